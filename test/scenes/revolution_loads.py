"""Weight, spin and heat inside solids of revolution against closed forms (doc/theory/axisymmetric.md)."""
import math
import os

from epafi import Run
from revolved import (CYLINDER, GRADED, QUARTER, body, clamp, column, last, refused, scene)
from runs import WORK, claim, epafi, finish, fresh, largest, rows, saved
from runs import balanced as balanced_of

E, NU, RHO, ALPHA = 5.0, 0.3, 0.2, 0.01
FIXED = {"Rigid Motions": {"Fix": ["Y"]}}
SCALE = 0.1  # of forces, where none acts along the axis


def balanced(name, limit):
    balanced_of(name, SCALE, limit)


def steel(ratio=NU, **more):
    return {"Young's Modulus": E, "Poisson's Ratio": ratio, "Density": RHO,
            "Thermal Expansion": ALPHA, **more}


def fields(name, places):
    return Run(os.path.join(WORK, name)).fields(places)


def within(name, found, exact, limit):
    error = largest(found - exact) / largest(exact)
    claim(error < limit, "%s within %.1e" % (name, error))


# a free disc that spins: Love's solution but at the rim, which the middle does not see
for thickness, exact in ((0.1, 0.4127321429), (0.2, 0.4134285714)):
    h = thickness / 2
    name = "disc %g" % thickness
    last(name, scene({"disc": body(
        [[0, -h], [1, -h], [1, h], [0, h]], ["low", "rim", "high", "axis"],
        material=steel(Density=1), **FIXED)}, size=1, degree=4, adaptivity={
            **GRADED, "Maximum Degrees of Freedom": 500}, **{"Body Loads": {"Spin": 1}}))
    hoop = fields(name, [(0, 0)])["hoop"][0]
    claim(abs(hoop - exact) < 1e-9, "%s: hoop stress in the middle %.11f, exact %.10f" % (
        name, hoop, exact))
    balanced(name, limit=1e-10)


# between rollers, which hold the ends (plane strain), the whole by polynomials and 1/r: a function of
# the radius gives the stresses along it, around it and along the axis
def spun(inner, outer, ratio=NU, omega=1.0):
    c = RHO * omega ** 2 / (8 * (1 - ratio))
    a, b = inner ** 2, outer ** 2
    k = 3 - 2 * ratio

    def stress(r):
        along = c * k * (a + b - (a * b / r ** 2 if a else 0) - r ** 2)
        around = c * (k * (a + b + (a * b / r ** 2 if a else 0)) - (1 + 2 * ratio) * r ** 2)
        return along, around, ratio * (along + around)
    return stress


def hot(inner, outer, ratio=NU):
    """Where T = r^2."""
    a, b = inner ** 2, outer ** 2
    e = ALPHA * E / (1 - ratio)

    def stress(r):
        whole, part = (b ** 2 - a ** 2) / 4, (r ** 4 - a ** 2) / 4
        along = e / r ** 2 * ((r ** 2 - a) / (b - a) * whole - part)
        around = e / r ** 2 * ((r ** 2 + a) / (b - a) * whole + part - r ** 4)
        return along, around, ratio * (along + around) - ALPHA * E * r ** 2
    return stress


def both(*loads):
    return lambda r: tuple(map(sum, zip(*(stress(r) for stress in loads))))


def energy(stress, inner, outer, height, ratio=NU):
    """Half of stress times its strain, by Simpson's rule."""
    n = 2000
    step = (outer - inner) / n
    total = 0
    for k in range(n + 1):
        r = inner + k * step
        if r == 0:
            continue
        s = stress(r)
        weight = step / 3 * (1 if k in (0, n) else 4 if k % 2 else 2)
        total += weight * r * ((1 + ratio) * sum(x * x for x in s) - ratio * sum(s) ** 2)
    return math.pi * height * total / E


