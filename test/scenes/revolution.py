"""Solids of revolution against closed forms and numbers known to twelve digits
(doc/theory/axisymmetric.md), and what they refuse."""
import math
import os

from epafi import Run
from revolved import (CYLINDER, ELASTIC, GRADED, QUARTER, body, clamp, column, last, refused,
                      scene)
from runs import WORK, claim, epafi, finish, largest, rows

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

# a shell without change of volume under pressure from both sides: u = B/R^2; each surface, to the axis,
# is a closed one, whose normal field the densities do not feel
for radius, inside, outside in ((1, 0.2, 0), (1.9, 0.3, 0.1)):
    row, _ = last("shell", scene({"shell": body(
        [[0, -2], [2, 0], [0, 2], [0, radius], [radius, 0], [0, -radius]],
        ["out", "out", "axis", "in", "in", "axis"],
        {"in": {"Type": "Neumann", "Pressure": inside}, "out": {"Type": "Neumann", "Pressure": outside}},
        {**ELASTIC, "Poisson's Ratio": 0.5}, bulges=[QUARTER, QUARTER, 0, -QUARTER, -QUARTER, 0],
        **{"Rigid Motions": {"Fix": ["Y"]}})}, degree=11))
    excess = inside - outside
    energy = 2 * math.pi * excess**2 / (4 / 3 * (1 / radius**3 - 1 / 8))
    error = abs(row["energy_strain"] / energy - 1)
    claim(error < 1e-9, "shell without change of volume: energy within %.1e" % error)


# Hertz, exactly: a rigid paraboloid on a block whose base and side move as in the half-space, by the
# potentials V of the pressure sqrt(1 - x^2) and, its integral over the depth, chi
def hertz():
    ratio = ELASTIC["Poisson's Ratio"]
    names = {"Z": "(-y)", "M": "sqrt((x^2 + y^2 - 1 + sqrt((x^2 + y^2 - 1)^2 + 4*y^2))/2)"}
    names["N"], names["T"] = "({Z}/{M})".format(**names), "atan2(1, {M})".format(**names)
    v = "pi/2*(2*{T} - x^2*({T} - {M}/(1 + {M}^2)) - 2*({Z}*{N} - {Z}^2*{T}))"
    v_z, v_r = "(-2*pi*({N} - {Z}*{T}))", "(-pi*x*({T} - {M}/(1 + {M}^2)))"
    chi_r = "(x < 1e-3 ? -x/2*" + v_z + (
        " : pi/max(x, 1e-3)*(2/3 - x^2*{Z}*{T} + {M}*{Z}/3 + 2/3*{N}*x^2 - {N}*{Z}^2/3 - 2/3*{N}))")
    scale = -(1 + ratio) / (2 * math.pi)  # -1/(4 pi mu)
    moved = {"Type": "Dirichlet",
             "Displacement X": ("%.17g*(%.17g*" % (scale, 1 - 2 * ratio) + chi_r + " + {Z}*" + v_r +
                                ")").format(**names),
             "Displacement Y": ("%.17g*(%.17g*" % (scale, 2 * (1 - ratio)) + v + " - {Z}*" + v_z +
                                ")").format(**names)}
    depth = math.pi / 2 * (1 - ratio**2)
    return {"block": body([[0, -3], [3, -3], [3, 0], [1.5, 0], [0, 0]],
                          ["base", "side", "free", "top", "axis"], {
                              "base": moved, "side": moved, "top": {
                                  "Type": "Contact", "Gap": "%.17g*(x^2/2 - 1)" % depth}})}


row, points = last("Hertz", scene(hertz(), size=0.75, degree=2, adaptivity={
    **GRADED, "Maximum Degrees of Freedom": 300}))
error = abs(row["force_normal"] / (2 * math.pi / 3) - 1)
claim(error < 1e-8, "Hertz: force within %.1e with %d unknowns" % (
    error, row["dof"] + row["dof_density"]))
middle = min(points, key=lambda p: p["x"])
error = abs(middle["pressure"] / math.sqrt(1 - middle["x"]**2) - 1)
claim(error < 1e-4 and abs(row["contact_length"] - 1) < 2e-3,
      "its pressure in the middle within %.1e, its end %.6f" % (error, row["contact_length"]))


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
    claim(abs(part - (1 - 2 * ratio) / (math.pi * (1 - ratio))) < 0.03,
          "ball on a plane, nu = %g: the force differs by %.4f a/R from that on an obstacle" % (
              ratio, part))

# shrunk hollow spheres: uniform pressure
STEEL = {"Young's Modulus": 210e3, "Poisson's Ratio": 0.3}


