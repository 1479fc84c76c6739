"""Runs epafi and reads what it writes.  Standard library only.

Every test is called as  <test>.py EPAFI SCENES WORK:  the program, the folder of the shipped
scenes, a folder to write into.
"""
import csv
import os
import shutil
import subprocess
import sys

EPAFI, SCENES, WORK = sys.argv[1:4]
failures = []


def claim(true, sentence):
    """Notes a claim that does not hold; finish() reports all of them."""
    print(("ok      " if true else "FAILED  ") + sentence)
    if not true:
        failures.append(sentence)


def finish():
    sys.exit(1 if failures else 0)


def epafi(*arguments):
    """Exit code and what was printed, errors included."""
    done = subprocess.run([EPAFI, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    return done.returncode, done.stdout


def scene(name):
    return os.path.join(SCENES, name)


def fresh(name):
    """A folder that does not exist yet."""
    folder = os.path.join(WORK, name)
    shutil.rmtree(folder, ignore_errors=True)
    return folder


def run(file, name, settings=(), expect=0):
    """Solves a scene; returns the rows of history.csv and of contact.csv."""
    folder = fresh(name)
    arguments = ["run", file, "--output", folder]
    for setting in settings:
        arguments += ["--set", setting]
    code, text = epafi(*arguments)
    if code != expect:
        sys.exit("%s: exit code %d, expected %d\n%s" % (name, code, expect, text))
    contact = os.path.join(folder, "contact.csv")
    return table(os.path.join(folder, "history.csv")), (
        table(contact) if os.path.exists(contact) else [])


def table(file):
    """Rows as dictionaries, numbers as floats."""
    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    with open(file, newline="") as stream:
        return [{key: value(cell) for key, cell in row.items()}
                for row in csv.DictReader(stream)]


def whole(contact):
    """Points of elements of one state: where the state changes, the conditions hold for the
    coefficients, not for the polynomial between them."""
    states = {}
    for point in contact:
        states.setdefault(point["element"], set()).add((point["contact"], point["friction"]))
    return [point for point in contact if len(states[point["element"]]) == 1]


def levels(count):
    return ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=%d" % count,
            "Adaptivity->Maximum Degrees of Freedom=100000"]


def differ(a, b, scale=None):
    """Relative difference."""
    return abs(a - b) / (scale or max(abs(a), abs(b)) or 1)


ENERGIES = ["energy_strain", "energy_load", "energy_friction"]
FORCES = ["force_normal", "force_tangential", "reaction_x", "reaction_y", "load_x", "load_y",
          "contact_x", "contact_y"]
MOMENTS = ["reaction_moment", "load_moment", "contact_moment"]
