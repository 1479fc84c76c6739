"""Manufactured partial slip (scenes/partial_slip.xml): the true errors in the energy norm and
in the contact stress fall at the rates of the theory, for every multiplier basis, strategy and
law, on uniform meshes with every stabilisation, too; one side sticks, the other slips; the stress
inside is right up to 1e-6 element lengths from the boundary.

    partial_slip.py EPAFI WORK [TABLE.md]     writes what it measured as a page, too
"""
import json
import math
import os
import subprocess
import sys

from run_cases import HERE
from runs import EPAFI, WORK, claim, failures, finish, read, run, table, write

TRESCA = read(os.path.join(HERE, "scenes", "partial_slip.xml"))
COULOMB = TRESCA.replace('"Tresca"', '"Coulomb"').replace("Threshold", "Coefficient").replace(
    '0.1*exp(1)*cos(y) + 0.25"', '(0.1*exp(1)*cos(y) + 0.25)/(3/7 - 0.1*exp(1)*sin(y))"')
STABILISED = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")
BASES = {basis: ["Discretization->Multiplier=" + basis] for basis in STABILISED}
BASES["Biorthogonal"] = ["Discretization->Multiplier=Biorthogonal",
                         "Discretization->Stabilization->Form=None"]
LEVELS = "Adaptivity->Maximum Levels=%d"
STRATEGIES = {
    **{"uniform h, p = %d" % p: ["Adaptivity->Strategy=Uniform h", LEVELS % 5,
                                 "Discretization->Degree=%d" % p] for p in (1, 2, 3)},
    "uniform p": ["Adaptivity->Strategy=Uniform p", LEVELS % 8],
    **{"adaptive h, p = %d" % p: ["Adaptivity->Strategy=Adaptive h", LEVELS % 40,
                                  "Adaptivity->Maximum Degrees of Freedom=900",
                                  "Discretization->Degree=%d" % p] for p in (1, 2)},
    "adaptive hp": ["Adaptivity->Strategy=Adaptive hp", LEVELS % 60,
                    "Adaptivity->Maximum Degrees of Freedom=600"],
    "graded hp": ["Adaptivity->Strategy=Graded hp", LEVELS % 60,
                  "Adaptivity->Marking Fraction=0.5",
                  "Adaptivity->Maximum Degrees of Freedom=600"]}
# of all bases and strategies, and of other forms of the stabilisation uniform h
VARIANTS = {"%s / %s" % (basis, strategy): BASES[basis] + STRATEGIES[strategy]
            for basis in BASES for strategy in STRATEGIES}
VARIANTS.update({"%s %s / %s" % (basis, form, strategy): [
    *BASES[basis], *settings, "Discretization->Stabilization->Form=" + form]
    for basis in STABILISED for form in ("Projected", "Exact")
    for strategy, settings in STRATEGIES.items() if strategy.startswith("uniform h")})
# Exact to rounding: the field is analytic.
REFERENCE = ["Adaptivity->Strategy=None", "Discretization->Degree=14"]


