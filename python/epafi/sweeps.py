"""One scene for many values of its parameters."""
from __future__ import annotations

import dataclasses
import itertools
import os
import re
from typing import Any, Callable, Mapping, Optional, Sequence

import numpy as np

from epafi.program import EpafiError, NotConverged
from epafi.runs import Run, run
from epafi.scenes import Scene


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
        self.shape = tuple(len(values) for values in self.parameters.values())

    def __len__(self) -> int:
        return len(self.cases)

    def __iter__(self):
        return iter(self.cases)

    def __getitem__(self, column: str) -> np.ndarray:
        """A column of history.csv on the last level of each case, in the shape of the
        parameters; NaN where a case failed."""
        return self.map(lambda result: result.history.numbers(column)[-1])

    def map(self, value: Callable[[Run], float]) -> np.ndarray:
        """value(run) of each case, in the shape of the parameters; NaN where one failed."""
        values = [value(case.run) if case.run is not None and case.error is None else np.nan
                  for case in self.cases]
        return np.array(values, float).reshape(self.shape)

    def plot(self, file: str | os.PathLike[str]) -> None:
        """Pressure and shear of all cases, one upon the other."""
        from epafi.plot.overlay import draw_file

        solved = [case for case in self.cases if case.run is not None and case.error is None]
        draw_file(os.fspath(file), [case.run.contact for case in solved if case.run],
                  [", ".join("%s = %s" % (path.rsplit("->", 1)[-1], value)
                             for path, value in case.settings.items()) for case in solved])


def sweep(scene: Scene | Mapping[str, Any] | str | os.PathLike[str],
          parameters: Mapping[str, Sequence[Any]],
          output: Optional[str | os.PathLike[str]] = None, *, threads: Optional[int] = None,
          force: bool = False, progress: Optional[Callable[[Case], Any]] = None) -> Sweep:
    """Solves a scene for all combinations of values: {"Constants->f": [0.1, 0.2, 0.4]}.

    output    a folder with a folder per case; without it temporary ones
    progress  is told each case when it is done

    A case that fails is kept with its error; the others go on.  InputError at once where a
    value cannot be.
    """
    if not isinstance(scene, Mapping):
        scene = Scene.read(scene)
    elif not isinstance(scene, Scene):
        scene = Scene(scene)
    combinations = [dict(zip(parameters, values))
                    for values in itertools.product(*parameters.values())]
    scenes = [scene.changed(settings) for settings in combinations]
    cases = []
    for number, (settings, own) in enumerate(zip(combinations, scenes), 1):
        case = Case(settings)
        words = "_".join(re.sub(r"[^\w.+-]+", "_", str(value)) for value in settings.values())
        folder = None if output is None else os.path.join(os.fspath(output),
                                                          "%02d_%s" % (number, words))
        try:
            case.run = run(own, folder, threads=threads, force=force)
        except NotConverged as error:
            case.run, case.error = error.run, error
        except EpafiError as error:
            case.error = error
        cases.append(case)
        if progress:
            progress(case)
    return Sweep(parameters, cases)
