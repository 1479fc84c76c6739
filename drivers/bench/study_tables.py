#!/usr/bin/env python3
"""Runs the studies behind doc/benchmarks and writes their tables and the picture.

    study_tables.py EPAFI [--study work-precision] [--study ablation] [--study stabilization]
                    [--study paths] [--output DIR] [--threads N] [--tables-only]

Without --study all.  A study goes to DIR/<name>; with --tables-only that of an earlier run is
read.  Between the lines "<!-- table NAME -->" and "<!-- end -->" of README.md and
doc/benchmarks/*.md the tables are replaced; pictures are copied to doc/benchmarks.

A cell says what the first level took whose relative error in the energy norm is at most the
column's: degrees of freedom (displacement and contact stress) and CPU seconds of all threads,
all levels before it and the estimates included.
"""
import argparse
import csv
import os
import re
import shutil
import subprocess

ROOT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..")
BENCHMARKS = os.path.join(ROOT, "doc", "benchmarks")


class Study:
    """study.csv: its scenes, its variants in the order of the file, their counted levels."""

    def __init__(self, folder):
        with open(os.path.join(folder, "study.csv"), newline="") as file:
            self.rows = list(csv.DictReader(file))
        self.scenes = unique(row["scene"] for row in self.rows)
        self.variants = unique(row["variant"] for row in self.rows
                               if row["variant"] != "reference")

    def levels(self, scene, variant):
        return [row for row in self.rows if row["scene"] == scene
                and row["variant"] == variant and row["counted"] == "1"]

    def first(self, scene, variant, bound, column="error"):
        """The first level with an error at most `bound`, or None."""
        return next((row for row in self.levels(scene, variant)
                     if float(row[column]) <= bound), None)

    def dof(self, scene, variant, bound):
        level = self.first(scene, variant, bound)
        return "-" if level is None else level["dof"]

    def pairs(self, kind):
        """Scenes with those of their variants that have that strategy in their names, and how a
        table calls both."""
        return {scene + ", " + variant.replace(", " + kind, ""): (scene, variant)
                for scene in self.scenes for variant in self.variants if kind in variant}


def unique(names):
    return list(dict.fromkeys(names))


def told(bound):
    return ("%.0e" % bound).replace("e-0", "e-")


