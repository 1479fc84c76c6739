"""Stress intensities against closed forms; numbers of a scene are the program's.

    indicators.py EPAFI WORK
"""
import math
import os
import sys
import warnings

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, raises, read, write  # noqa: E402

WORK = absent(sys.argv[2])
import epafi  # noqa: E402
from epafi.fatigue import swt  # noqa: E402
from epafi.intensities import paired  # noqa: E402
from epafi.wedges import CLAMPED, FREE, Corner, Wedge, held, modes, sliding  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)  # loads are of size 1: large displacements
SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers", "scenes")
PI, NU = math.pi, 0.3
KAPPA = 3 - 4 * NU


def wedge(angle, start=0.0, mu=1.0, kappa=KAPPA):
    return Wedge(start, start + angle, mu, kappa)


def exponents(*wedges, joints=(), faces=(FREE, FREE)):
    return [mode.exponent for mode in modes(Corner(wedges, joints, faces))]


def near(found, expected, bound=1e-10):
    return len(found) == len(expected) and np.allclose(found, expected, rtol=0, atol=bound)


def close(a, b):
    return abs(a - b) < 1e-9 * abs(b)


# exponents: Williams' equations
def zero(function, low, high):
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (middle, high) if function(low) * function(middle) > 0 else (low, middle)
    return middle


opening = zero(lambda x: math.sin(1.5 * PI * x) + x * math.sin(1.5 * PI), 0.4, 0.7)
sheared = zero(lambda x: math.sin(1.5 * PI * x) - x * math.sin(1.5 * PI), 0.8, 0.95)
claim(abs(opening - 0.5444837368) < 1e-10 and near(exponents(wedge(1.5 * PI)), [opening, sheared]),
      "a free corner of 270 degrees: %.10f, %.10f" % (opening, sheared))
claim(near(exponents(wedge(2 * PI)), [0.5, 0.5]) and
      exponents(wedge(0.9 * PI)) == [], "a crack: 1/2 for both modes; a convex corner: none")
claim(near(exponents(wedge(0.7), wedge(1.5 * PI - 0.7, 0.7), joints=(None,)),
           exponents(wedge(1.5 * PI))), "a bond within one material changes nothing")
mixed = exponents(wedge(PI / 2), faces=(CLAMPED, FREE))
claim(near([math.sin(x.real * PI / 2) ** 2 for x in mixed],
           [(KAPPA + 1) ** 2 / (4 * KAPPA) - x.real ** 2 / KAPPA for x in mixed]) and mixed,
      "a clamp that ends at a right angle: %.6f" % mixed[0].real)
claim(near(exponents(wedge(PI), faces=(CLAMPED, FREE)), [0.5 + 1j * math.log(KAPPA) / (2 * PI)]),
      "an adhering flat punch oscillates by ln(kappa)/(2 pi)")
for f in (0.5, 0, -0.5):
    claim(near(exponents(wedge(PI), faces=(sliding(f), FREE)),
               [0.5 - math.atan(f * (1 - 2 * NU) / (2 - 2 * NU)) / PI]),
          "a flat punch that slides with friction %g" % f)
mu, kappa = 10.0, 2.2
beta = ((kappa - 1) - mu * (KAPPA - 1)) / ((kappa + 1) + mu * (KAPPA + 1))
claim(near(exponents(wedge(PI, 0, 1), wedge(PI, PI, mu, kappa), joints=(None,)),
           [0.5 + 1j * math.log((1 + abs(beta)) / (1 - abs(beta))) / (2 * PI)]),
      "a crack between two materials oscillates as Dundurs' beta says")
claim(near(exponents(wedge(PI), wedge(PI / 2, PI, 1e9), joints=(0.3,)),
           exponents(wedge(PI), faces=(FREE, sliding(0.3))), 1e-6),
      "a corner pressed onto a half-plane becomes rigid as its stiffness grows")
claim(near(exponents(wedge(0.8 * PI), faces=(held(PI / 2), FREE)),
           exponents(wedge(0.8 * PI), faces=(sliding(0), FREE))) and
      near(exponents(wedge(0.8 * PI), faces=(sliding(0), FREE)),
           [x for x in exponents(wedge(1.6 * PI)) if abs(
               np.sin(x * 1.6 * PI) + x * np.sin(1.6 * PI)) < 1e-9]),
      "a roller is the symmetric half of twice the angle")
