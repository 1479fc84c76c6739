"""The program itself: exit codes, folders, options, signals."""
import os
import pty
import shutil
import signal
import subprocess
import time

import h5py

from runs import (EPAFI, WORK, claim, epafi, fails, finish, fresh, levels, options, run, scene,
                  stopped, table, write)

TRESCA = scene("tresca.xml")
ONE = ["--set", "Adaptivity->Strategy=None"]


fails("an unknown command names the nearest", ["'run'"], "runn")
fails("an unknown option names the nearest", ["'--output'"], "run", TRESCA, "--outptu", "x")
fails("no command shows the usage", ["epafi run"])
fails("no scene", ["scene"], "run")
fails("two scenes", ["one"], "run", TRESCA, TRESCA)
fails("threads are whole numbers", ["--threads"], "run", TRESCA, "--threads", "2x")
for command in ("run", "fields"):
    fails("epafi %s: the stacks of so many threads would take all of the memory" % command,
            ["--threads", "4096"], command, TRESCA, "--threads", "100000")
fails("a value is missing", ["--set"], "run", TRESCA, "--set")
fails("a switch takes no value", ["--force"], "run", TRESCA, "--force=yes")
fails("a missing file", ["nowhere.xml"], "run", os.path.join(WORK, "nowhere.xml"))
fails("an unknown key names the nearest", ["'Strategy'"], "run", TRESCA, "--set",
        "Adaptivity->Strateg=None")
fails("a wrong type", ["Maximum Levels"], "run", TRESCA, "--set",
        "Adaptivity->Maximum Levels=many")
fails("a cap below the first level", ["Maximum Degrees of Freedom"], "run", TRESCA,
        "--output", fresh("cap"), "--set", "Adaptivity->Maximum Degrees of Freedom=10")
fails("behind -- a word is no option", ["no such file", "--scene.xml"], "run", "--",
        "--scene.xml")
fails("a format of one command's help", ["--format"], "help", "run", "--format", "man")
fails("help is no failure", ["epafi check"], "--help", code=0)
fails("a word that an option does not know", ["--of: unknown value 'foo'", "'scene'"],
      "parameters", "--of", "foo")
fails("a study's folder is named by it", ["./<study name>.out"], "study", "--help", code=0)
fails("the pictures' least dots per inch", ["above 10,"], "plot", "--help", code=0)
fails("the version names the BLAS core", ["BLAS core"], "version", code=0)
for command in ("parameters", "schema", "help"):
    with open("/dev/full", "w") as full:
        done = subprocess.run([EPAFI, command], stdout=full, stderr=subprocess.PIPE,
                              universal_newlines=True)
    claim(done.returncode == 1 and "cannot be written" in done.stderr,
          "epafi %s on a full disk: exit %d, %s" % (command, done.returncode, done.stderr.strip()))

# what a person sees on a terminal: which step of how many, numbers with names, few file names
def seen():
    """The program's words, those of its line of progress first."""
    ours, theirs = pty.openpty()
    done = subprocess.run([EPAFI, "run", scene("there-and-back.xml"), "--output", fresh("seen"),
                           "--set", "Adaptivity->Maximum Levels=1"],
                          stdout=subprocess.PIPE, stderr=theirs, universal_newlines=True)
    os.close(theirs)
    line = b""
    try:
        while part := os.read(ours, 1 << 16):
            line += part
    except OSError:  # Linux's end of a terminal that is closed
        pass
    return line.decode(), done.stdout


progress, words = seen()
claim("level 0, step 2 of 3: newton" in progress, "progress names the step and how many there are")
claim(all(word in words for word in (" Newton steps, friction's work ", " normal force ", ", shear ")),
      "numbers of a step have names: " + [line for line in words.split("\n") if "step" in line][1])
claim("steps/1..3/contact.csv" in words and "steps/2" not in words, "files of steps are named once")

# where the time goes, on a path too: all of it is some phase's.  Other programs may stop this one
# anywhere for a while; so it is the best of a few runs that counts.
def timed():
    """Seconds of the start, of the run, and of what no phase holds."""
    folder = fresh("times")
    code, _ = epafi("run", scene("fretting.xml"), "--output", folder, "--set",
                    "History->Steps={1, 2, 2, 2}", "--threads", "1")
    assert code == 0
    with open(os.path.join(folder, "timings.txt")) as stream:
        times = [line.strip("| ").split(" ") for line in stream if ": " in line]
    [start] = [float(words[1]) for words in times if words[0] == "start:"]
    [total] = [float(words[2]) for words in times if words[:2] == ["epafi", "run:"]]
    return start, total, sum(float(words[1]) for words in times if words[0] == "Remainder:")


