"""2 and 3 ranks write what 1 rank writes, with dense operators, which every rank has, and with
compressed ones, of which it has subtrees: history.csv, steps.csv and contact.csv.

The paper's scenes, several bodies, arcs, a rigid body and load paths, with each form that
compressed operators take; levels that are refined uniformly, and graded, from warm starts.
Numbers agree to a bound of their column's scale."""
import functools
import os
import sys

import ranks
from scales import difference, worst

EVERY = sys.argv[6:] == ["all"]
UNIFORM = ("Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Degrees of Freedom=100000")
NONE = ("Discretization->Stabilization->Form=None", "Discretization->Multiplier=Biorthogonal")
DENSITY = ("Discretization->Stabilization->Form=Density",)
METHODS = {method: ("Solver->Linear->Method=" + method,)
           for method in ("Dense", "Compressed", "Belos")}


def levels(count):
    return "Adaptivity->Maximum Levels=%d" % count


def edges(*counts):
    return "Discretization->Elements per Edge={%s}" % ", ".join(map(str, counts))


@functools.lru_cache(maxsize=None)
def solve(count, scene, settings):
    """The tables of a run."""
    folder, text = ranks.solved(count, scene, scene, settings)
    ranks.claim(text.count("ended ") == 1, "one rank speaks: %s on %d" % (scene, count))
    return {name: ranks.table(os.path.join(folder, name))
            for name in ("history.csv", "steps.csv", "contact.csv") if name in os.listdir(folder)}


def compare(scene, settings, method, counts, bound, contact=None, aside=(), alone="the same"):
    """`contact`: the bound of contact.csv; `aside`: columns of history.csv to 1e-8 only;
    `alone`: the method of 1 rank."""
    one = solve(1, scene, (*settings, *METHODS.get(alone, METHODS[method])))
    for count in counts:
        many = solve(count, scene, (*settings, *METHODS[method]))
        what = "%s, %s, %s, %d ranks" % (scene, settings[0], method, count)
        for name, table in one.items():
            apart = worst(table, many[name], [column for column in table[0] if column not in aside])
            ranks.claim(list(table[0]) == list(many[name][0]), what + ": the same columns")
            ranks.claim(apart[0] <= (contact or bound if name == "contact.csv" else bound),
                        "%s, %s: %.1e, in %s" % (what, name, *apart))
        for column in aside:
            apart = difference(one["history.csv"], many["history.csv"], column)
            ranks.claim(apart <= 1e-8, "%s, %s: %.1e" % (what, column, apart))


# both numbers of ranks with either method: by turns here, each with each by "all"
H, P = ("Adaptivity->Strategy=Uniform h", levels(3)), ("Adaptivity->Strategy=Uniform p", levels(4))
for k, (scene, settings) in enumerate((
        ("tresca", H), ("tresca", P), ("coulomb", H), ("coulomb", P),
        ("dovetail", (levels(9),)), ("cylinder-on-block", (levels(9),)))):
    for method, more in (("Dense", ()), ("Compressed", DENSITY)):
        counts = (2, 3) if EVERY else (2 + (k + (method == "Dense")) % 2,)
        compare(scene, settings + more, method, counts, 1e-10)
        if scene == "tresca" and method == "Dense":  # V by Belos
            compare(scene, settings, "Belos", counts, 1e-9, alone="Dense")

# trees of several levels
for scene, settings, counts in (
        ("tresca", (levels(2), *NONE, *UNIFORM, edges(32, 32, 8, 16, 8, 32)), (2, 3)),
        ("coulomb", (levels(1), *DENSITY, *UNIFORM, edges(40, 40, 40, 40)), (2,)),
        ("two-blocks", (levels(3), *DENSITY, *UNIFORM), (2, 3)),
        ("press-fit", (levels(3), *DENSITY), (2,)),
        ("tilting-punch", (levels(1),), (2, 3))):
    compare(scene, settings, "Compressed", counts, 1e-9)

# a load path.  At nu = 1/2 the density knows the mean pressure from gamma alone, so that rounding
# of u comes back in it 1e7 times as large: in the residuals of the estimate and in the contact
PATH = (edges(2, 2, 2, 3, 1, 9, 20, 9, 1, 3, 2, 2, 2, 3, 3, 3), "History->Times={1, 2, 4}",
        "History->Steps={1, 2, 4}")
RATIO = "Bodies->block->Material->Poisson's Ratio=%g"
for method in ("Dense", "Compressed"):
    compare("fretting", (RATIO % 0.3, *PATH), method, (2, 3), 1e-10)
compare("fretting", (RATIO % 0.5, *PATH), "Dense", (2, 3), 1e-10, 1e-9,
        ("eta_neumann", "eta_density", "estimate", "estimate_relative", "worst_step_estimate"))
ranks.finish()
