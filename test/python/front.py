"""The Python front: scenes there and back, what is refused, runs, failures, sweeps, types.

    front.py EPAFI WORK
"""
import inspect
import json
import math
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
import types
import typing

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import claim, finish, raises, write  # noqa: E402

EPAFI, WORK = sys.argv[1:]
shutil.rmtree(WORK, ignore_errors=True)
os.makedirs(WORK)
import epafi  # noqa: E402
from epafi import program  # noqa: E402

SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers", "scenes")
FRICTION = "Bodies->block->Boundary Conditions->foundation->Friction"
claim(os.path.samefile(program.program(), EPAFI), "the program beside the package is found")
claim(list(epafi.version()) == ["Epafi", "Trilinos", "MPI", "BLAS core"],
      "and says its version: %s" % epafi.version())

# every shipped scene: read, written and read again, it is the same; and the program's own reading
for name in sorted(os.listdir(SHIPPED)):
    scene = epafi.Scene.read(os.path.join(SHIPPED, name))
    copy = os.path.join(WORK, name)
    scene.write(copy)
    again = epafi.Scene.read(copy)
    claim(again == scene and again.title == scene.title, name + ": there and back")

    def told(file):
        lines = subprocess.run([EPAFI, "check", file], stdout=subprocess.PIPE, text=True,
                               check=True).stdout.splitlines()
        return [lines[0].split(" (")[0], *lines[1:]]
    claim(told(copy) == told(os.path.join(SHIPPED, name)) and "The scene is valid." in told(copy),
          name + ": the program reads the same, a valid scene")

patch = epafi.Scene.read(os.path.join(SHIPPED, "patch.xml"))
for name, after, value in (("patch.yaml", "", None), ("patch.YAML", "0500", 500)):
    text = json.dumps({"Contact patch test": patch})
    key = "Young's Modulus\": "
    begin = text.index(key) + len(key)
    if value:
        text = text[:begin] + after + text[text.index(",", begin):]
    file = write(os.path.join(WORK, name), text)
    body, = epafi.Scene.read(file)["Bodies"].values()
    claim(body["Material"]["Young's Modulus"] == value if value else
          epafi.Scene.read(file) == patch, name + ": YAML is read as the program reads it")
FLAG = '<ParameterList name="a"><Parameter name="b" type="bool" value="%s"/></ParameterList>'
for name, text, words in (
        ("twice.yaml", "a:\n  Bodies: {}\n  Bodies: {}\n", "Bodies: given twice"),
        ("flag.xml", FLAG % "True", "b: 'True'"),
        ("number.xml", FLAG.replace("bool", "double") % "1,5", "b: '1,5'"),
        ("twice.xml", FLAG.replace("><P", "><Parameter name='b' type='int' value='1'/><P") % "true",
         "b: given twice"),
        ("none.xml", None, "none.xml")):
    file = os.path.join(WORK, name)
    if text:
        write(file, text)
    with raises(epafi.InputError, name + " is refused", words):
        epafi.Scene.read(file)
coulomb = epafi.Scene.read(os.path.join(SHIPPED, "coulomb.xml")).changed(
    {"Adaptivity->Maximum Levels": 2})
for settings, words in [
        ({"Adaptivity->Maximum Levls": 3}, ["Adaptivity->Maximum Levls: unknown", "'Maximum Levels'"]),
        ({"Foo": {}}, ["Foo: unknown"]),
        ({"Discretization->Degree": 1.5}, ["Discretization->Degree: is 1.5", "integer"]),
        ({"Discretization->Degree": True}, ["Discretization->Degree", "integer"]),
        ({"Output->Fields": 1}, ["boolean"]),
        ({FRICTION + "->Law": "Coulom"}, ["allowed", "'Coulomb'"]),
        ({"Bodies->block->Geometry->Vertices": [[0, 0, 1]] * 4}, ["2 coordinates"]),
        ({"Bodies->block->Geometry->Vertices": [[0, 0], [1]]}, ["entry 1 is not an array of 2 numbers"]),
        ({"Output->Nothing": None}, ["cannot be removed"]),
        ({"Constants": {"f": 1}, "Constants->f->g": 1}, ["Constants->f->g", "'f' is a value"]),
        ({"Discretization->Degree": 99}, ["Discretization->Degree = 99", "from 1 to 25"])]:
    with raises(epafi.InputError, "%s is refused" % settings, *words, absent=["/tmp"]):
        epafi.run(coulomb, set=settings)
