"""A run that goes on from solution.hdf is the run that never stopped; what is wrong with the
file, the folder or the disk is one sentence."""
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import zlib

import h5py
import numpy

from runs import EPAFI, RANKS, WORK, claim, epafi, finish, fresh, goes_on, options, scene, table
from scales import worst

HISTORY, CONTACT, SOLUTION = "history.csv", "contact.csv", "solution.hdf"
COEFFICIENT = "Bodies->block->Boundary Conditions->foundation->Friction->Coefficient=%g"
DOF = "Adaptivity->Maximum Degrees of Freedom=1600"
FILES = (HISTORY, CONTACT, "boundary.csv", SOLUTION)


def solve(file, folder, count, settings, *more):
    """Runs up to a number of levels; exit code and output."""
    return epafi("run", scene(file), *more, *(["--output", folder] if folder else []),
                 settings=[*settings, "Adaptivity->Maximum Levels=%d" % count, DOF])


def rows(folder, name=HISTORY):
    return table(os.path.join(folder, name))


def same(a, b):
    return worst(a, b)[0] <= 1e-10


def content(folder):
    result = {}
    for name in FILES:
        with open(os.path.join(folder, name), "rb") as stream:
            result[name] = stream.read()
    return result


def copy(folder, name):
    target = fresh(name)
    shutil.copytree(folder, target)
    return target


def refused(sentence, words, *arguments):
    code, text = epafi(*arguments)
    claim(code == 1 and all(word in text for word in words) and
          len(text.strip().split("\n")) == 1,
          "%s (exit %d: %s)" % (sentence, code, text.strip()[:200]))


# the same rows, iterations and points as without the stop
cases = [("tresca.xml", "tresca", [])]
cases += [("coulomb.xml", "coulomb %g" % f, [COEFFICIENT % f]) for f in (0.05, 1.5)]
STRATEGIES = ("Uniform h", "Uniform p", "Adaptive hp", "Graded hp")
for k, (file, name, settings) in enumerate(cases):
    # either coefficient with every other strategy; with "all" each with each
    for strategy in STRATEGIES if k == 0 or sys.argv[4:] == ["all"] else STRATEGIES[k - 1::2]:
        label = name + ", " + strategy
        settings_here = settings + ["Adaptivity->Strategy=" + strategy]
        part, *_ = goes_on(label, scene(file), [
            *settings_here, "Adaptivity->Maximum Levels=6", DOF], ["Adaptivity->Maximum Levels=3"])
        times = [row["seconds_total"] for row in rows(part)]
        claim(len(times) == 6 and times == sorted(times), label + ": CPU seconds count on")

# elsewhere; what may differ; nothing left to do
HP = ["Adaptivity->Strategy=Adaptive hp"]
base = fresh("base")
solve("tresca.xml", base, 3, HP)
before = content(base)
other = fresh("other")
code, text = solve("tresca.xml", other, 6, HP, "--restart", base)
claim(code == 0 and content(base) == before, "--output leaves the earlier run as it is")
claim(same(rows(os.path.join(WORK, "tresca, Adaptive hp")), rows(other)),
      "and has all rows, the earlier ones too")
code, text = solve("tresca.xml", fresh("strategy"), 4, ["Adaptivity->Strategy=Uniform p"],
                   "--restart", base)
claim(code == 0 and rows(os.path.join(WORK, "strategy"))[-1]["degree_min"] == 2,
      "another strategy may go on")
done = copy(base, "done")
code, text = solve("tresca.xml", None, 3, HP, "--restart", done)
claim(code == 0 and content(done) == before, "nothing to do changes nothing")
code, text = solve("tresca.xml", fresh("idle"), 3, HP, "--restart", done)
claim(code == 0 and content(os.path.join(WORK, "idle")) == before and SOLUTION in text,
      "nothing to do elsewhere leaves the same files there: " + text.splitlines()[-1])
drawn = copy(base, "drawn")
epafi("plot", drawn, "--picture", "all")
epafi("fields", drawn, "--grid", "5,5")
shutil.copy(os.path.join(drawn, "mesh.png"), os.path.join(drawn, "mine.png"))
before_more = set(os.listdir(drawn))
code, text = solve("tresca.xml", None, 3, HP, "--restart", drawn)
claim(code == 0 and set(os.listdir(drawn)) == before_more and {"mesh.svg", "fields.csv"} < before_more,
      "nor what was drawn of it")
code, text = solve("tresca.xml", None, 4, HP, "--restart", drawn)
claim(code == 0 and set(os.listdir(drawn)) == set(os.listdir(base)) | {"mine.png"},
      "another level leaves no picture and no field of the one before: " +
      " ".join(sorted(os.listdir(drawn))))
with open(os.path.join(done, HISTORY), "a") as stream:
    stream.write("99,a torn row")
