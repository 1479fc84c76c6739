"""Fatigue over a cycle of a load path: Smith, Watson and Topper on the critical plane, and Dang Van."""
from __future__ import annotations

import itertools
import math
from typing import TYPE_CHECKING, Optional, Sequence

import numpy as np

from epafi.program import InputError
from epafi.tables import Table

if TYPE_CHECKING:
    from epafi.runs import Run

PLANES = 90  # every 2 degrees, then closer around the best
POINTS = 256  # at a time


def swt(stress: np.ndarray, young: float, poisson: float) -> np.ndarray:
    """Smith, Watson and Topper's parameter of points, from (sxx, syy, sxy, szz) at each step,
    shape (..., steps, 4):

        max over planes of <sigma_n,max> (eps_n,max - eps_n,min) / 2

    with normals in the plane; and the angle of that normal [degree], its largest stress and its
    strain amplitude: shape (..., 4).  Strains are elastic ones, without thermal expansion."""
    sxx, syy, sxy, szz = np.moveaxis(stress, -1, 0)
    strain = np.stack([sxx - poisson * (syy + szz), syy - poisson * (sxx + szz),
                       (1 + poisson) * sxy], -1) / young
    angles = np.broadcast_to(np.linspace(0, math.pi, PLANES, endpoint=False),
                             (*stress.shape[:-2], PLANES))
    width = math.pi
    for _ in range(5):
        c, s = np.cos(angles), np.sin(angles)
        shape = np.stack([c * c, s * s, 2 * s * c], -2)
        largest = np.maximum((stress[..., :3] @ shape).max(axis=-2), 0)
        amplitude = np.ptp(strain @ shape, axis=-2) / 2
        best = np.argmax(largest * amplitude, axis=-1)[..., None]
        plane, pull, range_ = (np.take_along_axis(each, best, -1) for each in (
            angles, largest, amplitude))
        width /= 20
        angles = plane + np.linspace(-width, width, 41)
    return np.concatenate([pull * range_, np.round(np.degrees(plane), 9) % 180, pull, range_], -1)


def smallest_ball(points: np.ndarray) -> np.ndarray:
    """The middle of the smallest ball around points of shape (size, dimension)."""
    def ball(support: Sequence[int]) -> Optional[tuple[np.ndarray, float]]:
        """Through all of them, if its middle is between them."""
        ways = points[list(support[1:])] - points[support[0]]
        products = ways @ ways.T
        weights = np.linalg.lstsq(2 * products, np.diag(products), 1e-12)[0]
        if len(weights) and min(weights.min(), 1 - weights.sum()) < -1e-12:
            return None
        return points[support[0]] + weights @ ways, math.sqrt(weights @ products @ weights)

    size = np.linalg.norm(np.ptp(points, axis=0)) + 1e-300
    support, middle, radius = [0], points[0], 0.0
    while True:
        distances = np.linalg.norm(points - middle, axis=1)
        farthest = int(np.argmax(distances))
        if distances[farthest] <= radius + 1e-10 * size:
            return middle
        candidates = [*support, farthest]
        found = []
        for count in range(1, len(candidates) + 1):
            for chosen in itertools.combinations(candidates, count):
                new = ball(chosen)
                if new is not None and (np.linalg.norm(points[candidates] - new[0], axis=1)
                                        <= new[1] + 1e-11 * size).all():
                    found.append((new[1], list(chosen), new[0]))
        radius, support, middle = min(found, key=lambda entry: entry[0])


def dang_van(stress: np.ndarray, alpha: float) -> tuple[float, int, float, float]:
    """Dang Van's parameter of one point, from (sxx, syy, sxy, szz) at each step:

        max over steps of tau + alpha sigma_H,   tau = (s_1 - s_3) / 2

    with the principal values of the deviator less the middle of the smallest ball around its path
    (norm s:s); and the step of the maximum, tau and sigma_H there."""
    hydrostatic = (stress[:, 0] + stress[:, 1] + stress[:, 3]) / 3
    deviator = stress - np.outer(hydrostatic, [1, 1, 0, 1])
    scale = np.array([1, 1, math.sqrt(2), 1])
    sxx, syy, sxy, szz = (deviator - smallest_ball(deviator * scale) / scale).T
    radius, middle = np.hypot((sxx - syy) / 2, sxy), (sxx + syy) / 2
    principal = np.array([middle + radius, middle - radius, szz])
    tau = np.ptp(principal, axis=0) / 2
    step = int(np.argmax(tau + alpha * hydrostatic))
    return (float(tau[step] + alpha * hydrostatic[step]), step, float(tau[step]),
            float(hydrostatic[step]))


# Those of Dang Van, the last four, where alpha is given.
NAMES = ("swt", "swt_plane", "swt_stress", "swt_strain", "dang_van", "dang_van_t", "dang_van_shear",
         "dang_van_hydrostatic")


def cycle_of(run: Run, first: Optional[float], last: Optional[float]) -> tuple[np.ndarray, np.ndarray]:
    """Numbers and times of the steps of the last level from first to last."""
    steps = run.steps
    here = steps["level"] == steps["level"].max()
    number_of, t = steps["step"][here].astype(int), steps["t"][here]
    near = 1e-9 * abs(t).max()
    chosen = (t >= (t[0] if first is None else first) - near) & (
        t <= (t[-1] if last is None else last) + near)
    if chosen.sum() < 2:
        raise InputError("a cycle has two steps at least; from %s to %s there are %d; allowed: t from "
                         "%g to %g" % (first, last, chosen.sum(), t[0], t[-1]))
    return number_of[chosen], t[chosen]


def _constants(run: Run, body: str) -> tuple[float, float]:
    """Young's modulus and Poisson's ratio."""
    material = run.numbers["Bodies"][body]["Material"]
    return material["Young's Modulus"], material["Poisson's Ratio"]


