"""Both paper scenes, uniform h and uniform p, and scenes of several bodies as they are refined: 2
and 3 ranks write what 1 rank writes.

Numbers of history.csv agree to 1e-10 of the column's scale.
"""
import os
import sys

import ranks
from scales import worst

STRATEGIES = {"h": ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=4"],
              "p": ["Adaptivity->Strategy=Uniform p", "Adaptivity->Maximum Levels=5"],
              "graded": ["Adaptivity->Maximum Levels=12"]}


def solve(count, scene, strategy, method="Dense"):
    """history.csv of a run."""
    folder = ranks.fresh("%s-%s-%d" % (scene, strategy, count))
    arguments = ["run", os.path.join(ranks.SCENES, scene + ".xml"), "--output", folder]
    for setting in STRATEGIES[strategy] + ["Solver->Linear->Method=" + method]:
        arguments += ["--set", setting]
    run = ranks.Run(count, arguments)
    if run.codes != [0] * count:
        sys.exit("%s on %d ranks: %s\n%s" % (scene, count, run.codes, run.text))
    ranks.claim(run.text.count("ended ") == 1, "one rank speaks: %s on %d" % (scene, count))
    return ranks.table(os.path.join(folder, "history.csv"))


for scene in ("tresca", "coulomb"):
    for strategy in ("h", "p"):
        alone = solve(1, scene, strategy)
        for count in (2, 3):
            together = solve(count, scene, strategy)
            ranks.claim(list(alone[0]) == list(together[0]), "the columns are the same")
            apart = worst(alone, together)
            ranks.claim(apart[0] <= 1e-10, "%s, uniform %s, %d ranks: %.1e, in %s"
                        % (scene, strategy, count, *apart))
            if scene == "tresca":
                krylov = solve(count, scene, strategy, "Belos")
                apart = worst(alone, krylov)
                ranks.claim(apart[0] <= 1e-9, "V by Belos, uniform %s, %d ranks: %.1e, in %s"
                            % (strategy, count, *apart))
for scene in ("dovetail", "cylinder-on-block"):
    alone = solve(1, scene, "graded")
    for count in (2, 3):
        apart = worst(alone, solve(count, scene, "graded"))
        ranks.claim(apart[0] <= 1e-10, "%s, 12 levels, %d ranks: %.1e, in %s" % (
            scene, count, *apart))
ranks.finish()
