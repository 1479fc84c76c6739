"""Whatever goes wrong, all ranks leave within 5 s, counted on free cores, with one message and
the same code."""
import os
import sys

import ranks


TRESCA = os.path.join(ranks.SCENES, "tresca.xml")
FAULTY = sys.argv[5]


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
    ranks.claim(done.seconds < 5 * ranks.patience(), "%s: %.1f s" % (sentence, done.seconds))


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
# Each phase and each rank fails, by turns; with "all", every rank in every phase.
EVERY = sys.argv[6:] == ["all"]
PHASES = {2: range(8), 3: (0, 3, 5)}
COMPRESSED_PHASES = {2: range(1, 7), 3: (3,)}


def turns(count, phases):
    """(phase, the rank that fails in it)."""
    return [(phase, victim) for k, phase in enumerate(phases) for victim in range(count)
            if EVERY or victim == (count - 1 - k) % count]


for count in (2, 3):
    for phase, victim in turns(count, PHASES[count]):
        fault = {"EPAFI_FAULT": "%d %d error" % (phase, victim)}
        expect(run("fault", count, environment=fault), 2, "injected fault",
               "rank %d of %d in phase %d" % (victim, count, phase))
    for phase, victim in turns(count, COMPRESSED_PHASES[count]):
        fault = {"EPAFI_FAULT": "%d %d error" % (phase, victim)}
        expect(run("subtrees", count, COMPRESSED, environment=fault), 2, "injected fault",
               "rank %d of %d in phase %d, compressed" % (victim, count, phase))
    for victim in range(count) if EVERY else (3 - count, 2)[:count - 1]:
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
        ranks.claim(done.seconds < 5 * ranks.patience(), "and it takes %.1f s" % done.seconds)
ranks.finish()
