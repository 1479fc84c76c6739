"""Heat that is conducted in solids of revolution against closed forms (doc/theory/body-loads.md)."""
import math
import os

from epafi import Run
from revolved import QUARTER, body, clamp, last, scene
from runs import WORK, balanced, claim, epafi, finish, fresh, largest, rows, saved

E, NU, ALPHA, CONDUCTIVITY = 5.0, 0.3, 0.01, 3.5
FIXED = {"Rigid Motions": {"Fix": ["Y"]}}
SCALE = 0.1  # of forces, where none acts along the axis


def steel(ratio=NU, **more):
    return {"Young's Modulus": E, "Poisson's Ratio": ratio, "Density": 0.2, "Thermal Expansion": ALPHA,
            "Conductivity": CONDUCTIVITY, **more}


def held(value):
    return {"Temperature": value}


def flux(value):
    return {"Heat Flux": value}


def heat(**boundaries):
    return {"Thermal Conditions": boundaries}


def fields(name, places):
    return Run(os.path.join(WORK, name)).fields(places)


def within(name, found, exact, limit, scale):
    error = largest(map(lambda x, y: x - y, found, exact)) / scale
    claim(error < limit, "%s within %.1e" % (name, error))


def energy(stress, inner, outer, weight, ratio):
    """Half of stress times its strain, by Gauss' rule in pieces; weight: area over the radius."""
    points = [(-0.7745966692414834, 5 / 9), (0, 8 / 9), (0.7745966692414834, 5 / 9)]
    count, total = 400, 0
    half = (outer - inner) / count / 2
    for k in range(count):
        for t, share in points:
            r = inner + half * (2 * k + 1 + t)
            s = stress(r)
            total += half * share * weight(r) * ((1 + ratio) * sum(x * x for x in s) - ratio * sum(s) ** 2)
    return total / 2 / E


# tubes from 1 to 2, hotter inside, between rollers: the plane's closed form with the stress along the axis
def tube(hot, ratio):
    log = math.log(2)
    c = E * ALPHA * hot / (2 * (1 - ratio) * log)
    share = log / 3

    def stress(r):
        rho = math.log(2 / r)
        along = c * (-rho - share * (1 - (2 / r) ** 2))
        around = c * (1 - rho - share * (1 + (2 / r) ** 2))
        return along, around, ratio * (along + around) - E * ALPHA * hot * rho / log
    return stress


HOT = 3.0
for ratio, length, flows in ((NU, 1, False), (0.5, 1, True), (NU, 10, False)):
    name = "tube %g %g" % (ratio, length)
    inside = flux(CONDUCTIVITY * HOT / math.log(2)) if flows else held(HOT)
    row, _ = last(name, scene({"tube": body(
        [[1, 0], [2, 0], [2, length], [1, length]], ["low", "out", "high", "in"],
        {"low": clamp(Y=0), "high": clamp(Y=0)}, steel(ratio), **heat(**{"in": inside, "out": held(0)}))},
        size=0.5, degree=14))
    closed = tube(HOT, ratio)
    places = [(1 + share, y * length) for share in (0.01, 0.3, 0.9) for y in (0.2, 0.7)]
    found = fields(name, places)
    for k, key in enumerate(("sxx", "hoop", "syy")):
        within("%s: %s" % (name, key), found[key], [closed(x)[k] for x, _ in places], 1e-10, E * ALPHA * HOT)
    within(name + ": temperature", found["temperature"],
           [HOT * (1 - math.log(x) / math.log(2)) for x, _ in places], 1e-10, HOT)
    table = rows(name, "boundary.csv")
    within(name + ": hoop stress on the boundary", [p["hoop"] for p in table],
           [closed(p["x"])[1] for p in table], 1e-9 if ratio < 0.5 else 4e-9, E * ALPHA * HOT)
    exact = energy(closed, 1, 2, lambda r: 2 * math.pi * length * r, ratio)
    claim(abs(row["energy_strain"] / exact - 1) < 1e-10, "%s: strain energy %.13g, exact %.13g" % (
        name, row["energy_strain"], exact))
    balanced(name, SCALE, 1e-10)


# a hollow sphere: T = HOT (2/R - 1)
def hollow(ratio):
    c = 2 * ALPHA * E * HOT / (1 - ratio) / 7

    def stress(r):
        around = c * (3 - 7 / (2 * r) - 4 / (2 * r ** 3))
        return c * (3 - 7 / r + 4 / r ** 3), around, around
    return stress


def shell(**more):
    return body([[0, -2], [2, 0], [0, 2], [0, 1], [1, 0], [0, -1]], ["out", "out", "any", "in", "in", "any"],
                bulges=[QUARTER, QUARTER, 0, -QUARTER, -QUARTER, 0], **more)


