"""Exponents of the stress where elastic wedges meet in a point (Williams, Dundurs, Comninou).

Around the point a wedge has the displacement r^lambda and the stress r^(lambda - 1) of Kolosov's potentials
phi = a z^lambda, psi = b z^lambda.  Conditions on faces and joints are linear in (Re a, Im a, Re b,
Im b) of all wedges, M(lambda) c = 0; the exponents are the lambda with a solution c, its mode.
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

    def fields(self, exponent: complex, angle: float) -> np.ndarray:
        """(u_r, u_theta, sigma_r_theta, sigma_theta_theta) over powers of r, of each unknown."""
        minus, plus = (exponent - 1) * angle, (exponent + 1) * angle
        cm, sm, cp, sp = np.cos(minus), np.sin(minus), np.cos(plus), np.sin(plus)
        less, more, k = exponent - 1, exponent + 1, self.kappa
        u = np.array([[(k - exponent) * cm, (exponent - k) * sm, -cp, sp],
                      [(k + exponent) * sm, (k + exponent) * cm, sp, cp]]) / (2 * self.shear_modulus)
        stress = exponent * np.array([[less * sm, less * cm, sp, cp],
                                      [more * cm, -more * sm, cp, -sp]])
        return np.concatenate([u, stress])


@dataclass(frozen=True)
class Corner:
    """Wedges one after the other, anticlockwise, bonded (None) or sliding by a ratio at the joints
    between them; without faces the last one is joined to the first."""

    wedges: tuple[Wedge, ...]
    joints: tuple[Optional[float], ...] = ()
    faces: Optional[tuple[Rows, Rows]] = None

    def matrix(self, exponent: complex) -> np.ndarray:
        n, unit = len(self.wedges), np.diag([self.wedges[0].shear_modulus] * 2 + [1.0] * 2)
        rows = []

        def add(conditions: np.ndarray, *sides: tuple[int, float]) -> None:
            row = np.zeros((len(conditions), 4 * n), complex)
            for sign, (k, angle) in zip((1, -1), sides):
                row[:, 4 * k:4 * k + 4] += sign * np.array(conditions) @ unit @ (
                    self.wedges[k].fields(exponent, angle))
            rows.append(row)

        for k, ratio in enumerate(self.joints):
            left, right = (k, self.wedges[k].end), ((k + 1) % n, self.wedges[(k + 1) % n].start)
            if ratio is None:
                add(np.eye(4), left, right)
            else:
                add(np.eye(4)[[1, 3]], left, right)
                for side in (left, right):
                    add(np.array(sliding(ratio)[1:]), side)
        if self.faces:
            add(np.array(self.faces[0]), (0, self.wedges[0].start))
            add(np.array(self.faces[1]), (n - 1, self.wedges[-1].end))
        return np.concatenate(rows)


@dataclass(frozen=True)
class Mode:
    """A solution r^exponent: its stresses on a ray are those of the vector c."""

    exponent: complex  # lambda
    unknowns: np.ndarray

    def on_ray(self, corner: Corner, wedge: int, angle: float) -> np.ndarray:
        """(sigma_theta_theta, sigma_r_theta) over r^(lambda - 1)."""
        fields = corner.wedges[wedge].fields(self.exponent, angle)
        stresses = fields[[3, 2]] @ self.unknowns[4 * wedge:4 * wedge + 4]
        stresses[abs(stresses) < 1e-10 * abs(stresses).max()] = 0  # what is rounding, by symmetry
        return stresses


def _root(corner: Corner, exponent: complex) -> Optional[complex]:
    """Newton's method for the nonlinear eigenvalue problem: M(lambda) c = theta M'(lambda) c with the smallest
    theta, lambda - theta is the next; full accuracy at multiple roots as well."""
    h = 1e-5
    for _ in range(40):
        slope = (corner.matrix(exponent + h) - corner.matrix(exponent - h)) / (2 * h)
        try:
            inverse = np.linalg.eigvals(np.linalg.solve(corner.matrix(exponent), slope))
        except np.linalg.LinAlgError:  # it is a root
            return exponent
        step = 1 / inverse[np.argmax(abs(inverse))]
        exponent -= step
        if abs(step) < 1e-13:
            return exponent
        if not 0 < exponent.real < 6 or abs(exponent.imag) > 3:
            return None
    return exponent if abs(step) < 1e-10 else None


@functools.lru_cache(maxsize=None)
def modes(corner: Corner, most: float = 1) -> list[Mode]:
    """All with 0 < Re lambda < most, Im lambda >= 0, without lambda = 1, 2, ..., which uniform stresses,
    rotations and loads have; the smallest real part first."""
    roots: list[complex] = []
    for real in np.arange(0.05, most, 0.15):
        for imaginary in (0.0, 0.15, 0.5):
            root = _root(corner, complex(real, imaginary + 1e-3))
            if root is None:
                continue
            root = complex(root.real, abs(root.imag) if abs(root.imag) > 1e-9 else 0)
            if 0.01 < root.real < most - 1e-9 and abs(root - round(root.real)) > 1e-7 and all(
                    abs(root - other) > 1e-7 for other in roots):
                roots.append(root)
    result = []
    for root in sorted(roots, key=lambda root: (root.real, root.imag)):
        _, values, right = np.linalg.svd(corner.matrix(root))
        for k in np.flatnonzero(values < 1e-8 * values[0]):
            vector = right[k].conj()
            if root.imag == 0:  # of a real matrix
                vector = np.real(vector / vector[np.argmax(abs(vector))])
            result.append(Mode(root, vector))
    return result