SPIN, HEAT = {"Spin": 1}, {"Temperature": "r^2"}
for name, inner, acts, closed, ratio in (
        ("solid spins", 0, SPIN, spun(0, 2), NU),
        ("solid spins of 0.5", 0, SPIN, spun(0, 2, 0.5), 0.5),  # under pressure alone
        ("hollow spins", 1, SPIN, spun(1, 2), NU),
        ("solid is hot", 0, HEAT, hot(0, 2), NU),
        ("hollow is hot", 1, HEAT, hot(1, 2), NU),
        ("hollow is hot of 0.5", 1, HEAT, hot(1, 2, 0.5), 0.5),
        ("solid spins hot", 0, {**SPIN, **HEAT}, both(spun(0, 2), hot(0, 2)), NU),
        ("hollow spins hot", 1, {**SPIN, **HEAT}, both(spun(1, 2), hot(1, 2)), NU)):
    degree = 4 if inner == 0 else 14
    row, _ = last(name, scene({"shaft": body(
        [[inner, 0], [2, 0], [2, 1], [inner, 1]],
        ["low", "out", "high", "in" if inner else "axis"],
        {"low": clamp(Y=0), "high": clamp(Y=0)}, steel(ratio), **{"Body Loads": acts})},
        size=1 if inner == 0 else 0.5, degree=degree))
    places = [(inner + share * (2 - inner), y) for share in (0.01, 0.3, 0.9) for y in (0.2, 0.7)]
    found = fields(name, places)
    exact = [closed(x) for x, _ in places]
    for k, key in enumerate(("sxx", "hoop", "syy")):
        within("%s: %s inside" % (name, key), found[key], [s[k] for s in exact], 1e-10)
    table = [p for p in rows(name, "boundary.csv") if p["x"] > 0]
    error = largest(p["hoop"] - closed(p["x"])[1] for p in table) / abs(exact[0][1])
    claim(error < 1e-9, "%s: hoop stress on the boundary within %.1e" % (name, error))
    exact = energy(closed, inner, 2, 1, ratio)
    size = energy(closed, inner, 2, 1)
    claim(abs(row["energy_strain"] - exact) < 1e-10 * size, "%s: strain energy %.12g, exact %.12g" % (
        name, row["energy_strain"], exact))
    balanced(name, limit=1e-10)

# a constant force outwards, in a ring between rollers: u'' + u'/r - u/r^2 = -b/c
B, C = 0.7, E * (1 - NU) / (1 + NU) / (1 - 2 * NU)
LAMBDA = C * NU / (1 - NU)
last("outwards", scene({"ring": body(
    [[1, 0], [2, 0], [2, 1], [1, 1]], ["low", "out", "high", "in"],
    {"low": clamp(Y=0), "high": clamp(Y=0)}, steel(), **{"Body Loads": {"Force X": B}})}, degree=14))
# s_r = A - D/r^2 - B (2 + nu')/3 r, nu' = nu/(1-nu), no traction on both sides
SLOPE = B * (2 + LAMBDA / C) / 3
D = SLOPE / (1 - 1 / 4)
A = SLOPE * 1 + D
PLACES = [(1.2, 0.3), (1.7, 0.5)]
FOUND = fields("outwards", PLACES)
within("outwards: sxx", FOUND["sxx"], [A - D / x ** 2 - SLOPE * x for x, _ in PLACES], 1e-10)
within("outwards: hoop", FOUND["hoop"], [
    A + D / x ** 2 - B * (1 + 2 * LAMBDA / C) / 3 * x for x, _ in PLACES], 1e-10)
balanced("outwards", limit=1e-11)