for ratio, flows in ((NU, False), (0.49, True)):
    name = "hollow sphere %g" % ratio
    inside = flux(2 * CONDUCTIVITY * HOT) if flows else held(HOT)
    row, _ = last(name, scene({"ball": shell(material=steel(ratio), **FIXED, **heat(
        **{"in": inside, "out": held(0)}))}, degree=14))
    closed = hollow(ratio)

    def at(x, y):
        radius = math.hypot(x, y)
        s, t, _ = closed(radius)
        n = x / radius, y / radius
        return t + (s - t) * n[0] ** 2, t, t + (s - t) * n[1] ** 2, (s - t) * n[0] * n[1]
    places = [(r * math.sin(a), r * math.cos(a)) for r in (1.05, 1.5, 1.95) for a in (0, 0.2, 1.5, 2.5)]
    found = fields(name, places)
    for k, key in enumerate(("sxx", "hoop", "syy", "sxy")):
        within("%s: %s" % (name, key), found[key], [at(*p)[k] for p in places], 1e-10, E * ALPHA * HOT)
    table = rows(name, "boundary.csv")
    within(name + ": hoop stress on the boundary", [p["hoop"] for p in table],
           [at(p["x"], p["y"])[1] for p in table], 1e-9, E * ALPHA * HOT)
    exact = energy(closed, 1, 2, lambda r: 4 * math.pi * r * r, ratio)
    claim(abs(row["energy_strain"] / exact - 1) < 1e-10, "%s: strain energy %.13g, exact %.13g" % (
        name, row["energy_strain"], exact))
    balanced(name, SCALE, 1e-10)

# harmonic polynomials on all of the boundary, as body loads: a cylinder, a ring around a hole, and a
# cylinder with a hole in its axis and one off it
ROUND = [1, 1]
SHAPES = {
    "cylinder": dict(vertices=[[0, 0], [1, 0], [1, 2], [0, 2]], edges=["a", "a", "a", "any"]),
    "ring with a hole": dict(vertices=[[1, 0], [3, 0], [3, 2], [1, 2]], edges=["a"] * 4,
                             hole=[[2.4, 1], [1.6, 1]]),
    "cylinder with two holes": dict(
        vertices=[[0, 0], [3, 0], [3, 3], [0, 3], [0, 2], [0.5, 1.5], [0, 1]],
        edges=["a", "a", "a", "any", "a", "a", "any"], bulges=[0, 0, 0, 0, -QUARTER, -QUARTER, 0],
        hole=[[2.4, 1], [1.6, 1]])}


def drawn(shape, **more):
    whole = body(shape["vertices"], shape["edges"], **more)
    if "bulges" in shape:
        whole["Geometry"]["Bulges"] = shape["bulges"]
    if "hole" in shape:
        whole["Geometry"].update({"Hole 1 Vertices": shape["hole"], "Hole 1 Edges": ["a", "a"],
                                  "Hole 1 Bulges": ROUND})
    return whole


for what, shape in SHAPES.items():
    for text in ("1 + 2*z", "z^2 - r^2/2", "z^3 - 1.5*z*r^2"):
        values = []
        for name, loads in (("by loads", {"Body Loads": {"Temperature": text}}),
                            ("conducted", heat(a=held(text)))):
            row, _ = last("%s %s" % (what, name), scene({"body": drawn(
                shape, material=steel(), **FIXED, **loads)}, size=1, degree=9))
            points = [(x, y) for x in (0.7, 1.3, 2.7) for y in (0.4, 1.7)] if "hole" in shape else [
                (x, y) for x in (0.0, 0.3, 0.9) for y in (0.4, 1.7)]
            points = [p for p in points if what != "ring with a hole" or p[0] > 1]
            found = fields("%s %s" % (what, name), points)
            values.append([row["energy_strain"]] + [value for key in (
                "ux", "sxx", "syy", "sxy", "hoop", "temperature") for value in found[key]])
        size = largest(values[0])
        within("%s, T = %s: as by body loads" % (what, text), values[1], values[0], 1e-9, size)

