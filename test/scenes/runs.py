"""Runs epafi and reads what it writes.  Standard library only.

Every test is called as  <test>.py EPAFI SCENES WORK:  the program, the folder of the shipped
scenes, a folder to write into.
"""
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, table  # noqa: E402, F401

EPAFI, SCENES, WORK = sys.argv[1:4]
RANKS = int(os.environ.get("EPAFI_TEST_RANKS", "1"))  # on which EPAFI, then a launcher, runs


def epafi(*arguments):
    """Exit code and what was printed, errors included."""
    done = subprocess.run([EPAFI, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True)
    return done.returncode, done.stdout


def scene(name):
    return os.path.join(SCENES, name)


def fresh(name):
    """A folder that does not exist yet."""
    return absent(os.path.join(WORK, name))


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


def solved(name, file, *settings, expect=0):
    """Claims that a scene ends with an exit code; the folder, and what was printed."""
    folder = fresh(name)
    code, text = epafi("run", file, "--output", folder,
                       *(x for s in settings for x in ("--set", s)))
    claim(code == expect, "%s: exit code %d%s" % (
        name, code, "" if code == expect else " " + text[-400:]))
    return folder, text


def rows(folder, file="contact.csv"):
    return table(os.path.join(folder, file))


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
