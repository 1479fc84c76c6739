"""Solves random scenes, each made from its seed alone.

    run_random.py EPAFI WORK [--first SEED] [--count N] [--jobs N] [--seed SEED]...
                  [--bodies 2|3|pairs|parts|rings|odd|products|surfaces|revolution|slots|one_step|orders] [--set KEY=VALUE]...

Claimed is that all scenes are solved, that no level takes more than MOST steps, that no energy is
negative and that friction takes energy; of one_step that a path of one step is the solve without a
path: equal levels, elements and unknowns, energies equal by SAME of a level's largest; of pairs that forces
balance and none is far beyond the weight that it carries; of orders, pairs with either side first, that
normal forces are equal within twice the sum of both relative estimates and energies by NEAR in the median.
Of what fails the scene's file is printed.
"""
import argparse
import concurrent.futures
import functools
import json
import os
import shutil
import statistics
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, table, write  # noqa: E402
from bodies import Rings, ThreeBodies, TwoBodies  # noqa: E402
from oddities import Oddities  # noqa: E402
from pairs import Pairs  # noqa: E402
from parts import Parts  # noqa: E402
from products import Products  # noqa: E402
from revolutions import Revolutions  # noqa: E402
from scenes import Scene  # noqa: E402
from slots import Slots  # noqa: E402
from surfaces import Surfaces  # noqa: E402

FEW, MOST = 30, 100
KINDS = {"1": Scene, "2": TwoBodies, "3": ThreeBodies, "pairs": Pairs, "parts": Parts, "rings": Rings, "odd": Oddities,
         "products": Products, "surfaces": Surfaces, "revolution": Revolutions, "slots": Slots,
         "one_step": functools.partial(Products, paths=False), "orders": Pairs}
PATIENCE = 600
NEAR = 1e-4
SAME, NOTHING = 1e-10, 1e-30  # what is below the latter of E times size^2 is rounding of no load
SIZES = ("elements", "dof_displacement", "dof_multiplier", "degree_min", "degree_max")
ENERGIES = ("energy_strain", "energy_load", "energy_friction")


class Result:
    """What became of a scene: exit code, message, steps of each level."""

    def __init__(self, kind, seed, epafi, work, settings=()):
        self.scene = kind(seed)
        folder = absent(os.path.join(work, "%d" % seed))
        os.makedirs(folder)
        self.file = write(os.path.join(folder, "scene.yaml"), json.dumps(
            {"Random scene %d" % seed: self.scene.scene()}))
        out = os.path.join(folder, "out")
        try:
            done = subprocess.run([epafi, "run", self.file, "--quiet", "--threads", "1",
                                   "--output", out, *("--set=" + each for each in settings)],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  universal_newlines=True, timeout=PATIENCE)
            self.code, self.text = done.returncode, done.stdout.strip()
        except subprocess.TimeoutExpired:
            self.code, self.text = -1, "no end within %d s" % PATIENCE
        history = os.path.join(out, "history.csv")
        self.levels = table(history) if os.path.exists(history) else []
        self.steps = [int(level["newton_iterations"]) for level in self.levels]
        path = os.path.join(out, "steps.csv")
        if os.path.exists(path):  # of the step of each level that took most
            most = {}
            for step in table(path):
                most[step["level"]] = max(most.get(step["level"], 0), int(step["newton_iterations"]))
            self.steps = list(most.values())
        self.senseless = not all(makes_sense(level, self.scene)
                                 for level in self.levels)
        self.wrong = []
        path = os.path.join(out, "bodies.csv")
        if hasattr(self.scene, "wrong") and os.path.exists(path):
            rows = table(path)
            for level in self.levels:
                self.wrong += self.scene.wrong(
                    level, [row for row in rows if row["level"] == level["level"]])
        if (self.code == 0 and not self.senseless and not self.wrong and
                max(self.steps, default=0) <= FEW):
            shutil.rmtree(folder)


