"""Heat that is conducted inside bodies against closed forms (doc/theory/body-loads.md)."""
import cmath
import math

from runs import (acting, claim, epafi, finish, fresh, largest, points, refused, rows, run, saved,
                  scene)
from written import (CLAMPED, NONE, block, body, condition, contact, disc, friction, geometry, history,
                     keys, listed, loop, points_at, primed, rigid, round_hole, with_more, written)


def heated(whole, expansion=None, conductivity=None, plane=None, loads=NONE, **boundaries):
    """A body with Thermal Conditions; of a boundary a temperature or its keys."""
    more = {"Thermal Expansion": expansion, "Conductivity": conductivity, "Plane State": plane}
    heat = listed("Thermal Conditions", **{
        boundary: what if isinstance(what, dict) else {"Temperature": what}
        for boundary, what in boundaries.items()}) if boundaries else NONE
    return with_more(whole, heat, loads, **{
        key: value for key, value in more.items() if value is not None})


def flux(value):
    return {"Heat Flux": value}


def inside(name):
    return rows(name, "interior.csv")


def balanced(name, size=1):
    """Claims so of the forces and moments on each body."""
    off = max(largest(map(sum, parts)) for parts in acting(name)) / size
    claim(off < 1e-12, "%s: every body balances, %.1e" % (name, off))


def polar(p, angle):
    """Radial and hoop stress and shear at a point in that direction."""
    mean = (p["sxx"] + p["syy"]) / 2
    rest = (p["sxx"] - p["syy"] + 2j * p["sxy"]) / 2 * cmath.exp(-2j * angle)
    return mean + rest.real, mean - rest.real, rest.imag


def ring(name, inner, outer, modulus, at, ratio):
    return body(name, disc(outer, "outside", *at, round_hole(inner, "bore", *at)), modulus, NONE,
                "X, Y, Rotation", listed("Mesh", Elements_per_Edge=[2] * 4,
                                         Hole_1_Elements_per_Edge=[2] * 4), ratio)


def tube(name, a, b, modulus, ratio, alpha, plane, hot, degree, at=(0.0, 0.0), flow=None):
    """Hotter inside by `hot`: radial and hoop stress against the closed form, over the largest."""
    conductivity = 3.5
    radii = (a * (1 + 1e-6), a + 0.2 * (b - a), a + 0.6 * (b - a), b * (1 - 1e-6))
    points = [(at[0] + r * math.cos(k + 0.3), at[1] + r * math.sin(k + 0.3))
              for k, r in enumerate(radii)]
    into = hot / a / math.log(b / a) * conductivity
    text = heated(ring("tube", a, b, modulus, at, ratio=ratio), alpha, conductivity, plane,
                  bore=flux(into) if flow else hot, outside=0)
    level = run(written(name, [text], NONE, "Density", 1, degree, points_at(points)), name)[0][-1]
    e, _, al = primed(ratio, alpha, plane)
    log = math.log(b / a)
    scale = modulus * e * al * hot / (2 * log)
    share = a ** 2 / (b ** 2 - a ** 2) * log

    def stresses(r):
        rho = math.log(b / r)
        return (scale * (-rho - share * (1 - (b / r) ** 2)),
                scale * (1 - rho - share * (1 + (b / r) ** 2)))

    def energy(r):
        radial, hoop = stresses(r)
        nu = ratio / (1 + ratio) if plane == "Plane Stress" else ratio
        return 2 * math.pi * r * (radial ** 2 + hoop ** 2 - nu * (radial + hoop) ** 2) * (
            1 + ratio) / (2 * modulus)

    count = 2000
    exact = (b - a) / (3 * count) * sum(
        (1 if k in (0, count) else 4 if k % 2 else 2) * energy(a + (b - a) * k / count)
        for k in range(count + 1))
    error = abs(level["energy_strain"] / exact - 1)
    claim(error < 1e-9, "%s: strain energy, %.1e" % (name, error))
    worst = 0
    for k, (r, p) in enumerate(zip(radii, inside(name))):
        along, around, shear = polar(p, k + 0.3)
        radial, hoop = stresses(r)
        warm = hot * math.log(b / r) / log
        across = 0 if plane == "Plane Stress" else ratio * (radial + hoop) - modulus * alpha * warm
        worst = max(worst, abs(along - radial) / abs(scale), abs(around - hoop) / abs(scale),
                    abs(shear) / abs(scale),
                    abs(p["szz"] - across) / abs(scale), abs(p["temperature"] - warm) / abs(hot))
    # a uniform pressure moves the boundary by 1 - 2 nu only, and what rounds in V and u comes back
    # over that: 0.3 to 3.0 times 1.1e-16/(1 - 2 nu), by the kernels of BLAS
    claim(worst < max(1e-10, 4e-16 / (1 - 2 * ratio)),
          "%s: stress and temperature, %.1e" % (name, worst))
    balanced(name, abs(scale) * b)
    return scale * (1 - log - share * (1 + (b / a) ** 2))


