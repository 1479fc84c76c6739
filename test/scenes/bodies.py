"""Several bodies: patch tests with either side first, mirror images, rigid outlines, balance,
swapped sides, restart, loads that nothing holds."""

from runs import (RANKS, balanced, claim, epafi, finish, fresh, goes_on, largest, rows, run, scene)
from written import (CLAMPED, NONE, block, body, condition, contact, disc, friction, geometry, listed,
                     mesh, rigid, round_hole, written)


PRESS = condition("top", "Neumann", Traction_Y="-1")
ROLLER = condition("bottom", "Dirichlet", Displacement_Y="0")
CLAMP = condition("bottom", "Dirichlet", CLAMPED)

# constant stress on meshes and degrees that do not match; ranks compute dense levels each by itself
for form in ("None", "Projected", "Exact", "Density")[::1 if RANKS == 1 else 3]:
    for sides in (("a:bottom", "b:top"), ("b:top", "a:bottom")):
        for above, below in (((4, 1), (7, 3)), ((5, 3), (3, 1))):
            file = written("patch", [
                body("a", block(0, 0, 1, 1), 1.0, PRESS, "X, Rotation",
                     mesh(above[0], 2, above[1])),
                body("b", block(0, -1, 1, 0), 5.0, ROLLER, "X",
                     mesh(below[0], 2, below[1]), 0.2)], contact("c", *sides), form)
            history, points = run(file, "patch")
            claim(largest(p["lambda_n"] - 1 for p in points) < 1e-12,
                  "patch test, Form %s, first %s, %s on %s" % (form, sides[0], above, below))
            # uniaxial: the strain of each times its height 1
            expected = -(1 - 0.3**2) / 1 - (1 - 0.2**2) / 5
            claim(largest(row["uy"] - expected for row in rows("patch", "boundary.csv")
                          if row["boundary"] == "a:top") < 1e-12, "its displacement")
            balanced("patch")

# 1 mm beside 1 m, rubber on steel
file = written("small", [
    body("a", block(0, 0, 1e-3, 1e-3), 1e6, condition("top", "Neumann", Traction_Y="-1e3"),
         "X, Rotation", mesh(3, 2, 2)),
    body("b", block(-0.5, -1, 0.5, 0), 2.1e11, CLAMP, mesh=mesh(4, 4, 2))],
    contact("c", "a:bottom", "b:top"))
history, points = run(file, "small")
claim(largest(p["lambda_n"] / 1e3 - 1 for p in points) < 2e-5,
      "rubber of 1 mm on steel of 1 m: pressure as on a rigid plane up to E_1/E_2")
balanced("small")

# a mirror image is a rigid frictionless plane at half the approach
TOP = condition("top", "Dirichlet", Displacement_X="0", Displacement_Y="-0.02*(1+0.3*x)")
BOTTOM = condition("bottom", "Dirichlet", Displacement_X="0",
                   Displacement_Y="0.02*(1+0.3*x)")
PLANE = condition("bottom", "Contact", Gap="0")
file = written("mirror", [
    body("a", block(0, 0, 1, 0.5), 1.0, TOP, mesh=mesh(8, 4, 2)),
    body("b", block(0, -0.5, 1, 0), 1.0, BOTTOM, mesh=mesh(8, 4, 2))],
    contact("c", "a:bottom", "b:top", friction("0.3")))
both = run(file, "mirror")[1]
file = written("plane", [body("a", block(0, 0, 1, 0.5), 1.0, TOP + PLANE,
                              mesh=mesh(8, 4, 2))])
alone = run(file, "plane")[1]
scale = largest(p["lambda_n"] for p in alone)
claim(largest(p["lambda_n"] - q["lambda_n"] for p, q in zip(both, alone)) < 1e-9 * scale,
      "two mirror images press like one of them on a rigid frictionless plane")

