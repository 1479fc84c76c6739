"""Solving a scene, and what a run has left in its folder."""
from __future__ import annotations

import contextlib
import functools
import html
import os
import tempfile
import weakref
from typing import TYPE_CHECKING, Any, Callable, Collection, Mapping, Optional, Sequence

import numpy as np

from epafi.program import InputError, NotConverged, call
from epafi.scenes import Scene, printed
from epafi.tables import HISTORY, Table, counted, html_table, nearest, own, read, shown_step

if TYPE_CHECKING:
    import h5py
    from matplotlib.figure import Figure

Window = tuple[float, float, float, float]
CELLS = 240  # along the longer side of a window that is drawn


class Run:
    """The folder of a run; its files are read when they are first asked for.

    Columns are those of the files, as doc/columns.md lists them: `run.contact["pressure"]`.
    """

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = os.path.abspath(folder)
        if not os.path.isfile(os.path.join(self.folder, "history.csv")):
            raise InputError("'%s' holds no history.csv of a run" % self.folder)

    def _table(self, name: str) -> Table:
        table = read(self.folder, name)
        if table is None:
            raise InputError("the run in '%s' has written no %s" % (self.folder, name))
        return table

    @functools.cached_property
    def history(self) -> Table:
        """history.csv: a row per level; energies per unit of thickness [stress length^2], forces
        [stress length]."""
        return self._table("history.csv")

    @functools.cached_property
    def contact(self) -> Table:
        """contact.csv: along the contact of the last level (and step); stresses [stress], `u_n`,
        `u_t`, `gap` [length]."""
        return self._table("contact.csv")

    @functools.cached_property
    def boundary(self) -> Table:
        """boundary.csv: displacement [length] and traction [stress] on the whole boundary."""
        return self._table("boundary.csv")

    @functools.cached_property
    def bodies(self) -> Table:
        """bodies.csv: loads, contact forces, reactions of each body and level."""
        return self._table("bodies.csv")

    @functools.cached_property
    def steps(self) -> Table:
        """steps.csv: a row per level and step of a path."""
        if not os.path.isfile(os.path.join(self.folder, "steps.csv")):
            raise InputError("the run in '%s' has no steps.csv: its scene has no History" %
                             self.folder)
        return self._table("steps.csv")

    def step(self, k: int) -> Table:
        """contact.csv of step k = 1, 2, ... of the last level."""
        count = self._steps_of_last_level()
        if not isinstance(k, (int, np.integer)) or not 1 <= k <= count:
            raise InputError("there is no step %s; the path has steps 1 to %d" % (k, count))
        return self._table(os.path.join("steps", str(k), "contact.csv"))

    def _steps_of_last_level(self) -> int:
        return np.count_nonzero(self.steps["level"] == self.steps["level"][-1])

    def profiles(self, column: str, contact: Optional[str] = None) -> np.ndarray:
        """A column of contact.csv in each step of the last level's path, "worn_depth", "pressure", of
        one contact or of all: a row per step, as those of `steps` with that level, a column per
        point, as the rows of `contact`."""
        if contact is not None and contact not in self.contact["contact_name"]:
            raise _unknown("contact", contact, sorted(set(self.contact["contact_name"])))
        tables = [self.step(k) for k in range(1, self._steps_of_last_level() + 1)]
        return np.array([table[column] if contact is None else
                         table[column][table["contact_name"] == contact] for table in tables])

    @functools.cached_property
    def scene(self) -> Scene:
        """used.xml: the complete scene, defaults and versions included."""
        return Scene.read(own(self.folder, "used.xml"))

    @functools.cached_property
    def numbers(self) -> dict[str, Any]:
        """The complete scene with the number of each expression that is the same everywhere, at the
        end of the path; other expressions are texts."""
        return printed(own(self.folder, "used.xml"), "--numbers")[1]

    @property
    def converged(self) -> bool:
        return str(self.history["status"][-1]) == "converged"

    @property
    def no_result(self) -> str:
        """Why the last level is none: its error is estimated larger than the solution.  Else empty."""
        error = float(self.history["estimate_relative"][-1])
        if not error > 1 or self.scene["Adaptivity"]["Weights"] == "Paper":  # which tells no error
            return ""
        return "this is no result: the estimated error is %.3g %% of the energy norm" % (100 * error)

    def fields(self, points: Optional[Sequence[Sequence[float]] | np.ndarray] = None, *,
               grid: Optional[tuple[int, int]] = None, window: Optional[Window] = None,
               along: Optional[str] = None, depth: Optional[float] = None,
               step: Optional[int | str] = None) -> Table:
        """Displacement [length] and stress [stress] inside: at points, shape (n, 2), NaN where
        one is outside; on the middles of grid = (nx, ny) cells of a window (x0, y0, x1, y1), or
        of the bodies' box, that lie in a body; or along a boundary "body:boundary" at a depth.
        At a step of a path, at "all", else the last one.  Columns x, y, ux, uy, sxx, syy, sxy, szz (hoop of
        solids of revolution), von_mises, principal_1, principal_2."""
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "fields.csv")
            arguments = ["fields", self.folder, "--output", file, *_chosen(window, step)]
            if points is not None:
                places = np.atleast_2d(np.asarray(points, float))
                if places.ndim != 2 or places.shape[1] != 2:
                    raise InputError("points have the shape (n, 2), these have %s" % (
                        places.shape,))
                where = os.path.join(folder, "points.csv")
                np.savetxt(where, places, fmt="%.17g", delimiter=",", header="x,y", comments="")
                arguments += ["--points", where]
            if grid is not None:
                arguments += ["--grid", ",".join("%.12g" % count for count in np.ravel(grid))]
            if along is not None:
                arguments += ["--along", along]
            if depth is not None:
                arguments += ["--depth", repr(float(depth))]
            call(arguments)
            return Table(file)

    def intensities(self, step: Optional[int] = None) -> Table:
        """Where stresses of the last level are singular, at a step of a path, else at the last one,
        their exponents and intensities: a row per body, place and exponent; doc/columns.md lists the
        columns.  Stresses are K (2 pi r)^exponent on `side`, normal (tension positive) and shear."""
        from epafi.intensities import intensities

        return intensities(self, step)

    def fatigue(self, where: str | Sequence[Sequence[float]] | np.ndarray, *,
                body: Optional[str] = None, alpha: Optional[float] = None,
                first: Optional[float] = None, last: Optional[float] = None,
                depth: Optional[float] = None) -> Table:
        """Fatigue parameters over the steps of a path from t = first to last, its cycle; a row per
        point, with the columns of doc/columns.md.

        where   a contact's name: on the surfaces of both bodies, or of `body`; "body:boundary": along
                it, on the surface itself or `depth` below; or points
        alpha   Dang Van's weight of the hydrostatic stress, of the material; without it no Dang Van
        """
        from epafi.fatigue import fatigue

        return fatigue(self, where, body=body, alpha=alpha, first=first, last=last, depth=depth)

    @property
    def solution(self) -> h5py.File:
        """solution.hdf, open for reading; doc/solution-file.md says what is in it."""
        return opened(own(self.folder, "solution.hdf"))

    def plot(self, what: str = "contact", *, window: Optional[Window | str] = None,
             step: Optional[int] = None, axes: Any = None, **looks: Any) -> tuple[Figure, Any]:
        """One of the pictures of `epafi plot` ("contact", "deformed", "mesh", "path", ...) or a
        field inside the bodies ("von_mises", "syy", ...): its figure and its axes, an array where
        there are several.

        window  what of the plane a field, or "deformed", shows (x0, y0, x1, y1) [length]; "contact":
                around what touches
        step    of a path, for a field, "contact" or "deformed"; else that of the largest strain energy
        axes    as many as the picture has, to be drawn into
        looks   size=(width, height) in inches, dpi, font (points), title=False,
                units="mm,MPa" of length and stress
        """
        from epafi.plot.figures import Looks, Pictures, plt
        from epafi.plot.folder import NAMES, draw_field, draw_run
        from epafi.plot.inside import NAMES as FIELDS

        if what not in (*NAMES, *FIELDS):
            raise _unknown("picture", what, [*NAMES, *FIELDS])
        for name, value, others in (("window", window, ["deformed"]),
                                    ("step", step, ["contact", "deformed"])):
            if value is not None and what not in (*others, *FIELDS):
                raise InputError("the picture %r takes no %s; %s and fields do" % (
                    what, name, ", ".join(map(repr, others))))
        if step is not None:
            self.step(step)  # there is one
        window = self._window(window, step)
        pictures = Pictures(self.folder, Looks(**looks), window, only=what, axes=axes, step=step)
        with plt.rc_context(pictures.looks.style()), tempfile.TemporaryDirectory() as place:
            if what in FIELDS:
                step = shown_step(self.folder) if step is None else step
                draw_field(what, field_file(self.folder, place, window, step), pictures)
            else:
                draw_run(pictures)
        if not pictures.names:
            raise InputError("the run in '%s' has nothing for the picture %r" % (
                self.folder, what))
        return np.ravel(pictures.axes)[0].figure, pictures.axes

    def pictures(self, field: Optional[str] = None, *, window: Optional[Window | str] = None,
                 step: Optional[int] = None, pdf: bool = False, **looks: Any) -> list[str]:
        """Writes all that `epafi plot` writes into the run's folder, arguments as for `plot`; the
        files (PNG; SVG, with pdf PDF beside them)."""
        from epafi.plot import Looks, Pictures, draw_folder
        from epafi.plot.inside import NAMES as FIELDS

        if field is not None and field not in FIELDS:
            raise _unknown("field", field, FIELDS)
        endings = ("png", "svg", "pdf") if pdf else ("png", "svg")
        if step is not None:
            self.step(step)  # there is one
        window = self._window(window, step)
        pictures = Pictures(self.folder, Looks(endings=endings, **looks), window, step=step)
        if field is not None:
            field_file(self.folder, self.folder, window,
                       shown_step(self.folder) if step is None else step)
        return [os.path.join(self.folder, name + ".png")
                for name in draw_folder(pictures, field)]

    def _window(self, window: Optional[Window | str], step: Optional[int]) -> Optional[Window]:
        """Of what touches, if it is named so."""
        from epafi.plot.folder import contact_window

        if not isinstance(window, str):
            return window
        if window != "contact":
            raise InputError("window: %r is neither (x0, y0, x1, y1) nor 'contact'" % window)
        try:
            return contact_window(self.folder, step or shown_step(self.folder))
        except ValueError as error:
            raise InputError("window: %s" % error) from error

    def report(self) -> str:
        """Writes what `epafi report` writes, a page of HTML with all in it; its file."""
        call(["report", self.folder])
        return os.path.join(self.folder, "report.html")

    def __repr__(self) -> str:
        return "; ".join(filter(None, ["Run: %s, %s" % (
            counted(self.history.size, "level"), self.history["status"][-1]), self.no_result]))

    def _repr_html_(self) -> str:
        """For notebooks: the levels, and a picture where matplotlib is installed."""
        names = [name for name in HISTORY if name in self.history]
        what = "contact" if read(self.folder, "contact.csv") else "deformed"
        return "<p>%s</p>%s" % (html.escape(repr(self)), html_table(
            names, zip(*(self.history[name] for name in names)))) + pictured(
                lambda: self.plot(what)[0], what)


