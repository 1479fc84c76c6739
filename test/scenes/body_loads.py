"""Weight, spin and heat inside bodies against closed forms (doc/theory/body-loads.md)."""
import functools
import math

from runs import balanced as balanced_within
from runs import (claim, epafi, finish, fresh, largest, never_falls, points, refused, rows,
                  run)
from written import (CLAMPED, NONE, WALLS, block, body, condition, contact, disc, friction, history,
                     keys, listed, points_at, primed, rigid, round_hole, with_more, written)

balanced = functools.partial(balanced_within, limit=1e-12)
FORMS = ("Density", "Projected", "Exact")


def loads(**functions):
    return listed("Body Loads", **functions)


# a block in a frictionless channel: weight and a temperature over the height, linear in space
E, RHO, G, HEIGHT, ALPHA = 5.0, 0.2, 0.5, 3.0, 0.01
HEAT = (1.0, -0.8, 0.3)


def temperature(y):
    return sum(c * y ** k for k, c in enumerate(HEAT))


def channel(name, form, plane, ratio, y0=2.0, degree=3):
    up = "(y - %r)" % y0
    slab = body(
        "slab", block(1, y0, 3, y0 + HEIGHT), E, condition("bottom", "Contact") + WALLS,
        ratio=ratio, Density=RHO, Thermal_Expansion=ALPHA, Plane_State=plane, inside=loads(
            Gravity_Y="-%r*t" % G, Temperature="t*(%r + %r*%s + %r*%s^2)" % (
                HEAT[0], HEAT[1], up, HEAT[2], up)))
    file = written(name, [slab], NONE, form, 0.75, degree, points_at([(2.0, y0 + 1.0)]))
    return run(file, name)


for form in FORMS:
    for plane, ratio in (("Plane Strain", 0.3), ("Plane Stress", 0.3), ("Plane Strain", 0.5)):
        if ratio == 0.5 and form != "Density":
            continue
        name = "channel %s %s %g" % (form, plane, ratio)
        levels, contacts = channel(name, form, plane, ratio)
        e, nu, al = primed(ratio, ALPHA, plane)
        e *= E
        weight = RHO * G * HEIGHT
        worst = largest(p["lambda_n"] / weight - 1 for p in contacts)
        claim(worst < 1e-10, "%s: the floor carries the weight, %.1e" % (name, worst))
        sides = rows(name, "boundary.csv")
        error = largest(
            p["tx"] - nx * -(nu * RHO * G * (HEIGHT - p["y"] + 2) + e * al * temperature(p["y"] - 2))
            for p in sides for nx in ((1,) if p["boundary"] == "right" else
                                      (-1,) if p["boundary"] == "left" else ()))
        claim(error < 1e-10 * weight, "%s: pressure of the walls, %.1e" % (name, error))
        rises = sum(c * HEIGHT ** (k + 1) / (k + 1) for k, c in enumerate(HEAT))
        exact = -(1 - nu ** 2) * RHO * G * HEIGHT ** 2 / (2 * e) + (1 + nu) * al * rises
        error = largest(p["uy"] - exact for p in sides if p["boundary"] == "top") / abs(exact)
        claim(error < 1e-10, "%s: the top moves as it should, %.1e" % (name, error))
        inside = rows(name, "interior.csv")[0]
        syy = -RHO * G * (HEIGHT - 1)
        sxx = nu * syy - e * al * temperature(1)
        szz = 0 if plane == "Plane Stress" else ratio * (sxx + syy) - E * ALPHA * temperature(1)
        error = largest([inside["sxx"] - sxx, inside["syy"] - syy, inside["sxy"],
                         inside["szz"] - szz, inside["temperature"] - temperature(1)])
        claim(error < 1e-9, "%s: inside, %.1e" % (name, error))
        claim(levels[-1]["estimate"] < 1e-9, "%s: estimate %.1e" % (name, levels[-1]["estimate"]))
        balanced(name)

