"""Friction's work never falls in any step of any hard case, led to its load, to a tenth of it and
back; what contact closes and opens on the way makes steps shorter, not wrong.

Fourth argument: the folder of the hard scenes."""
import glob
import os
import sys

from runs import SCENES, claim, epafi, finish, fresh, keys_of, saved, table

LOADS = {"Displacement X", "Displacement Y", "Traction X", "Traction Y", "Force X", "Force Y"}


def path(file):
    """The scene along a path, or nothing where there is no friction."""
    keys = keys_of(file)
    conditions = [condition for body in keys["Bodies"].values()
                  for condition in body.get("Boundary Conditions", {}).values()]
    laws = {side.get("Friction", {}).get("Law")
            for side in (*conditions, *keys.get("Contacts", {}).values())}
    if not laws & {"Coulomb", "Tresca"} or "History" in keys:
        return None
    for condition in conditions:
        for load in LOADS & {key for key, value in condition.items() if value != "0"}:
            condition[load] = "(%s)*(0.55 + 0.45*sin(pi/2*t))" % condition[load]
    keys["History"] = {"Times": [1, 2, 3, 4, 5], "Steps": [4] * 5}
    return saved(os.path.basename(file)[:-4], keys)


solved = 0
for file in sorted(glob.glob(os.path.join(sys.argv[4], "*.xml")) +
                   [os.path.join(SCENES, name) for name in ("tresca.xml", "coulomb.xml")]):
    scene = path(file)
    if scene is None:
        continue
    name = os.path.basename(file)[:-4]
    folder = fresh(name)
    code, text = epafi("run", scene, "--quiet", "--threads", "1", "--output", folder, "--set",
                       "Adaptivity->Maximum Levels=1")
    rows = table(os.path.join(folder, "steps.csv")) if code in (0, 3) else []
    last = text.strip().splitlines()[-1][:160] if code and text.strip() else ""
    solved += code == 0
    columns = [key for key in (rows[0] if rows else []) if key.endswith("energy_dissipated")]
    falls = [key for key in columns for a, b in zip([{key: 0}] + rows, rows) if b[key] < a[key]]
    claim(not falls, "%s: exit %d behind %d of 20 steps, friction's work %s %s" %
          (name, code, len(rows), "never falls, %.2e" % rows[-1]["energy_dissipated"] if rows else
           "unknown", last))
claim(solved == 17, "all 17 paths are solved to their end, these are %d" % solved)
finish()
