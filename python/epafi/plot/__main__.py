#!/usr/bin/python3
"""What `epafi plot`, `epafi report` and `epafi check --plot` call."""
import argparse
import math
import os
import shlex
import sys
import warnings

sys.dont_write_bytecode = True  # nothing beside what was installed
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [os.path.dirname(os.path.dirname(HERE)), *(p for p in sys.path if p != HERE)]
try:
    import matplotlib
except ImportError as error:
    sys.exit("epafi: plot: Python's matplotlib is missing (%s); install it with\n"
             "    apt-get install python3-matplotlib\nor name a Python that has it in the variable "
             "EPAFI_PYTHON" % error)
matplotlib.use("Agg")
warnings.simplefilter("ignore", UserWarning)  # matplotlib's, of glyphs and of room
from epafi.plot import Looks, Pictures, draw_folder, scene  # noqa: E402
from epafi.plot.folder import (NAMES, STUDY, contact_window, has_steps,  # noqa: E402
                               unknown_step)
from epafi.plot.inside import NAMES as FIELDS  # noqa: E402
from epafi.plot.report import write_report  # noqa: E402
from epafi.program import EpafiError, InputError, call  # noqa: E402
from epafi.runs import field_file  # noqa: E402
from epafi.tables import Table, nearest, own, shown_step  # noqa: E402


def numbers_in(option, text, count, lowest=0.0, highest=float("inf")):
    """So many numbers between the bounds, of an option's text."""
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError:
        numbers = []
    if len(numbers) != count or not all(lowest < number <= highest for number in numbers):
        sys.exit("epafi: plot: %s: '%s' is not %s, above %g and at most %g" % (
            option, text, "a number" if count == 1 else "%d numbers" % count, lowest, highest))
    return numbers


def looks_of(given):
    looks = {}
    if given.size:
        looks["size"] = tuple(numbers_in("--size", given.size, 2, 0.5, 100))
    if given.dpi:
        looks["dpi"], = numbers_in("--dpi", given.dpi, 1, 10, 1200)
    if given.font:
        looks["font"], = numbers_in("--font", given.font, 1, 1, 100)
    try:
        return Looks(title=not given.no_title, units=given.units or None,
                     endings=("png", "svg", "pdf") if given.pdf else ("png", "svg"), **looks)
    except InputError as error:
        sys.exit("epafi: plot: --%s" % error)


def window_of(text, folder, step):
    if text == "contact":
        return contact_window(folder, step or shown_step(folder))
    try:
        window = tuple(float(end) for end in text.split(","))
        x0, y0, x1, y1 = window
        right = 0 < x1 - x0 < math.inf and 0 < y1 - y0 < math.inf
    except ValueError:
        right = False
    if not right:
        sys.exit("epafi: --window: '%s' is not X0,Y0,X1,Y1, two corners, the lower left one first, "
                 "nor 'contact'" % text)
    return window


def chosen_of(given):
    """The pictures that are asked for; None: those that are usual.  A field may be one of them."""
    names = list(given.picture)
    for name in names:
        known = ["all", *NAMES, "movie", *FIELDS, *STUDY]
        if name not in known:
            sys.exit("epafi: --picture: there is no '%s'%s known: %s" % (
                name, nearest(name, known), ", ".join(known)))
    given.field = given.field or next((name for name in names if name in FIELDS), "")
    if "all" in names:
        return {*NAMES, "movie", *STUDY}
    return set(names) if names else None


def step_of(given):
    """--step as a number; None: no step is named."""
    if not given.step:
        return None
    if given.step == "all":
        if not given.field:
            sys.exit("epafi: --step all belongs to a --field, which colours the movie")
        return None
    try:
        step = int(given.step)
    except ValueError:
        step = 0
    if step < 1:
        sys.exit("epafi: --step: '%s' is not a whole number >= 1, nor 'all'" % given.step)
    if has_steps(given.folder) and unknown_step(given.folder, step):
        sys.exit("epafi: --step %d: %s" % (step, unknown_step(given.folder, step)))
    return step


def fields_of(given, window, step):
    """Writes what the field is drawn of, at a step of a path, or of all; the file."""
    if given.step == "all":
        call(["fields", given.folder, "--vtk", "--step", "all"])
    return field_file(given.folder, given.folder, window, step or shown_step(given.folder))


def warnings_of(folder, report):
    """Draws the scene for a report; the program's warnings about it."""
    if not os.path.isfile(os.path.join(folder, "history.csv")):
        raise InputError("report: '%s' holds no history.csv; the folder of a finished run is needed" %
                         folder)
    place = os.path.dirname(report)
    if report == "-":
        raise InputError("--output: a report is a file; '-' is none")
    if place and not os.path.isdir(place):
        raise InputError("--output: there is no folder '%s'" % place)
    printed = call(["check", own(folder, "used.xml"), "--plot", own(folder, "scene.png")])
    return [line.removeprefix("warning: ") for line in printed.splitlines()
            if line.startswith("warning: ")]


def command_of(given):
    """The command that writes a report."""
    words = ["epafi", "report", given.folder]
    for option in ("field", "window", "step", "size", "dpi", "font", "units", "output"):
        if getattr(given, option) and (option, given.field) != ("field", "von_mises"):
            words += ["--%s=%s" % (option, getattr(given, option))]
    return shlex.join(words + ["--no-title"] * given.no_title + ["--pdf"] * given.pdf)


def draw_scene(given, looks):
    try:
        scene.draw(Table(given.folder), given.title, given.scene, looks)
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: check: '%s' cannot be drawn: %s" % (given.scene, error))
    print("picture " + given.scene)


def main():
    arguments = argparse.ArgumentParser(prog="epafi plot")
    arguments.add_argument("folder")
    for option in ("--field", "--window", "--step", "--size", "--dpi", "--font", "--units",
                   "--scene", "--title", "--output"):
        arguments.add_argument(option, default="")
    for option in ("--picture", "--column"):
        arguments.add_argument(option, action="append", default=[])
    for flag in ("--report", "--pdf", "--no-title"):
        arguments.add_argument(flag, action="store_true")
    given = arguments.parse_args()
    looks = looks_of(given)
    if given.scene:
        draw_scene(given, looks)
        return
    if not os.path.isdir(given.folder):
        sys.exit("epafi: plot: there is no folder '%s'" % given.folder)
    given.picture += ["all"] if given.report else []
    chosen = chosen_of(given)
    told = []
    try:
        step = step_of(given)
        window = window_of(given.window, given.folder, step) if given.window else None
        report = given.output or own(given.folder, "report.html")
        if given.report:
            told = warnings_of(given.folder, report)
            given.field = given.field or "von_mises"
        if given.field:
            fields = fields_of(given, window, step)
    except EpafiError as error:
        sys.exit("epafi: " + error.words)
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: %s" % error)
    pictures = Pictures(given.folder, looks, window, given.field if given.step == "all" else None,
                        chosen=chosen, step=step)
    try:
        names = draw_folder(pictures, given.field, given.column)
        if given.report:
            write_report(report, pictures, fields, told, command_of(given))
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" % (given.folder, error))
    if given.report:
        print("report " + report)
    else:
        print("pictures %s: %s (%s)%s" % (given.folder, " ".join(names), " ".join(
            "." + ending for ending in looks.endings),
            "" if chosen else "; more by --picture NAME, as mesh or von_mises, or all"))


if __name__ == "__main__":
    main()
