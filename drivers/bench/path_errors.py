#!/usr/bin/env python3
"""Errors of every step of a path, level by level, against a run that is kept.

    path_errors.py EPAFI SCENE DIR [--set KEY=VALUE ...] [--reference KEY=VALUE ...]
                   [--strategies "Graded hp,Adaptive h"] [--cap 1500] [--pressure 21:39]

Prints for each level its unknowns, CPU seconds of one thread so far and the largest error of any
step: of strain energy and of friction's work, relative to the step's own, and with --pressure of
lambda_n and of pressure in contact.csv, relative in L2 for x0 < x < x1.  `best` columns are the
best of the last three levels.  The reference is solved in DIR/reference unless it is there.
"""
import argparse
import bisect
import csv
import math
import os
import subprocess

ALWAYS = ["Adaptivity->Maximum Levels=1000", "Output->Contact Samples per Element=40",
          "Output->Fields=true"]


PRESSURES = ["lambda_n", "pressure"]


def table(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def run(epafi, scene, folder, settings, more=()):
    sets = [word for setting in [*ALWAYS, *settings] for word in ("--set", setting)]
    subprocess.run([epafi, "run", scene, "--quiet", "--threads", "1", *sets, *more], check=True,
                   stdout=subprocess.DEVNULL)


class Profile:
    """A column of a step along x, linear between samples."""

    def __init__(self, path, column="lambda_n"):
        points = sorted((float(row["x"]), float(row[column])) for row in table(path))
        self.x, self.values = zip(*points)

    def at(self, x):
        k = min(max(bisect.bisect_right(self.x, x), 1), len(self.x) - 1)
        a, b = self.x[k - 1], self.x[k]
        w = (x - a) / (b - a) if b > a else 0
        return (1 - w) * self.values[k - 1] + w * self.values[k]


def grid(interval, count=1800):
    a, b = interval
    return [a + (b - a) * (k + 0.5) / count for k in range(count)]


def profiles(folder, interval, column):
    result = []
    while os.path.exists(os.path.join(folder, "steps", str(len(result) + 1), "contact.csv")):
        profile = Profile(os.path.join(folder, "steps", str(len(result) + 1), "contact.csv"), column)
        result.append([profile.at(x) for x in grid(interval)])
    return result


def steps(folder):
    """Per level the rows of steps.csv."""
    levels = {}
    for row in table(os.path.join(folder, "steps.csv")):
        levels.setdefault(int(row["level"]), []).append(row)
    return levels


def relative(value, exact):
    return abs(value - exact) / abs(exact) if exact else abs(value)


def distance(profile, exact):
    size = math.sqrt(sum(p * p for p in exact))
    return math.sqrt(sum((p - q) ** 2 for p, q in zip(profile, exact))) / size if size else 0


def largest(errors):
    """The largest and its step."""
    return max((error, step) for step, error in enumerate(errors, 1))


def measured(options, name, reference):
    """Per level (unknowns, seconds, errors)."""
    folder = os.path.join(options.folder, name.replace(" ", "-").replace("=", "-").replace(">", ""))
    settings = [*options.set, "Adaptivity->Strategy=" + name.split(";")[0], *name.split(";")[1:]]
    exact = steps(reference)
    exact = exact[max(exact)]
    interval = options.pressure
    exactProfiles = profiles(reference, interval, "lambda_n") if interval else []
    subprocess.run(["rm", "-rf", folder], check=True)
    cap = "Adaptivity->Maximum Degrees of Freedom=%d" % options.cap
    rows = []
    if not interval:
        run(options.epafi, options.scene, folder, [*settings, cap], ["--output", folder])
        found = [None] * len(steps(folder))
    else:
        found = []
        while True:
            more = ["--restart", folder] if found else ["--output", folder]
            run(options.epafi, options.scene, folder,
                [*settings, cap, "Adaptivity->Maximum Levels=%d" % (len(found) + 1)], more)
            if len(table(os.path.join(folder, "history.csv"))) == len(found):
                break
            found.append([profiles(folder, interval, column) for column in PRESSURES])
    for row, (_, level), profile in zip(table(os.path.join(folder, "history.csv")),
                                        sorted(steps(folder).items()), found):
        errors = [largest(relative(float(a[key]), float(b[key])) for a, b in zip(level, exact))
                  for key in ("energy_strain", "energy_dissipated")]
        if interval:
            errors += [largest(distance(p, q) for p, q in zip(of, exactProfiles)) for of in profile]
        rows.append((int(row["dof"]), float(row["seconds_total"]), errors))
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("scene")
    parser.add_argument("folder")
    parser.add_argument("--set", action="append", default=[])
    parser.add_argument("--reference", action="append", default=[])
    parser.add_argument("--strategies", default="Graded hp")
    parser.add_argument("--cap", type=int, default=1500)
    parser.add_argument("--pressure", type=lambda text: tuple(map(float, text.split(":"))))
    options = parser.parse_args()
    reference = os.path.join(options.folder, "reference")
    if not os.path.exists(os.path.join(reference, "contact.csv")):
        run(options.epafi, options.scene, reference, [*options.set, *options.reference],
            ["--output", reference, "--force"])
    for name in options.strategies.split(","):
        print("%s\n%6s %7s  %s" % (name, "dof", "s", "   ".join(
            "%-27s" % (what + " step best") for what in
            ["energy", "work", *(PRESSURES if options.pressure else [])])), flush=True)
        rows = measured(options, name, reference)
        for k, (dof, seconds, errors) in enumerate(rows):
            cells = ["%.2e %3d %.2e" % (error, step, min(
                others[i][0] for _, _, others in rows[max(0, k - 2):k + 1]))
                     for i, (error, step) in enumerate(errors)]
            print("%6d %7.2f  %s" % (dof, seconds, "   ".join("%-27s" % c for c in cells)))


if __name__ == "__main__":
    main()
