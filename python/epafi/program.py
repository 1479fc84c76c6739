"""The program behind the package, and how its failures become exceptions."""
from __future__ import annotations

import functools
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import threading
import warnings
from typing import TYPE_CHECKING, Any, Callable, Optional, Sequence

from epafi.describe import json_object

if TYPE_CHECKING:
    from epafi.runs import Run

HERE = os.path.dirname(os.path.abspath(__file__))


class EpafiError(RuntimeError):
    """The program ended with `code`, and said why."""

    def __init__(self, message: str, code: int) -> None:
        super().__init__(message)
        self.code = code
        self.words = message  # the program's own, with its options


class InputError(EpafiError, ValueError):
    """A scene or an argument is wrong (exit code 1): what, where, what is allowed."""

    def __init__(self, message: str, code: int = 1) -> None:
        super().__init__(message, code)


class NumericalError(EpafiError, ArithmeticError):
    """Arithmetic broke down (exit code 2)."""


class EpafiWarning(UserWarning):
    """What a scene probably does not mean."""


class NotConverged(EpafiError):
    """A level is not converged (exit code 3); its files are written: see `run`."""

    run: Run


def program() -> str:
    """Where `epafi` is: the variable EPAFI, bin of the prefix or the virtual environment that this
    package is in, build/bin of the tree that it is in or was installed from by pip, PATH, in
    this order."""
    trees = [os.path.join(HERE, "..", "..")]
    if os.path.isfile(os.path.join(HERE, "tree")):  # by setup.py
        with open(os.path.join(HERE, "tree"), encoding="utf-8") as stream:
            trees.append(stream.read())
    places = [os.environ.get("EPAFI", ""),
              os.path.join(HERE, "..", "..", "..", "..", "bin", "epafi"),
              *(os.path.join(tree, "build", "bin", "epafi") for tree in trees),
              shutil.which("epafi") or ""]
    if places[0] and not os.access(places[0], os.X_OK):
        raise EpafiError("the variable EPAFI is '%s', which is no program" % places[0], 1)
    for place in places:
        if place and os.access(place, os.X_OK):
            return os.path.realpath(place)
    raise EpafiError("the program epafi is not found: build it (./run), put it into PATH, or its "
                     "path into the variable EPAFI", 1)


def failure(code: int, complaint: str) -> EpafiError:
    """The exception for an exit code, with the program's own sentence, its options by the names
    of the arguments here: "--restart DIR" is restart, "--force" force=True."""
    kinds: dict[int, type[EpafiError]] = {1: InputError, 2: NumericalError, 3: NotConverged}
    words = complaint.strip().removeprefix("epafi: ") or "exit code %d" % code
    message = re.sub(r"(?<![^\s(])(?:fields: |epafi run )?--([a-z]+)(?: [A-Z][A-Z:,]*\b)?",
                     r"\1", words.replace("--force", "force=True"))
    error = kinds.get(code, EpafiError)(message, code)
    error.words = words
    return error


# What mpirun tells the processes it starts: epafi run by one of these would wait for its ranks.
LAUNCHER = ("OMPI_COMM_WORLD", "OMPI_MCA_ess", "OMPI_MCA_orte", "OMPI_MCA_pmix", "PMI",
            "MPI_LOCAL")

# What `call` waits for, by thread: only the main thread hears of an interrupt.
RUNNING: dict[int, subprocess.Popen[str]] = {}


def call(arguments: Sequence[str], said: Optional[Callable[[str], Any]] = None,
         scene: str = "") -> str:
    """Runs epafi; returns what it printed, each line told to `said` as it comes.

    EpafiError where it fails; its sentence names neither `scene`, a file that is about to
    vanish, nor places in it.  KeyboardInterrupt is told to the program, too, which then keeps what is solved.
    """
    lines = []
    with tempfile.TemporaryFile("w+") as complaints:
        process = subprocess.Popen([program(), *arguments], stdout=subprocess.PIPE,
                                   stderr=complaints, text=True,
                                   env={name: value for name, value in os.environ.items()
                                        if not name.startswith(LAUNCHER)},
                                   # else Ctrl-C in a terminal reaches it twice, and the second
                                   # one ends it at once
                                   start_new_session=True)
        assert process.stdout is not None
        RUNNING[threading.get_ident()] = process
        try:
            for line in process.stdout:
                lines.append(line)
                if said:
                    said(line.rstrip("\n"))
            code = process.wait()
        except BaseException:
            while process.poll() is None:
                try:
                    process.send_signal(signal.SIGINT)  # a second one ends it at once
                    process.wait()
                except KeyboardInterrupt:
                    continue
            raise
        finally:
            process.stdout.close()
            del RUNNING[threading.get_ident()]
        complaints.seek(0)
        text = complaints.read()
        for line in text.splitlines():
            if line.startswith("epafi: warning: "):
                warnings.warn(line.removeprefix("epafi: warning: "), EpafiWarning, stacklevel=3)
        if code != 0:
            text = "".join(line for line in text.splitlines(True)
                           if not line.startswith("epafi: warning: "))
            raise failure(code, re.sub(r" \(line \d+, column \d+\)", "", text.replace(
                scene + ": ", "")) if scene else text)
    return "".join(lines)


@functools.lru_cache(maxsize=None)
def schema() -> dict[str, Any]:
    """The JSON Schema of a scene: keys, types, words, ranges."""
    return json_object(json.loads(call(["help", "--format", "json"]))["keys"]["scene"])


def version() -> dict[str, str]:
    """What the program is made of: {"Epafi": "0.2.0", "Trilinos": ..., "MPI": "Open MPI 4.1.4",
    "BLAS core": ...}."""
    lines = call(["version"]).splitlines()
    return {name: line.removeprefix(name + " ") for name, line in zip(
        ("Epafi", "Trilinos", "MPI", "BLAS core"), lines)}
