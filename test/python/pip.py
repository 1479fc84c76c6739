"""pip install ./python, without network: the package, its version, and which program it finds.

    pip.py EPAFI WORK
"""
import importlib.util
import os
import shutil
import subprocess
import sys

EPAFI, WORK = sys.argv[1:]
SOURCE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "python")
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish  # noqa: E402

if not all(importlib.util.find_spec(name) for name in ("pip", "setuptools", "wheel")):
    print("pip, setuptools or wheel are not here: not tried")
    sys.exit(0)
tree = absent(os.path.join(WORK, "tree"))  # pip writes into the tree that it installs
shutil.copytree(SOURCE, os.path.join(tree, "python"),
                ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
target = absent(os.path.join(WORK, "target"))
clean = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "EPAFI")}
done = subprocess.run(
    [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--no-build-isolation",
     "--disable-pip-version-check", "--root-user-action=ignore", "--target", target,
     os.path.join(tree, "python")], env=clean, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
    text=True)
claim(done.returncode == 0, "pip installs the package: " + done.stdout.strip())
claim(all(os.path.isfile(os.path.join(target, "epafi", name))
          for name in ("py.typed", "runs.py", "plot/folder.py")), "all of it")


def asked(words, **variables):
    """What the installed package prints."""
    done = subprocess.run([sys.executable, "-c", "from epafi import program\n" + words],
                          env={**clean, "PYTHONPATH": target, "PATH": "/usr/bin:/bin", **variables},
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, cwd=WORK)
    return done.stdout.strip().splitlines()[-1]


WHERE = "print(program.program())"
found = asked(WHERE)
claim("not found" in found and "./run" in found, "without a program it says what to do: " + found)


def linked(*folders):
    """A program in a folder of its own name."""
    place = os.path.join(*folders)
    os.makedirs(os.path.dirname(place), exist_ok=True)
    shutil.copy(EPAFI, place)
    return os.path.realpath(place)


on_path = linked(WORK, "path", "epafi")
claim(asked(WHERE, PATH=os.path.dirname(on_path)) == on_path, "the program in PATH")
built = linked(tree, "build", "bin", "epafi")
claim(asked(WHERE, PATH=os.path.dirname(on_path)) == built,
      "before it the one built in the tree that pip installed from")
named = linked(WORK, "named", "epafi")
claim(asked(WHERE, EPAFI=named) == named, "before that one the variable EPAFI")
claim(asked("import epafi; print(epafi.version()['Epafi'])") == asked(
    "from importlib.metadata import version; print(version('epafi'))"),
      "package and program have one version")
finish()
