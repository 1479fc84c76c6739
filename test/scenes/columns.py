"""Every column of every file stands on doc/columns.md, under the file's name.

    columns.py EPAFI SCENES WORK PAGE.md
"""
import csv
import os
import re
import sys

from runs import WORK, claim, epafi, finish, fresh, run, saved, scene

with open(sys.argv[4], encoding="utf-8") as stream:
    parts = re.split(r"^## ", stream.read(), flags=re.M)[1:]
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
