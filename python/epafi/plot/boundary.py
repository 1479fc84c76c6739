"""boundary.csv element by element."""
import math

import numpy as np


class Boundary:
    """The elements in their order along the outline: points x, displacements u, tractions t."""

    def __init__(self, table):
        self.elements = []
        number = table.numbers("element")
        names = table["boundary"].astype(str)
        starts = np.flatnonzero(np.diff(number, prepend=number[0] - 1))
        for first, last in zip(starts, [*starts[1:], table.size]):
            piece = slice(first, last)
            self.elements.append({
                "x": np.column_stack([table["x"][piece], table["y"][piece]]),
                "u": np.column_stack([table["ux"][piece], table["uy"][piece]]),
                "t": np.column_stack([table["tx"][piece], table["ty"][piece]]),
                "name": names[first], "degree": int(table["degree"][first])})
        corners = np.concatenate([element["x"] for element in self.elements])
        self.extent = np.ptp(corners, axis=0)  # width and height
        self.diameter = math.hypot(*self.extent)

    def loops(self):
        """Lists of elements that follow each other; a hole starts a new one."""
        return self.chains(lambda element: None)

    def sides(self):
        """Lists of elements that follow each other on one boundary."""
        return self.chains(lambda element: element["name"])

    def chains(self, kind):
        chains, before = [], None
        for element in self.elements:
            if (before is None or kind(element) != kind(before)
                    or np.hypot(*(element["x"][0] - before["x"][-1])) > 1e-9 * self.diameter):
                chains.append([])
            chains[-1].append(element)
            before = element
        return chains
