#!/usr/bin/python3
"""What one level of the Tresca scene costs by phase, p = 1, uniform: [P 8.1] with N elements.

    levels.py EPAFI [--runs 5] [--elements 256,1024] [--ranks 1,2] [--csv FILE]

One thread a rank; numbers of ranks by turns, so that what else the machine does meets all.  Prints
a Markdown table of medians: CPU seconds of the slowest rank, seconds by the clock, memory of the
largest rank, and the error of the strain energy relative to a run by "Graded hp" that the script
makes first.  Above 8000 elements by compressed operators, without stabilisation.  All runs are
appended to --csv with the load of the machine.
"""
import argparse
import csv
import datetime
import os
import statistics
import subprocess
import tempfile

from study_tables import ROOT, append, markdown

SCENE = os.path.join(ROOT, "drivers", "scenes", "tresca.xml")
EDGES = (4, 4, 1, 2, 1, 4)  # of 16 elements
OVERKILL = ["Adaptivity->Strategy=Graded hp", "Adaptivity->Marking Fraction=0.6",
            "Adaptivity->Maximum Levels=60", "Adaptivity->Maximum Degrees of Freedom=1400"]
LARGE = ["Discretization->Multiplier=Biorthogonal", "Discretization->Stabilization->Form=None"]
COSTS = ["seconds_" + phase for phase in ("assembly", "factorization", "stabilization", "newton",
                                          "estimate", "total", "wall")] + ["memory_mb"]


def environment():
    script = os.path.join(ROOT, "cmake", "environment.sh")
    lines = subprocess.run(["bash", script], stdout=subprocess.PIPE, check=True,
                           universal_newlines=True).stdout.split()
    return {**os.environ, **dict(line.split("=", 1) for line in lines),
            "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def last_row(epafi, ranks, folder, settings):
    launcher = ["mpirun", "-n", str(ranks), "--bind-to", "none"] if ranks > 1 else []
    subprocess.run([*launcher, epafi, "run", SCENE, "--quiet", "--force", "--threads", "1",
                    "--output", folder, *(x for setting in settings for x in ("--set", setting))],
                   check=True, env=environment())
    with open(os.path.join(folder, "history.csv"), newline="") as file:
        return list(csv.DictReader(file))[-1]


def uniform(elements):
    counts = ", ".join(str(n * elements // 16) for n in EDGES)
    return ["Discretization->Elements per Edge={%s}" % counts, "Adaptivity->Strategy=None",
            "Adaptivity->Maximum Degrees of Freedom=%d" % (8 * elements),
            *(["Output->Fields=false", *LARGE] if elements > 8000 else [])]


def numbers(text):
    return [int(word) for word in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--elements", type=numbers, default=[256, 1024])
    parser.add_argument("--ranks", type=numbers, default=[1])
    parser.add_argument("--csv")
    options = parser.parse_args()
    names = ["elements", "ranks", "dof", "newton_iterations", "energy_error", *COSTS]
    print(markdown(names, []))
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        exact = float(last_row(options.epafi, 1, folder, OVERKILL)["energy_strain"])
        for elements in options.elements:
            runs = [{**last_row(options.epafi, ranks, folder, uniform(elements)), "ranks": ranks,
                     "date": datetime.date.today().isoformat(), "load": os.getloadavg()[0]}
                    for _ in range(options.runs) for ranks in options.ranks]
            for run in runs:
                run["energy_error"] = "%.2e" % abs(float(run["energy_strain"]) / exact - 1)
            rows += [{name: run[name] for name in ["date", "load", *names]} for run in runs]
            for ranks in options.ranks:
                own = [run for run in runs if run["ranks"] == ranks]
                medians = {name: "%.4g" % statistics.median(float(run[name]) for run in own)
                           for name in COSTS}
                row = {**own[0], **medians}
                print("| " + " | ".join(str(row[name]) for name in names) + " |", flush=True)
    if options.csv:
        append(options.csv, rows)


if __name__ == "__main__":
    main()
