"""The two blocks of [P] sec. 8: rates of the estimate, the estimate beside true errors, exponential
convergence, and Newton's steps on levels that begin where the one before ended."""
import math
import os
import statistics

from runs import claim, epafi, finish, fresh, rows, run, saved, scene

PAPER = ("Adaptivity->Weights=Paper", "Discretization->Multiplier=Gauss-Lobatto-Lagrange",
         "Discretization->Stabilization->Gamma0=1e-3",
         "Discretization->Stabilization->Scaling=Absolute")
QUADRATIC = "Discretization->Degree=2"
OWN = ("Discretization->Stabilization->Scaling=Stiffness",
       "Discretization->Stabilization->Gamma0=0.1")
DUAL = ("Discretization->Multiplier=Biorthogonal", "Discretization->Stabilization->Form=None")


def chosen(strategy, levels, dof, *settings):
    return [*settings, "Adaptivity->Strategy=" + strategy,
            "Adaptivity->Marking Fraction=%g" % (0.6 if strategy == "Graded hp" else 0.3),
            "Adaptivity->Maximum Levels=%d" % levels,
            "Adaptivity->Maximum Degrees of Freedom=%d" % dof]


def history(name, *choice):
    return run(scene(name + ".xml"), name, chosen(*choice))[0]


def rate(levels):
    """Of the estimate in unknowns, least squares over the last two thirds."""
    last = levels[len(levels) // 3:]
    x, y = ([math.log(row[key]) for row in last] for key in ("dof", "estimate"))
    return -statistics.linear_regression(x, y).slope


for name, strategy, levels, dof, low, high in (
        ("tresca", "Uniform h", 6, 100000, 0.45, 0.6),
        ("tresca", "Adaptive h", 60, 1600, 1.55, math.inf),
        ("coulomb", "Uniform h", 5, 100000, 1.35, 1.6),
        ("coulomb", "Adaptive h", 60, 1600, 1.35, 1.6)):
    found = rate(history(name, strategy, levels, dof, *PAPER))
    claim(low <= found <= high, "%s, %s: a rate of %.2f" % (name, strategy, found))
for name, least, dof, most in (("tresca", 2.2, 660, 4e-4), ("coulomb", 2.5, 870, 2e-4)):
    levels = history(name, "Adaptive hp", 60, 900, *PAPER)
    smallest = min(row["estimate"] for row in levels if row["dof"] <= dof)
    claim(rate(levels) >= least and smallest <= most,
          "%s, Adaptive hp: a rate of %.2f, %.1e with %d unknowns" % (
              name, rate(levels), smallest, dof))

# true errors are those to a much finer level; errors near its own estimate do not count
VARIANTS = {
    "Uniform h": chosen("Uniform h", 5, 100000),
    "Uniform h, p = 2": chosen("Uniform h", 6, 100000, QUADRATIC),
    "Uniform h, p = 2, stabilised": chosen("Uniform h", 6, 100000, QUADRATIC, *OWN),
    "Uniform h, dual": chosen("Uniform h", 6, 100000, QUADRATIC, *DUAL),
    "Adaptive h": chosen("Adaptive h", 60, 900),
    "Adaptive h, p = 2": chosen("Adaptive h", 60, 1500, QUADRATIC),
    "Adaptive h, dual": chosen("Adaptive h", 60, 1500, QUADRATIC, *DUAL),
    "Adaptive hp": chosen("Adaptive hp", 60, 900),
    "Graded hp": chosen("Graded hp", 100, 1700)}
for name, unknowns in (("tresca", (550, 900, 1400)), ("coulomb", (400, 650, 950))):
    file = saved("study", {
        "Scenes": {name: {"File": os.path.abspath(scene(name + ".xml")), "Reference": {
            "Set": chosen("Graded hp", 100, 2300)}}},
        "Variants": {variant: {"Set": settings} for variant, settings in VARIANTS.items()}})
    folder = fresh(name + " study")
    code, text = epafi("study", file, "--output", folder, "--no-plot", "--quiet")
    claim(code == 0, "a study of %s %s" % (name, text[-300:]))
    levels = {variant: [] for variant in (*VARIANTS, "reference")}
    for row in rows(folder, "study.csv"):
        levels[row["variant"]].append(row)
    for variant in VARIANTS:
        counted = [row["effectivity"] for row in levels[variant] if row["counted"] == 1]
        outside = [value for value in counted if not 1.5 <= value <= 4.5]
        claim(len(counted) >= 3 and len(outside) <= 1,
              "%s, %s: effectivity %.2f to %.2f on %d levels, outside of 1.5 to 4.5 %s" % (
                  name, variant, min(counted), max(counted), len(counted), outside))
    graded = levels["Graded hp"]
    for bound, most in zip((1e-3, 1e-4, 1e-5), unknowns):
        first = 1 + max(k for k, row in enumerate(graded) if row["error"] > bound)
        claim(first < len(graded) and graded[first]["dof"] <= most,
              "%s, Graded hp: errors below %g from %d unknowns on" % (
                  name, bound, graded[min(first, len(graded) - 1)]["dof"]))

for multiplier, most in (("Gauss-Legendre-Lagrange", 8), ("Gauss-Lobatto-Lagrange", 20),
                         ("Bernstein", 20)):
    for name in ("tresca", "coulomb"):
        steps = []
        for strategy in ("Graded hp", "Adaptive h", "Adaptive hp"):
            for own in ((), OWN):
                levels = history(name, strategy, 100, 1500,
                                 "Discretization->Multiplier=" + multiplier, *own)
                steps += [row["newton_iterations"] for row in levels[1:]]
        claim(max(steps) <= most and statistics.median_high(steps) <= 3,
              "%s, %s: %g steps in the median of %d levels, at most %d" % (
                  multiplier, name, statistics.median_high(steps), len(steps), max(steps)))
finish()
