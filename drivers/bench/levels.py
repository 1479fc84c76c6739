#!/usr/bin/env python3
"""Seconds of one level by phase, one thread, p = 1, uniform: [P 8.1] with N elements.

    levels.py EPAFI [--runs 5] [--elements 256,1024] [--csv FILE]

Prints a Markdown table of medians with the error beside every time; the error is that of the
strain energy, relative to an overkill run by "Graded hp" that the script makes first.  Results are
appended to --csv.
"""
import argparse
import csv
import datetime
import os
import statistics
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "tresca.xml")
PHASES = ["assembly", "factorization", "stabilization", "newton", "estimate"]


def last_row(epafi, folder, overrides):
    command = [epafi, "run", SCENE, "--quiet", "--force", "--threads", "1", "--output", folder]
    for override in overrides:
        command += ["--set", override]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        return list(csv.DictReader(file))[-1]


def uniform(elements):
    counts = [elements // 4, elements // 4, elements // 16, elements // 8, elements // 16,
              elements // 4]
    return ["Discretization->Elements per Edge={%s}" % ", ".join(map(str, counts)),
            "Adaptivity->Strategy=None", "Adaptivity->Maximum Degrees of Freedom=100000"]


def overkill():
    return ["Adaptivity->Strategy=Graded hp", "Adaptivity->Marking Fraction=0.6",
            "Adaptivity->Maximum Levels=60", "Adaptivity->Maximum Degrees of Freedom=1400"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--elements", default="256,1024")
    parser.add_argument("--csv")
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        exact = float(last_row(options.epafi, folder, overkill())["energy_strain"])
        rows = []
        for elements in map(int, options.elements.split(",")):
            runs = [last_row(options.epafi, folder, uniform(elements))
                    for _ in range(options.runs)]
            row = {"date": datetime.date.today().isoformat(), "elements": elements,
                   "dof": runs[0]["dof"],
                   "energy_error": "%.2e" % abs(float(runs[0]["energy_strain"]) / exact - 1)}
            for phase in PHASES:
                row[phase] = "%.4f" % statistics.median(
                    float(run["seconds_" + phase]) for run in runs)
            row["total"] = "%.4f" % statistics.median(
                float(run["seconds_total"]) for run in runs)
            row["memory_mb"] = "%.0f" % statistics.median(
                float(run["memory_mb"]) for run in runs)
            row["newton_steps"] = runs[0]["newton_iterations"]
            rows.append(row)

    names = list(rows[0])[1:]
    print("| " + " | ".join(names) + " |")
    print("|" + "---|" * len(names))
    for row in rows:
        print("| " + " | ".join(str(row[name]) for name in names) + " |")
    if options.csv:
        new = not os.path.exists(options.csv)
        with open(options.csv, "a", newline="") as file:
            writer = csv.DictWriter(file, list(rows[0]))
            if new:
                writer.writeheader()
            writer.writerows(rows)
    return 0


if __name__ == "__main__":
    sys.exit(main())
