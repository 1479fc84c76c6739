"""The edges of a run's outlines, segments and arcs, and the samples of contacts along them."""
from __future__ import annotations

import math
from typing import Any

import numpy as np

from epafi.program import InputError
from epafi.tables import Table

SMOOTH = math.radians(1)  # less is no corner
STRAIGHT = 1e-7  # a turn that is rounding of what is drawn [radian]
FLAT = 1e-5  # an arc's turn, below which its centre would be too far away for digits


class Edge:
    """Of an outline, a segment or an arc between complex points; the body is on its left."""

    before: Edge
    after: Edge

    def __init__(self, table: Table, rows: slice) -> None:
        x = table["x"][rows] + 1j * table["y"][rows]
        self.start, self.end = complex(x[0]), complex(x[-1])
        self.body = str(table["body"][rows][0])
        self.name = str(table["boundary"][rows][0]).removeprefix(self.body + ":")
        self.elements = table["element"][rows][[0, -1]]
        inner = x[np.argmax(np.minimum(abs(x - x[0]), abs(x - x[-1])))]
        chord, rounding = abs(x[-1] - x[0]), 1e-9 + 1e-14 * abs(x).max() / abs(x[-1] - x[0])
        turn = 2 * float(np.angle((x[-1] - inner) / (inner - x[0])))
        self.turn = turn if abs(turn) > rounding else 0.0
        self.curvature = 2 * math.sin(self.turn / 2) / chord
        self.x, self.u = x, table["ux"][rows] + 1j * table["uy"][rows]

    def moved(self, x: complex) -> complex:
        """Displacement at a node of the edge, at the end of the path."""
        return complex(self.u[abs(self.x - x).argmin()])

    def goes_on(self, other: Edge) -> bool:
        """Are both one segment, or an arc of less than half a circle?"""
        turn = np.angle(other.tangent(other.start) / self.tangent(self.end))
        bend = (other.curvature - self.curvature) * min(
            abs(edge.end - edge.start) for edge in (self, other))
        return bool(self.end == other.start and (self.body, self.name) == (other.body, other.name)
                    and abs(turn) < STRAIGHT and abs(bend) < STRAIGHT
                    and abs(self.turn + other.turn) < math.pi)

    def tangent(self, x: complex) -> complex:
        """At a point of the edge."""
        first = (self.end - self.start) * np.exp(-0.5j * self.turn)
        chord = x - self.start
        turned = first if not self.turn or chord == 0 else chord * chord / first
        return complex(turned / abs(turned))

    def nearest(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Points of the edge, and whether they lie before one, not beyond the edge's ends."""
        chord = self.end - self.start
        if abs(self.turn) < FLAT:
            share = ((x - self.start) / chord).real
            found = self.start + np.clip(share, 0, 1) * chord
        else:
            centre = self.start + 1j * self.tangent(self.start) / self.curvature
            middle = self.tangent(self.start) * np.exp(0.5j * self.turn) / self.curvature / 1j
            share = 0.5 + np.angle((x - centre) / middle) / self.turn
            found = centre + middle * np.exp(1j * self.turn * (np.clip(share, 0, 1) - 0.5))
        return found, (share > -1e-9) & (share < 1 + 1e-9)


def rigid_corners(geometry: dict[str, Any]) -> list[complex]:
    """Of a rigid body's scene: where its sides end."""
    found = []
    for key in geometry:
        if key.endswith("Vertices"):
            loop = key.removesuffix("Vertices")
            x = np.array([complex(*vertex) for vertex in geometry[key]])
            half = 2 * np.arctan(geometry.get(loop + "Bulges") or np.zeros(len(x)))  # of a turn
            turn = np.angle((np.roll(x, -1) - x) / (x - np.roll(x, 1))) - half - np.roll(half, 1)
            names = geometry[loop + "Edges"]
            found += [corner for k, corner in enumerate(x)
                      if abs(turn[k]) > SMOOTH or names[k] != names[k - 1]]
    return found


def distance(x: complex, edges: list[Edge]) -> float:
    """To the nearest of the edges."""
    flat = [edge for edge in edges if abs(edge.turn) < FLAT]
    start, end = np.array([(edge.start, edge.end) for edge in flat]).reshape(-1, 2).T
    share = np.clip(((x - start) / (end - start)).real, 0, 1)
    return float(min([abs(start + share * (end - start) - x).min(initial=math.inf), *(
        abs(edge.nearest(np.array([x]))[0] - x)[0] for edge in edges if abs(edge.turn) >= FLAT)]))


def edges_of(table: Table) -> list[Edge]:
    """Of boundary.csv; those that go on as one segment or arc are one."""
    if "edge" not in table:
        raise InputError("boundary.csv has no column edge: another version of the program has written "
                         "it; solve the scene again")
    starts = np.flatnonzero(np.append(True, (np.diff(table["edge"]) != 0)
                                      | (table["body"][1:] != table["body"][:-1])))
    edges: list[Edge] = []
    begin = 0
    for a, b in zip(starts, [*starts[1:], table.size]):
        edges.append(Edge(table, slice(a, b)))
        if len(edges) > 1 and edges[-2].goes_on(edges[-1]):
            edges[-2:] = [Edge(table, slice(begin, b))]
        else:
            begin = a
    size, first = np.ptp(table["x"]) + np.ptp(table["y"]), edges[0]
    for edge, following in zip(edges, [*edges[1:], first]):
        closes = abs(edge.end - first.start) < 1e-12 * size + 1e-14 * abs(edge.end)
        edge.after = first if closes else following
        edge.after.before = edge
        first = following if closes else first
    return edges


class Samples:
    """The rows of contact.csv."""

    def __init__(self, table: Table) -> None:
        self.x = table["x"] + 1j * table["y"]
        self.name, self.body = table["contact_name"], table["body"]
        self.element = table["element"].astype(int)
        self.closed, self.stuck = table["contact"] == 1, table["friction"] == 1
        self.pressure, self.shear = table["lambda_n"], table["lambda_t"]
        self.bound, self.gap, self.sliding = table["bound"], table["gap"], table["u_t"]

    def on_edge(self, edge: Edge, name: str, other: str) -> np.ndarray:
        """Those of a contact on an edge, or, if they lie on the other side, opposite to it."""
        here = np.flatnonzero(self.name == name)
        own = here[self.body[here] == edge.body]
        own = own[(self.element[own] >= edge.elements[0]) & (self.element[own] <= edge.elements[1])]
        if len(own):
            return own
        here = here[self.body[here] == other.partition(":")[0]]
        return here[edge.nearest(self.x[here])[1]]
