#!/usr/bin/python3
"""Pictures of a finished run or study.

    python3 plot DIR    convergence, time, contributions, mesh, contact, deformed of a run, path
                        and steps of one with a History;
                        convergence, time, contact_stress, work-precision, exponential,
                        effectivity, sweep of a study, and those of a run in each variant's
                        folder

A file here draws one kind of picture; each is written as .png and .svg.  Reads history.csv, contact.csv,
boundary.csv and study.csv; what a folder does not hold is left out.
"""
import argparse
import os
import sys

sys.dont_write_bytecode = True  # nothing beside what was installed
try:
    import contact
    import contributions
    import convergence
    import deformed
    import effectivity
    import exponential
    import inside
    import mesh
    import path
    import study_curves
    import sweep
    import work_precision
    from boundary import Boundary
    from figures import Pictures
    from tables import read, title_of
    from variants import curves_of
    import numpy as np
except ImportError as error:
    sys.exit("epafi: plot: Python's matplotlib is missing (%s); install it with\n"
             "    apt-get install python3-matplotlib" % error)


def plot_run(folder):
    title = title_of(folder)
    pictures = Pictures(folder)
    history = read(folder, "history.csv")
    if history:
        convergence.draw(history, "dof", "convergence", title + ": convergence", pictures)
        convergence.draw(history, "seconds_total", "time", title + ": error against time",
                         pictures)
        contributions.draw(history, title, pictures)
    outline = read(folder, "boundary.csv")
    if outline and "degree" in outline:
        elements = Boundary(outline)
        mesh.draw(elements, title, pictures)
        deformed.draw(elements, title, pictures)
    points = read(folder, "contact.csv")
    if points:
        contact.draw(points, title, pictures)
    steps = read(folder, "steps.csv")
    if steps:
        path.draw(folder, steps, title, pictures)
    return pictures.names


def plot_study(folder):
    study = read(folder, "study.csv")
    if study is None:
        return []
    title = title_of(folder)
    pictures = Pictures(folder)
    scenes = {scene: variants for scene, variants in curves_of(study).items() if variants}
    if scenes and not np.isfinite(study.numbers("sweep_value")).all():
        for name in study_curves.PICTURES:
            study_curves.draw(study, scenes, name, title, pictures)
        work_precision.draw(study, scenes, title, pictures)
        exponential.draw(study, scenes, title, pictures)
        effectivity.draw(study, scenes, title, pictures)
    sweep.draw(study, title, pictures)
    return pictures.names


def main():
    arguments = argparse.ArgumentParser(prog="epafi plot")
    arguments.add_argument("folder")
    arguments.add_argument("--field")
    arguments.add_argument("--quiet", action="store_true")
    given = arguments.parse_args()
    folder = given.folder
    if not os.path.isdir(folder):
        sys.exit("epafi: plot: there is no folder '%s'" % folder)
    names = plot_study(folder)
    for entry in sorted(os.listdir(folder)) if names else ():
        if os.path.isfile(os.path.join(folder, entry, "history.csv")):
            plot_run(os.path.join(folder, entry))
    names += [name for name in plot_run(folder) if name not in names]
    if given.field:
        pictures = Pictures(folder)
        inside.draw(inside.Inside(os.path.join(folder, "fields.vtu")), given.field,
                    title_of(folder), pictures)
        names += pictures.names
    if not names:
        sys.exit("epafi: plot: '%s' holds no history.csv, contact.csv, boundary.csv or "
                 "study.csv of a run or a study" % folder)
    if not given.quiet:
        print("pictures %s: %s (.png and .svg)" % (folder, " ".join(names)))


if __name__ == "__main__":
    try:
        main()
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" %
                 (sys.argv[1], error))
