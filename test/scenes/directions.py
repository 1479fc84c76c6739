"""Gap, pressure and shear are along one direction, whichever side comes first: what slides along a flat
side, turns about its own centre or rolls is pressed as at rest, forces on both bodies are opposite, and
beside a corner the other side's normal counts."""
import math

from runs import claim, epafi, finish, rows, saved, solved
from written import (CLAMPED, QUARTERS, block, body, circle, condition, contact, friction, geometry, keys,
                     listed, rigid, round_hole)

E = 210000
ROUND = math.tan(math.pi / 8)
SIDES = "base, side, top, side"
BASE = condition("base", "Dirichlet", CLAMPED)


def held(boundary, x, y):
    return condition(boundary, "Dirichlet", Displacement_X=x, Displacement_Y=y)


def run(name, bodies, between, adaptivity, settings=(), size=0.3, degree=1):
    """The last rows of bodies.csv, the rows of contact.csv, what is printed."""
    file = saved(name, keys(
        listed("Bodies", *bodies), listed("Contacts", contact("c", *between)),
        listed("Discretization", Mesh_Size=size, Degree=degree), listed("Adaptivity", adaptivity),
        listed("Output", Fields=False)), name)
    folder, text = solved(name, file, *settings)
    last = rows(folder, "bodies.csv")[-2:]
    # what a rigid body needs is a force on it, and that an elastic one takes
    ofFirst, ofSecond = ((row["contact_x"], row["contact_y"]) for row in last)
    force = max(map(abs, ofFirst))
    claim(all(abs(a + b) < 1e-13 * force for a, b in zip(ofFirst, ofSecond)),
          "%s: forces of contact are opposite, %.15g and %.15g" % (name, ofFirst[1], ofSecond[1]))
    return last, rows(folder), text


def force(last):
    return last[0]["contact_y"]


def peak(points):
    return max(point["lambda_n"] for point in points)


def near(a, b, within):
    return abs(a - b) <= within * abs(b)


# A pad with rounded edges, slid over a plate: the flat side moves along itself.
PAD = geometry([(-1, 0), (1, 0), (1.3, 0.3), (1.3, 1.5), (-1.3, 1.5), (-1.3, 0.3)],
               "contact, contact, free, top, free, contact", [0, ROUND, 0, 0, 0, ROUND])
PLATE = geometry([(-8, -8), (8, -8), (8, 0), (2, 0), (-2, 0), (-8, 0)],
                 "base, free, free, contact, free, free")


def slid(by, between):
    return run("pad slid by %g, %s first" % (by, between[0]), [
        body("pad", PAD, E, held("top", by, -0.01)), body("plate", PLATE, E, BASE)],
        between, keys(Tolerance=3e-3))[:2]


for between in (("pad:contact", "plate:contact"), ("plate:contact", "pad:contact")):
    last, points = slid(0.03, between)
    claim(near(force(last), 1121.347, 1e-4) and near(peak(points), 2732, 0.01),
          "%s first: force %.7g, peak %.5g" % (between[0], force(last), peak(points)))
    claim(all(abs(point["d_x"]) < 1e-12 for point in points), "the direction is the plate's normal")
    # later levels refine where the largest pressure is in doubt
    estimates = [row["estimate_relative"]
                 for row in rows("pad slid by 0.03, %s first" % between[0], "history.csv")]
    falling = [e for e in estimates if e > 3e-3] + [3e-3]
    claim(all(b < a for a, b in zip(falling, falling[1:])), "estimates fall on %d levels" % len(falling))
    claim(near(force(slid(0.1, between)[0]), force(last), 1e-9), "slid farther all is the same")

# A disc on a block: at rest, turned about its axis, slid, rolled to both sides; the block elastic and
# rigid.
HUB = round_hole(0.4, "shaft", 0, 1)
DISC = geometry(circle(1, 0, 1), ["rim"] * 4, QUARTERS, HUB)
BLOCK = geometry(block(-3, -3, 3, 0), SIDES)
for between in (("disc:rim", "block:top"), ("block:top", "disc:rim")):
    forces = []
    for turn, slide in ((0, 0), (0.05, 0), (0, 0.05), (0.05, -0.05), (0.05, 0.05)):
        shaft = held("shaft", "%g-%g*(y-1)" % (slide, turn), "-0.01+%g*x" % turn)
        forces.append(force(run(
            "disc turned by %g, slid by %g, %s first" % (turn, slide, between[0]),
            [body("disc", DISC, E, shaft, mesh=listed("Mesh", Mesh_Size=0.08)),
             body("block", BLOCK, E, BASE, mesh=listed("Mesh", Elements_per_Edge=[4, 4, 40, 4]))],
            between, keys(Strategy="None"), degree=2)[0]))
    claim(all(near(each, forces[0], 1e-9) for each in forces),
          "turned, slid and rolled as at rest: %s" % forces)