# heat that flows past holes and out of them: no traction on the holes, in equilibrium inside
STEP = 1e-3
for what in ("ring with a hole", "cylinder with two holes"):
    shape = dict(SHAPES[what])
    shape["edges"] = ["low", "side", "high"] + (["side"] if len(shape["edges"]) == 4 else [
        "any", "own", "own", "any"])
    for kind, conditions in (("insulated", {}), ("heated", {"a": flux(1 + 0.2)}),
                             ("heated at the axis", {"own": flux(1)})):
        if "own" in conditions and "own" not in shape["edges"]:
            continue
        name = "%s %s" % (what, kind)
        last(name, scene({"body": drawn(shape, material=steel(), **FIXED, **heat(
            low=held(0), high=held(1), **conditions))}, size=0.7, degree=12))
        turns = [0.3 + 0.9 * k for k in range(7)]
        near = [(2 + (0.4 + 1e-6) * math.cos(a), 1 + (0.4 + 1e-6) * math.sin(a)) for a in turns]
        found = fields(name, near)
        normal = [found["sxx"][k] * math.cos(a) + found["sxy"][k] * math.sin(a) for k, a in enumerate(turns)]
        shear = [found["sxy"][k] * math.cos(a) + found["syy"][k] * math.sin(a) for k, a in enumerate(turns)]
        size = largest(found["hoop"])
        claim(largest(normal + shear) < 1e-5 * size, "%s: traction on the hole %.1e of the hoop stress" % (
            name, largest(normal + shear) / size))
        x, y = 2.6, 1.5
        places = [(x + STEP * i, y + STEP * j) for i, j in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))]
        found = fields(name, places)

        def slopes(key):  # along x, along y
            return [(found[key][k] - found[key][k + 1]) / 2 / STEP for k in (1, 3)]
        ux, uy, sxx, syy, sxy = map(slopes, ("ux", "uy", "sxx", "syy", "sxy"))
        s = {key: found[key][0] for key in ("sxx", "syy", "hoop", "sxy")}
        trace, hot = s["sxx"] + s["syy"] + s["hoop"], ALPHA * found["temperature"][0]
        error = largest([strain - ((1 + NU) * s[key] - NU * trace) / E - hot for strain, key in (
            (ux[0], "sxx"), (uy[1], "syy"), (found["ux"][0] / x, "hoop"))] +
            [ux[1] + uy[0] - 2 * (1 + NU) * s["sxy"] / E]) / ALPHA
        claim(error < 1e-5, "%s: strains are those of stress and heat, %.1e" % (name, error))
        error = largest((sxx[0] + sxy[1] + (s["sxx"] - s["hoop"]) / x,
                         sxy[0] + syy[1] + s["sxy"] / x)) / (E * ALPHA)
        claim(error < 1e-5, "%s: stresses carry themselves, %.1e" % (name, error))
        balanced(name, SCALE, 1e-10)

# half of a body and all of it
ENERGIES = []
for symmetric in (False, True):
    name = "half" if symmetric else "whole"
    low = 0 if symmetric else -1
    keys = scene({"hub": body([[1, low], [2, low], [2, 1], [1, 1]], ["any", "out", "end", "bore"] if symmetric
                              else ["end", "out", "end", "bore"], material=steel(), **heat(
                                  bore=held("(1 - z^2)^2")), **({} if symmetric else FIXED))}, size=0.5, degree=8)
    if symmetric:
        keys["Geometry"]["Symmetry"] = "Y"
    ENERGIES.append((last(name, keys)[0]["energy_strain"], fields(name, [(1.3, 0.6)])["hoop"][0]))
for half, whole in zip(ENERGIES[1], ENERGIES[0]):
    claim(abs(half / whole - 1) < 1e-6, "a half is half of the whole: %.10g, %.10g" % (half, whole))

# the estimate over the true error, that to a finer solution: a sleeve that is heated outside and cooled at
# its end on a longer shaft, which conducts, too
def sleeve(strategy, unknowns):
    keys = scene({
        "sleeve": body([[1, 0], [2, 0], [2, 1], [1, 1]], ["any", "side", "end", "bore"], {}, steel(),
                       **heat(side=held(1), end=flux(-2))),
        "shaft": body([[0, 0], [1, 0], [1, 3], [0, 3]], ["any", "seat", "end", "any"], {}, steel(),
                      **heat(end=held(-1)))},
        adaptivity={"Strategy": strategy, "Maximum Levels": 60, "Maximum Degrees of Freedom": unknowns},
        Contacts={"fit": {"Between": ["sleeve:bore", "shaft:seat"], "Interference": 0.02}})
    keys["Geometry"]["Symmetry"] = "Y"
    return keys


last("finer", sleeve("Graded hp", 500))
for strategy, unknowns in (("Graded hp", 200), ("Adaptive h", 160), ("Uniform h", 100)):
    name = "by " + strategy
    code, text = epafi("run", saved(name, sleeve(strategy, unknowns)), "--output", fresh(name),
                       "--reference", os.path.join(WORK, "finer", "solution.hdf"))
    ratios = [row["effectivity"] for row in rows(name, "history.csv") if row["counted"] == 1]
    claim(code == 0 and len(ratios) > 2 and 1 < min(ratios) and max(ratios) < 6, "%s: estimate over error %s" % (
        name, " ".join("%.2f" % value for value in ratios)))

# heated and cooled on a path with friction: the balance of energies is better the finer the path
ERRORS = []
for steps in (4, 16):
    name = "path of %d" % steps
    last(name, scene({"block": body([[0, 0], [1, 0], [1, 2], [0, 2]], ["base", "side", "top", "any"], {"base": {
        "Type": "Contact", "Gap": "0.002*x^2", "Friction": {"Law": "Coulomb", "Coefficient": 0.2}},
        "top": {"Type": "Neumann", "Traction Y": "-0.05*min(t, 1)"}}, steel(), **heat(
            side=held("t < 1 ? 0 : 1 - abs(t - 2)"), top=flux("t < 1 ? 0 : 2*(1 - abs(t - 2))")))},
        size=0.5, degree=3, History={"Times": [1, 2, 3], "Steps": [steps] * 3}))
    row = rows(name, "steps.csv")[-1]
    ERRORS.append(abs(row["energy_error"]) / abs(row["energy_outside"]))
    balanced(name, SCALE, 1e-11)
claim(ERRORS[1] < max(ERRORS[0] / 5, 1e-12), "heated: balance of energies to %.1e, %.1e" % tuple(ERRORS))
finish()