# a column in a frictionless bore, on a rigid plane; a free one presses with all its weight, too
for ratio in (NU, 0.5):
    for free in (False, True):
        name = "%s column %g" % ("free" if free else "held", ratio)
        conditions = {"base": {"Type": "Contact", "Gap": 0}, **({} if free else {"side": clamp(X=0)})}
        row, points = last(name, scene({"block": column(
            CYLINDER, conditions, material=steel(ratio), **{"Body Loads": {"Gravity Y": -3}})}, degree=3))
        exact, share = RHO * 3 * 2, ratio / (1 - ratio)
        weight = rows(name, "bodies.csv")[-1]["body_force_y"]
        claim(abs(weight / (-exact * math.pi) - 1) < 1e-13 and
              abs(row["force_normal"] / (exact * math.pi) - 1) < 1e-12, "%s: its weight %.14g" % (
                  name, row["force_normal"]))
        balanced(name, limit=1e-11)
        if free:
            continue
        error = largest(p["lambda_n"] / exact - 1 for p in points)
        claim(error < 1e-11, "%s: pressure below within %.1e" % (name, error))
        energy_exact = math.pi * (RHO * 3) ** 2 * 8 / 6 / E * (1 - 2 * ratio * share)
        if ratio < 0.5:
            claim(abs(row["energy_strain"] / energy_exact - 1) < 1e-11,
                  "%s: its energy %.12g" % (name, row["energy_strain"]))
        found = fields(name, [(0, 0.5), (0.4, 1.5)])
        for key, part in (("syy", 1), ("sxx", share), ("hoop", share)):
            within("%s: %s" % (name, key), found[key], [-part * RHO * 3 * x for x in (1.5, 0.5)], 1e-11)

# a rigid cylinder on an elastic one: both weigh
HEAVY = scene({
    "block": column(CYLINDER, {"base": clamp(Y=0)}, material=steel()),
    "lid": {"Material": {"Rigid": True, "Density": 0.5}, "Geometry": {
        "Vertices": [[0, 2], [0.8, 2], [0.8, 3], [0, 3]], "Edges": ["low", "side", "top", "axis"]},
        "Motion": {"Force Y": 0}}}, size=0.5, degree=3,
    Contacts={"c": {"Between": ["block:top", "lid:low"]}}, **{"Body Loads": {"Gravity Y": -3}})
last("lid", HEAVY)
TABLE = {row["body"]: row for row in rows("lid", "bodies.csv")}
WEIGHTS = [RHO * 3 * 2 * math.pi, 0.5 * 3 * 0.64 * math.pi]
claim(abs(TABLE["lid"]["body_force_y"] / -WEIGHTS[1] - 1) < 1e-13 and
      abs(TABLE["block"]["reaction_y"] / sum(WEIGHTS) - 1) < 1e-11,
      "a lid on a block: the ground carries %.13g" % TABLE["block"]["reaction_y"])
balanced("lid", limit=1e-11)


# a free sphere: T = R^2, and T = r^2 alone, whose stresses a computer algebra found
def sphere(x, y, ratio):
    """T = x^2 + y^2: sxx, hoop, syy, sxy."""
    e, square = 2 * ALPHA * E / (1 - ratio) / 5, x * x + y * y
    around = e * (1 - 2 * square)
    mix = e
    return around + mix * x * x, around, around + mix * y * y, mix * x * y


def radial(x, y, ratio):
    """T = x^2."""
    n = ratio
    c, r, z = E * ALPHA / (5 * (n - 1) * (5 * n + 7)), x * x, y * y
    return (c * (5 * n * r + 15 * n * z - 5 * n + 11 * r + 17 * z - 11),
            c * (5 * n * r + 15 * n * z - 5 * n + 27 * r + 17 * z - 11),
            2 * c * (5 * n + 3) * (2 * r + z - 1), -2 * c * x * y * (5 * n + 3))


PLACES = [(r * math.sin(a), r * math.cos(a)) for r in (0.1, 0.5, 0.95) for a in (0.2, 1.5, 2.5)]
for text, closed in (("r^2 + z^2", sphere), ("r^2", radial)):
    for ratio in (NU, 0.49):
        name = "sphere %s %g" % (text, ratio)
        last(name, scene({"ball": body([[0, -1], [1, 0], [0, 1]], ["low", "high", "axis"],
                                       material=steel(ratio), bulges=[QUARTER, QUARTER, 0],
                                       **FIXED, **{"Body Loads": {"Temperature": text}})},
                         degree=12))
        found = fields(name, PLACES)
        exact = [closed(x, y, ratio) for x, y in PLACES]
        for k, key in enumerate(("sxx", "hoop", "syy", "sxy")):
            error = largest(found[key] - [s[k] for s in exact]) / (ALPHA * E)
            claim(error < 1e-10, "%s: %s within %.1e" % (name, key, error))
        within(name + ": temperature", found["temperature"], [
            x ** 2 + (y ** 2 if closed is sphere else 0) for x, y in PLACES], 1e-13)
        error = largest(p["hoop"] - closed(p["x"], p["y"], ratio)[1]
                        for p in rows(name, "boundary.csv")) / (ALPHA * E)
        limit = 1e-10 if closed is radial else 3e-10
        claim(error < limit, "%s: hoop stress on its boundary within %.1e" % (name, error))
        balanced(name, limit=1e-9)

