#!/usr/bin/python3
"""What `epafi study` becomes: runs of the variants of scenes, one table, pictures.

    study.py STUDY FOLDER THREADS [--threads=N] [--quiet] [--no-plot]

The folder has the complete study as .used.xml.part; THREADS are "2 threads"."""
from __future__ import annotations

import csv
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import warnings
from typing import Any, Iterator, Mapping, NamedTuple, Optional, Sequence

sys.dont_write_bytecode = True  # nothing beside what was installed
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path = [os.path.dirname(HERE), *(p for p in sys.path if p != HERE)]
from epafi.program import EpafiError, InputError, NotConverged, call  # noqa: E402
from epafi.scenes import printed  # noqa: E402
from epafi.tables import nearest, own  # noqa: E402

HEAD = "  level    dof  density   estimate      error  effectivity  steps   CPU s"
# What `epafi run --reference` adds to history.csv; study.csv calls the last one worst_step.
ERRORS = ("error", "error_multiplier", "error_energy", "counted", "effectivity", "error_path",
          "error_path_multiplier", "error_path_friction", "error_path_step")
OWN = ("sweep_value", "smallest_eigenvalue", "reason", "folder")
# What a variant keeps only with `Keep Solutions`; a sweep may have hundreds of values.
OF_MANY = ("solution.hdf", "timings.txt", "steps.pvd", "steps")
OF_SWEEPS = ("history.csv", "boundary.csv", "bodies.csv", "interior.csv", *OF_MANY)
# What --force replaces; files of variants are their runs' business.
EARLIER = re.compile(
    r"study\.csv|(contact_stress|convergence|effectivity|exponential|path|sweep|sweep_forces|"
    r"sweep_contact(_\d+)?|time|work-precision)\.(png|svg|pdf)")


class Variant(NamedTuple):
    """A way of solving a scene."""

    scene: str
    name: str
    arguments: list[str]  # of `epafi run`: the scene's file, --set
    used: str  # the complete scene, as JSON
    value: Optional[str] = None  # of a sweep

    def get(self, part: str, key: str, default: Any = None) -> Any:
        tree, = json.loads(self.used).values()
        return tree.get(part, {}).get(key, default)


