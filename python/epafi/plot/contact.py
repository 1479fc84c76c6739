"""contact: stresses, gap and displacements along the contact boundaries."""
import math

import numpy as np

from epafi.plot.figures import COLOURS, plain, settle, short
from epafi.plot.layout import finer, lengths, middles, places
from epafi.tables import Table, used_of


def typical(values, weights, share):
    """The value that this share of the length stays below."""
    order = np.argsort(values)
    below = np.cumsum(weights[order])
    return values[order][np.searchsorted(below, share * below[-1])]


def cap_of(stresses, weights):
    """Where sizes of stresses are cut so that the others can be read; 0 where there are none."""
    loaded = stresses > 1e-9 * stresses.max()
    return 4 * typical(stresses[loaded], weights[loaded], 0.8) if loaded.any() else 0


def cut(axes, columns):
    """Cuts curves that are singular so that they can be read elsewhere, above and below by what is on
    that side, and says at each cut how far they go.  `columns`: values and weights of each."""
    caps = [cap_of(np.abs(values), weights) if values.any() else 0 for values, weights in columns]
    ends = []
    for sign in (-1, 1):
        reaches = [max(0, (sign * values).max()) for values, _ in columns]
        # what has this sign on next to nothing of the length, beside a singular point, has no side
        wide = [weights[sign * values > 0].sum() > 0.01 * weights.sum()
                for values, weights in columns]
        ends.append((sign, max(reaches), max(map(min, reaches, np.multiply(caps, wide)))))
    low, high = (end for _, _, end in ends)
    margin = 0.06 * (low + high)
    if not margin > 0:
        return
    axes.set_ylim(-low - margin, high + margin)
    for sign, reach, end in ends:
        if reach > end + margin:
            axes.annotate("cut here: goes on to %.3g" % (sign * reach), (0.5, (1 + sign) / 2),
                          xytext=(0, -5 * sign), ha="center", va="top" if sign > 0 else "bottom",
                          fontsize="small", xycoords="axes fraction", textcoords="offset points",
                          bbox={"facecolor": "white", "edgecolor": COLOURS[1], "alpha": 0.85})


def joined(shown):
    """All columns and weights of what is drawn side by side."""
    columns = {name: np.concatenate([columns[name] for columns, *_ in shown])
               for name in shown[0][0]}
    weights = [lengths(s[a:b]) for _, s, _, parts in shown for a, b in parts]
    return columns, np.concatenate(weights)


def means_of_unresolved(columns, stress):
    """Where elements do not resolve a singular stress, and go beyond all others by that: their means; else
    nan.  The polynomial dips beside the singular point as far as it goes beyond at it."""
    values, means = columns[stress], np.full(len(columns[stress]), math.nan)
    if stress + "_error" not in columns:  # of an older run
        return means
    element = np.char.add(columns["body"].astype(str), columns["element"].astype(str))
    starts = np.flatnonzero(np.concatenate([[True], element[1:] != element[:-1]]))
    ends = np.append(starts[1:], len(element))
    mean = [np.average(values[a:b], weights=lengths(columns["s"][a:b])) for a, b in zip(starts, ends)]
    doubtful = [columns[stress + "_error"][a] > 0.3 * abs(average) for a, average in zip(starts, mean)]
    sizes = [np.abs(values[a:b]).max() for a, b in zip(starts, ends)]
    most = max((size for size, doubt in zip(sizes, doubtful) if not doubt), default=math.inf)
    for a, b, doubt, size, average in zip(starts, ends, doubtful, sizes, mean):
        if doubt and size > most:
            means[a:b] = average
    return means


def line(axes, laid, values, text, **style):
    _, s, _, parts = laid
    breaks = [a for a, _ in parts[1:]]
    axes.plot(np.insert(s, breaks, math.nan), np.insert(values, breaks, math.nan), label=text,
              **style)


