"""Closed lines of two or three edges, the fewest elements that close one: circles, rings, lenses and
halves of discs under uniform pressure against closed forms, with dense and compressed operators,
and pressed by a contact that goes all around.  Standard library only."""
import math

from runs import claim, finish, run
from written import (NONE, QUARTERS, body, circle, condition, contact, geometry, keys, listed,
                     loop, written)

NU, PRESSURE = 0.3, 0.01
METHODS = ("Dense", "Compressed")


def bulge(degrees):
    return math.tan(math.radians(degrees) / 4)


def arcs(angles, radius, start=0.3):
    """Corners and bulges of a circle of arcs."""
    corners = []
    for angle in angles:
        corners.append((radius * math.cos(start), radius * math.sin(start)))
        start += math.radians(angle)
    return corners, tuple(map(bulge, angles))


def outline(corners, bulges, hole=None):
    """Sides of the outer loop are `o`, those of a hole `i`."""
    return geometry(corners, ["o"] * len(corners), bulges,
                    loop(hole[0], ["i"] * len(hole[0]), hole[1], "Hole 1 ") if hole else NONE)


def elements(outer, inner=()):
    """One on each arc, two where it turns by more than half a circle."""
    def counts(angles):
        return [2 if angle > 180 else 1 for angle in angles]
    return (keys(Elements_per_Edge=counts(outer)) if outer else NONE) + (
        keys(Hole_1_Elements_per_Edge=counts(inner)) if inner else NONE)


def pressed(boundary, pressure):
    return condition(boundary, "Neumann", Traction_X="-(%.17g)*nx" % pressure,
                     Traction_Y="-(%.17g)*ny" % pressure)


def energy(name, shape, mesh, degree, method, inside=0):
    """Strain energy and estimate of the first mesh."""
    conditions = pressed("o", PRESSURE) + (pressed("i", inside) if inside else NONE)
    file = written(name, [body("b", shape, 1.0, conditions, "X, Y, Rotation",
                               listed("Mesh", mesh, Degree=degree), NU)],
                   more=listed("Adaptivity", Maximum_Levels=1))
    level = run(file, name, ["Solver->Linear->Method=" + method])[0][-1]
    return level["energy_strain"], level["estimate"]


def lame(inner, outer, inside):
    """Of a ring under pressures on both sides, plane strain, E = 1."""
    a = (inside * inner ** 2 - PRESSURE * outer ** 2) / (outer ** 2 - inner ** 2)
    b = (inside - PRESSURE) * (inner * outer) ** 2 / (outer ** 2 - inner ** 2)

    def u(r):
        return (1 + NU) * ((1 - 2 * NU) * a * r + b / r)
    return math.pi * (inner * inside * u(inner) - outer * PRESSURE * u(outer))


def compressed_uniformly(area):
    return PRESSURE ** 2 * (1 - 2 * NU) * (1 + NU) * area


# Degrees, and how far arcs of at most half a circle are resolved then.  The best polynomials on half
# a circle miss u = c x by 8e-5, 2.3e-12, 2e-21 of the energy; on a quarter by 2e-7, 2e-17, 8e-29.
DEGREES = ((4, 2e-4, 1e-3), (8, 1e-11, 1e-5), (12, 1e-13, 1e-9))