plate = [0, 0]
for k, turn in enumerate((0, 0.05)):
    shaft = held("shaft", "0.02-%g*(y-1)" % turn, "-0.01+%g*x" % turn)
    plate[k] = force(run("disc turned by %g on a rigid plate" % turn, [
        body("disc", DISC, E, shaft, mesh=listed("Mesh", Mesh_Size=0.08)),
        rigid("block", block(-3, -3, 3, 0))],
        ("disc:rim", "block:top"), keys(Strategy="None"), degree=2)[0])
claim(near(*plate, 1e-9), "on a rigid plate, too: %s" % plate)

# A roller in a race, slid: as if drawn there, pressed by what it comes into the race.
R, SLIDE, DEEP = 6.0, 0.1, 0.01
WIDTH = 1.6
ROLLER = geometry([(-1, 1), (0, 0), (1, 1)], "rim, rim, top", [ROUND, ROUND, 0])
placed = math.hypot(SLIDE, R - 1 + DEEP) - (R - 1)


def pressed(name, x, y, between, radius=R, tolerance=0.01, size=0.3):
    width = min(WIDTH, 0.9 * radius)
    rim = radius - math.sqrt(radius * radius - width * width)
    bulge = -math.tan(math.asin(width / radius) / 4)
    race = geometry([(-width, -4), (width, -4), (width, rim), (0, 0), (-width, rim)],
                    "base, side, way, way, side", [0, 0, bulge, bulge, 0])
    last = run(name, [body("roller", ROLLER, E, held("top", x, y)), body("race", race, E, BASE)],
               between, keys(Strategy="Graded hp", Tolerance=tolerance), size=size)[0]
    return math.hypot(last[0]["contact_x"], last[0]["contact_y"])


drawn = pressed("roller placed", 0, -placed, ("roller:rim", "race:way"))
for between in (("roller:rim", "race:way"), ("race:way", "roller:rim")):
    here = pressed("roller slid, %s first" % between[0], SLIDE, -DEEP, between)
    claim(near(here, drawn, 3e-3), "a roller slid in a race: %.5g for %.5g" % (here, drawn))
    # what takes off moments on arcs is known to the estimate, or it would be all that is left of it
    # and where one side is refined, the other follows in the same step
    for name, radius, slide, tolerance, size, most in (
            ("narrow race", 2.0, SLIDE, 0.002, 0.3, 700), ("close race", 1.5, 0.03, 0.01, 0.2, 550),
            ("fine race", 1.5, 0, 0.01, 0.15, 600)):
        name = "roller slid in a %s, %s first" % (name, between[0])
        pressed(name, slide, -DEEP, between, radius, tolerance, size)
        levels = rows(name, "history.csv")
        falling = [level["estimate"] for level in levels]
        claim(levels[-1]["dof"] < most and all(b < a for a, b in zip(falling, falling[1:])),
              "%s: %g is met by %d unknowns, estimates fall: %s" % (name, tolerance, levels[-1]["dof"],
                                                                    falling))

# A disc on the apex of a wedge: nothing pushes it aside.  At the apex the pressure is E/(1 - nu^2) of a part of
# the disc, cos of that of a part of a flank, whatever the load: it strains the wedge by one.
HALF = geometry([(-1, 1), (0, 0), (1, 1)], "rim, rim, top", [ROUND, ROUND, 0])
for falling, tolerance, within in ((27, 0.01, 0), (45, 0.01, 0), (72, 0.001, 0.05)):
    angle = math.radians(falling)
    wedge = geometry([(-2, -2 * math.tan(angle)), (2, -2 * math.tan(angle)), (0, 0)], "base, flank, flank")
    forces = []
    for between in (("disc:rim", "wedge:flank"), ("wedge:flank", "disc:rim")):
        name = "disc on a wedge of %d degrees, %s first" % (falling, between[0])
        last, points, _ = run(name, [body("disc", HALF, E, held("top", 0, -0.005)), body("wedge", wedge, E, BASE)],
                              between, keys(Strategy="Graded hp", Tolerance=tolerance))
        claim(abs(last[0]["contact_x"]) < 1e-10 * force(last),
              "on an apex contact_x is %.1e of %.4g" % (last[0]["contact_x"], force(last)))
        forces.append(force(last))
        # a level without contact tells of it as if it had found it, and the next one finds it
        falls = [row["estimate"] for row in rows(name, "history.csv") if row["estimate_relative"] > tolerance]
        claim(len(falls) < 20 and all(b < a for a, b in zip(falls, falls[1:])),
              "on an apex estimates fall: %s" % falls)
        limit = E / (1 - 0.3 ** 2) * (math.cos(angle) if between[0] == "wedge:flank" else 1)
        claim((1 - within if within else 0.4) < peak(points) / limit < 1.001,
              "on an apex the pressure tends to %.6g: %.6g" % (limit, peak(points)))
    # either sees along the disc's normals; along those of the flanks it was 2 to 8 % more
    claim(near(*forces, 3e-4), "on an apex either side may come first: %s" % forces)

