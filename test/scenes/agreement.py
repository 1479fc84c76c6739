"""Compressed against dense operators over combinations of body, mesh, law, form and size: energies
to 1e-9, the same states of contact, no more steps of Newton's.

    agreement.py EPAFI SCENES WORK [WORD...]

of the combinations whose names have all words; "large" adds 2048 and 4096 elements.  Prints a line
for each, and the sums in doc/benchmarks/compression.md.
"""
import collections
import sys

from runs import ENERGIES, claim, differ, epafi, finish, fresh, largest, rows, saved
from written import CLAMPED, NONE, block, body, condition, contact, geometry, keys, listed, loop

LAWS = {"frictionless": {"Law": "None"}, "Tresca": {"Law": "Tresca", "Threshold": "0.002*(1 + x)"},
        "Coulomb": {"Law": "Coulomb", "Coefficient": "0.3"}}
FORMS = {  # multiplier, form
    "GLL": ("Gauss-Legendre-Lagrange", "Density"), "GLoL": ("Gauss-Lobatto-Lagrange", "Density"),
    "Bernstein": ("Bernstein", "Density"), "Biorthogonal": ("Biorthogonal", "None")}
FORMED = 1000  # multipliers up to which compressed operators form D
SMALLEST = 1e-8  # edge of an outline that is cut towards its corners, of its side
# Graded hp, from few elements: a tenth of the smallest with every other level
GRADED = ["Adaptivity->Strategy=Graded hp", "Adaptivity->Maximum Levels=20",
          "Adaptivity->Marking Fraction=0.3", "Adaptivity->Maximum Degrees of Freedom=1500"]
SIDES = ["bottom", "right", "top", "left"]

# kind: block, hole, arcs, two, beam (1 : 30); mesh: uniform, graded, cut (an outline with many
# corners, no arcs)
Combination = collections.namedtuple("Combination", "kind mesh law form elements degree",
                                     defaults=[1])
NAME = "%s, %s, %s, %s, %d elements, p = %d"


def cut(corners, sides):
    """Outline whose sides are cut towards both ends, halved until SMALLEST remains."""
    points, names = [], []
    for k, (x, y) in enumerate(corners):
        a, b = corners[(k + 1) % len(corners)]
        shares = [0.0]
        place = 0.25
        while place > SMALLEST:
            shares.insert(1, place)
            place /= 2
        shares += [0.5] + [1 - share for share in reversed(shares[1:])]
        points += [(x + s * (a - x), y + s * (b - y)) for s in shares]
        names += [sides[k]] * len(shares)
    return points, names


def counts(number, edges, weights):
    """Elements of each edge, `number` in all, some per weight."""
    share = number / sum(weights)
    return [max(1, round(share * w)) for w in weights[:edges]]