square = Corner((wedge(PI / 2), wedge(1.5 * PI, PI / 2)), (None, None))
claim(modes(square) == [], "all around one material nothing is singular")


def clamped(angle):
    return Corner((wedge(angle),), (), (CLAMPED, FREE))


low, high = math.radians(120), PI  # two real exponents; two conjugate ones
for _ in range(50):
    middle = (low + high) / 2
    low, high = (low, middle) if modes(clamped(middle))[0].exponent.imag > 1e-7 else (middle, high)
for angle, known in ((low, False), (low - 1e-3, True)):
    alike = modes(clamped(angle))[:1]
    claim((paired(clamped(angle), alike) is not None) == known,
          "a clamp that ends at %.6f degrees has %s" % (math.degrees(angle), "K" if known else
                                                        "a logarithm, and no K"))

# intensities
GRADED = {"Adaptivity->Strategy": "Graded hp", "Adaptivity->Maximum Levels": 30,
          "Discretization->Degree": 2}


def solved(scene, dof, **settings):
    return epafi.run(scene, threads=1, set={
        **GRADED, "Adaptivity->Maximum Degrees of Freedom": dof, **settings}).intensities()


punch = epafi.Scene.read(os.path.join(SHIPPED, "punch.xml")).changed(
    {"Discretization->Elements per Edge": [2, 2, 2, 4, 2, 2, 2, 2, 2, 2]})
flat = solved(punch, 800)
claim(flat.size == 2 and near(flat["exponent"], [-0.5] * 2) and not flat["k_shear"].any() and
      abs(flat["k_normal"] * math.sqrt(PI) + 1).max() < 4e-3 and set(flat["kind"]) == {
          "edge of contact"}, "a flat punch: K = -P / sqrt(pi a), %s" % flat["k_normal"])
glued = punch.changed({"Bodies->block->Rigid Motions": None,
                       "Bodies->block->Boundary Conditions->punch": None})
