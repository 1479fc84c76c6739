"""Stacks and a wall, whose load comes from block to block: those between are held by friction alone."""
from runs import claim, differ, finish, levels, rows, solved
from written import CLAMPED, NONE, block, body, condition, contact, friction, geometry, keys, written

DOWN = 1e-3


def stack(count, aside, name):
    def storey(k):
        held = condition("bottom", "Dirichlet", CLAMPED) if k == 0 else NONE
        loaded = condition("top", "Neumann", Traction_X=aside, Traction_Y=-DOWN) if k == count - 1 else NONE
        return body("b%d" % k, block(0, k, 1, k + 1), 1.0, held + loaded)

    return written(name, [storey(k) for k in range(count)], keys(*(
        contact("c%d" % k, "b%d:bottom" % k, "b%d:top" % (k - 1), friction("0.5"))
        for k in range(1, count))), "Density", 1 / 8)


def off(folder, count, aside):
    """Largest error of the contact forces on the blocks of a stack, over the load."""
    largest = 0
    for own in rows(folder, "bodies.csv"):
        carried = {"b0": 1, "b%d" % (count - 1): -1}.get(own["body"], 0)
        largest = max(largest, abs(own["contact_x"] - aside * carried), abs(own["contact_y"] + DOWN * carried))
    return largest / DOWN


COUNT, ASIDE = 10, 1e-5
energy = None
for iteration in ("Newton", "Inexact Fixed Point", "Fixed Point"):
    folder, _ = solved(iteration, stack(COUNT, ASIDE, "stack"), *levels(1), "Solver->Coulomb Iteration=" + iteration)
    row, = rows(folder, "history.csv")
    energy = energy or row["energy_strain"]
    error = off(folder, COUNT, ASIDE)
    claim(error < 1e-10 and differ(row["energy_strain"], energy) < 1e-8,
          "a stack of %d, %s: in %d steps, forces to %.1e of the load" % (
              COUNT, iteration, row["newton_iterations"], error))

# D is a sum over bodies here; the start closes all joints, whatever their number
for count in (30, 60):
    folder, _ = solved("stack of %d" % count, stack(count, 1e-6, "stack of %d" % count), *levels(1))
    row, = rows(folder, "history.csv")
    error = off(folder, count, 1e-6)
    claim(error < 1e-10 and row["newton_iterations"] <= 3,
          "a stack of %d: in %d steps, forces to %.1e of the load" % (count, row["newton_iterations"], error))

# each body in a tree of its own
folder, _ = solved("compressed", stack(20, 1e-6, "stack of 20"), *levels(1), "Solver->Linear->Method=Compressed")
row, = rows(folder, "history.csv")
folder, _ = solved("dense", stack(20, 1e-6, "stack of 20"), *levels(1), "Solver->Linear->Method=Dense")
dense, = rows(folder, "history.csv")
claim(differ(row["energy_strain"], dense["energy_strain"]) < 1e-9 and row["newton_iterations"] <= 3,
      "a compressed stack of 20: energy to %.1e" % differ(row["energy_strain"], dense["energy_strain"]))


def wall(size):
    """Bricks of 2 x 1 in running bond, each half of a side on one of the bricks below; the lowest row is
    clamped, the highest loaded."""
    starts = [[max(2 * k - row % 2, 0) for k in range(size + row % 2)] for row in range(size)]
    ends = [begin[1:] + [2 * size] for begin in starts]
    bodies, contacts = [], []
    for row in range(size):
        for k, (x, end) in enumerate(zip(starts[row], ends[row])):
            middle = [x + 1] if end - x == 2 else []
            names = ["b%d" % i for i in range(x, end)] + ["right"] + ["t%d" % i for i in reversed(range(x, end))]
            corners = [(c, row) for c in [x] + middle + [end]] + [(c, row + 1) for c in [end] + middle + [x]]
            held = [condition("b%d" % i, "Dirichlet", CLAMPED) for i in range(x, end) if row == 0]
            loaded = [condition("t%d" % i, "Neumann", Traction_X=1e-6, Traction_Y=-DOWN)
                      for i in range(x, end) if row == size - 1]
            bodies.append(body("r%d-%d" % (row, k), geometry(corners, names + ["left"]), 1.0,
                               keys(*held, *loaded)))
            for i in range(x, end) if row > 0 else ():
                below = next(j for j, last in enumerate(ends[row - 1]) if i < last)
                contacts.append(contact("c%d-%d" % (row, i), "r%d-%d:b%d" % (row, k, i),
                                        "r%d-%d:t%d" % (row - 1, below, i), friction("0.5")))
    return written("wall", bodies, keys(*contacts), "Density", 1 / 4)


SIZE = 5
folder, _ = solved("wall", wall(SIZE), *levels(1))
row, = rows(folder, "history.csv")
claim(differ(row["reaction_y"], 2 * SIZE * DOWN) < 1e-10 and row["newton_iterations"] <= 3,
      "a wall of %d rows: in %d steps, it carries %.12g of its load" % (
          SIZE, row["newton_iterations"], row["reaction_y"] / (2 * SIZE * DOWN)))
finish()
