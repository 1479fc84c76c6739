"""Stress intensities of a run, by a fit of its stresses with the exponents of theory."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from epafi.places import NEAR, Outlines, Place
from epafi.tables import Table
from epafi.wedges import Corner, Mode, modes

if TYPE_CHECKING:
    from epafi.runs import Run

COLUMNS = ("body", "before", "after", "x", "y", "kind", "angle", "side", "exponent",
           "exponent_imaginary", "k_normal", "k_shear", "k_normal_error", "k_shear_error", "reach")
FAR = 0.3  # of the reach: as far as stresses are taken
MOST = (3.2, 2.2, 1.2)  # Re lambda of the terms of a fit: that which changes least counts
POINTS = 40  # on a bisector


@dataclass
class Ray:
    """Stresses (sigma_theta_theta, sigma_r_theta) at distances r; the first two elements from the point on are
    not trusted: `start`."""

    side: str
    angle: float
    start: float
    r: np.ndarray
    weights: np.ndarray
    stresses: np.ndarray


@dataclass
class Singular:
    """A place, what theory says of it, and how far the next one is."""

    place: Place
    corner: Corner
    own: int  # wedge
    modes: list[Mode]
    reach: float

    @property
    def kind(self) -> str:
        kinds = {face.kind for face in self.place.faces}
        for kind, text in (("bond", "end of bond"), ("contact", "edge of contact"),
                           ("clamp", "end of clamp")):
            if kind in kinds:
                return text
        return "crack" if self.place.angle == 2 * math.pi else "corner"

    def start(self, at_end: bool) -> float:
        return max(abs(element.node(not at_end) - self.place.x)
                   for element, _ in zip(self.place.outward(at_end), range(2)))

    def on_side(self, at_end: bool) -> Ray:
        parts, place = [], self.place
        for element in place.outward(at_end):
            parts.append(element.polar(at_end, place.x))
            if parts[-1][0].max() > self.reach:
                break
        r, weights, normal, shear = (np.concatenate(column) for column in zip(*parts))
        return Ray(element.name, place.angle if at_end else 0.0, self.start(at_end), r, weights,
                   np.array([normal, shear]))

    def bisector(self) -> tuple[complex, np.ndarray, float]:
        """Direction, distances, start."""
        start = max(self.start(False), self.start(True))
        direction = self.place.before.after.direction(False) * np.exp(0.5j * self.place.angle)
        return complex(direction), np.geomspace(min(start, self.reach / 10) / 2, self.reach / 2,
                                                POINTS), start


def fitted(ray: Ray, singular: Singular, window: tuple[float, float], most: float) -> np.ndarray:
    """(K_normal, K_shear) of each mode with lambda < 1: least squares of relative errors, equal over
    log r, of the modes with lambda < most, and of uniform and linear stresses if they are; NaN where
    stresses are too few."""
    here = (ray.r > window[0]) & (ray.r < window[1])
    scale = singular.reach
    rho, columns, owners = ray.r[here] / scale, [], []
    terms = [mode for mode in singular.modes if mode.exponent.real < most]
    for k, mode in enumerate(terms):
        stresses = mode.on_ray(singular.corner, singular.own, ray.angle)
        shape = np.outer(stresses, rho ** (mode.exponent - 1))
        columns += [shape.real, -shape.imag][:2 if mode.exponent.imag else 1]
        owners += [(k, stresses.real), (k, -stresses.imag)][:2 if mode.exponent.imag else 1]
    columns += [np.outer(component, rho ** power) for power in range(int(most) - 1)
                for component in np.eye(2)]
    weights = np.tile(np.sqrt(ray.weights[here] / ray.r[here])
                      * rho ** (1 - terms[0].exponent.real), 2)
    matrix = np.column_stack([column.ravel() for column in columns]) * weights[:, None]
    size = np.linalg.norm(matrix, axis=0) + 1e-300
    values = ray.stresses[:, here].ravel() * weights
    result = np.full((sum(mode.exponent.real < 1 for mode in terms), 2), math.nan)
    if len(values) >= 2 * len(columns):
        result[:] = 0
        amplitudes = np.linalg.lstsq(matrix / size, values, 1e-10)[0] / size
        for (k, stresses), amplitude in zip(owners, amplitudes):
            if k < len(result):
                result[k] += amplitude * stresses * (2 * math.pi * scale) ** (
                    1 - terms[k].exponent.real)
    return result


def best(ray: Ray, singular: Singular) -> tuple[np.ndarray, np.ndarray]:
    """Intensities and how much they change with the window; NaN where nothing tells."""
    low, high = ray.start, FAR * singular.reach
    found = []
    for most in MOST:
        k, *others = (fitted(ray, singular, window, most) for window in (
            (low, high), (low, high / 2), (2 * low, high), (low, 1.5 * high)))
        changes = abs(np.array(others) - k)
        changes[np.isnan(changes)] = 0 if np.isfinite(changes).any() else math.inf
        found.append((changes.max(axis=0), k))
    error, k = min(found, key=lambda pair: math.inf if np.isnan(pair[1]).any() else pair[0].max())
    error[np.isinf(error)] = math.nan
    return k, error


def rows_of(singular: Singular, ray: Ray) -> list[tuple[Any, ...]]:
    result: dict[complex, tuple[np.ndarray, np.ndarray]] = {}
    for mode, k, error in zip(singular.modes, *best(ray, singular)):
        near = [old for old in result if abs(old - mode.exponent) < 1e-6]
        key = near[0] if near else mode.exponent  # one row of modes I and II
        sums = result.get(key, (np.zeros(2), np.zeros(2)))
        result[key] = (sums[0] + k, sums[1] + error)
    return [row_of(singular.place, singular.kind, ray.side, exponent, k, error, singular.reach)
            for exponent, (k, error) in result.items()]


def row_of(place: Place, kind: str, side: str, exponent: complex, k: np.ndarray, error: np.ndarray,
           reach: float) -> tuple[Any, ...]:
    """Of COLUMNS, from lambda."""
    names = [element.name for element in (place.before, place.before.after)]
    return (place.before.body, *names, place.x.real, place.x.imag, kind, math.degrees(place.angle),
            side, exponent.real - 1, exponent.imag, *k, *error, reach)


def intensities(run: Run) -> Table:
    outlines = Outlines(run)
    places = outlines.places()
    points = np.array([place.x for place in places])
    fronts = outlines.fronts()
    found, wanted = [], []
    for place in places:
        corner, own = outlines.corner(place)
        if not modes(corner):
            continue
        singular = Singular(place, corner, own, modes(corner, MOST[0]), math.inf)
        ends = [place.faces[0].kind != "free", place.faces[1].kind != "free"]
        start = singular.start(not ends[0] and ends[1])
        distances = np.append(abs(points - place.x), abs(fronts - place.x)[
            abs(fronts - place.x) > start])
        singular.reach = float(min(distances[distances > NEAR * outlines.size], default=outlines.size))
        found.append(singular)
        if not any(ends):
            wanted.append(singular)
    rays = dict(zip(map(id, wanted), on_bisectors(run, wanted))) if wanted else {}
    rows = [row for singular in found for row in rows_of(
        singular, rays.get(id(singular)) or singular.on_side(
            singular.place.faces[0].kind == "free"))]
    for place in outlines.open_ends():
        exponents = modes(outlines.corner(place)[0])
        if exponents and all(abs(points - place.x) > abs(place.before.chord)):
            points = np.append(points, place.x)
            rows.append(row_of(place, "end of contact", "", exponents[0].exponent + 1, np.zeros(2),
                               np.zeros(2), math.nan))
    return Table.of({name: np.array(column) for name, column in zip(
        COLUMNS, zip(*rows) if rows else [[]] * len(COLUMNS))})


def on_bisectors(run: Run, all_singular: list[Singular]) -> list[Ray]:
    laid = [singular.bisector() for singular in all_singular]
    points = np.concatenate([singular.place.x + direction * r for singular, (direction, r, _) in zip(
        all_singular, laid)])
    fields = run.fields(np.column_stack([points.real, points.imag]))
    rays = []
    for k, (singular, (direction, r, start)) in enumerate(zip(all_singular, laid)):
        sxx, syy, sxy = (fields[name][k * POINTS:(k + 1) * POINTS] for name in ("sxx", "syy", "sxy"))
        c, s = direction.real, direction.imag
        rays.append(Ray("bisector", singular.place.angle / 2, start, r, r, np.array([
            s * s * sxx + c * c * syy - 2 * s * c * sxy,
            s * c * (syy - sxx) + (c * c - s * s) * sxy])))
    return rays