start, total, rest = min((timed() for _ in range(4)), key=lambda run: run[2] / run[1])
claim(0 < start < 60, "timings.txt has the start, %s s, and all of a run: %s" % (start, total))
claim(rest < 0.05 * total, "phases cover 95 %% of %g s: %g s are left" % (total, rest))

# folders
folder = os.path.join(fresh("deep"), "er", "still")
code, text = epafi("run", TRESCA, "--output", folder, *ONE)
claim(code == 0 and os.path.exists(os.path.join(folder, "history.csv")), "parents are made")
keep = os.path.join(folder, "notes.txt")
open(keep, "w").close()
fails("an earlier run is not overwritten", ["--force"], "run", TRESCA, "--output", folder,
        *ONE)
claim(sorted(os.listdir(folder)) == ["boundary.csv", "contact.csv", "history.csv",
                                     "interior.csv", "notes.txt", "solution.hdf",
                                     "timings.txt", "used.xml"],
      "no temporary file is left: " + " ".join(sorted(os.listdir(folder))))
code, text = epafi("run", TRESCA, "--output=" + folder, "--force", *ONE, "--set",
                   "Output->Fields=false")
claim(code == 0 and sorted(os.listdir(folder)) == ["contact.csv", "history.csv",
                                                   "interior.csv", "notes.txt",
                                                   "timings.txt", "used.xml"],
      "--force deletes the program's own files only; Fields = false leaves fields out: " +
      " ".join(sorted(os.listdir(folder))))
fails("a file is no folder", ["is a file"], "run", TRESCA, "--output", keep, *ONE)


def content(folder):
    return {name: open(os.path.join(folder, name), "rb").read() for name in os.listdir(folder)}


