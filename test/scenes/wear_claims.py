"""Worn half-planes against closed forms, meshes graded to 1e-8, a hundred cycles of fretting.  Some
minutes."""
import math

from runs import claim, differ, finish, rows, solved, steps
from written import (CLAMPED, block, body, condition, contact, friction, geometry, history, keys,
                     listed, rigid, wear, written)

NU = 0.3
STIFF = 1 / (1 - NU**2)  # E*, E = 1
SAMPLES = 40


def right_half(name, depth, nodes, law, force, path, size, degree, gap="0"):
    """Half of a block of 2 depth x depth, whose side up to the last node is in contact with a rigid
    slab that is pressed without turning; symmetry at x = 0."""
    far = [depth * 0.5**k for k in range(1, 14)]
    outside = [x for x in far if x > 1.3 * nodes[-1]]
    corners = [(0, -depth), (depth, -depth), (depth, 0)] + [(x, 0) for x in outside]
    corners += [(x, 0) for x in sorted(nodes, reverse=True)] + [(0, 0)] + [
        (0, -y) for y in reversed(far)]
    names = ["bottom", "right"] + ["top"] * (1 + len(outside)) + ["contact"] * len(nodes) + [
        "left"] * (len(far) + 1)
    counts = [3, 3] + [3] * len(outside) + [6] + size[::-1] + [2] * len(far) + [1]
    soft = body("soft", geometry(corners, names), 1.0,
                condition("bottom", "Dirichlet", Displacement_Y="0") +
                condition("left", "Dirichlet", Displacement_X="0"),
                mesh=listed("Mesh", Elements_per_Edge=counts, Degree=degree))
    slab = rigid("slab", block(0, 0, nodes[-1], 1),
                 listed("Motion", Force_Y="-%r*min(t, 1)" % (force / 2)))
    return written(name, [soft, slab], contact(
        "rub", "soft:contact", "slab:bottom",
        law, Interference="-(%s)" % gap), "Density", 1, degree,
        more=history(*path) + listed("Output", Contact_Samples_per_Element=SAMPLES))


def worn(name, file):
    """Points along the contact, rows of steps.csv."""
    folder, _ = solved(name, file)
    return sorted(rows(folder), key=lambda p: p["x"]), steps(folder)


def at(points, x, key="lambda_n"):
    """By the line through the two nearest samples."""
    a, b = sorted(points, key=lambda p: abs(p["x"] - x))[:2]
    return a[key] + (b[key] - a[key]) * (x - a["x"]) / (b["x"] - a["x"])


# a guided flat punch: T = E* k s/a to 1 in ten implicit steps
EXACT = {0: 0.9053846337, 0.5: 0.9862452518, 0.9: 1.1150012662}
FLAT = [0.5, 0.75, 0.9] + [1 - 0.1 * 0.5**k for k in range(1, 10)] + [1]
found = {}
for depth in (25, 50):
    points, _ = worn("punch %d" % depth, right_half(
        "punch", depth, FLAT, keys(Sliding="max(0, t-1)") + wear(1 / STIFF),
        1e-3, ([1, 2], [1, 10]), [2] * 13, 4))
    found[depth] = {x: at(points, x) / 0.5e-3 for x in EXACT}
for x, exact in EXACT.items():
    value = (4 * found[50][x] - found[25][x]) / 3
    claim(abs(value / exact - 1) < 1e-4, "worn punch, p(%g): %.7f, exact %.7f, off by %.1e" % (
        x, value, exact, value / exact - 1))

# a cylinder: tau = E* k s/a_H to 1, and V = k P s
R = 1000.0
P = math.pi * STIFF / (4 * R)  # a_H = 1
HERTZ = 2 * P / math.pi
ROUND = {}
for count in (100, 200):
    points, path = worn("cylinder %d" % count, right_half(
        "cylinder", 100, [1.2, 1.345, 1.355, 1.6, 2.4], keys(Sliding="max(0, t-1)") +
        wear(1 / STIFF), P, ([1, 2], [1, count]), [120, 60, 50, 20, 8], 1, "x^2/%r" % (2 * R)))
    last = path[-1]
    ROUND[count] = (last["rub.contact_length"], at(points, 0) / HERTZ,
                    2 * R * at(points, 0, "worn_depth"))
    off = max(differ(row["rub.worn_volume"], 0.5 * P * (row["t"] - 1) / STIFF)
              for row in path[1:])
    claim(off < 1e-12, "V = k P s in %d steps to %.1e" % (count, off))
