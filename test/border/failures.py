"""Whatever goes wrong, all ranks leave within 5 s, counted on free cores, with one message and
the same code."""
import os

import ranks


def limit():
    """Seconds; what waits for a core in vain, and what sanitizers take, does not count."""
    return 5 * float(os.environ.get("EPAFI_TEST_PATIENCE", "1")) * max(1, os.getloadavg()[0] / os.cpu_count())


TRESCA = os.path.join(ranks.SCENES, "tresca.xml")
FAULTY = ranks.sys.argv[5]


def run(name, count, extra=(), scene=TRESCA, **options):
    """A run into a fresh folder, unless the arguments name one."""
    folder = [] if "--output" in extra else ["--output", ranks.fresh(name)]
    return ranks.Run(count, ["run", scene, *folder, *extra], **options)


def expect(done, code, words, sentence):
    """All ranks: this code, one message with these words, in time."""
    ranks.claim(done.codes and set(done.codes) == {code},
                "%s: every rank leaves with %d, here %s" % (sentence, code, done.codes))
    ranks.claim(len(done.messages) == 1 and words in done.messages[0],
                "%s: one message, here %s" % (sentence, done.messages))
    ranks.claim(done.seconds < limit(), "%s: %.1f s" % (sentence, done.seconds))


for count in (1, 2, 3):
    on = " on %d" % count
    expect(run("missing", count, scene="nowhere.xml"), 1, "nowhere.xml", "a missing scene" + on)
    expect(run("key", count, ["--set", "Solver->Tolerence=1"]), 1, "Tolerence",
           "an unknown key" + on)
    expect(run("unwritable", count, ["--output", "/proc/none"]), 1, "/proc/none",
           "a folder that cannot be made" + on)
    expect(run("gamma", count, ["--set", "Discretization->Stabilization->Gamma0=50"]), 2,
           "Gamma0", "an indefinite matrix" + on)
    expect(ranks.Run(count, ["rnu"]), 1, "rnu", "an unknown command" + on)
    done = run("threads", count, ["--threads", "2"])
    ranks.claim(done.codes == [0] * count and "2 threads" in done.text,
                "--threads is Epafi's own option" + on)
    done = ranks.Run(count, ["--help"])
    ranks.claim(done.codes == [0] * count and done.text.count("epafi check SCENE.xml") == 1,
                "--help is Epafi's and comes once" + on)
    plain = run("plain", count, scene="nowhere.xml", plain=True)
    ranks.claim(plain.code == 1, "mpirun itself returns the code" + on)

COMPRESSED = ["--set", "Solver->Linear->Method=Compressed",
              "--set", "Discretization->Stabilization->Form=Density",
              "--set", "Discretization->Elements per Edge={24, 24, 6, 12, 6, 24}"]

ranks.EPAFI = FAULTY
for count in (2, 3):
    for victim in range(count):
        for phase in range(8) if count == 2 else (0, 3, 5):
            fault = {"EPAFI_FAULT": "%d %d error" % (phase, victim)}
            expect(run("fault", count, environment=fault), 2, "injected fault",
                   "rank %d of %d in phase %d" % (victim, count, phase))
        for phase in range(1, 7) if count == 2 else (3,):
            fault = {"EPAFI_FAULT": "%d %d error" % (phase, victim)}
            expect(run("subtrees", count, COMPRESSED, environment=fault), 2, "injected fault",
                   "rank %d of %d in phase %d, compressed" % (victim, count, phase))
        fault = {"EPAFI_FAULT": "1 %d memory" % victim}
        expect(run("fault", count, environment=fault), 2, "memory",
               "rank %d of %d without memory" % (victim, count))
        # The others do not listen: the last resort is MPI_Abort.
        fault = {"EPAFI_FAULT": "2 %d busy" % victim}
        done = run("busy", count, environment=fault, plain=True)
        ranks.claim(done.code == 2, "rank %d of %d fails, the others are busy: mpirun returns 2, "
                    "here %s" % (victim, count, done.code))
        ranks.claim(len(done.messages) == 1 and "injected" in done.messages[0],
                    "and there is one message, here %s" % done.messages)
        ranks.claim(done.seconds < limit(), "and it takes %.1f s" % done.seconds)

# What goes wrong on a thread that helps is told as if it had gone wrong on the first one.
LONG = ["--threads", "2", "--set", "Adaptivity->Strategy=None",
        "--set", "Adaptivity->Maximum Degrees of Freedom=10000",
        "--set", "Discretization->Stabilization->Form=Density",
        "--set", "Discretization->Elements per Edge={160, 160, 160, 160, 160, 160}"]
for method in ("Dense", "Compressed"):
    expect(run("heap", 1, [*LONG, "--set", "Solver->Linear->Method=" + method],
               environment={"EPAFI_FAULT": "0 0 heap"}), 2, "the memory does not suffice",
           "a thread without memory, " + method)

# A compressed level that breaks down, in its operators, its system, its solution or its
# estimate: dense matrices take its place, unless the scene asks for compressed ones by name.
LARGE = [*COMPRESSED[2:], "--set", "Discretization->Degree=9", "--set", "Adaptivity->Strategy=None",
         "--set", "Adaptivity->Maximum Degrees of Freedom=10000", "--set", "Output->Fields=false"]


def level(method, fault="", why="injected", extra=()):
    """A run of one level: exit codes, its row of history.csv without columns of time and memory,
    how often it was told why: other output may stand within its line."""
    folder = ranks.fresh("instead")
    done = run("instead", 1, [*LARGE, *extra, "--set", "Solver->Linear->Method=" + method,
                              "--output", folder], environment={"EPAFI_FAULT": fault})
    file = os.path.join(folder, "history.csv")
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
expect(run("named", 1, [*LARGE, "--set", "Solver->Linear->Method=Compressed"],
           environment={"EPAFI_FAULT": "2 0 error"}), 2, "injected fault", "compressed by name")
ranks.finish()