# A wedge's tip on the middle of a flat side, which gets a node there: without it degrees rose for 40 levels.
STEEP = math.sqrt(3)
forces = []
for between in (("tip:flank", "block:top"), ("block:top", "tip:flank")):
    name = "tip on a block, %s first" % between[0]
    forces.append(force(run(name, [
        body("tip", geometry([(0, 0), (1, STEEP), (-1, STEEP)], "flank, top, flank"), E, held("top", 0, -0.004)),
        body("block", BLOCK, E, BASE)], between, keys(Strategy="Graded hp", Tolerance=0.01), size=0.77)[0]))
    levels = rows(name, "history.csv")
    claim(levels[-1]["estimate_relative"] <= 0.01 and len(levels) < 25,
          "%s: within 0.01 on %d levels" % (name, len(levels)))
claim(near(abs(forces[0]), abs(forces[1]), 1e-3), "a tip on a block, either side first: %s" % forces)

# The tip of a wedge in a hollow, where the direction turns fast: energies are by the same rule as forces.
HOLLOW = geometry([(-2.5, -2.75), (2.5, -2.75), (2.5, 0.25), (-2.5, 0.25)], "base, side, way, side",
                  [0, 0, -0.1, 0])
TIP = geometry([(0.017, 1.14e-5), (1.243, 1.5), (-1.209, 1.5)], "flank, top, flank")
for degree in (1, 3):
    run("tip in a hollow, p = %d" % degree, [
        body("tip", TIP, E, held("top", 0.004, -0.026)), body("hollow", HOLLOW, E, BASE)],
        ("tip:flank", "hollow:way", friction(0.1)), keys(Strategy="None"), size=0.15, degree=degree)

# Two equal domes, slid: what they part by is left out and told of.
DOME = [0.2, 0, 0, 0]
UP = geometry([(-1, 0.2), (1, 0.2), (1, 2), (-1, 2)], "arc, side, base, side", DOME)
LOW = geometry([(1, -0.2), (-1, -0.2), (-1, -2), (1, -2)], "arc, side, base, side", DOME)
domes = []
for between, by in ((("up:arc", "low:arc"), 0.1), (("low:arc", "up:arc"), 0.1),
                    (("up:arc", "low:arc"), 0)):
    last, _, text = run("domes slid by %g, %s first" % (by, between[0]), [
        body("up", UP, E, held("base", by, -0.01)), body("low", LOW, E, BASE)], between,
        keys(Tolerance=0.01))
    domes.append(force(last))
    claim(("convex sides part" in text) == (by > 0), "a warning where convex sides slide")
claim(near(domes[1], domes[0], 3e-3) and near(domes[2], domes[0], 1e-3),
      "slid domes are pressed as at rest in either order: %s" % domes)

# What nothing holds is still found.
for fix in ("X", "Rotation"):
    code, text = epafi("run", saved("free", keys(
        listed("Bodies", body("disc", geometry(circle(1, 0, 1), ["rim"] * 4, QUARTERS), E, fix=fix,
                              inside=listed("Body Loads", Force_Y=-1)),
               body("block", BLOCK, E, BASE)),
        listed("Contacts", contact("c", "disc:rim", "block:top")),
        listed("Discretization", Mesh_Size=0.3)), "free"))
    claim(code == 1, "a disc held in %s alone is refused: %s" % (fix, text[:200]))
# A block that rests aslant on a few elements over a bump, its turn fixed: what Fix does through the
# stabilisation beside pressures along a turning direction is what it does in the equations, or 3e-9 of
# the virtual work would be missing, which ends a run.
solved("aslant", saved("aslant", keys(
    listed("Bodies",
           body("block", geometry([(-0.02, 0), (1, 0), (1, 1.3), (-0.02, 1.3)], "face, side, far, side"), 1,
                condition("far", "Neumann", Traction_Y=-1e-4), "X, Rotation",
                listed("Mesh", Elements_per_Edge=[5, 2, 4, 2], Degree=3)),
           listed("bump", listed("Material", Rigid=True),
                  geometry([(1, -0.176), (-1, -0.176), (-1, -2), (1, -2)], ["all"] * 4,
                           [0.176, 0, 0, 0]))),
    listed("Contacts", contact("joint", "block:face", "bump:all")),
    listed("Discretization", Degree=3), listed("Adaptivity", Strategy="None")), "Aslant"))

finish()
