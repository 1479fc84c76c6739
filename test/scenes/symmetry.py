"""Geometry->Symmetry: one half against the whole on matched meshes.

Where solutions are smooth both resolve them to rounding, which the claims ask for; the half has
elements on the line, which the whole has not, so that elsewhere they agree within estimates."""
import copy
import math
import os
import re

from epafi import Run

from runs import (WORK, claim, differ, epafi, fails, finish, fresh, goes_on, largest, rows, saved,
                  solved, write)

DEGREE = 16
STEEL = {"Young's Modulus": 1, "Poisson's Ratio": 0.3}
SOFT = {"Young's Modulus": 0.4, "Poisson's Ratio": 0.2}


def outline(path, names, counts, whole):
    """Of a path from the line x = 0 on to it again the half or the whole."""
    if not whole:
        return path, names + ["any"], counts + [counts[0]]
    mirrored = [(-x, y) for x, y in path[-2:0:-1]]
    return path + mirrored, names + names[::-1], counts + counts[::-1]


def turned(point):
    return (-point[1], point[0])


def block(low, high, whole, count=2, width=1, y=False):
    """A body [0, width] x [low, high] or its whole; of Y turned left by a right angle."""
    corners, names, counts = outline([(0, low), (width, low), (width, high), (0, high)],
                                     ["bottom", "side", "top"], [count] * 3, whole)
    if y:
        corners = [turned(c) for c in corners]
    return {"Geometry": {"Vertices": [list(c) for c in corners], "Edges": names},
            "Mesh": {"Elements per Edge": counts}}


def file_of(name, bodies, whole, axis="X", **more):
    scene = {"Bodies": bodies, "Discretization": {"Mesh Size": 1, "Degree": DEGREE}, **more}
    if not whole:
        scene["Geometry"] = {"Symmetry": axis}
    return saved(name + (" whole" if whole else " half"), scene)


# what nothing else holds in the whole; the line does it in the half
FIXED = {"Rigid Motions": {"Fix": ["X"]}}
PRESSED = "-0.01*(1 + 0.2*cos(pi*x))"
# bounds that grow from the line on, so that slip is smooth
LAW = {"Law": "Coulomb", "Coefficient": "0.3*abs(x)*(1 - x^2)^2"}


def on_obstacle(whole, friction=LAW, load=PRESSED, count=2, more=FIXED):
    body = block(0, 1, whole, count)
    return {"block": {"Material": STEEL, **body, **more, "Boundary Conditions": {
        "bottom": {"Type": "Contact", "Gap": "0.001*cos(pi*x)", "Friction": friction},
        "top": {"Type": "Dirichlet", "Displacement Y": load}}}}


def on_obstacle_turned():
    body = block(0, 1, False, y=True)
    return {"block": {"Material": STEEL, **body, "Boundary Conditions": {
        "bottom": {"Type": "Contact", "Gap": "0.001*cos(pi*y)",
                   "Friction": {**LAW, "Coefficient": LAW["Coefficient"].replace("x", "y")}},
        "top": {"Type": "Dirichlet", "Displacement X": "0.01*(1 + 0.2*cos(pi*y))"}}}}


def two_blocks(whole):
    """The lower one on a roller, no friction: smooth."""
    return {"upper": {"Material": SOFT, **block(0, 1, whole), **FIXED, "Boundary Conditions": {
        "top": {"Type": "Dirichlet", "Displacement Y": PRESSED}}},
            "lower": {"Material": STEEL, **block(-1, 0, whole), **FIXED, "Boundary Conditions": {
                "bottom": {"Type": "Dirichlet", "Displacement Y": "0"}}}}


JOINT = {"joint": {"Between": ["upper:bottom", "lower:top"]}}


def punch(whole):
    stamp = block(1, 2, whole, width=2)
    stamp.pop("Mesh")
    return {"block": {"Material": STEEL, **block(0, 1, whole), **FIXED, "Boundary Conditions": {
        "bottom": {"Type": "Dirichlet", "Displacement Y": "0.001*cos(pi*x)"}}},
            "punch": {"Material": {"Rigid": True}, **stamp, "Motion": {"Force Y": "-0.02"}}}


# columns whose sizes are compared with each other's; what others hold depends on the mesh
KINDS = {
    "energies": "energy_.*(strain|load|friction|dissipated|trapezoidal|outside|interface|stored|"
                "springs)$",
    "lengths": ".*_length$", "pressures": "pressure",
    "forces": "(force|load|contact|reaction|body)_", "motions": "motion|rotation"}
