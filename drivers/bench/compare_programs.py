#!/usr/bin/env python3
"""Compares two programs: the same numbers, errors no worse, times.

    compare_programs.py OLD NEW [--work DIR] [--repeat N] [--levels N] [--only NAME]...

Both paper scenes with Uniform h and Uniform p, and every shipped scene as it is.  Runs without
decisions agree to 1e-10 of each column's scale (test/scales.py), in history.csv and
contact.csv.  Adaptive runs agree to 1e-9 up to the first level that is refined otherwise; said
is how far the decision before it was from its threshold, and how large the errors are at equal
degrees of freedom from there on.  With --repeat the programs run in turn, and medians of the CPU seconds
of each phase over all levels are compared.  Exit code 1 when numbers differ.  Needs h5py.
"""
import argparse
import glob
import math
import os
import statistics
import subprocess
import sys

import h5py
import numpy

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
sys.path.insert(0, os.path.join(ROOT, "test"))
from claims import absent, claim, finish, table  # noqa: E402
from scales import worst  # noqa: E402

SCENES = os.path.join(ROOT, "drivers", "scenes")
MESH = ("elements", "dof", "degree_min", "degree_max")
COUNTS = ("newton_iterations", "coulomb_iterations")
UNIFORM = ("None", "Uniform h", "Uniform p")
STATES = ("contact", "friction")  # of a point; where nothing presses or slides, rounding's


class Run:
    def __init__(self, program, scene, settings, folder):
        command = [program, "run", scene, "--quiet", "--threads", "1",
                   "--output", absent(folder)]
        for setting in settings:
            command += ["--set", setting]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True)
        if done.returncode != 0:
            sys.exit("%s: exit code %d\n%s" % (" ".join(command), done.returncode, done.stdout))
        self.folder = folder
        self.history = table(os.path.join(folder, "history.csv"))
        self.contact = table(os.path.join(folder, "contact.csv"))

    def used(self, key):
        with open(os.path.join(self.folder, "used.xml")) as stream:
            text = stream.read()
        return text.split('name="%s"' % key)[1].split('value="')[1].split('"')[0]

    def checkpoint(self):
        with h5py.File(os.path.join(self.folder, "solution.hdf"), "r") as file:
            return {name: item[()] for name, item in file["Epafi"].items()}

    def seconds(self, phase):
        return sum(row["seconds_" + phase] for row in self.history)


def comparable(one, other):
    """Columns of both tables: a newer program may have more."""
    return [name for name in one[0] if name in other[0] and name not in COUNTS + STATES]


def same(what, old, new, columns):
    missing = [name for name in old.history[0] if name not in new.history[0]]
    claim(not missing, "%s: columns that are gone: %s" % (what, " ".join(missing) or "none"))
    claim(len(old.history) == len(new.history), "%s: %d levels, %d levels" % (
        what, len(old.history), len(new.history)))
    for name, a, b in (("history.csv", old.history, new.history),
                       ("contact.csv", old.contact, new.contact)):
        apart = worst(a, b, columns or comparable(a, b))
        claim(apart[0] <= 1e-10, "%s: %s differs by %.1e, in %s" % (what, name, *apart))
    for name in COUNTS:
        a, b = ([row[name] for row in run.history] for run in (old, new))
        claim(a == b, "%s: %s %d and %d, most %d and %d" % (
            what, name.replace("_", " "), sum(a), sum(b), max(a), max(b)))


def doerflerMargin(squares, fraction):
    """How little of the sum decides how many elements are marked, and how little of an
    element's part decides which."""
    ordered = numpy.sort(squares)[::-1]
    tails = numpy.append(numpy.cumsum(ordered[::-1])[::-1], 0.0)
    rest = (1 - fraction) * tails[0]
    count = 1
    while count < len(ordered) and tails[count] > rest:
        count += 1
    much = min(abs(tails[k] - rest) for k in (count - 1, count)) / tails[0]
    below = ordered[ordered < (1 - 1e-10) * ordered[count - 1]]
    return much, (1 - below[0] / ordered[count - 1] if len(below) else 1.0)


def decayMargins(run, threshold):
    """Distance from the threshold, for each element, of the decay of its displacement's
    Legendre coefficients (of clamped elements the density's, left out here)."""
    points = {}
    for point in table(os.path.join(run.folder, "boundary.csv")):
        points.setdefault(int(point["element"]), []).append(point)
    margins = []
    for element in points.values():
        degree = int(element[0]["degree"])
        t = numpy.linspace(-1, 1, len(element))
        arm = numpy.arange(degree + 1) - degree / 2
        for component in ("ux", "uy"):
            values = numpy.array([point[component] for point in element])
            if degree == 0 or not numpy.any(values):
                continue
            series = numpy.abs(numpy.polynomial.legendre.legfit(t, values, degree))
            rate = math.exp(-(arm @ numpy.log(series + 1e-300)) / -(arm @ arm))
            margins.append(abs(1 / rate / threshold - 1))
    return margins