glued["Bodies"]["block"]["Boundary Conditions"]["punch"] = {
    "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
glued = solved(glued, 800)
size = np.hypot(glued["k_normal"], glued["k_shear"]) * math.sqrt(PI)
claim(abs(size * math.sqrt(KAPPA) / (2 - 2 * NU) - 1).max() < 1e-2 and
      abs(glued["k_shear"] / glued["k_normal"]).max() < 0.03 and near(glued["reach"], [2, 2]),
      "an adhering one: K = P 2 (1 - nu) / sqrt(kappa pi a), without shear at r = 2 a")
tilted = epafi.run(os.path.join(SHIPPED, "tilting-punch.xml"), threads=1).intensities()
edge = tilted["kind"] == "edge of contact"
claim(edge.sum() == 1 and abs(tilted["k_normal"][edge][0] / -0.002 * math.sqrt(0.6 * PI) - 1) < 2e-3,
      "a tilted punch: K = -2 P / sqrt(pi c) at the edge, %s" % tilted["k_normal"][edge])
claim(set(tilted["kind"]) == {"edge of contact", "end of clamp"} and abs(tilted["reach"][edge][0] - 1.2)
      < 0.03, "nothing is singular where it lifts off, at a - 2 c: there its reach ends")


def cracked(half, width, height):
    """Two blocks, bonded beside a crack, pulled apart by 1."""
    x = [-width, -half, half, width]
    material = {"Young's Modulus": 100.0, "Poisson's Ratio": NU}
    lower = [[-width, -height], [width, -height], *([a, 0] for a in x[::-1])]
    return {"Bodies": {
        "lower": {"Material": material, "Geometry": {"Vertices": lower, "Edges": [
            "end", "side", "bond", "crack", "bond", "side"]},
            "Boundary Conditions": {"end": {"Type": "Neumann", "Traction Y": -1}},
            "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}},
        "upper": {"Material": material, "Geometry": {
            "Vertices": [*([a, 0] for a in x), [width, height], [-width, height]],
            "Edges": ["bond", "crack", "bond", "side", "end", "side"]},
            "Boundary Conditions": {"end": {"Type": "Neumann", "Traction Y": 1}}}},
        "Contacts": {"bond": {"Between": ["lower:bond", "upper:bond"],
                              "Friction": {"Law": "Tied"}}},
        "Discretization": {"Mesh Size": 3.0}}


share = 0.2  # of the width; Feddersen's factor with Tada's correction, to 1e-3
factor = (1 - 0.025 * share ** 2 + 0.06 * share ** 4) / math.sqrt(math.cos(PI * share / 2))
slit = solved(epafi.Scene(cracked(1.0, 5.0, 15.0)), 1400)
claim(slit.size == 4 and near(slit["exponent"], [-0.5] * 4) and set(slit["kind"]) == {"end of bond"}
      and abs(slit["k_normal"] / (math.sqrt(PI) * factor) - 1).max() < 5e-3 and
      abs(slit["k_shear"]).max() < 5e-3, "a crack in a strip: K_I = %s, exactly %.4f" % (
          slit["k_normal"], math.sqrt(PI) * factor))
claim(np.ptp(slit["k_normal"]) < slit["k_normal_error"].max() < 1e-4,
      "its tips are alike within the error, %s" % slit["k_normal_error"])


def angled(scale, turn):
    """An L of sides 2, pulled along its arm."""
    corners = scale * np.exp(1j * turn) * np.array([-1 - 1j, -1j, 0, 1, 1 + 1j, -1 + 1j])
    return epafi.Scene({"Bodies": {"L": {
        "Material": {"Young's Modulus": 100.0, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": np.column_stack([corners.real, corners.imag]),
                     "Edges": ["foot", "in", "in", "end", "out", "out"]},
        "Boundary Conditions": {
            "foot": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0},
            "end": {"Type": "Neumann", "Traction X": -math.sin(turn), "Traction Y": math.cos(turn)}}}},
        "Discretization": {"Mesh Size": 0.5 * scale}})


def at_corner(table):
    here = table["kind"] == "corner"
    return [table["k_normal"][here][0], table["k_shear"][here][1]], [
        table["k_normal_error"][here][0], table["k_shear_error"][here][1]]


fine, fine_error = at_corner(solved(angled(1, 0), 900))
coarse, coarse_error = at_corner(solved(angled(1, 0), 300))
claim(np.allclose(coarse, fine, rtol=1e-2) and (np.abs(np.subtract(fine, coarse)) <
      np.add(fine_error, coarse_error)).all() and fine_error[0] < 1e-3 * fine[0],
      "the corner of an L: K_I, K_II = %s, on a coarser mesh %s" % (fine, coarse))


def bent(dof):
    """An L whose inner sides are arcs."""
    tree = angled(1, 0)
    tree["Bodies"]["L"]["Geometry"]["Bulges"] = [0, 0.1, 0.07, 0, 0, 0]
    return at_corner(solved(tree, dof))


(coarse_bent, error), (fine_bent, _) = bent(400), bent(900)
claim((np.abs(np.subtract(coarse_bent, fine_bent)) < error).all() and error[0] < 1e-2 * fine_bent[0],
      "of an L with bent sides: %s, on a coarser mesh %s" % (fine_bent, coarse_bent))
other, _ = at_corner(solved(angled(1000, 0.7), 300))
claim(np.allclose(other, np.array(coarse) * [1000 ** (1 - opening), 1000 ** (1 - sheared)], rtol=2e-3),
      "turned, and as length^(1 - lambda) with the size")


def notched(line):
    """A strip with a notch of 90 degrees, pulled; given a line its half on one side of that."""
    half = [[0, 0.5], [0.5, 0], [1, 0], [1, 2], [0, 2]]
    names = ["notch", "foot", "end", "top"]
    corners, edges, fix = half + [[-x, y] for x, y in half[-2:0:-1]], names + names[::-1], "XY"
    if line:
        corners, edges, fix = half, names + ["any"], "Y"
    if line == "Y":
        corners, fix = [[-y, x] for x, y in corners], "X"
    along = "Y" if line == "Y" else "X"
    return epafi.Scene({"Bodies": {"strip": {
        "Material": {"Young's Modulus": 100.0, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": corners, "Edges": edges},
        "Boundary Conditions": {"end": {"Type": "Neumann", "Traction " + along: "n" + along.lower()}},
        "Rigid Motions": {"Fix": list(fix) + ["Rotation"] * (not line)}}},
        **({"Geometry": {"Symmetry": line}} if line else {}), "Discretization": {"Mesh Size": 0.5}})


notch = solved(notched(None), 500)
for line in "XY":
    half = solved(notched(line), 500)
    claim(list(half["kind"]) == ["corner"] and near(half["exponent"], [opening - 1]) and
          abs(half["k_normal"][0] / notch["k_normal"][0] - 1) < 3e-3 and half["k_shear"][0] == 0,
          "a notch on the line of symmetry %s: K = %s, of the whole %s" % (
              line, half["k_normal"], notch["k_normal"]))


def pressed(**friction):
    """Half of a block on a curved obstacle: nothing is singular."""
    return epafi.Scene({"Bodies": {"block": {
        "Material": {"Young's Modulus": 100.0, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": [[0, 0], [2, 0], [2, 1], [0, 1]],
                     "Edges": ["foot", "side", "top", "any"]},
        "Boundary Conditions": {"top": {"Type": "Neumann", "Traction Y": -1}, "foot": {
            "Type": "Contact", "Gap": "x^2/100",
            "Friction": {"Law": "Coulomb", "Coefficient": 0.5, **friction}}}}},
        "Geometry": {"Symmetry": "X"}, "Discretization": {"Mesh Size": 0.25}})


claim(solved(pressed(), 300).size == 0,
      "where contact meets the line of symmetry, and where it ends, nothing is singular")
claim(solved(pressed(Compliance="0.001*(1 + x^2)"), 200).size == 0,
      "a compliance that varies is none of a rigid surface")


def right_angle(x, y, blunt=0.0, **more):
    """A plate with a notch of 90 degrees, its corner at (x, y) or an arc."""
    corners = [[1, -1], [2, -1], [2, 2], [-2, 2], [-2, -1], [-1, -1]]
    tip = [[-blunt, -blunt], [blunt, -blunt]] if blunt else [[0, 0]]
    names = ["f", "side", "t", "side", "f", "n", *["n"] * len(tip)]
    bulges = [0] * 6 + ([math.tan(-PI / 8), 0] if blunt else [0])
    return epafi.Scene({"Bodies": {"b": {
        "Material": {"Young's Modulus": 100, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": [[x + a, y + b] for a, b in corners + tip], "Edges": names,
                     "Bulges": bulges, **more},
        "Boundary Conditions": {"side": {"Type": "Neumann", "Traction X": "nx"}},
        "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}}, "Discretization": {"Mesh Size": 0.5}})


def within(scene, tolerance):
    return epafi.run(scene, threads=1, set={"Adaptivity->Tolerance": tolerance}).intensities()


tips = [within(right_angle(*place), tolerance) for place, tolerance in (
    ((7, 3), 1e-3), ((7, 3), 1e-5), ((1e6, 1e6), 1e-5))]
claim(all(tip.size == 2 and set(tip["kind"]) == {"corner"} and near(tip["angle"], [270] * 2, 1e-8) for tip
          in tips) and near([tip["k_normal"][0] for tip in tips], [tips[1]["k_normal"][0]] * 3, 2e-5) and
      abs(tips[2]["k_normal"][0] - tips[1]["k_normal"][0]) < 1e-7,
      "a notch is one of 270 degrees on coarse and fine meshes, wherever it is: K_I = %.7f" % (
          tips[1]["k_normal"][0]))
claim(within(right_angle(7, 3, 0.1), 1e-3).size == 0, "a round one has none")
claim(epafi.run(os.path.join(SHIPPED, "press-fit.xml"), threads=1).intensities().size == 0,
      "nor have rings of arcs that are pressed together")
claim(epafi.run(os.path.join(SHIPPED, "spheres.xml"), threads=1).intensities().size == 0,
      "nor balls that touch on their axis")
drilled = within(right_angle(0, 0, **{"Hole 1 Vertices": [[-0.3, 1], [0.3, 1]], "Hole 1 Edges": [
    "hole"] * 2, "Hole 1 Bulges": [1, 1]}), 1e-3)
claim(near(drilled["reach"], [0.7] * 2) and (drilled["k_normal_error"] < 1e-3 * drilled["k_normal"].max()
                                             ).all(), "a round hole above it limits its reach")


def included():
    """A square that is bonded into a hole of a softer plate, which is pulled."""
    square = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
    pull = {"Type": "Neumann", "Traction X": "0.01*nx"}
    return epafi.Scene({"Bodies": {
        "square": {"Material": {"Young's Modulus": 26, "Poisson's Ratio": 0.3},
                   "Geometry": {"Vertices": square, "Edges": ["bond"] * 4}},
        "plate": {"Material": {"Young's Modulus": 2.4, "Poisson's Ratio": 0.2},
                  "Geometry": {"Vertices": [[4 * a, 4 * b] for a, b in square],
                               "Edges": ["bottom", "right", "top", "left"],
                               "Hole 1 Vertices": square, "Hole 1 Edges": ["bond"] * 4},
                  "Boundary Conditions": {"left": pull, "right": pull},
                  "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}},
        "Contacts": {"c": {"Between": ["plate:bond", "square:bond"], "Friction": {"Law": "Tied"}}},
        "Discretization": {"Mesh Size": 1}})


corners = within(included(), 1e-2)
claim(corners.size == 16 and all(np.ptp(np.abs(corners[name][abs(corners["exponent"] - power) < 1e-9])) <
      1e-6 * abs(corners[name]).max() for name in ("k_normal", "k_shear")
      for power in corners["exponent"][[0, 2]]),
      "a square inclusion: both intensities are those of all corners, of both bodies")
path = epafi.run(angled(1, 0).changed({"History": {"Times": [1], "Steps": [2]}, "Bodies->L->Boundary "
                 "Conditions->end->Traction Y": "t"}), threads=1)
claim(np.allclose(path.intensities(1)["k_normal"], path.intensities()["k_normal"] / 2, rtol=1e-9, atol=1e-9)
      and path.intensities().size == 4, "half of the load of a path has half of the intensities")
run = epafi.run(angled(1, 0), os.path.join(WORK, "L"))
claim(">Stress intensities</h2>" in read(run.report()), "a report has them")

# numbers of a scene are the program's, whatever a folder's scene says
wordy = epafi.run(angled(1, 0).changed({
    "Constants": {"lambda": 2, "b": "lambda^2"}, "Bodies->L->Material->Young's Modulus": "25*b",
    "Bodies->L->Material->Poisson's Ratio": "lambda > 1 ? 0.3*ln(exp(1)) : 0",
    "Bodies->L->Boundary Conditions->end->Traction X": "sin(pi)*lambda + nx/2 + y - x",
    "Bodies->L->Boundary Conditions->end->Traction Y": "t*b/4",
    "History": {"Times": [0.5, 1]}}), os.path.join(WORK, "wordy"))
material = wordy.numbers["Bodies"]["L"]["Material"]
end = wordy.numbers["Bodies"]["L"]["Boundary Conditions"]["end"]
claim((material["Young's Modulus"], material["Poisson's Ratio"]) == (100, NU) and
      (end["Traction X"], end["Traction Y"]) == ("sin(pi)*lambda + nx/2 + y - x", 1) and
      wordy.numbers["Constants"] == {"lambda": 2, "b": 4},
      "numbers are those of expressions that are the same everywhere: %s, %s" % (material, end))
claim(wordy.intensities().size > 0 and close(wordy.fatigue([[0.5, 0.5]], alpha=0.3)["swt"][0],
      swt(np.array([[wordy.fields([[0.5, 0.5]], step=k)[s][0] for s in ("sxx", "syy", "sxy", "szz")]
                    for k in (1, 2)]), 100.0, NU)[0]),
      "intensities and fatigue parameters take them, a constant named lambda or not")
touched, own = os.path.join(WORK, "touched"), os.path.join(WORK, "wordy", "used.xml")
scene = read(own).replace("lambda", "k")
for text in ("[c for c in ().__class__.__base__.__subclasses__() if c.__name__ == '_wrap_close'][0]"
             ".__init__.__globals__['system']('touch %s')", "__import__('os').system('touch %s')"):
    write(own, scene.replace('"25*b"', '"%s"' % (text % touched)))
    with raises(epafi.InputError, "a scene's text is not run", "Young's Modulus"):
        epafi.Run(os.path.join(WORK, "wordy")).intensities()
claim(not os.path.exists(touched), "a run's folder runs nothing")

finish()