hoop = tube("tube", 10, 20, 210e3, 0.3, 1.2e-5, "Plane Strain", 100, 8)
claim(abs(hoop / -220.314893 - 1) < 1e-8, "the closed form is the known one")
tube("tube of degree 10", 10, 20, 210e3, 0.3, 1.2e-5, "Plane Strain", 100, 10)
tube("tube in plane stress", 10, 20, 70e3, 0.33, 2.3e-5, "Plane Stress", -40, 9)
tube("thin tube", 0.9, 1.1, 5.0, 0.2, 0.01, "Plane Strain", 3, 8)
tube("thick tube elsewhere", 1, 4, 5.0, 0.45, 0.01, "Plane Strain", 3, 10, (30.0, -70.0))
tube("tube that hardly yields", 10, 20, 2.0, 0.499999, 1e-3, "Plane Strain", 10, 9)
tube("tube with a heat flux", 10, 20, 210e3, 0.3, 1.2e-5, "Plane Strain", 100, 8, flow=True)

# an insulated hole in a flow of heat that is uniform far away: T = g (r + a^2/r) cos th
A, B, E, ALPHA, G = 1.0, 3.0, 5.0, 0.01, 2.0
for plane, ratio, degree in (("Plane Strain", 0.3, 10), ("Plane Stress", 0.3, 10),
                             ("Plane Strain", 0.499999, 10)):
    name = "insulated hole, %s %g" % (plane, ratio)
    where = (4.0, -1.0)
    radii = (A * 1.0001, 1.7, 2.9)
    spots = [(where[0] + r * math.cos(k - 1), where[1] + r * math.sin(k - 1))
             for k, r in enumerate(radii)]
    plate = heated(ring("plate", A, B, E, where, ratio=ratio), ALPHA, None, plane,
                   outside="%r*(x - %r)" % (G * (1 + (A / B) ** 2), where[0]))
    levels = run(written(name, [plate], NONE, "Density", 1, degree, points_at(spots)), name)[0]
    e, _, al = primed(ratio, ALPHA, plane)
    size = E * e * al * G * A ** 2 / 2
    worst = 0
    for k, (r, p) in enumerate(zip(radii, inside(name))):
        along, around, shear = polar(p, k - 1)
        cubic, inverse = r / (A ** 2 + B ** 2), (A * B) ** 2 / (A ** 2 + B ** 2) / r ** 3
        cosine, sine = math.cos(k - 1), math.sin(k - 1)
        worst = max(worst,
                    abs(along - size * (-1 / r + cubic + inverse) * cosine) / size,
                    abs(around - size * (-1 / r + 3 * cubic - inverse) * cosine) / size,
                    abs(shear - size * (-1 / r + cubic + inverse) * sine) / size,
                    abs(p["temperature"] - G * (r + A ** 2 / r) * cosine))
    claim(worst < 1e-10, "%s: %.1e" % (name, worst))
    balanced(name)

# linear and harmonic temperatures held on all of an L with a hole are those of Body Loads
CORNERS = [(0, 0), (4, 0), (4, 2), (2, 2), (2, 4), (0, 4)]
SIDES = "bottom, right, step, inner, top, left"
L_SHAPE = geometry(CORNERS, SIDES, holes=loop(block(0.5, 0.5, 1.5, 1.2), "h, h, h, h", (), "Hole 1 "))
HELD = condition("bottom", "Contact", Gap="0.01*x") + condition("left", "Dirichlet",
                                                                 Displacement_X="0")
