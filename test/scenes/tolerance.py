"""Adaptivity->Tolerance: a run ends where its estimated error is small enough, and says what it
reached or what is missing."""
import os

from epafi import Run
from runs import (WORK, claim, epafi, finish, fresh, refused, rows, saved, scene, solved,
                  steps)
from written import CLAMPED, block, body, condition, written

NONE = ["Adaptivity->Strategy=", "Adaptivity->Maximum Levels=",
        "Adaptivity->Maximum Degrees of Freedom="]


def solve(file, name, tolerance, *settings, expect=0):
    folder, text = solved(name, scene(file), "Adaptivity->Tolerance=%g" % tolerance, *settings,
                          expect=expect)
    return rows(folder, "history.csv"), text


def misses(name, row):
    """Does a level miss 0.02 in the whole or at a contact, or is its largest pressure in doubt?"""
    peaks = [row] if not os.path.exists(os.path.join(WORK, name, "steps.csv")) else [
        step for step in steps(name) if step["level"] == row["level"]]
    contact = next(key[:-13] for key in peaks[0] if key.endswith(".pressure_max"))
    peak = max(peaks, key=lambda each: each[contact + ".pressure_max"])
    return (max(row["estimate_relative"], row["estimate_contact"]) > 0.02 or
            not peak[contact + ".pressure_unbounded"] and
            peak[contact + ".pressure_max_error"] > 0.05 * peak[contact + ".pressure_max"])


def norm(row):
    return (2 * row["energy_strain"]) ** 0.5


for file in ("two-blocks.xml", "there-and-back.xml"):
    name = file[:-4]
    levels, text = solve(file, name, 0.02, *NONE)
    claim(levels[-1]["estimate_relative"] <= 0.02 and
          not misses(name, levels[-1]) and all(misses(name, row) for row in levels[:-1]),
          "ends at the first level within it, in the whole and at each contact: %g, %g" % (
              levels[-1]["estimate_relative"], levels[-1]["estimate_contact"]))
    claim("within Adaptivity->Tolerance = 0.02" in text, "and says so")
    claim(levels[-1]["degree_max"] > levels[0]["degree_max"] and
          levels[-1]["size_min"] < levels[0]["size_min"], "alone it means Graded hp")
for row in levels:
    own = [step["energy_strain"] for step in steps("there-and-back")
           if step["level"] == row["level"]]
    worst = row["worst_step_estimate"] / (2 * own[int(row["worst_step"]) - 1]) ** 0.5
    claim(worst <= row["estimate_relative"] * (1 + 1e-12),
          "every step counts: %g, %g" % (worst, row["estimate_relative"]))

# a stiff body's little energy asks for no more digits than the tractions of a soft one have
sizes = [solve("two-blocks.xml", "plate %g" % modulus, 0.003, *NONE,
               "Bodies->plate->Material->Young's Modulus=%g" % modulus)[0][-1]["dof"]
         for modulus in (1e-6, 1, 1e6)]
claim(max(sizes[0], sizes[2]) < 1.5 * sizes[1],
      "moduli of 1 : 1e6 either way need %d, %d unknowns, equal ones %d" % (
          sizes[0], sizes[2], sizes[1]))

# a prescribed displacement that is zero at all nodes is an error of all of it
waves = [solved("waves %d" % degree, written("waves", [body("block", block(0, 0, 2, 1), 1.0, {
    **condition("bottom", "Dirichlet", CLAMPED),
    **condition("top", "Dirichlet", Displacement_X=0, Displacement_Y="0.001*sin(4*pi*x)")})],
    degree=degree))[0] for degree in (1, 16)]
coarse, fine = (rows(folder, "history.csv")[-1] for folder in waves)
claim(coarse["energy_strain"] < 1e-25 and 0.3 < coarse["estimate"] / norm(fine) < 5,
      "what nodes do not see is estimated: %.2f of the norm" % (coarse["estimate"] / norm(fine)))

