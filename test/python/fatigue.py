"""Fatigue parameters: of cycles that have closed forms, on both bodies of a fretting contact with the error
that is told, on warm bodies, and what is refused.

    fatigue.py EPAFI WORK
"""
import math
import os
import sys
import warnings

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, raises  # noqa: E402

WORK = absent(sys.argv[2])
import epafi  # noqa: E402
from epafi.fatigue import dang_van, smallest_ball, swt  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)  # loads are of size 1: large displacements
SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers", "scenes")
PI, NU = math.pi, 0.3


def close(a, b):
    return abs(a - b) < 1e-9 * abs(b)


# fatigue of a point: stresses (sxx, syy, sxy, szz) over a cycle
YOUNG, ALPHA, STEPS = 200.0, 0.25, 24
cosine, sine = (f(2 * PI * np.arange(STEPS) / STEPS) for f in (np.cos, np.sin))


def path(*stresses):
    return np.column_stack([np.zeros(STEPS) + part for part in stresses])


def turned(stress, angle):
    c, s = math.cos(angle), math.sin(angle)
    sxx, syy, sxy, szz = stress.T
    return np.column_stack([c * c * sxx + s * s * syy - 2 * s * c * sxy,
                            s * s * sxx + c * c * syy + 2 * s * c * sxy,
                            s * c * (sxx - syy) + (c * c - s * s) * sxy, szz])


pull, plane, shear = path(3 * cosine, 0, 0, 0), path(3 * cosine, 0, 0, 3 * NU * cosine), path(
    0, 0, 3 * cosine, 0)
circle = path(2 * cosine, -2 * cosine, 2 * sine, 0)
claim(close(swt(pull, YOUNG, NU)[0], 9 / YOUNG) and
      close(swt(plane, YOUNG, NU)[0], 9 * (1 - NU ** 2) / YOUNG), "SWT: stress times strain amplitude")
claim(swt(path(3 * cosine - 3, 0, 0, 0), YOUNG, NU)[0] == 0, "none where a cycle is pressure alone")
claim(close(swt(shear, YOUNG, NU)[0], 9 * (1 + NU) / YOUNG) and
      abs(abs(swt(shear, YOUNG, NU)[1] - 90) - 45) < 1e-4, "of shear on planes at 45 degrees")
claim(close(swt(circle, YOUNG, NU)[0], 4 * (1 + NU) / YOUNG) and
      close(dang_van(circle, ALPHA)[0], 2), "shear that turns round: tau is its radius")
claim(close(dang_van(pull, ALPHA)[0], 3 * (1 / 2 + ALPHA / 3)) and
      close(dang_van(shear, ALPHA)[0], 3), "Dang Van of a pull and of shear")
one, low, high = np.array([1.0, -0.4, 0.3, 0.2]), -0.5, 2.0
range_ = (high - low) / 2 * ((one[0] + one[1]) / 2 + math.hypot((one[0] - one[1]) / 2, one[2]) - min(
    one[3], (one[0] + one[1]) / 2 - math.hypot((one[0] - one[1]) / 2, one[2]))) / 2
claim(close(dang_van(np.outer(np.linspace(low, high, 7), one), ALPHA)[0],
            range_ + ALPHA * high * (one[0] + one[1] + one[3]) / 3),
      "of a proportional path: half the range of tau, and the largest pull")
random = np.random.default_rng(1).normal(size=(STEPS, 4))
claim(all(close(swt(turned(random, a), YOUNG, NU)[0], swt(random, YOUNG, NU)[0]) and
          close(dang_van(turned(random, a), ALPHA)[0], dang_van(random, ALPHA)[0])
          for a in (0.3, 1.1)), "both do not change with the axes")
constant = random + np.array([0.7, -0.7, 0.2, 0])
claim(close(dang_van(constant, ALPHA)[0], dang_van(random, ALPHA)[0]),
      "a constant deviator does not change Dang Van's")
for points in (random, circle, np.zeros((3, 4)), random[:2]):
    middle = smallest_ball(points)
    distances = np.linalg.norm(points - middle, axis=1)
    outer = points[distances > distances.max() - 1e-9]
    directions = np.random.default_rng(2).normal(size=(2000, 4))
    claim((((outer - middle) @ directions.T).max(axis=0) > -1e-9).all(),
          "no shift of the middle makes the ball around %d points smaller" % len(points))

