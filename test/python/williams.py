"""An independent solver for wedges that meet in a point: exact solutions r^lambda, as texts of scenes.

Kolosov's potentials and their conjugates are taken as independent, phi = A z^lambda, conj(phi) = B
conj(z)^lambda, psi = C z^lambda, conj(psi) = D conj(z)^lambda, so that all is analytic in lambda.
"""
import cmath
import math

import numpy as np

FREE, CLAMPED = "free", "clamped"


def polar(lam, theta, mu, kappa):
    """(u_r, u_theta, sigma_theta_theta, sigma_r_theta) at r = 1 of A, B, C, D: shape (..., 4, 4)."""
    lam = np.asarray(lam, complex)
    z, c = np.exp(1j * lam * theta), np.exp(-1j * lam * theta)
    e = cmath.exp(1j * theta)
    zero = 0 * lam
    out = np.array([kappa * z, -lam * e * e * c, zero, -c]) / e  # u, turned
    back = np.array([-lam * z / e / e, kappa * c, -z, zero]) * e  # its conjugate
    trace = np.array([2 * lam * z / e, 2 * lam * c * e, zero, zero])
    d = 2 * np.array([lam * (lam - 1) * z / e ** 3, zero, lam * z / e, zero]) * e * e
    bar = 2 * np.array([zero, lam * (lam - 1) * c * e ** 3, zero, lam * c * e]) / e / e
    rows = [(out + back) / 4 / mu, (out - back) / 4j / mu, trace / 2 + (d + bar) / 4, (d - bar) / 4j]
    return np.moveaxis(np.array(rows), [0, 1], [-2, -1])


def matrix(wedges, faces, joints, lam):
    """Wedges (start, end, mu, kappa); faces FREE, CLAMPED, ("roller", angle from the x axis of the
    direction that is held) or a ratio of friction on what is rigid; joints None or a ratio."""
    lam = np.atleast_1d(lam)
    rows, scale = [], wedges[0][2]

    def add(*parts):
        row = np.zeros((len(lam), 4 * len(wedges)), complex)
        for k, values in parts:
            row[:, 4 * k:4 * k + 4] += values
        rows.append(row)

    def at(k, end):
        start = polar(lam, wedges[k][end], wedges[k][2], wedges[k][3])
        start[:, :2] *= scale
        return start

    for face, k, end in ((faces[0], 0, 0), (faces[1], len(wedges) - 1, 1)):
        f = at(k, end)
        if face == FREE:
            add((k, f[:, 2])), add((k, f[:, 3]))
        elif face == CLAMPED:
            add((k, f[:, 0])), add((k, f[:, 1]))
        elif isinstance(face, tuple):
            c, s = math.cos(face[1] - wedges[k][end]), math.sin(face[1] - wedges[k][end])
            add((k, c * f[:, 0] + s * f[:, 1])), add((k, -s * f[:, 3] + c * f[:, 2]))
        else:
            add((k, f[:, 1])), add((k, f[:, 3] - face * f[:, 2]))
    for k, ratio in enumerate(joints):
        a, b = at(k, 1), at(k + 1, 0)
        if ratio is None:
            for i in range(4):
                add((k, a[:, i]), (k + 1, -b[:, i]))
        else:
            for i in (1, 2):
                add((k, a[:, i]), (k + 1, -b[:, i]))
            add((k, a[:, 3] - ratio * a[:, 2])), add((k + 1, b[:, 3] - ratio * b[:, 2]))
    return np.stack(rows, axis=1)


def exponents(wedges, faces, joints=()):
    """All lambda with 0 < Re lambda < 1, Im lambda >= 0: Newton's method for log det."""
    lam = np.add.outer(np.arange(0.03, 1.02, 0.03), [0.001j, 0.08j, 0.25j]).ravel()
    for _ in range(40):
        h = 1e-6
        slope = (matrix(wedges, faces, joints, lam + h) - matrix(wedges, faces, joints, lam - h)) / 2 / h
        left, values, right = np.linalg.svd(matrix(wedges, faces, joints, lam))
        inverse = right.conj().swapaxes(1, 2) / (values + 1e-30)[:, None] @ left.conj().swapaxes(1, 2)
        trace = np.trace(inverse @ slope, axis1=1, axis2=2)
        step = 1 / trace
        step *= np.minimum(1, 0.1 / abs(step))
        lam = lam - step
        here = np.isfinite(lam) & (abs(lam - 0.5) < 1.5)
        lam, step = lam[here], step[here]
    found = []
    for root in sorted(lam[abs(step) < 1e-9], key=lambda x: (x.real, x.imag)):
        root = complex(root.real, abs(root.imag) if abs(root.imag) > 1e-7 else 0)
        if 0.02 < root.real < 0.999 and all(abs(root - other) > 1e-6 for other in found):
            found.append(root)
    return found


