"""Exponents of the stress where elastic wedges meet in a point (Williams, Dundurs, Comninou).

Around the point a wedge has the displacement r^lambda and the stress r^(lambda - 1) of Kolosov's
potentials phi = a z^lambda, psi = b z^lambda.  Conditions on faces and joints are linear in (Re a,
Im a, Re b, Im b) of all wedges, M(lambda) c = 0; the exponents are the lambda with a solution c,
its mode.
"""
from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Optional

import numpy as np

Rows = tuple[tuple[float, float, float, float], ...]

# What vanishes on a face, in terms of (u_r, u_theta, sigma_r_theta, sigma_theta_theta).
FREE: Rows = ((0, 0, 1, 0), (0, 0, 0, 1))
CLAMPED: Rows = ((1, 0, 0, 0), (0, 1, 0, 0))


def held(angle: float) -> Rows:
    """Only the displacement in a direction is prescribed, at an angle from the face's ray [radian]."""
    c, s = np.cos(angle), np.sin(angle)
    return ((c, s, 0, 0), (0, 0, -s, c))


def sliding(ratio: float) -> Rows:
    """On what is rigid, sigma_r_theta = ratio sigma_theta_theta: without friction ratio is 0."""
    return ((0, 1, 0, 0), (0, 0, 1, -ratio))


@dataclass(frozen=True)
class Wedge:
    """Material between two rays, start < end [radian]."""

    start: float
    end: float
    shear_modulus: float
    kappa: float  # Kolosov's constant

    def fields(self, exponents: np.ndarray, angle: float) -> np.ndarray:
        """(u_r, u_theta, sigma_r_theta, sigma_theta_theta) over powers of r, of each unknown: shape
        (size, 4, 4)."""
        k, less, more = self.kappa, exponents - 1, exponents + 1
        cm, sm, cp, sp = (f(which * angle) for which in (less, more) for f in (np.cos, np.sin))
        minus, plus, double = k - exponents, k + exponents, 2 * self.shear_modulus
        rows = [[minus * cm / double, -minus * sm / double, -cp / double, sp / double],
                [plus * sm / double, plus * cm / double, sp / double, cp / double],
                [exponents * less * sm, exponents * less * cm, exponents * sp, exponents * cp],
                [exponents * more * cm, -exponents * more * sm, exponents * cp, -exponents * sp]]
        return np.moveaxis(np.array(rows), 2, 0)


@dataclass(frozen=True)
class Corner:
    """Wedges one after the other, anticlockwise, bonded (None) or sliding by a ratio at the joints
    between them; without faces the last one is joined to the first."""

    wedges: tuple[Wedge, ...]
    joints: tuple[Optional[float], ...] = ()
    faces: Optional[tuple[Rows, Rows]] = None

    def matrix(self, exponents: np.ndarray) -> np.ndarray:
        """M, shape (size, 4n, 4n)."""
        n, unit = len(self.wedges), np.diag([self.wedges[0].shear_modulus] * 2 + [1.0] * 2)
        rows = []

        def add(conditions: Rows, *sides: tuple[int, float]) -> None:
            row = np.zeros((len(exponents), len(conditions), 4 * n), complex)
            for sign, (k, angle) in zip((1, -1), sides):
                row[:, :, 4 * k:4 * k + 4] += sign * np.array(conditions) @ unit @ (
                    self.wedges[k].fields(exponents, angle))
            rows.append(row)

        for k, ratio in enumerate(self.joints):
            left, right = (k, self.wedges[k].end), ((k + 1) % n, self.wedges[(k + 1) % n].start)
            if ratio is None:
                add(CLAMPED + FREE, left, right)
            else:
                add((CLAMPED[1], FREE[1]), left, right)
                for side in (left, right):
                    add(sliding(ratio)[1:], side)
        if self.faces:
            add(self.faces[0], (0, self.wedges[0].start))
            add(self.faces[1], (n - 1, self.wedges[-1].end))
        return np.concatenate(rows, axis=1)


@dataclass(frozen=True)
class Mode:
    """A solution r^exponent: its stresses on a ray are those of the vector c."""

    exponent: complex  # lambda
    unknowns: np.ndarray

    def on_ray(self, corner: Corner, wedge: int, angle: float) -> np.ndarray:
        """(sigma_theta_theta, sigma_r_theta) over r^(lambda - 1)."""
        fields = corner.wedges[wedge].fields(np.array([self.exponent]), angle)
        stresses = fields[0, [3, 2]] @ self.unknowns[4 * wedge:4 * wedge + 4]
        stresses[abs(stresses) < 1e-10 * abs(stresses).max()] = 0  # what is rounding, by symmetry
        return stresses


def _roots(corner: Corner, exponents: np.ndarray) -> np.ndarray:
    """From many starts.  Newton's method for the nonlinear eigenvalue problem: of M(lambda) c = theta
    M'(lambda) c the smallest theta leads to lambda - theta, with full accuracy at multiple roots as
    well."""
    h = 1e-5
    for _ in range(25):
        slopes = (corner.matrix(exponents + h) - corner.matrix(exponents - h)) / (2 * h)
        left, values, right = np.linalg.svd(corner.matrix(exponents))
        inverse = (right.conj().swapaxes(1, 2) / (values + 1e-30)[:, None]) @ (
            left.conj().swapaxes(1, 2) @ slopes)
        eigenvalues = np.linalg.eigvals(inverse)
        largest = abs(eigenvalues).argmax(axis=1)
        step = 1 / np.take_along_axis(eigenvalues, largest[:, None], 1)[:, 0]
        exponents = exponents - step
        inside = (exponents.real > 0) & (exponents.real < 6) & (abs(exponents.imag) < 3)
        exponents, step = exponents[inside], step[inside]
    return exponents[abs(step) < 1e-11]


@functools.lru_cache(maxsize=None)
def modes(corner: Corner, most: float = 1) -> list[Mode]:
    """All with 0 < Re lambda < most, Im lambda >= 0, without lambda = 1, 2, ..., which uniform stresses,
    rotations and loads have; the smallest real part first."""
    starts = np.add.outer(np.arange(0.05, most, 0.15), [0.001j, 0.15j, 0.5j]).ravel()
    roots: list[complex] = []
    for root in _roots(corner, starts):
        root = complex(root.real, abs(root.imag) if abs(root.imag) > 1e-9 else 0)
        if 0.01 < root.real < most - 1e-9 and abs(root - round(root.real)) > 1e-4 and all(
                abs(root - other) > 1e-4 for other in roots):
            roots.append(root)
    result = []
    for root in sorted(roots, key=lambda root: (root.real, root.imag)):
        _, values, right = np.linalg.svd(corner.matrix(np.array([root]))[0])
        for k in np.flatnonzero(values < 1e-8 * values[0]):
            vector = right[k].conj()
            if root.imag == 0:  # of a real matrix
                vector = np.real(vector / vector[np.argmax(abs(vector))])
            result.append(Mode(root, vector))
    return result
