"""Runs epafi and reads what it writes.  Standard library only, but for keys_of().

Every test is called as  <test>.py EPAFI SCENES WORK:  the program, the folder of the shipped
scenes, a folder to write into.
"""
import base64
import json
import os
import signal
import struct
import subprocess
import sys
import time
import xml.etree.ElementTree as xml

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, options, raises, read, table, write  # noqa: E402, F401
from scales import worst  # noqa: E402

EPAFI, SCENES, WORK = *sys.argv[1:3], os.path.abspath(sys.argv[3])
RANKS = int(os.environ.get("EPAFI_TEST_RANKS", "1"))  # on which EPAFI, then a launcher, runs
os.makedirs(WORK, exist_ok=True)


def epafi(*arguments, settings=(), cwd=None):
    """Exit code and what was printed, errors included."""
    done = subprocess.run([EPAFI, *arguments, *options(settings)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, universal_newlines=True, cwd=cwd)
    return done.returncode, done.stdout


def stopped(ready, *arguments, how=signal.SIGKILL):
    """Starts the program, ends it by a signal as soon as something is so; its exit code."""
    process = subprocess.Popen([EPAFI, *arguments], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
    while process.poll() is None and not ready():
        time.sleep(0.001)
    process.send_signal(how)
    return process.wait()


def interrupted(behind, *arguments):
    """Starts the program, interrupts it as soon as it tells of so many steps of a path."""
    with subprocess.Popen([EPAFI, *arguments], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                          universal_newlines=True) as process:
        for line in process.stdout:
            behind -= line.startswith("        step ")
            if behind == 0:
                process.send_signal(signal.SIGINT)


def scene(name):
    return os.path.join(SCENES, name)


def saved(name, scene, title="scene"):
    """The file of a scene or a study that is given as a dictionary, as YAML."""
    return write(os.path.join(WORK, name + ".yaml"), json.dumps({title: scene}))


def keys_of(file):
    """A scene's file as a dictionary of the package."""
    from epafi import Scene
    return Scene.read(file)


def changed(name, file, *changes):
    """A copy of a scene's file in which texts are others: (before, after)."""
    text = read(file)
    for before, after in changes:
        claim(before in text, "%s has %s" % (os.path.basename(file), before[:60]))
        text = text.replace(before, after)
    return write(os.path.join(WORK, name + os.path.splitext(file)[1]), text)


def fresh(name):
    """A folder that does not exist yet."""
    return absent(os.path.join(WORK, name))


def solved(name, file, *settings, expect=0):
    """Claims that a scene ends with an exit code; the folder, and what was printed."""
    folder = fresh(name)
    code, text = epafi("run", file, "--output", folder, settings=settings)
    claim(code == expect, "%s: exit code %d%s" % (
        name, code, "" if code == expect else " " + text[-400:]))
    return folder, text


def run(file, name, settings=(), expect=0):
    """Solves a scene; returns the rows of history.csv and of contact.csv."""
    folder, _ = solved(name, file, *settings, expect=expect)
    contact = os.path.exists(os.path.join(folder, "contact.csv"))
    return rows(folder, "history.csv"), rows(folder) if contact else []


def results(folder):
    """The tables of a folder by name; those of a path's steps as one, for what has not begun to
    wear is rounding."""
    found = {name: rows(folder, name) for name in (
        "steps.csv", "history.csv", "bodies.csv", "contact.csv", "boundary.csv")
        if os.path.exists(os.path.join(folder, name))}
    count = max((row["step"] for row in found.get("steps.csv", ())), default=0)
    of_steps = [row for k in range(1, round(count) + 1) for row in points(folder, k)
                if "contact.csv" in found]
    return {**found, "steps/*/contact.csv": of_steps} if of_steps else found


def goes_on(name, file, settings, before, within=1e-12):
    """Claims that a run which stops and goes on leaves the tables of one which does not.  It stops
    by further settings, is interrupted behind so many steps, or is killed as soon as something is so.
    Its folder, what both said."""
    (whole, told), part = solved(name + ", at once", file, *settings), fresh(name)
    if isinstance(before, int):
        interrupted(before, "run", file, *options(settings), "--output", part)
    elif callable(before):
        stopped(lambda: os.path.exists(os.path.join(part, "solution.hdf")) and before(part),
                "run", file, *options(settings), "--output", part)
    else:
        solved(name, file, *settings, *before)
    first = "steps.csv" if os.path.exists(os.path.join(whole, "steps.csv")) else "history.csv"
    known, all_of_it = (len(rows(folder, first)) for folder in (part, whole))
    code, text = epafi("run", file, "--restart", part, settings=settings)
    one, other = results(whole), results(part)
    off = max((*worst(one[table], other[table]), table) for table in one)
    claim(code == 0 and one.keys() == other.keys() and off[0] <= within and 0 < known < all_of_it,
          "%s: stopped behind %d of %d rows, gone on with to the same tables: %.1e of %s in %s%s" % (
              name, known, all_of_it, *off, text[-300:] if code else ""))
    return part, told, text


def rows(folder, file="contact.csv"):
    """Of a folder, or of one in WORK."""
    return table(os.path.join(WORK, folder, file))


def steps(folder):
    return rows(folder, "steps.csv")


def points(folder, step=None):
    """Of the contact at a step of a path, else at its end."""
    return rows(folder if step is None else os.path.join(folder, "steps", str(step)))


def vtu(file):
    """The arrays of a file for ParaView; claims that each is whole."""
    piece, arrays, missing = xml.parse(file).getroot().find(".//Piece"), {}, []
    for group in piece:
        of_points = group.tag in ("Points", "PointData")
        count = int(piece.get("NumberOfPoints" if of_points else "NumberOfCells"))
        for item in group:
            name, data = item.get("Name"), base64.b64decode(item.text)
            letter = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}[item.get("type")]
            size = (len(data) - 8) // struct.calcsize(letter)
            arrays[name] = struct.unpack("<%d%s" % (size, letter), data[8:])
            if struct.unpack("<Q", data[:8])[0] != len(data) - 8 or name != "connectivity" and (
                    size != count * int(item.get("NumberOfComponents"))):
                missing.append(name)
    claim(not missing and len(arrays["connectivity"]) == arrays["offsets"][-1],
          "%s: all arrays are whole %s" % (os.path.basename(file), missing))
    return arrays


def largest(values):
    return max(abs(value) for value in values)


def acting(folder):
    """For each row of bodies.csv what acts along x, along y and about the origin, part by part."""
    return [[[row[part + c] for part in ("load_", "contact_", "reaction_")] + [row[inside]]
             for c, inside in (("x", "body_force_x"), ("y", "body_force_y"),
                               ("moment", "body_moment"))] for row in rows(folder, "bodies.csv")]


def imbalance(folder, scale=0):
    """Of the worst body, relative to its largest resultant, at least a scale: all may cancel."""
    return max(largest(map(sum, parts)) / (max(scale, largest(sum(parts, []))) or 1)
               for parts in acting(folder))


def balanced(folder, scale=0, limit=1e-10):
    worst = imbalance(folder, scale)
    claim(worst < limit, "%s: every body balances, %.1e" % (os.path.basename(folder), worst))


def never_falls(folder):
    """Claims so of friction's work along a path, of all contacts and of each."""
    last = [row for row in steps(folder) if row["level"] == steps(folder)[-1]["level"]]
    for column in [c for c in last[0] if c.endswith("energy_dissipated")]:
        work = [0] + [row[column] for row in last]
        claim(all(b >= a for a, b in zip(work, work[1:])), "%s: %s never falls, %.3e" % (
            os.path.basename(folder), column, work[-1]))


def fails(sentence, words, *arguments, code=1, settings=()):
    """Claims that the program ends with a code and a message that has all these words."""
    got, text = epafi(*arguments, settings=settings)
    claim(got == code and all(word in text for word in words), "%s: exit %d and %s; got %d, %s" % (
        sentence, code, list(words), got, text.strip()[-200:]))


def refused(what, file, *words, settings=(), command="run"):
    """Claims that a scene ends with exit code 1 and a message with these words."""
    fails(what, words, command, file, *(["--output", fresh("bad")] if command == "run" else []),
          settings=settings)


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
