"""One scene for many values of its parameters."""
from __future__ import annotations

import dataclasses
import itertools
import os
import re
import signal
import threading
import time
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor, as_completed
from typing import TYPE_CHECKING, Any, Callable, Mapping, Optional, Sequence

import numpy as np

from epafi.program import RUNNING, EpafiError, InputError, NotConverged
from epafi.runs import Run, pictured, run, scene_of
from epafi.scenes import Scene
from epafi.tables import (HISTORY, frame_of, html_table, nearest, read, text_table,
                          unknown_column)

if TYPE_CHECKING:
    import pandas
    from matplotlib.figure import Figure


@dataclasses.dataclass
class Case:
    """One combination of values: its run, or why there is none."""

    settings: dict[str, Any]
    run: Optional[Run] = None
    error: Optional[EpafiError] = None


class Sweep:
    """The cases of a sweep, in the order of itertools.product over the values."""

    def __init__(self, parameters: Mapping[str, Sequence[Any]], cases: Sequence[Case]) -> None:
        self.parameters = {path: list(values) for path, values in parameters.items()}
        self.cases = list(cases)
        self.names = _names(self.parameters)
        self.shape = tuple(len(values) for values in self.parameters.values())

    def __len__(self) -> int:
        return len(self.cases)

    def __iter__(self):
        return iter(self.cases)

    def __getitem__(self, column: str) -> np.ndarray:
        """A column of history.csv on the last level of each case, in the shape of the
        parameters; NaN where a case failed."""
        columns = dict.fromkeys(name for case in self.cases if case.run is not None
                                for name in case.run.history.columns)
        if columns and column not in columns:
            raise unknown_column(column, columns)
        return self.map(lambda result: result.history.numbers(column)[-1])

    def map(self, value: Callable[[Run], float]) -> np.ndarray:
        """value(run) of each case, in the shape of the parameters; NaN where one failed."""
        values = [value(case.run) if case.run is not None and case.error is None else np.nan
                  for case in self.cases]
        return np.array(values, float).reshape(self.shape)

    def rows(self) -> tuple[list[str], list[list[Any]]]:
        """The names of the columns of a table, and its rows, one for each case: its values, the
        last level in short, `status` or why it failed."""
        shown = HISTORY[1:-1]
        names = [*(_short(path, self.parameters) for path in self.parameters), *shown, "status"]
        rows = []
        for case, values in zip(self.cases, self.names):
            numbers = [case.run.history.numbers(name)[-1] if case.run else np.nan
                       for name in shown]
            status = ("not converged" if isinstance(case.error, NotConverged) else
                      "%s" % case.error if case.error else "converged")
            rows.append([*values, *numbers, status])
        return names, rows

    def frame(self) -> pandas.DataFrame:
        """The same as a frame of pandas, which has to be installed."""
        names, rows = self.rows()
        return frame_of({name: list(column) for name, column in zip(names, zip(*rows))})

    def __repr__(self) -> str:
        return text_table(*self.rows())

    def _repr_html_(self) -> str:
        """For notebooks: the table, and a picture where matplotlib is installed."""
        return html_table(*self.rows()) + pictured(lambda: self.plot()[0], "contact of all cases")

    def plot(self, file: Optional[str | os.PathLike[str]] = None, axes: Any = None,
             column: Optional[str] = None) -> tuple[Figure, Any]:
        """Pressure and shear of all cases, one upon the other; or a column of history.csv against the
        first parameter that has numbers, a curve for each value of the others: figure and axes, of
        its own or those given; written into a file if one is named."""
        from epafi.plot.overlay import curves_of, figure_of

        if column is not None:
            figure, drawn = curves_of(*self._curves(column), axes)
            if file is not None:
                figure.savefig(os.fspath(file), bbox_inches="tight")
            return figure, drawn

        solved = [(case.run.contact, values) for case, values in zip(self.cases, self.names)
                  if case.run is not None and case.error is None]
        if not solved:
            raise InputError("no case of the sweep is solved, there is nothing to draw")
        figure, drawn = figure_of(
            [contact for contact, _ in solved],
            [", ".join("%s = %s" % (_short(path, self.parameters), value)
                       for path, value in zip(self.parameters, values)) for _, values in solved],
            axes)
        if file is not None:
            figure.savefig(os.fspath(file), bbox_inches="tight")
        return figure, drawn


    def _curves(self, column: str) -> tuple[str, str, list[tuple[str, np.ndarray, np.ndarray]]]:
        """The labels of both axes; of each curve its label, its places in increasing order, and the
        column there."""
        numbers = [path for path, values in self.parameters.items()
                   if all(isinstance(value, (int, float, np.number)) for value in values)]
        if not numbers:
            raise InputError("no parameter of the sweep has numbers, which a curve wants")
        along = list(self.parameters).index(numbers[0])
        x = np.array(self.parameters[numbers[0]], float)
        rows = np.moveaxis(self[column], along, -1).reshape(-1, len(x))
        others = {path: values for path, values in self.parameters.items() if path != numbers[0]}
        labels = [", ".join("%s = %s" % (_short(path, self.parameters), value)
                            for path, value in zip(others, values)) for values in _names(others)]
        order = np.argsort(x)
        return _short(numbers[0], self.parameters), column.replace("_", " "), [
            (label, x[order], row[order]) for label, row in zip(labels, rows)]