def opened(file: str) -> h5py.File:
    """A solution.hdf for reading.  InputError where anything in it stands for what is in another
    file, as HDF5's links and datasets may."""
    import h5py

    def check(group: h5py.Group) -> None:
        for name in group:
            link = group.get(name, getlink=True)
            item = group[name] if isinstance(link, h5py.HardLink) else None
            if isinstance(item, h5py.Group):
                check(item)
            elif item is None or isinstance(item, h5py.Dataset) and (
                    item.external or item.is_virtual):
                raise InputError("'%s': %s/%s is not in the file" % (file, group.name, name))

    content = h5py.File(file, "r")
    try:
        check(content)
    except InputError:
        content.close()
        raise
    return content


def pictured(draw: Callable[[], Figure], text: str) -> str:
    """A picture as HTML, where matplotlib is installed and there is something to draw."""
    try:
        from epafi.plot.report import embedded

        return embedded(draw(), text)
    except (ImportError, InputError):
        return ""


def field_file(folder: str, place: str, window: Optional[Window], step: Optional[int]) -> str:
    """Writes what a field of a run is drawn of: at a step, else at the last one; fields.vtu also beside
    the grid of a window."""
    file = own(place, "fields.vtu")
    call(["fields", folder, "--vtk", "--output", file, *_chosen(None, step)])
    if window is not None:
        x, y = window[2] - window[0], window[3] - window[1]
        file = own(place, "fields-window.csv")
        call(["fields", folder, "--grid", "%d,%d" % tuple(
            max(1, round(CELLS * side / max(x, y))) for side in (x, y)), "--output", file, *_chosen(window, step)])
    return file


