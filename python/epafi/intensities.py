"""Stress intensities of a run: by Betti's theorem, from its fields on arcs round each place."""
from __future__ import annotations

import functools
import math
from typing import TYPE_CHECKING, Any, Optional

import numpy as np
from numpy.polynomial.legendre import leggauss

from epafi.places import Meeting, Outlines, Place
from epafi.tables import Table
from epafi.wedges import ALIKE, CLAMPED, Corner, Mode, dual_modes, modes

if TYPE_CHECKING:
    from epafi.runs import Run

COLUMNS = ("body", "before", "after", "x", "y", "kind", "angle", "side", "exponent",
           "exponent_imaginary", "k_normal", "k_shear", "k_normal_error", "k_shear_error", "reach",
           "note")
# Radii of the arcs, over the reach, and what they count: smoothly less at the ends, since an average
# over a smooth function of the radius has less of an error of the mesh than an arc has.
SHARES = (np.arange(12) + 0.5) / 12
RADII = 0.15 + 0.65 * SHARES
COUNTS = SHARES * (1 - SHARES) / np.sum(SHARES * (1 - SHARES))
ROUNDING = 1e-9  # of fields, relative
DEFECTIVE = 1e-3  # of the work of a mode with its dual one over their sizes: a logarithm

gauss = functools.lru_cache(maxsize=None)(leggauss)


