"""Both paper scenes, uniform h and uniform p: 2 and 3 ranks write what 1 rank writes.

Numbers of history.csv agree to 1e-10 of the column's scale.  The scale of a column is the
largest number among those it is added to: all energies, all forces, all lengths.  The eta_*
are roots: their squares add up to the estimate's, so squares are what is compared.
"""
import os
import sys

import ranks

ASIDE = ("seconds_", "memory_")
FAMILIES = ("energy_", "_length", "eta_")
STRATEGIES = {"h": ["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=4"],
              "p": ["Adaptivity->Strategy=Uniform p", "Adaptivity->Maximum Levels=5"]}


def numbers(rows, name):
    """A column; words (status) as they are."""
    values = [row[name] for row in rows]
    if any(isinstance(value, str) for value in values):
        return [str(value) for value in values]
    return [value ** 2 for value in values] if name.startswith("eta_") else values


def family(rows, name):
    """The columns that share a scale."""
    forces = ("force_", "reaction_", "load_", "contact_x", "contact_y", "contact_moment")
    if name.startswith(forces):
        return [other for other in rows[0] if other.startswith(forces)]
    for part in FAMILIES:
        if part in name:
            return [other for other in rows[0] if part in other]
    return [name]


def difference(one, other, name):
    """Largest difference in a column relative to its scale; infinite if rows or words differ."""
    a, b = numbers(one, name), numbers(other, name)
    if len(a) != len(b):
        return float("inf")
    if isinstance(a[0], str):
        return 0 if a == b else float("inf")
    scale = max(abs(x) for column in family(one, name) for x in numbers(one, column))
    return max(abs(x - y) for x, y in zip(a, b)) / scale if scale > 0 else max(map(abs, b))


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
    for strategy in STRATEGIES:
        alone = solve(1, scene, strategy)
        for count in (2, 3):
            together = solve(count, scene, strategy)
            ranks.claim(list(alone[0]) == list(together[0]), "the columns are the same")
            worst = max((difference(alone, together, name), name)
                        for name in alone[0] if not name.startswith(ASIDE))
            ranks.claim(worst[0] <= 1e-10, "%s, uniform %s, %d ranks: %.1e, in %s"
                        % (scene, strategy, count, *worst))
            if scene == "tresca":
                krylov = solve(count, scene, strategy, "Belos")
                worst = max((difference(alone, krylov, name), name)
                            for name in alone[0] if not name.startswith(ASIDE))
                ranks.claim(worst[0] <= 1e-9, "V by Belos, uniform %s, %d ranks: %.1e, in %s"
                            % (strategy, count, *worst))
ranks.finish()
