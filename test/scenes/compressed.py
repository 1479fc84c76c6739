"""Compressed operators give what dense ones give: energies, states of contact, Newton's steps.
Method "Automatic" takes them by sizes and shape."""
import os

from runs import (ENERGIES, claim, differ, epafi, finish, fresh, keys_of, refused, run, saved, scene,
                  table)
from written import block, body, condition, geometry, listed, round_hole, with_moduli, written

LEVELS = ["Adaptivity->Maximum Levels=3"]
UNIFORM = ["Adaptivity->Strategy=Uniform h", "Adaptivity->Tolerance=1e-9",
           "Adaptivity->Maximum Degrees of Freedom=3000"]
SCENES = {
    "fretting": ["Discretization->Elements per Edge={2, 2, 2, 3, 1, 9, 20, 9, 1, 3, 2, 2, 2, 3, 3, 3}",
                 "History->Times={1, 2, 3}", "History->Steps={1, 3, 3}"],
    "tilting-punch": [],
    "two-blocks": LEVELS,
    "incline": LEVELS,
    "dovetail": LEVELS,
    "two-cylinders": LEVELS,
    "press-fit": LEVELS,
    "disc": LEVELS,
    # of revolution: bodies that meet, with friction, bolt load, heat, hollow ones that move freely
    "flange": UNIFORM,
    "hub-on-shaft": UNIFORM,
    "o-ring": UNIFORM,
    "spheres": UNIFORM,
    "hot-hub": LEVELS,
}


def compare(name, file, settings):
    results = {}
    for method in ("Dense", "Compressed"):
        results[method] = run(file, name + "-" + method, [
            *settings, "Solver->Linear->Method=" + method])
    (dense, contact), (own, met) = results["Dense"], results["Compressed"]
    worst = max(differ(a[key], b[key], a["energy_strain"])
                for a, b in zip(dense, own) for key in ENERGIES)
    claim(len(dense) == len(own) and worst < 1e-9, "%s: energies differ by %.1e" % (name, worst))
    states = [[(point["contact"], point["friction"]) for point in side] for side in (contact, met)]
    claim(states[0] == states[1], "%s: states of contact are the same" % name)
    steps = [sum(row["newton_iterations"] for row in rows) for rows in (dense, own)]
    # from a start, full steps take the place of pivoting; along a path, where the start is right
    # but for a front, sweeps over D's entries settle that one and full steps do not
    most = 1.3 if any("History" in setting for setting in settings) else 1.2
    claim(steps[1] <= most * steps[0], "%s: %d Newton steps, dense %d" % (name, steps[1], steps[0]))


for each, choices in SCENES.items():
    compare(each, scene(each + ".xml"), choices)
for ratio in (1000, 0.001):
    path = saved("moduli", with_moduli(keys_of(scene("two-blocks.xml")), ratio))
    compare("two-blocks, E %g" % ratio, path, LEVELS)

# nu = 1/2, no line in contact, and clamps that alone would change the volume
pressed = written("incompressible", [body(
    "A", geometry(block(0, 0, 1, 1), holes=round_hole(0.2, "hole", 0.5, 0.5)),
    1.0, condition("bottom", "Dirichlet", Displacement_X=0, Displacement_Y="0.01*x^2"), "",
    listed("Mesh", Elements_per_Edge=[64] * 4, Hole_1_Elements_per_Edge=[32] * 4), 0.5)],
    form="Density")
sums = [run(pressed, "incompressible-" + method, ["Solver->Linear->Method=" + method])[0][-1]
        for method in ("Dense", "Compressed")]
claim(differ(*(row["energy_strain"] for row in sums)) < 1e-7 and
      max(abs(row["reaction_" + c]) for row in sums for c in ("x", "y", "moment")) < 1e-8,
      "prescribed displacements at nu = 1/2: energies %g, %g" % tuple(
          row["energy_strain"] for row in sums))
refused("Belos there", pressed, "Belos", "'A'", "1/2", "Dense",
        settings=["Solver->Linear->Method=Belos"])

STABLE = ["Discretization->Multiplier=Biorthogonal", "Discretization->Stabilization->Form=None"]
DENSITY = ["Discretization->Stabilization="]


def chosen(name, file, elements, settings):
    """What a level of a scene was solved with under "Automatic", and what was printed."""
    folder = fresh("automatic-" + name)
    code, text = epafi("run", scene(file), "--output", folder, "--threads", "1", settings=[
        "Adaptivity->Strategy=None", "Adaptivity->Maximum Degrees of Freedom=100000",
        "Solver->Linear->Method=Automatic", "Output->Fields=false",
        "Discretization->Elements per Edge={%s}" % ", ".join(map(str, elements)), *settings])
    return (table(os.path.join(folder, "history.csv"))[-1]["operators"] if code == 0 else "none"), text


claim(chosen("small", "coulomb.xml", [64] * 4, DENSITY)[0] == "dense", "small levels are dense")
claim(chosen("large", "coulomb.xml", [256] * 4, DENSITY)[0] == "compressed",
      "large ones are compressed")
claim(chosen("around", "spinning-disc.xml", [270, 270, 270, 1], [
    "Discretization->Degree=1", "Discretization->Mesh Size="])[0] == "compressed",
      "as of solids of revolution")
THIN = "Bodies->block->Geometry->Vertices=4x2:{-0.5,-0.5, 0.5,-0.5, 0.5,-0.48, -0.5,-0.48}"
claim(chosen("slender", "coulomb.xml", [460, 52, 460, 52], [*DENSITY, THIN])[0] == "dense",
      "but dense where the body is slender, whose displacements would lose digits")
claim("slender" in chosen("told", "coulomb.xml", [64, 8, 64, 8],
                          [*DENSITY, THIN, "Solver->Linear->Method=Compressed"])[1],
      "which a run with Compressed says")
FOUNDATION = [176, 176, 44, 88, 44, 176]
claim(chosen("fits", "tresca.xml", FOUNDATION, STABLE)[0] == "dense", "a level of 704 elements is dense")
for limit, words in [(112, "Method = Compressed operators could be compressed"), (80, "coarser")]:
    method, said = chosen("narrow", "tresca.xml", FOUNDATION, [
        *STABLE, "Adaptivity->Maximum Memory=%d" % limit])
    claim(method == "none" and words in said, "refused where it does not fit, not solved otherwise "
          "than on a larger machine: " + said.strip()[-300:])
for count, wanted in [(768, "dense"), (832, "compressed")]:
    claim(chosen("crossover", "tresca.xml", [count // 4] * 2 + [count // 16, count // 8, count // 16,
                 count // 4], STABLE)[0] == wanted, "%d elements: %s" % (count, wanted))
method, said = chosen("dense", "coulomb.xml", [320] * 4, [*DENSITY, "Solver->Linear->Method=Dense"])
claim(method == "dense" and "Method = Automatic operators could be compressed" in said,
      "where dense is asked for, a large level names Automatic")
method, said = chosen("form", "coulomb.xml", [320] * 4, [])
claim(method == "dense" and "Form = Density operators could be compressed" in said,
      "a Form that cannot be compressed stays; another one is named")

finish()