def setting(value: Any) -> str:
    """A value as --set reads it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if not isinstance(value, list):
        return str(value)
    table = bool(value) and isinstance(value[0], list)
    text = "{%s}" % ", ".join(
        setting(cell) for row in (value if table else [value]) for cell in row)
    return "%dx%d:%s" % (len(value), len(value[0]), text) if table else text


def settings(*lists: Mapping[str, Any]) -> list[str]:
    """The options for Set and Override of lists."""
    def assignments(tree: Mapping[str, Any], path: str) -> Iterator[str]:
        for key, value in tree.items():
            if isinstance(value, Mapping):
                yield from assignments(value, path + key + "->")
            else:
                yield "%s%s=%s" % (path, key, setting(value))

    return [word for rules in lists
            for text in (*rules.get("Set", ()), *assignments(rules.get("Override", {}), ""))
            for word in ("--set", text)]


def variant(where: str, scene: str, name: str, arguments: list[str],
            value: Optional[str] = None) -> Variant:
    """Errors begin with the place in the study that wants it."""
    try:
        return Variant(scene, name, arguments, call(
            ["check", *arguments, "--used", "--format", "json"]), value)
    except InputError as error:
        raise InputError("%s: %s" % (where, error.words)) from None


def variants_of(study: Mapping[str, Any], scene: str, common: list[str]) -> Iterator[Variant]:
    """Of each entry that is for the scene: one, or one per value of its sweep."""
    for name, rules in study["Variants"].items():
        if scene not in rules.get("Scenes", [scene]):
            continue
        where, arguments = "Variants->" + name, [*common, *settings(rules)]
        sweep = rules.get("Sweep", {})
        key, values = sweep.get("Key"), sweep.get("Values", [])
        if bool(key) != bool(values):
            raise InputError(where + "->Sweep: give both Key and Values")
        if not values:
            yield variant(where, scene, name, arguments)
        for value in values:
            yield variant(where + "->Sweep", scene,
                          "%s, %s = %s" % (name, key.rpartition("->")[2], value),
                          [*arguments, "--set", "%s=%s" % (key, value)], value)


def check_names(study: Mapping[str, Any]) -> None:
    scenes = study["Scenes"]
    for kind in ("Scenes", "Variants"):
        if not study[kind]:
            raise InputError("%s: no %s is given; at least one is needed" % (
                kind, kind.lower()[:-1]))
    for name, rules in study["Variants"].items():
        for scene in rules.get("Scenes", ()):
            if scene not in scenes:
                raise InputError("Variants->%s->Scenes: there is no %r%s; known here: %s" % (
                    name, scene, nearest(scene, scenes), ", ".join(map(repr, scenes))))


def scenes_of(study: Mapping[str, Any]) -> list[tuple[Optional[Variant], list[Variant]]]:
    """The reference and the variants of each scene, all of them valid."""
    check_names(study)
    scenes = []
    for name, rules in study["Scenes"].items():
        common = [rules["File"], *settings(study, rules)]
        where = "Scenes->%s->Reference" % name
        reference = "Reference" in rules and variant(
            where, name, "reference", [*common, *settings(rules["Reference"])]) or None
        variants = list(variants_of(study, name, common))
        scenes.append((reference, variants))
        if not reference:
            continue
        if (reference.get("Adaptivity", "Weights"),
                reference.get("Adaptivity", "Residual Factor")) != ("Energy", 1):
            raise InputError(where + ": its estimate says which errors can be told, and so "
                             "needs Adaptivity->Weights = Energy and Residual Factor = 1")
        for each in variants:
            ends = [one.get("History", "Times", [1.0])[-1] for one in (each, reference)]
            if ends[0] != ends[1] and not any(isinstance(end, str) for end in ends):
                raise InputError(
                    "Variants->%s: its path ends at t = %g, that of %s at %g; errors compare "
                    "solutions under the same loads" % (each.name, ends[0], where, ends[1]))
    return scenes


def file_name(name: str) -> str:
    """As the name of a file that is neither hidden nor in another folder."""
    name = re.sub(rb"[^A-Za-z0-9.+=-]", b"_", name.encode()).decode()
    return "_" + name if name[:1] in ("", ".") else name


def history(folder: str) -> list[dict[str, str]]:
    try:
        with open(os.path.join(folder, "history.csv"), newline="") as stream:
            return list(csv.DictReader(stream))
    except FileNotFoundError:
        return []


def line(row: Mapping[str, str]) -> str:
    estimate, error, effectivity = (
        "%.4g" % float(cell) if cell else "" for cell in (
            row["estimate"], row.get("error_path") or row.get("error"), row.get("effectivity")))
    return "%7s%7s%9s%11s%11s%13s%7s%8.2f%s" % (
        row["level"], row["dof"], row["dof_density"], estimate, error, effectivity,
        row["newton_iterations"], float(row["seconds_total"]),
        "  not counted" if row.get("counted") == "0" else "")


class Study:
    def __init__(self, folder: str, tree: Mapping[str, Any], options: Sequence[str]) -> None:
        self.folder = folder
        self.kept = tree["Keep Solutions"]
        self.quiet = "--quiet" in options
        self.options = [*(option for option in options if option.startswith("--threads=")),
                        *["--smallest-eigenvalue"] * tree["Smallest Eigenvalue"]]
        self.columns = ["level", "status"]  # of history.csv, once there is one
        self.rows: list[dict[str, str]] = []
        self.folders: set[str] = set()
        self.unsolved = 0

    def say(self, *lines: str) -> None:
        if lines and not self.quiet:
            print(*lines, sep="\n", flush=True)

    def add(self, variant: Variant, row: Mapping[str, str], **more: str) -> None:
        """A row of study.csv."""
        if "dof" in row:
            self.columns = list(dict.fromkeys(
                name for name in (*row, *self.columns) if name not in (*ERRORS, *OWN)))
        try:
            more["sweep_value"] = "%.17g" % float(variant.value or "")
        except ValueError:  # no sweep, or not of numbers
            pass
        self.rows.append({"scene": variant.scene, "variant": variant.name, **row, **more})
        self.write()

    def write(self) -> None:
        names = ["scene", "variant", *self.columns, *ERRORS, *OWN]
        part = own(self.folder, ".study.csv.part")
        with open(part, "w", newline="", encoding="utf-8") as stream:
            table = csv.writer(stream, lineterminator="\n")
            table.writerow("worst_step" if name == ERRORS[-1] else name for name in names)
            table.writerows([row.get(name, "") for name in names] for row in self.rows)
        os.replace(part, os.path.join(self.folder, "study.csv"))

    def fail(self, variant: Variant, level: int, reason: str) -> None:
        self.unsolved += 1
        more = {}
        used = re.search(r"Gamma0 = (\S+) is too large for this mesh; below (\S+) it", reason)
        if used:
            more["smallest_eigenvalue"] = "%.17g" % (1 - float(used[1]) / float(used[2]))
        self.add(variant, {"level": str(level), "status": "failed"}, reason=reason, **more)
        self.say("  %s: %s failed on level %d: %s" % (
            variant.scene, variant.name, level, reason))

    def reference(self, variant: Variant) -> Optional[str]:
        """The solution.hdf, kept from before or computed now; None if it failed."""
        name = own(self.folder, "reference-" + file_name(variant.scene) + ".hdf")[:-4]
        solution = name + ".hdf"

        def checksum() -> str:
            with open(solution, "rb") as stream:
                return hashlib.sha256(stream.read()).hexdigest()

        try:
            with open(name + ".json", encoding="utf-8") as stream:
                of = json.load(stream)
            kept = of["scene"] == variant.used and of["checksum"] == checksum()
        except (OSError, ValueError, KeyError):
            kept = False
        if not kept:  # what stands there is taken for the whole of it later
            with tempfile.TemporaryDirectory(dir=self.folder) as place:
                try:
                    call(["run", *variant.arguments, "--set", "Output->Fields=true", "--output",
                          place, *self.options], scene=variant.arguments[0])
                except EpafiError as error:
                    self.fail(variant, len(history(place)), error.words)
                    return None
                os.replace(os.path.join(place, "solution.hdf"), solution)
                of = {"scene": variant.used, "checksum": checksum(), "level": history(place)[-1]}
            with open(name + ".json", "w", encoding="utf-8") as stream:
                json.dump(of, stream)
        self.say("%s: reference %s, %s elements, estimate %g" % (
            variant.scene, "kept from before" if kept else "computed", of["level"]["elements"],
            float(of["level"]["estimate"])))
        self.add(variant, {**of["level"], "smallest_eigenvalue": ""})
        return solution

    def folder_of(self, variant: Variant, alone: bool) -> str:
        """Different variants get different folders, even if their names differ in signs only."""
        name = os.path.join("" if variant.value is None else "sweep",
                            ("" if alone else file_name(variant.scene) + "-") +
                            file_name(variant.name))
        while name in self.folders:
            name += "_"
        self.folders.add(name)
        return name

    def solve(self, variant: Variant, name: str, reference: Optional[str]) -> None:
        self.say("%s: %s" % (variant.scene, variant.name))
        folder = own(self.folder, name)
        shown = 0

        def look(said: str = "") -> None:
            """Takes the levels that are written, and notes of the run: "        level 2: ..."."""
            nonlocal shown
            for row in history(folder)[shown:]:
                shown += 1
                self.add(variant, row, folder=name)
                self.say(line(row))
            if re.match(" {8}(?!step)", said):
                self.say(said)

        with warnings.catch_warnings(record=True) as found:
            warnings.simplefilter("always")
            try:
                call(["run", *variant.arguments, "--output", folder, "--force", *self.options,
                      *(["--reference", reference] if reference else [])], look,
                     variant.arguments[0])
            except NotConverged as error:
                look()
                self.unsolved += 1
                self.rows[-1]["reason"] = error.words.partition(" is not converged: ")[2]
                self.say("  not converged: " + self.rows[-1]["reason"])
                self.write()
            except EpafiError as error:
                look()
                self.fail(variant, shown, error.words)
            finally:
                look()
        self.say(*("  warning: %s" % warning.message for warning in found))
        for file in () if self.kept else OF_MANY if variant.value is None else OF_SWEEPS:
            path = os.path.join(folder, file)
            if os.path.exists(path):
                if os.path.isdir(path):
                    shutil.rmtree(path)
                else:
                    os.remove(path)


def solve_all(file: str, folder: str, threads: str, *options: str) -> int:
    part = os.path.join(folder, ".used.xml.part")
    title, tree = printed(part)
    study = Study(folder, tree, options)
    try:
        scenes = scenes_of(tree)
    except InputError as error:
        os.remove(part)
        raise InputError("%s: %s" % (file, error)) from None
    for name in filter(EARLIER.fullmatch, os.listdir(folder)):
        if not os.path.isdir(os.path.join(folder, name)):
            os.remove(os.path.join(folder, name))
    os.replace(part, os.path.join(folder, "used.xml"))
    study.say("%s, %s" % (title, threads))
    for reference, variants in scenes:
        solution = study.reference(reference) if reference else None
        study.say(HEAD)
        for each in variants:
            study.solve(each, study.folder_of(each, len(scenes) == 1), solution)
    if study.unsolved:
        print("epafi: %s not solved on every level: column reason of %s/study.csv" % (
            "1 variant was" if study.unsolved == 1 else "%d variants were" % study.unsolved,
            folder), file=sys.stderr, flush=True)
    drawn = "--no-plot" in options or subprocess.run(
        [sys.executable, os.path.join(HERE, "plot", "__main__.py"), folder],
        stdout=subprocess.DEVNULL if study.quiet else None).returncode == 0
    return 3 if study.unsolved else 0 if drawn else 1


def main() -> int:
    def end(number: int, _: Any) -> None:
        raise KeyboardInterrupt(number)

    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, end)
    try:
        return solve_all(*sys.argv[1:])
    except KeyboardInterrupt as interrupt:
        code, words = 128 + interrupt.args[0], (
            "interrupted; %s/study.csv has what was solved; --force begins anew and keeps the "
            "references that are there" % sys.argv[2])
    except EpafiError as error:
        code, words = error.code, error.words
    except OSError as error:
        code, words = 1, "study: %s" % error
    print("epafi: " + words, file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
