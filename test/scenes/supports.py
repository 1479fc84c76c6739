"""Displacement Normal: supports along normals of straight and curved edges, against closed forms and
against rollers along the axes."""
import math

from runs import (balanced, claim, differ, epafi, finish, goes_on, largest, levels, refused,
                  rows, run, steps)
from written import (CLAMPED, NONE, QUARTERS, block, body, condition, contact, disc, geometry, history, keys,
                     listed, rigid, round_hole, written)

FORMS = ("Density", "Projected", "Exact", "None")
NU, E = 0.3, 1.0
MU = E / (2 * (1 + NU))


def support(boundary, value=0, **loads):
    return condition(boundary, "Dirichlet", keys(Displacement_Normal=value), **loads)


def turned(corners, angle):
    c, s = math.cos(angle), math.sin(angle)
    return [(c * x - s * y, s * x + c * y) for x, y in corners]


def of(name, boundary):
    return [row for row in rows(name, "boundary.csv") if row["boundary"].endswith(boundary)]


# a wedge between smooth walls under pressure: -p everywhere, and the walls may give way
p, half = 0.02, 0.35
tip = [(0, 0), (math.tan(half), 1), (-math.tan(half), 1)]
shrinks = p * (1 + NU) * (1 - 2 * NU)
for form in FORMS:
    for give in (0, 0.01):
        row, reactions = run(written("wedge", [body("w", geometry(tip, "right, top, left"), E, support(
            "right", give) + support("left", give) + condition("top", "Neumann", Pressure=p))],
            form=form, degree=1), "wedge")
        claim(largest(q["lambda_n"] / p - 1 for q in reactions) < 1e-11,
              "a wedge in a smooth channel, Form %s, walls that give by %g" % (form, give))
        claim(largest(q["uy"] + shrinks * q["y"] + give / math.sin(half)
                      for q in rows("wedge", "boundary.csv")) < 1e-12, "its displacement")
        claim(differ(row[0]["reaction_y"], 2 * p * math.tan(half)) < 1e-11 and
              row[0]["contact_y"] == 0 and row[0]["contact_length"] == 0 and
              row[0]["newton_iterations"] == 1, "its walls react, nothing is in contact")

# a sheared block on an incline: the tangent is loaded, what of the load is normal goes into the support
tau, angle = 0.01, 0.4
along, up = turned([(1, 0)], angle)[0], turned([(0, 1)], angle)[0]
PULL = dict(Traction_X=-tau * along[0] + 0.03 * up[0], Traction_Y=-tau * along[1] + 0.03 * up[1])
TOP = dict(Traction_X=tau * along[0], Traction_Y=tau * along[1])
SIDES = (condition("right", "Neumann", Traction_X=tau * up[0], Traction_Y=tau * up[1]) +
         condition("left", "Neumann", Traction_X=-tau * up[0], Traction_Y=-tau * up[1]))
for form in FORMS:
    row, reactions = run(written("sheared", [body(
        "b", geometry(turned(block(0, 0, 2, 1), angle)), E,
        support("bottom", **PULL) + support("top", **TOP) + SIDES, "X")], form=form, degree=1), "sheared")
    claim(largest(q["lambda_n"] - (-0.03 if q["boundary"] == "bottom" else 0) for q in reactions) < 1e-12,
          "pure shear by loads along supports, Form %s" % form)
    claim(differ(row[0]["energy_strain"], tau ** 2 / MU) < 1e-11 and
          differ(row[0]["energy_load"], 2 * row[0]["energy_strain"]) < 1e-11, "its energies")