def draw_stresses(axes, laid):
    contact, *_ = laid
    for stress, colour in zip(("pressure", "shear"), COLOURS):
        means = means_of_unresolved(contact, stress)
        line(axes, laid, np.where(np.isnan(means), contact[stress], math.nan), stress, color=colour)
        if not np.isnan(means).all():
            line(axes, laid, means, "%s, mean of elements\nthat do not resolve it" % stress, color=colour,
                 ls=":", lw=2.5)
    signs = signs_of(contact)
    for sign in signs:
        line(axes, laid, sign * contact["bound"], "friction bound" if sign == signs[0] else "_",
             color="grey", ls="--", lw=1)


def signs_of(contact):
    """On which sides the bound of friction is drawn: those that the shear comes near."""
    bound, shear = contact["bound"], contact["shear"]
    if not bound.any() or not np.isfinite(bound).all():  # bonds have none
        return []
    return [sign for sign in (1, -1) if (sign * shear).max() > 0.1 * np.abs(shear).max()] or [1]


def with_bound_of_pressure(contact, coulomb):
    """Coulomb's bound is that of `lambda_n`; beside `pressure` and `shear` the bound is that of
    `pressure`.  `coulomb`: the contacts with such a law."""
    loaded = contact["lambda_n"] > 0
    ratio = np.divide(contact["pressure"], contact["lambda_n"], where=loaded,
                      out=np.ones(len(loaded)))
    ratio[~np.isin(contact["contact_name"].astype(str), coulomb)] = 1
    return {**contact, "bound": contact["bound"] * np.maximum(ratio, 0)}


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


OBSTACLE = "an obstacle"


def sides_of(folder):
    """Of the contacts of a run's scene what lies upon what, "pad:bottom on plate:top", and the law of
    friction, by name; of obstacles their boundary's."""
    root, found = used_of(folder), {}
    if root is None:
        return found
    for one in root.findall("ParameterList[@name='Contacts']/ParameterList"):
        between = one.find("Parameter[@name='Between']").get("value").strip("{}").split(",")
        found[one.get("name")] = " on ".join(map(str.strip, between)), law_of(one)
    for one in root.findall(
            "ParameterList[@name='Bodies']/*/ParameterList[@name='Boundary Conditions']/*"):
        if one.find("Parameter[@name='Type'][@value='Contact']") is not None:
            found.setdefault(one.get("name"), (OBSTACLE, law_of(one)))
    return found


def law_of(contact):
    law = contact.find("ParameterList[@name='Friction']/Parameter[@name='Law']")
    return "None" if law is None else law.get("value")


def title_of(names, sides):
    """What touches: "joint (pad:bottom on plate:top)"."""
    if len(names) > NAMED:
        return "contact on %d sides" % len(names)
    words = []
    for name in names:
        text = sides.get(name, ("", ""))[0]
        words.append("%s on %s" % (name, text) if text == OBSTACLE else
                     "%s (%s)" % (name, text) if text else name)
    return plain("; ".join(words))


def draw(contact, title, pictures):
    sides = sides_of(pictures.folder)
    names = list(dict.fromkeys(contact["contact_name"].astype(str)))
    contact = finer(Table.of(with_bound_of_pressure(
        contact.columns, [name for name, (_, law) in sides.items() if law == "Coulomb"])))
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
    for stress in ("pressure", "shear"):
        means = means_of_unresolved(everything, stress)
        everything[stress] = np.where(np.isnan(means), everything[stress], means)
    cut(rows[0, 0], [(everything["pressure"], weights), (everything["shear"], weights)])
    frame(rows[1, 0], everything)
    rows[0, 0].set_ylabel(pictures.looks.label("contact stress", "stress"))
    rows[1, 0].set_ylabel(pictures.looks.label("displacement along n and t", "length"))
    for row in rows:  # what is in any of the columns
        named = {text: drawn for axes in row
                 for drawn, text in zip(*axes.get_legend_handles_labels())}
        pictures.legend(row[-1], named, loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.title(figure, "%s: %s" % (title, title_of(names, sides)))
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
