"""Exponents of the stress where elastic wedges meet in a point (Williams, Dundurs, Comninou), and the
modes that belong to them.

Around the point a wedge has the displacement r^lambda and the stress r^(lambda - 1) of Kolosov's
potentials phi = a z^lambda, psi = b z^lambda.  Conditions on faces and joints are linear in (Re a,
Im a, Re b, Im b) of all wedges, M(lambda) c = 0; the exponents are the lambda with a solution c,
its mode.  Between a solution and a dual mode, of the exponent -lambda and of the adjoint conditions,
the reciprocal work over an arc is that of the mode lambda alone (Betti), whatever the arc's radius.
"""
from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Iterator, Optional

import numpy as np

Rows = tuple[tuple[float, float, float, float], ...]

# What vanishes on a face, in terms of (u_r, u_theta, sigma_r_theta, sigma_theta_theta).
FREE: Rows = ((0, 0, 1, 0), (0, 0, 0, 1))
CLAMPED: Rows = ((1, 0, 0, 0), (0, 1, 0, 0))
# The work of a face's tractions on another solution's displacements, less that with both exchanged.
WORK = np.array([[0, 0, -1, 0], [0, 0, 0, -1], [1, 0, 0, 0], [0, 1, 0, 0]])
ALIKE = 1e-7  # exponents that differ by less are one
BOUNDED = 1e-3  # stresses that grow like r^-BOUNDED or less do not count as singular


def held(angle: float) -> Rows:
    """Only the displacement in a direction is prescribed, at an angle from the face's ray [radian]."""
    c, s = np.cos(angle), np.sin(angle)
    return ((c, s, 0, 0), (0, 0, -s, c))


def sliding(ratio: float) -> Rows:
    """On what is rigid, sigma_r_theta = ratio sigma_theta_theta: without friction ratio is 0."""
    return ((0, 1, 0, 0), (0, 0, 1, -ratio))


def joined(ratio: Optional[float]) -> np.ndarray:
    """What vanishes on the two sides of a joint, (left, right): bonded (None), or sliding."""
    if ratio is None:
        return np.hstack([np.eye(4), -np.eye(4)])
    left, right = np.array(sliding(ratio)), np.array([(0, -1, 0, 0), (0, 0, 0, 0)])
    shear = np.hstack([0 * left[1:], left[1:]])
    return np.vstack([np.hstack([left, right]), shear, [0, 0, 0, 1, 0, 0, 0, -1]])


