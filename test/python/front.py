"""The Python front: scenes there and back, what is refused, runs, failures, sweeps, types.

    front.py EPAFI WORK
"""
import inspect
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
import typing

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import claim, finish  # noqa: E402

EPAFI, WORK = sys.argv[1:]
shutil.rmtree(WORK, ignore_errors=True)
os.makedirs(WORK)
import epafi  # noqa: E402
from epafi import program, scenes  # noqa: E402

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
    claim(told(copy) == told(os.path.join(SHIPPED, name)), name + ": the program reads the same")

try:
    import yaml

    with open(os.path.join(WORK, "patch.yaml"), "w") as stream:
        yaml.safe_dump({"Contact patch test": dict(epafi.Scene.read(
            os.path.join(SHIPPED, "patch.xml")))}, stream)
    claim(epafi.Scene.read(os.path.join(WORK, "patch.yaml")) ==
          epafi.Scene.read(os.path.join(SHIPPED, "patch.xml")), "YAML is read as well")
    with open(os.path.join(WORK, "patch.yaml")) as stream:
        text = stream.read()
    key = "Young's Modulus: "
    begin = text.index(key) + len(key)
    with open(os.path.join(WORK, "patch.YAML"), "w") as stream:
        stream.write(text[:begin] + "1e3" + text[text.index("\n", begin):])
    body, = epafi.Scene.read(os.path.join(WORK, "patch.YAML"))["Bodies"].values()
    claim(body["Material"]["Young's Modulus"] == 1000,
          "with numbers as the program takes them, and .YAML")
except ImportError:
    print("python3-yaml is not here: YAML not tried")
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
        ({"Bodies->block->Geometry->Vertices": [[0, 0], [1]]}, ["one length"]),
        ({"Output->Nothing": None}, ["cannot be removed"]),
        ({"Discretization->Degree": 99}, ["Discretization->Degree = 99", "from 1 to 25"])]:
    try:
        epafi.run(coulomb, set=settings)
        claim(False, "%s is refused" % settings)
    except epafi.InputError as error:
        claim(all(word in str(error) for word in words) and "/tmp" not in str(error),
              "%s is refused: %s" % (settings, error))
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
claim(run.fields(grid=(4, 3)).size == 12, "on a grid")
pictures = run.plot("syy")
claim(len(pictures) == 7 and all(os.path.getsize(file) > 5000 for file in pictures),
      "pictures are drawn")
import matplotlib  # noqa: E402

claim(matplotlib.rcParams["axes.grid"] == matplotlib.rcParamsDefault["axes.grid"],
      "and leave matplotlib's style alone")
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
try:
    run.steps
    claim(False, "steps.csv of a scene without a History")
except epafi.InputError as error:
    claim("steps.csv" in str(error), "a file that is not there is named: %s" % error)
more = epafi.run(coulomb, restart=run, set={"Adaptivity->Maximum Levels": 3})
claim(more.history.size == 3, "a run goes on")
temporary = more.folder
del more
claim(not os.path.exists(temporary), "a run without a folder leaves none")
try:
    epafi.run(coulomb, folder)
    claim(False, "an earlier run is in the way")
except epafi.InputError as error:
    claim("--force" in str(error), "an earlier run is not overwritten: %s" % error)
FIXED_POINT = {"Solver->Coulomb Iteration": "Fixed Point"}
try:
    epafi.run(coulomb, set={**FIXED_POINT, "Solver->Coulomb Maximum Iterations": 1})
    claim(False, "one update is not enough")
except epafi.NotConverged as error:
    claim(error.code == 3 and not error.run.converged and error.run.history.size == 1,
          "what does not converge is an exception with a run")

# sweeps: an array in the parameters' shape, failures among them
sweep = epafi.sweep(coulomb, {"Discretization->Degree": [1, 2],
                              FRICTION + "->Coefficient": [0, 0.2, 0.4]},
                    os.path.join(WORK, "sweep"))
single = epafi.run(coulomb, set={"Discretization->Degree": 2, FRICTION + "->Coefficient": 0.4})
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
try:
    epafi.run(long, os.path.join(WORK, "long"))
    claim(False, "an interrupt ends a run")
except KeyboardInterrupt:
    claim(epafi.Run(os.path.join(WORK, "long")).history.size > 0, "an interrupt keeps levels")

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
with open(os.path.join(WORK, "profile.csv"), "w") as stream:
    stream.write("-10, 0\n10, 0\n")
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
            "h5py": __import__("h5py")}),
              "%s.%s is typed" % (name, function.__name__))
finish()