def decision(what, programs, scene, settings, level, work):
    """Says on what the mesh of this level depended."""
    runs = [Run(program, scene, settings + ["Adaptivity->Maximum Levels=%d" % level],
                os.path.join(work, "decision-%d" % k)) for k, program in enumerate(programs)]
    old, new = (run.checkpoint() for run in runs)
    fraction, threshold = (float(runs[0].used(key)) for key in
                           ("Marking Fraction", "Analyticity Threshold"))
    squares = [point["indicators"].sum(axis=1) for point in (old, new)]
    states = sum(int((old[name] != new[name]).sum())
                 for name in ("contact_state", "friction_state"))
    much, which = doerflerMargin(squares[0], fraction)
    print("        %s, level %d before it: indicators apart by %.1e of their largest, nodes by "
          "%.1e, %d states differ" % (
              what, level - 1, abs(squares[0] - squares[1]).max() / squares[0].max(),
              abs(old["position"] - new["position"]).max(), states))
    print("        the bulk is met within %.1e of the sum, the next element is smaller by %.1e, "
          "a decay is %.1e from its threshold" % (
              much, which, min(decayMargins(runs[0], threshold), default=1)))


def at(rows, column, dof):
    """log of a column at so many degrees of freedom, between levels."""
    x = [math.log(row["dof"]) for row in rows]
    y = [math.log(max(row[column], 1e-300)) for row in rows]
    return float(numpy.interp(math.log(dof), x, y))


def errors(what, old, new, level, exact):
    """Ratios new : old of estimate and energy error at equal dof after the first difference."""
    for run in (old, new):
        for row in run.history:
            row["energy_error"] = abs(row["energy_strain"] / exact - 1)
    end = min(run.history[-1]["dof"] for run in (old, new))
    for column, most in (("estimate", 1.3), ("energy_error", 2.0)):
        ratios = [math.exp(at(new.history, column, row["dof"]) -
                           at(old.history, column, row["dof"]))
                  for row in old.history[level:] if row["dof"] <= end] or [1.0]
        claim(statistics.median(ratios) <= most,
              "%s: %s at equal dof, new : old, median %.3f, range %.3f to %.3f" % (
                  what, column, statistics.median(ratios), min(ratios), max(ratios)))


def firstDifference(old, new):
    pairs = zip(old.history, new.history)
    return next((k for k, (a, b) in enumerate(pairs) if any(a[c] != b[c] for c in MESH)), None)


def compare(what, programs, scene, settings, work):
    old, new = (Run(program, scene, settings, os.path.join(work, "%d" % k))
                for k, program in enumerate(programs))
    if old.used("Strategy") in UNIFORM:
        return same(what, old, new, None)
    first = firstDifference(old, new)
    shared = min(len(old.history), len(new.history)) if first is None else first
    claim(shared > 0, "%s: the first level is the same" % what)
    rows = [run.history[:shared] for run in (old, new)]
    apart = worst(*rows, comparable(*rows))
    claim(apart[0] <= 1e-9, "%s: %s; until then apart by %.1e, in %s" % (
        what, "all %d levels are refined alike" % shared if first is None else
        "level %d is the first to differ" % first, *apart))
    for name in COUNTS:
        print("        %s: %s until then %s" % (what, name.replace("_", " "), " and ".join(
            "%d" % sum(row[name] for row in kind) for kind in rows)))
    if first is not None:
        decision(what, programs, scene, settings, first, work)
    exact = Run(programs[0], scene, settings + [
        "Adaptivity->Maximum Degrees of Freedom=%d" % (1.6 * old.history[-1]["dof"])],
        os.path.join(work, "exact")).history[-1]["energy_strain"]
    errors(what, old, new, shared if first is not None else 0, exact)


def times(what, programs, scene, settings, work, repeat):
    runs = ([], [])
    for _ in range(repeat):
        for k, program in enumerate(programs):
            runs[k].append(Run(program, scene, settings, os.path.join(work, "times")))
    phases = [name[len("seconds_"):] for name in runs[0][0].history[0]
              if name.startswith("seconds_") and name not in ("seconds_total", "seconds_wall")]
    for phase in phases:
        old, new = (statistics.median(run.seconds(phase) for run in kind) for kind in runs)
        print("        %-28s %-14s %9.4f %9.4f s  new : old %.2f" % (
            what, phase, old, new, new / old if old > 0 else float("nan")))


def cases(only):
    for name in ("tresca", "coulomb"):
        for strategy, levels in (("Uniform h", 4), ("Uniform p", 5)):
            yield "%s, %s" % (name, strategy), name, [
                "Adaptivity->Strategy=" + strategy, "Adaptivity->Maximum Levels=%d" % levels]
    for file in sorted(glob.glob(os.path.join(SCENES, "*.xml"))):
        name = os.path.basename(file)[:-len(".xml")]
        yield name, name, []


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("--work", default="build/compare")
    parser.add_argument("--repeat", type=int, default=0)
    parser.add_argument("--only", action="append", default=[], help="scene, e.g. coulomb")
    options = parser.parse_args()
    programs = (options.old, options.new)
    for what, name, settings in cases(options.only):
        if options.only and name not in options.only:
            continue
        scene = os.path.join(SCENES, name + ".xml")
        compare(what, programs, scene, settings, options.work)
        if options.repeat:
            times(what, programs, scene, settings, options.work, options.repeat)
    finish()


if __name__ == "__main__":
    main()
