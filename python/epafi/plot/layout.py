"""Where samples of contact are drawn: along an axis or the length of their boundaries, cut to where
something touches."""
import os

import numpy as np

from epafi.tables import Table, read


def chains(contact):
    """Index ranges (first, last) of samples that follow each other on one boundary: a new one
    begins where the name changes, or an element is not the next one of the mesh and not the first one of
    an outline that the boundary runs on over, see in_order."""
    names, element = contact["boundary"].astype(str), np.diff(contact["element"])
    on = np.diff(contact["s"]) > 0 if "s" in contact else element >= 0  # of an older run
    fresh = (names[1:] != names[:-1]) | (element > 1) | ~on
    starts = np.append(0, np.flatnonzero(fresh) + 1)
    return list(zip(starts, [*starts[1:], len(names)]))


def in_order(contact):
    """The table with its samples along their boundaries: of one that runs over the first vertex of its
    outline, where the numbers of elements begin again, what is before the vertex comes first."""
    parts = chains(contact)
    if "s" not in contact or len(parts) < 2:
        return contact
    names, s = contact["boundary"].astype(str), contact["s"]
    x = np.column_stack([contact["x"], contact["y"]])

    def step(a, b):
        return np.hypot(*np.diff(x[a:b], axis=0).T).max(initial=0)

    order = list(parts)
    for a, b in parts:
        for start, end in parts:  # where lengths go on from
            if start > a and names[start] == names[a] and s[end - 1] < s[a] and np.hypot(
                    *(x[a] - x[end - 1])) <= 2 * max(step(a, min(b, a + 2)), step(max(start, end - 2), end)):
                order.remove((start, end))
                order.insert(order.index((a, b)), (start, end))
    if order == parts:
        return contact
    rows = np.concatenate([np.arange(a, b) for a, b in order])
    return Table.of({name: column[rows] for name, column in contact.columns.items()})


def per_element(contact):
    """How many samples there are on each element, in the middles of equal parts of it."""
    new = (np.diff(contact["element"]) != 0) | (contact["boundary"][1:] != contact["boundary"][:-1])
    return int(np.append(np.flatnonzero(new), len(new))[0]) + 1


# What changes by polynomials on each element.
SMOOTH = ("x", "y", "s", "pressure", "shear", "u_n", "u_t")
FEW, MANY = 3, 12  # samples that are enough for a polynomial, and for a curve


def finer(contact):
    """The table with points between the samples of an element, by the polynomials through these; gaps, bounds and what else may have kinks by those where all of an element is closed or the highest
    coefficients are small, else by lines."""
    count = per_element(contact)
    if "s" not in contact or not FEW <= count <= MANY or contact.size % count:
        return contact
    samples = (2 * np.arange(count) + 1) / count - 1
    t = np.linspace(samples[0], samples[-1], 2 * count - 1)
    vander = np.polynomial.legendre.legvander
    coefficients = np.linalg.inv(vander(samples, count - 1))
    smooth = vander(t, count - 1) @ coefficients
    lines = np.array([np.interp(t, samples, row) for row in np.eye(count)]).T
    nearest = (np.arange(len(t)) + 1) // 2
    closed = (contact["contact"].reshape(-1, count) > 0).all(axis=1)[:, None]
    columns = {}
    for name, values in contact.columns.items():
        rows = values.reshape(-1, count)
        if values.dtype.kind != "f" or name in ("element", "contact", "friction") or not np.isfinite(values).all():
            rows = rows[:, nearest]
        else:
            size = np.abs(rows @ coefficients.T)
            flat = size[:, -2:].max(axis=1) < 1e-3 * size.max(axis=1)
            rows = np.where(closed | flat[:, None] | (name in SMOOTH), rows @ smooth.T, rows @ lines.T)
        columns[name] = rows.ravel()
    return Table.of(columns)


def samples_at(folder, step=None, columns=None):
    """contact.csv of a step, else of the last one, in its order; of some columns, or of all."""
    contact = read(os.path.join(folder, "steps", "%d" % step) if step else folder, "contact.csv", columns)
    return contact and in_order(contact)


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


def turned(contacts):
    """Is the one closed chain of these solutions cut where they do not touch?  As all of them are
    drawn, so that a place is at one length in all."""
    return any(map(closes, contacts)) and not any((each["contact"] > 0).all() for each in contacts)


def closes(contact):
    """Does a single chain end where it begins, in contact there and not all around?"""
    x = np.column_stack([contact["x"], contact["y"]])
    steps = np.hypot(*np.diff(x, axis=0).T)
    closed = contact["contact"] > 0
    return (len(steps) > 2 and np.hypot(*(x[-1] - x[0])) < 2 * max(steps[0], steps[-1])
            and (closed[0] or closed[-1]) and not closed.all())


def laid_out(contact, first=0, last=None, turns=None):
    """The columns of the samples first <= k < last, where each is drawn, what that is, and the
    chains.  Contact that runs over the end of a closed chain, or that `turns`, is in one piece: its
    second half comes first, at lengths below 0."""
    columns = {name: contact[name][first:last] for name in contact.columns}
    parts = chains(columns)
    s, label = abscissa(columns, parts)
    if len(parts) == 1 and (closes(columns) if turns is None else turns):
        x, y = columns["x"], columns["y"]
        turn = np.hypot(x[0] - x[-1], y[0] - y[-1]) + s[-1] - s[0]
        late = s > s[0] + turn / 2
        order = np.concatenate([np.flatnonzero(late), np.flatnonzero(~late)])
        s = np.where(late, s - turn, s)[order]
        columns = {name: column[order] for name, column in columns.items()}
    return columns, s, label, parts


def window(laid):
    """What is shown of (columns, s, ...) that share an axis: all, or where less than half of it is ever
    closed, that and as much again on both sides."""
    closed = np.concatenate([s[columns["contact"] > 0] for columns, s, *_ in laid])
    low, high = (pick(s) for pick, s in ((min, [s.min() for _, s, *_ in laid]),
                                         (max, [s.max() for _, s, *_ in laid])))
    if not closed.size or np.ptp(closed) > 0.5 * (high - low):
        return low, high
    room = max(np.ptp(closed), 0.02 * (high - low))
    return max(low, closed.min() - room), min(high, closed.max() + room)


def within(laid, low, high):
    columns, s, label, parts = laid
    here = (s >= low) & (s <= high)
    if not here.any():
        return laid
    before = np.append(0, np.cumsum(here))
    parts = [(before[a], before[b]) for a, b in parts if before[b] > before[a]]
    return {name: column[here] for name, column in columns.items()}, s[here], label, parts


def places(contact):
    """What is drawn side by side, each as from laid_out and cut to its window: all of the contact,
    or, where up to four boundaries touch over a small share of their lengths, each by itself."""
    parts = chains(contact)
    each = [laid_out(contact, a, b) for a, b in parts]
    touching = [laid for laid in each if (laid[0]["contact"] > 0).any()]
    small = touching and all(window([laid])[1] - window([laid])[0] < np.ptp(laid[1])
                             for laid in touching)
    if not (small and 1 < len(parts) <= 4):
        each = [laid_out(contact)]
    return [within(laid, *window([laid])) for laid in each]


def middles(s):
    """The places between samples, the first and the last sample at the ends."""
    return np.concatenate([[s[0]], 0.5 * (s[1:] + s[:-1]), [s[-1]]])


def lengths(s):
    """What of a chain each sample stands for; 1 where there is a single one."""
    return np.abs(np.diff(middles(s))) if len(s) > 1 else np.ones(1)
