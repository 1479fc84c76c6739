"""kill -9 at a random moment leaves a folder that the run goes on from to the same result.

Fourth argument: how often."""
import os
import random
import subprocess
import sys
import time

from runs import EPAFI, claim, epafi, finish, fresh, options, rows, scene

LEVELS = 26  # so many that files are written on the way
SCENE = ["run", scene("tresca.xml"), "--quiet", "--threads", "1", *options([
    "Adaptivity->Strategy=Adaptive hp", "Adaptivity->Maximum Levels=%d" % LEVELS,
    "Adaptivity->Maximum Degrees of Freedom=100000"])]


def iterations(folder):
    return [row["newton_iterations"] for row in rows(folder, "history.csv")]


whole = fresh("whole")
began = time.monotonic()
code, text = epafi(*SCENE, "--output", whole)
duration = time.monotonic() - began
claim(code == 0, "a run of %.2f s that nobody kills" % duration)
expected = rows(whole)
largest = {key: max(abs(row[key]) for row in expected) for key in expected[0]
           if not isinstance(expected[0][key], str)}

moments = random.Random(2026)
resumed = 0
for k in range(int(sys.argv[4])):
    folder = fresh("killed")
    moment = moments.uniform(0.1, 1) * duration
    process = subprocess.Popen([EPAFI, *SCENE, "--output", folder])
    # every other one behind the first file that it could go on from
    while k % 2 == 1 and process.poll() is None and not os.path.exists(
            os.path.join(folder, "solution.hdf")):
        time.sleep(0.01)
    time.sleep(moment if k % 2 == 0 else 0.3 * moment)
    process.kill()
    process.wait()
    solved = os.path.exists(os.path.join(folder, "solution.hdf"))
    resumed += solved
    code, text = epafi(*SCENE, *(["--restart", folder] if solved else
                                 ["--output", folder, "--force"]))
    points = rows(folder) if code == 0 else []
    error = max((abs(a[key] - b[key]) / (size or 1)
                 for a, b in zip(points, expected) for key, size in largest.items()),
                default=1)
    claim(code == 0 and len(points) == len(expected) and error <= 1e-10 and
          iterations(folder) == iterations(whole) and
          not any(name.startswith(".") for name in os.listdir(folder)),
          "killed after %.3f s, %s: contact.csv differs by %.1e %s" %
          (moment, "restarted" if solved else "nothing yet, begun anew", error, text))
claim(resumed > 0, "%d runs were restarted" % resumed)
finish()
