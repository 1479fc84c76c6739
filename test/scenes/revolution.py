"""Solids of revolution against closed forms and numbers known to twelve digits
(doc/theory/axisymmetric.md), and what they refuse."""
import math
import os

from runs import WORK, claim, epafi, finish, rows, run, saved

ELASTIC = {"Young's Modulus": 1, "Poisson's Ratio": 0.3}
QUARTER = math.tan(math.pi / 8)
GRADED = {"Strategy": "Graded hp", "Maximum Levels": 60, "Maximum Degrees of Freedom": 4000}


def clamp(**displacements):
    return {"Type": "Dirichlet", **{"Displacement " + c: u for c, u in displacements.items()}}


def body(vertices, edges, conditions=None, material=ELASTIC, **more):
    outline = {"Vertices": vertices, "Edges": edges}
    if "bulges" in more:
        outline["Bulges"] = more.pop("bulges")
    return {"Material": material, "Geometry": outline,
            **({"Boundary Conditions": conditions} if conditions else {}), **more}


def scene(bodies, size=1, degree=1, adaptivity=None, **more):
    return {"Geometry": {"Type": "Axisymmetric"}, "Bodies": bodies,
            "Discretization": {"Mesh Size": size, "Degree": degree},
            **({"Adaptivity": adaptivity} if adaptivity else {}), **more}


def last(name, keys):
    history, points = run(saved(name, keys), name)
    return history[-1], points


def column(vertices, conditions, **more):
    return body(vertices, ["base", "side", "top", "axis"], conditions, **more)


CYLINDER = [[0, 0], [1, 0], [1, 2], [0, 2]]

# pressed on a rigid plane without friction: uniform stress, exact on every mesh
for level in (1, 2):
    row, points = last("patch", scene({"block": column(CYLINDER, {
        "base": {"Type": "Contact", "Gap": 0},
        "top": {"Type": "Neumann", "Traction Y": -0.01}})}, degree=level))
    error = max(abs(p["lambda_n"] - 0.01) for p in points)
    claim(error < 1e-14, "patch: pressure within %.1e" % error)
    claim(abs(row["force_normal"] / (0.01 * math.pi) - 1) < 1e-13,
          "patch: the force of the whole revolution, %.15g" % row["force_normal"])
    claim(abs(row["energy_strain"] / (0.5 * 1e-4 * 2 * math.pi) - 1) < 1e-12,
          "patch: the energy, %.15g" % row["energy_strain"])

# between clamped ends
row, _ = last("clamped", scene({"block": column(CYLINDER, {
    "base": clamp(X=0, Y=0), "top": clamp(X=0, Y=-0.01)})}, degree=2,
    adaptivity={**GRADED, "Tolerance": 3e-4}))
force = 2 * row["energy_strain"] / 0.01
claim(abs(force / 1.656095199650e-2 - 1) < 2e-7,
      "clamped ends: force %.12g with %d unknowns" % (force, row["dof_displacement"]))


# one half of a ball, pressed by its equator: on an obstacle, whose gap is along the ball's normal,
# and on a rigid plane, which is met along its own: as the surface moves inward by some (1-2 nu), that
# makes a difference of (1-2 nu)/(pi (1-nu)) a/R in the force
def ball(depth, round=None, ratio=0.3):
    return body([[0, -1], [1, 0], [0, 0]], ["round", "equator", "axis"],
                {"equator": clamp(Y=-depth), **({"round": round} if round else {})},
                bulges=[QUARTER, 0, 0], material={**ELASTIC, "Poisson's Ratio": ratio})


def pressed(name, bodies, **more):
    row, _ = last(name, scene(bodies, size=0.25, degree=2,
                              adaptivity={**GRADED, "Tolerance": 2e-4}, **more))
    return row


OBSTACLE = {"Type": "Contact", "Gap": "(1 + y)/max(-y, 0.1)"}
PLANE = body([[0, -2], [3, -2], [3, -1], [0, -1]], ["down", "side", "up", "axis"],
             material={"Rigid": True})
row = pressed("ball", {"ball": ball(0.1, OBSTACLE)})
force = -row["reaction_y"]
claim(abs(force / 5.05271079e-2 - 1) < 1e-6,
      "ball: force %.9g, %d unknowns" % (force, row["dof_displacement"]))
for ratio in (0.3, 0.5):
    force = -pressed("light ball %g" % ratio, {"ball": ball(1e-3, OBSTACLE, ratio)})["reaction_y"]
    name = "ball on a plane %g" % ratio
    pressed(name, {"ball": ball(1e-3, None, ratio), "plane": PLANE},
            Contacts={"c": {"Between": ["ball:round", "plane:up"]}})
    part = (rows(name, "bodies.csv")[-1]["reaction_y"] / force - 1) / math.sqrt(1e-3)
    claim(abs(part - (1 - 2 * ratio) / (math.pi * (1 - ratio))) < 0.01,
          "ball on a plane, nu = %g: the force differs by %.4f a/R from that on an obstacle" % (
              ratio, part))