def sides_of(run: Run, name: str) -> list[tuple[str, str]]:
    """Body and boundary of the sides of a contact, those of rigid bodies left out."""
    bodies = {body: keys for body, keys in run.scene["Bodies"].items()
              if not keys.get("Material", {}).get("Rigid")}
    pair = run.scene.get("Contacts", {}).get(name)
    if pair is not None:
        sides = [tuple(side.split(":", 1)) for side in pair["Between"]]
    else:
        sides = [(body, name) for body, keys in bodies.items() if keys.get(
            "Boundary Conditions", {}).get(name, {}).get("Type") == "Contact"]
    if not sides:
        raise InputError("there is no contact %r; contacts: %s" % (
            name, ", ".join(sorted(set(run.contact["contact_name"])))))
    return [(body, boundary) for body, boundary in sides if body in bodies]


def turned(stress: np.ndarray, cosine: np.ndarray, sine: np.ndarray) -> np.ndarray:
    """Stresses (..., 4) in axes that are turned left."""
    sxx, syy, sxy, szz = np.moveaxis(stress, -1, 0)
    return np.stack([cosine ** 2 * sxx + sine ** 2 * syy + 2 * sine * cosine * sxy,
                     sine ** 2 * sxx + cosine ** 2 * syy - 2 * sine * cosine * sxy,
                     sine * cosine * (syy - sxx) + (cosine ** 2 - sine ** 2) * sxy, szz], -1)


def doubt(values: np.ndarray, element: np.ndarray) -> np.ndarray:
    """By how much values along a boundary may be wrong: on an element the sizes of the two highest
    coefficients of the Legendre series of its degree through them, as pressure_error has it of the
    pressure; the largest of it and its neighbours."""
    own: dict[int, float] = {}
    for number in np.unique(element):
        there = values[element == number]
        places = -1 + (2 * np.arange(len(there)) + 1) / len(there)  # as epafi fields takes them
        degree = len(there) // 2 - 1
        highest = np.polynomial.legendre.legfit(places, there, degree)[max(1, degree - 1):]
        own[int(number)] = float(np.abs(highest).sum())
    return np.array([max(own.get(int(number) + k, 0.0) for k in (-1, 0, 1)) for number in element])


def parameters(run: Run, table: Table, chosen: np.ndarray, t: np.ndarray, alpha: Optional[float],
               from_normal: bool) -> dict[str, np.ndarray]:
    """Of the points of a table of all steps; plane angles from the x axis or from the normal."""
    steps = int(table["step"].max())
    stress = np.column_stack([table[column] for column in (
        "sxx", "syy", "sxy", "hoop" if "hoop" in table else "szz")]).reshape(steps, -1, 4)
    first = {name: column[:table.size // steps] for name, column in table.columns.items()}
    if from_normal:
        stress = turned(stress, first["n_x"], first["n_y"])
    stress = np.moveaxis(stress[chosen - 1], 0, 1)
    found = np.full((len(stress), 4 if alpha is None else len(NAMES)), math.nan)
    within = np.isfinite(stress).all(axis=(1, 2))
    for body in sorted(set(first["body"][within])):
        here = np.flatnonzero(within & (first["body"] == body))
        for part in np.array_split(here, -(-len(here) // POINTS)):
            found[part, :4] = swt(stress[part], *_constants(run, str(body)))
    if alpha is not None:
        for point in np.flatnonzero(within):
            value, step, tau, hydrostatic = dang_van(stress[point], alpha)
            found[point, 4:] = value, t[step], tau, hydrostatic
    return first | dict(zip(NAMES, found.T))


def fatigue(run: Run, where: str | Sequence[Sequence[float]] | np.ndarray, *,
            body: Optional[str] = None, alpha: Optional[float] = None, first: Optional[float] = None,
            last: Optional[float] = None, depth: Optional[float] = None) -> Table:
    """As Run.fatigue."""
    name = where if isinstance(where, str) else ""
    boundary, contact = ":" in name, bool(name) and ":" not in name
    if depth is not None and not boundary:
        raise InputError("depth: belongs to a boundary, 'body:boundary'")
    if body is not None and not contact:
        raise InputError("body: belongs to a contact, which has two")
    if alpha is not None and (not isinstance(alpha, (int, float, np.number))
                              or not math.isfinite(alpha)):
        raise InputError("alpha: %r is no finite number" % (alpha,))
    steps, t = cycle_of(run, first, last)
    if contact:
        sides = sides_of(run, name)
        bodies = list(dict.fromkeys(each for each, _ in sides))
        if body is not None and body not in bodies:
            raise InputError("body: %r is none of %r that deforms; those are: %s" % (
                body, name, ", ".join(bodies)))
        places = ["%s:%s" % (each, side) for each, side in sides if body in (None, each)]
    else:
        places = [name] if boundary else []
    tables = [run.fields(along=place, depth=depth or 0, step="all") for place in places] or [
        run.fields(np.asarray(where, float), step="all")]
    found = []
    for k, table in enumerate(tables):
        columns = parameters(run, table, steps, t, alpha, contact)
        if contact:  # as contact.csv names it
            side = places[k] if len(run.scene["Bodies"]) > 1 else places[k].split(":", 1)[1]
            columns["boundary"] = np.full(len(columns["x"]), side)
        if places and not depth:
            for value in ("swt", "dang_van") if alpha is not None else ("swt",):
                columns[value + "_error"] = doubt(columns[value], columns["element"])
        found.append(columns)
    names = [column for column in ("x", "y", "body", "s", "boundary", *NAMES, "swt_error", "dang_van_error")
             if column in found[0]]
    return Table.of({column: np.concatenate([columns[column] for columns in found]) for column in names})
