"""What a reader of a report asks first: how hard contacts press and where, how wide they are, what they
carry, how far from slipping they are, the largest stress."""
from __future__ import annotations

import math
from typing import Iterator, Mapping, NamedTuple, Optional

import numpy as np

from epafi.plot.figures import Pictures
from epafi.plot.inside import known
from epafi.plot.layout import chains, lengths, per_element
from epafi.plot.path import contacts_of, samples_of
from epafi.tables import Table, shown_step

ROUNDING = 1e-10  # numbers so much smaller than the largest of their kind are none
# Columns of one kind are compared with each other; the last word of their names says of which.
KINDS = {"x": "force", "y": "force", "normal": "force", "tangential": "force", "moment": "moment"}


class Result(NamedTuple):
    """A line of the first table; quantity: one of figures.POWERS, or empty."""

    where: str
    name: str
    value: float
    quantity: str
    remark: str = ""


def kind_of(column: str) -> str:
    """Forces of all contacts and bodies are of one kind, energies, motions; others by themselves."""
    name = column.rsplit(".", 1)[-1]
    if name.startswith(("energy", "motion")):
        return name.split("_")[0]
    first, _, last = name.rpartition("_")
    known = first in ("", "force", "load", "contact", "reaction", "body_force", "body")
    return KINDS.get(last, column) if known else column


def settled(columns: Mapping[str, np.ndarray], length: float = 0) -> dict[str, np.ndarray]:
    """Columns in which what is rounding beside others of its kind is 0.  `length`: of the bodies, by
    which moments compare with forces."""
    sizes: dict[str, float] = {}
    for name, values in columns.items():
        if values.dtype.kind == "f":
            finite = np.abs(values[np.isfinite(values)])
            sizes[kind_of(name)] = max(sizes.get(kind_of(name), 0.0), finite.max(initial=0.0))
    sizes["moment"] = max(sizes.get("moment", 0.0), length * sizes.get("force", 0.0))
    return {name: np.where(np.abs(values) <= ROUNDING * sizes[kind_of(name)], 0.0, values)
            if values.dtype.kind == "f" else values for name, values in columns.items()}


def place(x: float, y: float, size: float) -> str:
    """A point among others that are so far apart."""
    return "(%s)" % ", ".join("%.4g" % (value if abs(value) > 1e-6 * size else 0) for value in (x, y))


def extent(table: Optional[Table]) -> float:
    """The longer side of the box of points."""
    return max(float(np.ptp(table[axis])) for axis in "xy") if table else 0.0


def integral_weights(points: Table, otherwise: np.ndarray) -> np.ndarray:
    """Of samples in the middles of equal parts of each element weights of integrals, exact for polynomials of
    degrees below 10 and the number of samples."""
    count = per_element(points)
    if count == 1:
        return otherwise
    legendre = np.polynomial.legendre.legvander((2 * np.arange(count) + 1) / count - 1, min(count, 10) - 1)
    on_element = np.linalg.pinv(legendre.T)[:, 0] * count  # of integrals over the steps between samples
    s = points["s"].reshape(-1, count)
    return ((s[:, 1] - s[:, 0])[:, None] * on_element).ravel()


def middle_of(points: Mapping[str, np.ndarray]) -> np.ndarray:
    """Of the box around samples and the ends of sides half a step beyond them; those that are closed have
    none."""
    x = np.column_stack([points["x"], points["y"]])
    for a, b in chains(points):
        beyond = (x[[a + 1, b - 2]] - x[[a, b - 1]]) / 2 if b - a > 1 else np.zeros((2, 2))
        if np.hypot(*(x[a] - x[b - 1])) > 4 * np.hypot(*beyond.T).max():
            x = np.vstack([x, x[[a, b - 1]] - beyond])
    return (x.min(axis=0) + x.max(axis=0)) / 2


