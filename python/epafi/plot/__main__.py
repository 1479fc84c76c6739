#!/usr/bin/python3
"""What `epafi plot`, `epafi report` and `epafi check --plot` call."""
import argparse
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
from epafi.program import InputError  # noqa: E402
from epafi.tables import Table  # noqa: E402


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


def main():
    arguments = argparse.ArgumentParser(prog="epafi plot")
    arguments.add_argument("folder")
    for option in ("--field", "--window", "--size", "--dpi", "--font", "--units", "--scene",
                   "--title", "--report"):
        arguments.add_argument(option, default="")
    arguments.add_argument("--step", type=int)
    arguments.add_argument("--warning", action="append", default=[])
    for flag in ("--quiet", "--pdf", "--no-title", "--film"):
        arguments.add_argument(flag, action="store_true")
    given = arguments.parse_args()
    looks = looks_of(given)
    if given.scene:
        try:
            scene.draw(Table(given.folder), given.title, given.scene, looks)
        except (KeyError, ValueError, OSError) as error:
            sys.exit("epafi: check: '%s' cannot be drawn: %s" % (given.scene, error))
        if not given.quiet:
            print("picture " + given.scene)
        return
    if not os.path.isdir(given.folder):
        sys.exit("epafi: plot: there is no folder '%s'" % given.folder)
    window = tuple(float(end) for end in given.window.split(",")) if given.window else None
    pictures = Pictures(given.folder, looks, window, given.field if given.film else None)
    try:
        names = draw_folder(pictures, given.field, given.step)
        if given.report:
            write_report(given.report, pictures, given.warning)
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" % (given.folder, error))
    if given.report:
        print("report " + given.report)
    elif not given.quiet:
        print("pictures %s: %s (%s)" % (given.folder, " ".join(names), " ".join(
            "." + ending for ending in looks.endings)))


if __name__ == "__main__":
    main()