TOTALS = ("history.csv", "steps.csv", "bodies.csv")


def kind(column):
    name = column.split(".")[-1]
    return next((kind for kind, words in KINDS.items() if re.match(words, name)), None)


def compare(name, half, other, sharp=1e-9, tractions=1e-6):
    """Totals, and what stands along contact and boundary: what is a place on a mesh, or a traction
    at one, is not as sharp as sums."""
    worst = {}

    def compared(what, columns, here, there):
        size = largest(row[c] for row in there for c in columns)
        for column in columns if size > 1e-15 else ():
            off = largest(a[column] - b[column] for a, b in zip(here, there)) / size
            worst[what] = max(worst.get(what, (0, "")), (off, column))

    def inside(folder, file):
        found = [r for r in rows(folder, file) if r["x"] > 0 and
                 r["boundary"].split(":")[-1] != "symmetry"]
        return sorted(found, key=lambda r: (r.get("body"), r["boundary"], round(r["x"], 9),
                                            round(r["y"], 9)))

    for file in TOTALS:
        if os.path.exists(os.path.join(other, file)):
            here, there = rows(half, file)[-2:], rows(other, file)[-2:]
            for group in KINDS:
                columns = [column for column in there[0] if kind(column) == group]
                if columns:
                    compared(file if group not in ("lengths", "pressures") else group, columns,
                             here, there)
    for file, groups in (("contact.csv", (("lambda_n", "lambda_t"), ("u_n", "u_t"))),
                         ("boundary.csv", (("ux", "uy"), ("tx", "ty")))):
        if os.path.exists(os.path.join(other, file)):
            here, there = inside(half, file), inside(other, file)
            claim(len(here) == len(there) > 10, "%s: %d points of %s" % (name, len(here), file))
            for columns in groups:
                compared(file, columns, here, there)
    for what, (off, column) in sorted(worst.items()):
        claim(off < (sharp if what in TOTALS else tractions),
              "%s: %s within %.1e (%s)" % (name, what, off, column))


def pair(name, scene, *settings, sharp=1e-9, tractions=1e-6, **more):
    """A scene as a function of `whole`; the folder of its half."""
    folders = [solved(name + " " + which, file_of(name, scene(which == "whole"), which == "whole",
                                                **more), *settings)[0]
               for which in ("half", "whole")]
    compare(name, *folders, sharp=sharp, tractions=tractions)
    return folders


half, whole = pair("on an obstacle", on_obstacle)
row = rows(half, "history.csv")[-1]
claim(row["contact_y"] > 0.001 and row["contact_x"] == row["reaction_x"] == 0 and
      row["reaction_moment"] == 0 and row["slip_length"] > 1.99 and row["energy_friction"] > 0,
      "pressed and slipping: a force along the line, none across")
claim(abs(row["reaction_y"] + row["contact_y"]) < 1e-10 * row["contact_y"], "in balance")

# turned by a right angle
folder = solved("Y", file_of("Y", on_obstacle_turned(), False, "Y"))[0]
other = rows(folder, "history.csv")[-1]
claim(all(differ(row[c], other[c]) < 1e-9 for c in (
    "energy_strain", "energy_friction", "force_normal", "contact_length", "estimate")) and
      differ(row["contact_y"], -other["contact_x"]) < 1e-9 and other["contact_y"] == 0,
      "Y is X turned by a right angle")

# the other half, drawn on the left, off the line by rounding in a file
left = on_obstacle(False)
geometry = left["block"]["Geometry"]
geometry["Vertices"] = [[-x if x else 1e-7 * y, y] for x, y in geometry["Vertices"][::-1]]
geometry["Edges"] = ["top", "side", "bottom", "any"]
folder = solved("left", file_of("left", left, False))[0]
other = rows(folder, "history.csv")[-1]
claim(all(differ(row[c], other[c]) < 1e-9 for c in ("energy_strain", "energy_friction", "estimate")),
      "the left half is as good as the right one")

pair("two blocks", two_blocks, Contacts=JOINT)
STAMP = {"stamp": {"Between": ["block:top", "punch:bottom"]}}
half, _ = pair("punch", punch, Contacts=STAMP)
stamp = [r for r in rows(half, "bodies.csv") if r["body"] == "punch"][-1]
claim(abs(stamp["load_y"] + 0.02) < 1e-15 and abs(stamp["contact_y"] - 0.02) < 1e-11,
      "the punch is under the whole of its force")