code, text = solve("tresca.xml", None, 3, HP, "--restart", done)
claim(code == 0 and content(done) == before, "rows after the file's level are dropped")
UNIFORM = ["Adaptivity->Strategy=Uniform h"]
stuck = fresh("stuck")
code, text = solve("tresca.xml", stuck, 6, UNIFORM + ["Solver->Maximum Iterations=1"])
claim(code == 3, "a level is not converged")
code, text = solve("tresca.xml", None, 6, UNIFORM, "--restart", stuck)
claim(code == 0 and same(rows(stuck, CONTACT),
                         rows(os.path.join(WORK, "tresca, Uniform h, at once"), CONTACT)),
      "and is solved again with more iterations")

# a path that ends early on a level leaves no steps of the one before
path = UNIFORM + ["History->Times={1, 2}"]
early = fresh("early")
claim(solve("coulomb.xml", early, 1, path)[0] == 0, "a path of two steps")
pathed = copy(early, "pathed")
code, text = solve("coulomb.xml", None, 2, path + [
    "Solver->Coulomb Iteration=Fixed Point", "Solver->Coulomb Maximum Iterations=1"],
                   "--restart", early)
claim(code == 3 and os.listdir(os.path.join(early, "steps")) == ["1"],
      "a path that ends in its first step has files of that one: %s" % os.listdir(early + "/steps"))
code, text = epafi("fields", early, "--step", "2")
claim(code == 1 and "has 1 step" in text, "and says so: " + text.strip())

# what must agree
RESTART = ["run", scene("tresca.xml"), "--restart", base]
for sentence, setting, word in (
        ("another material", "Bodies->block->Material->Poisson's Ratio=0.1", "Poisson's Ratio"),
        ("another first mesh", "Discretization->Degree=2", "Discretization"),
        ("another constant", "Constants->c=1", "Constants"),
        ("other loads inside", "Body Loads->Force Y=-1", "Body Loads->Force Y"),
        ("another table", "Tables->profile={Points=2x2:{0, 0, 1, 1}}", "Tables"),
        ("other weights", "Adaptivity->Weights=Paper", "Adaptivity->Weights")):
    refused(sentence, [word, SOLUTION], *RESTART, "--set", setting)
refused("another scene", ["Bodies", SOLUTION], "run", scene("hertz.xml"), "--restart", base)
refused("--force and --restart", ["--force"], *RESTART, "--force")
refused("no new solution.hdf", ["Output->Fields"], *RESTART, "--set", "Output->Fields=false")
claim(content(base) == before, "a refused restart touches nothing")

# a file that is not what it should be
def not_read(sentence, folder, *words):
    refused(sentence, words, "run", scene("tresca.xml"), "--restart", folder)


not_read("no folder", os.path.join(WORK, "nowhere"), "no such file", SOLUTION)
damaged = copy(base, "damaged")
file = os.path.join(damaged, SOLUTION)
whole = before[SOLUTION]


def damage(data, sentence):
    with open(file, "wb") as stream:
        stream.write(data)
    not_read(sentence, damaged, file)