claim(issubclass(epafi.InputError, ValueError), "as a ValueError")

# a run is what the program does; numpy's arrays and numbers are taken
folder = os.path.join(WORK, "run")
lines = []
vertices = np.array(coulomb["Bodies"]["block"]["Geometry"]["Vertices"])
run = epafi.run(coulomb, folder, set={"Bodies->block->Geometry->Vertices": vertices,
                                      "Discretization->Degree": np.int64(1)},
                threads=1, progress=lines.append)
claim(run.history.size == 2 and run.converged and "ended" in "".join(lines),
      "a run of two levels, with its lines")
claim(abs(run.history["force_normal"][-1] - 0.125) < 1e-12, "the load is carried")
claim(run.contact["lambda_n"].shape == (run.contact.size,) and
      run.contact["boundary"][0] == "foundation", "columns are arrays of numbers or of texts")
claim(run.scene["Adaptivity"]["Weights"] == "Energy", "the scene used has its defaults")
claim("Epafi" in run.solution, "solution.hdf is open")
points = np.array([[0, 0.1], [0.2, -0.3]])
inside = run.fields(points)
claim(np.allclose(np.column_stack([inside["x"], inside["y"]]), points, atol=0) and
      np.isfinite(inside["von_mises"]).all(), "fields at points")
cells = run.fields(grid=(4, 3), window=(-0.25, -0.5, 0.25, 0))
claim(cells.size == 12 and abs(cells["x"]).max() < 0.25 and cells["y"].max() < 0, "of a window")
with raises(KeyError, "an unknown column names the nearest", "'force_normal'"):
    run.history["force_norml"]
with raises(KeyError, "a row is no column", "no column -1; columns: level"):
    run.history[-1]
claim(list(dict(run.history)) == [*run.history] == list(run.history.columns) and
      len(run.history) == 2, "a table has the names of its columns, and its length is that of these")
page = run._repr_html_()
claim(page.count("<tr>") == 3 and "force_normal" in page and "data:image/png;base64," in page,
      "a notebook shows a table and a picture of a run")
try:
    import pandas  # noqa: F401

    claim(run.history.frame()["dof"].tolist() == run.history["dof"].tolist(), "frames of pandas")
except ImportError:
    print("pandas is not here: frames not tried")

# everything but pictures without matplotlib and h5py
SCRIPT = """import sys
sys.modules["matplotlib"] = sys.modules["h5py"] = sys.modules["pandas"] = None  # cannot be imported
import epafi
run = epafi.Run(sys.argv[1])
assert run._repr_html_().endswith("</table>") and run.contact.size and run.fields(grid=(2, 2)).size
try:
    run.plot()
except ImportError:
    print("usable")"""
done = subprocess.run([sys.executable, "-c", SCRIPT, folder], stdout=subprocess.PIPE, text=True)
claim(done.stdout == "usable\n", "matplotlib is wanted by pictures only")
import matplotlib  # noqa: E402

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

pictures = run.pictures("syy")
claim([os.path.basename(file) for file in pictures] == [
    "convergence.png", "deformed.png", "contact.png", "syy.png"] and all(os.path.getsize(file) > 5000 for file in pictures),
      "pictures are drawn")
claim(matplotlib.rcParams["axes.grid"] == matplotlib.rcParamsDefault["axes.grid"],
      "and leave matplotlib's style alone")
