"""Adaptivity->Tolerance: a run ends where its estimated error is small enough, and says what it
reached or what is missing."""
import os

from runs import WORK, claim, epafi, finish, fresh, scene, table

os.makedirs(WORK, exist_ok=True)
NONE = ["--set", "Adaptivity->Strategy=", "--set", "Adaptivity->Maximum Levels=",
        "--set", "Adaptivity->Maximum Degrees of Freedom="]


def solve(file, name, tolerance, *more):
    folder = fresh(name)
    code, text = epafi("run", scene(file), "--output", folder, "--set",
                       "Adaptivity->Tolerance=%g" % tolerance, *more)
    claim(code == 0, "%s, tolerance %g (exit %d)" % (name, tolerance, code))
    return table(os.path.join(folder, "history.csv")), text


def norm(row):
    return (2 * row["energy_strain"]) ** 0.5


for file in ("two-blocks.xml", "there-and-back.xml"):
    name = file[:-4]
    rows, text = solve(file, name, 0.02, *NONE)
    claim(rows[-1]["estimate_relative"] <= 0.02 and
          all(row["estimate_relative"] > 0.02 for row in rows[:-1]),
          "ends at the first level within it: %g" % rows[-1]["estimate_relative"])
    claim("within Adaptivity->Tolerance = 0.02" in text, "and says so")
    claim(rows[-1]["degree_max"] > rows[0]["degree_max"] and
          rows[-1]["size_min"] < rows[0]["size_min"], "alone it means Graded hp")
for row in rows:
    steps = table(os.path.join(WORK, "there-and-back", "steps.csv"))
    own = [step["energy_strain"] for step in steps if step["level"] == row["level"]]
    worst = row["worst_step_estimate"] / (2 * own[int(row["worst_step"]) - 1]) ** 0.5
    claim(worst <= row["estimate_relative"] * (1 + 1e-12),
          "every step counts: %g, %g" % (worst, row["estimate_relative"]))

rows, text = solve("two-blocks.xml", "short", 0.02, *NONE, "--set", "Adaptivity->Maximum Levels=2")
claim(len(rows) == 2 and "above Adaptivity->Tolerance = 0.02" in text,
      "another limit says what is missing: " + text.split("ended")[-1].split("\n")[0])
claim(abs(rows[1]["estimate_relative"] * norm(rows[1]) / rows[1]["estimate"] - 1) < 1e-12,
      "relative to the energy norm")
rows, text = solve("two-blocks.xml", "few", 0.02, *NONE[:4], "--set",
                   "Adaptivity->Maximum Degrees of Freedom=260")
claim("Maximum Degrees of Freedom" in text and "above Adaptivity->Tolerance" in text,
      "so does a limit of unknowns")

# going on behind a level knows what it had reached
goes, on = os.path.join(WORK, "short"), fresh("on")
code, text = epafi("run", scene("two-blocks.xml"), "--restart", goes, "--output", on,
                   "--set", "Adaptivity->Tolerance=0.02", *NONE)
claim(code == 0, "a restart goes on (exit %d) %s" % (code, text if code else ""))
whole, later = (table(os.path.join(WORK, name, "history.csv")) for name in ("two-blocks", "on"))
claim([row["estimate"] for row in whole] == [row["estimate"] for row in later],
      "as without an end between")
code, text = epafi("run", scene("two-blocks.xml"), "--restart", on, "--output", fresh("no more"),
                   "--set", "Adaptivity->Tolerance=0.02", *NONE)
claim(code == 0 and "nothing was left to solve" in text, "what is reached is not refined")

code, text = epafi("check", scene("two-blocks.xml"), "--set", "Adaptivity->Tolerance=0.02",
                   "--set", "Adaptivity->Weights=Paper")
claim(code == 1 and "Adaptivity->Tolerance" in text and "Energy" in text,
      "weights without the norm's unit are refused: " + text.strip())
finish()