# the front is steep, and its end in steps of elements
for name, exact, close, one, two in zip(
        ("a/a_H", "p(0)/p_H", "2 R w(0)/a_H^2"), (1.34928471, 0.7434119, 0.8597296),
        (2e-4, 2e-4, 2e-4), ROUND[100], ROUND[200]):
    claim(abs(one / exact - 1) < 2e-3 and abs((2 * two - one) / exact - 1) < close,
          "worn cylinder, %s: off by %.1e in 100 steps, by %.1e extrapolated" % (
              name, one / exact - 1, (2 * two - one) / exact - 1))

# fretting wear's limit: what slips beyond c = 0.7 a_H wears until it carries nothing
C = 0.7
limit = ((1 - C**2)**0 * math.pi * STIFF * C / (2 * math.pi * R) +
         (P - math.pi * STIFF * C**2 / (4 * R)) / (math.pi * C)) / HERTZ
GRADED = [C * (1 - 0.5**k) for k in range(1, 9)] + [C] + [C * (1 + 0.5**k) for k in range(8, 2, -1)]
values = []
for distance in (1, 1e2, 1e4):
    points, _ = worn("limit %g" % distance, right_half(
        "limit", 100, GRADED + [1.6], keys(Sliding="x > %r ? max(0, t-1) : 0" % C) +
        wear(distance / STIFF), P, ([1, 2], [1, 4]), [10] + [2] * 14 + [30], 2,
        "x^2/%r" % (2 * R)))
    values.append(at(points, 0) / HERTZ)
claim(abs(limit - 1.0642857) < 1e-6 and values == sorted(values) and
      abs(values[-1] - limit) < 2e-3, "fretting's limit %.6f is approached: %s" % (limit, values))

# elements down to 1e-8 of the punch: k ds E*/h of a million in every step
TINY = [0.5] + [1 - 10.0**-k for k in range(1, 9)] + [1]
points, path = worn("graded", right_half(
    "graded", 25, TINY, keys(Sliding="max(0, t-1)") + wear(0.1 / STIFF),
    1e-3, ([1, 2], [1, 10]), [4] + [2] * 9, 1))


def means(key):
    """Of each element, on the way to the edge."""
    elements = {}
    for p in points:
        elements.setdefault(p["element"], []).append(p[key])
    return [sum(values) / len(values) for values in elements.values()]


rises = [b > a for a, b in zip(means("lambda_n"), means("lambda_n")[1:])]
turns = sum(a != b for a, b in zip(rises, rises[1:]))
claim(turns <= 1 and means("worn_depth") == sorted(means("worn_depth")),
      "k ds E*/h = 1e6: the depth rises to the edge, the pressure turns %d times; Newton's worst "
      "count %d" % (turns, max(row["newton_iterations"] for row in path)))


# a hundred cycles of partial slip, and ten that stand for ten each, behind the first one
def cycles(name, count, jump):
    return worn(name, right_sided(name, "0.0015*sin(2*pi*max(0, t-1))",
                                  ([1, count + 1], [1, 8 * count]),
                                  wear(2, "t > 2 ? %d : 1" % jump)))


def right_sided(name, to_and_fro, path, law):
    """A block on which a rigid parabola is pressed and shaken."""
    outline = [(-4, -4), (4, -4), (4, 0), (0.4, 0), (-0.4, 0), (-4, 0)]
    soft = body("soft", geometry(outline, "bottom, right, top, contact, top, left"), 1.0,
                condition("bottom", "Dirichlet", CLAMPED), "",
                listed("Mesh", Elements_per_Edge=[2, 2, 6, 24, 6, 2], Degree=1))
    pad = rigid("pad", block(-0.4, 0, 0.4, 1),
                listed("Motion", Force_Y="-0.002*min(t, 1)", Displacement_X=to_and_fro))
    return written(name, [soft, pad],
                   contact("rub", "soft:contact", "pad:bottom", friction("0.6"), law,
                           Interference="-x^2/100"), "Density", 1, 1, more=history(*path))


one, rows_of_one = cycles("cycles", 101, 1)
ten, rows_of_ten = cycles("jumps", 11, 10)
first, last, jumped = rows_of_one[8], rows_of_one[-1], rows_of_ten[-1]
claim(last["cycles"] == jumped["cycles"] == 102 and
      0 < first["rub.slip_length"] < first["rub.contact_length"], "a hundred cycles of partial slip")
off = [jumped[key] / last[key] - 1 for key in ("rub.worn_volume", "rub.pressure_max", "energy_worn")]
claim(max(map(abs, off)) < 0.05 and last["rub.worn_volume"] > 20 * first["rub.worn_volume"],
      "jumps of ten: volume, largest pressure, work on wear off by %s" % " ".join(
          "%.1e" % x for x in off))
finish()