levels, text = solve("two-blocks.xml", "short", 0.02, *NONE, "Adaptivity->Maximum Levels=2")
claim(len(levels) == 2 and "above Adaptivity->Tolerance = 0.02" in text,
      "another limit says what is missing: " + text.split("ended")[-1].split("\n")[0])
claim("epafi: warning: a limit ends the run; the estimated error is" in text, "and warns of it")
claim(abs(levels[1]["estimate_relative"] * norm(levels[1]) / levels[1]["estimate"] - 1) < 1e-12,
      "relative to the energy norm")
levels, text = solve("two-blocks.xml", "few", 0.02, *NONE[:2],
                   "Adaptivity->Maximum Degrees of Freedom=260")
claim("Maximum Degrees of Freedom" in text and "above Adaptivity->Tolerance" in text,
      "so does a limit of unknowns")

# going on behind a level knows what it had reached
goes, on = os.path.join(WORK, "short"), fresh("on")
code, text = epafi("run", scene("two-blocks.xml"), "--restart", goes, "--output", on,
                   settings=["Adaptivity->Tolerance=0.02", *NONE])
claim(code == 0, "a restart goes on (exit %d) %s" % (code, text if code else ""))
whole, later = (rows(name, "history.csv") for name in ("two-blocks", "on"))
claim([row["estimate"] for row in whole] == [row["estimate"] for row in later] and
      rows("two-blocks", "bodies.csv") == rows("on", "bodies.csv"),
      "as without an end between")
code, text = epafi("run", scene("two-blocks.xml"), "--restart", on, "--output", fresh("no more"),
                   settings=["Adaptivity->Tolerance=0.02", *NONE])
claim(code == 0 and "ended" in text and
      rows("no more", "history.csv") == later, "what is reached is not refined")

# Hertz' contact between the points of the first mesh; every motion of an open block is no error
def pressed(name, count, *settings, gap="x^2/200", expect=0):
    block = "Bodies->block->Boundary Conditions->"
    return solve("hertz.xml", name, 0.02, *NONE, block + "contact->Gap=" + gap, *settings,
                 "Bodies->block->Rigid Motions=", block +
                 "top={Type=Dirichlet, Displacement X=0.002, Displacement Y=-0.0001}",
                 "Discretization->Elements per Edge={1, 1, %d, 1, 1, 2, 2, 2}" % count, expect=expect)


WARNING = "contact never closes"
known = pressed("known", 64)[0][-1]["force_normal"]
for name, *settings in (["missed"], ["missed in steps", "History->Times={1, 2}"]):
    levels, text = pressed(name, 3, *settings)
    claim(levels[0]["contact_length"] == 0 and levels[0]["estimate_relative"] > 1 and
          WARNING not in text and abs(levels[-1]["force_normal"] / known - 1) < 0.02,
          "%s at first, it is found: %g, %g" % (name, levels[-1]["force_normal"], known))
    levels, text = pressed(name, 3, *settings, "Adaptivity->Maximum Levels=1", expect=3)
    claim("between the points" in text and WARNING not in text, "one mesh says what it misses")
    levels, text = pressed("open", 3, *settings, gap="5")
    claim(len(levels) == 1 and levels[0]["estimate_relative"] == 0 and WARNING in text,
          "nothing strained: one level")

# what a mesh holds exactly and what is not strained meets any tolerance, however large the loads
WARM = {"Thermal Expansion": 1.2e-5}
SIDES = ["bottom", "right", "top", "left"]
ALL = ["X", "Y", "Rotation"]


def unstrained(name, rules, fix=(), x=0, nu=0.3, **more):
    return solved(name, saved(name, {"Bodies": {"block": {
        "Material": {"Young's Modulus": 210000, "Poisson's Ratio": nu, **WARM},
        "Geometry": {"Vertices": [[x, x], [x + 10, x], [x + 10, x + 5], [x, x + 5]],
                     "Edges": SIDES},
        "Rigid Motions": {"Fix": list(fix)}, "Boundary Conditions": rules, **more}},
        "Discretization": {"Mesh Size": 2},
        "Adaptivity": {"Tolerance": 1e-6, "Maximum Levels": 3}}))[0]


