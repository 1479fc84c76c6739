"""Which stages of the solver decide.  Standard library only.

    stages.py FOLDER...        counts all timings.txt below these folders

A line of timings.txt says what was tried on a level, the last one decides:
"level 2: full steps 17 cycling, follow offset 5 converged".
"""
import os
import re
import statistics
import sys

RUN = re.compile(r"(?P<stage>[a-z][a-z ]*?) (?P<steps>\d+) "
                 r"(?P<end>converged|unfinished|cycling|grows|not finite|stalled|singular|"
                 r"no balance)")


def outermost(text):
    """The text without what stands in parentheses."""
    depth, kept = 0, ""
    for character in text:
        depth += character == "("
        kept += character if depth == 0 else ""
        depth -= character == ")"
    return kept


def levels(text):
    """For each level of a timings.txt its stages: (name, steps, how it ended)."""
    lines = re.findall(r"^level \d+: (.*)$", text, re.MULTILINE)
    return [[(run["stage"], int(run["steps"]), run["end"])
             for run in RUN.finditer(outermost(line))] for line in lines]


def counted(solves):
    """Rows by stage: name, solves that it ran in, that it decided, median and worst steps of
    those; most decisions first."""
    ran, decided = {}, {}
    for solve in solves:
        for stage, _, _ in solve:
            ran[stage] = ran.get(stage, 0) + 1
        if solve and solve[-1][2] == "converged":
            decided.setdefault(solve[-1][0], []).append(sum(steps for _, steps, _ in solve))
    return sorted(((stage, ran[stage], len(decided.get(stage, [])),
                    statistics.median(decided.get(stage, [0])),
                    max(decided.get(stage, [0]))) for stage in ran), key=lambda row: -row[2])


def printed(solves):
    text = "%-18s %8s %8s %8s %8s\n" % ("stage", "ran", "decided", "median", "worst")
    return text + "".join("%-18s %8d %8d %8g %8d\n" % row for row in counted(solves))


if __name__ == "__main__":
    found = []
    for folder in sys.argv[1:]:
        for path, _, files in os.walk(folder):
            if "timings.txt" in files:
                with open(os.path.join(path, "timings.txt")) as stream:
                    found += levels(stream.read())
    sys.stdout.write(printed(found))