def _names(parameters: Mapping[str, Sequence[Any]]) -> list[tuple[Any, ...]]:
    """How tables, legends and folders name the values of each case: arrays and lists by their
    numbers, #1, #2."""
    return list(itertools.product(*(
        [value if np.isscalar(value) or value is None else "#%d" % number
         for number, value in enumerate(values, 1)] for values in parameters.values())))


def _short(path: str, paths: Iterable[str]) -> str:
    """The key at the end of a path, or as much of it as tells it from the others."""
    words = path.split("->")
    for count in range(1, len(words)):
        short = "->".join(words[-count:])
        if sum(other.endswith(short) for other in paths) == 1:
            return short
    return path


def _check_constants(scene: Scene, paths: Iterable[str]) -> None:
    """A constant that no expression can know is a slip of the pen."""
    known = list(scene.get("Constants", {}))
    for path in paths:
        parent, _, name = path.rpartition("->")
        if parent == "Constants" and name not in known:
            raise InputError("%s: the scene has no such constant%s" % (path, nearest(name, known)))


def sweep(scene: Scene | Mapping[str, Any] | str | os.PathLike[str],
          parameters: Mapping[str, Sequence[Any]],
          output: Optional[str | os.PathLike[str]] = None, *, jobs: Optional[int] = None,
          threads: Optional[int] = None, force: bool = False,
          progress: Optional[Callable[[Case], Any]] = None) -> Sweep:
    """Solves a scene for all combinations of values: {"Constants->f": [0.1, 0.2, 0.4]}.

    output    a folder with a folder per case; without it temporary ones
    jobs      cases solved at a time; as many as there are cores without it
    threads   of each case; one where several are solved at a time, else as `run`
    progress  is told each case when it is done

    A case that fails is kept with its error; the others go on.  InputError at once where a
    value cannot be, or for a constant that the scene does not have.
    """
    scene = scene_of(scene)
    _check_constants(scene, parameters)
    for path, values in parameters.items():
        if isinstance(values, str) or not isinstance(values, Iterable):
            raise InputError("%s: is %r, wanted: a list of values" % (path, values))
    parameters = {path: list(values) for path, values in parameters.items()}
    for path, values in parameters.items():
        if not values:
            raise InputError("%s: has no values; a sweep wants one at least" % path)
    if jobs is not None and jobs < 1:
        raise InputError("jobs: is %r, wanted: at least 1" % jobs)
    combinations = [dict(zip(parameters, values))
                    for values in itertools.product(*parameters.values())]
    scenes = [scene.changed(settings) for settings in combinations]
    cases = [Case(settings) for settings in combinations]
    folders = [None if output is None else os.path.abspath(os.path.join(
        output, "%02d_%s" % (number, "_".join(re.sub(r"[^\w.+#-]+", "_", str(value))
                                              for value in values))))
               for number, values in enumerate(_names(parameters), 1)]
    for folder in folders:
        if folder and not force and read(folder, "history.csv"):
            raise InputError("the folder '%s' holds an earlier run; force=True replaces it" % folder)
    jobs = max(1, min(jobs or len(os.sched_getaffinity(0)), len(cases)))
    if jobs > 1 and threads is None:
        threads = 1

    def solve(number: int) -> Case:
        case = cases[number]
        try:
            case.run = run(scenes[number], folders[number], threads=threads, force=force)
        except NotConverged as error:
            case.run, case.error = error.run, error
        except EpafiError as error:
            case.error = error
        return case

    workers: list[int] = []
    with ThreadPoolExecutor(jobs, initializer=lambda: workers.append(
            threading.get_ident())) as pool:
        waiting = [pool.submit(solve, number) for number in range(len(cases))]
        try:
            for done in as_completed(waiting):
                case = done.result()
                if progress:
                    progress(case)
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            told = set()  # once each: a second signal ends a program at once
            while any(future.running() for future in waiting):
                for process in [RUNNING[worker] for worker in workers if worker in RUNNING]:
                    if process.pid not in told:
                        process.send_signal(signal.SIGINT)
                        told.add(process.pid)
                time.sleep(0.05)
            raise
    return Sweep(parameters, cases)