# a path: pressed on, and pressed more
PATH = {"Times": [1, 2], "Steps": [1, 2]}
half, _ = pair("path", lambda w: on_obstacle(w, load="t/2*(%s)" % PRESSED), History=PATH)
pair("punch on a path", punch, "Bodies->punch->Motion->Force Y=-0.02*t", Contacts=STAMP, History=PATH)
half, _ = pair("punch by a spring", punch, "Bodies->punch->Motion->Force Y=-0.02*t",
               "Bodies->punch->Motion->Stiffness Y=0.5", Contacts=STAMP, History=PATH)
row = rows(half, "steps.csv")[-1]
claim(row["energy_springs"] > 1e-6 and differ(
    row["energy_springs"], 0.5 * 0.5 * row["punch.motion_y"]**2) < 1e-9,
      "the spring is that of the whole")

# Fix holds what the line does not; its reaction acts on the body's boundary alone, a shear on the
# sides that jumps at corners
def fixed(whole):
    return {"block": {"Material": {**STEEL, "Density": 1}, **block(0, 1, whole, 2),
                      "Boundary Conditions": {
                          "top": {"Type": "Neumann", "Traction Y": "-0.01*(1 + x^2)"}},
                      "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}}


half, whole = pair("fixed, with weight", fixed, sharp=1e-6, tractions=1e-3,
                   **{"Body Loads": {"Gravity Y": "-0.003", "Spin": "0.02"}})
row = rows(half, "history.csv")[-1]
claim(abs(row["reaction_y"] - 2 * (0.01 * 4 / 3 + 0.003 - 0.5 * 0.02**2)) < 1e-12,
      "Fix carries all of the weight and the spin")


# no change of volume; heat, which does not cross the line
def warm(whole):
    return {"block": {"Material": {"Young's Modulus": 1, "Poisson's Ratio": 0.3,
                                   "Thermal Expansion": 1e-3}, **block(0, 1, whole, 3), **FIXED,
                      "Thermal Conditions": {"top": {"Temperature": "1 + cos(pi*x)"},
                                             "bottom": {"Temperature": "0"}},
                      "Boundary Conditions": {
                          "bottom": {"Type": "Dirichlet", "Displacement Y": "0"}}}}


pair("incompressible", on_obstacle, "Bodies->block->Material->Poisson's Ratio=0.5", tractions=1e-5)
pair("warm", warm, "Discretization->Degree=8", sharp=1e-6, tractions=1e-3)


# two pads on a plate that the line cuts, of which one is drawn
def pads(whole):
    scene = {"plate": {"Material": STEEL, **block(-1, 0, whole, 6, 2), "Boundary Conditions": {
        "bottom": {"Type": "Dirichlet", "Displacement X": "0", "Displacement Y": "0"}}}}
    for name, left, sign in (("pad", 0.5, 1), ("other", -1.5, -1))[:2 if whole else 1]:
        scene[name] = {
            "Material": SOFT, "Geometry": {
                "Vertices": [[left, 0], [left + 1, 0], [left + 1, 0.5], [left, 0.5]],
                "Edges": ["bottom", "right", "top", "left"]},
            "Mesh": {"Elements per Edge": [4, 2, 4, 2]}, "Boundary Conditions": {
                "top": {"Type": "Neumann", "Traction X": "%d*0.006" % sign, "Traction Y": "-0.02"}}}
    return scene


def joints(whole):
    return {name: {"Between": [name + ":bottom", "plate:top"],
                   "Friction": {"Law": "Coulomb", "Coefficient": 0.4}}
            for name in ("pad", "other")[:2 if whole else 1]}


half, whole = (solved("pads %d" % w, file_of("pads", pads(w), w, Contacts=joints(w), History=PATH),
                      "Discretization->Degree=3")[0] for w in (False, True))
here, there = ({r["body"]: r for r in rows(f, "bodies.csv")} for f in (half, whole))
E = [rows(f, "history.csv")[-1] for f in (half, whole)]
close = 2e-3
for body in ("pad", "plate"):
    claim(all(abs(here[body][c] - there[body][c]) < 1e-9 for c in (
        "load_x", "load_y", "contact_x", "contact_y", "reaction_x", "reaction_y")) and
          differ(here[body]["energy_strain"], there[body]["energy_strain"]) < close,
          "pads: forces on the %s as in the whole, to %.1e" % (body, close))
claim(here["plate"]["contact_x"] == 0 and abs(here["plate"]["contact_y"] + 0.04) < 1e-9 and
      abs(here["pad"]["contact_x"] + 0.006) < 1e-9, "the plate is whole, the pad one of two")
steps = [rows(f, "steps.csv")[-1] for f in (half, whole)]
claim(all(differ(steps[0]["pad." + c], steps[1]["pad." + c]) < close for c in (
    "force_y", "force_normal", "contact_length", "slip_length")) and
      abs(steps[0]["pad.energy_dissipated"] - steps[1]["pad.energy_dissipated"]) < close *
      steps[1]["energy_strain"], "steps.csv tells of the pad's contact what it is on one pad")
claim(all(abs(E[0][c] - E[1][c]) < close * E[1]["energy_strain"] for c in (
    "energy_strain", "energy_friction")) and differ(*(e["contact_length"] for e in E)) < close and
      E[0]["load_x"] == 0 and E[0]["slip_length"] > 0.1 and
      differ(E[0]["estimate"], E[1]["estimate"]) < 0.05, "history.csv has both pads")

# a coarse line beside fine contact: Hertz' pressure at its end, on all levels
P, RADIUS = 2 * 4.3153745e-4, 1000
HERTZ = {"half": {"Material": STEEL, "Geometry": {
    "Vertices": [[0, 0], [3, 0], [50, 0], [50, 50], [0, 50]],
    "Edges": ["contact", "free", "side", "top", "any"]}, "Boundary Conditions": {
        "contact": {"Type": "Contact", "Gap": "x^2/%d" % (2 * RADIUS)},
        "top": {"Type": "Neumann", "Force Y": -P / 2}}}}
peak = math.sqrt(P / (1 - 0.3**2) / (math.pi * RADIUS))
for name, counts, *settings in (
        ("Hertz", [120, 8, 4, 4, 4]),
        ("Hertz, refined", [12, 8, 4, 4, 1], "Adaptivity->Strategy=Adaptive h",
         "Adaptivity->Maximum Levels=7")):
    folder = solved(name, saved(name, {
        "Geometry": {"Symmetry": "X"}, "Bodies": HERTZ,
        "Discretization": {"Elements per Edge": counts, "Degree": 2}}), *settings)[0]
    first = min(rows(folder), key=lambda r: r["x"])
    claim(abs(first["pressure"] / peak - 1) < 5e-3,
          "%s: %.4f of Hertz' pressure at the end of the line" % (name, first["pressure"] / peak))


# cracks on the line keep their conditions
def cracked(names=("any", "crack"), crack=None):
    """The upper half of a plate with a crack of length 2, pulled or pressed open."""
    line, slit = names
    rules = {"top": {"Type": "Neumann", "Traction Y": 1}} if crack is None else {"crack": crack}
    return {"Material": STEEL, "Geometry": {
        "Vertices": [[-10, 0], [-1, 0], [1, 0], [10, 0], [10, 10], [-10, 10]],
        "Edges": [line, slit, line, "side", "top", "side"]},
            "Boundary Conditions": rules, "Rigid Motions": {"Fix": ["X"]}}


def pulled(name, whole, body, fine="1e-5"):
    scene = {"Bodies": {"up": body}, "Discretization": {"Mesh Size": 2},
             "Adaptivity": {"Tolerance": fine}}
    if not whole:
        scene["Geometry"] = {"Symmetry": "Y"}
        return solved(name, saved(name, scene))[0]
    down = copy.deepcopy(body)
    down["Geometry"]["Vertices"] = [[x, -y] for x, y in body["Geometry"]["Vertices"][::-1]]
    down["Geometry"]["Edges"] = [body["Geometry"]["Edges"][(4 - i) % 6] for i in range(6)]
    for rules in down["Boundary Conditions"].values():
        rules["Traction Y"] = -rules["Traction Y"]
    body["Rigid Motions"] = {"Fix": ["X", "Y", "Rotation"]}
    down["Rigid Motions"] = {}
    scene["Bodies"]["down"] = down
    scene["Contacts"] = {"joint": {"Between": ["up:joint", "down:joint"],
                                   "Friction": {"Law": "Tied"}}}
    return solved(name, saved(name, scene))[0]


halves = pulled("half a crack", False, cracked())
energies = [rows(f, "history.csv")[-1]["energy_strain"] for f in (
    halves, pulled("a crack", True, cracked(("joint", "crack"))))]
claim(differ(*energies) < 1e-9, "half a cracked plate and all of it: energies within %.1e" % differ(
    *energies))
# what a pressure inside the crack does is the same crack, under stresses that it takes away
PRESSURE = {"Type": "Neumann", "Traction Y": 1}
energies = [rows(f, "history.csv")[-1]["energy_strain"] for f in (
    pulled("pressed open", False, cracked(crack=PRESSURE)),
    pulled("named alone", False, cracked(("line", "crack"), PRESSURE)),
    pulled("a crack pressed open", True, cracked(("joint", "crack"), PRESSURE)))]
claim(max(differ(e, energies[-1]) for e in energies) < 1e-9,
      "pressed open: energies within %.1e" % max(differ(e, energies[-1]) for e in energies))
found = Run(halves).intensities()
tips = found["k_normal"][abs(abs(found["x"]) - 1) < 1e-9]
# [Feddersen 1966] for long strips; a square one has 1.0 % more
exact = math.sqrt(math.pi / math.cos(math.pi / 20))
claim(len(tips) == 2 and differ(*tips) < 1e-6 and all(exact < tip < 1.02 * exact for tip in tips),
      "K_I %s of half a crack, %.4f in a long strip" % (list(tips), exact))

# singular corners and the ends of contact, level by level
# a disc on a plane that is a body of its own: beside the line the plane has no corner
def disc(whole):
    quarter = math.tan(math.pi / 8)
    curve = {"Vertices": [[0, -1], [1, 0], [0, 0]], "Edges": ["round", "equator", "any"],
             "Bulges": [quarter, 0, 0]}
    if whole:
        curve = {"Vertices": [[-1, 0], [0, -1], [1, 0]], "Edges": ["round", "round", "equator"],
                 "Bulges": [quarter, quarter, 0]}
    plane = block(-2, -1, whole, width=3)["Geometry"]
    return {"disc": {"Material": STEEL, "Geometry": curve, "Boundary Conditions": {
        "equator": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": -0.01}}},
            "plane": {"Material": {"Rigid": True}, "Geometry": plane}}


ROLLS = {"Contacts": {"c": {"Between": ["disc:round", "plane:top"]}},
         "Discretization": {"Mesh Size": 0.25, "Degree": 2},
         "Adaptivity": {"Strategy": "Graded hp", "Maximum Levels": 40, "Tolerance": 1e-4}}
halves = [rows(solved("disc %d" % w, file_of("disc", disc(w), w, **ROLLS))[0], "history.csv")[-1]
          for w in (False, True)]
claim(differ(*(row["force_normal"] for row in halves)) < 1e-6, "half a disc on a plane: force within %.1e" % (
    differ(*(row["force_normal"] for row in halves))))

GRADED = ["Adaptivity->Strategy=Graded hp", "Adaptivity->Maximum Levels=8",
          "Discretization->Degree=2", "Bodies->block->Boundary Conditions->bottom->Gap=0.05*x^2",
          "Bodies->block->Boundary Conditions->top->Displacement X=0"]
CONSTANT = {"Law": "Coulomb", "Coefficient": 0.3}
folders = [solved("graded %d" % w, file_of("graded", on_obstacle(w, CONSTANT, "-0.03", 4, {}), w),
                  *GRADED)[0] for w in (False, True)]
half, whole = (rows(f, "history.csv") for f in folders)
worst = max(differ(a["estimate_relative"], b["estimate_relative"]) for a, b in zip(half, whole))
claim(len(half) == len(whole) == 8 and worst < 0.25,
      "Graded hp: relative estimates of all levels within %.1f per cent" % (100 * worst))
claim(all(differ(half[-1][c], whole[-1][c]) < whole[-1]["estimate_relative"]**2
          for c in ("energy_strain", "force_normal")) and
      half[-1]["dof"] < 0.65 * whole[-1]["dof"], "as good with %d unknowns as with %d" % (
          half[-1]["dof"], whole[-1]["dof"]))
name = file_of("graded", on_obstacle(False, CONSTANT, "-0.03", 4, {}), False)
folder = solved("compressed", name, *GRADED, "Solver->Linear->Method=Compressed")[0]
other = rows(folder, "history.csv")[-1]
claim(other["operators"] == "compressed" and all(
    differ(half[-1][c], other[c]) < 1e-6 for c in ("energy_strain", "force_normal", "estimate")),
      "compressed as dense")
folder, *_ = goes_on("restarted at level 3", name, GRADED, ["Adaptivity->Maximum Levels=3"])
fails("a restart is of the same symmetry", ["Geometry->Symmetry differs"], "run", name, "--restart",
      folder, "--output", fresh("another"), settings=GRADED[2:] + ["Geometry->Symmetry=None"])

# points of the half that is not drawn
points = os.path.join(WORK, "points.csv")
write(points, "0.3,0.4\n-0.3,0.4\n0,0.4\n1.1,0.4\n")
found = []
for folder in folders:
    code, text = epafi("fields", folder, "--points", points)
    claim(code == 0, "fields" + ("" if code == 0 else text))
    found.append(rows(folder, "fields.csv"))
a, b, middle, outside = found[0]
claim(a["ux"] == -b["ux"] and a["sxy"] == -b["sxy"] and
      all(a[c] == b[c] for c in ("uy", "sxx", "syy", "szz", "von_mises")) and outside["ux"] == "",
      "a point of the other half has the image's fields")
for place, points, sharp in (("off the line", (0, 1), 1e-6), ("on the line", (2,), 1e-3)):
    worst = max(abs(found[0][k][c] - found[1][k][c]) / max(abs(p[d]) for p in found[1][:3] for
                                                           d in group) for k in points for
                group in (("ux", "uy"), ("sxx", "syy", "sxy")) for c in group)
    claim(worst < sharp, "fields %s within %.1e" % (place, worst))


# bad input
def refused(name, scene, *words, **more):
    code, text = epafi("check", file_of(name, scene, False, **more))
    claim(code == 1 and text.count("\n") <= 2 and all(w in text for w in words),
          "%s: %s" % (name, text.strip()))


def changed(scene, body, part, **values):
    scene[body].setdefault(part, {}).update({k.replace("_", " "): v for k, v in values.items()})
    return scene


refused("crossing", on_obstacle(True), "(-1, ", "beyond the line of symmetry, x = 0")
refused("no edge", {"block": {**on_obstacle(False)["block"], "Geometry": {
    "Vertices": [[1, 0], [2, 0], [2, 1], [1, 1]], "Edges": ["bottom", "side", "top", "any"]}}},
        "no edge of a body lies on the line x = 0")
refused("condition", changed(on_obstacle(False), "block", "Boundary Conditions", any={
    "Type": "Neumann", "Traction X": 1}), "Boundary Conditions->any", "rollers by themselves")
refused("contact", two_blocks(False), "Contacts->joint", "upper:any",
        Contacts={"joint": {"Between": ["upper:any", "lower:top"]}})


# a body on the line without a roller: a load or support does not tell a half from a copy
def named(body, boundary="line", **condition):
    """The line's edge of a block has a name and a condition of its own."""
    body["Geometry"]["Edges"] = [boundary if e == "any" else e for e in body["Geometry"]["Edges"]]
    if condition:
        body["Boundary Conditions"][boundary] = {
            key.replace("_", " "): value for key, value in condition.items()}
    return body


def stacked(**condition):
    """The upper one of two blocks under a force, its edge on the line named."""
    scene = two_blocks(False)
    scene["upper"]["Boundary Conditions"]["top"] = {"Type": "Neumann", "Traction Y": -0.01}
    named(scene["upper"], **condition)
    return scene


for which, condition in (("a roller by hand", {"Type": "Dirichlet", "Displacement_X": 0}),
                         ("a clamp", {"Type": "Dirichlet", "Displacement_X": 0,
                                      "Displacement_Y": 0}),
                         ("a pressure", {"Type": "Neumann", "Traction_X": 0.01})):
    scene = stacked(**condition)
    scene["upper"].pop("Rigid Motions")
    refused(which, scene, "Bodies->upper->Boundary Conditions->line",
            "rollers by themselves", "leave a gap", Contacts=JOINT)
refused("met by a body", stacked(), "Contacts->other->Between: 'upper:line'", Contacts={
    **JOINT, "other": {"Between": ["upper:line", "lower:side"]}})
tall = stacked(Type="Contact")
corners = tall["upper"]["Geometry"]["Vertices"]
tall["upper"]["Geometry"].update(Vertices=corners + [[0, 0.5]],
                                 Edges=["bottom", "side", "top", "line", "slit"])
tall["upper"]["Mesh"] = {"Elements per Edge": [2, 2, 2, 1, 1]}
tall["upper"]["Boundary Conditions"]["slit"] = {"Type": "Neumann", "Traction X": 0.01}
refused("obstacle and pressure", tall, "Bodies->upper->Boundary Conditions->slit",
        Contacts=JOINT)
# under 0.01 on what is drawn a half carries 0.02, a copy 0.01; the lower one, a half, bears 0.02
vertex = stacked()
vertex["upper"]["Geometry"]["Vertices"] = [[0.25, 0], [0.75, 0], [1, 1], [0, 1]]
gap = stacked()
gap["upper"]["Geometry"]["Vertices"] = [[0.01, 0], [0.99, 0], [1.01, 1], [0.01, 1]]
for which, scene, copies in (("a half", stacked(), 1),
                             ("pressing its image", stacked(Type="Contact"), 2),
                             ("touching in a corner", vertex, 2), ("beside the line", gap, 2)):
    folder = solved(which, file_of(which, scene, False, Contacts=JOINT),
                    "Discretization->Degree=2")[0]
    loads = {r["body"]: r for r in rows(folder, "bodies.csv")}
    claim(abs(loads["upper"]["load_y"] + 0.02 / copies) < 1e-12 and
          abs(loads["lower"]["contact_y"] + 0.02) < 1e-6,
          "%s: %g on the upper block, %g on the lower one" % (
              which, loads["upper"]["load_y"], loads["lower"]["contact_y"]))
refused("across", changed(punch(False), "punch", "Motion", Displacement_X="0"),
        "Motion->Displacement X", "no motion across", Contacts=STAMP)
refused("moment", changed(punch(False), "punch", "Motion", Moment="1"), "Motion->Moment",
        Contacts=STAMP)
for load in ({"Gravity X": "1"}, {"Spin": "1", "Center": [0.5, 0]}, {"Angular Acceleration": "1"}):
    refused("load " + next(iter(load)), changed(on_obstacle(False), "block", "Material", Density=1),
            "Body Loads: of bodies that are symmetric", **{"Body Loads": load})
bulging = on_obstacle(False)
bulging["block"]["Geometry"] = {"Vertices": [[0, 0], [1, 0], [1, 1], [0, 1], [0, 0.5]],
                                "Edges": ["bottom", "side", "top", "any", "any"],
                                "Bulges": [0, 0, 0, 0, 0.2]}
bulging["block"]["Mesh"] = {"Elements per Edge": [1] * 5}
refused("bulge", bulging, "beyond the line of symmetry")
bulging["block"]["Geometry"].update(
    {"Edges": ["bottom", "symmetry", "top", "any", "any"], "Bulges": [0] * 5})
refused("name", bulging, "'symmetry'", "take another name")
fails("an unknown axis", ["Geometry->Symmetry"], "check", file_of("good", on_obstacle(False), False),
      "--set", "Geometry->Symmetry=Z")


def beside(low, side, left, *conditions):
    """A block at a distance `left` from the line, on the right or the left of it."""
    corners = [[left, low], [0.8, low], [0.8, low + 1], [left, low + 1]][::side]
    names = ["foot", "side", "top", "any"] if side > 0 else ["top", "side", "foot", "any"]
    return {"Material": STEEL, "Geometry": {"Vertices": [[side * x, y] for x, y in corners],
                                            "Edges": names}, "Boundary Conditions": {
        edge: {"Type": "Dirichlet", "Displacement X": x, "Displacement Y": y}
        for edge, x, y in conditions}}


for side in (1, -1):
    for motion in (-0.08, -0.03):  # the gap to the line is 0.05
        both = {"pad": beside(1, side, 0.05, ("top", "%g" % (side * motion), "-0.001")),
                "base": beside(0, side, 0, ("foot", "0", "0"))}
        _, text = solved("beyond", file_of("beyond", both, False, Contacts={
            "joint": {"Between": ["pad:foot", "base:top"]}}), "Discretization->Degree=1")
        claim(("'pad', deformed, overlaps its mirror image" in text) == (motion < -0.05),
              "a body that moves by %g, to the line or beyond" % (side * motion))
for law, sliding, jumps in (({"Law": "Coulomb", "Coefficient": "0.3"}, "0.01*t", True),
                            ({"Law": "Coulomb", "Coefficient": "0.3"}, "0.01*x*t", False),
                            ({"Law": "Coulomb", "Coefficient": "0.3"}, "0.01*t*log(abs(x))",
                             False),
                            ({"Law": "None"}, "0.01*t", False)):
    joint = {"joint": {**JOINT["joint"], "Friction": law, "Sliding": sliding}}
    if law["Law"] == "None":
        joint["joint"]["Wear"] = {"Coefficient": "0.1"}
    code, text = epafi("check", file_of("slides", two_blocks(False), False, Contacts=joint,
                                        History={"Times": [1]}))
    claim(code == 0 and ("slides the other way" in text) == jumps,
          "sliding by %s under %s at the line of symmetry: %s" % (
              sliding, law["Law"], text.splitlines()[-1]))

# Westergaard's wave: p0 = 2 (p π E* A/L)^½.  At a roller it goes on as at a line of symmetry
PLATE = {"Young's Modulus": 200000, "Poisson's Ratio": 0.3}
ROLLER = {"Type": "Dirichlet", "Displacement X": 0}
WAVE = "0.005*(1 - cos(2*pi*x))"


def pressed(name, bodies, **more):
    folder, text = solved(name, saved(name, {"Bodies": bodies, **more}))
    return rows(folder, "history.csv")[-1]


def plate(left, right, low, ends, roller, **conditions):
    return {"Material": PLATE,
            "Geometry": {"Vertices": [[left, low], [right, low], [right, low + 1], [left, low + 1]],
                         "Edges": ["foot", ends[1], "head", ends[0]]},
            "Boundary Conditions": {"side": roller, **conditions}}


def westergaard(moduli):
    return 2 * math.sqrt(300 * math.pi * 200000 / (1 - 0.3**2) / moduli * 0.005)


PRESS = {"Type": "Neumann", "Pressure": 300}
BOTH = ["side", "side"]
for name, roller in (("a roller", ROLLER), ("a support", {
        "Type": "Dirichlet", "Displacement Normal": 0}), ("a roller that is moved", {
            "Type": "Dirichlet", "Displacement X": 0.001})):
    found = pressed("wave", {"wave": plate(0, 0.5, 0, BOTH, roller, head=PRESS, foot={
        "Type": "Contact", "Gap": WAVE})})
    claim(differ(found["pressure_max"], westergaard(1)) < 3e-3 and not found["pressure_unbounded"],
          "half a wave, %s at its crest: %.0f, exactly %.0f" % (name, found["pressure_max"], westergaard(1)))
FOOT = {"Type": "Contact", "Gap": WAVE, "Friction": {"Law": "Coulomb", "Coefficient": 0.3}}
found = [pressed("stuck", {"wave": plate(0, 0.5, 0, ends, ROLLER, head=PRESS, foot=FOOT)}, **more)
         for ends, more in ((BOTH, {}), (["symmetry", "side"], {"Geometry": {"Symmetry": "X"}}))]
claim(differ(*(each["pressure_max"] for each in found)) < 3e-3,
      "with friction a roller at the crest is a line of symmetry: %s" % [each["pressure_max"] for each in found])
# of two bodies, whichever is first; then one that goes on beyond the line, a gap with a slope
BASE = {"foot": {"Type": "Dirichlet", "Displacement Y": 0}}
JOIN = {"Interference": "-" + WAVE}
above = {"wave": plate(0, 0.5, 1, BOTH, ROLLER, head=PRESS)}
below = {"flat": plate(0, 0.5, 0, BOTH, ROLLER, **BASE)}
for sides in (["wave:foot", "flat:head"], ["flat:head", "wave:foot"]):
    found = pressed("waves", {**above, **below}, Contacts={"joint": {"Between": sides, **JOIN}})
    claim(differ(found["pressure_max"], westergaard(2)) < 3e-3 and not found["pressure_unbounded"],
          "two bodies, %s first: %.0f, exactly %.0f" % (sides[0], found["pressure_max"], westergaard(2)))
for name, bodies, more in (
        ("what goes on opposite", {**above, "flat": plate(-0.5, 0.5, 0, ["end", "side"], ROLLER, **BASE)},
         {"Contacts": {"joint": {"Between": ["wave:foot", "flat:head"]}}}),
        ("a gap with a slope", {"wave": plate(0, 0.5, 0, BOTH, ROLLER, head=PRESS, foot={
            "Type": "Contact", "Gap": "0.02*x"})}, {})):
    found = pressed("beyond the roller", bodies, Adaptivity={"Tolerance": 0.003}, **more)
    claim(found["pressure_unbounded"] == 1, "a pressure without bound beside a roller, %s: %s" % (
        name, found["pressure_max"]))
finish()