for what in ("3 + 2*x - y", "x^2 - y^2 + 0.3*x*y"):
    for plane, ratio in (("Plane Strain", 0.3), ("Plane Stress", 0.4), ("Plane Strain", 0.5)):
        found = []
        for kind in ("polynomial", "conducted"):
            name = "L %s %s %s %g" % (kind, what.replace("*", ""), plane, ratio)
            plain = body("L", L_SHAPE, E, HELD, ratio=ratio)
            bounds = {b: what for b in ("bottom", "right", "step", "inner", "top", "left", "h")}
            more = keys(Force_Y=-0.1) + (keys(Temperature=what) if kind == "polynomial" else NONE)
            text = heated(plain, ALPHA, 2.0, plane, listed("Body Loads", more),
                          **(bounds if kind == "conducted" else {}))
            levels, sides = run(written(name, [text], NONE, "Density", 1, 4, points_at(
                [(0.3, 0.3), (1.9, 1.4), (3.9, 0.1), (0.4, 3.0)])), name)
            found.append((levels[-1], sides, inside(name)))
            balanced(name)
        one, other = found
        size = largest(p["lambda_n"] for p in one[1])
        worst = max(largest(p[c] - q[c] for p, q in zip(one[1], other[1])) for c in (
            "lambda_n", "lambda_t")) / size
        worst = max(worst, largest(p[c] - q[c] for p, q in zip(one[2], other[2]) for c in (
            "sxx", "syy", "sxy", "szz")) / size)
        worst = max(worst, largest(p[c] - q[c] for p, q in zip(one[2], other[2]) for c in (
            "ux", "uy", "temperature")) / largest(p["temperature"] for p in one[2]))
        claim(worst < 1e-10, "%s: as the polynomial, %.1e" % (name, worst))
        worst = max(abs(one[0][c] / other[0][c] - 1) for c in ("energy_strain", "energy_load"))
        claim(worst < 1e-9, "%s: energies, %.1e" % (name, worst))

# heat goes in at one end of a bar and out at the other: T is linear, q/k its slope
for into, out in ((flux(6), 1), (7, flux(-6))):
    name = "bar, %s" % ("in" if out == 1 else "out")
    bar = heated(body("bar", block(0, 0, 2, 1), E, condition(
        "left", "Dirichlet", Displacement_X="0") + condition("right", "Dirichlet",
                                                             Displacement_X="0"), "Y"),
                 ALPHA, 2.0, left=into, right=out)
    run(written(name, [bar], NONE, "Density", 1, 3, points_at([(0.5, 0.5)])), name)
    p = inside(name)[0]
    claim(abs(p["temperature"] - 5.5) < 1e-11, "%s: %r" % (name, p["temperature"]))
    balanced(name)

# a temperature beside insulation goes with r^1/2: the estimate bounds the true error at each level
PLATE = heated(body("plate", geometry(
    [(0, 0), (1, 0), (2, 0), (2, 1), (0, 1)], "cold, floor, right, top, left"), E, keys(*(
        condition(side, "Dirichlet", CLAMPED) for side in ("cold", "floor", "right", "left")))),
               ALPHA, None, cold=0, top=1)
file = written("beside insulation", [PLATE], NONE, "Density", 0.5, 2)
file = saved("study beside insulation", keys(
    listed("Scenes", plate={"File": file, "Reference": {"Set": [
        "Adaptivity->Strategy=Graded hp", "Adaptivity->Maximum Levels=24",
        "Adaptivity->Maximum Degrees of Freedom=1500"]}}),
    listed("Variants", *(listed(strategy, Set=[
        "Adaptivity->Strategy=" + strategy, "Adaptivity->Maximum Levels=%d" % count])
        for strategy, count in (("Uniform h", 4), ("Graded hp", 14))))))
folder = fresh("beside insulation study")
code, text = epafi("study", file, "--output", folder, "--no-plot")
claim(code == 0, "a study of it: exit %d" % code)
errors = {}
for row in rows(folder, "study.csv"):
    if row["variant"] != "reference":
        errors.setdefault(row["variant"], []).append(row)
