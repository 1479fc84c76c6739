"""contact: stresses, gap and displacements along the contact boundaries."""
import math

import numpy as np

from epafi.plot.figures import COLOURS, plain, settle, short
from epafi.plot.layout import lengths, middles, places


def typical(values, weights, share):
    """The value that this share of the length stays below."""
    order = np.argsort(values)
    below = np.cumsum(weights[order])
    return values[order][np.searchsorted(below, share * below[-1])]


def cap_of(stresses, weights):
    """Where sizes of stresses are cut so that the others can be read; 0 where there are none."""
    loaded = stresses > 1e-9 * stresses.max()
    return 4 * typical(stresses[loaded], weights[loaded], 0.8) if loaded.any() else 0


def say_cut(axes, largest):
    axes.annotate("cut here: stresses reach %.3g" % largest, (0.5, 1), xytext=(0, -5), ha="center",
                  va="top", fontsize="small", xycoords="axes fraction", textcoords="offset points",
                  bbox={"facecolor": "white", "edgecolor": COLOURS[1], "alpha": 0.85})


def readable(axes, contact, weights):
    """Cuts stresses that are singular, so that the others can be read, and marks it."""
    stresses = np.maximum(np.abs(contact["lambda_n"]), np.abs(contact["lambda_t"]))
    cap = cap_of(stresses, weights)
    if not stresses.any():
        return
    shown = min(cap, stresses.max())
    low = max(min(contact["lambda_n"].min(), contact["lambda_t"].min()), -shown)
    high = min(max(contact["lambda_n"].max(), contact["lambda_t"].max()), shown)
    if contact["bound"].any():  # as far as it does not flatten the rest
        bound = min(np.abs(contact["bound"]).max(), 1.5 * shown)
        low, high = min(low, -bound), max(high, bound)
    margin = 0.08 * (high - low)
    axes.set_ylim(low - margin, high + margin)
    if stresses.max() > cap:
        say_cut(axes, stresses.max())


def joined(shown):
    """All columns and weights of what is drawn side by side."""
    columns = {name: np.concatenate([columns[name] for columns, *_ in shown])
               for name in shown[0][0]}
    weights = [lengths(s[a:b]) for _, s, _, parts in shown for a, b in parts]
    return columns, np.concatenate(weights)


def line(axes, laid, values, text, **style):
    _, s, _, parts = laid
    breaks = [a for a, _ in parts[1:]]
    axes.plot(np.insert(s, breaks, math.nan), np.insert(values, breaks, math.nan), label=text,
              **style)


def draw_stresses(axes, laid):
    contact, s, _, parts = laid
    line(axes, laid, contact["lambda_n"], r"pressure $\lambda_n$", color=COLOURS[0])
    line(axes, laid, contact["lambda_t"], r"shear $\lambda_t$", color=COLOURS[1])
    if (contact["bound"] != 0).any() and np.isfinite(contact["bound"]).all():  # bonds have none
        for sign, text in ((1, "friction bound, both signs"), (-1, "_")):
            line(axes, laid, sign * contact["bound"], text, color="grey", ls="--", lw=1)


def draw_displacements(axes, laid):
    contact, *_ = laid
    line(axes, laid, contact["u_n"], "normal displacement $u_n$", color=COLOURS[0])
    room = {text: contact[column] for text, column in (
        ("gap", "gap"), ("closing", "normal_closing"), ("wear", "worn_depth"))
            if text == "gap" or column in contact and contact[column].any()}
    if len(room) > 1:
        line(axes, laid, contact["gap"], "gap as drawn", color="grey", ls=":", lw=1)
    line(axes, laid, sum(room.values()), " + ".join(room), color="black", ls="--", lw=1)
    line(axes, laid, contact["u_t"], "tangential displacement $u_t$", color=COLOURS[1])


def frame(axes, contact):
    """Limits of displacements that neither a far gap nor rounding flattens or fills."""
    room = max(np.ptp(contact["u_n"]), np.ptp(contact["u_t"]), 1e-300)
    reach = max(np.abs(contact["u_n"]).max(), np.abs(contact["u_t"]).max()) + 0.2 * room
    if np.abs(contact["gap"]).max() > 3 * reach:  # a gap far off would flatten the rest
        axes.set_ylim(-reach, 1.5 * reach)
    settle(axes, 1e-3 * max(np.ptp(contact["x"]), np.ptp(contact["y"])))  # as of bonded sides


NAMED = 6  # sides that carry their names


def names_of(columns, parts):
    """The contact of each part; of several parts of one, the boundary."""
    names = [str(columns["contact_name"][a]) for a, _ in parts]
    return [name if names.count(name) == 1 else str(columns["boundary"][a])
            for name, (a, _) in zip(names, parts)]


def draw(contact, title, pictures):
    shown = places(contact)
    figure, rows = pictures.subplots(2, len(shown), figsize=(5.9 + 3.5 * len(shown), 7.4),
                                     sharex="col", sharey="row")
    rows = rows.reshape(2, len(shown))
    for (stress, shift), laid in zip(rows.T, shown):
        columns, s, label, parts = laid
        draw_stresses(stress, laid)
        draw_displacements(shift, laid)
        if 2 < len(parts) + len(shown) < NAMED + 2:  # which of the sides is which
            for (a, b), name in zip(parts, names_of(columns, parts)):
                stress.annotate(short(name, 20), ((s[a] + s[b - 1]) / 2, 1.01),
                                ha="center", fontsize="small",
                                xycoords=stress.get_xaxis_transform())
        shift.set_xlabel(pictures.looks.label(label, "length"))
        for axes in (stress, shift):
            shade(axes, s, columns, parts)
    everything, weights = joined(shown)
    readable(rows[0, 0], everything, weights)
    frame(rows[1, 0], everything)
    rows[0, 0].set_ylabel(pictures.looks.label("contact stress", "stress"))
    rows[1, 0].set_ylabel(pictures.looks.label("displacement along n and t", "length"))
    for row in rows:  # what is in any of the columns
        named = {text: drawn for axes in row
                 for drawn, text in zip(*axes.get_legend_handles_labels())}
        pictures.legend(row[-1], named, loc="center left", bbox_to_anchor=(1, 0.5))
    names = dict.fromkeys(contact["contact_name"].astype(str))
    pictures.title(figure, "%s: contact on %s" % (
        title, ", ".join(map(plain, names)) if len(names) <= NAMED else "%d sides" % len(names)))
    pictures.save(figure, "contact")


def shade(axes, s, contact, parts):
    """Sticking and sliding parts as grounds, one darker than the other; open ones stay white."""
    closed, friction = contact["contact"] > 0, contact["friction"]
    kinds = [("closed, no friction", closed & (friction == 0), "#ececec"),
             ("closed, stick", closed & (friction == 1), "#b9d6ea"),
             ("closed, slip", closed & (friction == 2), "#fbe3cf")]
    for text, here, colour in kinds:
        for a, b in parts:
            edge = middles(s[a:b])
            change = np.flatnonzero(np.diff(np.concatenate([[0], here[a:b].astype(int), [0]])))
            for first, last in zip(change[::2], change[1::2]):
                axes.axvspan(edge[first], edge[last], color=colour, lw=0, label=text, zorder=0)
                text = "_"  # once in the legend