# at degree 1 it is an approximation that converges, and the estimate bounds it
previous = None
for size in (0.75, 0.375):
    name = "channel of degree 1, %g" % size
    slab = body(
        "slab", block(1, 2, 3, 5), E, condition("bottom", "Contact") + WALLS, Density=RHO, inside=loads(
            Gravity_Y=-G))
    level = run(written(name, [slab], NONE, "Density", size, 1), name)[0][-1]
    nu = 0.3 / 0.7
    exact = (1 - nu ** 2) * (RHO * G) ** 2 * HEIGHT ** 3 / (3 * E / 0.91)  # 2 wide, halved
    error = math.sqrt(2 * abs(level["energy_strain"] - exact))
    claim(error < 4 * level["estimate"], "degree 1: energy %.6e, exact %.6e, estimate %.1e" % (
        level["energy_strain"], exact, level["estimate"]))
    previous = level["estimate"] / previous if previous else level["estimate"]
claim(previous < 0.6, "halved elements: the estimate falls by %.2f" % previous)


FREE = "X, Y, Rotation"
R, OMEGA = 2.0, 0.6

# the rotating disc, wherever it is, in both plane states
for plane, ratio, x in (("Plane Strain", 0.3, 0.0), ("Plane Stress", 0.3, 7.0)):
    name = "disc %s %g" % (plane, x)
    turned = body("disc", disc(R, "rim", x), E, NONE, FREE, ratio=ratio, Density=RHO, Plane_State=plane,
                  inside=loads(Spin=OMEGA, Center=[x, 0]))
    e, nu, _ = primed(ratio, 0, plane)
    e *= E
    c = RHO * OMEGA ** 2
    file = written(name, [turned], NONE, "Density", 1, 10, points_at([(x + 1e-3, 0.0)]))
    level = run(file, name)[0][-1]
    inside = rows(name, "interior.csv")[0]
    exact = (3 + nu) * c * R ** 2 / 8
    claim(abs(inside["sxx"] / exact - 1) < 1e-6 and abs(inside["syy"] / exact - 1) < 1e-6,
          "%s: stress in the middle" % name)
    exact = (1 - nu) * c * R ** 3 / (4 * e)
    error = largest(math.hypot(p["ux"], p["uy"]) / exact - 1 for p in rows(name, "boundary.csv"))
    claim(error < 1e-10, "%s: the rim moves outwards, %.1e" % (name, error))
    error = largest(math.hypot(p["tx"], p["ty"]) for p in rows(name, "boundary.csv"))
    claim(error < 1e-9 * c * R ** 2, "%s: no traction on the rim, %.1e" % (name, error))
    exact = math.pi * c ** 2 * (1 - nu) * (7 + nu) * R ** 6 / (96 * e)
    claim(abs(level["energy_strain"] / exact - 1) < 1e-9,
          "%s: strain energy %.12e, exact %.12e" % (name, level["energy_strain"], exact))
    claim(abs(level["energy_load"] / (2 * exact) - 1) < 1e-9,
          "%s: twice that is the load's work" % name)
    balanced(name, scale=c * R ** 3)

# a disc in a rigid hole, heated and spinning; the clearance is lost, by every form
CLEARANCE = 1e-3
GAUSS = "Gauss-Legendre-Lagrange"
for form, plane, basis in (
        *((form, "Plane Strain", GAUSS) for form in FORMS), ("Density", "Plane Stress", GAUSS),
        *((form, "Plane Strain", basis) for form in ("Projected", "Density")
          for basis in ("Gauss-Lobatto-Lagrange", "Bernstein")),
        ("None", "Plane Strain", "Biorthogonal")):
    name, ratio = "disc in hole %s %s %s" % (form, plane, basis), 0.3
    filled = body("disc", disc(R, "rim"), E, condition("rim", "Contact", Gap=CLEARANCE), FREE, ratio=ratio,
                  Density=RHO, Thermal_Expansion=ALPHA, Plane_State=plane,
                  inside=loads(Spin=OMEGA, Temperature=2))
    levels, contacts = run(written(name, [filled], NONE, form, 1, 10, Multiplier=basis), name)
    e, nu, al = primed(ratio, ALPHA, plane)
    c = RHO * OMEGA ** 2
    exact = E * e / (1 - nu) * (2 * al - CLEARANCE / R) + c * R ** 2 / 4
    error = largest(p["lambda_n"] / exact - 1 for p in contacts)
    claim(error < 1e-9, "%s: pressure, %.1e" % (name, error))
    # radial and hoop stress are a - (3+nu) c r^2/8 and a - (1+3nu) c r^2/8
    a = (3 + nu) * c * R ** 2 / 8 - exact
    squares = [R ** (2 + n) / (2 + n) for n in (0, 2, 4)]  # of r^n r dr
    terms = (a * a * (1 - nu), -a * c * (1 - nu ** 2) / 2,
             c ** 2 / 128 * ((3 + nu) ** 2 + (1 + 3 * nu) ** 2 - 2 * nu * (3 + nu) * (1 + 3 * nu)))
    exact = 2 * math.pi / (E * e) * sum(x * y for x, y in zip(terms, squares))
    claim(abs(levels[-1]["energy_strain"] / exact - 1) < 1e-9,
          "%s: strain energy %.9e, exact %.9e" % (name, levels[-1]["energy_strain"], exact))