class Solution:
    """A real solution of exponents lambda and its conjugate, in one wedge."""

    def __init__(self, wedge, lam, unknowns):
        self.wedge, self.lam, self.unknowns = wedge, complex(lam), unknowns

    def ray(self, theta, r=1.0):
        """(u_r, u_theta, sigma_theta_theta, sigma_r_theta)."""
        values = polar(self.lam, theta, *self.wedge[2:]) @ self.unknowns
        return 2 * np.real(np.concatenate([values[:2] * r ** self.lam,
                                           values[2:] * r ** (self.lam - 1)]))

    def texts(self, weight=1.0):
        """(u_x, u_y, traction x, traction y) of x, y, nx, ny."""
        lam, (a, b, c, d), (mu, kappa) = self.lam, self.unknowns * weight, self.wedge[2:]

        def term(factor, power, turns):
            """(real, imaginary part) of factor r^power e^(i turns theta)."""
            grow = "exp(%.17g*L+(%.17g)*T)" % (power.real, -complex(turns).imag)
            phase = "(%.17g)*L+(%.17g)*T" % (power.imag, complex(turns).real)
            f = complex(factor)
            return ("%s*((%.17g)*cos(%s)-(%.17g)*sin(%s))" % (grow, f.real, phase, f.imag, phase),
                    "%s*((%.17g)*sin(%s)+(%.17g)*cos(%s))" % (grow, f.real, phase, f.imag, phase))

        def total(terms, conjugates):
            parts = [(term(*t), "+") for t in terms] + [(term(*t), "-") for t in conjugates]
            return ("+".join("(%s)" % t[0] for t, _ in parts),
                    "0" + "".join("%s(%s)" % (sign, t[1]) for t, sign in parts))

        ux, uy = total([(kappa * a / 2 / mu, lam, lam), (-lam * b / 2 / mu, lam, 2 - lam),
                        (-d / 2 / mu, lam, -lam)],
                       [(kappa * b / 2 / mu, lam, -lam), (-lam * a / 2 / mu, lam, lam - 2),
                        (-c / 2 / mu, lam, lam)])
        trace, _ = total([(4 * lam * a, lam - 1, lam - 1), (4 * lam * b, lam - 1, 1 - lam)], [])
        re, im = total([(2 * lam * (lam - 1) * a, lam - 1, lam - 3), (2 * lam * c, lam - 1, lam - 1)],
                       [(2 * lam * (lam - 1) * b, lam - 1, 3 - lam), (2 * lam * d, lam - 1, 1 - lam)])
        xx, yy, xy = "(%s-(%s))/2" % (trace, re), "(%s+(%s))/2" % (trace, re), "(%s)/2" % im
        return tuple(text.replace("L", "ln(x^2+y^2)/2").replace("T", "atan2(y,x)") for text in (
            ux, uy, "(%s)*nx+(%s)*ny" % (xx, xy), "(%s)*nx+(%s)*ny" % (xy, yy)))


def solution(wedges, faces, joints, lam):
    """In each wedge, of arbitrary size."""
    unknowns = np.linalg.svd(matrix(wedges, faces, joints, lam)[0])[2][-1].conj()
    part = [Solution(wedge, lam, unknowns[4 * k:4 * k + 4]) for k, wedge in enumerate(wedges)]
    if lam.imag == 0:  # the real part may vanish
        sizes = [max(np.abs(p.ray(t)).max() for p in (Solution(w, lam, f * u.unknowns) for w, u in zip(
            wedges, part)) for t in (p.wedge[0], p.wedge[1])) for f in (1, 1j)]
        part = [Solution(p.wedge, lam, p.unknowns * (1 if sizes[0] > sizes[1] else 1j)) for p in part]
    return part