def outlined(case, corners, elements):
    """An outline and its mesh."""
    sides, bulges, holes, more = SIDES, (0.05, 0, 0, 0) if case.kind == "arcs" else (), NONE, NONE
    weights = [15, 1, 15, 1] if case.kind == "beam" else [1] * 4
    if case.mesh == "cut":
        corners, sides = cut(corners, sides)
        weights = [1] * len(corners)
    if case.kind == "hole":
        holes = loop(block(-0.1, 0.2, 0.1, 0.5), ["rim"] * 4, hole="Hole 1 ")
        more = keys(Hole_1_Elements_per_Edge=counts(elements // 4, 4, [1] * 4))
        elements -= elements // 4
    return geometry(corners, sides, bulges, holes), listed(
        "Mesh", more, Degree=case.degree, Elements_per_Edge=counts(elements, len(corners), weights))


def scene(case):
    law = {"Friction": LAWS[case.law]}
    press = condition("top", "Neumann", Traction_X="0.001", Traction_Y="-0.01*(1 + 0.3*x)")
    touch = condition("bottom", "Contact", law, Gap="0.002*x^2")
    share = case.elements // 2 if case.kind == "two" else case.elements
    outline, mesh = outlined(
        case, block(-0.5, 0, 29.5, 1) if case.kind == "beam" else block(-0.5, 0, 0.5, 0.75), share)
    contacts = NONE
    if case.kind == "two":
        under, coarse = outlined(case, block(-1, -1, 1, 0), case.elements - share)
        bodies = [body("pad", outline, 1.0, press, "X, Rotation", mesh),
                  body("plate", under, 1000, condition("bottom", "Dirichlet", CLAMPED),
                       mesh=coarse)]
        contacts = listed("Contacts", contact("joint", "pad:bottom", "plate:top", law))
    elif case.kind in ("hole", "arcs"):
        held = (condition("right", "Dirichlet", CLAMPED) if case.kind == "arcs" else
                condition("rim", "Dirichlet", Displacement_X="0", Displacement_Y="-0.01"))
        bodies = [body("block", outline, 1.0, press + touch + held, mesh=mesh)]
    else:
        bodies = [body("block", outline, 1.0, press + touch, "X, Rotation", mesh)]
    multiplier, form = FORMS[case.form]
    return keys(listed("Bodies", *bodies), contacts,
                listed("Discretization", listed("Stabilization", Form=form), Mesh_Size=10,
                       Multiplier=multiplier),
                listed("Adaptivity", Strategy="None", Maximum_Degrees_of_Freedom=1000000),
                listed("Output", Fields=False, Contact_Samples_per_Element=2))


def compare(case):
    """Claims that both methods agree; what is summed, if both solve the scene."""
    name = NAME % case
    file = saved("scene", scene(case), name)
    found = []
    for method in ("Dense", "Compressed"):
        folder = fresh("run-" + method)
        code, text = epafi("run", file, "--quiet", "--threads", "1", "--output", folder, settings=[
            "Solver->Linear->Method=" + method, *(GRADED if case.mesh == "graded" else ())])
        if code:  # what dense operators do not solve, nobody is asked to
            claim(method == "Dense" and code == 2,
                  "%s, %s: exit %d, %s" % (name, method, code, text))
            return None
        found.append((rows(folder, "history.csv"), rows(folder)))
    (dense, there), (own, here) = found
    energy = max(differ(a[key], b[key], a["energy_strain"])
                 for a, b in zip(dense, own) for key in ENERGIES)
    pressure = largest(p["lambda_n"] - q["lambda_n"] for p, q in zip(there, here)) / (
        largest(p["lambda_n"] for p in there) or 1)
    states = abs(len(there) - len(here)) + sum(
        (p["contact"], p["friction"]) != (q["contact"], q["friction"]) for p, q in zip(there, here))
    steps = [int(sum(row["newton_iterations"] for row in table)) for table in (dense, own)]
    # where D is formed steps are the same ones; else what rounding leaves of a residual may ask for
    # one more on a level
    formed = max(row["dof_multiplier"] for row in own) <= FORMED
    more = 0 if formed else max(len(own), 0.1 * steps[0])
    claim(energy < 1e-9 and states == 0 and steps[1] - steps[0] <= more,
          "%-75s energy %.1e  pressure %.1e  states %d  steps %d %d" % (
              name, energy, pressure, states, *steps))
    return energy, pressure, states, own[-1]["size_min"], steps


def combinations(large):
    kinds = ("block", "hole", "arcs", "two")
    turn = [(law, form) for law in LAWS for form in FORMS]
    chosen = [Combination(kind, "uniform", law, form, 256) for kind in kinds for law, form in turn]
    chosen += [Combination(kind, "graded", law, form, 16) for kind in kinds for law, form in turn]
    for degree in range(2, 13):
        for k, kind in enumerate(kinds):
            law, form = turn[(4 * degree + 7 * k) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, max(24, 512 // degree), degree))
    for k, kind in enumerate(("block", "hole")):
        for i in range(3):
            law, form = turn[(2 * k + 5 * i) % len(turn)]
            chosen.append(Combination(kind, "cut", law, form, 512))
    chosen += [Combination("two", "cut", "frictionless", form, 512) for form in FORMS]
    for k, kind in enumerate(kinds):
        for i in range(3):
            law, form = turn[(2 * k + 5 * i) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, 1024))
    for i in range(12):
        law, form = turn[5 * i % len(turn)]
        chosen.append(Combination("beam", "uniform", law, form, 1024 if i % 4 == 0 else 512, 1 + i % 2))
    if large:
        for k, kind in enumerate(kinds):
            law, form = turn[(4 * k + 1) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, 2048))
        chosen.append(Combination("block", "uniform", "Coulomb", "GLL", 4096))
        chosen.append(Combination("two", "uniform", "Tresca", "Biorthogonal", 4096))
    return chosen


words = sys.argv[4:]
groups = {}
for case in combinations("large" in words):
    if all(word in NAME % case for word in words if word != "large"):
        result = compare(case)
        for group in ("all", case.kind, case.mesh, *["1024 and more"] * (case.elements >= 1024)):
            groups.setdefault(group, []).extend([result] * bool(result))
for group, results in groups.items():
    energies, pressures, states, sizes, steps = zip(*results)
    print("%s: %d scenes, energies to %.0e, pressures to %.0e, %d points of another state, "
          "smallest element %.0e, Newton steps %d and %d" % (
              group, len(results), max(energies), max(pressures), sum(states), min(sizes),
              *map(sum, zip(*steps))))
finish()
