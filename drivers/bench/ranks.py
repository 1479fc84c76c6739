#!/usr/bin/python3
"""How much faster are two ranks than one?

    drivers/bench/ranks.py EPAFI OUTPUT.csv [REPETITIONS [ELEMENTS...]]

One level of the Tresca scene, p = 1, one thread a rank, 1 and 2 ranks by turns, so that what
else the machine does meets both.  Above 8000 elements without stabilisation, by compressed
operators.  Prints medians and minima of the seconds by the clock on the
wall and of the largest memory of a rank, as rows of doc/benchmarks/speed.md's table; all runs go
into the csv with the machine's load.
Standard library only.
"""
import csv
import os
import statistics
import subprocess
import sys
import tempfile

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "tresca.xml")
EDGES = (4, 4, 1, 2, 1, 4)  # of the coarse mesh: 16 elements
LARGE = ("Discretization->Multiplier=Biorthogonal", "Discretization->Stabilization->Form=None")
PHASES = ("assembly", "factorization", "stabilization", "newton", "estimate")


def environment():
    script = os.path.join(os.path.dirname(SCENE), "..", "..", "cmake", "environment.sh")
    lines = subprocess.run(["bash", script], stdout=subprocess.PIPE, check=True,
                           universal_newlines=True).stdout.split()
    return {**os.environ, **dict(line.split("=", 1) for line in lines),
            "OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}


def solve(epafi, ranks, elements, folder):
    """A row: what the level cost."""
    counts = "{%s}" % ", ".join(str(n * elements // 16) for n in EDGES)
    subprocess.run(
        ["mpirun", "-n", str(ranks), "--bind-to", "none", epafi, "run", SCENE, "--force", "--quiet",
         "--output", folder, "--threads", "1", "--set", "Adaptivity->Strategy=None",
         "--set", "Discretization->Elements per Edge=" + counts,
         "--set", "Adaptivity->Maximum Degrees of Freedom=%d" % (8 * elements),
         "--set", "Output->Fields=false",
         *(x for setting in LARGE if elements > 8000 for x in ("--set", setting))],
        check=True, env=environment())
    with open(os.path.join(folder, "history.csv"), newline="") as stream:
        level = next(csv.DictReader(stream))
    row = {"elements": elements, "ranks": ranks, "load": "%.1f" % os.getloadavg()[0],
           "seconds_wall": level["seconds_wall"], "memory_mb": level["memory_mb"]}
    row.update({"cpu_" + phase: level["seconds_" + phase] for phase in PHASES})
    return row


def main(epafi, output, repetitions=3, *sizes):
    rows = []
    print("| elements | | 1 rank | 2 ranks | ratio |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for elements in map(int, sizes or (1024, 2048, 4096)):
            for _ in range(int(repetitions)):
                rows += [solve(epafi, ranks, elements, folder) for ranks in (1, 2)]
                with open(output, "w", newline="") as stream:
                    writer = csv.DictWriter(stream, rows[0])
                    writer.writeheader()
                    writer.writerows(rows)

            for name in ("seconds_wall", "memory_mb"):
                for title, pick in (("median", statistics.median), ("least", min)):
                    one, two = (pick([float(row[name]) for row in rows
                                      if row["elements"] == elements and row["ranks"] == ranks])
                                for ranks in (1, 2))
                    print("| %d | %s, %s | %.2f | %.2f | %.2f |"
                          % (elements, name, title, one, two, one / two), flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