for strategy, levels in errors.items():
    counted = [row for row in levels if row["counted"] == 1]
    bounds = [row["effectivity"] for row in counted]
    claim(len(counted) >= 3 and 1 < min(bounds) and max(bounds) < 8,
          "%s: effectivity %.2f to %.2f on %d levels" % (
              strategy, min(bounds), max(bounds), len(counted)))
one, other = errors["Uniform h"][-1], errors["Graded hp"]
claim(min(row["error"] for row in other if row["dof"] < one["dof"]) < one["error"] / 10,
      "graded meshes are better than uniform ones: %g" % one["error"])

# a path: without friction heat that has gone leaves nothing
for law in ("smooth", "rough"):
    text = heated(body("block", block(-1, 0, 1, 1), E,
                       condition("bottom", "Contact", friction(0.4) if law == "rough" else NONE,
                                 Gap="0.004*x^2"), "X, Rotation"), ALPHA, 1.0,
                  loads=listed("Body Loads", Force_Y="-0.4*min(t, 1)"),
                  bottom="(t < 1 ? 0 : 1 - abs(t - 2))*(1 + x)",
                  top=flux("(t < 1 ? 0 : 1 - abs(t - 2))*cos(x)"))
    name = "there and back " + law
    run(written(name, [text], NONE, "Density", 0.5, 3,
                history([1, 2, 3], [4, 4, 4])), name)
    first, last = points(name, 4), points(name, 12)
    apart = largest(p["lambda_n"] - q["lambda_n"] for p, q in zip(first, last)) / largest(
        p["lambda_n"] for p in first)
    claim(apart < 1e-11 if law == "smooth" else apart > 1e-4, "%s: %.1e" % (name, apart))
    step = rows(name, "steps.csv")[-1]
    claim(abs(step["energy_error"]) < 0.05 * abs(step["energy_outside"]),
          "%s: energies balance, %.1e" % (name, step["energy_error"] / step["energy_outside"]))
    balanced(name)

# two bodies, each with heat of its own, in either order
LOWER = heated(body("lower", block(0, 0, 3, 1), E, condition("bottom", "Dirichlet", CLAMPED)),
               ALPHA, 1.0, top="1 + x", bottom=0)
UPPER = heated(body("upper", block(0.5, 1, 2.5, 2), 2 * E, condition(
    "top", "Neumann", Traction_Y="-0.3"), "X, Rotation"), 2 * ALPHA, 3.0, bottom=2, left=2,
               right=flux(-1))
found = []
for bodies in ((LOWER, UPPER), (UPPER, LOWER)):
    name = "two bodies, %d" % len(found)
    joint = contact("joint", "upper:bottom", "lower:top", friction("0.3"))
    sides = run(written(name, bodies, joint, "Density", 0.5, 4), name)[1]
    found.append(sorted((p["x"], p["lambda_n"], p["lambda_t"]) for p in sides))
    balanced(name)
apart = max(abs(a - b) for p, q in zip(*found) for a, b in zip(p, q))
claim(apart < 1e-10, "bodies in another order: %.1e" % apart)

# a hot slot: its source is shared out along it
slot = geometry(block(0, 0, 4, 2), ["outside"] * 4, holes=loop(
    block(0.5, 0.9, 3, 1), ["slot"] * 4, (), "Hole 1 "))
level = run(written("slot", [heated(body("plate", slot, E, NONE, "X, Y, Rotation"), ALPHA,
                                    outside=0, slot=1)], NONE, "Density", 0.5, 2,
                    listed("Adaptivity", Strategy="Graded hp", Maximum_Levels=14)), "slot")[0][-1]
claim(level["estimate"] < 4e-4 and abs(level["energy_strain"] / 1.9536e-4 - 1) < 3e-3,
      "a hot slot: estimate %.1e" % level["estimate"])
balanced("slot")

# more elements than a dense system would take: a linear temperature is free of stress
run(written("fine", [heated(body("plate", block(0, 0, 1, 1), E, NONE, "X, Y, Rotation"), 1e-5,
                            top=1, bottom=0)], NONE, "Density", 0.0008, 1,
            points_at([(0.5, 0.25), (0.3, 0.999)])), "fine")
