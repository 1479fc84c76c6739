"""The two blocks of [P] sec. 8, under Tresca's and under Coulomb's law: friction's work, complementarity,
symmetry.  That they balance is a claim of test/hard/cases.py."""
import math

from runs import ENERGIES, claim, differ, finish, largest, levels, run, scene, whole

both = {name: run(scene(name + ".xml"), name, levels(6)) for name in ("tresca", "coulomb")}
for name, (history, contact) in both.items():
    claim(len(history) == 6 and all(row["dof"] == row["dof_displacement"] + row["dof_multiplier"] and
                                    row["newton_iterations"] <= 15 and row["status"] == "converged"
                                    for row in history), name + ": six levels")
    parts = [[row[key] for key in row if key.startswith("eta_")] for row in history]
    claim(all(min(part) >= 0 and differ(math.hypot(*part), row["estimate"]) < 1e-12
              for part, row in zip(parts, history)), name + ": contributions make the estimate")
    sizes = {key: largest(point[key] for point in contact) for key in (
        "lambda_n", "lambda_t", "u_n", "bound")}
    points = whole(contact)
    work = [point["lambda_t"] * point["u_t"] for point in points]
    claim(min(work) >= -1e-3 * max(work), name + ": friction never feeds energy in")
    claim(all(abs(abs(p["lambda_t"]) - p["bound"]) <= 1e-8 * sizes["lambda_t"] for p in points
              if p["friction"] == 2), name + ": what slides carries its bound")
    claim(all(abs(p["lambda_t"]) <= p["bound"] + 1e-2 * sizes["bound"] for p in points),
          name + ": no shear beyond the bound")
    claim(all(p["u_n"] - p["gap"] <= 1e-3 * sizes["u_n"] for p in points if p["contact"] == 0),
          name + ": open points do not penetrate")
    claim(sum(abs(p["lambda_n"] * (p["u_n"] - p["gap"])) for p in contact) <
          1e-2 * sum(p["lambda_n"] for p in contact) * sizes["u_n"],
          name + ": pressure acts where the gap is closed")

claim([{point[key] for point in both["tresca"][1]} for key in ("contact", "friction")] ==
      [{0, 1}, {1, 2}], "Tresca: some are open, some closed; some points stick, some slide")
history, contact = both["coulomb"]
claim(all(differ(row["force_normal"], 0.125) < 1e-10 and largest(row[key] for key in (
    "force_tangential", "reaction_x", "reaction_y", "reaction_moment")) < 1e-10 * 0.125
    for row in history), "contact carries the load; by symmetry nothing else acts")
shear = sizes["lambda_t"]
odd = largest(a["lambda_t"] + b["lambda_t"] for a, b in zip(contact, reversed(contact)))
even = largest(a["lambda_n"] - b["lambda_n"] for a, b in zip(contact, reversed(contact)))
claim(max(odd, even) < 1e-8 * shear, "lambda_t is odd, lambda_n even (%.1e, %.1e)" % (odd, even))
middle = [point for point in contact if abs(point["x"]) < 1e-3]
claim(len(middle) == 2 and
      abs(middle[0]["lambda_t"] - middle[1]["lambda_t"]) > 0.5 * middle[0]["bound"],
      "lambda_t jumps at x = 0")
claim(all(differ(abs(point["lambda_t"]), 0.3 * point["lambda_n"], shear) < 1e-8
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
