"""Scenes and folders from somebody else: nothing of them is run, no file outside of a folder is
read or written.

    hostile.py EPAFI WORK
"""
import os
import shutil
import subprocess
import sys
import warnings

import h5py

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, raises, read, write  # noqa: E402

EPAFI, WORK = sys.argv[1], os.path.abspath(absent(sys.argv[2]))
import epafi  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)
os.makedirs(WORK)
SECRET = write(os.path.join(WORK, "secret"), "told to nobody")
TOUCHED = os.path.join(WORK, "touched")
NASTY = "../a\"b'c;$(touch %s)`touch %s`\n<script>&amp;%%s" % (TOUCHED, TOUCHED)

NAME = NASTY.replace("\n", "").replace(">", "")


def called(*words, cwd=WORK):
    done = subprocess.run([EPAFI, *words], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, cwd=cwd)
    return done.returncode, done.stdout


def untouched(sentence):
    """Claims that only folders named so by this test are there, and the secret as it was."""
    others = {name for name in os.listdir(WORK) if not name.startswith(("run", "study", "sweep"))}
    claim(others == {"secret"} and read(SECRET) == "told to nobody", "%s: %s" % (sentence, others))


def copied(name):
    """A folder of the run, to be spoiled."""
    folder = os.path.join(WORK, "run-" + name)
    shutil.rmtree(folder, ignore_errors=True)
    return shutil.copytree(RUN, folder, symlinks=True)


def refused(sentence, words, *command):
    code, text = called(*command)
    claim(code == 1 and all(word in text for word in words) and "told to" not in text and
          "Traceback" not in text, "%s: %d, %s" % (sentence, code, text.strip()[-300:]))
    untouched(sentence)


def block(name, x):
    return {"Material": {"Young's Modulus": 100.0, "Poisson's Ratio": 0.3},
            "Geometry": {"Vertices": [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1]],
                         "Edges": [name, "right", "top", "left"]},
            "Boundary Conditions": {
                name: {"Type": "Contact", "Friction": {"Law": "Coulomb", "Coefficient": 0.3}},
                "top": {"Type": "Neumann", "Traction Y": "-t", "Traction X": "t/10"}}}


# names of all kinds, in all commands
RUN = os.path.join(WORK, "run")
scene = epafi.Scene({"Bodies": {NAME: block(NAME, 0), "b": block("b", 3)},
                     "Discretization": {"Mesh Size": 0.5}, "History": {"Times": [0.5, 1.0]}},
                    title=NASTY)
run = epafi.run(scene, RUN, threads=1)
claim(run.scene.title == NASTY and list(run.scene["Bodies"]) == [NAME, "b"], "names stay as they are")
code, text = called("plot", RUN, "--field", "von_mises")
claim(code == 0, "it is drawn: " + text)
code, text = called("report", RUN)
page = read(os.path.join(RUN, "report.html"))
claim(code == 0 and "<script" not in page and "&lt;script&gt;" in page, "and reported: " + text)
run.intensities()
run.fatigue([[0.5, 0.5]], alpha=0.3)
epafi.sweep(scene, {"Bodies->b->Boundary Conditions->top->Traction X": ["t/9", "(t)/(../1)"]},
            os.path.join(WORK, "sweep"), jobs=1)
file = os.path.join(WORK, "run", "scene.xml")
scene.write(file)
study = os.path.join(WORK, "study.yaml")
write(study, """study:
  Scenes: {"../x;$(touch touched)": {File: run/scene.xml}}
  Variants:
    "../../v$(touch touched)": {}
    "<script>": {Sweep: {Key: "Discretization->Mesh Size", Values: ["0.5", "1"]}}
""")
code, text = called("study", study, "--threads", "1", "--output", "study.out")
claim(code == 0, "studied: " + text[-300:])
untouched("names are names")

# what a run's scene may not do
for entity in ('<!ENTITY e SYSTEM "file://%s">' % SECRET, '<!ENTITY a "%s"><!ENTITY e "%s">' % (
        "ha" * 1000, "&a;" * 1000)):
    folder = copied("entity")
    used = read(os.path.join(folder, "used.xml"))
    write(os.path.join(folder, "used.xml"), "<!DOCTYPE p [%s]>" % entity + used.replace(
        '"Plane Strain"', '"&e;"', 1).replace(' isDefault="true"', ""))
    refused("entities of XML", [], "report", folder)
