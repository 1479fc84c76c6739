"""Both paper scenes, uniform h and uniform p, and scenes of several bodies as they are refined: 2
and 3 ranks write what 1 rank writes, with dense operators, which every rank has, and with
compressed ones, of which it has a part.

Numbers of history.csv agree to 1e-10 of the column's scale.
"""
import os
import sys

import ranks
from scales import worst

STRATEGIES = {"h": ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=3"],
              "p": ["Adaptivity->Strategy=Uniform p", "Adaptivity->Maximum Levels=4"],
              "graded": ["Adaptivity->Maximum Levels=9"]}


# Compressed operators want one of the forms that go with them.
METHODS = {"Dense": [], "Compressed": ["Discretization->Stabilization->Form=Density"]}


def solve(count, scene, strategy, method="Dense"):
    """history.csv of a run."""
    folder, text = ranks.solved(count, "%s-%s-%s" % (scene, strategy, method), scene, [
        *STRATEGIES[strategy], *METHODS.get(method, []), "Solver->Linear->Method=" + method])
    ranks.claim(text.count("ended ") == 1, "one rank speaks: %s on %d" % (scene, count))
    return ranks.table(os.path.join(folder, "history.csv"))


# Both numbers of ranks with either method: by turns here, each with each by "all".  Ranks share
# compressed operators and compute dense ones each by itself.
EVERY = sys.argv[6:] == ["all"]
CASES = [(scene, strategy) for scene in ("tresca", "coulomb") for strategy in ("h", "p")]
CASES += [("dovetail", "graded"), ("cylinder-on-block", "graded")]
for k, (scene, strategy) in enumerate(CASES):
    for method in METHODS:
        alone = solve(1, scene, strategy, method)
        for count in (2, 3) if EVERY else (2 + (k + (method == "Dense")) % 2,):
            together = solve(count, scene, strategy, method)
            ranks.claim(list(alone[0]) == list(together[0]), "the columns are the same")
            apart = worst(alone, together)
            ranks.claim(apart[0] <= 1e-10, "%s, %s, %s, %d ranks: %.1e, in %s"
                        % (scene, strategy, method, count, *apart))
            if scene == "tresca" and method == "Dense":
                krylov = solve(count, scene, strategy, "Belos")
                apart = worst(alone, krylov)
                ranks.claim(apart[0] <= 1e-9, "V by Belos, uniform %s, %d ranks: %.1e, in %s"
                            % (strategy, count, *apart))
ranks.finish()