# loads of all kinds at once: Hooke's law and equilibrium inside by differences
X, Y, STEP, HOT = 0.4, 0.3, 2e-5, 0.8
QUARTIC = "0.5 - 0.3*y + 0.4*y^2 + 0.2*y^3 - 0.3*y^4 + 0.7*x^2 - 0.4*x^2*y + 0.6*x^2*y^2 + 0.4*x^4"
for ratio in (0.3, 0.5):
    name = "all loads %g" % ratio
    last(name, scene({"block": column([[0, 0], [1, 0], [1, 1], [0, 1]], {"base": clamp(X=0, Y=0)},
                                      material=steel(ratio, **{"Thermal Expansion": HOT}))},
                     size=0.5, degree=4, **{"Body Loads": {
                         "Gravity Y": -0.7, "Force X": 0.3, "Spin": 1.5, "Temperature": QUARTIC}}))
    places = [(X + STEP * i, Y + STEP * j) for i, j in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))]
    found = fields(name, places)

    def slopes(key):  # along x, along y
        return [(found[key][k] - found[key][k + 1]) / 2 / STEP for k in (1, 3)]
    ux, uy, sxx, syy, sxy = map(slopes, ("ux", "uy", "sxx", "syy", "sxy"))
    s = {key: found[key][0] for key in ("sxx", "syy", "hoop", "sxy")}
    heat = HOT * eval(QUARTIC.replace("^", "**"), {"x": X, "y": Y})
    trace = s["sxx"] + s["syy"] + s["hoop"]
    error = largest([strain - ((1 + ratio) * s[key] - ratio * trace) / E - heat for strain, key in (
        (ux[0], "sxx"), (uy[1], "syy"), (found["ux"][0] / X, "hoop"))] +
        [ux[1] + uy[0] - 2 * (1 + ratio) * s["sxy"] / E])
    claim(error < 1e-7, "%s: strains are those of stress and heat, %.1e" % (name, error))
    error = largest((sxx[0] + sxy[1] + (s["sxx"] - s["hoop"]) / X + 0.3 + RHO * 2.25 * X,
                     sxy[0] + syy[1] + s["sxy"] / X - RHO * 0.7))
    claim(error < 1e-7, "%s: stresses carry the forces, %.1e" % (name, error))
    balanced(name, limit=1e-11)

# a hub shrunk on a shaft of its length, both spin.  Rollers hold the ends; free ends (both without a
# force along the axis) are longer by -nu s/E, s the mean of s_z between rollers
INNER, OUTER, FIT, OMEGA = 1.0, 2.0, 0.5, 0.8
SPUN = RHO * OMEGA ** 2


def grown(inner, outer, r, free):
    """u_r of what spins."""
    e, n = E / (1 - NU ** 2), NU / (1 - NU)
    a, b = inner ** 2, outer ** 2
    u = SPUN / 8 / e * r * ((3 + n) * (1 - n) * (a + b) + (3 + n) * (1 + n) * a * b / r ** 2 -
                            (1 - n * n) * r ** 2)
    return u + free * NU ** 2 * SPUN * (a + b) * r / 2 / E


def yields(free):
    """By a pressure of 1."""
    e, n = (E, NU) if free else (E / (1 - NU ** 2), NU / (1 - NU))
    ring = (OUTER ** 2 + INNER ** 2) / (OUTER ** 2 - INNER ** 2)
    return INNER / e * ((ring + n) + (1 - n))