for method in METHODS:
    for angles in ([180, 180], [90] * 4, [120] * 3, [270, 90], [337, 23], [200, 160]):
        for degree, limit, estimated in DEGREES:
            value, estimate = energy("disc", outline(*arcs(angles, 1)), elements(angles), degree,
                                     method)
            error = abs(value / compressed_uniformly(math.pi) - 1)
            claim(error < limit and estimate < estimated,
                  "%s disc of arcs %s, degree %d: energy within %.1e, "
                  "estimate %.1e" % (method, angles, degree, error, estimate))
    for outer, inner in (([180, 180], [180, 180]), ([90] * 4, [180, 180]), ([270, 90], [120] * 3)):
        for degree, limit, estimated in DEGREES:
            value, estimate = energy("ring", outline(*arcs(outer, 1), arcs(inner, 0.5, 0.7)),
                                     elements(outer, inner), degree, method, 2 * PRESSURE)
            error = abs(value / lame(0.5, 1, 2 * PRESSURE) - 1)
            claim(error < limit and estimate < 10 * estimated,
                  "%s ring of arcs %s around %s, degree %d: energy "
                  "within %.1e, estimate %.1e" % (method, outer, inner, degree, error, estimate))
    # from (1, 0) above and back below, half a disc, lenses, a crescent: area of circles' segments
    for angles in ([180, 0], [40, 40], [90, 0], [180, -40]):
        area = sum(math.copysign((t - math.sin(t)) / 2 / math.sin(t / 2) ** 2, angle) for t, angle in
                   ((math.radians(abs(angle)), angle) for angle in angles) if t > 0)
        for degree, limit, estimated in DEGREES:
            value, estimate = energy("lens", outline([(1, 0), (-1, 0)], tuple(map(bulge, angles))),
                                     elements([1, 1]), degree, method)
            error = abs(value / compressed_uniformly(area) - 1)
            claim(error < limit and estimate < estimated,
                  "%s arcs %s on a chord, degree %d: energy within %.1e, "
                  "estimate %.1e" % (method, angles, degree, error, estimate))

# a square with a hole: of two arcs and of four, one outer mesh
for method in METHODS:
    energies = [energy("square", outline(*([(-2, -2), (2, -2), (2, 2), (-2, 2)], (0,) * 4),
                                         arcs(angles, 0.5, 0.7)),
                       keys(Elements_per_Edge=[4, 4, 4, 4]) + elements((), angles), 12, method,
                       2 * PRESSURE)[0] for angles in ([180, 180], [270, 90], [90] * 4)]
    for name, value in zip(("two halves", "270 and 90 degrees"), energies):
        error = abs(value / energies[-1] - 1)
        claim(error < 1e-11, "%s square with a hole of %s: energy of four quarters within %.1e" %
              (method, name, error))


def press_fit(angles, degree, sides, method, hole=None):
    """Of a disc in a ring whose hole has the same arcs, or others: last level, points."""
    inner, outer = arcs(angles, 1), arcs(hole or angles, 1)
    bodies = [body("disc", outline(*inner), 1.0, NONE, "X, Y, Rotation",
                   listed("Mesh", elements(angles), Degree=degree), NU),
              body("ring", geometry(circle(2), "o, o, o, o", QUARTERS,
                                    loop(outer[0], ["i"] * len(outer[0]), outer[1], "Hole 1 ")),
                   1.0, NONE, "X, Y, Rotation",
                   listed("Mesh", elements([90] * 4, hole or angles), Degree=degree), NU)]
    levels, points = run(written("fit", bodies, contact("fit", *sides, Interference=0.001),
                                 "Density", more=listed("Adaptivity", Maximum_Levels=1)), "fit",
                         ["Solver->Linear->Method=" + method])[:2]
    return levels[-1], points


# a disc of two arcs in a ring whose hole has two: a press fit, p/d of plane strain
SIDES = ("disc:o", "ring:i")
# both give way by p times this
give = (1 + NU) * (1 - 2 * NU) + (1 + NU) * ((1 - 2 * NU) * 1 + 4) / 3
for method in METHODS:
    pressures = []
    for angles in ([180, 180], [90] * 4):
        points = press_fit(angles, 12, SIDES, method)[1]
        pressures.append([point["lambda_n"] for point in points])
    error = max(abs(value * give / 0.001 - 1) for value in pressures[0])
    claim(error < 1e-9, "%s press fit of half circles: pressure within %.1e, of quarters %.1e" % (
        method, error, max(abs(value * give / 0.001 - 1) for value in pressures[1])))

# nine elements against eight: linear displacements of the two circles would press at their nodes
for sides in (SIDES, SIDES[::-1]):
    for angles in ([40] * 9, [45] * 8):
        level, _ = press_fit(angles, 1, sides, "Dense", [85 - angles[0]] * (17 - len(angles)))
        error = level["pressure_max"] * give / 0.001 - 1
        claim(abs(error) < 0.02, "%s, %d elements against %d, degree 1: largest pressure within %.1e" %
              (sides[0], len(angles), 17 - len(angles), error))
finish()