# the residual of the stabilisation knows the traction by which Fix holds the disc against its weight
for form, basis in (*((form, GAUSS) for form in FORMS), ("None", "Biorthogonal")):
    name = "held disc " + form
    held = body("disc", disc(1, "rim"), 100, condition("rim", "Contact", Gap=-0.05), FREE,
                inside=loads(Force_X=2))
    level = run(written(name, [held], NONE, form, 1, 8, Multiplier=basis), name)[0][-1]
    claim(abs(level["contact_x"] / (-10 * math.pi / 9) - 1) < 2e-9, "%s: force of the contact %.10f, exact %.10f"
          % (name, level["contact_x"], -10 * math.pi / 9))

# a disc of arcs that turns as a whole is strained at no degree
whirl = body("disc", disc(R, "rim"), E, condition("rim", "Dirichlet", Displacement_X="-0.01*y",
                                                  Displacement_Y="0.01*x"))
level = run(written("turned", [whirl], form="None", size=1, degree=1), "turned")[0][-1]
claim(abs(level["energy_strain"]) < 1e-19 * E, "a disc that turns has no strain: %.1e" % level["energy_strain"])

# nu = 1/2: a spinning ring on a shaft, in a housing: u = a/r on both; the other line is pinned
MU_HALF, INNER, OVERLAP = E / 3, 1.0, 0.1
C_HALF = RHO * OMEGA ** 2
for method in ("Dense", "Compressed"):
    for side, radius, other, way in (("in", INNER, R, 1), ("out", R, INNER, -1)):
        name = "ring held %s, %s" % (side, method)
        outline = disc(R, "out", holes=round_hole(INNER, "in"))
        held = condition(side, "Contact", friction(0.1), Gap=-OVERLAP)
        spun = body("ring", outline, E, held, ratio=0.5, Density=RHO, inside=loads(Spin=OMEGA))
        contacts = run(written(name, [spun], NONE, "Density", 1, 9,
                               listed("Solver", listed("Linear", Method=method))), name)[1]
        a = way * OVERLAP * radius
        exact = (2 * MU_HALF * a * (1 / radius ** 2 - 1 / other ** 2) +
                 C_HALF * (radius ** 2 - other ** 2) / 2)
        error = largest(p["lambda_n"] / exact - 1 for p in contacts)
        claim(error < 1e-8, "%s: pressure %.6e, %.1e" % (name, exact, error))
        error = largest(math.hypot(p["tx"], p["ty"]) for p in rows(name, "boundary.csv")
                        if p["boundary"] != side) / abs(exact)
        claim(error < 1e-7, "%s: no traction on the other line, %.1e" % (name, error))
        balanced(name, C_HALF * R ** 3, limit=1e-11)

# ring on shaft along a path of speed: pressure falls with its square, the fit is lost and found
STEEL, RI, RF, RO, FIT, TON = 210e3, 10.0, 20.0, 30.0, 0.01, 7.85e-9


def ring(name, inner, outer, x=0.0):
    outline = disc(outer, "outside", x, holes=round_hole(inner, "inside", x))
    return body(name, outline, STEEL, NONE, FREE, Density=TON, Thermal_Expansion=12e-6,
                Plane_State="Plane Stress")


