"""Law "Tied": bonded bodies carry tension and shear, and are as one."""
from runs import claim, differ, finish, largest, rows, run
from written import (CLAMPED, NONE, TIED, block, body, condition, contact, disc, friction, geometry, keys, listed,
                     mesh, rigid, round_hole, written)

PULL = condition("top", "Neumann", Traction_Y="1")
ROLLER = condition("bottom", "Dirichlet", Displacement_Y="0")
CLAMP = condition("left", "Dirichlet", CLAMPED)
GIVEN = keys(Interference=-0.002)


def boundary(name, where):
    return [row for row in rows(name, "boundary.csv") if row["boundary"] == where]


# constant tension through meshes and degrees that do not match, and a given jump
for form in ("None", "Projected", "Exact", "Density"):
    for sides in (("a:bottom", "b:top"), ("b:top", "a:bottom")):
        file = written("pulled", [
            body("a", block(0, 0, 1, 1), 1.0, PULL, "X, Rotation", mesh(5, 2, 1), 0.0),
            body("b", block(0, -1, 1, 0), 5.0, ROLLER, "X", mesh(7, 2, 3), 0.0)],
            contact("c", *sides, TIED + GIVEN), form)
        points = run(file, "pulled")[1]
        claim(largest(p["lambda_n"] + 1 for p in points) < 1e-12,
              "constant tension, Form %s, first %s" % (form, sides[0]))
        claim(all(p["contact"] == p["friction"] == 1 for p in points), "closed and stuck")
        claim(largest(row["uy"] - 1.198 for row in boundary("pulled", "a:top")) < 1e-12,
              "its displacement, jump included")

# cut in two and tied again
LOAD = condition("right", "Neumann", Traction_X="0.1", Traction_Y="0.02*y")
for form in ("Projected", "Density"):
    for all_of_it, above, below, bound in (
            (mesh(10, 10, 3), mesh(10, 5, 3), mesh(10, 5, 3), 2e-8),
            (mesh(8, 8, 3), mesh(10, 4, 2), mesh(7, 4, 4), 2e-5)):
        whole = run(written("whole", [body("w", block(0, -1, 2, 1), 1.0, CLAMP + LOAD,
                                           mesh=all_of_it)], form="Density"), "whole")[0][0]
        end = boundary("whole", "right")
        energies = []
        for sides in (("a:bottom", "b:top"), ("b:top", "a:bottom")):
            file = written("halves", [
                body("a", block(0, 0, 2, 1), 1.0, CLAMP + LOAD, mesh=above),
                body("b", block(0, -1, 2, 0), 1.0, CLAMP + LOAD, mesh=below)],
                contact("glue", *sides, TIED), form)
            row = run(file, "halves")[0][0]
            energies.append(row["energy_strain"])
            claim(differ(row["energy_strain"], whole["energy_strain"]) < bound,
                  "a block cut in two and tied has the energy of the whole, %s" % form)
            claim(row["newton_iterations"] == 1, "one step solves what is linear")
        claim(differ(*energies) < bound, "either side first")
        if bound < 1e-6:
            halves = boundary("halves", "b:right") + boundary("halves", "a:right")
            claim(largest(p["uy"] - q["uy"] for p, q in zip(halves, end)) < 1e-6,
                  "and its displacements")

# coatings of the material that they lie on, far thinner than what a layer bends by alone
PRESSED = condition("face", "Neumann", Traction_X="5e-4*x*(1-x^2)^2", Traction_Y="-1e-3*(1-x^2)^2")


def layers(name, heights, weak=(), base=condition("base", "Dirichlet", Displacement_Y=0), size=0.2, degree=8):
    """Blocks of 2 on each other, tied; the lowest one rests on rollers, the highest is loaded."""
    bodies, ties = [], []
    for k, (low, high) in enumerate(zip(heights, heights[1:])):
        first, last = k == 0, k == len(heights) - 2
        bodies.append(body("b%d" % k, geometry(block(-1, low, 1, high), [
            "base" if first else "under", "side", "face" if last else "over", "side"]), 1.0,
            (base if first else NONE) + (PRESSED if last else NONE),
            "X" if first else ""))
        if k > 0:
            pair = ("b%d:under" % k, "b%d:over" % (k - 1))
            ties.append(contact("tie%d" % k, *(pair[::-1] if k in weak else pair), TIED))
    return written(name, bodies, keys(*ties), "Density", size, degree)


for height in (2e-3, 2e-4, 2e-5):
    whole = run(layers("whole", (-1, height)), "whole")[0][0]["energy_strain"]
    for name, file in (("a coating", layers("coating", (-1, 0, height))),
                       ("the substrate's multiplier", layers("coating", (-1, 0, height), (1,))),
                       ("two layers", layers("coating", (-1, 0, height / 2, height))),
                       ("a layer between blocks", layers("coating", (-1, -0.5, height - 0.5, height)))):
        row = run(file, "coating")[0][0]
        error = differ(row["energy_strain"], whole)
        claim(error < 1e-8 and row["newton_iterations"] == 1,
              "%s, %g of the width thick, as one block: %.1e" % (name, height / 2, error))

