"""What must not matter: basis of the multiplier, form of the stabilisation; used.xml."""
import os

from runs import ENERGIES, WORK, claim, differ, finish, levels, run, scene


def agree(file, count, key, values, tolerance):
    """Energies of the last level, under each value of a key."""
    rows = [run(file, "variant", levels(count) + [key + "=" + value])[0][-1]
            for value in values]
    for value, row in zip(values[1:], rows[1:]):
        for energy in ENERGIES:
            error = differ(row[energy], rows[0][energy])
            # |u_t| over what sticks adds up the error of u_t without cancellation
            limit = 5 * tolerance if energy == "energy_friction" else tolerance
            claim(error < limit, "%s, %s and %s: the same %s (%.1e)" % (
                os.path.basename(file), values[0], value, energy, error))


bases = ["Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein",
         "Biorthogonal"]
for name in ("tresca.xml", "coulomb.xml"):
    agree(scene(name), 6, "Discretization->Multiplier", bases, 1e-4)
agree(scene("tresca.xml"), 4, "Discretization->Stabilization->Form",
      ["Projected", "Exact"], 1e-4)
agree(scene("coulomb.xml"), 2, "Discretization->Stabilization->Form",
      ["Projected", "Exact"], 1e-4)

history, contact = run(scene("tresca.xml"), "first", levels(2))
again, points = run(os.path.join(WORK, "first", "used.xml"), "again")
claim(contact == points, "used.xml repeats a run exactly")
finish()