def fit(name, length, free, speed="%g" % OMEGA, size=0.5, degree=10, hub=None, **more):
    ends = {} if free else {"high": clamp(Y=0)}
    keys = scene({
        "hub": body([[INNER, 0], [OUTER, 0], [OUTER, length], [INNER, length]],
                    ["any", "out", "high", "bore"], ends, steel(),
                    **({"Body Loads": {"Spin": speed, **hub}} if hub else {})),
        "shaft": body([[0, 0], [INNER, 0], [INNER, length], [0, length]],
                      ["any", "seat", "high", "any"], ends, steel())},
        size=size, degree=degree, Contacts={"fit": {
            "Between": ["hub:bore", "shaft:seat"], "Interference": FIT}},
        **{"Body Loads": {"Spin": speed}, **more})
    keys["Geometry"]["Symmetry"] = "Y"
    row, points = last(name, keys)
    return row, points


for free, length, size, degree, limit in ((False, 0.5, 0.5, 14, 1e-9), (True, 8, 1, 12, 1e-6)):
    name = "spinning fit, ends %s" % ("free" if free else "held")
    _, points = fit(name, length, free, size=size, degree=degree)
    less = grown(INNER, OUTER, INNER, free) - grown(0, INNER, INNER, free)
    exact = (FIT - less) / yields(free)
    error = largest(p["lambda_n"] / exact - 1 for p in points if p["y"] < 0.5)
    claim(error < limit, "%s: pressure in the middle %.9g, within %.1e" % (name, exact, error))
    balanced(name, limit=1e-9)

# a path of speed: forces fall with its square, the fit is lost and found
SPEEDS = (0.5, 1, 1.6, 3)
fit("speed", 0.5, False, "t", degree=8, History={"Times": list(SPEEDS)})
LESS = [(grown(INNER, OUTER, INNER, False) - grown(0, INNER, INNER, False)) * (t / OMEGA) ** 2
        for t in SPEEDS]
FORCES = [max(0, FIT - less) / yields(False) * 2 * math.pi for less in LESS]  # of both halves
claim(FORCES[-1] == 0 < FORCES[-2], "the fit is lost on the way")
for row, exact in zip(rows("speed", "steps.csv"), FORCES):
    claim(abs(row["fit.force_normal"] - exact) < 1e-7 * FORCES[0], "speed %g: force %.10g, exact %.10g" % (
        row["t"], row["fit.force_normal"], exact))
balanced("speed", limit=1e-9)

# a hub heated evenly is one made larger
COLD = fit("cold", 1, True, "0", size=1, degree=6)[0]
WARM = fit("warm", 1, True, "0", size=1, degree=6, hub={"Temperature": 0.4})[0]
claim(abs(WARM["force_normal"] / COLD["force_normal"] / (1 - 0.4 * ALPHA * INNER / FIT) - 1) < 1e-10,
      "a hub heated evenly is larger: force %.12g of %.12g" % (WARM["force_normal"], COLD["force_normal"]))

# the estimate over the true error, that to a finer solution
STRATEGIES = {"Graded hp": 160, "Adaptive h": 120, "Uniform h": 80}


def shrunk(strategy, unknowns):
    hub = {**steel(), "Density": 1}
    keys = scene({
        "hub": body([[1, 0], [2, 0], [2, 1], [1, 1]], ["any", "side", "end", "bore"], {}, hub, **{
            "Body Loads": {"Spin": 0.02, "Temperature": "0.01*z^2"}}),
        "shaft": body([[0, 0], [1, 0], [1, 3], [0, 3]], ["any", "seat", "end", "any"], {}, hub)},
        adaptivity={"Strategy": strategy, "Maximum Levels": 60, "Maximum Degrees of Freedom": unknowns},
        Contacts={"fit": {"Between": ["hub:bore", "shaft:seat"], "Interference": 1e-3}})
    keys["Geometry"]["Symmetry"] = "Y"
    return keys


def spun_disc(strategy, unknowns):
    return scene({"disc": body([[0, -0.2], [1, -0.2], [1, 0.2], [0, 0.2]], ["low", "rim", "high", "axis"],
                               material=steel(), **FIXED)}, size=0.4,
                 adaptivity={"Strategy": strategy, "Maximum Levels": 60,
                             "Maximum Degrees of Freedom": unknowns}, **{"Body Loads": {"Spin": 1}})