# one body on a rigid outline, held and moved, and the same by Gap
PUSH = condition("top", "Neumann", Traction_Y="-0.02", Traction_X="0.001")
for motion, gap in ((NONE, "0.01*x^2"), (listed("Motion", Displacement_Y=0.004), "0.01*x^2-0.004")):
    file = written("floor", [body("a", block(0, 0, 1, 0.5), 1.0, PUSH, mesh=mesh(8, 4, 2)),
                             rigid("floor", block(-1, -1, 2, 0), motion)], contact(
        "c", "a:bottom", "floor:top", friction("0.4"), Interference="-0.01*x^2"), "Projected")
    history, onFloor = run(file, "floor")
    file = written("gap", [body("a", block(0, 0, 1, 0.5), 1.0,
                                PUSH + condition("bottom", "Contact", friction("0.4"), Gap=gap),
                                mesh=mesh(8, 4, 2))], form="Projected")
    other, onGap = run(file, "gap")
    scale = largest(p["lambda_n"] for p in onGap)
    claim(largest(p[key] - q[key] for p, q in zip(onFloor, onGap)
                  for key in ("lambda_n", "lambda_t")) < 1e-10 * scale,
          "a rigid outline is an obstacle at the same distance" + (", moved" if motion else ""))
    claim(abs(history[0]["contact_y"] - other[0]["contact_y"]) < 1e-12,
          "history.csv has the force of a rigid body as that of an obstacle")

# a pin in a lug, on coarse arcs of low degree: what is met turns as a rigid body, too
lug = body("lug", geometry(block(-3, -3, 3, 3), holes=round_hole(1, "s")), 1.0,
           condition("left", "Dirichlet", CLAMPED))
pin = body("pin", disc(0.99, "s", holes=round_hole(0.5, "in")), 3.0,
           condition("in", "Neumann", Traction_X="1e-2", Traction_Y="1e-3"), "Rotation")
for k, form in enumerate(("Projected", "Exact", "Density", "None")):
    for degree in (1, 2):
        sides = ("pin:s", "lug:s")[::(-1) ** (k + degree)]
        run(written("pin", [lug, pin], contact("c", *sides, friction("0.2")), form, 0.8, degree), "pin")
        balanced("pin")

# partly covered sides, either first; the resultants are those of the load
pad = body("a", block(0.3, 0, 0.85, 0.5), 1.0, PUSH, mesh=mesh(6, 4, 2))
plate = body("b", block(0, -1, 1, 0), 2.0, CLAMP, mesh=mesh(5, 4, 2))
lengths = []
for sides in (("a:bottom", "b:top"), ("b:top", "a:bottom")):
    file = written("covered", [pad, plate], contact("c", *sides, friction("0.5")),
                   "Projected")
    history, points = run(file, "covered")
    balanced("covered")
    claim(abs(history[0]["force_normal"] - 0.011) < 1e-10, "and carry the load")
    claim(all(0.3 < p["x"] < 0.85 for p in points), "where nothing is opposite nothing presses")
    claim(abs(history[0]["contact_y"]) < 1e-12, "contact between bodies cancels in history.csv")
    lengths.append(history[0]["energy_strain"])
claim(abs(lengths[0] / lengths[1] - 1) < 0.02, "either side first: alike on a coarse mesh")

# drawn flush but for a digit: no element of that width, across which tractions would be unbounded
flush = []
for wider in (0, 1e-8):
    flush += run(written("flush", [
        body("a", block(0, 0, 1, 1), 1.0, PRESS, mesh=mesh(4, 4, 2)),
        body("b", block(0, -1, 1 + wider, 0), 2.0, CLAMP, mesh=mesh(4, 4, 2))],
        contact("c", "a:bottom", "b:top", friction("0.5")), "Projected"), "flush")[0]
claim(flush[0]["elements"] == flush[1]["elements"] and
      abs(flush[1]["estimate"] / flush[0]["estimate"] - 1) < 1e-6,
      "a block wider by 1e-8 has the mesh and the estimate of a flush one")

# a wedge on a foot of a millionth of its size, which alone holds its rotation
FOOT = 5e-7
wedge = geometry([(-FOOT, 0), (FOOT, 0), (0.5, 0.5), (0.5, 1), (-0.5, 1), (-0.5, 0.5)],
                 "foot, side, side, top, side, side")
history, points = run(written("foot", [
    body("wedge", wedge, 2.0, condition("top", "Neumann", Force_Y=-1e-8)),
    body("base", block(-1, -1, 1, 0), 1.0, CLAMP)],
    contact("c", "wedge:foot", "base:top", friction("0.5")), "Projected"), "foot")
claim(abs(history[0]["force_normal"] / 1e-8 - 1) < 1e-6, "a foot of a millionth holds a wedge")

