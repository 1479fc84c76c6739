"""A path of one step is the solve without a path: random scenes (products.py) with History->Times={1}
against themselves without.

    one_step.py EPAFI WORK [--first SEED] [--count N] [--jobs N] [--seed SEED]...

Claimed are equal levels, elements and unknowns, and equal energies, by SAME of a level's largest; what
is below NOTHING of the body's size times Young's modulus is rounding of no load.
"""
import functools
import os
import sys

from products import Products
from run_random import Result, claim, finish, of_each, parser_of

SAME, NOTHING = 1e-10, 1e-30
SIZES = ("elements", "dof_displacement", "dof_multiplier", "degree_min", "degree_max")
ENERGIES = ("energy_strain", "energy_load", "energy_friction")


class Pair:
    """A scene solved at once and as a path of one step, and what is different."""

    def __init__(self, seed, epafi, work):
        self.seed = seed
        kind = functools.partial(Products, paths=False)
        self.once, self.path = (
            Result(kind, seed, epafi, os.path.join(work, name), settings)
            for name, settings in (("once", ()), ("path", ("History->Times={1}",))))
        self.isSolved = self.once.code == self.path.code == 0
        pairs = list(zip(self.once.levels, self.path.levels))
        self.isAlike = (self.once.code == self.path.code and
                        len(self.once.levels) == len(self.path.levels) and
                        all(a[size] == b[size] for a, b in pairs for size in SIZES))
        nothing = NOTHING * self.once.scene.energy
        self.off = max([differ(a, b, nothing) for a, b in pairs] or [0]) if self.isSolved else 0

    def __str__(self):
        return "%d (%s): exit codes %d and %d, %d and %d levels, energies off by %.1e %s" % (
            self.seed, ", ".join(self.once.scene.features), self.once.code, self.path.code,
            len(self.once.levels), len(self.path.levels), self.off,
            "" if self.isSolved else "\n    " + (self.once.text or self.path.text))


def differ(a, b, nothing):
    size = max(nothing, *(abs(a[energy]) for energy in ENERGIES))
    off = max(abs(a[energy] - b[energy]) for energy in ENERGIES)
    return off / size if off > nothing else 0


def main():
    options = parser_of(20).parse_args()
    pairs = of_each(options, lambda seed: Pair(seed, options.epafi, options.work))
    for pair in pairs:
        if not (pair.isSolved and pair.isAlike and pair.off <= SAME):
            print(pair)
    features = {}
    for pair in pairs:
        for feature in pair.once.scene.features:
            features[feature] = features.get(feature, 0) + 1
    print(", ".join("%s: %d" % item for item in sorted(features.items())))
    print("%d levels, of friction %d; worst %.1e" % (
        sum(len(pair.once.levels) for pair in pairs),
        sum(level["energy_friction"] > 0 for pair in pairs for level in pair.once.levels),
        max(pair.off for pair in pairs)))
    for which, wrong in (("not solved", [p for p in pairs if not p.isSolved]),
                         ("other levels", [p for p in pairs if not p.isAlike]),
                         ("other energies", [p for p in pairs if not p.off <= SAME])):
        claim(not wrong, "%d scenes, %s: %s" % (
            len(pairs), which, " ".join(str(pair.seed) for pair in wrong) or "none"))
    finish()


if __name__ == "__main__":
    sys.exit(main())