def markdown(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def append(file, rows):
    """Rows, dictionaries, below those of a csv file, which begins with their names."""
    with open(file, "a", newline="") as stream:
        writer = csv.DictWriter(stream, list(rows[0]))
        if stream.tell() == 0:
            writer.writeheader()
        writer.writerows(rows)


def work_table(study, bounds, column="error"):
    def work(level):
        return "-" if level is None else "%s, %.2f s" % (level["dof"], float(level["seconds_total"]))

    return "\n\n".join(markdown([scene, *map(told, bounds)], [
        [variant, *(work(study.first(scene, variant, bound, column)) for bound in bounds)]
        for variant in study.variants if study.levels(scene, variant)]) for scene in study.scenes)


def effectivity_table(study):
    def band(scene, variant):
        values = [float(row["effectivity"]) for row in study.levels(scene, variant)]
        if not values:
            return "-"
        outside = sum(value < 1.5 or value > 4.5 for value in values)
        return "%.3g .. %.3g (%d of %d)" % (min(values), max(values), outside, len(values))

    return markdown(["estimate over true error, levels outside 1.5 .. 4.5", *study.scenes],
                    [[variant, *(band(scene, variant) for scene in study.scenes)]
                     for variant in study.variants])


def dof_table(study, variant, bounds):
    return markdown(["relative error", *(scene.split()[0] + ", unknowns" for scene in study.scenes)],
                    [[told(bound), *(study.dof(scene, variant, bound) for scene in study.scenes)]
                     for bound in bounds])


def reference_lines(study):
    return "\n".join(
        "* %s: reference with %s degrees of freedom, estimate %.1e (absolute); errors below ten "
        "times that do not count" % (row["scene"], row["dof"], float(row["estimate"]))
        for row in study.rows if row["variant"] == "reference")


def failure_lines(study):
    return "\n".join("* %s, %s, level %s: %s" % (row["scene"], row["variant"], row["level"],
                                                 row["reason"])
                     for row in study.rows if row["status"] in ("failed", "not converged")
                     ) or "No level failed."


def replace(path, tables):
    with open(path) as file:
        text = file.read()
    for name, table in tables.items():
        pattern = r"(<!-- table %s -->\n).*?(<!-- end -->)" % re.escape(name)
        text, count = re.subn(pattern, lambda m: m[1] + table + "\n" + m[2], text, flags=re.S)
        if count != 1:
            raise SystemExit("%s: %d tables named '%s' instead of one" % (path, count, name))
    with open(path, "w") as file:
        file.write(text)


def finest_table(study, kind):
    """The last level of the variants with that strategy in their names."""
    def numbers(rows):
        last = rows[-1]
        effectivity = [float(row["effectivity"]) for row in rows if row["effectivity"]]
        return [last["dof"], "%.2e" % float(last["error"]),
                "%.2e" % float(last["error_multiplier"]),
                "%.1f to %.1f" % (min(effectivity), max(effectivity)),
                "%d" % max(int(row["newton_iterations"]) for row in rows)]

    return markdown(["%s, finest mesh" % kind, "unknowns", "u, ψ", "λ",
                     "estimate / error, all levels", "Newton, most"],
                    [[name, *numbers(study.levels(*pair))]
                     for name, pair in study.pairs(kind).items() if study.levels(*pair)])


def reached_table(study, kind, bounds):
    """Unknowns of the first level below each bound."""
    return markdown(["%s, unknowns for an error of u, ψ of" % kind, *map(told, bounds)],
                    [[name, *(study.dof(*pair, bound) for bound in bounds)]
                     for name, pair in study.pairs(kind).items()])


def sweep_table(study):
    """Errors of u, psi and of lambda at each value of the swept key."""
    def cell(row):
        if row["status"] != "converged":
            return "fails"
        return "%.3g, %.3g" % (float(row["error"]), float(row["error_multiplier"]))

    swept = [row for row in study.rows if row["sweep_value"]]
    values = unique(row["sweep_value"] for row in swept)
    cells = {}
    for row in swept:
        name = row["scene"] + ", " + row["variant"].rsplit(", ", 1)[0].replace(", gamma0", "")
        cells.setdefault(name, {})[row["sweep_value"]] = cell(row)
    return markdown(["u, ψ and λ at γ₀ =", *("%g" % float(value) for value in values)],
                    [[name, *(row.get(value, "-") for value in values)]
                     for name, row in cells.items()])


# Of each study the tables of its page, and what is copied beside it as what.
PAGES = {
    "work-precision": lambda study: {
        "work": work_table(study, [1e-1, 1e-2, 1e-3, 1e-4, 1e-5]),
        "effectivity": effectivity_table(study)},
    "ablation": lambda study: {"work": work_table(study, [1e-3, 1e-4, 1e-5])},
    "stabilization": lambda study: {
        "uniform": "\n\n".join(finest_table(study, kind)
                               for kind in ("uniform h, p=1", "uniform h, p=2")),
        "graded": reached_table(study, "graded hp", [1e-3, 1e-4, 1e-5]),
        "sweep": sweep_table(study)},
    "path-errors": lambda study: {
        "energy": work_table(study, [1e-2, 1e-3, 1e-4, 1e-5], "error_path"),
        "pressure": work_table(study, [1e-1, 1e-2, 3e-3], "error_path_multiplier"),
        "friction": work_table(study, [1e-2, 1e-3, 1e-4], "error_path_friction")}}
PICTURES = {"work-precision": "work-precision.png", "path-errors": "path_time.png"}


def write(page, folder):
    study = Study(folder)
    tables = {**PAGES[page](study), "references": reference_lines(study)}
    if page != "stabilization":
        tables["failures"] = failure_lines(study)
    replace(os.path.join(BENCHMARKS, page + ".md"), tables)
    if page == "work-precision":
        replace(os.path.join(ROOT, "README.md"),
                {"unknowns": dof_table(study, "graded hp", [1e-3, 1e-4, 1e-5])})
    if page in PICTURES:
        shutil.copy(os.path.join(folder, PICTURES[page]), os.path.join(BENCHMARKS, page + ".png"))


PAGE_OF = {"work-precision": "work-precision", "ablation": "ablation",
           "stabilization": "stabilization", "paths": "path-errors"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("--study", action="append", choices=sorted(PAGE_OF))
    parser.add_argument("--output", default="studies.out")
    parser.add_argument("--threads", default="")
    parser.add_argument("--tables-only", action="store_true")
    arguments = parser.parse_args()
    environment = dict(os.environ)
    if arguments.threads:
        environment.update(OMP_NUM_THREADS=arguments.threads,
                           OPENBLAS_NUM_THREADS=arguments.threads)
    for name in arguments.study or sorted(PAGE_OF):
        folder = os.path.join(arguments.output, name)
        if not arguments.tables_only:
            study = os.path.join(ROOT, "drivers", "studies", name + ".xml")
            subprocess.run([arguments.epafi, "study", study, "--output", folder, "--force"],
                           check=True, env=environment)
        write(PAGE_OF[name], folder)


if __name__ == "__main__":
    main()