folder = copied("file")
used = os.path.join(folder, "used.xml")
outside = epafi.Scene({"Bodies": {"b": {"Material": {"Young's Modulus": 1.0, "Poisson's Ratio": 0.3},
                                        "Geometry": {"File": SECRET}}},
                       "Discretization": {"Mesh Size": 1}})
outside.write(used)
for command in (["report", folder], ["check", used], ["run", used, "--output", "run-x"]):
    refused("a run's scene names no file", ["Bodies->b->Geometry->File", "names no other file"], *command)
with raises(epafi.InputError, "nor in Python", "names no other file"):
    epafi.Run(folder).numbers

# links out of a folder: neither read nor written
for link, there, command in (
        ("history.csv", SECRET, ["plot"]), ("contact.png", "../nowhere", ["plot"]),
        ("report.html", SECRET, ["report"]), ("scene.png", SECRET, ["report"]),
        ("used.xml", SECRET, ["report"]), ("steps", "..", ["fields", "--vtk", "--step", "all"]),
        ("solution.hdf", SECRET, ["fields"]), ("fields.csv", "../nowhere", ["fields"]),
        ("fields.vtu", SECRET, ["plot", "--field", "syy"])):
    folder = copied("link")
    place = os.path.join(folder, link)
    if os.path.exists(place):
        (shutil.rmtree if link == "steps" else os.remove)(place)
    os.symlink(there, place)
    refused("a link %s" % link, ["out of its folder"], command[0], folder, *command[1:])
for link in (".used.xml.part", ".epafi.probe", ".history.csv.part"):
    folder = copied("part")
    os.symlink(SECRET, os.path.join(folder, link))
    called("run", file, "--output", folder, "--force", "--quiet", "--threads", "1")
    untouched("a link %s" % link)
folder = copied("inside")  # within a folder they may stand
os.rename(os.path.join(folder, "contact.csv"), os.path.join(folder, "own.csv"))
os.symlink("own.csv", os.path.join(folder, "contact.csv"))
claim(called("plot", folder)[0] == 0, "a link that stays in its folder is followed")

# what HDF5 takes from other files
grid = "VTKHDF/PointData/displacement"
for kind in ("link", "external", "virtual"):
    folder = copied(kind)
    with h5py.File(os.path.join(folder, "solution.hdf"), "r+") as data:
        values = data[grid][()]
        names = [grid]
        data.visititems(lambda name, item: names.append(name) if isinstance(
            item, h5py.Dataset) and item.dtype == float and item.size > 9 else None)
        for name in names:
            values = data[name][()]
            del data[name]
            if kind == "link":
                data[name] = h5py.ExternalLink(os.path.join(RUN, "solution.hdf"), name)
            elif kind == "external":
                data.create_dataset(name, values.shape, float, external=[(SECRET, 0, values.nbytes)])
            else:
                layout = h5py.VirtualLayout(values.shape, float)
                layout[...] = h5py.VirtualSource(os.path.join(RUN, "solution.hdf"), name, values.shape)
                data.create_virtual_dataset(name, layout)
    refused("HDF5: " + kind, ["solution.hdf"], "fields", folder)
    with raises(epafi.InputError, "HDF5 in Python: " + kind, "is not in the file"):
        epafi.Run(folder).solution

# tables that name folders, a style that calls LaTeX
folder = os.path.join(WORK, "study-spoiled")
shutil.copytree(os.path.join(WORK, "study.out"), folder)
table = os.path.join(folder, "study.csv")
write(table, read(table).replace("sweep/", "../run/../"))
refused("a study's table", ["out of its folder"], "plot", folder)
folder = copied("style")
write(os.path.join(folder, "matplotlibrc"), "text.usetex: True\ntext.latex.preamble: \\nothing\n")
code, text = called("plot", ".", cwd=folder)
claim(code == 0, "a style in the folder calls no LaTeX: " + text)
# texts of tables in a page
folder = copied("table")
history = os.path.join(folder, "history.csv")
write(history, read(history).replace("converged", "<script>alert(1)</script>"))
code, text = called("report", folder)
claim("<script" not in read(os.path.join(folder, "report.html")), "texts of tables are no HTML")
untouched("all of it")
finish()
