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


def swt(stress: np.ndarray, young: float, poisson: float) -> tuple[float, float, float, float]:
    """Smith, Watson and Topper's parameter of one point, from (sxx, syy, sxy, szz) at each step:

        max over planes of <sigma_n,max> (eps_n,max - eps_n,min) / 2

    with normals in the plane; and the angle of that normal [degree], its largest stress and its
    strain amplitude.  Strains are elastic ones, without thermal expansion."""
    sxx, syy, sxy, szz = stress.T
    strain = np.array([sxx - poisson * (syy + szz), syy - poisson * (sxx + szz),
                       (1 + poisson) * sxy]) / young

    def on(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        c, s = np.cos(angles), np.sin(angles)
        shape = np.array([c * c, s * s, 2 * s * c])
        normal = np.array([sxx, syy, sxy]).T @ shape
        return np.maximum(normal.max(axis=0), 0), np.ptp(strain.T @ shape, axis=0) / 2

    width, angles = math.pi, np.linspace(0, math.pi, PLANES, endpoint=False)
    for _ in range(5):
        largest, amplitude = on(angles)
        best = int(np.argmax(largest * amplitude))
        width /= 20
        result = (float(largest[best] * amplitude[best]), round(math.degrees(angles[best]), 9) % 180,
                  float(largest[best]), float(amplitude[best]))
        angles = angles[best] + np.linspace(-width, width, 41)
    return result


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


def on_contact(run: Run, name: str, steps: Sequence[int]) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """The samples of a contact, and stresses of shape (steps, samples, 4), in axes along n and t."""
    stresses = []
    for step in steps:
        table = run.step(step)
        here = table["contact_name"] == name
        poisson, strain = np.array([_constants(run, body)[1:] for body in table["body"][here]]).T
        p, shear, along, multiplier = (table[column][here] for column in (
            "pressure", "shear", "stress_t", "lambda_n"))
        # stress_t is that of the strain along the surface under lambda_n
        along = along + (multiplier - p) * np.where(strain, poisson / (1 - poisson), poisson)
        stresses.append(np.column_stack([-p, along, -shear, strain * poisson * (along - p)]))
    places = {column: table[column][here] for column in ("x", "y", "s", "boundary", "body")}
    return places, np.array(stresses)


def _constants(run: Run, body: str) -> tuple[float, float, bool]:
    """Young's modulus, Poisson's ratio, whether in plane strain."""
    material = run.numbers["Bodies"][body]["Material"]
    return (material["Young's Modulus"], material["Poisson's Ratio"],
            material["Plane State"] == "Plane Strain")


def inside(run: Run, steps: Sequence[int], points: Optional[np.ndarray], along: Optional[str],
           depth: Optional[float]) -> tuple[dict[str, np.ndarray], np.ndarray]:
    """Points inside, or along a boundary, and stresses of shape (steps, points, 4), in x and y."""
    tables = [run.fields(points, along=along, depth=depth, step=int(step)) for step in steps]
    return ({column: tables[0][column] for column in ("x", "y", "body")},
            np.array([np.column_stack([table[column] for column in (
                "sxx", "syy", "sxy", "hoop" if "hoop" in table else "szz")]) for table in tables]))


def fatigue(run: Run, where: str | Sequence[Sequence[float]] | np.ndarray, *,
            alpha: Optional[float] = None, first: Optional[float] = None, last: Optional[float] = None,
            depth: Optional[float] = None) -> Table:
    """As Run.fatigue."""
    if depth is not None and not (isinstance(where, str) and ":" in where):
        raise InputError("depth: belongs to a boundary, 'body:boundary'")
    if alpha is not None and (not isinstance(alpha, (int, float, np.number))
                              or not math.isfinite(alpha)):
        raise InputError("alpha: %r is no finite number" % (alpha,))
    steps, t = cycle_of(run, first, last)
    scene = run.scene
    if isinstance(where, str) and ":" not in where:
        names = sorted(set(run.contact["contact_name"]))
        if where not in names:
            raise InputError("there is no contact %r; contacts: %s" % (where, ", ".join(names)))
        places, stresses = on_contact(run, where, steps)
        warm = [body for body, keys in scene["Bodies"].items() if body in places["body"] and (
            "Temperature" in (keys.get("Body Loads") or scene.get("Body Loads", {}))
            or keys.get("Thermal Conditions"))]
        if warm:
            raise InputError("%s: the stress across the plane of a warm body is not in contact.csv; "
                             "give points, or a boundary and a depth" % ", ".join(warm))
    elif isinstance(where, str):
        places, stresses = inside(run, steps, None, where, depth)
    else:
        places, stresses = inside(run, steps, np.asarray(where, float), None, None)
    rows = []
    for body, stress in zip(places["body"], stresses.swapaxes(0, 1)):
        if not np.isfinite(stress).all():  # outside
            rows.append([math.nan] * (4 if alpha is None else len(NAMES)))
            continue
        young, poisson, _ = _constants(run, str(body))
        row = list(swt(stress, young, poisson))
        if alpha is not None:
            value, step, tau, hydrostatic = dang_van(stress, alpha)
            row += [value, t[step], tau, hydrostatic]
        rows.append(row)
    return Table.of({**places, **dict(zip(NAMES, np.array(rows).T))})
