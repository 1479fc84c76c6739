"""Running epafi on several ranks.  Standard library only.

Every test is called as  <test>.py MPIEXEC EPAFI SCENES WORK.
"""
import os
import subprocess
import sys
import time

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, options, table  # noqa: E402, F401

MPIEXEC, EPAFI, SCENES, WORK = sys.argv[1:5]


def patience():
    """How much longer than on free cores, without sanitizers, something may take."""
    return float(os.environ.get("EPAFI_TEST_PATIENCE", "1")) * max(
        1, os.getloadavg()[0] / os.cpu_count())


def fresh(name):
    """A folder that does not exist yet."""
    return absent(os.path.join(WORK, name))


class Run:
    """mpirun -n ranks epafi arguments: exit code of each rank, messages, seconds.

    code is None where mpirun had to be killed.  A shell around each rank notes its exit code
    and hides it from mpirun, which would otherwise kill the others; plain=True leaves it out
    and gives mpirun's own.
    """

    def __init__(self, ranks, arguments, plain=False, environment=None, limit=60):
        codes = fresh("codes")
        os.makedirs(codes)
        command = [EPAFI, *arguments]
        if not plain:
            command = ["sh", "-c", '"$@"; echo $? > "$0/$OMPI_COMM_WORLD_RANK"', codes, *command]
        start = time.monotonic()
        try:
            done = subprocess.run([MPIEXEC, "-n", str(ranks), *command], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, universal_newlines=True,
                                  timeout=limit * patience(),
                                  env={**os.environ, **(environment or {})})
            self.code, self.text = done.returncode, done.stdout
        except subprocess.TimeoutExpired as expired:
            self.code, self.text = None, str(expired.output)
        self.seconds = time.monotonic() - start
        self.codes = [int(open(os.path.join(codes, name)).read()) for name in os.listdir(codes)]
        self.messages = [line for line in self.text.splitlines() if line.startswith("epafi:")]


def solved(count, name, scene, settings):
    """The folder of a shipped scene's run, and what was printed."""
    folder = fresh("%s-%d" % (name, count))
    run = Run(count, ["run", os.path.join(SCENES, scene + ".xml"), "--output", folder, *options(settings)])
    if run.codes != [0] * count:
        sys.exit("%s on %d ranks: %s\n%s" % (name, count, run.codes, run.text))
    return folder, run.text
