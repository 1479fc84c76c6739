"""All pictures of a folder.

history.csv, contact.csv, boundary.csv, steps.csv and study.csv are read; what a folder does not
hold is left out.
"""
from __future__ import annotations

import os
from typing import Optional

import numpy as np

from epafi.plot import contact, convergence, deformed, inside, mesh, path, study_curves, sweep
from epafi.plot.bodies import rigid_outlines
from epafi.plot.boundary import Boundary
from epafi.plot.figures import Pictures, plain, plt
from epafi.tables import Table, loaded_step, own, read, title_of

# Of a run; fields have the names in inside.NAMES.
NAMES = ("convergence", "time", "contributions", "mesh", "deformed", "contact", "path", "rigid",
         "steps")


def bodies_of(outline: Table) -> int:
    """How many bodies boundary.csv has: those that deform."""
    return len(set(outline["body"])) if "body" in outline else 1


def at_step(outline: Table, lines: dict[str, np.ndarray]) -> tuple[Table, np.ndarray]:
    """boundary.csv with what boundary.vtu of a step has at its points, and all displacements of
    that."""
    columns = dict(outline.columns)
    for name, (x, y) in (("displacement", ("ux", "uy")), ("traction", ("tx", "ty"))):
        columns[x], columns[y] = lines[name][:outline.size, :2].T
    return Table.of(columns), lines["displacement"]


def draw_run(pictures: Pictures) -> None:
    folder, step = pictures.folder, loaded_step(pictures.folder)
    title, at = plain(title_of(folder)), when(folder, step)
    history = read(folder, "history.csv")
    if history:
        convergence.draw(history, title, pictures)
    outline, points, moved = read(folder, "boundary.csv"), read(folder, "contact.csv"), None
    if step and outline:
        points = path.step_file(folder, step)
        outline, moved = at_step(outline, inside.arrays(own(
            folder, os.path.join("steps", str(step), "boundary.vtu"))))
    if outline and "degree" in outline:
        elements = Boundary(outline)
        if pictures.wants("mesh"):
            mesh.draw(elements, title, pictures)
        if pictures.wants("deformed"):
            deformed.draw(elements, rigid_outlines(folder, bodies_of(outline), moved), points,
                          title + at, pictures)
    if points and pictures.wants("contact"):
        contact.draw(points, title + at, pictures)
    steps = read(folder, "steps.csv")
    if steps:
        path.draw(folder, steps, title, pictures)


def draw_study(pictures: Pictures) -> None:
    study = read(pictures.folder, "study.csv")
    if study is None:
        return
    title = plain(title_of(pictures.folder))
    scenes = study_curves.curves_of(study)
    if scenes and not np.isfinite(study.numbers("sweep_value")).all():
        study_curves.draw(study, scenes, title, pictures)
    sweep.draw(study, title, pictures)


def draw_field(field: str, file: str, pictures: Pictures, when: str = "") -> None:
    """Of a file of epafi fields: a .vtu, or a .csv of a grid over a window; `when` ends the
    title."""
    outline = read(pictures.folder, "boundary.csv")
    rigid = rigid_outlines(pictures.folder, bodies_of(outline)) if outline else []
    title = plain(title_of(pictures.folder)) + when
    if file.endswith(".csv") and outline:
        inside.draw_window(Table(file), field, Boundary(outline).path(), rigid, title, pictures)
    else:
        inside.draw(inside.Inside(file), field, rigid, title, pictures)


def when(folder: str, step: Optional[int]) -> str:
    """What titles say of a step that is chosen, one of the last level's."""
    steps = None if step is None else read(folder, "steps.csv")
    if not steps:
        return ""
    return ", t = %g" % steps["t"][steps["level"] == steps["level"][-1]][step - 1]


def draw_folder(pictures: Pictures, field: Optional[str] = None,
                step: Optional[int] = None) -> list[str]:
    """Draws what the folder of a run or a study holds, and a field if one is named, at `step`, of
    fields-window.csv where there is a window, else of fields.vtu; the pictures' names, without
    endings.

    ValueError where there is nothing to draw.
    """
    folder = pictures.folder
    if not os.path.isdir(folder):
        raise ValueError("there is no folder '%s'" % folder)
    with plt.rc_context(pictures.looks.style()):
        draw_study(pictures)
        for entry in sorted(os.listdir(folder)) if pictures.names else ():
            if os.path.isfile(os.path.join(folder, entry, "history.csv")):
                draw_run(Pictures(own(folder, entry), pictures.looks))
        draw_run(pictures)
        if field:
            draw_field(field, own(folder, "fields-window.csv" if pictures.window else "fields.vtu"),
                       pictures, when(folder, step))
    if not pictures.names:
        raise ValueError("'%s' holds no history.csv, contact.csv, boundary.csv or study.csv of a "
                         "run or a study" % folder)
    return list(dict.fromkeys(pictures.names))