def makes_sense(level, scene):
    """Bonds may pull."""
    # pairs may not touch yet, loads may be zero: all is rounding
    nothing = getattr(scene, "nothing", NOTHING) * getattr(scene, "energy", 0)
    if abs(level["energy_strain"]) <= nothing:
        return True
    return level["energy_strain"] >= 0 and level["energy_friction"] >= 0 and (
        "Tied" in scene.laws or level["force_normal"] >= getattr(scene, "least", 0))


def off(once, path):
    """How far the energies of two runs are apart; infinitely if they have other levels."""
    worst, nothing = 0, NOTHING * once.scene.energy
    for a, b in zip(once.levels, path.levels):
        size = max(nothing, *(abs(a[energy]) for energy in ENERGIES))
        apart = max(abs(a[energy] - b[energy]) for energy in ENERGIES)
        worst = max(worst, apart / size if apart > nothing else 0,
                    *(float("inf") for key in SIZES if a[key] != b[key]))
    return worst if len(once.levels) == len(path.levels) else float("inf")


def between(one, other):
    """What the last levels of two runs differ by: force over what it may, and energy."""
    a, b = one.levels[-1], other.levels[-1]
    if max(a["energy_strain"], b["energy_strain"]) <= NOTHING * one.scene.energy:
        return 0, 0
    force = max(abs(a["force_normal"]), abs(b["force_normal"]), NOTHING)
    allowed = 2 * (a["estimate_relative"] + b["estimate_relative"])
    return (abs(a["force_normal"] - b["force_normal"]) / force / allowed,
            abs(a["energy_strain"] - b["energy_strain"]) / max(a["energy_strain"], b["energy_strain"]))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("epafi")
    parser.add_argument("work")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, action="append", default=[])
    parser.add_argument("--bodies", default="1", choices=KINDS)
    parser.add_argument("--set", action="append", default=[], help="said to every scene")
    options = parser.parse_args()
    seeds = options.seed or range(options.first, options.first + options.count)

    def solved(work, *settings, kind=KINDS[options.bodies]):
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            return list(pool.map(lambda seed: Result(kind, seed, options.epafi, work,
                                                     [*options.set, *settings]), seeds))

    def none(sentence, wrong):
        seeds = " ".join(str(result.scene.seed) for result in wrong)
        claim(not wrong, "%s: %s" % (sentence, seeds or "none"))

    results = solved(options.work)
    if options.bodies == "one_step":
        pairs = list(zip(results, solved(os.path.join(options.work, "path"), "History->Times={1}")))
        none("a path of one step is another solve", [a for a, b in pairs if not off(a, b) <= SAME])
        results = [result for pair in pairs for result in pair]
    if options.bodies == "orders":
        others = solved(os.path.join(options.work, "swapped"), kind=functools.partial(Pairs, swapped=True))
        pairs = [(a, b, between(a, b)) for a, b in zip(results, others) if a.levels and b.levels]
        none("forces of both orders apart", [a for a, b, (force, energy) in pairs if force > 1])
        middle = statistics.median(energy for a, b, (force, energy) in pairs)
        claim(middle <= NEAR, "energies of both orders apart by %.1e in the median of %d" % (middle, len(pairs)))
        results += others
    for result in results:
        if result.code != 0 or max(result.steps, default=0) > FEW:
            print("%s: exit code %d, steps %s\n        %s" % (
                result.file, result.code, result.steps, result.text))
    steps = [step for result in results for step in result.steps] or [0]
    print("%d levels of %g steps in the median, %d at most, %d of more than %d" % (
        len(steps), statistics.median(steps), max(steps), sum(step > FEW for step in steps), FEW))
    none("%d scenes, not solved" % len(results), [r for r in results if r.code != 0])
    none("energies or pressures below zero", [r for r in results if r.senseless])
    for result in results:
        if result.wrong:
            print("%s: %s" % (result.file, "; ".join(result.wrong)))
    none("forces out of balance or beyond the load", [r for r in results if r.wrong])
    none("more than %d steps" % MOST, [r for r in results if max(r.steps, default=0) > MOST])
    finish()


if __name__ == "__main__":
    main()
