"""contact: stresses, gap and displacements along the contact boundaries."""
import math

import numpy as np

from epafi.plot.figures import plt


def chains(contact):
    """Index ranges (first, last) of samples that follow each other on one boundary: a new one
    begins where the name changes or an element is not the next one of the mesh."""
    names, element = contact["boundary"].astype(str), contact["element"]
    fresh = (names[1:] != names[:-1]) | (np.diff(element) > 1) | (np.diff(element) < 0)
    starts = np.append(0, np.flatnonzero(fresh) + 1)
    return list(zip(starts, [*starts[1:], len(names)]))


def abscissa(contact, parts):
    """Where each sample is drawn, and what that is: a coordinate if all boundaries lie along one
    axis and do not overlap there, else the length along them with room between chains."""
    for name, other in (("x", "y"), ("y", "x")):
        s = contact[name]
        spans = sorted((s[a:b].min(), s[a:b].max()) for a, b in parts)
        apart = all(low >= high for (_, high), (low, _) in zip(spans, spans[1:]))
        straight = all(np.ptp(contact[other][a:b]) <= 1e-9 * np.ptp(s) for a, b in parts)
        one_way = all((np.diff(s[a:b]) > 0).all() or (np.diff(s[a:b]) < 0).all()
                      for a, b in parts)
        if straight and apart and one_way:
            return s, name
    s, end = np.zeros(len(contact["x"])), 0.0
    lengths = [np.append(0, np.cumsum(np.hypot(np.diff(contact["x"][a:b]),
                                               np.diff(contact["y"][a:b]))))
               for a, b in parts]
    room = 0.05 * sum(length[-1] for length in lengths)
    for (a, b), length in zip(parts, lengths):
        s[a:b] = end + length
        end = s[b - 1] + room
    return s, "length along the contact boundaries"


def closes(contact):
    """Does a single chain end where it begins, in contact there and not all around?"""
    x = np.column_stack([contact["x"], contact["y"]])
    steps = np.hypot(*np.diff(x, axis=0).T)
    closed = contact["contact"] > 0
    return (len(steps) > 2 and np.hypot(*(x[-1] - x[0])) < 2 * max(steps[0], steps[-1])
            and (closed[0] or closed[-1]) and not closed.all())


def laid_out(contact):
    """The columns, where each sample is drawn, what that is, and the chains.  Contact that runs
    over the end of a closed chain is in one piece: its second half comes first, at lengths
    below 0."""
    parts = chains(contact)
    s, label = abscissa(contact, parts)
    columns = {name: contact[name] for name in contact.columns}
    if len(parts) == 1 and closes(contact):
        turn = np.hypot(*(np.subtract([contact["x"][0], contact["y"][0]],
                                      [contact["x"][-1], contact["y"][-1]]))) + s[-1] - s[0]
        late = s > s[0] + turn / 2
        order = np.concatenate([np.flatnonzero(late), np.flatnonzero(~late)])
        s = np.where(late, s - turn, s)[order]
        columns = {name: column[order] for name, column in columns.items()}
    return columns, s, label, parts


def window(laid):
    """What is shown of (columns, s, ...) that share an axis: all, or where little of it is ever
    closed, that and as much again on both sides."""
    closed = np.concatenate([s[columns["contact"] > 0] for columns, s, *_ in laid])
    low, high = (pick(s) for pick, s in ((min, [s.min() for _, s, *_ in laid]),
                                         (max, [s.max() for _, s, *_ in laid])))
    if not closed.size or np.ptp(closed) > 0.25 * (high - low):
        return low, high
    room = max(np.ptp(closed), 0.02 * (high - low))
    return closed.min() - room, closed.max() + room


def within(laid, low, high):
    columns, s, label, parts = laid
    here = (s >= low) & (s <= high)
    if not here.any():
        return laid
    before = np.append(0, np.cumsum(here))
    parts = [(before[a], before[b]) for a, b in parts if before[b] > before[a]]
    return {name: column[here] for name, column in columns.items()}, s[here], label, parts


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
    axes.text(0.5, 0.97, "cut here: stresses reach %.3g" % largest, ha="center",
              va="top", fontsize=8, transform=axes.transAxes,
              bbox={"facecolor": "white", "edgecolor": "C3", "alpha": 0.85})


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


