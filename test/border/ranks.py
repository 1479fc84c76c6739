"""Running epafi on several ranks.  Standard library only.

Every test is called as  <test>.py MPIEXEC EPAFI SCENES WORK.
"""
import csv
import os
import shutil
import subprocess
import sys
import time

MPIEXEC, EPAFI, SCENES, WORK = sys.argv[1:5]
failures = []


def claim(true, sentence):
    """Notes a claim that does not hold; finish() reports all of them."""
    print(("ok      " if true else "FAILED  ") + sentence)
    if not true:
        failures.append(sentence)


def finish():
    sys.exit(1 if failures else 0)


def fresh(name):
    """A folder that does not exist yet."""
    folder = os.path.join(WORK, name)
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(WORK, exist_ok=True)
    return folder


class Run:
    """mpirun -n ranks epafi arguments: exit code of each rank, messages, seconds.

    code is None where mpirun had to be killed.  A shell around each rank notes its exit code and hides it from mpirun, which
    would otherwise kill the others; plain=True leaves it out and gives mpirun's own.
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
                                  timeout=limit, env={**os.environ, **(environment or {})})
            self.code, self.text = done.returncode, done.stdout
        except subprocess.TimeoutExpired as expired:
            self.code, self.text = None, str(expired.output)
        self.seconds = time.monotonic() - start
        self.codes = [int(open(os.path.join(codes, name)).read()) for name in os.listdir(codes)]
        self.messages = [line for line in self.text.splitlines() if line.startswith("epafi:")]


def table(file):
    """Columns by name, as text."""
    with open(file, newline="") as stream:
        rows = list(csv.DictReader(stream))
    return {name: [row[name] for row in rows] for name in rows[0]}
