"""What fails on a single rank: the memory of a thread that helps, and compressed operators, whose
place dense ones take.  The program is one that fails as EPAFI_FAULT says."""
import os
import sys

import ranks

ranks.EPAFI = sys.argv[5]
TRESCA = os.path.join(ranks.SCENES, "tresca.xml")


def run(name, extra, fault):
    return ranks.Run(1, ["run", TRESCA, "--output", ranks.fresh(name), *extra],
                     environment={"EPAFI_FAULT": fault})


def fails(done, words, sentence):
    ranks.claim(done.codes == [2] and len(done.messages) == 1 and words in done.messages[0],
                "%s: exit 2 and one message, here %s %s" % (sentence, done.codes, done.messages))


# What goes wrong on a thread that helps is told as if it had gone wrong on the first one.
LONG = ["--threads", "2", "--set", "Adaptivity->Strategy=None",
        "--set", "Adaptivity->Maximum Degrees of Freedom=10000",
        "--set", "Discretization->Stabilization->Form=Density",
        "--set", "Discretization->Elements per Edge={160, 160, 160, 160, 160, 160}"]
for method in ("Dense", "Compressed"):
    fails(run("heap", [*LONG, "--set", "Solver->Linear->Method=" + method], "0 0 heap"),
          "the memory does not suffice", "a thread without memory, " + method)

# A compressed level that breaks down, in its operators, its system, its solution or its
# estimate: dense matrices take its place, unless the scene asks for compressed ones by name.
LARGE = ["--set", "Discretization->Stabilization->Form=Density",
         "--set", "Discretization->Elements per Edge={24, 24, 6, 12, 6, 24}",
         "--set", "Discretization->Degree=9", "--set", "Adaptivity->Strategy=None",
         "--set", "Adaptivity->Maximum Degrees of Freedom=10000", "--set", "Output->Fields=false"]


def level(method, fault="", why="injected", extra=()):
    """A run of one level: exit codes, its row of history.csv without columns of time and memory,
    how often it was told why: other output may stand within its line."""
    done = run("instead", [*LARGE, *extra, "--set", "Solver->Linear->Method=" + method], fault)
    file = os.path.join(ranks.WORK, "instead", "history.csv")
    row = ranks.table(file)[-1] if os.path.exists(file) else {"operators": "none"}
    return done.codes, {key: value for key, value in row.items()
                        if not key.startswith(("seconds", "memory"))}, done.text.count(
                            "compressed operators failed, dense ones took their place: " + why)


_, dense, _ = level("Dense")
codes, row, warnings = level("Automatic")
ranks.claim((codes, row["operators"], warnings) == ([0], "compressed", 0),
            "without a fault Automatic compresses this level: %s" % row["operators"])
for phase in (1, 2, 3, 4):
    on = ", fault in phase %d" % phase
    codes, row, warnings = level("Automatic", "%d 0 error" % phase)
    ranks.claim(codes == [0] and row == {**dense, "operators": "dense instead"},
                "the row of dense operators, and it says so" + on)
    ranks.claim(warnings == 2, "told in the table and by a warning: %d" % warnings + on)

# The same where it is not solved within the steps that the scene allows, at once or on a path:
# neither are dense operators then, and the row is theirs.
SHORT = ["--set", "Solver->Maximum Iterations=1"]
PATH = ["--set", "History->Times={1}", "--set", "History->Minimum Step=1"]
for extra, why in ((SHORT, "scaled residual"), ([*SHORT, *PATH], "step 1 of the path ends")):
    _, dense, _ = level("Dense", extra=extra)
    ranks.claim(dense["status"] == "not converged", "one step is not enough: " + dense["status"])
    codes, row, warnings = level("Automatic", why=why, extra=extra)
    ranks.claim(codes == [3] and row == {**dense, "operators": "dense instead"},
                "the row of dense operators after a compressed level that is not solved, %s" % why)
    ranks.claim(warnings == 2, "told in the table and by a warning: %d, %s" % (warnings, why))
    codes, row, _ = level("Compressed", extra=extra)
    ranks.claim((codes, row["operators"]) == ([3], "compressed"), "compressed by name, %s" % why)
fails(run("named", [*LARGE, "--set", "Solver->Linear->Method=Compressed"], "2 0 error"),
      "injected fault", "compressed by name")
ranks.finish()