def held(x, y):
    return {"bottom": {"Type": "Dirichlet", "Displacement X": x, "Displacement Y": y}}


CONDUCTED = {"left": {"Temperature": 20}, "right": {"Temperature": 100}}
OPEN = {"bottom": {"Type": "Contact", "Gap": 1}}
for name, *arguments in (
        ("conducted heat", {}, ALL, {"Thermal Conditions": CONDUCTED}),
        ("conducted heat, open", OPEN, ALL, {"Thermal Conditions": CONDUCTED}),
        ("uniform heat", {}, ALL, {"Body Loads": {"Temperature": 100}}),
        ("uniform heat, open", OPEN, ALL, {"Body Loads": {"Temperature": 100}}),
        ("linear heat", {}, ALL, {"Body Loads": {"Temperature": "20 + 8*x"}}),
        ("turned", held("0.3 - 0.01*y", "0.2 + 0.01*x"), (), {}),
        ("turned far away", held("0.3 - 0.01*(y - 1e6)", "0.2 + 0.01*(x - 1e6)"), (), {"x": 1e6}),
        ("open", {**OPEN, "top": {"Type": "Dirichlet", "Displacement X": 0.1,
                                  "Displacement Y": -0.2}}, (), {}),
        ("nothing", {}, ALL, {})):
    levels = rows(unstrained(name, *arguments[:2], **arguments[2]), "history.csv")
    claim(len(levels) == 1 and levels[0]["estimate_relative"] == 0,
          "%s: level %d, error %.1e" % (name, len(levels) - 1, levels[-1]["estimate_relative"]))

# elements whose places coordinates do not tell apart are not cut
def clamped(x):
    """A block on a clamp, with singular corners."""
    return rows(solved("clamped at %g" % x, saved("clamped", {"Bodies": {"block": {
        "Material": {"Young's Modulus": 1e3, "Poisson's Ratio": 0.3},
        "Geometry": {"Vertices": [[x, x], [x + 2, x], [x + 2, x + 1], [x, x + 1]],
                     "Edges": SIDES},
        "Boundary Conditions": {**held("0", "0"), "top": {"Type": "Neumann", "Traction Y": -1}}}},
        "Discretization": {"Mesh Size": 0.5}, "Adaptivity": {"Tolerance": 2e-6}}))[0],
        "history.csv")


near, far, farther = (clamped(x) for x in (0, 1e6, 1e9))
claim(near[-1]["estimate_relative"] <= 2e-6 and far[-1]["size_min"] > 1e-9,
      "at the origin down to %.0e, far away to %.0e" % (near[-1]["size_min"], far[-1]["size_min"]))
claim(farther[-1]["size_min"] > 1e-6 and 2e-6 < farther[-1]["estimate_relative"] < 1e-2,
      "farther away to %.0e, and the run ends" % farther[-1]["size_min"])
# a load between the nodes of two elements: the error is larger than the solution, which is no result
sharp = written("sharp", [body("block", block(0, 0, 1, 1), 1.0, condition(
    "bottom", "Dirichlet", CLAMPED) + condition("top", "Neumann", Traction_Y="-0.001*cos(40*pi*x)"))],
    form="Density", size=0.5, degree=1)
NO_RESULT = "this is no result: the estimated error is 250 %"
folder, text = solved("sharp", sharp)
claim("epafi: warning: a limit ends the run; " + NO_RESULT in text and
      NO_RESULT in text.split("ended")[-1], "what is none is told as no result")
claim(repr(Run(folder)).endswith("converged; " + NO_RESULT + " of the energy norm"), repr(Run(folder)))
folder, text = solved("sharp asked", sharp, "Adaptivity->Tolerance=0.1",
                      "Adaptivity->Maximum Levels=1", expect=3)