# refinement over both bodies; a run that goes on gives the same digits
shipped = scene("two-blocks.xml")
levels = rows(goes_on("two bodies", shipped, ["Adaptivity->Maximum Levels=4"],
                      ["Adaptivity->Maximum Levels=2"], 0)[0], "history.csv")
claim(levels[-1]["estimate"] < 0.75 * levels[0]["estimate"], "the estimate falls")
claim(epafi("check", shipped)[0] == 0, "epafi check")

# both sides are graded alike toward where contact ends
run(shipped, "graded")
sizes = {}
for row in rows("graded", "boundary.csv"):
    sizes.setdefault((row["boundary"], row["element"]), []).append(row["x"])
for sign in (-1, 1):
    ends = [min(max(x) - min(x) for (boundary, _), x in sizes.items()
                if boundary == side and max(sign * place for place in x) < 0.5001 and
                max(sign * place for place in x) > 0.4999)
            for side in ("pad:bottom", "plate:top")]
    claim(abs(ends[0] / ends[1] - 1) < 1e-3, "elements of %.3g and %.3g meet at x = %g" % (
        *ends, 0.5 * sign))

# twelve elements on each third of three, four and a half beside them: as many left as right
run(written("halves", [
    body("a", block(-0.5, 0, 0.5, 1), 1.0, PRESS, "X, Rotation", mesh(4, 2, 1)),
    body("b", block(-2, -1, 2, 0), 5.0, CLAMP, mesh=mesh(12, 2, 1))],
    contact("c", "a:bottom", "b:top")), "halves")
middles = {}
for row in rows("halves", "boundary.csv"):
    if row["boundary"] == "b:top":
        middles.setdefault(row["element"], []).append(row["x"])
left, right = (sum(sign * sum(x) > 0.5 * len(x) for x in middles.values()) for sign in (-1, 1))
claim(left == right == 5, "%d elements left of the contact, %d right of it" % (left, right))

# a bulge far below rounding is none
flat = [run(shipped, "flat", ["Adaptivity->Maximum Levels=1",
                              "Bodies->pad->Geometry->Bulges={0, %g, 0, 0}" % bulge])[0][0][
                                  "estimate"] for bulge in (0, 1e-16, 1e-160, 1e-300)]
claim(largest(estimate / flat[0] - 1 for estimate in flat) < 1e-10, "bulges of nothing: %s" % flat)

# what no contact holds is named
PAD = "Bodies->pad->Boundary Conditions->top={Type=Neumann, Traction X=%g, Traction Y=%g}"
PUNCH = "Bodies->punch->Motion={Force Y=%s, Moment=%s}"
SHORT = ("History->Times={1}", "History->Steps={1}", "History->Minimum Step=1")
for file, settings, code, words in (
        ("two-blocks", [PAD % (0, 1)], 2, "drives Bodies->pad in the direction (0, 1)"),
        ("two-blocks", [PAD % (1, -1)], 2, "slides Bodies->pad in the direction (1, 0)"),
        ("two-blocks", [PAD.replace("%g}", "-0.01*(1+20*x)}") % 0], 2, "turns Bodies->pad about ("),
        ("tilting-punch", [PUNCH % (1, 0), *SHORT], 3, "drives Bodies->punch in the direction (0, 1)"),
        ("tilting-punch", [PUNCH % (-1, 3), *SHORT], 3, "turns Bodies->punch")):
    done, text = epafi("run", scene(file + ".xml"), "--output", fresh("unheld"), settings=settings)
    claim(done == code and "the load " + words in text and "neither contact nor friction" in text
          and "of a rigid body a Displacement or a Rotation" in text,
          "%s %s: exit %d, %s" % (file, settings[0], done, text.splitlines()[-1]))

# a force on one of the bodies, from a constant
TOP = "Bodies->pad->Boundary Conditions->top"
run(scene("two-blocks.xml"), "force", [
    "Constants->push=0.0075", TOP + "={Type=Neumann, Force X=0.2*push, Force Y=-2*push*t}",
    "Bodies->pad->Geometry->Vertices=4x2:{-0.5,0, 0.5,0, 0.25,0.5, -0.5,0.5}"])
for row in rows("force", "bodies.csv"):
    if row["body"] == "pad":
        claim(abs(row["load_x"] - 0.0015) < 1e-15 and
              abs(row["load_y"] + 0.015) < 1e-15, "the load is the force")
balanced("force")
finish()
