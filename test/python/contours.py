"""Stress intensities against exact solutions r^lambda round wedges: free, clamped, on rollers, on floors
with friction, bonded, sliding, sticking; the Griffith crack.

    contours.py EPAFI WORK [COUNT]

COUNT wedges are drawn of each kind; with more than one they are solved on two meshes.
"""
import math
import os
import sys
import warnings

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, raises  # noqa: E402

WORK = absent(sys.argv[2])
COUNT = int(sys.argv[3]) if len(sys.argv) > 3 else 1
import epafi  # noqa: E402
import williams  # noqa: E402
from williams import CLAMPED, FREE  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)
PI, NU = math.pi, 0.3
rng = np.random.default_rng(7)


def wedges_of(*angles, moduli=(1.0, 1.0)):
    """One or two, symmetric about the x axis: (start, end, mu, kappa)."""
    ends = np.cumsum([0, *angles]) - sum(angles) / 2
    return [(ends[k], ends[k + 1], moduli[k], 3 - 4 * NU) for k in range(len(angles))]


def outline(wedge, low, high):
    angle = wedge[1] - wedge[0]
    turns = np.linspace(wedge[0], wedge[1], max(2, math.ceil(angle / 1.05)) + 1)
    return {"Vertices": [[0, 0], *([math.cos(t), math.sin(t)] for t in turns)],
            "Edges": [low, *["far"] * (len(turns) - 1), high]}