def adjoint(rows: np.ndarray) -> np.ndarray:
    """What vanishes in those solutions that exchange no work with any that fulfil the rows: sliding
    with friction it is u_theta + ratio u_r and sigma_r_theta."""
    count = len(rows)
    solutions = np.linalg.svd(rows)[2][count:]
    work = np.kron(np.diag([1, -1][:count // 2]), WORK)
    return solutions @ work


@dataclass(frozen=True)
class Wedge:
    """Material between two rays, start < end [radian]."""

    start: float
    end: float
    shear_modulus: float
    kappa: float  # Kolosov's constant

    def fields(self, exponents: np.ndarray, angles: np.ndarray | float) -> np.ndarray:
        """(u_r, u_theta, sigma_r_theta, sigma_theta_theta, sigma_r_r) over powers of r, of each
        unknown: shape (shape of exponents and angles, 5, 4)."""
        k, less, more = self.kappa, exponents - 1, exponents + 1
        cm, sm = np.cos(less * angles), np.sin(less * angles)
        cp, sp = np.cos(more * angles), np.sin(more * angles)
        minus, plus, double = k - exponents, k + exponents, 2 * self.shear_modulus
        across = [exponents * more * cm, -exponents * more * sm, exponents * cp, -exponents * sp]
        trace = [4 * exponents * cm, -4 * exponents * sm, 0, 0]  # of the stress
        rows = [[minus * cm / double, -minus * sm / double, -cp / double, sp / double],
                [plus * sm / double, plus * cm / double, sp / double, cp / double],
                [exponents * less * sm, exponents * less * cm, exponents * sp, exponents * cp],
                across, [a - b for a, b in zip(trace, across)]]
        return np.moveaxis(np.array(rows), [0, 1], [-2, -1])


@dataclass(frozen=True)
class Corner:
    """Wedges one after the other, anticlockwise, bonded (None) or sliding by a ratio at the joints
    between them; without faces the last one is joined to the first."""

    wedges: tuple[Wedge, ...]
    joints: tuple[Optional[float], ...] = ()
    faces: Optional[tuple[Rows, Rows]] = None

    def conditions(self) -> Iterator[tuple[np.ndarray, tuple[tuple[int, float], ...]]]:
        """Rows, and the sides (wedge, angle) that they tie."""
        n = len(self.wedges)
        for k, ratio in enumerate(self.joints):
            after = (k + 1) % n
            yield joined(ratio), ((k, self.wedges[k].end), (after, self.wedges[after].start))
        if self.faces:
            yield np.array(self.faces[0], float), ((0, self.wedges[0].start),)
            yield np.array(self.faces[1], float), ((n - 1, self.wedges[-1].end),)

    def matrix(self, exponents: np.ndarray, dual: bool = False) -> np.ndarray:
        """M, or that of the adjoint conditions, shape (size, 4n, 4n)."""
        unit = np.array([self.wedges[0].shear_modulus] * 2 + [1.0] * 2)
        blocks = []
        for rows, sides in self.conditions():
            rows = adjoint(rows) if dual else rows
            block = np.zeros((len(exponents), len(rows), 4 * len(self.wedges)), complex)
            for k, (wedge, angle) in enumerate(sides):
                block[:, :, 4 * wedge:4 * wedge + 4] += (rows[:, 4 * k:4 * k + 4] * unit) @ (
                    self.wedges[wedge].fields(exponents, angle)[:, :4])
            blocks.append(block)
        return np.concatenate(blocks, axis=1)

    def null(self, exponent: complex, dual: bool = False) -> list[np.ndarray]:
        """The solutions of M c = 0."""
        _, values, right = np.linalg.svd(self.matrix(np.array([exponent]), dual)[0])
        vectors = [row.conj() for row in right[values < 1e-7 * values[0]]]
        if np.imag(exponent) == 0:  # of a real matrix
            vectors = [np.real(vector / vector[np.argmax(abs(vector))]) for vector in vectors]
        return vectors


@dataclass(frozen=True)
class Mode:
    """A solution r^exponent; of a dual mode the exponent is -lambda."""

    exponent: complex
    unknowns: np.ndarray

    def fields(self, corner: Corner, wedge: int, angles: np.ndarray) -> np.ndarray:
        """(u_r, u_theta, sigma_r_theta, sigma_theta_theta, sigma_r_r) at r = 1."""
        return corner.wedges[wedge].fields(np.array(self.exponent), angles) @ (
            self.unknowns[4 * wedge:4 * wedge + 4])

    def on_ray(self, corner: Corner, wedge: int, angle: float) -> np.ndarray:
        """(sigma_theta_theta, sigma_r_theta) over r^(lambda - 1)."""
        stresses = self.fields(corner, wedge, np.array(angle))[[3, 2]]
        stresses[abs(stresses) < 1e-10 * abs(stresses).max()] = 0  # what is rounding, by symmetry
        return stresses


def _near_roots(corner: Corner, points: int = 128, moments: int = 4) -> np.ndarray:
    """Of M, those within an ellipse and some others: Beyn's method, eigenvalues of the moments of
    M^-1 along the ellipse, whose strip of Re lambda in (0, 1) it encloses."""
    turn = np.exp(2j * np.pi * (np.arange(points) + 0.5) / points)
    place = 0.5 + 0.62 * turn.real + 0.9j * turn.imag
    slope = -0.62 * turn.imag + 0.9j * turn.real
    inverse = np.linalg.inv(corner.matrix(place)) * slope[:, None, None]
    scaled = (place - 0.5)[:, None] ** np.arange(2 * moments)
    taken = np.einsum("pk,pij->kij", scaled, inverse) / points
    rows = [np.block([[taken[i + j + shift] for j in range(moments)] for i in range(moments)])
            for shift in (0, 1)]
    left, values, right = np.linalg.svd(rows[0])
    rank = np.count_nonzero(values > 1e-11 * values[0])
    reduced = left[:, :rank].conj().T @ rows[1] @ right[:rank].conj().T / values[:rank]
    return np.linalg.eigvals(reduced) + 0.5


def _polished(corner: Corner, exponents: np.ndarray) -> np.ndarray:
    """Newton's method for the nonlinear eigenvalue problem: of M(lambda) c = theta M'(lambda) c the
    smallest theta leads to lambda - theta, with full accuracy at multiple roots as well."""
    h = 1e-5
    for _ in range(8):
        if not exponents.size:
            break
        slopes = (corner.matrix(exponents + h) - corner.matrix(exponents - h)) / (2 * h)
        left, values, right = np.linalg.svd(corner.matrix(exponents))
        inverse = (right.conj().swapaxes(1, 2) / (values + 1e-30)[:, None]) @ (
            left.conj().swapaxes(1, 2) @ slopes)
        eigenvalues = np.linalg.eigvals(inverse)
        largest = abs(eigenvalues).argmax(axis=1)
        step = 1 / np.take_along_axis(eigenvalues, largest[:, None], 1)[:, 0]
        exponents = exponents - step
        inside = abs(exponents - 0.5) < 2
        exponents, step = exponents[inside], step[inside]
        if (abs(step) < 1e-13).all():
            break
    return exponents[abs(step) < 1e-9] if exponents.size else exponents


@functools.lru_cache(maxsize=None)
def modes(corner: Corner) -> list[Mode]:
    """All with 0 < Re lambda < 1 - BOUNDED, Im lambda >= 0; the smallest real part first."""
    near = _near_roots(corner)
    near = near[(near.real > -0.05) & (near.real < 1.05) & (abs(near.imag) < 1)]
    roots: list[complex] = []
    for root in sorted(_polished(corner, near), key=lambda root: (root.real, root.imag)):
        root = complex(root.real, abs(root.imag) if abs(root.imag) > 1e-9 else 0)
        if 0.01 < root.real < 1 - BOUNDED and all(abs(root - other) > ALIKE for other in roots):
            roots.append(root)
    return [Mode(root, vector) for root in roots for vector in corner.null(root)]


@functools.lru_cache(maxsize=None)
def dual_modes(corner: Corner, exponent: complex) -> list[Mode]:
    return [Mode(-exponent, vector) for vector in corner.null(-exponent, dual=True)]