# fretting: cracks begin at the trailing edge
fretting = epafi.run(os.path.join(SHIPPED, "fretting.xml"), threads=1)
cycle = fretting.fatigue("contact", first=2, last=6, alpha=ALPHA)
worst = int(np.argmax(cycle["swt"]))
tension = 2 * 0.5 * 0.005 * math.sqrt(0.5)  # 2 f p0 sqrt(Q / (f P)), at the edge
claim(abs(abs(cycle["x"][worst]) - 1) < 0.02 and cycle["swt_stress"][worst] < tension and
      cycle["swt_stress"][worst] > 0.94 * tension and abs(cycle["swt_plane"][worst] - 90) < 10,
      "SWT is largest at x = %g, on a plane across the surface, under a pull of %g of %g" % (
          cycle["x"][worst], cycle["swt_stress"][worst], tension))
exact = tension ** 2 * (1 - 0.5 ** 2) / 0.75  # the pull on that plane, and its range
claim(0 < exact - cycle["swt"][worst] < cycle["swt_error"][worst] < 0.3 * exact,
      "%.3e, exactly %.3e, with an error of %.1e" % (cycle["swt"][worst], exact, cycle["swt_error"][worst]))
claim(abs(abs(cycle["x"][np.argmax(cycle["dang_van"])]) - 1) < 0.02, "and so is Dang Van's")
surface = [[cycle["x"][worst] * 0.9, 1e-3], [0, 99]]
inside = fretting.fatigue(surface, first=2, last=6, alpha=ALPHA)
beside = np.argmin(abs(cycle["x"] - surface[0][0]))
claim(abs(inside["swt"][0] / cycle["swt"][beside] - 1) < 0.1 and np.isnan(inside["swt"][1]) and
      "swt_error" not in inside, "just below the surface it is that of the surface; NaN outside")
along = fretting.fatigue("block:contact", first=2, last=6)
claim(np.allclose(along["swt"], cycle["swt"], rtol=1e-6) and list(along["s"]) == list(cycle["s"]) and
      (abs(np.sin(np.radians(cycle["swt_plane"] - 90 - along["swt_plane"])))[
          cycle["swt"] > 0.01 * cycle["swt"].max()] < 1e-4).all() and
      np.allclose(along["swt_error"], cycle["swt_error"], rtol=1e-3, atol=1e-12),
      "along the boundary itself it is the same, planes from the x axis")
claim(set(cycle["boundary"]) == {"contact"} and "dang_van" not in along and "dang_van_error" in cycle,
      "boundaries as contact.csv has them; Dang Van only with alpha")


