"""boundary.csv element by element."""
import math

import numpy as np
from matplotlib.path import Path
from numpy.polynomial.legendre import legfit, legval

from epafi.plot.bodies import revolves


def on_arc(x):
    """Points of an element that is an arc: its own are so few that one would see a polygon.  Of others its
    own."""
    a, b, c = (complex(*x[k]) for k in (0, len(x) // 2, -1))
    angle = 2 * np.angle((c - b) / (b - a)) if a != b != c else 0
    count = 1 + max(len(x) - 1, math.ceil(abs(angle) / math.radians(2)))
    if abs(angle) < 1e-6 or count == len(x):
        return x
    s = np.linspace(0, 1, count)
    z = a + (c - a) * np.sin(angle * s / 2) / np.sin(angle / 2) * np.exp(0.5j * angle * (s - 1))
    return np.column_stack([z.real, z.imag])


def on_circle(element):
    """An element with the points of on_arc.  Displacements are their polynomial there."""
    x = on_arc(element["x"])
    if len(x) == len(element["x"]):
        return element
    old, s = np.linspace(0, 1, len(element["x"])), np.linspace(0, 1, len(x))
    u = legval(2 * s - 1, legfit(2 * old - 1, element["u"], element["degree"])).T
    t = np.column_stack([np.interp(s, old, column) for column in element["t"].T])
    return {**element, "x": x, "u": u, "t": t}


class Boundary:
    """The elements in their order along the outline: points x, displacements u, tractions t."""

    def __init__(self, table):
        self.elements = []
        self.revolves = revolves(table, table["x"])
        number = table.numbers("element")
        names = table["boundary"].astype(str)
        starts = np.flatnonzero(np.diff(number, prepend=number[0] - 1))
        for first, last in zip(starts, [*starts[1:], table.size]):
            piece = slice(first, last)
            self.elements.append(on_circle({
                "x": np.column_stack([table["x"][piece], table["y"][piece]]),
                "u": np.column_stack([table["ux"][piece], table["uy"][piece]]),
                "t": np.column_stack([table["tx"][piece], table["ty"][piece]]),
                "name": names[first], "degree": int(table["degree"][first])}))
        corners = np.concatenate([element["x"] for element in self.elements])
        self.extent = np.ptp(corners, axis=0)  # width and height
        self.diameter = math.hypot(*self.extent)

    def loops(self):
        """Lists of elements that follow each other; a hole starts a new one."""
        return self.chains(lambda element: None)

    def sides(self):
        """Lists of elements that follow each other on one boundary."""
        return self.chains(lambda element: element["name"])

    def path(self):
        """Of all bodies as one area, holes left out."""
        loops = [np.concatenate([element["x"] for element in loop]) for loop in self.loops()]
        return Path.make_compound_path(*(Path(x, closed=True) for x in loops))

    def chains(self, kind):
        chains, before = [], None
        for element in self.elements:
            if (before is None or kind(element) != kind(before)
                    or np.hypot(*(element["x"][0] - before["x"][-1])) > 1e-9 * self.diameter):
                chains.append([])
            chains[-1].append(element)
            before = element
        return chains