def press_fit(name, spin, heat="0", x=0.0, path=NONE, first="ring:inside", second="shaft:outside",
              more=NONE):
    root = loads(Spin=spin, Center=[x, 0])
    hot = loads(Spin=spin, Center=[x, 0], Temperature=heat)
    file = written(name, [ring("shaft", RI, RF, x), with_more(ring("ring", RF, RO, x), hot)],
                   contact("fit", first, second, Interference=FIT),
                   "Density", 20, 8, root + path + more)
    return run(file, name)


C = RF * ((RO ** 2 + RF ** 2) / (RO ** 2 - RF ** 2) + 0.3 +
          (RF ** 2 + RI ** 2) / (RF ** 2 - RI ** 2) - 0.3) / STEEL
S = RF * TON * (3.3 * RO ** 2 + 0.7 * RF ** 2 - 0.7 * RF ** 2 - 3.3 * RI ** 2) / STEEL / 4
LOST = math.sqrt(FIT / S)
claim(abs(LOST - 4501.817172) < 1e-6, "the speed at which the fit is lost: %.6f" % LOST)
TIMES = (0.5, 1, 1.6, 2.6, 3.2)
press_fit("speed", "3000*t", "0", 0, history(TIMES, 1))
FORCES = [row["fit.force_normal"] for row in rows("speed", "steps.csv")]
for t, whole in zip(TIMES, FORCES):
    exact = max(0, (FIT - S * (3000 * t) ** 2) / C)
    force = whole / (2 * math.pi * RF)
    claim(abs(force - exact) < 1e-9 * 24.6, "ring at %g of 3000/s: pressure %.9f, exact %.9f" % (
        t, force, exact))
# linear in the square of the speed, to where the force vanishes
ZERO = 3000 * math.sqrt(0.25 + 0.75 * FORCES[0] / (FORCES[0] - FORCES[1]))
claim(abs(ZERO / LOST - 1) < 1e-9, "the forces vanish at %.9f, exact %.9f" % (ZERO, LOST))
balanced("speed", 24.6 * RF, limit=1e-11)
_, contacts = press_fit("hot ring", "0", "10", 5.0)
error = largest(p["lambda_n"] / 18.7031250 - 1 for p in contacts)
claim(error < 1e-9, "ring 10 K hotter: 18.7031250 within %.1e" % error)
_, other = press_fit("hot ring swapped", "0", "10", 5.0, NONE, "shaft:outside", "ring:inside")
error = largest(p["lambda_n"] / 18.7031250 - 1 for p in other)
claim(error < 1e-9, "the other side first: within %.1e" % error)
_, other = press_fit("hot ring compressed", "0", "10", 5.0, NONE, more=listed(
    "Solver", listed("Linear", Method="Compressed")))
error = largest(p["lambda_n"] / 18.7031250 - 1 for p in other)
claim(error < 1e-9, "compressed operators: within %.1e" % error)
balanced("hot ring compressed", 18.7 * RF, limit=1e-10)

# a block on an incline: slides at tan a = mu, and carries downhill of its middle
W, H, MU = 2.0, 1.0, 0.3
for slope, slides in ((MU * (1 - 1e-9), False), (MU * (1 + 1e-9), True)):
    a = math.atan(slope)
    name = "incline %.10f" % slope
    held = condition("bottom", "Contact", friction(MU))
    lying = body("block", block(-W / 2, 0, W / 2, H), E, held, Density=RHO, inside=loads(
        Gravity_X=math.sin(a), Gravity_Y=-math.cos(a)))
    code, text = epafi("run", written(name, [lying], NONE, "Density", 0.25, 3), "--output",
                       fresh(name))
    claim((code == 0) != slides, "an incline of %.9f mu: %s" % (
        slope / MU, "slides" if slides else "holds"))
    if not slides:
        row = rows(name, "bodies.csv")[-1]
        middle = row["contact_moment"] / row["contact_y"]
        claim(abs(middle - H / 2 * slope) < 1e-9, "centre of pressure %.9f, exact %.9f" % (
            middle, H / 2 * slope))
        balanced(name)