def work(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Of one's tractions on the other's displacements less that of the other's on one's, per angle
    and radius; both are (u_r, u_theta, sigma_r_theta, sigma_r_r)."""
    return np.asarray(one[3] * other[0] + one[2] * other[1] - other[3] * one[0] - other[2] * one[1])


def modal(corner: Corner, mode: Mode, k: int, angles: np.ndarray, r: np.ndarray | float) -> np.ndarray:
    """The fields of `work` of a mode at distances over the reach."""
    u_r, u_theta, shear, _, radial = mode.fields(corner, k, angles).T
    power = np.asarray(r, complex) ** mode.exponent
    return np.array([u_r * power, u_theta * power, shear * power / r, radial * power / r])


class Arcs:
    """Quadrature points on arcs round a meeting, inside of its bodies; lengths over the reach."""

    def __init__(self, meeting: Meeting) -> None:
        self.meeting = meeting
        parts = []
        for k, (place, wedge) in enumerate(zip(meeting.places, meeting.corner.wedges)):
            for n, r in enumerate(RADII):
                t, weights = gauss(8 + 4 * round((1 + 7 * r) * place.angle / math.pi))
                low, high = (np.arcsin(edge.curvature * r * meeting.reach / 2)
                             for edge in place.edges)
                half = (place.angle - low - high) / 2
                local = low + half * (1 + t)
                parts.append((np.full(len(t), n), np.full(len(t), k), wedge.start + local,
                              half * r * weights, place.x + r * meeting.reach * place.ray(0) * np.exp(
                                  1j * local), place.ray(0) * np.exp(1j * local)))
        self.radius, self.wedge, self.angle, self.weight, self.points, self.ray = map(
            np.concatenate, zip(*parts))

    def solution(self, fields: Table, rows: slice, moves: bool) -> np.ndarray:
        """Of a run, for `work`; without the motion of the place if it `moves`."""
        u = fields["ux"][rows] + 1j * fields["uy"][rows]
        for k, place in enumerate(self.meeting.places if moves else ()):
            shift, turn = place.motion
            here = self.wedge == k
            u[here] -= shift + 1j * turn * (self.points[here] - place.x)
        u = u / self.ray / self.meeting.reach
        mean, half = ((fields["sxx"][rows] + sign * fields["syy"][rows]) / 2 for sign in (1, -1))
        turned = (half + 1j * fields["sxy"][rows]) / np.square(self.ray)
        return np.array([u.real, u.imag, turned.imag, mean + turned.real])

    def works(self, solution: np.ndarray, dual: Mode) -> np.ndarray:
        """Of a solution on a dual mode, for each radius."""
        fields = np.zeros((4, len(self.angle)), complex)
        for k in range(len(self.meeting.places)):
            here = self.wedge == k
            fields[:, here] = modal(self.meeting.corner, dual, k, self.angle[here],
                                    RADII[self.radius[here]])
        density = self.weight * work(solution, fields)
        return np.array([density[self.radius == n].sum() for n in range(len(RADII))])


def full_work(corner: Corner, mode: Mode, dual: Mode) -> complex:
    t, weights = gauss(40)
    total = 0
    for k, wedge in enumerate(corner.wedges):
        half = (wedge.end - wedge.start) / 2
        angles = wedge.start + half * (1 + t)
        total += half * np.sum(weights * work(modal(corner, mode, k, angles, 1.0),
                                              modal(corner, dual, k, angles, 1.0)))
    return complex(total)


def paired(corner: Corner, alike: list[Mode]) -> Optional[tuple[list[Mode], np.ndarray]]:
    """The dual modes of modes with the same exponent, and the work of each mode on each of them; None
    where the stress has logarithms, too."""
    duals = dual_modes(corner, alike[0].exponent)
    matrix = np.array([[full_work(corner, mode, dual) for mode in alike] for dual in duals])
    least = min(wedge.shear_modulus for wedge in corner.wedges)  # displacements are at most 1 / least
    defective = len(duals) != len(alike) or np.linalg.svd(matrix * least)[1][-1] < DEFECTIVE
    return None if defective else (duals, matrix)


def on_arcs(arcs: Arcs, solution: np.ndarray, alike: list[Mode]) -> Optional[np.ndarray]:
    """Amplitudes of modes with the same exponent, their stresses those at the reach, from each
    radius, shape (modes, radii); None if they are not paired."""
    pairs = paired(arcs.meeting.corner, alike)
    if pairs is None:
        return None
    works = np.array([arcs.works(solution, dual) for dual in pairs[0]])
    return np.asarray(np.linalg.solve(pairs[1], works) * (2 if alike[0].exponent.imag else 1))


def powers(meeting: Meeting, at_end: bool, exponent: complex) -> list[complex]:
    """Of r in what an arc shows besides an amplitude: what is given brings terms r^k into the
    displacement, the curvature of edges factors 1 + O(r).  At the end of a path the motion of the place
    is known, at another step it is one of the terms."""
    given = meeting.given
    if 0 in given or meeting.bent:
        given = given - {0} if at_end else given | {0, 1}
    return [k - exponent for k in sorted(given)] + ([1, 2] if meeting.bent else [])


def settled(amplitudes: np.ndarray, components: np.ndarray,
            besides: list[complex]) -> tuple[np.ndarray, np.ndarray]:
    """What the arcs say of both components, from amplitudes of shape (modes, radii), without those
    powers of r; how much it changes with the radius."""
    if not besides:
        values = (components.T @ amplitudes).real
        value = values @ COUNTS
        return value, 2 * abs(values - value[:, None]).max(axis=1) + ROUNDING * abs(value)
    columns = np.array([RADII ** complex(power) for power in (0, *besides)]).T

    def fitted(rows: slice) -> np.ndarray:
        weights = np.sqrt(COUNTS[rows])[:, None]
        matrix = columns[rows] * weights
        size = np.linalg.norm(matrix, axis=0)
        found = np.linalg.lstsq(matrix / size, amplitudes[:, rows].T * weights, 1e-12)[0]
        return np.asarray(found / size[:, None] @ components)

    all_ = fitted(slice(None))
    value = all_[0].real
    changes = [abs((fitted(rows)[0] - all_[0]).real) for rows in (slice(2, None), slice(None, -2))]
    rest = abs((amplitudes.T @ components - columns @ all_).real).max(axis=0)
    return value, 5 * np.max([*changes, rest], axis=0) + ROUNDING * abs(value)


def kind_of(place: Place) -> str:
    faces = place.faces
    if faces[0].kind != faces[1].kind or faces[0].name != faces[1].name:
        for kind, text in (("bond", "end of bond"), ("contact", "edge of contact"),
                           ("clamp", "end of clamp")):
            if kind in (faces[0].kind, faces[1].kind):
                return text
    return "crack" if place.angle == 2 * math.pi else "corner"


def side_of(place: Place) -> float:
    """Where in the wedge stresses are taken: on the face that holds more, 0 after or 1 before the
    place; between free ones on the bisector, 0.5."""
    order = ("free", "symmetry", "clamp", "contact", "bond")
    after, before = ((order.index(face.kind), face.rows == CLAMPED) for face in place.faces)
    return 0.5 if after[0] == before[0] == 0 else 0 if after >= before else 1


def rows_of(arcs: Arcs, fields: Table, rows: slice, at_end: bool) -> list[tuple[Any, ...]]:
    """Of COLUMNS: of each body and exponent of a meeting; whether at the end of the path."""
    meeting = arcs.meeting
    solution = arcs.solution(fields, rows, at_end and (0 in meeting.given or meeting.bent))
    all_modes = modes(meeting.corner)
    groups: list[list[Any]] = []
    for mode in all_modes:
        if groups and abs(groups[-1][0].exponent - mode.exponent) < ALIKE:
            groups[-1].append(mode)
        else:
            groups.append([mode])
    bodies = np.array([place.body for place in meeting.places])[arcs.wedge]
    inside = (fields["body"][rows] == bodies).all()
    result = []
    for alike in groups:
        exponent = alike[0].exponent
        found = on_arcs(arcs, solution, alike) if inside else None
        note = "" if found is not None else (
            "K: two exponents coincide, the stress has a logarithm" if inside else
            "K: the bodies are no wedges as far as reach, they overlap or leave a gap")
        besides = powers(meeting, at_end, exponent)
        for k, place in enumerate(meeting.places):
            at = side_of(place)
            side = place.edges[int(at)].name if at != 0.5 else "bisector"
            wedge = meeting.corner.wedges[k]
            values = errors = np.full(2, math.nan)
            if found is not None:
                stresses = np.array([mode.on_ray(meeting.corner, k, wedge.start + at * (
                    wedge.end - wedge.start)) for mode in alike])
                values, errors = settled(found, stresses * (2 * math.pi * meeting.reach) ** (
                    1 - exponent.real), besides)
            result.append((place.body, place.edges[1].name, place.edges[0].name, place.x.real,
                           place.x.imag, kind_of(place), math.degrees(place.angle), side,
                           exponent.real - 1, exponent.imag, *values, *errors, meeting.reach, note))
    return result


def intensities(run: Run, step: Optional[int] = None) -> Table:
    arcs = [Arcs(meeting) for meeting in Outlines(run, step).meetings()]
    rows: list[tuple[Any, ...]] = []
    if arcs:
        points = np.concatenate([each.points for each in arcs])
        fields = run.fields(np.column_stack([points.real, points.imag]), step=step)
        end = 0
        for each in arcs:
            start, end = end, end + len(each.points)
            rows += rows_of(each, fields, slice(start, end), step is None)
    doubts = ["" if run.converged else "the run is not converged", run.no_result]
    rows = [(*row[:-1], "; ".join(filter(None, (row[-1], *doubts)))) for row in rows]
    return Table.of({name: np.array(column) for name, column in zip(
        COLUMNS, zip(*rows) if rows else [[]] * len(COLUMNS))})
