"""Compressed operators on 2 and 3 ranks write what 1 rank writes, to 1e-9: subtrees on ranks.

Trees of several levels: Tresca and Coulomb, without stabilisation and by the density, two
bodies, arcs, a rigid body on a load path, refined levels from warm starts."""
import os

import ranks
from scales import worst

NONE = ["Discretization->Stabilization->Form=None", "Discretization->Multiplier=Biorthogonal"]
DENSITY = ["Discretization->Stabilization->Form=Density"]
UNIFORM = ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Degrees of Freedom=100000"]


def edges(*counts):
    return "Discretization->Elements per Edge={%s}" % ", ".join(map(str, counts))


CASES = {
    "tresca": NONE + UNIFORM + ["Adaptivity->Maximum Levels=2", edges(32, 32, 8, 16, 8, 32)],
    "coulomb": DENSITY + UNIFORM + ["Adaptivity->Maximum Levels=1", edges(40, 40, 40, 40)],
    "two-blocks": DENSITY + UNIFORM + ["Adaptivity->Maximum Levels=3"],
    "press-fit": DENSITY + ["Adaptivity->Maximum Levels=3"],
    "tilting-punch": ["Adaptivity->Maximum Levels=1"],
}


def solve(count, scene):
    """The tables of a run."""
    folder, _ = ranks.solved(count, scene, scene, CASES[scene] + ["Solver->Linear->Method=Compressed"])
    names = ["history.csv", "contact.csv", "steps.csv"]
    return {name: ranks.table(os.path.join(folder, name)) for name in names
            if os.path.exists(os.path.join(folder, name))}


for scene in CASES:
    alone = solve(1, scene)
    for count in (2, 3) if scene in ("tresca", "two-blocks", "tilting-punch") else (2,):
        together = solve(count, scene)
        for name, table in alone.items():
            apart = worst(table, together[name])
            ranks.claim(apart[0] <= 1e-9, "%s on %d ranks, %s: %.1e, in %s"
                        % (scene, count, name, *apart))
ranks.finish()
