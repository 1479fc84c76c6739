"""The symmetric block under Coulomb friction, held by Fix = {X, Rotation}."""
from runs import ENERGIES, claim, differ, finish, levels, run, scene, whole

history, contact = run(scene("coulomb.xml"), "coulomb", levels(6))
for row in history:
    name = "level %d: " % row["level"]
    claim(row["status"] == "converged", name + "converged")
    claim(differ(row["force_normal"], 0.125) < 1e-10, name + "contact carries the load")
    claim(max(abs(row[key]) for key in ("force_tangential", "reaction_x", "reaction_y",
                                        "reaction_moment")) < 1e-10 * 0.125,
          name + "by symmetry nothing else acts")

largest = max(abs(point["lambda_t"]) for point in contact)
odd = max(abs(a["lambda_t"] + b["lambda_t"]) for a, b in zip(contact, reversed(contact)))
claim(odd < 1e-8 * largest, "lambda_t is odd (%.1e)" % (odd / largest))
even = max(abs(a["lambda_n"] - b["lambda_n"]) for a, b in zip(contact, reversed(contact)))
claim(even < 1e-8 * largest, "lambda_n is even (%.1e)" % (even / largest))
middle = [point for point in contact if abs(point["x"]) < 1e-3]
claim(len(middle) == 2 and
      abs(middle[0]["lambda_t"] - middle[1]["lambda_t"]) > 0.5 * middle[0]["bound"],
      "lambda_t jumps at x = 0")
dissipation = [point["lambda_t"] * point["u_t"] for point in whole(contact)]
claim(min(dissipation) >= -1e-3 * max(dissipation), "friction never feeds energy in")
claim(all(differ(abs(point["lambda_t"]), 0.3 * point["lambda_n"], largest) < 1e-8
          for point in whole(contact)), "all that touches slides: |lambda_t| = 0.3 lambda_n")

# the part that slips: all of it down to no friction at all, none where there is no law
for friction, share in (("Law=Coulomb, Coefficient=0.01", 1), ("Law=Coulomb, Coefficient=0", 1),
                        ("Law=None", 0)):
    last, _ = run(scene("coulomb.xml"), "smooth", levels(1) + [
        "Bodies->block->Boundary Conditions->foundation->Friction={%s}" % friction])
    claim(differ(last[-1]["slip_length"], share * last[-1]["contact_length"], 1) < 1e-6,
          "%s: slides on %g of its contact" % (friction, last[-1]["slip_length"]))

for iteration in ("Inexact Fixed Point", "Fixed Point"):
    other, points = run(scene("coulomb.xml"), "coulomb_iteration",
                        levels(4) + ["Solver->Coulomb Iteration=" + iteration])
    for row, reference in zip(other, history):
        for key in ENERGIES + ["force_normal"]:
            claim(differ(row[key], reference[key]) < 1e-8,
                  "%s, level %d: the same %s" % (iteration, row["level"], key))
finish()