# a block on a plane under its own weight: the pressure is not uniform
upright = body("block", block(-0.5, 0, 0.5, 1), 1.0, condition(
    "bottom", "Contact"), "X, Rotation", Density=1.0, inside=loads(Gravity_Y=-1))
_, contacts = run(written("own weight", [upright], NONE, "Density", 0.25, 3,
                          listed("Adaptivity", Strategy="Graded hp", Maximum_Levels=15) +
                          listed("Output", Contact_Samples_per_Element=40)), "own weight")
for x, exact in ((0, 0.097791745), (0.25, 0.039662894)):
    near = sorted(sorted(contacts, key=lambda p: abs(p["x"] - x))[:4], key=lambda p: p["x"])
    value = sum(p["lambda_n"] * math.prod((x - q["x"]) / (p["x"] - q["x"])
                                          for q in near if q is not p) for p in near)
    error = abs((value - 1) / (0.3 / 0.7) - exact)
    claim(error < 1e-7, "own weight: pressure at %g W within %.1e" % (x, error))
balanced("own weight")

# a block that hangs from a clamp at degree 1: the clamp carries it
hung = body("block", block(3, 4, 4, 6), E, condition("top", "Dirichlet", CLAMPED), Density=RHO,
            Thermal_Expansion=ALPHA, inside=loads(Gravity_Y=-1, Gravity_X=0.3,
                                                  Temperature="x^2 - y"))
level = run(written("hung", [hung], NONE, "Density", 0.5, 1), "hung")[0][-1]
claim(abs(level["reaction_y"] / (2 * RHO) - 1) < 1e-12 and
      abs(level["reaction_x"] / (-0.6 * RHO) - 1) < 1e-12, "a clamp carries what hangs from it")
balanced("hung")

# a ring whose hub is held while it is to turn faster; a rigid square in the same motion
GAMMA, INSIDE = 0.7, 1.0
wheel = body("wheel", disc(R, "out", holes=round_hole(INSIDE, "in")), E,
             condition("in", "Dirichlet", CLAMPED), Density=RHO,
             inside=loads(Angular_Acceleration=GAMMA))
level = run(written("wheel", [wheel], NONE, "Density", 1, 10), "wheel")[0][-1]
exact = RHO * GAMMA * math.pi * (R ** 4 - INSIDE ** 4) / 2
claim(abs(level["reaction_moment"] / exact - 1) < 1e-11, "the hub turns the wheel: %.9f, exact %.9f" % (
    level["reaction_moment"], exact))
exact = R * RHO * GAMMA / (4 * E / 2.6) * ((R ** 2 - INSIDE ** 2) / 2 + R ** 4 / 2 * (
    1 / R ** 2 - 1 / INSIDE ** 2))
error = largest((p["uy"] * p["x"] - p["ux"] * p["y"]) / R / exact - 1
                for p in rows("wheel", "boundary.csv") if p["boundary"] == "out")
claim(error < 1e-9, "the rim stays behind, %.1e" % error)
balanced("wheel")
square = rigid("square", block(2, 0, 3, 1), loads(Spin=OMEGA, Angular_Acceleration=GAMMA), Density=RHO)
beside = body("beside", block(3, 0, 4, 1), E, condition("right", "Dirichlet", CLAMPED))
run(written("square", [beside, square], contact("at", "beside:left", "square:right"), "Density",
            0.5, 2), "square")
row = next(row for row in rows("square", "bodies.csv") if row["body"] == "square")
for key, exact in (("body_force_x", RHO * (OMEGA ** 2 * 2.5 + GAMMA * 0.5)),
                   ("body_force_y", RHO * (OMEGA ** 2 * 0.5 - GAMMA * 2.5)),
                   ("body_moment", -RHO * GAMMA * (2.5 ** 2 + 0.5 ** 2 + 1 / 6))):
    claim(abs(row[key] - exact) < 1e-13, "a rigid square: %s %.12f" % (key, row[key]))
balanced("square")