for what in (shrunk, spun_disc):
    finer = os.path.join(WORK, what.__name__ + " finer", "solution.hdf")
    last(what.__name__ + " finer", what("Graded hp", 400))
    for strategy, unknowns in STRATEGIES.items():
        name = "%s by %s" % (what.__name__, strategy)
        code, text = epafi("run", saved(name, what(strategy, unknowns)), "--output", fresh(name),
                           "--reference", finer)
        ratios = [row["effectivity"] for row in rows(name, "history.csv") if row["counted"] == 1]
        claim(code == 0 and len(ratios) > 2 and 1 < min(ratios) and max(ratios) < 6, "%s: estimate over error %s" % (
            name, " ".join("%.2f" % value for value in ratios)))

# heated and cooled with friction: energies balance the better the finer the path
for law in ({"Law": "None"}, {"Law": "Coulomb", "Coefficient": 0.2}):
    errors = []
    for steps in (4, 16):
        name = "heated %s %d" % (law["Law"], steps)
        last(name, scene({"block": column(CYLINDER, {"base": {
            "Type": "Contact", "Gap": "0.02*x^2", "Friction": law}}, material=steel(), **{
                "Body Loads": {"Gravity Y": "-2*min(t, 1)", "Spin": "min(t, 1)",
                               "Temperature": "(t < 1 ? 0 : 1 - abs(t - 2))*(1 + 2*x^2 + y*x^2)"}})},
            size=0.5, degree=3, History={"Times": [1, 2, 3], "Steps": [steps] * 3}))
        row = rows(name, "steps.csv")[-1]
        errors.append(abs(row["energy_error"]) / abs(row["energy_outside"]))
        balanced(name, limit=1e-11)
    claim(errors[1] < max(errors[0] / 5, 1e-12), "heated %s: balance of energies to %.1e, %.1e" % (
        law["Law"], *errors))

# what is refused, and what r may be called
BLOCK = {"base": clamp(X=0, Y=0)}
for acts, words in (
        ({"Gravity X": 1}, ["Gravity X", "along the axis"]),
        ({"Angular Acceleration": 1}, ["Angular Acceleration", "torsion"]),
        ({"Spin": 1, "Center": [1, 0]}, ["Center", "about the axis"]),
        ({"Temperature": "x"}, ["Temperature", "even in x"]),
        ({"Temperature": "r*z"}, ["Temperature", "even in x"]),
        ({"Temperature": "r^6"}, ["Temperature", "at most 4"])):
    for whose in ("body", "root"):
        keys = scene({"b": column(CYLINDER, BLOCK, material=steel())})
        (keys if whose == "root" else keys["Bodies"]["b"])["Body Loads"] = acts
        refused("%s of the %s" % (next(iter(acts)), whose), words, keys)
refused("weight without density", ["Density: missing"], scene(
    {"b": column(CYLINDER, BLOCK)}, **{"Body Loads": {"Gravity Y": -1}}))
half = scene({"b": column(CYLINDER, {}, material=steel())}, **{"Body Loads": {"Gravity Y": -1}})
half["Geometry"]["Symmetry"] = "Y"
refused("weight across a line of symmetry", ["Geometry->Symmetry"], half)
plane = scene({"b": column(CYLINDER, {**BLOCK, "top": {"Type": "Neumann", "Traction Y": "r"}})})
plane["Geometry"] = {}
refused("r in the plane", ["x, y"], plane)
PULLED = [last("pulled", scene({"b": column(CYLINDER, {**BLOCK, "top": {
    "Type": "Neumann", "Traction Y": text}})}, **more))[0]["energy_strain"] for text, more in (
        ("x + 2*y", {}), ("r + 2*z", {}), ("r + 2*z", {"Constants": {"r": 0, "z": 1}}), ("2", {}))]
claim(PULLED[0] == PULLED[1] and PULLED[2] == PULLED[3] != PULLED[0],
      "r and z are x and y, but where constants are called so")
finish()