def _unknown(kind: str, name: str, known: Collection[str]) -> InputError:
    return InputError("there is no %s %r%s known: %s" % (
        kind, name, nearest(name, known), ", ".join(known)))


def _chosen(window: Optional[Window], step: Optional[int | str]) -> list[str]:
    words = [] if step is None else ["--step", str(step)]
    return words if window is None else [
        *words, "--window=" + ",".join(repr(float(end)) for end in np.ravel(window))]


def scene_of(scene: Scene | Mapping[str, Any] | str | os.PathLike[str]) -> Scene:
    if not isinstance(scene, Mapping):
        return Scene.read(scene)
    return scene if isinstance(scene, Scene) else Scene(scene)


def run(scene: Scene | Mapping[str, Any] | str | os.PathLike[str],
        output: Optional[str | os.PathLike[str]] = None, *,
        set: Optional[Mapping[str, Any]] = None, threads: Optional[int] = None,
        restart: Optional[str | os.PathLike[str] | Run] = None, force: bool = False,
        progress: Optional[Callable[[str], Any]] = None) -> Run:
    """Solves a scene: a `Scene`, a dictionary, or a file.

    output    folder for the results; without it a temporary one that lives as long as the Run
    set       {"A->B->Key": value}, as `Scene.changed`
    threads   at most so many, as the work pays for; all cores without it
    restart   a run, or its folder, to go on from
    force     replace the files of an earlier run in `output`
    progress  is told each line that the program prints as it comes: print

    InputError, NumericalError; NotConverged, whose `run` has what was reached.
    """
    scene = scene_of(scene)
    if set:
        scene = scene.changed(set)
    with contextlib.ExitStack() as kept, tempfile.TemporaryDirectory(prefix="epafi-") as place:
        folder = os.fspath(output) if output is not None else os.path.join(
            kept.enter_context(tempfile.TemporaryDirectory(prefix="epafi-")), "run")
        file = os.path.join(place, "scene.yaml")
        scene.write(file)
        arguments = ["run", file, "--output", folder]
        if threads is not None:
            arguments += ["--threads", str(threads)]
        if restart is not None:
            arguments += ["--restart", restart.folder if isinstance(restart, Run)
                          else os.fspath(restart)]
        if force:
            arguments.append("--force")
        problem = None
        try:
            call(arguments, progress, file)
        except NotConverged as error:
            problem = error
        result = Run(folder)
        weakref.finalize(result, kept.pop_all().close)
    if problem:
        problem.run = result
        raise problem
    return result