# loads of all kinds at once: Hooke's law and equilibrium inside by differences
X, Y, STEP, HOT = 0.4, 0.3, 2e-5, 0.8
QUARTIC = "0.5 + 0.2*x - 0.3*y + 0.7*x*y - 0.4*x^2*y + 0.3*x^3*y - 0.6*x^2*y^2 + 0.4*x^4 - 0.2*y^4"
for plane, ratio in (("Plane Strain", 0.3), ("Plane Stress", 0.3), ("Plane Strain", 0.5)):
    name = "all loads %s %g" % (plane, ratio)
    loaded = body("block", block(0, 0, 1, 1), E, condition("bottom", "Dirichlet", CLAMPED), ratio=ratio,
                  Density=RHO, Thermal_Expansion=HOT, Plane_State=plane,
                  inside=loads(Gravity_X=0.3, Gravity_Y=-0.7, Spin=OMEGA, Angular_Acceleration=GAMMA,
                               Temperature=QUARTIC))
    run(written(name, [loaded], NONE, "Density", 0.5, 4, points_at(
        [(X + STEP * i, Y + STEP * j) for i, j in ((0, 0), (1, 0), (-1, 0), (0, 1), (0, -1))])), name)
    p, *around = rows(name, "interior.csv")
    ux, uy, sxx, syy, sxy = ([(a[key] - b[key]) / 2 / STEP for a, b in (around[:2], around[2:])]
                             for key in ("ux", "uy", "sxx", "syy", "sxy"))  # along x, along y
    e, nu, al = primed(ratio, HOT, plane)
    heat = al * eval(QUARTIC.replace("^", "**"), {"x": X, "y": Y})
    error = largest((ux[0] - (p["sxx"] - nu * p["syy"]) / e / E - heat,
                     uy[1] - (p["syy"] - nu * p["sxx"]) / e / E - heat,
                     ux[1] + uy[0] - 2 * (1 + nu) * p["sxy"] / e / E))
    claim(error < 1e-7, "%s: strains are those of stress and heat, %.1e" % (name, error))
    error = largest((sxx[0] + sxy[1] + RHO * (0.3 + OMEGA ** 2 * X + GAMMA * Y),
                     sxy[0] + syy[1] + RHO * (-0.7 + OMEGA ** 2 * Y - GAMMA * X)))
    claim(error < 1e-7, "%s: stresses carry the forces, %.1e" % (name, error))
    balanced(name)

# a guide that pulls: held along one axis, loaded along the other
pulled = body("bar", block(0, 0, 2, 1), E,
              condition("left", "Dirichlet", Displacement_X=0) +
              condition("right", "Dirichlet", Displacement_Y="-%.17g*y" % (0.3 * 0.39 / E),
                        Traction_X="0.3") + condition("bottom", "Dirichlet", Displacement_Y=0,
                                                      Force_X=0))
level = run(written("guide", [pulled], NONE, "Density", 0.5, 1), "guide")[0][-1]
claim(abs(level["reaction_x"] + 0.3) < 1e-12 and abs(level["load_x"] - 0.3) < 1e-14,
      "a guide that pulls: reaction %.15f" % level["reaction_x"])
error = largest(p["ux"] - 0.3 * 0.91 / E * p["x"] for p in rows("guide", "boundary.csv"))
claim(error < 1e-13, "and the bar is as much longer as it should, %.1e" % error)
refused("both along one axis", written("refused", [body("bar", block(0, 0, 1, 1), E, condition(
    "left", "Dirichlet", Displacement_X=0, Traction_X="1"))], NONE, "Density"),
        "one of them moves the boundary", command="check")

# bodies on bodies: weights add up, a rigid one's too; the other side first, compressed
UPPER, LOWER = block(-0.5, 0.5, 0.5, 1.5), block(-1, 0, 1, 0.5)
LIST = loads(Gravity_X=0.01, Gravity_Y=-1)


def heap(name, first="lid:bottom", second="block:top", more=NONE, form="Density"):
    lid = rigid("lid", UPPER, listed("Motion", Force_X=0, Force_Y=-0.01), Density=3 * RHO)
    lying = body("block", LOWER, E, Density=RHO)
    floor = rigid("floor", block(-2, -1, 2, 0))
    pair = [("lid", "block:top", "lid:bottom"), ("floor", "block:bottom", "floor:top")]
    return run(written(name, [lid, lying, floor], keys(*(
        contact(*sides, friction(0.4)) for sides in pair)), form, 0.25, 2, LIST + more), name)


