"""All pictures of a folder.

history.csv, contact.csv, boundary.csv, steps.csv and study.csv are read; what a folder does not
hold is left out.
"""
from __future__ import annotations

import os
from typing import Optional, Sequence

import numpy as np

from epafi.plot import contact, convergence, deformed, inside, mesh, path, study_curves, sweep
from epafi.plot.bodies import rigid_outlines
from epafi.plot.boundary import Boundary
from epafi.plot.figures import Pictures, plain, plt
from epafi.plot.layout import samples_at
from epafi.tables import Table, own, read, shown_step, title_of

# Of a run, those that are drawn if none is named; fields have the names in inside.NAMES.
USUAL = ("contact", "deformed", "path", "convergence")
NAMES = (*USUAL, "steps", "slip", "rigid", "mesh", "contributions", "time")
# Of a study; several of one kind have numbers behind the name.
STUDY = (*study_curves.PICTURES, "work-precision", "exponential", "effectivity", "sweep",
         "sweep_forces", "sweep_contact", "sweep_column")


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
    folder = pictures.folder
    step = pictures.step or shown_step(folder)
    title, at = plain(title_of(folder)), when(folder, step)
    history = read(folder, "history.csv")
    if history:
        convergence.draw(history, title, pictures)
    outline, points, moved = read(folder, "boundary.csv"), samples_at(folder, step), None
    if step and outline and pictures.wants("deformed"):
        outline, moved = at_step(outline, inside.arrays(own(
            folder, os.path.join("steps", str(step), "boundary.vtu"))))
    if outline and "degree" in outline and (pictures.wants("mesh") or pictures.wants("deformed")):
        elements = Boundary(outline)
        if pictures.wants("mesh"):
            mesh.draw(elements, title, pictures)
        if pictures.wants("deformed"):
            deformed.draw(elements, rigid_outlines(folder, bodies_of(outline), moved), points,
                          title + at, pictures)
    steps = read(folder, "steps.csv")
    if points and pictures.wants("contact"):
        touching = pressed_step(steps) if steps and not pictures.step else None
        if touching and not (points["contact"] > 0).any():  # of what opens under the largest load
            points, at = samples_at(folder, touching) or points, when(folder, touching)
        contact.draw(points, title + at, pictures)
    if steps:
        path.draw(folder, steps, title, pictures)


def pressed_step(steps: Table) -> Optional[int]:
    """The step of the last level in which contacts press most."""
    rows = path.solved_steps(steps)
    forces = [rows[name] for name in rows if name.endswith(".force_normal")]
    return int(rows["step"][np.argmax(sum(forces))]) if forces and rows["step"].size else None


def draw_study(pictures: Pictures, columns: Sequence[str]) -> None:
    study = read(pictures.folder, "study.csv")
    if study is None:
        return
    title = plain(title_of(pictures.folder))
    scenes = study_curves.curves_of(study)
    if scenes and not np.isfinite(study.numbers("sweep_value")).all():
        study_curves.draw(study, scenes, title, pictures)
    sweep.draw(study, title, pictures, columns)


def draw_field(field: str, file: str, pictures: Pictures) -> None:
    """Of a file of epafi fields: a .vtu, or a .csv of a grid over a window."""
    step = pictures.step or shown_step(pictures.folder)
    everything = inside.known(field, file, pictures.folder, step, pictures.window)[1]
    outline = read(pictures.folder, "boundary.csv")
    rigid = rigid_outlines(pictures.folder, bodies_of(outline)) if outline else []
    title = plain(title_of(pictures.folder)) + when(pictures.folder, step)
    if file.endswith(".csv") and outline:
        inside.draw_window(Table(file), field, everything, Boundary(outline).path(), rigid, title,
                           pictures)
    else:
        inside.draw(inside.Inside(file), field, everything, rigid, title, pictures)


def when(folder: str, step: Optional[int]) -> str:
    """What titles say of a step of a path, one of the last level's; None: the last one."""
    steps, history = read(folder, "steps.csv"), read(folder, "history.csv")
    at, status = "", history["status"][-1] if history else "converged"
    if steps:
        row = np.flatnonzero(steps["level"] == steps["level"][-1])[(step or 0) - 1]
        at, status = ", t = %g" % steps["t"][row], steps["status"][row]
    return at + ", not solved" * bool(status != "converged")


def has_steps(folder: str) -> bool:
    return read(folder, "steps.csv") is not None


def unknown_step(folder: str, step: int) -> str:
    """Why there is no such step on the last level; empty: there is."""
    steps = read(folder, "steps.csv")
    if not steps:
        return "the run in '%s' has no History, and no steps; leave it out" % folder
    count = np.count_nonzero(steps["level"] == steps["level"][-1])
    return "" if step <= count else "the path in '%s' has %d step%s" % (
        folder, count, "s" * (count > 1))


def contact_window(folder: str, step: Optional[int]) -> tuple[float, float, float, float]:
    """Two corners around what touches at a step, half as much again on all sides.

    ValueError where nothing does.
    """
    points = samples_at(folder, step)
    closed = points["contact"] > 0 if points else np.zeros(0, bool)
    if not closed.any():
        raise ValueError("nothing is in contact%s; give --window X0,Y0,X1,Y1" % when(folder, step))
    x, y = points["x"], points["y"]
    size = max(np.ptp(x[closed]), np.ptp(y[closed]), 0.02 * max(np.ptp(x), np.ptp(y)))
    middle = [(values[closed].min() + values[closed].max()) / 2 for values in (x, y)]
    return (middle[0] - size, middle[1] - size, middle[0] + size, middle[1] + size)


def draw_folder(pictures: Pictures, field: Optional[str] = None,
                columns: Sequence[str] = ()) -> list[str]:
    """Draws what the folder of a run or a study holds, and a field if one is named, of
    fields-window.csv where there is a window, else of fields.vtu; of a study's sweep columns of
    study.csv; the pictures' names, without endings.

    ValueError where there is nothing to draw.
    """
    folder = pictures.folder
    if not os.path.isdir(folder):
        raise ValueError("there is no folder '%s'" % folder)
    with plt.rc_context(pictures.looks.style()):
        draw_study(pictures, columns)
        if pictures.chosen is None:
            pictures.chosen = USUAL if pictures.film is None else (*USUAL, "movie")
        if field:
            pictures.chosen = {*pictures.chosen, field}
        for entry in sorted(os.listdir(folder)) if pictures.names else ():
            if os.path.isfile(os.path.join(folder, entry, "history.csv")):
                draw_run(Pictures(own(folder, entry), pictures.looks, chosen=pictures.chosen))
        draw_run(pictures)
        if field:
            draw_field(field, own(folder, "fields-window.csv" if pictures.window else "fields.vtu"),
                       pictures)
    if not pictures.names and pictures.chosen is not None and os.path.isfile(
            os.path.join(folder, "history.csv")):
        raise ValueError("there is nothing for %s" % ", ".join(sorted(pictures.chosen)))
    if not pictures.names:
        raise ValueError("'%s' holds no history.csv, contact.csv, boundary.csv or study.csv of a "
                         "run or a study" % folder)
    return list(dict.fromkeys(pictures.names))