# shrunk hollow spheres: uniform pressure
STEEL = {"Young's Modulus": 210e3, "Poisson's Ratio": 0.3}


def shell(inner, outer, names):
    return body([[0, -outer], [outer, 0], [0, outer], [0, inner], [inner, 0], [0, -inner]],
                [names[1], names[1], "axis", names[0], names[0], "axis"],
                bulges=[QUARTER, QUARTER, 0, -QUARTER, -QUARTER, 0], material=STEEL,
                **{"Rigid Motions": {"Fix": ["Y"]}} if names[0] == "bore" else {})


row, points = last("spheres", scene({"inner": shell(10, 20, ("bore", "fit")),
                                     "outer": shell(20, 30, ("fit", "out"))},
                                    size=16, degree=8, Contacts={"fit": {
                                        "Between": ["inner:fit", "outer:fit"],
                                        "Interference": 0.01}}))
error = max(abs(p["lambda_n"] / 63.9423076923 - 1) for p in points)
claim(error < 1e-6, "hollow spheres: pressure within %.1e" % error)


# a flat punch with friction on a clamped block ten times as large: where it sticks
row, _ = last("stick", scene({"block": body(
    [[0, -10], [10, -10], [10, 0], [1, 0], [0, 0]], ["base", "side", "top", "punch", "axis"],
    {"base": clamp(X=0, Y=0.01), "punch": {"Type": "Contact", "Gap": 0, "Friction": {
        "Law": "Coulomb", "Coefficient": 0.2}}})}, size=5, adaptivity={
            **GRADED, "Tolerance": 3e-4}))
claim(abs(1 - row["slip_length"] - 0.716234) < 2e-3,
      "flat punch: it sticks up to %.6f, %d unknowns" % (
          1 - row["slip_length"], row["dof_displacement"]))

# a hub on a longer shaft, one half of both: the work of the fit is half of force times interference
fit = scene({
    "hub": body([[1, 0], [2, 0], [2, 1], [1, 1]], ["middle", "side", "end", "bore"]),
    "shaft": body([[0, 0], [1, 0], [1, 3], [0, 3]], ["middle", "seat", "end", "axis"])},
    size=1, degree=2, adaptivity={**GRADED, "Tolerance": 2e-3},
    Contacts={"fit": {"Between": ["hub:bore", "shaft:seat"], "Interference": 1e-3}})
fit["Geometry"]["Symmetry"] = "Y"
row, _ = last("fit", fit)
force = row["energy_strain"] / 1e-3
claim(abs(force / 2.41165312e-3 - 1) < 1e-5,
      "hub on a shaft: force %.9g with %d unknowns" % (force, row["dof_displacement"]))

def refused(name, words, keys):
    code, text = epafi("check", saved(name, keys))
    claim(code == 1 and all(word in text for word in words),
          "%s: refused: %s" % (name, text.strip()[-300:]))


BLOCK = {"base": clamp(X=0, Y=0)}
refused("beyond", ["Bodies->b->Geometry", "x >= 0"],
        scene({"b": column([[-1, 0], [1, 0], [1, 2], [-1, 2]], BLOCK)}))
refused("fix", ["Fix", "Y"], scene({"b": column(CYLINDER, {}, **{
    "Rigid Motions": {"Fix": ["X"]}})}))
refused("plane state", ["Plane State"], scene({"b": column(
    CYLINDER, BLOCK, material={**ELASTIC, "Plane State": "Plane Stress"})}))
refused("axis", ["axis"], scene({"b": column(CYLINDER, {**BLOCK, "axis": clamp(X=0)})}))
symmetric = scene({"b": column(CYLINDER, BLOCK)})
symmetric["Geometry"]["Symmetry"] = "X"
refused("mirrored", ["Geometry->Symmetry"], symmetric)
for key, value in (("Stabilization", {"Form": "Exact"}), ("Multiplier", "Biorthogonal")):
    other = scene({"b": column(CYLINDER, BLOCK)})
    other["Discretization"][key] = value
    refused(key, ["Discretization->" + key], other)
refused("compressed", ["Solver->Linear->Method"], scene(
    {"b": column(CYLINDER, BLOCK)}, Solver={"Linear": {"Method": "Compressed"}}))
refused("weight", ["Body Loads: ", "not possible"], scene({"b": column(
    CYLINDER, BLOCK, material={**ELASTIC, "Density": 1})}, **{
    "Body Loads": {"Gravity Y": -1}}))
refused("inside", ["Output->Interior Points"], scene(
    {"b": column(CYLINDER, BLOCK)}, Output={"Interior Points": [[0.5, 0.5]]}))
refused("heat", ["Thermal Conditions"], scene({"b": column(
    CYLINDER, BLOCK, material={**ELASTIC, "Thermal Expansion": 1e-3, "Conductivity": 1},
    **{"Thermal Conditions": {"base": {"Temperature": 1}}})}))

finish()
