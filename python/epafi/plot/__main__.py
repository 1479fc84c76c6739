#!/usr/bin/python3
"""What `epafi plot`, `epafi report` and `epafi check --plot` call."""
import argparse
import math
import os
import sys
import warnings

sys.dont_write_bytecode = True  # nothing beside what was installed
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [os.path.dirname(os.path.dirname(HERE)), *(p for p in sys.path if p != HERE)]
try:
    import matplotlib
except ImportError as error:
    sys.exit("epafi: plot: Python's matplotlib is missing (%s); install it with\n"
             "    apt-get install python3-matplotlib" % error)
matplotlib.use("Agg")
warnings.simplefilter("ignore", UserWarning)  # matplotlib's, of glyphs and of room
from epafi.plot import Looks, Pictures, draw_folder, scene  # noqa: E402
from epafi.plot.report import write_report  # noqa: E402
from epafi.program import EpafiError, InputError, call  # noqa: E402
from epafi.runs import field_file  # noqa: E402
from epafi.tables import Table, loaded_step, own  # noqa: E402


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


def window_of(text):
    try:
        window = tuple(float(end) for end in text.split(","))
        x0, y0, x1, y1 = window
        right = 0 < x1 - x0 < math.inf and 0 < y1 - y0 < math.inf
    except ValueError:
        right = False
    if not right:
        sys.exit("epafi: --window: '%s' is not X0,Y0,X1,Y1, two corners, the lower left one first" %
                 text)
    return window


def fields_of(given, window):
    """Writes what the field is drawn of; the step, or None for the last one, which is loaded."""
    every = given.step == "all"
    if every:
        call(["fields", given.folder, "--vtk", "--step", "all"])
    step = loaded_step(given.folder) if every or not given.step else given.step
    field_file(given.folder, given.folder, window, step)
    return step and int(step)


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
    for flag in ("--report", "--pdf", "--no-title"):
        arguments.add_argument(flag, action="store_true")
    given = arguments.parse_args()
    looks = looks_of(given)
    if given.scene:
        draw_scene(given, looks)
        return
    if not os.path.isdir(given.folder):
        sys.exit("epafi: plot: there is no folder '%s'" % given.folder)
    if given.step and not given.field:
        sys.exit("epafi: --step belongs to a --field")
    window = window_of(given.window) if given.window else None
    told, step = [], None
    try:
        report = given.output or own(given.folder, "report.html")
        if given.report:
            told = warnings_of(given.folder, report)
            given.field = given.field or "von_mises"
        if given.field:
            step = fields_of(given, window)
    except EpafiError as error:
        sys.exit("epafi: " + error.words)
    pictures = Pictures(given.folder, looks, window, given.field if given.step == "all" else None)
    try:
        names = draw_folder(pictures, given.field, step)
        if given.report:
            write_report(report, pictures, told)
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" % (given.folder, error))
    if given.report:
        print("report " + report)
    else:
        print("pictures %s: %s (%s)" % (given.folder, " ".join(names), " ".join(
            "." + ending for ending in looks.endings)))


if __name__ == "__main__":
    main()