off = max(abs(p["temperature"] - y) for p, y in zip(inside("fine"), (0.25, 0.999)))
stress = largest(p[key] / E / 1e-5 for p in inside("fine") for key in ("sxx", "syy", "sxy"))
claim(off < 1e-9, "5000 elements: temperature inside off by %.1e" % off)
claim(stress < 1e-7, "5000 elements: stress inside %.1e of that of a clamped body" % stress)

# the shipped scenes
run(scene("hot-tube.xml"), "hot-tube")
hoops = [p["syy"] for p in inside("hot-tube")]
claim(abs(hoops[0] + 220.314152) < 1e-6 and abs(hoops[2] - 139.684917) < 1e-6,
      "hot tube: %.6f, %.6f just below the surfaces" % (hoops[0], hoops[2]))
level, sides = run(scene("shrink-fit.xml"), "shrink-fit")
claim(abs(level[-1]["force_normal"] / (49.21875 * 40 * math.pi) - 1) < 1e-6,
      "shrink fit: the mean pressure of a press fit, %.4f" % level[-1]["force_normal"])
claim(largest(p["lambda_t"] for p in sides) > 0.5, "friction keeps a shear")
claim(any(row["fit.force_normal"] == 0 for row in rows("shrink-fit", "steps.csv") if row["t"] == 1),
      "hot, the ring is loose")
run(scene("blade-root.xml"), "blade-root", ["Adaptivity->Maximum Levels=1"])
ROOT = [(-4.571150438746157, 0), (4.571150438746157, 0), (5.571150438746157, 1),
        (5.571150438746157, 2.935822227524088), (3, 6), (3, 12)]
ROOT += [(-x, y) for x, y in ROOT[:1:-1]]
pull = 7.85e-9 * 1500 ** 2 * sum(  # of the root itself: rho w^2 times the area's moment
    (a[0] * b[1] - b[0] * a[1]) * (200 / 2 + (a[1] + b[1]) / 6)
    for a, b in zip(ROOT, ROOT[1:] + ROOT[:1])) + 1500
for row in rows("blade-root", "steps.csv"):
    share = {0.25: 0.0625, 0.5: 0.25, 1.0: 1, 1.5: 0.25}.get(row["t"])
    if share is not None:
        angle, slides = math.radians(50), 1 if row["t"] <= 1 else -1
        exact = share * pull / 2 / (math.cos(angle) + slides * 0.2 * math.sin(angle))
        error = largest(row[side + ".force_normal"] / exact - 1 for side in ("left", "right"))
        claim(error < 1e-9, "blade root at t = %g: flanks carry what pulls, %.1e" % (
            row["t"], error))

# what is refused
BARE = body("block", block(0, 0, 1, 1), E, condition("bottom", "Contact"), "X, Rotation")
TEMPERATURE = listed("Body Loads", Temperature=1)
for text, what in (
        (heated(BARE, 1e-5, top=flux(1)), "no boundary has a Temperature"),
        (heated(BARE, 1e-5, top=1, loads=TEMPERATURE), "give one of them"),
        (heated(BARE, 1e-5, top={"Temperature": 1, "Heat Flux": 1}), "has both of"),
        (heated(BARE, 1e-5, top={}), "has none of Temperature and Heat Flux"),
        (heated(BARE, 1e-5, tip=1), "did you mean 'top'"),
        (heated(BARE, 1e-5, top={"Temperatur": 1}), "did you mean"),
        (heated(BARE, 1e-5, 0.0, top=1), "Conductivity"),
        (heated(BARE, 1e-5, left=1, top=2), "a temperature does not jump"),
        (heated(BARE, top=1), "Thermal Expansion: missing; Bodies->block->Thermal Conditions "
         "needs it")):
    refused(what, written("refused", [text], NONE, "Density"), what, command="check")
refused("conduction in a rigid body", written("refused", [BARE, heated(
    rigid("floor", block(-1, -2, 2, -1)), top=1)], contact("on", "block:right", "floor:top"),
    "Density"), "Thermal Conditions", "rigid", command="check")
finish()
