"""doc/columns.md: its tables are what the program says of its columns, and every column of every
file stands there, under the file's name.

    columns.py EPAFI SCENES WORK PAGE.md            --write: mends the page
"""
import csv
import json
import os
import re
import sys

from runs import WORK, claim, epafi, finish, fresh, run, saved, scene


def table(columns):
    """Columns that share a meaning stand in one row."""
    groups = []
    for column in columns:
        if groups and not column["meaning"] and not column["unit"]:
            groups[-1][0].append(column["name"])
        else:
            groups.append(([column["name"]], column["meaning"], column["unit"]))
    return "| column | holds | unit |\n|---|---|---|\n" + "".join("| %s | %s |%s |\n" % (
        ", ".join("`%s`" % name for name in names), meaning, unit and " " + unit)
        for names, meaning, unit in groups)


def written(page, columns):
    """The page with the tables of the program, each the last of its file's section."""
    parts = re.split(r"^(?=## )", page, flags=re.M)
    for k, part in enumerate(parts):
        file = re.search(r"\w+\.csv(?=\n)", part)
        if file and file[0] in columns:
            parts[k] = re.sub(r"\| column \| holds \| unit \|\n(\|.*\n)+",
                              lambda _: table(columns[file[0]]), part)
    return "".join(parts)


with open(sys.argv[4], encoding="utf-8") as stream:
    page = stream.read()
columns = json.loads(epafi("help", "--format", "json")[1])["columns"]
now = written(page, columns)
if "--write" in sys.argv:
    with open(sys.argv[4], "w", encoding="utf-8") as stream:
        stream.write(now)
claim(now == page, "the tables of the page; --write mends them")
parts = re.split(r"^## ", page, flags=re.M)[1:]
known = {}
for part in parts:
    head, text = part.split("\n", 1)
    for name in re.findall(r"\w+\.csv", head):
        known[name] = set(re.findall(r"`([^`]+)`", text))
known["study.csv"] |= known["history.csv"]

ONE = ["Adaptivity->Maximum Levels=1"]
run(scene("two-blocks.xml"), "bodies", ONE)
run(scene("fretting.xml"), "path", ["History->Times={1, 2}", "History->Steps=1"])
run(scene("patch.xml"), "patch", ONE)
epafi("fields", os.path.join(WORK, "patch"), "--grid", "2,2")
study = saved("study", {"Scenes": {"s": {"File": os.path.abspath(scene("patch.xml"))}},
                        "Variants": {"v": {"Set": ONE}}})
claim(epafi("study", study, "--quiet", "--no-plot", "--output", fresh("study"))[0] == 0, "a study")

met = set()
for folder, _, files in os.walk(WORK):
    for name in files:
        if not name.endswith(".csv"):
            continue
        with open(os.path.join(folder, name), newline="") as stream:
            columns = next(csv.reader(stream))
        unknown = [c for c in columns if c not in known.get(name, ()) and
                   not {"<contact>." + c.split(".")[-1], "<body>." + c.split(".")[-1]} & known[name]]
        claim(not unknown, "%s in %s: not on the page: %s" % (
            name, os.path.relpath(folder, WORK), unknown))
        met.add(name)
claim(met == set(known), "every file was met: %s" % sorted(set(known) ^ met))
finish()
