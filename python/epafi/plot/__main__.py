#!/usr/bin/python3
"""What `epafi plot` calls:  __main__.py DIR [--field NAME] [--quiet]"""
import argparse
import os
import sys

sys.dont_write_bytecode = True  # nothing beside what was installed
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [os.path.dirname(os.path.dirname(HERE)), *(p for p in sys.path if p != HERE)]
try:
    import matplotlib
except ImportError as error:
    sys.exit("epafi: plot: Python's matplotlib is missing (%s); install it with\n"
             "    apt-get install python3-matplotlib" % error)
matplotlib.use("Agg")
from epafi.plot import draw_folder, scene  # noqa: E402
from epafi.tables import Table  # noqa: E402


def main():
    arguments = argparse.ArgumentParser(prog="epafi plot")
    arguments.add_argument("folder")
    arguments.add_argument("--field")
    arguments.add_argument("--window", action="store_true")
    arguments.add_argument("--quiet", action="store_true")
    arguments.add_argument("--scene")
    arguments.add_argument("--title", default="")
    given = arguments.parse_args()
    if given.scene:
        try:
            scene.draw(Table(given.folder), given.title, given.scene)
        except (KeyError, ValueError, OSError) as error:
            sys.exit("epafi: check: '%s' cannot be drawn: %s" % (given.scene, error))
        print("picture " + given.scene)
        return
    if not os.path.isdir(given.folder):
        sys.exit("epafi: plot: there is no folder '%s'" % given.folder)
    try:
        names = draw_folder(given.folder, given.field, given.window)
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" % (given.folder, error))
    if not given.quiet:
        print("pictures %s: %s (.png and .svg)" % (given.folder, " ".join(names)))


if __name__ == "__main__":
    main()
