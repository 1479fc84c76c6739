"""Epafi from Python: scenes as dictionaries, runs, results as arrays, studies over parameters,
pictures.

Everything is computed by the program `epafi`; this package writes its scenes, starts it and reads
its files.  It needs numpy, h5py for `Run.solution` and matplotlib for pictures.

    import epafi

    scene = epafi.Scene.read("coulomb.xml")
    run = epafi.run(scene.changed({"Discretization->Degree": 2}))
    print(run.history["force_normal"][-1], run.contact["pressure"].max())

Numbers are in the scene's own units.
"""
from epafi.program import (EpafiError, EpafiWarning, InputError, NotConverged, NumericalError,
                           version)
from epafi.runs import Run, run
from epafi.scenes import Scene
from epafi.sweeps import Case, Sweep, sweep
from epafi.tables import Table

__all__ = ["Case", "EpafiError", "EpafiWarning", "InputError", "NotConverged", "NumericalError", "Run", "Scene",
           "Sweep", "Table", "run", "sweep", "version"]