class Contacts:
    """Of all contacts of a run, at one step of a path or of the one load."""

    def __init__(self, points: Table, numbers: Mapping[str, float], revolves: bool,
                 mirror: Optional[str] = None) -> None:
        """points   contact.csv
        numbers  the row of steps.csv, or of history.csv, by columns
        mirror   Geometry->Symmetry, X or Y: half of the scene is drawn"""
        self.points, self.revolves, self.mirror = points, revolves, {"X": "x", "Y": "y"}.get(mirror or "", "")
        self.numbers = {name: values[0] for name, values in settled(
            {name: np.atleast_1d(value) for name, value in numbers.items()}).items()}
        self.lengths = np.concatenate([lengths(points["s"][a:b]) for a, b in chains(points)])
        self.weights = integral_weights(points, self.lengths) * (2 * math.pi * points["x"] if revolves else 1)

    def results(self) -> Iterator[Result]:
        for name in contacts_of(self.numbers):
            for result in self._of(name):
                yield Result(name, *result)

    def _of(self, name: str) -> Iterator[tuple]:
        here = samples_of(self.points, name)
        of = {key.rpartition(".")[2]: value for key, value in self.numbers.items()
              if key.rpartition(".")[0] == name}
        points = {column: self.points[column][here] for column in (
            "boundary", "element", "s",
            "x", "y", "pressure", "shear", "bound", "contact", "d_x", "d_y")}
        weights = self.weights[here]
        size = math.hypot(np.ptp(points["x"]), np.ptp(points["y"]))
        if not of["contact_length"] > 0:
            yield "nothing touches", math.nan, ""
            return
        if of["pressure_max"] > 0:
            peak = np.argmin(np.abs(points["pressure"] - of["pressure_max"]))
            yield "largest pressure", of["pressure_max"], "stress", "± %.2g, at %s%s" % (
                of["pressure_max_error"], place(points["x"][peak], points["y"][peak], size),
                "; beside it, at an end of the side, it has no bound" * bool(
                    of["pressure_unbounded"]))
        both = bool(self.mirror) and (
            of["contact_length"] > 1.5 * self.lengths[here][points["contact"] > 0].sum())
        for what, column, quantity in (("width of contact", "contact_length", "length"),
                                       ("normal force", "force_normal", "force"),
                                       ("tangential force", "force_tangential", "force")):
            if what != "tangential force" or of[column] or points["bound"].any():
                remarks = ["± %.2g" % of[column + "_error"]] if column + "_error" in of else []
                if both and of[column]:
                    remarks.append("both halves; %.4g of the one that is drawn" % (of[column] / 2))
                yield what, of[column], quantity, "; ".join(remarks)
        middle = middle_of(points)
        moment, whose = of["moment"] - middle[0] * of["force_y"] + middle[1] * of["force_x"], ""
        if both:  # that of both is about the line, where it is 0
            moment, whose = self._drawn_moment(points, weights, middle), "of the half that is drawn, "
        pressed = np.abs(points["pressure"]) @ weights
        if not self.revolves and abs(moment) > 1e-6 * pressed * size:
            yield "moment", moment, "energy", "%sabout %s" % (whose, place(middle[0], middle[1], size))
        yield from self._slip(of, points, weights)

    def _drawn_moment(self, points: Mapping[str, np.ndarray], weights: np.ndarray,
                      middle: np.ndarray) -> float:
        """Of the stresses of a half, about the middle of its side; 0 where the side goes on beyond the line,
        whose middle is on it."""
        if (np.abs(points[self.mirror]) <= 2 * self.lengths.max()).any():
            return 0.0
        x, y = (points[axis] - at for axis, at in zip("xy", middle))
        force = [-(points["pressure"] * d + points["shear"] * t) for d, t in (
            (points["d_x"], -points["d_y"]), (points["d_y"], points["d_x"]))]
        return float((x * force[1] - y * force[0]) @ weights)

    @staticmethod
    def _slip(of: Mapping[str, float], points: Mapping[str, np.ndarray],
              weights: np.ndarray) -> Iterator[tuple]:
        bound = points["bound"]
        if not np.isfinite(bound).all() or not bound.any():  # bonded, or without friction
            return
        share = min(1.0, of["slip_length"] / of["contact_length"])
        told = ("all of it sticks" if share < 1e-9 else "all of it slips" if share > 1 - 1e-9 else
                "%.3g %% of it slips" % (100 * share))
        held, carried = bound @ weights, abs(points["shear"] @ weights)
        if of["force_tangential"] and carried > 1e-6 * held:
            yield ("safety against slip", held / carried, "",
                   "what friction can hold over what it holds; " + told)
        else:  # what slips all over holds itself, at its limit
            yield ("safety against slip", math.inf if share < 1 - 1e-9 else math.nan, "",
                   "no tangential force; " + told)


def largest_stress(fields: str, pictures: Pictures, singular: Optional[Table]) -> Result:
    """Of all that is known of the inside and of the boundary, or of a window: see inside.known.  `singular`:
    where stresses are."""
    x, values = known("von_mises", fields, pictures.folder, pictures.step or shown_step(pictures.folder),
                      pictures.window)
    peak = x[np.argmax(values)]
    size = float(max(np.ptp(x, axis=0)))
    remark = "at " + place(peak[0], peak[1], size)
    if singular is not None and singular.size:
        near = np.hypot(singular["x"] - peak[0], singular["y"] - peak[1])
        if near.min() < 0.02 * size:
            remark += "; stress has no bound there, it grows with the mesh: see stress intensities"
    return Result("the window" if pictures.window else "the bodies", "largest von Mises stress",
                  float(np.max(values)), "stress", remark)