# a ring: its outer arc is moved along the normal (Lame), or held there and turned by tractions
a, b, d = 1, 2, 0.001
RING = disc(b, "outer", holes=round_hole(a, "inner"))
lame = E * NU / ((1 + NU) * (1 - 2 * NU))
slope = d / (b + (lame + MU) / MU * a * a / b)  # u = slope r + rest / r
rest = (lame + MU) / MU * a * a * slope
pressure = -2 * (lame + MU) * slope + 2 * MU * rest / b ** 2
for form, ratio, within in (("Density", NU, 1e-9), ("Projected", NU, 1e-6)):
    _, reactions = run(written("moved", [body("ring", RING, E, support("outer", d), "X, Y, Rotation")],
                               form=form, degree=8), "moved")
    error = largest(q["lambda_n"] / pressure - 1 for q in reactions)
    claim(error < within, "a ring moved along its normal, Form %s: %.1e" % (form, error))
    claim(largest(q["u_n"] / d - 1 for q in reactions) < within, "it is where it was moved to")
TURNED = dict(Traction_X="%g * -ny" % tau, Traction_Y="%g * nx" % tau)
row, reactions = run(written("turned", [body("ring", RING, E, support("outer", 0, **TURNED) +
                                             condition("inner", "Dirichlet", CLAMPED))],
                             form="Density", degree=8), "turned")
twist = tau * b ** 2 / (2 * MU)
claim(largest(q["lambda_n"] for q in reactions) < 1e-8 * tau, "a ring turned by its outer arc")
claim(largest(math.hypot(q["ux"], q["uy"]) / (twist * (b / a ** 2 - 1 / b)) - 1
              for q in of("turned", "outer")) < 1e-8, "its displacement")
claim(differ(row[0]["reaction_moment"], -2 * math.pi * b ** 2 * tau) < 1e-9, "and the clamp's moment")
_, reactions = run(written("cylinder", [body(
    "tube", geometry(block(a, 0, b, 1), "bottom, outer, top, inner"), E, support("outer", d) +
    support("bottom") + condition("top", "Dirichlet", Displacement_Y=0))], degree=8, form="Density",
    more=listed("Geometry", Type="Axisymmetric")), "cylinder")
claim(largest(q["lambda_n"] / pressure - 1 for q in reactions if q["boundary"] == "outer") < 1e-9,
      "a tube moved along its normal, as a solid of revolution")
QUARTER = geometry([(a, 0), (b, 0), (0, b), (0, a)], "bottom, outer, left, inner",
                   (0, QUARTERS[0], 0, -QUARTERS[0]))
_, reactions = run(written("soft", [body("ring", QUARTER, E, support("outer", d) + support("left") +
                                         condition("bottom", "Dirichlet", Displacement_Y=0), ratio=0.5)],
                           form="Density", degree=8), "soft")
error = largest(q["lambda_n"] / (2 / 3 * E * d * b * (1 / b ** 2 - 1 / a ** 2)) - 1
                for q in reactions if q["boundary"] == "outer")
claim(error < 1e-8, "a quarter of an incompressible one: %.1e" % error)

# supports along the axes are rollers; turned by an angle they hold the same
PUNCH = listed("Motion", Displacement_Y=-0.02)
DEEP = listed("Adaptivity", Strategy="Graded hp", Tolerance=0.003, Maximum_Degrees_of_Freedom=20000)


def pressed(name, angle, sides, solver=NONE, motion=PUNCH, path=NONE):
    """A block whose side is held on its lower half, under a punch."""
    outline = [(-1, -1), (1, -1), (1, 0), (-1, 0), (-1, -0.5)]
    return written(name, [
        body("b", geometry(turned(outline, angle), "bottom, right, top, left, guide"), E, sides),
        rigid("punch", turned(block(-0.3, 0, 0.3, 0.5), angle), motion)],
        contact("c", "b:top", "punch:bottom"), "Density", 0.5, more=DEEP + solver + path)


AXES = (condition("bottom", "Dirichlet", Displacement_Y=0) +
        condition("guide", "Dirichlet", Displacement_X=0))
