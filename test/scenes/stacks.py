"""A stack, whose load comes from block to block: those between are held by friction alone."""
from runs import claim, differ, finish, levels, rows, solved
from written import CLAMPED, NONE, block, body, condition, contact, friction, keys, written

COUNT, DOWN, ASIDE = 10, 1e-3, 1e-5


def storey(k):
    held = condition("bottom", "Dirichlet", CLAMPED) if k == 0 else NONE
    loaded = condition("top", "Neumann", Traction_X=ASIDE, Traction_Y=-DOWN) if k == COUNT - 1 else NONE
    return body("b%d" % k, block(0, k, 1, k + 1), 1.0, held + loaded)


stack = written("stack", [storey(k) for k in range(COUNT)], keys(*(
    contact("c%d" % k, "b%d:bottom" % k, "b%d:top" % (k - 1), friction("0.5"))
    for k in range(1, COUNT))), "Density", 1 / 8)
energy = None
for iteration in ("Newton", "Inexact Fixed Point", "Fixed Point"):
    folder, _ = solved(iteration, stack, *levels(1), "Solver->Coulomb Iteration=" + iteration)
    row, = rows(folder, "history.csv")
    energy = energy or row["energy_strain"]
    off = 0
    for own in rows(folder, "bodies.csv"):
        carried = {"b0": 1, "b%d" % (COUNT - 1): -1}.get(own["body"], 0)
        off = max(off, abs(own["contact_x"] - ASIDE * carried), abs(own["contact_y"] + DOWN * carried))
    claim(off < 1e-10 * DOWN and differ(row["energy_strain"], energy) < 1e-8,
          "a stack of %d, %s: in %d steps, forces to %.1e of the load" % (
              COUNT, iteration, row["newton_iterations"], off / DOWN))
finish()
