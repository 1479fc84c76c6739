"""All pictures of a folder.

history.csv, contact.csv, boundary.csv, steps.csv and study.csv are read; what a folder does not
hold is left out.
"""
import os

import numpy as np

from epafi.plot import (contact, contributions, convergence, deformed, effectivity, exponential,
                        inside, mesh, path, study_curves, sweep, work_precision)
from epafi.plot.bodies import rigid_outlines
from epafi.plot.boundary import Boundary
from epafi.plot.figures import STYLE, Pictures, plt
from epafi.plot.variants import curves_of
from epafi.tables import Table, read, title_of


def bodies_of(outline: Table) -> int:
    """How many bodies boundary.csv has: those that deform."""
    return len(set(outline["body"])) if "body" in outline else 1


def draw_run(folder: str) -> list[str]:
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
        deformed.draw(elements, rigid_outlines(folder, bodies_of(outline)), title, pictures)
    points = read(folder, "contact.csv")
    if points:
        contact.draw(points, title, pictures)
    steps = read(folder, "steps.csv")
    if steps:
        path.draw(folder, steps, title, pictures)
    return pictures.names


def draw_study(folder: str) -> list[str]:
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


def draw_folder(folder: str, field: str | None = None,
                window: bool = False) -> list[str]:
    """Draws what the folder of a run or a study holds, and a field if one is named, of
    fields-window.csv or of fields.vtu; the pictures' names, without .png and .svg.

    ValueError where there is nothing to draw.
    """
    if not os.path.isdir(folder):
        raise ValueError("there is no folder '%s'" % folder)
    with plt.rc_context(STYLE):
        names = draw_study(folder)
        for entry in sorted(os.listdir(folder)) if names else ():
            if os.path.isfile(os.path.join(folder, entry, "history.csv")):
                draw_run(os.path.join(folder, entry))
        names += [name for name in draw_run(folder) if name not in names]
        if field:
            pictures = Pictures(folder)
            outline = read(folder, "boundary.csv")
            rigid = rigid_outlines(folder, bodies_of(outline)) if outline else []
            if window:
                inside.draw_window(Table(os.path.join(folder, "fields-window.csv")), field, rigid,
                                   title_of(folder), pictures)
            else:
                inside.draw(inside.Inside(os.path.join(folder, "fields.vtu")), field, rigid,
                            title_of(folder), pictures)
            names += pictures.names
    if not names:
        raise ValueError("'%s' holds no history.csv, contact.csv, boundary.csv or study.csv of a "
                         "run or a study" % folder)
    return names