os.remove(file)
not_read("no solution.hdf", damaged, "no such file", file)
for length in (0, 7, 100, len(whole) // 3, len(whole) - 1):
    damage(whole[:length], "cut to %d of %d bytes" % (length, len(whole)))
noise = random.Random(1)
damage(bytes(noise.randrange(256) for _ in range(5000)), "garbage")
damage(whole[:600] + bytes(noise.randrange(256) for _ in range(len(whole) - 600)),
       "garbage behind the head")
place = whole.index(b"Poisson's Ratio")
damage(whole[:place] + b"q" + whole[place + 1:], "one letter of the scene")
os.remove(file)
os.makedirs(file)
not_read("a folder instead", damaged, "is a folder", file)
foreign = copy(base, "foreign")
with h5py.File(os.path.join(foreign, SOLUTION), "w") as data:
    data["x"] = 1
not_read("somebody else's HDF5 file", foreign, "/Epafi")

# a file of another format
other_format = copy(base, "format")
with h5py.File(os.path.join(other_format, SOLUTION), "r+") as data:
    data["Epafi"].attrs.modify("format", numpy.int32(4))
not_read("another format", other_format, "format 4", "reads format 10", SOLUTION)

# a file whose checksum is right, but not its meaning
def seal(group):
    """Writes the checksum, as drivers/output/SolutionFile.cpp forms it."""
    head = [numpy.int32(group.attrs[name]) for name in ("level", "converged", "complete")]
    head += [group.attrs[name] for name in ("seconds_total", "seconds_wall")]
    texts = [bytes(group[name][()]) for name in ("reason", "used")]
    texts += [part for name in ("history", "steps", "resultants")
              for part in (bytes(group[name + "_columns"][()]), group[name][()].tobytes())]
    numbers = [group[name][()] for name in (
        "edge", "degree", "position", "indicators", "multiplier", "rigid", "contact_state",
        "friction_state", "displacement", "density", "bodies", "rigid_bodies", "path_t",
        "path_iterations", "path_multiplier", "path_rigid", "path_errors", "step_t",
        "step_displacement", "step_density", "step_contact_state", "step_friction_state",
        "step_rigid_bodies")]
    group.attrs.modify("checksum", numpy.uint64(zlib.crc32(b"".join(
        [one.tobytes() for one in head] + texts + [one.tobytes() for one in numbers]))))


def foreign_edge(group):
    group["edge"][-1] = 100


def no_path(group):
    for name in [name for name in group if name.startswith("path_")]:
        none = group[name][:0]
        del group[name]
        group[name] = none


def short_path(group):
    short = group["path_multiplier"][:2]
    del group["path_multiplier"]
    group["path_multiplier"] = short


def other_head(group):
    columns = group["steps_columns"]
    columns[...] = columns[()].replace(b",parts,", b",Parts,", 1)


def no_kind(group):
    columns = group["steps_columns"]
    columns[...] = columns[()].replace(b"whole", b"whale", 1)


def no_word(group):
    group["history"][0, group["history_columns"][()].split(b",").index(b"status")] = 7


def half_a_level(group):
    group["history"][0, 0] = 0.5


def a_row_less(group):
    rest = group["steps"][:-1]
    del group["steps"]
    group["steps"] = rest


more = ["--set", "Adaptivity->Maximum Levels=2"]
for of, rest, change, words in (
        (base, [scene("tresca.xml"), *more], foreign_edge, "on edge 100"),
        (pathed, [scene("coulomb.xml"), *options(path), *more], no_path, "has no path"),
        (pathed, [scene("coulomb.xml"), *options(path), *more], short_path, "a path that does"),
        (pathed, [scene("coulomb.xml"), *options(path), *more], other_head, "other columns"),
        (pathed, [scene("coulomb.xml"), *options(path), *more], no_kind, "table that is damaged"),
        (pathed, [scene("coulomb.xml"), *options(path), *more], a_row_less, "not one row of steps.csv"),
        (base, [scene("tresca.xml"), *more], no_word, "table that is damaged"),
        (base, [scene("tresca.xml"), *more], half_a_level, "table that is damaged")):
    changed = copy(of, "changed")
    with h5py.File(os.path.join(changed, SOLUTION), "r+") as data:
        before_seal = data["Epafi"].attrs["checksum"]
        seal(data["Epafi"])
        claim(data["Epafi"].attrs["checksum"] == before_seal, "the checksum is as it was")
        change(data["Epafi"])
        seal(data["Epafi"])
    refused(words, [words, SOLUTION], "run", *rest, "--restart", changed)
    if change not in (other_head, a_row_less):  # of which fields know nothing
        refused(words + ", of fields", [words, SOLUTION], "fields", changed)
    if change is not other_head:  # neither do errors, of single columns
        refused(words + ", of a reference", [words, SOLUTION], "run", *rest, "--reference",
                os.path.join(changed, SOLUTION), "--output", fresh("referring"))

# a folder or disk that takes nothing
refused("a folder that cannot be made", ["cannot be made"], "run", scene("tresca.xml"),
        "--output", "/proc/epafi")


def limited(kilobytes):
    def limit():
        signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
        resource.setrlimit(resource.RLIMIT_FSIZE, (1024 * kilobytes, 1024 * kilobytes))
    return limit


def run_limited(arguments, kilobytes):
    got = subprocess.run([EPAFI, *arguments], stdout=subprocess.DEVNULL,
                         stderr=subprocess.PIPE, universal_newlines=True,
                         preexec_fn=limited(kilobytes))
    return got.returncode, got.stderr.strip()


# mpirun has files of its own, which the limit would meet first
for name in (SOLUTION, "contact.csv") if RANKS == 1 else ():
    kilobytes = len(before[name]) // 1024
    full = copy(base, "full")
    code, text = run_limited(RESTART[:-1] + [full] + options(
        HP + ["Adaptivity->Maximum Levels=4"]), kilobytes)
    claim(code == 1 and name in text and "\n" not in text,
          "files of %d KiB at most (exit %d: %s)" % (kilobytes, code, text))
    claim(content(full) == before and not any(".part" in n for n in os.listdir(full)),
          "leave the earlier level as it was")
    code, text = solve("tresca.xml", None, 6, HP, "--restart", full)
    claim(code == 0 and same(rows(other), rows(full)), "from which the run goes on")

tiny = fresh("tiny")
os.makedirs(tiny)
if os.geteuid() == 0 and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=80k", "epafi", tiny],
        stderr=subprocess.DEVNULL).returncode == 0:
    try:
        code, text = solve("tresca.xml", os.path.join(tiny, "out"), 6, HP)
        claim(code == 1 and "No space left" in text, "a full disk: " + text.split("\n")[-2])
    finally:
        subprocess.run(["umount", tiny], check=True)
finish()