def shell(inner, outer, names, conditions=None):
    return body([[0, -outer], [outer, 0], [0, outer], [0, inner], [inner, 0], [0, -inner]],
                [names[1], names[1], "axis", names[0], names[0], "axis"],
                conditions, bulges=[QUARTER, QUARTER, 0, -QUARTER, -QUARTER, 0], material=STEEL,
                **{"Rigid Motions": {"Fix": ["Y"]}} if names[0] == "bore" else {})


row, points = last("spheres", scene({"inner": shell(10, 20, ("bore", "fit")),
                                     "outer": shell(20, 30, ("fit", "out"))},
                                    size=16, degree=8, Contacts={"fit": {
                                        "Between": ["inner:fit", "outer:fit"],
                                        "Interference": 0.01}}))
error = max(abs(p["lambda_n"] / 63.9423076923 - 1) for p in points)
claim(error < 1e-6, "hollow spheres: pressure within %.1e" % error)


# hollow spheres without compression: bore and outside are two surfaces.  In a rigid bowl too small by 0.01
# u = -0.01 b^2/r^2; the radii are such that the longest edge is the axis, too
def bowl(conditions, **more):
    rigid = {"Young's Modulus": 3, "Poisson's Ratio": 0.5}
    return scene({"ball": body(
        [[0, -20], [20, 0], [0, 20], [0, 2], [2, 0], [0, -2]], ["out", "out", "axis", "bore", "bore", "axis"],
        conditions, bulges=[QUARTER, QUARTER, 0, -QUARTER, -QUARTER, 0], material=rigid, **more)},
        size=16, degree=12)


_, points = last("bowl", bowl({"out": {"Type": "Contact", "Gap": -0.01}}))
exact = 4 * 0.01 * 20**2 * (1 / 2**3 - 1 / 20**3)
error = max(abs(p["lambda_n"] / exact - 1) for p in points)
claim(error < 1e-5, "hollow sphere without compression: pressure within %.1e" % error)
_, points = last("pressed bowl", bowl({
    "out": {"Type": "Contact", "Gap": 0}, "bore": {"Type": "Neumann", "Pressure": 1}}))
error = max(abs(p["lambda_n"] - 1) for p in points)
claim(error < 1e-9, "it hands a pressure on: within %.1e" % error)
refused("a bore without compression", ["closed surface", "'bore'"], bowl(
    {"out": {"Type": "Contact", "Gap": 0}, "bore": clamp(X=0, Y=0)}))

# a hollow sphere under pressure inside: stresses around the axis
last("shell", scene({"shell": shell(10, 20, ("bore", "out"), {
    "bore": {"Type": "Neumann", "Pressure": 1}})}, size=16, degree=14))
WHOLE = Run(os.path.join(WORK, "shell"))


def along(x, y):
    return (1 - 8e3 / math.hypot(x, y)**3) / 7


def around(x, y):
    return (1 + 4e3 / math.hypot(x, y)**3) / 7


places = [(r * math.sin(a), r * math.cos(a)) for r in (10.0001, 11, 15, 19.9)
          for a in (-2, -1e-3, 0, 1e-8, 0.4, 1.5, math.pi)]
found = WHOLE.fields(places)
claim(largest(found["hoop"] - [around(*p) for p in places]) < 1e-10 and
      largest(found["syy"] - [(along(x, y) * y**2 + around(x, y) * x**2) / (x**2 + y**2)
                              for x, y in places]) < 1e-10 and
      largest(found["sxy"] - [(along(x, y) - around(x, y)) * x * y / (x**2 + y**2)
                              for x, y in places]) < 1e-10,
      "stresses inside a hollow sphere, on both sides of the axis, within %.1e" % largest(
          found["hoop"] - [around(*p) for p in places]))
boundary = rows("shell", "boundary.csv")
error = largest(p["hoop"] - around(p["x"], p["y"]) for p in boundary)
claim(error < 1e-10 and {p["boundary"] for p in boundary} == {"bore", "out", "axis"},
      "and on its boundary: %.1e" % error)
deep = WHOLE.fields(along="shell:bore", depth=1e-3)
error = largest(deep["hoop"] - [around(*p) for p in zip(deep["x"], deep["y"])])
claim(error < 1e-9, "and below it: %.1e" % error)
code, text = epafi("fields", os.path.join(WORK, "shell"), "--vtk")
claim(code == 0, "fields.vtu: " + text)
code, text = epafi("plot", os.path.join(WORK, "shell"), "--field", "hoop")
claim(code == 0 and os.path.isfile(os.path.join(WORK, "shell", "hoop.png")), "hoop.png: " + text[-200:])
code, text = epafi("plot", os.path.join(WORK, "shell"), "--field", "szz")
claim(code != 0 and "hoop" in text, "szz is called hoop: " + text[-200:])
picture = os.path.join(WORK, "shell", "scene.png")
code, text = epafi("check", os.path.join(WORK, "shell.yaml"), "--plot", picture)
claim(code == 0 and os.path.isfile(picture), "check --plot: " + text[-200:])