figure, axes = run.plot("contact", units="mm,MPa")
claim(len(axes) == 2 and axes[0].get_ylabel() == "contact stress [MPa]" and
      axes[0].figure is figure, "a picture is a figure and its axes")
from epafi.plot.figures import COLOURS  # noqa: E402

own, panels = plt.subplots(1, 3)
for drawn in (axes[0], run.plot("deformed")[1], run.plot("convergence")[1],
              run.plot("convergence", axes=panels[1])[1]):
    colours = {matplotlib.colors.to_hex(line.get_color()).upper() for line in drawn.lines}
    claim(colours - {"#808080"} <= set(COLOURS), "its colours are the palette's: %s" % colours)
figure, axes = run.plot("syy", window=(-0.25, -0.5, 0.25, 0), axes=panels[0])
claim(figure is own and axes is panels[0] and axes.get_images()[0].get_clip_path() is not None,
      "it goes into axes of one's own; a window of a field ends at the outline")
for wrong, what, words in ((ValueError, "contact", "2 axes"),
                           (epafi.InputError, "contakt", "'contact'"),
                           (epafi.InputError, "path", "nothing for")):
    with raises(wrong, what + " is refused", words):
        run.plot(what, axes=panels if what == "contact" else None)
claim([text.get_text() for text in run.plot("temperature")[1].texts] ==
      ["temperature is 0 everywhere"] and not run.plot("syy")[1].texts, "a field of zeros says so")
plt.close("all")