# compressed, with more coefficients than D is formed of for their sake: for that of the beddings it is
SLIDING = condition("base", "Contact", friction("0.3"), Gap="0.001*x^2")
pressed = layers("coated", (-1, 0, 2e-4, 4e-4), base=SLIDING, size=0.03, degree=2)
dense, compressed = (run(pressed, method, ["Solver->Linear->Method=" + method])[0][0]
                     for method in ("Dense", "Compressed"))
claim(compressed["dof_multiplier"] > 1000 and differ(compressed["energy_strain"], dense["energy_strain"]) < 1e-7,
      "two layers on a block with friction, compressed: %.1e" % differ(compressed["energy_strain"],
                                                                      dense["energy_strain"]))

# jumps: a uniform dislocation across a whole cut moves one part, a misfit is Lame's
for form in ("None", "Projected", "Exact", "Density"):
    for first in ("inner", "outer"):
        sign = 1 if first == "inner" else -1  # of n and of u - u_B
        sides = ("inner:rim", "outer:bore") if sign > 0 else ("outer:bore", "inner:rim")
        jump = keys(Interference="-(0.003 * nx - 0.002 * ny) * %d" % sign,
                    Sliding="(-0.003 * ny - 0.002 * nx) * t * %d" % sign)
        inner = body("inner", disc(1, "rim"), 1.0)
        held = body("outer", disc(2, "edge", holes=round_hole(1, "bore")), 3.0,
                    condition("edge", "Dirichlet", CLAMPED))
        row, points = run(written("moved", [inner, held], contact("cut", *sides, TIED + jump), form,
                                  degree=4), "moved")
        claim(row[0]["energy_strain"] < 1e-24 and largest(p["lambda_n"] for p in points) < 1e-11,
              "a dislocation across a whole round cut has no stress, Form %s, first %s" % (form, first))
        claim(largest(p["ux"] - 0.003 for p in boundary("moved", "inner:rim")) < 1e-12 and
              largest(p["uy"] + 0.002 for p in boundary("moved", "inner:rim")) < 1e-12,
              "what it surrounds moves by it")
        if form in ("None", "Exact"):
            continue
        for misfit in (0.002, -0.002):
            row, points = run(written("misfit", [
                body("inner", disc(1, "rim"), 1.0, fix="X, Y, Rotation"),
                body("outer", disc(2, "edge", holes=round_hole(1, "bore")), 1.0)],
                contact("cut", *sides, TIED + keys(Interference=misfit)), form, degree=8), "misfit")
            pressure = misfit / (1.3 * ((0.4 + 4) / 3 + 0.4))
            error = largest(p["lambda_n"] / pressure - 1 for p in points)
            claim(error < (1e-8 if form == "Density" else 1e-6),
                  "a misfit of %g, Form %s, first %s: %.1e" % (misfit, form, first, error))

# a coat on a block that slides on an obstacle
FLOOR = condition("bottom", "Contact", friction("0.3"), Gap="0.01*x^2")
PRESS = condition("top", "Neumann", Traction_X="0.004", Traction_Y="-0.02")
one = run(written("one", [body("w", block(-1, 0, 1, 1.2), 1.0, FLOOR + PRESS,
                               mesh=mesh(8, 4, 3))], form="Density"), "one")[0][0]
for iteration in ("Newton", "Fixed Point", "Inexact Fixed Point"):
    row = run(written("coated", [
        body("coat", block(-1, 0, 1, 0.2), 1.0, FLOOR, mesh=mesh(8, 1, 3)),
        body("block", block(-1, 0.2, 1, 1.2), 1.0, PRESS, mesh=mesh(8, 4, 3))],
        contact("glue", "coat:top", "block:bottom", TIED), "Density"), "coated",
        ["Solver->Coulomb Iteration=" + iteration])[0][0]
    claim(differ(row["energy_strain"], one["energy_strain"]) < 1e-4 and
          differ(row["contact_length"] - 2, one["contact_length"]) < 1e-6 and
          differ(row["slip_length"], one["slip_length"]) < 1e-6,
          "a coat of the block's own material does not show, " + iteration)

# tied to what is rigid: it follows
file = written("carried", [
    body("a", block(0, 0, 1, 0.5), 1.0, mesh=mesh(4, 2, 1)),
    rigid("floor", block(-1, -1, 2, 0), listed("Motion", Rotation=0.01, Displacement_X=0.02))],
    contact("c", "a:bottom", "floor:top", TIED), "Density")
points = run(file, "carried")[1]
claim(largest(p["lambda_n"] for p in points) < 1e-12, "a body tied to a rigid one goes with it")
claim(largest(row["ux"] - 0.02 + 0.01 * (row["y"] + 0.5)
              for row in boundary("carried", "a:top")) < 1e-12, "turned with it, too")
GLUED = condition("bottom", "Contact", TIED, Gap="0.01")
HELD = condition("top", "Dirichlet", Displacement_Y="0")
points = run(written("glued", [body("a", block(0, 0, 1, 0.5), 1.0, GLUED + HELD,
                                    mesh=mesh(4, 2, 1), ratio=0.0)], form="Density"), "glued")[1]
claim(largest(p["lambda_n"] + 0.02 for p in points) < 1e-12,
      "glued to an obstacle at a distance: as far as that")
finish()