# corners off the axis are those of plane strain
inPlane = scene({"block": column([[-1, 0], [1, 0], [1, 2], [-1, 2]], {
    "base": clamp(X=0, Y=0), "top": clamp(X=0, Y=-0.01)})}, degree=2, adaptivity={
        **GRADED, "Maximum Levels": 8})
inPlane["Geometry"] = {}
last("plane", inPlane)
there, here = (Run(os.path.join(WORK, name)).intensities() for name in ("plane", "clamped"))
exponents = {round(float(e), 6) for e in there["exponent"]}
claim(len(here["exponent"]) > 0 and {round(float(e), 6) for e in here["exponent"]} <= exponents and
      min(here["x"]) > 0.9, "corners off the axis: exponents %s of %s" % (
          sorted(here["exponent"]), sorted(exponents)))

# a flat punch with friction on a clamped block ten times as large: where it sticks
row, _ = last("stick", scene({"block": body(
    [[0, -10], [10, -10], [10, 0], [1, 0], [0, 0]], ["base", "side", "top", "punch", "axis"],
    {"base": clamp(X=0, Y=0.01), "punch": {"Type": "Contact", "Gap": 0, "Friction": {
        "Law": "Coulomb", "Coefficient": 0.2}}})}, size=5, adaptivity={
            **GRADED, "Tolerance": 3e-4}))
claim(abs(1 - row["slip_length"] - 0.716234) < 2e-3,
      "flat punch: it sticks up to %.6f, %d unknowns" % (
          1 - row["slip_length"], row["dof_displacement"]))

# a rigid paraboloid that goes in with friction: contact and stick grow in proportion (Spence), but for
# half of what a step of the path adds; on a half-space they are as of the flat punch, .19983
FAR = [80, 42, 22, 12, 7, 4, 2.5, 1.8, 1.45, 1.25, 1.15, 1.1]
spence = scene({"block": body(
    [[0, -80], [80, -80], *([x, 0] for x in FAR), [0.3, 0], [0, 0]],
    ["base", "side", *["top"] * (len(FAR) - 1), "ball", "ball", "axis"], {
        "base": clamp(X=0, Y=0), "ball": {"Type": "Contact", "Gap": "(x^2/2 - t^2)/50", "Friction": {
            "Law": "Coulomb", "Coefficient": 0.1}}},
    **{"Mesh": {"Elements per Edge": [3, 3, *[2] * (len(FAR) - 1), 80, 30, 1]}})},
    degree=2, History={"Times": [k / 10 for k in range(1, 11)], "Steps": [6] * 10})
del spence["Discretization"]["Mesh Size"]
last("Spence", spence)
shares = [1 - row["ball.slip_length"] / row["ball.contact_length"] for row in rows("Spence", "steps.csv")
          if row["t"] > 0.49 and round(row["step"]) % 6 == 0]  # where contact ends at a node
claim(abs(shares[-1] - 0.19983) < 2e-3 and max(shares) < 1.01 * min(shares),
      "a ball that goes in sticks on .19983 of the contact: %.5f to %.5f" % (min(shares), max(shares)))

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

# sides of radii 1.1 and 1: what presses on the shaft is 1.1 times what presses on the hub, and so it is in
# the residuals of the stabilisation, whose strength does not matter
for between in (["hub:bore", "shaft:seat"], ["shaft:seat", "hub:bore"]):
    energies = []
    for gamma in (0.5, 50):
        held = {"low": clamp(Y=0), "high": clamp(Y=0)}
        gap = scene({
            "hub": body([[1.1, 0], [2, 0], [2, 1], [1.1, 1]], ["low", "out", "high", "bore"], held),
            "shaft": body([[0, 0], [1, 0], [1, 1], [0, 1]], ["low", "seat", "high", "axis"], held)},
            size=0.5, degree=8, Contacts={"fit": {"Between": between, "Interference": 0.101}})
        gap["Discretization"]["Stabilization"] = {"Gamma0": gamma}
        row, points = last("gap of rings", gap)
        energies.append(row["energy_strain"])
    # what Lame's rings yield by the pressure on the hub
    yields = 1.3 * 1.1 * ((0.4 * 1.21 + 4) / (4 - 1.21) + 0.4)
    ratio = yields / 1e-3 / (1 if between[0] == "hub:bore" else 1.1)
    error = max(abs(p["lambda_n"] * ratio - 1) for p in points)
    claim(error < 1e-7, "%s first: pressure within %.1e" % (between[0], error))
    claim(abs(energies[1] / energies[0] - 1) < 1e-9, "energies with Gamma0 0.5 and 50 differ by %.1e" % (
        energies[1] / energies[0] - 1))

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

finish()
