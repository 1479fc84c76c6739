"""One mesh for all steps: under Graded hp the energies of every step of a path converge, on two blocks
whose ends of contact and of stick are elsewhere in each.

The truth is that of 34 levels of Graded hp up to 5914 unknowns, Marking Fraction 0.5, whose last
three levels agree to 3e-12; Adaptive h with degree 2 on 3460 unknowns is within 1.2e-8 of it.
"""
from runs import claim, finish, goes_on, rows, scene, solved

SCENE = scene("there-and-back.xml")
LIMITS = ["Adaptivity->Maximum Levels=100", "Adaptivity->Maximum Degrees of Freedom=1500"]
STRAIN = [8.61233400977e-05, 1.025693332895e-04, 8.61752971477e-05]
WORKS = [2.40259e-09, 2.6441888e-07, 3.1809441e-07]
# unknowns, largest relative error of a step's strain energy and of friction's work so far, the
# best of the last three levels: three times what they were, and below what singular points of the
# last step alone make, 1.9e-5 and 1.6e-2, 2.6e-6 and 6.3e-3
BOUNDS = [(900, 2e-6, 8e-3), (1500, 8e-8, 6e-4)]


def largest(rows, column, exact):
    return max(abs(row[column] - e) / e for row, e in zip(rows, exact))


folder, text = solved("path", SCENE, *LIMITS)
history, steps = rows(folder, "history.csv"), rows(folder, "steps.csv")
errors = []
for row in history:
    own = [step for step in steps if step["level"] == row["level"]]
    errors.append((row["dof"], largest(own, "energy_strain", STRAIN),
                   largest(own, "energy_dissipated", WORKS)))
for unknowns, strain, work in BOUNDS:
    last = [e for e in errors if e[0] <= unknowns][-3:]
    claim(min(e[1] for e in last) < strain,
          "%d unknowns: a step's strain energy is off by %.1e, below %.1e" %
          (last[-1][0], min(e[1] for e in last), strain))
    claim(min(e[2] for e in last) < work, "%d unknowns: friction's work is off by %.1e, below %.1e" % (
        last[-1][0], min(e[2] for e in last), work))

worst = {int(row["worst_step"]) for row in history}
claim(worst <= {1, 2, 3} and len(worst) > 1, "steps with the largest estimate: %s" % sorted(worst))
claim(all(row["worst_step_estimate"] <= row["estimate"] for row in history),
      "a step's estimate is at most that of the largest indicators")
claim("level 0: the largest error is that of step %d" % history[0]["worst_step"] in text,
      "a run says which step that is")

# states of all steps are in the file
goes_on("half", SCENE, ["Adaptivity->Maximum Levels=8", LIMITS[1]],
        ["Adaptivity->Maximum Levels=4"], 0)
finish()