# a fit: arcs are arcs, rounding is no picture, torque over twist
turned = epafi.Scene.read(os.path.join(SHIPPED, "rotating-fit.xml")).changed({
    "Body Loads": None, "Bodies->hub->Rigid Motions": None, "Bodies->ring->Rigid Motions": None,
    "Bodies->hub->Boundary Conditions": {"bore": {
        "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}},
    "Bodies->ring->Boundary Conditions": {"outside": {
        "Type": "Dirichlet", "Displacement X": "-1e-4*t*y", "Displacement Y": "1e-4*t*x"}},
    "Contacts->fit->Friction": {"Law": "Coulomb", "Coefficient": 0.3},
    "Adaptivity->Maximum Levels": 1, "Discretization->Degree": 2,
    "History": {"Times": [1, 2], "Steps": [1, 1]}})
fit = epafi.run(turned)
figure, axes = fit.plot("path")
twist, torque = axes[2].lines[0].get_data()
shear = 20 * fit.steps["fit.force_tangential"]  # the circle's radius
claim(len(twist) == 3 and 0 < twist[1] < twist[2] < 2e-4 and
      np.allclose(torque[1:], -shear, rtol=1e-2), "torque %g over twist %g" % (torque[2], twist[2]))
work = axes[1].get_ylim()
claim(work[1] - work[0] > 0.1 * fit.steps["energy_strain"].max() and
      fit.steps["energy_dissipated"].max() < 1e-9 * fit.steps["energy_strain"].max(),
      "work that is rounding is drawn as a line")
plt.close("all")
from epafi.plot.boundary import Boundary  # noqa: E402
from epafi.plot.deformed import scale_of  # noqa: E402

places = np.concatenate([element["x"] for element in Boundary(fit.boundary).elements])
radii = np.hypot(*places.T)
claim(len(places) > 2 * fit.boundary.size and
      max(abs(radii - r).min() for r in (10, 20, 30)) < 1e-9 and
      all(min(abs(radius - r) for r in (10, 20, 30)) < 1e-9 for radius in radii),
      "arcs are drawn as arcs")
shifts = np.array([[1e-4, 0.0]])
scale = scale_of(60, shifts, fit.contact)
claim(scale_of(60, shifts, None) > 1e4 and 1 < scale and (scale - 1) * 0.01 < 0.3,
      "gaps that close limit the scale of displacements to %g" % scale)
from epafi.plot.layout import places  # noqa: E402

both = epafi.Table.__new__(epafi.Table)  # two boundaries, each touching over a tenth
x, half = np.linspace(0, 1, 101), np.repeat(["left", "right"], 101)
both.columns = {"x": np.concatenate([x, x + 2]), "y": np.zeros(202), "boundary": half,
                "element": np.repeat([1.0, 5.0], 101),
                "contact": (abs(np.tile(x, 2) - 0.5) < 0.051).astype(float)}
shown = [(label, s.min(), s.max()) for _, s, label, _ in places(both)]
windows = [pair[1:] for pair in shown]
claim(len(shown) == 2 and np.allclose(windows, [[0.35, 0.65], [2.35, 2.65]], atol=0.02) and
      len(places(run.contact)) == 1, "small places are drawn side by side: %s" % shown)
# a block that wears by k p s, s = t - 1: in each of two steps by a tenth of the pressure then
worn = epafi.run({"Bodies": {"block": {
    "Material": {"Young's Modulus": 1.0, "Poisson's Ratio": 0.0},
    "Geometry": {"Vertices": [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
                 "Edges": ["bottom", "right", "top", "left"]},
    "Rigid Motions": {"Fix": ["X"]},
    "Boundary Conditions": {
        "top": {"Type": "Dirichlet", "Displacement Y": "-0.01"},
        "bottom": {"Type": "Contact", "Sliding": "max(0, t-1)", "Wear": {"Coefficient": "0.1"}}}}},
    "History": {"Times": [1.0, 3.0], "Steps": [1, 2]}, "Discretization": {"Mesh Size": 0.5}})
depth = worn.profiles("worn_depth", "bottom")
exact = 0.01 * (1 - 1.1 ** -np.arange(3.0))
claim(depth.shape == (3, worn.contact.size) and np.allclose(depth, exact[:, None], atol=1e-12) and
      np.allclose(worn.steps["cycles"], [1, 2, 3]), "worn profiles over the steps of a path")


def at_samples(curve):
    """Of what is drawn on each element, between the samples, too."""
    return curve.reshape(-1, 15)[:, ::2].ravel()


figure, axes = worn.plot("contact", step=1)
title = worn.plot("syy", step=1)[1].get_title()
plt.close("all")
claim(np.allclose(at_samples(axes[0].lines[0].get_ydata()), worn.step(1)["pressure"], atol=0) and
      worn.step(1)["lambda_n"][0] > 1.05 * worn.contact["lambda_n"][0] and
      "t = 1" in figure.texts[0].get_text() and "t = 1" in title, "a step of a path is drawn, with its t")
# pressed, then let go: what is left of the last step is rounding
idle = epafi.run(worn.scene.changed({
    "Bodies->block->Boundary Conditions->top->Displacement Y": "-0.01*min(t, 2 - t)",
    "Bodies->block->Boundary Conditions->bottom": {"Type": "Contact"},
    "History": {"Times": [1.0, 2.0]}}), os.path.join(WORK, "idle"))
_, axes = idle.plot("contact")
titles = [axes[0].figure.texts[0].get_text(), *(idle.plot(what)[1].get_title() for what in (
    "deformed", "syy"))]
along = idle.plot("path")[1]
claim(len(along) == 2 and np.allclose(along[1].lines[0].get_xydata(), np.column_stack([
    idle.steps["bottom.force_normal"], idle.steps["bottom.contact_length"]])),
      "without friction the length in contact is drawn over the force")
outline = idle.plot("deformed")[1].lines[1].get_xydata()
plt.close("all")
claim(np.allclose(at_samples(axes[0].lines[0].get_ydata()), idle.step(1)["pressure"], atol=0) and
      np.ptp(outline[:, 1]) < 0.99 and all("t = 1" in title for title in titles),
      "the step of the largest energy is drawn: %s" % titles)
outline = idle.plot("deformed", step=2)[1].lines[1].get_xydata()
claim(abs(np.ptp(outline[:, 1]) - 1) < 1e-9, "and any other at will")
# the same points of a closed line, touching around its ends and everywhere
from epafi.plot.overlay import figure_of  # noqa: E402

angle = np.linspace(0, 2 * math.pi, 65)[:-1]
around = [epafi.Table.of({
    "x": np.cos(angle), "y": np.sin(angle), "boundary": np.repeat("rim", 64),
    "element": np.arange(64.0), "contact": closed.astype(float), "pressure": 1 + angle,
    "shear": 0 * angle}) for closed in (np.cos(angle) > 0.5, angle > -1, np.cos(angle) > 2)]
lines = [line.get_xydata() for line in figure_of(around, "abc")[1].lines]
plt.close("all")
claim(all((line[np.argsort(line[:, 1]), 0] == lines[0][np.argsort(lines[0][:, 1]), 0]).all()
          for line in lines) and len(lines) == 3, "a point has one place in all steps")
for words, slip in (
        ("takes no step", lambda: worn.plot("mesh", step=1)),
        ("takes no window", lambda: worn.plot("contact", window=(0, 0, 1, 1))),
        ("steps 1 to 3", lambda: worn.pictures(step=4)),
        ("'body:boundary'", lambda: worn.fatigue("bottom", alpha=0.3, depth=0.1)),
        ("'10' is not NX,NY", lambda: worn.fields(grid=10)),
        ("'3.7' is not a whole", lambda: worn.fields(grid=(3.7, 3))),
        ("x0, y0, x1, y1", lambda: worn.plot("syy", window=(0, 0, 1))),
        ("x0, y0, x1, y1", lambda: worn.plot("deformed", window=(1, 0, 0, 1))),
        ("(width, height)", lambda: worn.plot("contact", size=3)),
        ("shape (n, 2)", lambda: worn.fields([[0.1, 0.2, 0.3], [0.4, 0.5, 0.6]])),
        ("end with .xml", lambda: worn.scene.write(os.path.join(WORK, "written.json"))),
        ("LENGTH,STRESS", lambda: worn.plot("contact", units="mm")),
        ("'bottom'", lambda: worn.profiles("worn_depth", "botom")),
        ("steps 1 to 3", lambda: worn.step(4)),
        ("steps 1 to 3", lambda: worn.step(1.0)),
        ("size: (0, 1)", lambda: worn.plot("contact", size=(0, 1))),
        ("dpi: 'x'", lambda: worn.plot("contact", dpi="x")),
        ("alpha: nan", lambda: worn.fatigue("bottom", alpha=math.nan)),
        ("alpha: 'x'", lambda: worn.fatigue("bottom", alpha="x")),
        ("'von_mises'", lambda: worn.pictures("von_mise")),
        ("a list of values", lambda: epafi.sweep(worn.scene, {"Discretization->Degree": "2"})),
        ("has no values", lambda: epafi.sweep(worn.scene, {"Discretization->Degree": []})),
        ("at least 1", lambda: epafi.sweep(worn.scene, {"Discretization->Degree": [2]}, jobs=0))):
    with raises(epafi.InputError, "a slip is noticed", words):
        slip()
with raises(epafi.InputError, "a run without a path has no steps", "steps.csv", "no History"):
    run.steps
more = epafi.run(coulomb, restart=run, set={"Adaptivity->Maximum Levels": 3})
claim(more.history.size == 3, "a run goes on")
temporary = more.folder
del more
claim(not os.path.exists(temporary), "a run without a folder leaves none")

# a relative folder stays that folder, and nothing is left open
SCRIPT = """import epafi, os, sys, warnings
warnings.simplefilter("ignore", epafi.EpafiWarning)  # of a coarse mesh
scene = epafi.Scene.read(sys.argv[1])
run = epafi.run(scene, "relative", set={"Adaptivity->Maximum Levels": 1})
os.chdir("/")
assert run.contact.size and run.fields(grid=(2, 2)).size
try:
    epafi.run(scene, set={"Discretization->Degree": 99})
except epafi.InputError:
    print("refused")"""
done = subprocess.run([sys.executable, "-X", "dev", "-W", "error::ResourceWarning", "-c", SCRIPT,
                       os.path.join(SHIPPED, "coulomb.xml")], stdout=subprocess.PIPE,
                      stderr=subprocess.STDOUT, text=True, cwd=WORK)
claim(done.stdout == "refused\n", "a relative folder, no warning: " + done.stdout)
with raises(epafi.InputError, "an earlier run is not overwritten", "force=True replaces",
            "restart goes on", "output goes elsewhere", absent=["--"]):
    epafi.run(coulomb, folder)
FIXED_POINT = {"Solver->Coulomb Iteration": "Fixed Point"}
with raises(epafi.NotConverged, "one update is not enough") as caught:
    epafi.run(coulomb, set={**FIXED_POINT, "Solver->Coulomb Maximum Iterations": 1})
claim(caught[0].code == 3 and not caught[0].run.converged and caught[0].run.history.size == 1,
      "what does not converge is an exception with a run")

# sweeps: an array in the parameters' shape, failures among them
sweep = epafi.sweep(coulomb, {"Discretization->Degree": [1, 2],
                              FRICTION + "->Coefficient": [0, 0.2, 0.4]},
                    os.path.join(WORK, "sweep"))
single = epafi.run(coulomb, set={"Discretization->Degree": 2, FRICTION + "->Coefficient": 0.4})
table = str(sweep).splitlines()
claim(len(table) == 7 and table[0].split()[:2] == ["Degree", "Coefficient"] and
      table[6].split()[:2] == ["2", "0.4"] and table[6].endswith("converged"),
      "a sweep prints as a table:\n" + str(sweep))
claim(sweep._repr_html_().count("<tr>") == 7 and "data:image" in sweep._repr_html_(),
      "in a notebook with a picture")
claim(abs(epafi.sweep(coulomb, {FRICTION + "->Coefficient": [0.2, 0.4]}, jobs=1)["energy_strain"]
          / sweep["energy_strain"][0, 1:] - 1).max() < 1e-9, "cases are alike one after the other")
with raises(epafi.InputError, "one place at a time", "one of grid, points and along", absent=["--"]):
    run.fields(points, grid=(2, 2))
with raises(epafi.InputError, "an earlier sweep is not overwritten", "force"):
    epafi.sweep(coulomb, sweep.parameters, os.path.join(WORK, "sweep"))
high = vertices * [1, 2]
shapes = epafi.sweep(coulomb, {"Bodies->block->Geometry->Vertices": (v for v in (vertices, high))},
                     os.path.join(WORK, "shapes"))
claim(sorted(os.listdir(os.path.join(WORK, "shapes"))) == ["01_#1", "02_#2"] and
      [line.split()[0] for line in str(shapes).splitlines()] == ["Vertices", "#1", "#2"] and
      [text.get_text() for text in shapes.plot()[1][0].get_legend().get_texts()] ==
      ["Vertices = #1", "Vertices = #2"], "arrays have numbers in a sweep:\n%s" % shapes)
with raises(epafi.InputError, "an unknown constant is refused", "no such constant; did you mean 'load'"):
    epafi.sweep(coulomb.changed({"Constants": {"load": 1}}), {"Constants->lod": [1]})
with raises(epafi.InputError, "an unknown constant is refused", "no such constant"):
    epafi.sweep(coulomb, {"Constants->f": [1]})
with raises(KeyError, "an unknown column of a sweep names the nearest", "'contact_length'"):
    sweep["contact_lenght"]
claim(sweep["energy_strain"].shape == (2, 3) and
      sweep["energy_strain"][1, 2] == single.history["energy_strain"][-1],
      "a case of a sweep is a run")
claim(abs(sweep["energy_friction"][:, 0]).max() == 0 < sweep["energy_friction"][:, 1:].min(),
      "only friction dissipates")
sweep.plot(os.path.join(WORK, "overlay.png"))
claim(os.path.getsize(os.path.join(WORK, "overlay.png")) > 5000, "stresses are overlaid")
failing = epafi.sweep(coulomb.changed(FIXED_POINT),
                      {"Solver->Coulomb Maximum Iterations": [1, 100]})
claim(np.isnan(failing["dof"][0]) and failing["dof"][1] > 0 and
      isinstance(failing.cases[0].error, epafi.NotConverged), "one that fails does not end it")

# an interrupt reaches the program
long = coulomb.changed({"Adaptivity->Strategy": "Uniform h", "Adaptivity->Maximum Levels": 30,
                        "Adaptivity->Maximum Degrees of Freedom": 10**6})


def interrupt():
    while not os.path.exists(os.path.join(WORK, "long", "history.csv")):
        time.sleep(0.05)
    time.sleep(0.5)
    os.kill(os.getpid(), signal.SIGINT)


threading.Thread(target=interrupt).start()
with raises(KeyboardInterrupt, "an interrupt ends a run"):
    epafi.run(long, os.path.join(WORK, "long"))
claim(epafi.Run(os.path.join(WORK, "long")).history.size > 0, "and keeps levels")

began = time.monotonic()
threading.Timer(2, os.kill, (os.getpid(), signal.SIGINT)).start()
with raises(KeyboardInterrupt, "an interrupt ends a sweep"):
    epafi.sweep(long, {"Discretization->Degree": [1, 2, 3]}, os.path.join(WORK, "longs"), jobs=2)
claim(len(os.listdir(os.path.join(WORK, "longs"))) == 2 and not program.RUNNING and
      not any(thread.name.startswith("ThreadPool") for thread in threading.enumerate()),
      "and its runs, after %.0f s" % (time.monotonic() - began))

# Ctrl-C in a terminal, which signals the program's whole group, as well
SCRIPT = """import epafi, sys
scene = epafi.Scene.read(sys.argv[1])
epafi.run(scene, sys.argv[2])"""
small = coulomb.changed({"Adaptivity->Maximum Levels": 1000, "Adaptivity->Marking Fraction": 0.02,
                         "Adaptivity->Strategy": "Adaptive h"})
small.write(os.path.join(WORK, "small.xml"))  # phases of far less than its second of grace
folder = os.path.join(WORK, "terminal")
process = subprocess.Popen([sys.executable, "-c", SCRIPT, os.path.join(WORK, "small.xml"), folder],
                           start_new_session=True, stderr=subprocess.DEVNULL)
while not os.path.exists(os.path.join(folder, "history.csv")):
    time.sleep(0.05)
time.sleep(0.5)
os.killpg(process.pid, signal.SIGINT)
process.wait()
claim(os.path.isfile(os.path.join(folder, "timings.txt")),
      "Ctrl-C in a terminal lets the program write what it has")

# a table's file is looked for beside the scene
write(os.path.join(WORK, "profile.csv"), "-10, 0\n10, 0\n")
beside = epafi.Scene({**coulomb, "Tables": {"profile": {"File": "profile.csv"}}}, folder=WORK)
claim(beside.check(), "a table has its file beside the scene")

# everything that is public is documented and typed
for name in epafi.__all__:
    thing = getattr(epafi, name)
    claim(inspect.getdoc(thing), name + " is documented")
    functions = [thing] if inspect.isfunction(thing) else [
        f for f in vars(thing).values() if inspect.isfunction(f) and f.__module__.startswith("epafi")]
    for function in functions:
        if function.__name__.startswith("__") and function.__name__ != "__init__":
            continue
        claim(typing.get_type_hints(function, vars(sys.modules[function.__module__]) | {
            "h5py": __import__("h5py"), "Figure": matplotlib.figure.Figure,
            "pandas": types.SimpleNamespace(DataFrame=object)}),
              "%s.%s is typed" % (name, function.__name__))
finish()
