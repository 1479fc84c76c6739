"""Stress intensities of a run, by a fit of its stresses with the exponents of theory."""
from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from epafi.places import Outlines, Place
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
    """Stresses (sigma_theta_theta, sigma_r_theta) at distances r; `ends` of the first two elements,
    which the error next to the point spoils."""

    side: str
    angle: float
    ends: tuple[float, float]
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

    def ends(self, at_end: bool) -> tuple[float, float]:
        far = [abs(element.node(not at_end) - self.place.x)
               for element, _ in zip(self.place.outward(at_end), range(2))]
        return far[0], far[-1]

    def on_side(self, at_end: bool) -> Ray:
        parts, place = [], self.place
        for element in place.outward(at_end):
            parts.append(element.polar(at_end, place.x))
            if parts[-1][0].max() > self.reach:
                break
        r, weights, normal, shear = (np.concatenate(column) for column in zip(*parts))
        return Ray(element.name, place.angle if at_end else 0.0, self.ends(at_end), r, weights,
                   np.array([normal, shear]))

    def bisector(self) -> tuple[complex, np.ndarray, tuple[float, float]]:
        """Direction, distances, ends."""
        first, second = (max(ends) for ends in zip(self.ends(False), self.ends(True)))
        direction = self.place.before.after.direction(False) * np.exp(0.5j * self.place.angle)
        return (complex(direction), np.geomspace(min(second, self.reach / 10) / 2, self.reach,
                                                 POINTS), (first, second))


def fitted(ray: Ray, singular: Singular, window: tuple[float, float], most: float) -> np.ndarray:
    """(K_normal, K_shear) of each mode with lambda < 1: least squares of relative errors, equal over
    log r, of the modes with lambda < most, and of uniform and linear stresses if they are; NaN where
    stresses are too few."""
    here = (ray.r > window[0]) & (ray.r < window[1]) & np.isfinite(ray.stresses).all(axis=0)
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
    """Intensities, and how much they change with the window, the first of those that hold enough
    stresses; NaN where none does."""
    for low, far in ((ray.ends[1], FAR), (ray.ends[0], FAR), (ray.ends[0], 2 * FAR)):
        high, found = far * singular.reach, []
        for most in MOST:
            k, *others = (fitted(ray, singular, window, most) for window in (
                (low, high), (low, high / 2), (2 * low, high), (low, 1.5 * high)))
            changes = abs(np.array(others) - k)
            if (changes > 1e-9 * abs(k).max()).any():  # other windows hold other stresses
                found.append((np.nanmax(changes, axis=0), k))
        if found:
            error, k = min(found, key=lambda pair: pair[0].max())
            return k, error
    return np.full_like(k, math.nan), np.full_like(k, math.nan)


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
    found, wanted = [], []
    for place in places:
        corner, own = outlines.corner(place)
        if not modes(corner):
            continue
        singular = Singular(place, corner, own, modes(corner, MOST[0]), math.inf)
        ends = [place.faces[0].kind != "free", place.faces[1].kind != "free"]
        singular.reach = outlines.reach(place, points, singular.ends(not ends[0] and ends[1])[1])
        found.append(singular)
        if not any(ends):
            wanted.append(singular)
    rays = dict(zip(map(id, wanted), on_bisectors(run, wanted))) if wanted else {}
    rows = [row for singular in found for row in rows_of(
        singular, rays.get(id(singular)) or singular.on_side(
            singular.place.faces[0].kind == "free"))]
    for place in outlines.open_ends():
        exponents = modes(outlines.corner(place)[0])
        if exponents and all(abs(points - place.x) > 2 * abs(place.before.chord)):
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
    for k, (singular, (direction, r, ends)) in enumerate(zip(all_singular, laid)):
        sxx, syy, sxy = (fields[name][k * POINTS:(k + 1) * POINTS] for name in ("sxx", "syy", "sxy"))
        c, s = direction.real, direction.imag
        rays.append(Ray("bisector", singular.place.angle / 2, ends, r, r, np.array([
            s * s * sxx + c * c * syy - 2 * s * c * sxy,
            s * c * (syy - sxx) + (c * c - s * s) * sxy])))
    return rays