# Root may write anywhere unless it gives that right away.
HUMBLE = ["setpriv", "--bounding-set=-dac_override"] if os.geteuid() == 0 else []
locked = fresh("locked")
code, text = epafi("run", TRESCA, "--output", locked, *ONE)
before = content(locked)
os.chmod(locked, 0o500)
for sentence, arguments in (
        ("a new run", ["--output", locked]), ("a run that would replace it", ["--output", locked,
                                                                              "--force"]),
        ("a restart", ["--restart", locked, "--set", "Adaptivity->Maximum Levels=3"]),
        ("a folder in it", ["--output", os.path.join(locked, "deeper")])):
    done = subprocess.run([*HUMBLE, EPAFI, "run", TRESCA, *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, universal_newlines=True)
    claim(done.returncode == 1 and len(done.stderr.splitlines()) == 1 and locked in done.stderr,
          "a folder that is not writable, %s (exit %d: %s)" % (sentence, done.returncode,
                                                               done.stderr.strip()))
    claim(content(locked) == before, "leaves its files as they were")
os.chmod(locked, 0o700)
code, text = epafi("run", TRESCA, "--quiet", "--output", fresh("quiet"), *ONE)
claim(code == 0 and text == "", "--quiet prints nothing")

# what has solved nothing is no run: it does not stand in the way of its correction
folder = fresh("corrected")
TOO_STRONG = ["--set", "Discretization->Stabilization->Gamma0=10", "--set",
              "Discretization->Stabilization->Scaling=Stiffness"]
fails("a stabilisation that is too strong", ["Gamma0"], "run", TRESCA, "--output", folder, *ONE,
      *TOO_STRONG, code=2)
claim(os.path.exists(os.path.join(folder, "used.xml")), "fails at once")
code, text = epafi("run", TRESCA, "--output", folder, *ONE)
claim(code == 0, "its correction takes its place without --force")
with open(os.path.join(folder, "history.csv")) as stream:
    head = stream.readline()
os.remove(os.path.join(folder, "solution.hdf"))
for name in ("contact.csv", "boundary.csv", "interior.csv"):
    os.remove(os.path.join(folder, name))
fails("a history with a row is a run", ["--force"], "run", TRESCA, "--output", folder, *ONE)
write(os.path.join(folder, "history.csv"), head)
code, text = epafi("run", TRESCA, "--output", folder, *ONE)
claim(code == 0, "one without a row is none")

# caps
history, contact = run(TRESCA, "capped", levels(6)[:2] +
                       ["Adaptivity->Maximum Degrees of Freedom=200"])
claim(history[-1]["dof"] <= 200 and len(history) == 3, "the cap on dof ends a run")
claim(list(history[0])[:9] == ["level", "elements", "dof_displacement", "dof_multiplier",
                               "dof", "dof_density", "degree_min", "degree_max",
                               "size_min"], "history.csv begins as promised")
claim(list(contact[0]) == ["boundary", "element", "x", "y", "lambda_n", "lambda_t", "u_n",
                           "u_t", "gap", "bound", "contact", "friction", "body",
                              "contact_name", "s", "normal_closing", "pressure", "shear",
                              "pressure_error", "shear_error", "d_x", "d_y"],
      "contact.csv has its columns")

# failures of the numerics
history, contact = run(TRESCA, "unconverged", levels(3) + ["Solver->Maximum Iterations=1"],
                       expect=3)
claim(history[-1]["status"] == "not converged" and len(contact) > 0,
      "what did not converge is written and said")
history, contact = run(TRESCA, "unconverged later", ["Solver->Maximum Iterations=2"], expect=3)
claim(history[-1]["energy_friction"] > 0, "with the work of its friction")
fails("points that still change are told, of the first level, too", ["still change state: ("], "run",
      scene("two-blocks.xml"), "--output", fresh("changing"), "--set", "Solver->Maximum Iterations=1", code=3)
claim(0 < max(row["newton_iterations"] for row in history) <= 45,
      "one step allowed: other methods make 20 in all, steps of the load as many")

# signals
ENDLESS = options(["Adaptivity->Strategy=Uniform h", "Adaptivity->Maximum Levels=20",
                   "Adaptivity->Maximum Degrees of Freedom=1000000"])
folder = fresh("interrupted")
code = stopped(lambda: os.path.exists(os.path.join(folder, "history.csv")), "run", TRESCA, "--output",
               folder, *ENDLESS, how=signal.SIGTERM)
claim(code == 128 + signal.SIGTERM, "SIGTERM ends with 128 + its number")
rows = table(os.path.join(folder, "history.csv"))
claim(len(rows) >= 1 and all(row["memory_mb"] is not None for row in rows),
      "rows are whole after a signal")

def interrupted(ready, *command, meanwhile=lambda: None, cwd=None):
    """Ctrl-C as soon as something is so: exit code, message, and seconds until the program ends."""
    process = subprocess.Popen(command, cwd=cwd, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               universal_newlines=True)
    deadline = time.time() + 60
    while time.time() < deadline and not ready():
        time.sleep(0.02)
    meanwhile()
    began = time.time()
    process.send_signal(signal.SIGINT)
    text = process.communicate()[1].strip()
    return process.returncode, text, time.time() - began


def deep():
    """Some levels are solved, and the next one takes seconds."""
    file = os.path.join(folder, "history.csv")
    return os.path.exists(file) and len(table(file)) >= 7


def another_run():
    time.sleep(0.5)
    fails("a folder that another run writes into", ["another run"], "run", TRESCA, "--output",
          folder, "--force", *ONE)


# Ctrl-C answers soon, also in the midst of a long phase, and says how to go on
MPIEXEC = os.environ.get("MPIEXEC")
commands = {"ctrl-c": [EPAFI], **({"ctrl-c.2": [MPIEXEC, "-n", "2", EPAFI]} if MPIEXEC else {})}
for name, command in commands.items():
    folder = fresh(name)
    code, text, took = interrupted(deep, *command, "run", TRESCA, "--quiet", "--output", folder,
                                   *ENDLESS, meanwhile=another_run)
    # mpirun's own exit code says nothing, and it may end before the program has spoken
    told = code == 130 and "--restart " + folder in text and text.count("--restart") == 1
    claim(took < 2 and (told or command[0] == MPIEXEC and code in (1, 130)),
          "%s: %.2f s, exit %d, %s" % (name, took, code, text))

# on a path behind the last step, in words that a shell takes for what was given
place = fresh("ctrl-c.path")
os.makedirs(place)
file, folder, setting = "-it's $HOME.xml", 'my "out" `ls`;', "History->Steps={10, 200, 200, 200}"
shutil.copy(scene("fretting.xml"), os.path.join(place, file))
solution = os.path.join(place, folder, "solution.hdf")
code, text, _ = interrupted(lambda: os.path.exists(solution), os.path.abspath(EPAFI), "run",
                            "--quiet", "--output", folder, "--set", setting, "--", file, cwd=place)
told, _, command = text.partition("; to go on from it: epafi run ")
words = subprocess.run(["sh", "-c", "printf '%s\\n' " + command], stdout=subprocess.PIPE,
                       universal_newlines=True).stdout.splitlines()
claim(code == 130 and "in level 0, after " in told and
      words == ["./" + file, "--set", setting, "--restart", folder],
      "Ctrl-C on the first level of a path: %s" % text)
with h5py.File(solution) as file:
    seconds = [float(file["Epafi"].attrs["seconds_" + name]) for name in ("total", "wall")]
claim(all(0 < value < 120 for value in seconds), "whose file has its seconds: %s" % seconds)
finish()
