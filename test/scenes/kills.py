"""kill -9 at any moment leaves a folder that the run goes on from to the same end.

Fourth argument: how often it is killed; fifth: levels, path (one body that rubs) or bodies (two).
"""
import os
import random
import sys
import time

import h5py

from halves import half
from runs import claim, epafi, fails, finish, fresh, options, rows, scene, stopped, table
from scales import worst
from written import contact, friction, history, listed, wear, written

KIND = sys.argv[5]
if KIND == "bodies":
    PUSH = "0.25*pi/400*(t < 1 ? 0 : 2/pi*asin(sin(pi/2*(t - 1))))"
    SCENE = [written(
        "two", [half("upper", 1, 2, PUSH), half("lower", -1, 3, PUSH, ratio=0.2)], contact(
            "fret", "upper:contact", "lower:contact", friction("0.5"), wear(0.02, "t < 2 ? 1 : 10"),
            listed("Normal", Law="Exponential", Length=1e-4, Pressure=1e-3),
            Interference="-x^2/200", Sliding="2e-5*t"), "Density",
        more=history([1, 2, 4, 6], [1, 7, 16, 16]))]
elif KIND == "path":
    SCENE = [scene("fretting.xml"), *options([
        "Discretization->Elements per Edge={2, 2, 2, 3, 1, 4, 10, 4, 1, 3, 2, 2, 2, 3, 3, 3}",
        "History->Times={1, 2, 4, 6}", "History->Steps={1, 7, 16, 16}"])]
else:  # so many levels that files are written on the way
    SCENE = [scene("tresca.xml"), *options(["Adaptivity->Maximum Degrees of Freedom=100000"])]
STEPS = 0 if KIND == "levels" else 40  # of each level
SCENE += ["--quiet", "--threads", "1", *options(
    ["Adaptivity->Strategy=Adaptive h", "Adaptivity->Maximum Levels=3"] if STEPS else
    ["Adaptivity->Strategy=Adaptive hp", "Adaptivity->Maximum Levels=26"])]


def same(sentence, whole, part):
    names = [name for name in ("history.csv", "steps.csv", "contact.csv", "bodies.csv", *(
        os.path.join("steps", str(k), "contact.csv") for k in (1, 20, 40)))
        if os.path.exists(os.path.join(whole, name))]
    apart = max(worst(rows(whole, name), rows(part, name)) for name in names)
    hidden = [name for name in os.listdir(part) if name.startswith(".")]
    claim(apart[0] < 1e-10 and not hidden, "%s: the same files, %.1e in %s %s" % (
        sentence, *apart, hidden))


def solution(folder):
    """The last file of a write: it says what a folder holds."""
    return os.path.join(folder, "solution.hdf")


def solved(folder):
    """Steps, or levels, of which solution.hdf knows, and whether those of its level are all."""
    with h5py.File(solution(folder)) as file:
        told = file["Epafi"].attrs
        return (STEPS or 1) * int(told["level"]) + len(file["Epafi/path_t"]), bool(told["complete"])


whole = fresh("whole")
began = time.monotonic()
code, text = epafi("run", *SCENE, "--output", whole)
duration = time.monotonic() - began
claim(code == 0 and not STEPS or len(rows(whole, "steps.csv")) == 3 * STEPS,
      "a run that nobody kills: " + text[-100:])

moments = random.Random(15)
resumed = 0
for k in range(int(sys.argv[4])):
    folder = fresh("killed")
    end = time.monotonic() + moments.uniform(0.1, 1) * duration
    # every other one behind the first file that it could go on from, however late that is
    stopped(lambda: os.path.exists(solution(folder)) if k % 2 else time.monotonic() > end,
            "run", *SCENE, "--output", folder)
    goes_on = os.path.exists(solution(folder))
    resumed += goes_on
    before, complete = solved(folder) if goes_on else (0, True)
    if not complete:
        fails("fields of its steps", ["--restart"], "fields", folder, "--step", "1")
    code, text = epafi("run", *SCENE, *(["--restart", folder] if goes_on
                                        else ["--output", folder, "--force"]))
    claim(code == 0, "killed behind %d steps: goes on%s" % (before, "" if code == 0 else text))
    same("killed behind %d steps" % before, whole, folder)
claim(resumed > 0, "%d of the folders could be gone on from" % resumed)
if not STEPS:
    finish()

elsewhere = fresh("elsewhere")
code, text = epafi("run", *SCENE, "--restart", whole, "--output", elsewhere)
same("nothing left to solve elsewhere", whole, elsewhere)
code, text = epafi("fields", elsewhere, "--step", "20", "--grid", "4,4")
claim(code == 0, "and fields of its steps: " + text.strip()[-90:])

# one that goes on and is killed as soon as it writes has lost no step
def file_number(folder):
    return os.stat(solution(folder)).st_ino


folder = fresh("twice")
steps = os.path.join(folder, "steps.csv")
stopped(lambda: os.path.exists(solution(folder)) and len(table(steps)) >= 25,
        "run", *SCENE, "--output", folder)
for k in range(3):
    before, number = solved(folder)[0], file_number(folder)
    stopped(lambda: file_number(folder) != number, "run", *SCENE, "--restart", folder)
    claim(solved(folder)[0] >= before and len(table(steps)) >= before,
          "killed again behind %d steps: %d in solution.hdf, %d in steps.csv" % (
              before, solved(folder)[0], len(table(steps))))
code, text = epafi("run", *SCENE, "--restart", folder)
claim(code == 0, "killed four times: goes on" + ("" if code == 0 else text))
same("killed four times", whole, folder)

fails("another path", ["History"], "run", *SCENE, "--restart", whole, "--set",
      "History->Steps={1, 7, 16, 17}")
finish()