claim("epafi: all levels that the scene allows are computed; " + NO_RESULT in text,
      "and with a Tolerance not converged")
folder, text = solved("sharp done", sharp, "Adaptivity->Tolerance=0.1")
claim("no result" not in text and Run(folder).no_result == "", "unless that is met")

# nothing is said of meshes: to 0.01 in the whole and at each contact, whatever else is loaded
STEEL = {"Young's Modulus": 210000, "Poisson's Ratio": 0.3}
CLAMP = {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
DISC = {"disc": {"Material": STEEL, "Geometry": {"Vertices": [[0, 0], [0, 20]], "Edges": ["rim", "rim"],
                                                "Bulges": [1, 1]},
                 "Body Loads": {"Force Y": -0.1}, "Rigid Motions": {"Fix": ["X", "Rotation"]}},
        "block": {"Material": STEEL,
                  "Geometry": {"Vertices": [[-10, -20], [10, -20], [10, 0], [-10, 0]],
                               "Edges": ["base", "side", "top", "side"]},
                  "Boundary Conditions": {"base": CLAMP}}}
CONTACT = {"c": {"Between": ["disc:rim", "block:top"]}}


def beam(load):
    return {"beam": {"Material": STEEL,
                     "Geometry": {"Vertices": [[100, 0], [200, 0], [200, 20], [100, 20]],
                                  "Edges": ["below", "end", "above", "clamp"]},
                     "Boundary Conditions": {"clamp": CLAMP, "end": {"Type": "Neumann", "Force Y": -load}}}}


for load in (0, 1, 1000, 1e6):
    file = saved("beam", {"Bodies": {**(beam(load) if load else {}), **DISC}, "Contacts": CONTACT})
    folder, text = solved("beam %g" % load, file)
    last = rows(folder, "history.csv")[-1]
    peak = max(point["pressure"] for point in rows(folder))
    claim(abs(peak / 339.2 - 1) < 0.05 and abs(last["contact_length"] / 0.118 - 1) < 0.15,
          "beside a beam under %g a disc presses with %.4g on %.4g" % (
              load, peak, last["contact_length"]))
    claim(last["estimate_relative"] <= 0.01 and "within Adaptivity->Tolerance = 0.01" in text,
          "to the tolerance of scenes that state no mesh")
used = os.path.join(folder, "used.xml")
again, _ = solved("used", used)
claim([row["dof"] for row in rows(again, "history.csv")] ==
      [row["dof"] for row in rows(folder, "history.csv")], "used.xml repeats it")
part, _ = solved("part", file, "Adaptivity->Maximum Levels=14")
code, text = epafi("run", file, "--restart", part)
claim(code == 0 and [row["dof"] for row in rows(part, "history.csv")] ==
      [row["dof"] for row in rows(folder, "history.csv")], "and so does a restart: " + text[-300:])
coarse = {"Bodies": {**DISC, "disc": {**DISC["disc"], "Mesh": {"Mesh Size": 8}}}, "Contacts": CONTACT}
folder, text = solved("stated", saved("stated", coarse))
claim(len(rows(folder, "history.csv")) == 1, "a mesh that is stated stays")
folder, text = solved("coarse", saved("coarse", {
    "Bodies": {"block": {**DISC["block"], "Boundary Conditions": {
        "base": CLAMP, "top": {"Type": "Neumann", "Traction Y": -1}}, "Mesh": {"Mesh Size": 20}}}}))
error = rows(folder, "history.csv")[-1]["estimate_relative"]
claim(error > 0.1 and "warning: the estimated error is %d %% of the energy norm" % round(100 * error) in text,
      "a coarse mesh is warned of: " + text[-300:])

refused("weights without the norm's unit", scene("two-blocks.xml"), "Adaptivity->Tolerance", "Energy",
        settings=["Adaptivity->Tolerance=0.02", "Adaptivity->Weights=Paper"])
finish()