def study(law, scene):
    """The rows of study.csv, by variant."""
    os.makedirs(WORK, exist_ok=True)
    files = {kind: os.path.join(WORK, law + kind) for kind in (".xml", ".study.yaml", ".out")}
    write(files[".xml"], scene)
    write(files[".study.yaml"], json.dumps({"Partial slip": {
        "Scenes": {"block": {"File": os.path.abspath(files[".xml"]), "Reference": {"Set": REFERENCE}}},
        "Variants": {name.replace(",", ""): {"Set": words} for name, words in VARIANTS.items()}}}))
    done = subprocess.run([EPAFI, "study", files[".study.yaml"], "--quiet", "--force", "--no-plot",
                           "--output", files[".out"]], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    if done.returncode != 0:
        sys.exit(done.stdout)
    rows = {}
    for row in table(os.path.join(files[".out"], "study.csv")):
        rows.setdefault(row["variant"], []).append(row)
    for variant in set(rows) - {"reference"}:
        points = table(os.path.join(files[".out"], rows[variant][-1]["folder"], "contact.csv"))
        claim({(p["boundary"], p["contact"], p["friction"]) for p in points} ==
              {("base", 1, 1), ("right", 1, 2)}, "%s, %s: one side sticks, one slips" % (law, variant))
    return rows


def rate(rows, column):
    """Decay against degrees of freedom, by least squares over the last half."""
    points = [(math.log(row["dof"]), math.log(row[column]))
              for row in rows[len(rows) // 2:]]
    x, y = (sum(axis) / len(points) for axis in zip(*points))
    return -sum((a - x) * (b - y) for a, b in points) / sum((a - x)**2 for a, b in points)


def judge(law, basis, strategy, levels):
    # a product's control points are not the products of control points
    secondOrder = law == "Coulomb" and basis.startswith("Bernstein")
    what = "%s, %s / %s" % (law, basis, strategy)
    first, last = (tuple(levels[i][column] for column in ("error", "error_multiplier"))
                   for i in (0, -1))
    rates = rate(levels, "error"), rate(levels, "error_multiplier")
    if strategy.startswith("uniform h"):
        wanted = min(int(strategy[-1]) + 0.5, 2 if secondOrder else 99)
        claim(min(rates) > wanted - 0.15,
              "%s: rates %.2f and %.2f, wanted %g" % (what, *rates, wanted))
    elif secondOrder and strategy in ("uniform p", "graded hp"):
        claim(last[0] < 1e-3, "%s: to %.1e" % (what, last[0]))
    elif strategy == "uniform p":  # rounding is amplified by 2^(p+1) in control points
        most = (1e-11, 1e-10) if basis == "Bernstein" else (1e-12, 1e-11)
        claim(last[0] < most[0] and last[1] < most[1],
              "%s: exponentially to %.1e and %.1e" % (what, *last))
    elif strategy == "graded hp":
        claim(max(last) < 1e-8, "%s: exponentially to %.1e and %.1e" % (what, *last))
    elif strategy.startswith("adaptive h,"):
        wanted = int(strategy[-1]) + 0.5
        claim(rates[0] > wanted - 0.3, "%s: rate %.2f, wanted %g" % (what, rates[0], wanted))
    else:
        claim(last[0] < 0.4 * first[0] and last[1] < 0.4 * first[1],
              "%s: from %.1e to %.1e, in contact stress from %.1e to %.1e" % (
                  what, first[0], last[0], first[1], last[1]))
    return rates


def stress(x, y):
    wave = 0.1 * math.exp(x)
    return {"sxx": wave * math.sin(y) - 3 / 7, "syy": -wave * math.sin(y) - 1,
            "sxy": wave * math.cos(y) + 0.25}


def stressInside(distance):
    """Largest error of the stress at points so many element lengths from each side."""
    near, places = 0.25 * distance, (0.01, 0.13, 0.25, 0.37, 0.5, 0.77, 0.99)
    points = [point for s in places for point in ((s, near), (1 - near, s), (s, 1 - near),
                                                  (near, s))]
    array = "%dx2:{%s}" % (len(points), ", ".join("%.17g,%.17g" % point for point in points))
    result = run("partial_slip", REFERENCE + ["Output->Interior Points=" + array])
    claim(len(result.interior) == len(points), "%d points" % len(points))
    return max(abs(point[key] - exact) for point in result.interior
               for key, exact in stress(point["x"], point["y"]).items())


lines = []
for law, scene in (("Tresca", TRESCA), ("Coulomb", COULOMB)):
    for variant, rows in study(law, scene).items():
        levels = [row for row in rows if row["error"] != ""]
        if variant == "reference":
            continue
        basis, strategy = variant.split(" / ")
        rates = judge(law, basis, strategy, levels)
        last = levels[-1]
        if basis in BASES:
            lines.append("| %s | %s | %s | %d | %.1e | %.1e | %.1f | %.1f |\n" % (
                law, basis, strategy, last["dof"], last["error"], last["error_multiplier"], *rates))
inside = {distance: stressInside(distance) for distance in (0.5, 1e-2, 1e-4, 1e-6)}
for distance, error in inside.items():
    claim(error < 1e-8, "the stress %g element lengths inside errs by %.1e" % (distance, error))
if len(sys.argv) > 3 and not failures:
    text = read(os.path.join(HERE, "partial-slip.md"))
    with open(sys.argv[3], "w") as out:
        out.write(text.replace("STRESS\n", "".join(
            "| %g | %.1e |\n" % pair for pair in inside.items())) + "".join(lines))
finish()