def draw(contact, title, pictures):
    names = contact["boundary"].astype(str)
    laid = laid_out(contact)
    contact, s, label, parts = within(laid, *window([laid]))
    weights = np.concatenate([lengths(s[a:b]) for a, b in parts])
    breaks = [a for a, _ in parts[1:]]
    names_of = contact["boundary"].astype(str)

    def line(axes, values, text, **style):
        axes.plot(np.insert(s, breaks, math.nan), np.insert(values, breaks, math.nan),
                  label=text, **style)

    figure, (stress, shift) = plt.subplots(2, 1, figsize=(8, 7.4), sharex=True)
    line(stress, contact["lambda_n"], r"pressure $\lambda_n$", color="C0")
    line(stress, contact["lambda_t"], r"shear $\lambda_t$", color="C1")
    if (contact["bound"] != 0).any() and np.isfinite(contact["bound"]).all():  # bonds have none
        line(stress, contact["bound"], "friction bound, both signs", color="grey", ls="--",
             lw=1)
        line(stress, -contact["bound"], "_", color="grey", ls="--", lw=1)
    readable(stress, contact, weights)
    for a, b in parts if len(parts) > 1 else ():  # which of the sides is which
        stress.annotate(names_of[a], ((s[a] + s[b - 1]) / 2, 1.01), ha="center", fontsize=8,
                        xycoords=stress.get_xaxis_transform())
    stress.set_ylabel("contact stress")
    line(shift, contact["u_n"], "normal displacement $u_n$", color="C0")
    line(shift, contact["gap"], "gap", color="black", ls="--", lw=1)
    line(shift, contact["u_t"], "tangential displacement $u_t$", color="C1")
    room = max(np.ptp(contact["u_n"]), np.ptp(contact["u_t"]), 1e-300)
    reach = max(np.abs(contact["u_n"]).max(), np.abs(contact["u_t"]).max()) + 0.2 * room
    if np.abs(contact["gap"]).max() > 3 * reach:  # a gap far off would flatten the rest
        shift.set_ylim(-reach, 1.5 * reach)
    rounding = 1e-12 * max(np.ptp(contact["x"]), np.ptp(contact["y"]))
    if reach < rounding and (contact["gap"] == 0).all():  # as of bonded sides
        shift.set_ylim(-rounding, rounding)
    shift.set_ylabel("displacement along n and t")
    shift.set_xlabel(label)
    for axes in (stress, shift):
        shade(axes, s, contact, parts)
        axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle("%s: contact on %s" % (title, ", ".join(dict.fromkeys(names))), y=0.94)
    pictures.save(figure, "contact")


def middles(s):
    """The places between samples, the first and the last sample at the ends."""
    return np.concatenate([[s[0]], 0.5 * (s[1:] + s[:-1]), [s[-1]]])


def lengths(s):
    """What of a chain each sample stands for; 1 where there is a single one."""
    return np.abs(np.diff(middles(s))) if len(s) > 1 else np.ones(1)


def shade(axes, s, contact, parts):
    """Sticking and sliding parts as coloured grounds; what is open stays white."""
    closed, friction = contact["contact"] > 0, contact["friction"]
    kinds = [("closed, no friction", closed & (friction == 0), "#cfe3f2"),
             ("closed, stick", closed & (friction == 1), "#cde8cd"),
             ("closed, slip", closed & (friction == 2), "#f7dcc4")]
    for text, here, colour in kinds:
        for a, b in parts:
            edge = middles(s[a:b])
            change = np.flatnonzero(np.diff(np.concatenate([[0], here[a:b].astype(int), [0]])))
            for first, last in zip(change[::2], change[1::2]):
                axes.axvspan(edge[first], edge[last], color=colour, lw=0, label=text, zorder=0)
                text = "_"  # once in the legend
