"""clang-tidy over the C++ files of a build.  Standard library only.

    tidy.py ROOT [FOLDER...]     reads ROOT/build/compile_commands.json; FOLDER: packages, test/bem

Most of the time of a file goes by in the headers of libraries, so that neighbours are read as one:
each group of files of a folder becomes a file that includes them.  What does not compile as one,
since two files define a name of their own, is read in halves.  Shadowed names are left to GCC.  Prints what was found;
exit code 1 if anything was.
"""
import concurrent.futures
import itertools
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile

GROUP = 6
FOUND = re.compile(r"^\S.*(?:warning|error): .*\[.*\]$", re.M)


def options(command):
    """The options of a command that say how its file is read, without GCC's own."""
    words = iter(shlex.split(command)[1:])
    for word in words:
        if word in ("-o", "-c"):
            next(words)
        elif word != "-fcx-limited-range":
            yield word


def tidied(root, files, own):
    """What clang-tidy says about files that are read as one."""
    with tempfile.NamedTemporaryFile("w", suffix=".cpp", dir=root + "/build") as group:
        group.writelines('#include "%s"\n' % name for name in files)
        group.flush()
        several = len(files) > 1
        checks = ["--checks=-bugprone-suspicious-include"] if several else []
        said = subprocess.run(
            ["clang-tidy-14", "-quiet", "--config-file=%s/.clang-tidy" % root, *checks,
             group.name if several else files[0], "--", *own,
             *(["-Wno-shadow"] if several else [])], text=True,
            stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    if "[clang-diagnostic-error" in said and several:
        half = len(files) // 2
        return tidied(root, files[:half], own) + tidied(root, files[half:], own)
    return said


def main(root, *folders):
    with open(root + "/build/compile_commands.json") as stream:
        commands = {entry["file"]: entry["command"] for entry in json.load(stream)}
    # quadmath.h is among GCC's own headers; clang's come first
    gcc = subprocess.check_output(["g++", "-print-file-name=include"], text=True).strip()
    inside = tuple("%s/%s/" % (root, folder)
                   for folder in folders or ("packages", "drivers", "test"))

    def kind(name):
        return os.path.dirname(name), [*options(commands[name]), "-idirafter", gcc]

    groups = []
    for (_, own), files in itertools.groupby(
            sorted((name for name in commands if name.startswith(inside)), key=kind), kind):
        files = list(files)
        groups += [(files[k:k + GROUP], own) for k in range(0, len(files), GROUP)]
    found = set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for said in pool.map(lambda group: tidied(root, *group), groups):
            found.update(FOUND.findall(said))
    print("\n".join(sorted(found)))
    print("%d files, %d findings" % (sum(len(files) for files, _ in groups), len(found)))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