HELD = support("bottom") + support("guide")
angle = math.pi / 7
DOWN = listed("Motion", Displacement_X=0.02 * math.sin(angle), Displacement_Y=-0.02 * math.cos(angle))
one = run(pressed("rollers", 0, AXES), "rollers")[0]
for name, turn, motion in (("supports", 0, PUNCH), ("turned-supports", angle, DOWN)):
    other = run(pressed(name, turn, HELD, motion=motion), name)[0]
    balanced(name)
    claim(differ(one[-1]["energy_strain"], other[-1]["energy_strain"]) <
          one[-1]["estimate_relative"] ** 2 + other[-1]["estimate_relative"] ** 2,
          "%s: the energy of rollers, %.1e" % (name, differ(
              one[-1]["energy_strain"], other[-1]["energy_strain"])))
    claim(other[-1]["dof_displacement"] < 1.25 * one[-1]["dof_displacement"] and
          other[-1]["estimate_relative"] <= 0.003, "with as many displacements, %d and %d" % (
              other[-1]["dof_displacement"], one[-1]["dof_displacement"]))
dense, squeezed = (run(pressed("by", angle, HELD, listed("Solver", Linear={"Method": method}), DOWN), "by",
                       ["Adaptivity->Maximum Levels=3"])[0][-1] for method in ("Dense", "Compressed"))
claim(differ(dense["energy_strain"], squeezed["energy_strain"]) < 1e-8, "compressed as dense")

# a path: what supports do from outside is stored
RAMP = support("outer", "%g*t" % d) + support("inner", "0", Traction_X="0.01*t*ny")
path = written("path", [body("ring", RING, E, RAMP, "Rotation")], form="Density", degree=4,
               more=history([1, 2], 2))
goes_on("path", path, levels(2), ["Adaptivity->Maximum Levels=1"])
last = steps("path, at once")[-1]
claim(differ(last["energy_outside"], last["energy_stored"]) < 1e-9, "a path stores what supports do")

# a half
energies = []
for whole in (True, False):
    corners = tip if whole else [(0, 0), (math.tan(half), 1), (0, 1)]
    row = run(written("half", [body("w", geometry(corners, "right, top, left" if whole else
                                                  "right, top, symmetry"), E, support("right") + (
        support("left") if whole else NONE) + condition("top", "Neumann", Traction_Y="-0.01*x^2"))],
        form="Density", degree=8, size=0.1, more=NONE if whole else listed("Geometry", Symmetry="X")), "half")[0][0]
    energies.append(row["energy_strain"])
claim(differ(*energies) < 1e-7, "half a wedge has the energy of the whole, %.1e" % differ(*energies))

# what is said of it
SIDE = body("a", block(0, 0, 1, 1), E, support("bottom"))
code, text = epafi("check", written("one", [body("a", block(0, 0, 1, 1), E, support(
    "bottom") + condition("left", "Dirichlet", Displacement_X=0))], form="Density"))
claim(code == 0 and "left bottom (normal)" in text and "contact     none" in text, "check tells of it")
refused("along the normal and along an axis", written("both", [body("a", block(0, 0, 1, 1), E, support(
    "bottom", Displacement_X=0))], form="Density"), "bottom->Displacement Normal", "in place of")
refused("a side in contact", written("pair", [SIDE, rigid("r", block(0, -1, 1, 0))], contact(
    "c", "a:bottom", "r:top"), "Density"), "bottom", "a side in contact has none")
refused("nothing holds along the support", written("free", [
    body("a", block(0, 0, 1, 1), E, support("bottom") + condition("left", "Neumann", Traction_X=1))],
    form="Density"), "in the direction (1, 0)", command="check")
refused("nothing turns back", written("spun", [body("ring", RING, E, support("outer", 0, **TURNED))],
                                      form="Density"), "turns", command="check")
code, text = epafi("check", written("corner", [body("a", block(0, 0, 1, 1), E, support(
    "bottom", 0.01) + condition("left", "Dirichlet", CLAMPED))], form="Density"))
claim(code == 0 and "'left' and 'bottom' prescribe different displacements" in text,
      "a corner that two sides hold apart is warned of")
finish()