for form in FORMS:
    name = "heap " + form
    heap(name, form=form)
    last = {row["body"]: row for row in rows(name, "bodies.csv")}
    claim(abs(last["floor"]["reaction_y"] - (0.01 + 3 * RHO + RHO)) < 1e-12,
          "%s: the floor carries all, %.15f" % (name, last["floor"]["reaction_y"]))
    claim(abs(last["lid"]["body_force_y"] + 3 * RHO) < 1e-14, "the lid weighs what it weighs")
    balanced(name)

# up and down again, weight and heat, without friction and with it
for law, form in (("smooth", "Density"), *(("rough", form) for form in FORMS)):
    errors = []
    for steps in (4, 16):
        name = "there and back %s %s %d" % (law, form, steps)
        held = condition("bottom", "Contact", friction(0.2) if law == "rough" else NONE,
                         Gap="0.02*x^2")
        lying = body("block", block(-1, 0, 1, 1), E, held, "X, Rotation", Density=RHO,
                     Thermal_Expansion=ALPHA,
                     inside=loads(Gravity_Y="-2*min(t, 1)",
                                  Temperature="(t < 1 ? 0 : 1 - abs(t - 2))*(1 + 2*x + x*y)"))
        run(written(name, [lying], NONE, form, 0.5, 3, history([1, 2, 3], steps)), name)
        never_falls(name)
        first, last = (points(name, k) for k in (steps, 3 * steps))
        size = largest(p["lambda_n"] for p in first)
        apart = largest(p["lambda_n"] - q["lambda_n"] for p, q in zip(first, last)) / size
        row = rows(name, "steps.csv")[-1]
        errors.append(abs(row["energy_error"]) / abs(row["energy_outside"]))
        if law == "smooth":
            claim(apart < 1e-10, "without friction heat comes and goes: %.1e" % apart)
        else:
            claim(apart > 1e-4, "with friction it leaves something: %.1e" % apart)
        balanced(name)
    claim(errors[1] < errors[0] / 5, "%s %s: balance of energy to %.1e, %.1e" % (law, form, *errors))

# a strip of 1 : 1000 has the same polynomials as a block
STRIP = body("block", block(0, 0, 1, 1e-3), E, condition("bottom", "Contact"), "X, Rotation")
for text in ("1 - x^4", "x^2*y^2 - 3*x*y", "(y/1e-3)^2 + x"):
    code, said = epafi("check", written("strip",
                                        [with_more(STRIP, loads(Temperature=text),
                                                   Thermal_Expansion=1e-5)], NONE, "Density"))
    claim(code == 0, "a temperature of %s on a thin strip: %s" % (text, said.strip().split("\n")[0]))

# what is refused
BARE = body("block", block(0, 0, 1, 1), E, condition("bottom", "Contact"), "X, Rotation")
for text, what in (
        (with_more(BARE, loads(Gravity_Y=-1)), "Density: missing; Bodies->block->Body Loads->"
         "Gravity Y needs it"),
        (with_more(BARE, loads(Spin=1)), "Spin needs it"),
        (with_more(BARE, loads(Angular_Acceleration=1)), "Angular Acceleration needs it"),
        (with_more(BARE, loads(Temperature=1)), "Thermal Expansion: missing"),
        (with_more(BARE, loads(Gravity_X=1, Force_X=1), Density=1.0), "not both"),
        (with_more(BARE, loads(Spin=1, Center=[1]), Density=1.0), "a point has two"),
        (with_more(BARE, loads(Temperature="exp(x)"), Thermal_Expansion=1e-5),
         "is not a polynomial in x and y of degree at most 4; the nearest one is off by up to"),
        (with_more(BARE, loads(Gravity_Y="-x"), Density=1.0), "Gravity Y")):
    refused(what, written("refused", [text], NONE, "Density"), what, command="check")
refused("a rigid body that is hot", written("refused", [BARE, rigid(
    "floor", block(-1, -2, 2, -1), loads(Temperature=1))], contact("on", "block:right", "floor:top"),
    "Density"), "heat does nothing to it", command="check")
finish()