def half(up, mesh, modulus):
    """A block 80 half-widths of the contact wide, above or below; its outer sides carry what a
    half-plane has there under Flamant's forces P and Q at the origin."""
    cuts, counts = mesh
    far, names = cuts[-1], ["contact" if -2 < x < 1.2 else "free" for x in cuts[:-1]]
    push = "(Q*(t < 1 ? 0 : 2/pi*asin(sin(pi/2*(t - 1))))*x - P*min(t, 1)*y)"
    return {
        "Material": {"Young's Modulus": modulus, "Poisson's Ratio": NU},
        "Geometry": {"Vertices": [[up * x, 0] for x in cuts] + [[up * far, up * 2 * far],
                                                               [-up * far, up * 2 * far]],
                     "Edges": names + (["right", "far", "left"] if up > 0 else ["left", "far", "right"])},
        "Boundary Conditions": {edge: {"Type": "Neumann", **{
            "Traction " + c.upper(): "%d*2/pi*%s*(%s)*%s/(x^2 + y^2)^2" % (up, push, normal, c)
            for c in "xy"}} for edge, normal in (("left", "-x"), ("right", "x"), ("far", "abs(y)"))},
        "Mesh": {"Elements per Edge": counts + [6, 6, 6], "Degree": 2},
        **({"Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}} if up < 0 else {})}


def mesh(count):
    return ([-40, -16, -6, -2.5, -1.25, -1.02, -0.6, 0.6, 1.02, 1.25, 2.5, 6, 16, 40],
            [4, 4, 4, 6, count // 4, count, count // 2, count, count // 4, 6, 4, 4, 4])


def fretted(swapped, pad, specimen, stiff=1):
    """SWT and Dang Van, with their errors, where they are largest on the pad and on the specimen."""
    both_bodies = ["pad", "specimen"]
    sides = [body + ":contact" for body in both_bodies]
    run = epafi.run({
        "Constants": {"P": "pi/400", "Q": "P/4"},
        "Bodies": {"pad": half(1, mesh(pad), stiff * 2 * (1 - NU ** 2)),
                   "specimen": half(-1, mesh(specimen), 2 * (1 - NU ** 2))},
        "Contacts": {"fret": {"Between": sides[::-1] if swapped else sides, "Interference": "-x^2/200",
                              "Friction": {"Law": "Coulomb", "Coefficient": 0.5}}},
        "History": {"Times": [1, 2, 4, 6], "Steps": [1, 2, 4, 4]}}, threads=1)
    both = run.fatigue("fret", first=2, last=6, alpha=ALPHA)
    claim(list(dict.fromkeys(both["body"])) == both_bodies[::-1 if swapped else 1], "both bodies, first that which carries the stresses")
    for body in () if swapped else both_bodies:
        one = run.fatigue("fret", body=body, first=2, last=6)
        claim(np.array_equal(one["swt"], both["swt"][both["body"] == body]) and
              set(one["boundary"]) == {body + ":contact"}, "or the %s alone" % body)
    found = {}
    for body in both_bodies:
        one = {name: column[both["body"] == body] for name, column in both.columns.items()}
        found[body] = [(one[name][most], one[name + "_error"][most]) for name in ("swt", "dang_van")
                       for most in [int(one[name].argmax())]]
    return found


def equal(found, words):
    """Is each within the error of each?"""
    for k, name in enumerate(("SWT", "Dang Van's parameter")):
        values = [each[k] for each in found]
        apart = max(abs(a[0] - b[0]) - max(a[1], b[1]) for a in values for b in values)
        claim(apart < 0 and max(error for _, error in values) < 0.5 * values[0][0],
              "%s %s: %s" % (name, words, ", ".join("%.4g +- %.1g" % value for value in values)))


# two equal bodies, pressed by P and pushed by Q: the pad is the mirror image of the specimen
same = [fretted(swapped, *meshes) for swapped in (False, True) for meshes in ((8, 8), (16, 12))]
equal([each[body] for each in same for body in each],
      "of pad and specimen, in both orders, on meshes that match and that do not")
exact = tension ** 2 * (1 - NU ** 2) / (2 * (1 - NU ** 2))
claim(all(abs(value - exact) < error for each in same for (value, error), _ in each.values()),
      "the exact SWT, %.4g, is within the error" % exact)
unlike = [fretted(swapped, 12, 8, stiff=3) for swapped in (False, True)]
for body in unlike[0]:
    equal([each[body] for each in unlike], "of the %s of two materials, in both orders" % body)
claim(unlike[0]["pad"][0][0] < 0.8 * unlike[0]["specimen"][0][0], "of the softer body it is larger")


# warm bodies, and lists of a body's own
def pressed(**more):
    """Half of a block on a curved obstacle."""
    return epafi.Scene({"Bodies": {"block": {
        "Material": {"Young's Modulus": 100.0, "Poisson's Ratio": NU, "Thermal Expansion": 1e-3},
        "Geometry": {"Vertices": [[0, 0], [2, 0], [2, 1], [0, 1]],
                     "Edges": ["foot", "side", "top", "any"]},
        "Boundary Conditions": {"top": {"Type": "Neumann", "Traction Y": "-t"}, "foot": {
            "Type": "Contact", "Gap": "x^2/100", "Friction": {"Law": "Coulomb", "Coefficient": 0.5}}},
        **more}}, "Geometry": {"Symmetry": "X"}, "Discretization": {"Mesh Size": 0.125, "Degree": 3},
        "Body Loads": {"Temperature": "4*t*y^2"}, "History": {"Times": [1], "Steps": [2]}})


warm, cold = (epafi.run(pressed(**more), threads=1) for more in ({}, {"Body Loads": {"Force Y": "0"}}))
for run, words in ((warm, "warm"), (cold, "cold")):
    surface, below = run.fatigue("foot", alpha=ALPHA), run.fatigue("block:foot", depth=1e-7, alpha=ALPHA)
    apart = abs(surface["dang_van"] - below["dang_van"])
    usual = np.median(apart) / abs(surface["dang_van"]).max()
    claim((apart <= surface["dang_van_error"]).all() and usual < 1e-3,
          "of a %s body on a contact as just below it within the error, in the median to %.1e" % (words, usual))
apart = [run.fatigue("foot", alpha=ALPHA)["dang_van"] for run in (warm, cold)]
claim(abs(apart[0] - apart[1]).max() > 0.2 * apart[1].max(), "which are not alike")
for words, where, options in (
        ("'contakt'; contacts: contact", "contakt", {}), ("two steps", "contact", {"last": 2}),
        ("those are: block", "contact", {"body": "blok"}), ("belongs to a contact", "block:contact", {
            "body": "block"}), ("'block:contakt'", "block:contakt", {})):
    with raises(epafi.InputError, "%s, %s is refused" % (where, options), words):
        fretting.fatigue(where, **{"first": 2, "last": 6, "alpha": ALPHA, **options})
finish()
