"""Either side of a contact may come first: solutions differ by less than the sum of their
estimated errors, and by what the direction of the gap says (doc/benchmarks/bodies.md).

With a fourth argument, all: every shipped scene, and moduli up to 1 : 1000."""
import os
import sys

from runs import claim, epafi, finish, fresh, keys_of, saved, scene, table
from written import keys, listed, with_moduli, with_sides_swapped, without_friction

# With an effectivity near 3 two errors that add up are a third of the sum.
SHARE = 0.4
# sides that do not coincide: of the order a/R, relative to the solution
DIRECTION = {"two-cylinders": 2e-3, "cylinder-on-block": 2e-3}


def pair(name, whole, levels):
    """A scene whose reference is the same with its sides swapped."""
    return listed(name, File=saved(name, whole), Reference={"Set": [levels, *(
        "Contacts->%s->Between={%s, %s}" % (contact, *keys["Between"])
        for contact, keys in with_sides_swapped(whole)["Contacts"].items())]})


def compare(scenes, count):
    """The energy norm of the differences, on `count` levels of all."""
    levels = "Adaptivity->Maximum Levels=%d" % count
    study = saved("study", keys(listed("Scenes", *(
        pair(name, whole, levels) for name, whole in scenes.items())),
        listed("Variants", first={"Set": [levels]})), "Swapped")
    folder = fresh("study")
    code, printed = epafi("study", study, "--output", folder, "--quiet", "--no-plot")
    claim(code == 0, "all are solved on %d levels %s" % (count, printed if code else ""))
    rows = table(os.path.join(folder, "study.csv"))
    for name in scenes:
        row, other = ([row for row in rows if (row["scene"], row["variant"]) == (name, variant)][-1]
                      for variant in ("first", "reference"))
        difference = row["estimate"] / row["effectivity"]
        both = row["estimate"] + other["estimate"]
        direction = DIRECTION.get(name, 0) * difference / row["error"]
        claim(difference < SHARE * both + direction,
              "%s: sides differ by %.2f of the sum of the estimates, by %.1e of the solution" % (
                  name, difference / both, row["error"]))


every = sys.argv[4:] == ["all"]
scenes = {}
for name in ("two-blocks", "cylinder-on-block", "dovetail", "incline", "press-fit",
             "ring-on-disc", "bonded-inclusion", "two-cylinders") if every else (
                 "two-blocks", "cylinder-on-block"):
    drawn = keys_of(scene(name + ".xml"))
    for ratio in (1, 10, 1000, 0.001) if every else (1, 1000):
        scenes["%s, moduli 1 : %g" % (name, ratio)] = (
            drawn if ratio == 1 else with_moduli(drawn, ratio))
    if name == "incline":
        scenes[name + ", moduli 1 : 1000, without friction"] = without_friction(
            with_moduli(drawn, 1000))
compare(scenes, 4)
if every:
    compare({name: whole for name, whole in scenes.items()
             if name.startswith(("two-blocks", "incline"))}, 8)
finish()