def scene(wedges, faces, joint, solution, held, friction=None):
    """The solution given on the far sides: `held` its displacements, else its tractions."""
    bodies = {}
    for k, wedge in enumerate(wedges):
        ux, uy, tx, ty = ("+".join("(%s)" % part[k].texts()[n] for part in solution) for n in range(4))
        conditions = {"far": {"Type": "Dirichlet", "Displacement X": ux, "Displacement Y": uy}
                      if held else {"Type": "Neumann", "Traction X": tx, "Traction Y": ty}}
        names = ["low" if k == 0 else "joint", "high" if k == len(wedges) - 1 else "joint"]
        for name, face, end in ((names[0], faces[0], 0), (names[1], faces[1], 1)):
            if name == "joint" or face == FREE:
                continue
            if face == CLAMPED:
                conditions[name] = {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
            elif isinstance(face, tuple):
                conditions[name] = {"Type": "Dirichlet", "Displacement " + (
                    "X" if face[1] == 0 else "Y"): 0}
            else:
                conditions[name] = {"Type": "Contact", "Gap": 0, "Friction": {
                    "Law": "Coulomb", "Coefficient": abs(face)} if face else {"Law": "None"}}
        bodies["b%d" % k] = {
            "Material": {"Young's Modulus": 2 * (1 + NU) * wedge[2], "Poisson's Ratio": NU},
            "Geometry": outline(wedge, *names), "Boundary Conditions": conditions}
    if not held and not any(face == CLAMPED or isinstance(face, tuple) for face in faces):
        bodies["b0"]["Rigid Motions"] = {"Fix": ["X", "Y", "Rotation"]}
    contacts = {"Contacts": {"joint": {"Between": ["b0:joint", "b1:joint"], "Friction": friction}}}
    return epafi.Scene({"Bodies": bodies, **(contacts if len(wedges) > 1 else {}),
                        "Discretization": {"Mesh Size": 0.5}})


def closes(part, ray, ratio, other=None):
    """Does the face press, and slide against its friction?"""
    u_r, _, normal, _ = part.ray(ray)
    slip = u_r - (other.ray(ray)[0] if other else 0)
    below = part.wedge[0] == ray  # the body is beyond the ray
    return normal < 0 and (ratio == 0 or (ratio * slip < 0) == below)


def drawn(kind):
    """(wedges, faces, joint, friction, held): a random one."""
    f = rng.uniform(0.1, 0.8) * rng.choice([-1, 1])
    two = rng.uniform(60, 170, 2)
    moduli = (1.0, 10 ** rng.uniform(-1, 1))
    if kind == "free":
        return wedges_of(math.radians(rng.uniform(200, 359))), (FREE, FREE), None, None, False
    if kind == "clamped":
        return wedges_of(math.radians(rng.uniform(80, 330))), (CLAMPED, FREE), None, None, False
    if kind == "roller":
        return wedges_of(math.radians(rng.uniform(100, 330))), (("roller", float(rng.choice(
            [0, PI / 2]))), FREE), None, None, True
    if kind == "floor":
        return wedges_of(math.radians(rng.uniform(100, 180))), (float(f), FREE), None, None, True
    wedges = wedges_of(*np.radians(two), moduli=moduli)
    if kind == "bonded":
        return wedges, (FREE, FREE), None, {"Law": "Tied"}, False
    if kind == "sliding":
        return wedges, (FREE, FREE), float(f), {"Law": "Coulomb", "Coefficient": abs(f)}, True
    return wedges, (FREE, FREE), None, {"Law": "Coulomb", "Coefficient": 3.0}, True


def example(kind):
    """Of drawn(kind) with its exact solution: (..., exponents, solutions)."""
    while True:
        wedges, faces, joint, friction, held = drawn(kind)
        joints = (joint,) * (len(wedges) - 1)
        found = williams.exponents(wedges, faces, joints)
        if not found or found[0].real < 0.35 or found[-1].real > 0.97:
            continue  # below, elements at the tip would have to be smaller than rounding
        if kind in ("floor", "sliding", "sticking") and (found[0].imag or len(found) > 1 and (
                kind != "floor")):
            continue  # pressures of one sign alone
        count = 1 if kind in ("floor", "sliding", "sticking") else len(found)
        parts = [williams.solution(wedges, faces, joints, lam) for lam in found[:count]]
        for part in parts:  # stresses of size 0.01, of either sign
            size = max(np.abs(p.ray(t)[2:]).max() for p in part for t in p.wedge[:2]) + max(
                np.abs(p.ray((p.wedge[0] + p.wedge[1]) / 2)[2:]).max() for p in part)
            factor = rng.uniform(0.3, 1) * rng.choice([-1, 1]) * 0.01 / size
            for p in part:
                p.unknowns = p.unknowns * factor
        first = parts[0]
        if kind in ("floor", "sliding", "sticking"):
            ray = wedges[0][0] if kind == "floor" else wedges[0][1]
            if first[0].ray(ray)[2] > 0:
                for p in first:
                    p.unknowns = -p.unknowns
            _, _, normal, shear = first[0].ray(ray)
            if kind == "sticking" and abs(shear) > 2.5 * abs(normal):
                continue
            ratio = faces[0] if kind == "floor" else joint
            if kind != "sticking" and not closes(first[0], ray, ratio, first[1] if (
                    kind == "sliding") else None):
                continue
        return wedges, faces, joint, friction, held, found, parts


def stress(table, row, wedges, part, scale):
    """(K_normal, K_shear) of a solution on the side that a row names."""
    k = int(table["body"][row][1:])
    start, end = wedges[k][:2]
    side = table["side"][row]
    names = ["low" if k == 0 else "joint", "high" if k == len(wedges) - 1 else "joint"]
    ray = start if side == names[0] else end if side == names[1] else (start + end) / 2
    return part[k].ray(ray, scale)[2:] * (2 * PI * scale) ** (1 - part[k].lam.real)


def compared(name, wedges, found, parts, table):
    """(Error of lambda; error of K over its size, of each row with whether it is within the stated
    one)."""
    at_tip = np.hypot(table["x"], table["y"]) < 1e-9
    rows = np.flatnonzero(at_tip)
    wrong, lambdas = [], 0.0
    if len(rows) != len(found) * len(wedges):
        print("%s: %d rows for %d exponents %s" % (name, len(rows), len(found), found))
        return 1.0, [(1.0, False)]
    for row in rows:
        lam = complex(table["exponent"][row] + 1, table["exponent_imaginary"][row])
        nearest = int(np.argmin([abs(lam - root) for root in found]))
        lambdas = max(lambdas, abs(lam - found[nearest]))
        if nearest >= len(parts):
            continue
        scale = table["reach"][row] if lam.imag else 1.0
        exact = stress(table, row, wedges, parts[nearest], scale)
        told = np.array([table["k_normal"][row], table["k_shear"][row]])
        error = np.array([table["k_normal_error"][row], table["k_shear_error"][row]])
        size = np.hypot(*exact)
        wrong.append((np.abs(told - exact).max() / size,
                      bool((np.abs(told - exact) <= error + 1e-9 * size).all())))
    return lambdas, wrong


def griffith(dof, normal, shear, pressure=0, stiffer=1, first="upper", **keys):
    """A crack |x| < 1 in two bonded halves of a square, the tractions of the infinite plane's solution
    on its sides (Westergaard, Z = z / sqrt(z^2 - 1)); under pressure it is closed and slides.  The
    upper half may be stiffer, either may carry the bond's stresses."""
    r = "sqrt(sqrt((x-1)^2+y^2)*sqrt((x+1)^2+y^2))"
    t = "((atan2(y,x-1)+atan2(y,x+1))/2)"
    re, im = "(x*cos(%s)+y*sin(%s))/%s" % (t, t, r), "(y*cos(%s)-x*sin(%s))/%s" % (t, t, r)
    slope = "/(%s)^3" % r  # dZ/dz = -(z^2 - 1)^(-3/2)
    dre, dim = "(-cos(3*%s)%s)" % (t, slope), "(sin(3*%s)%s)" % (t, slope)
    xx = "%g*(%s-y*%s-1)+%g*(2*%s+y*%s)" % (normal, re, dim, shear, im, dre)
    yy = "%g*(%s+y*%s)+%g*(-y*%s)-%g" % (normal, re, dim, shear, dre, pressure)
    xy = "%g*(-y*%s)+%g*(%s-y*%s)" % (normal, dre, shear, re, dim)
    far = {"Type": "Neumann", "Traction X": "(%s)*nx+(%s)*ny" % (xx, xy),
           "Traction Y": "(%s)*nx+(%s)*ny" % (xy, yy)}
    material = {"Young's Modulus": 1000.0, "Poisson's Ratio": NU, "Thermal Expansion": 1e-8}
    bodies = {
        "upper": {"Material": {**material, "Young's Modulus": 1000.0 * stiffer}, "Geometry": {
            "Vertices": [[-3, 0], [-1, 0], [1, 0], [3, 0], [3, 3], [-3, 3]],
            "Edges": ["bond", "crack", "bond", "far", "far", "far"]}},
        "lower": {"Material": material, "Geometry": {
            "Vertices": [[-3, 0], [-3, -3], [3, -3], [3, 0], [1, 0], [-1, 0]],
            "Edges": ["far", "far", "far", "bond", "crack", "bond"]},
            "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}}
    for body in bodies.values():
        body["Boundary Conditions"] = {"far": far}
    sides = ["upper:bond", "lower:bond"][::1 if first == "upper" else -1]
    contacts = {"bond": {"Between": sides, "Friction": {"Law": "Tied"}}}
    if pressure:
        contacts["crack"] = {"Between": ["lower:crack", "upper:crack"]}
    return epafi.run(epafi.Scene({
        "Bodies": bodies, "Contacts": contacts, "Discretization": {"Mesh Size": 1.0}, **keys}),
        threads=1, set=graded(dof))


def graded(dof):
    return {"Adaptivity->Strategy": "Graded hp", "Adaptivity->Maximum Levels": 40,
            "Adaptivity->Maximum Degrees of Freedom": dof}


KINDS = ("free", "clamped", "roller", "floor", "bonded", "sliding", "sticking")
SIZES = (400,) if COUNT == 1 else (400, 900)
within, total = 0, 0
for kind in KINDS:
    lambdas, errors = 0.0, {dof: [] for dof in SIZES}
    for n in range(COUNT):
        wedges, faces, joint, friction, held, found, parts = example(kind)
        made = scene(wedges, faces, joint, parts, held, friction)
        for dof in SIZES:
            run = epafi.run(made, threads=1, set=graded(dof))
            name = "%s %d, %d unknowns" % (kind, n, run.history["dof"][-1])
            off, wrong = compared(name, wedges, found, parts, run.intensities())
            lambdas, here = max(lambdas, off), max(error for error, _ in wrong)
            if here > 1e-4 or not all(good for _, good in wrong):
                print("%s: %s %s, lambda %s, error %.1e, within %s" % (
                    name, [math.degrees(w[1] - w[0]) for w in wedges], faces, found, here,
                    [good for _, good in wrong]))
            errors[dof].append(here)
            within += sum(good for _, good in wrong)
            total += len(wrong)
    claim(lambdas < 1e-9, "%s: exponents to %.0e" % (kind, lambdas))
    claim(max(errors[400]) < 1e-4, "%s: K at 400 unknowns to %.1e, %.1e in the median" % (
        kind, max(errors[400]), np.median(errors[400])))
    if COUNT > 1:
        claim(np.median(errors[900]) < max(1e-7, 0.3 * np.median(errors[400])), "%s: at 900 to %.1e, %.1e" % (
            kind, max(errors[900]), np.median(errors[900])))
with raises(epafi.NotConverged, "one update of the slip bounds is not enough") as caught:
    epafi.run(made, threads=1, set={"Solver->Coulomb Iteration": "Fixed Point",
                                    "Solver->Coulomb Maximum Iterations": 1})
notes = caught[0].run.intensities()["note"]
claim(len(notes) and all("not converged" in note for note in notes), "its intensities say so")
claim(within >= 0.95 * total, "the true error is within the stated one in %d of %d" % (within, total))

for normal, shear, pressure in ((0.01, 0, 0), (0.006, 0.008, 0), (0, 0.008, 0.01))[0 if COUNT > 1 else 1:]:
    crack = griffith(800, normal, shear, pressure).intensities()
    told = np.column_stack([crack["k_normal"], crack["k_shear"]]) / math.sqrt(PI)
    error = np.column_stack([crack["k_normal_error"], crack["k_shear_error"]]) / math.sqrt(PI)
    off = np.abs(told - [normal, shear])
    size = math.hypot(normal, shear)
    claim(crack.size == 4 and set(crack["side"]) == {"bond"} and set(crack["kind"]) == {"end of bond"}
          and off.max() < (1e-4 if pressure else 1e-5) * size and (off <= error + 1e-9 * size).all(),
          "a Griffith crack under %g, %g, pressure %g: K to %.1e" % (
              normal, shear, pressure, off.max() / size))


def interface(**keys):
    """K of the crack between unlike halves and its errors, of each end as the upper half has it."""
    table = griffith(800, 0.006, 0.008, stiffer=50, **keys).intensities()
    order = np.lexsort((table["exponent"], table["x"], table["body"]))
    order = [row for row in order if abs(table["exponent"][row] + 0.5) < 1e-9]
    claim(len(order) == 4 and (abs(table["exponent_imaginary"][order]) > 0.05).all(),
          "both ends of a crack between unlike halves oscillate")
    return [np.array([table[name + end][order] for name in ("k_normal", "k_shear")])
            for end in ("", "_error")]


plain, error = interface()
for what, keys in {
        "taken from the other side of the bond": {"first": "lower"},
        "under a temperature that both halves follow": {"Body Loads": {"Temperature": "1+2*x-y"}}}.items():
    changed, others = interface(**keys)
    off = np.abs(changed - plain)
    claim((off <= error + others).all() and others.max() < 5e-3 * np.abs(plain).max(),
          "K of a crack between unlike halves %s: to %.0e, stated %.0e" % (
              what, off.max() / np.abs(plain).max(), others.max() / np.abs(plain).max()))


def with_data(angle, faces, stresses="000", step=None, **keys):
    """The largest errors of K, relative, and whether they are stated: of an exact solution with other
    stresses (xx, yy, xy), a load or a motion that leaves K unchanged; at a step of a path at whose
    end these stresses are zero."""
    wedges = wedges_of(math.radians(angle))
    found = williams.exponents(wedges, faces)
    parts = [williams.solution(wedges, faces, (), lam) for lam in found]
    for part in parts:
        size = max(np.abs(part[0].ray(t)[2:]).max() for t in (0, wedges[0][1]))
        part[0].unknowns = part[0].unknowns * 0.01 / size
    made = scene(wedges, faces, None, parts, False)
    body = made["Bodies"]["b0"]
    xx, yy, xy = (text + "*t*(2-t)" if step else text for text in stresses)
    if step:
        made["History"] = {"Times": [1, 2], "Steps": [1, 1]}
    extra = {"Traction X": "(%s)*nx+(%s)*ny" % (xx, xy), "Traction Y": "(%s)*nx+(%s)*ny" % (xy, yy)}
    far = body["Boundary Conditions"]["far"]
    far.update({key: far[key] + "+" + text for key, text in extra.items()})
    for name, face in zip(("low", "high"), faces):
        if face == FREE and stresses != "000":
            end = wedges[0][0] + PI if name == "low" else wedges[0][1]
            normal = {"nx": "(%.17g)" % -math.sin(end), "ny": "(%.17g)" % math.cos(end)}
            body["Boundary Conditions"][name] = {"Type": "Neumann", **{
                key: text.replace("nx", normal["nx"]).replace("ny", normal["ny"])
                for key, text in extra.items()}}
    for key, value in keys.items():
        body[key.replace("_", " ")] = {**body.get(key.replace("_", " "), {}), **value}
    _, wrong = compared(str(keys), wedges, found, parts, epafi.run(
        epafi.Scene(made), threads=1, set=graded(400)).intensities(step))
    return max(error for error, _ in wrong), all(good for _, good in wrong)


for what, (off, stated) in {
        "linear stresses on free faces": with_data(
            270, (FREE, FREE), ("0.01*y", "0.005", "-0.004")),
        "weight": with_data(270, (FREE, FREE), ("0.002", "0.01*y", "0"), Body_Loads={"Force Y": -0.01}),
        "stresses on faces that are zero at the end of a path": with_data(
            270, (FREE, FREE), ("0.01", "0.005", "-0.004"), step=1),
        "steady heat conduction, which free bodies do not feel": with_data(
            270, (FREE, FREE), Material={"Thermal Expansion": 1e-4, "Conductivity": 1.0}, Thermal_Conditions={
                "low": {"Temperature": 0}, "high": {"Temperature": 0}, "far": {"Heat Flux": 1}}),
        "a temperature that free bodies do not feel": with_data(
            270, (FREE, FREE), Material={"Thermal Expansion": 0.01}, Body_Loads={"Temperature": "1+2*x-y"}),
        "a clamp that moves and turns": with_data(200, (CLAMPED, FREE), Boundary_Conditions={"low": {
            "Type": "Dirichlet", "Displacement X": "0.01-0.01*y", "Displacement Y": "0.01*x-0.02"}}),
}.items():
    claim(off < 1e-4 and stated, "K does not change by %s: to %.1e" % (what, off))
finish()
