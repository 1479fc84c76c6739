"""Runs random scenes (scenes.py, bodies.py, oddities.py, products.py, surfaces.py): each is solved, in few steps of Newton's.

    run_random.py EPAFI WORK [--first SEED] [--count N] [--jobs N] [--seed SEED]... [--table FILE]
                  [--bodies 2|3|rings|odd|products|surfaces] [--set KEY=VALUE]...

Prints what fails with the scene's file, then steps per level by law, basis, strategy and more,
and which stages of the solver decided.
Claimed is that all scenes are solved, that no level takes more than MOST steps, that no energy
is negative and that friction takes energy.
"""
import argparse
import concurrent.futures
import csv
import json
import os
import shutil
import statistics
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, table, write  # noqa: E402
from bodies import Rings, ThreeBodies, TwoBodies  # noqa: E402
from oddities import Oddities  # noqa: E402
from products import Products  # noqa: E402
from scenes import Scene  # noqa: E402
from stages import levels, printed  # noqa: E402
from surfaces import Surfaces  # noqa: E402

FEW, MOST = 30, 100
KINDS = {"1": Scene, "2": TwoBodies, "3": ThreeBodies, "rings": Rings, "odd": Oddities,
         "products": Products, "surfaces": Surfaces}
PATIENCE = 600


class Result:
    """What became of a scene: exit code, message, steps of each level."""

    def __init__(self, kind, seed, epafi, work, settings=()):
        self.scene = kind(seed)
        folder = absent(os.path.join(work, "%d" % seed))
        os.makedirs(folder)
        self.file = write(os.path.join(folder, "scene.yaml"), json.dumps(
            {"Random scene %d" % seed: self.scene.scene()}))
        out = os.path.join(folder, "out")
        start = time.monotonic()
        try:
            done = subprocess.run([epafi, "run", self.file, "--quiet", "--threads", "1",
                                   "--output", out, *("--set=" + each for each in settings)],
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                  universal_newlines=True, timeout=PATIENCE)
            self.code, self.text = done.returncode, done.stdout.strip()
        except subprocess.TimeoutExpired:
            self.code, self.text = -1, "no end within %d s" % PATIENCE
        self.seconds = time.monotonic() - start
        history = os.path.join(out, "history.csv")
        self.levels = table(history) if os.path.exists(history) else []
        self.steps = [int(level["newton_iterations"]) for level in self.levels]
        path = os.path.join(out, "steps.csv")
        if os.path.exists(path):  # of the step of each level that took most
            most = {}
            for step in table(path):
                most[step["level"]] = max(most.get(step["level"], 0), int(step["newton_iterations"]))
            self.steps = list(most.values())
        self.senseless = not all(makes_sense(level, "Tied" in self.scene.laws)
                                 for level in self.levels)
        timings = os.path.join(out, "timings.txt")
        self.stages = []
        if os.path.exists(timings):
            with open(timings) as stream:
                self.stages = levels(stream.read())
        if self.code == 0 and not self.senseless and max(self.steps, default=0) <= FEW:
            shutil.rmtree(folder)

    def kinds(self):
        """What was drawn; of a law and a gap there may be two."""
        scene = self.scene
        return {"law": sorted(set(scene.laws)), "basis": [scene.basis],
                "strategy": [scene.strategy], "gap": sorted(set(scene.gaps)),
                "held": [scene.held], "feature": getattr(scene, "features", [])}

    def words(self):
        return [" + ".join(members) for members in self.kinds().values()]


def makes_sense(level, tied):
    """Bonds may pull."""
    return (float(level["energy_strain"]) >= 0 and float(level["energy_friction"]) >= 0 and
            (tied or float(level["force_normal"]) >= 0))


def summary(results):
    """Rows: kind, member, scenes, failed, levels, median and worst steps, levels above FEW."""
    groups = {}
    for result in results:
        for kind, members in [("all", [""])] + list(result.kinds().items()):
            for member in members:
                groups.setdefault((kind, member), []).append(result)
    for (kind, member), group in sorted(groups.items()):
        steps = [step for result in group for step in result.steps] or [0]
        yield (kind, member, len(group), sum(result.code != 0 for result in group), len(steps),
               statistics.median(steps), max(steps), sum(step > FEW for step in steps))


def parser_of(count):
    """Of what is said of seeds; so many if nothing is."""
    parser = argparse.ArgumentParser()
    parser.add_argument("epafi")
    parser.add_argument("work")
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--count", type=int, default=count)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--seed", type=int, action="append", default=[])
    return parser


def of_each(options, make):
    """What is made of each seed, some at a time."""
    seeds = options.seed or range(options.first, options.first + options.count)
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        return list(pool.map(make, seeds))


def main():
    parser = parser_of(40)
    parser.add_argument("--bodies", default="1", choices=KINDS)
    parser.add_argument("--set", action="append", default=[], help="said to every scene")
    parser.add_argument("--table", help="a row for each scene, csv")
    options = parser.parse_args()
    results = of_each(options, lambda seed: Result(KINDS[options.bodies], seed, options.epafi,
                                                   options.work, options.set))
    for result in results:
        if result.code != 0 or max(result.steps, default=0) > FEW:
            print("%s: exit code %d, steps %s, %s\n        %s" % (
                result.file, result.code, result.steps, ", ".join(result.words()),
                result.text))
    print("%-9s %-24s %6s %6s %6s %6s %6s %6s" % ("", "", "scenes", "failed", "levels",
                                                  "median", "worst", "> %d" % FEW))
    for row in summary(results):
        print("%-9s %-24s %6d %6d %6d %6g %6d %6d" % row)
    print(printed([level for result in results for level in result.stages]))
    if options.table:
        with open(options.table, "w", newline="") as stream:
            writer = csv.writer(stream)
            writer.writerow(["seed", "code", "seconds", "steps", *results[0].kinds()])
            for result in results:
                writer.writerow([result.scene.seed, result.code, "%.2f" % result.seconds,
                                 " ".join(map(str, result.steps)), *result.words()])
    failed = [result.scene.seed for result in results if result.code != 0]
    claim(not failed, "%d scenes, not solved: %s" % (
        len(results), " ".join(map(str, failed)) or "none"))
    senseless = [result.scene.seed for result in results if result.senseless]
    claim(not senseless, "energies or pressures below zero: %s" % (
        " ".join(map(str, senseless)) or "none"))
    slow = [result.scene.seed for result in results if max(result.steps, default=0) > MOST]
    claim(not slow, "more than %d steps: %s" % (MOST, " ".join(map(str, slow)) or "none"))
    finish()


if __name__ == "__main__":
    main()
