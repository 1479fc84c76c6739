"""Thin layers under elements that are longer than they are thick: the estimated error is not below
the true one, against a finer run (doc/theory/estimators.md, Thin layers)."""
import os

from runs import WORK, claim, epafi, finish, rows, saved

CLAMPED = {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
PRESSED = "-1e-2*%g"  # of the thickness


def layer(thickness, ratio, top, levels, unknowns):
    """Clamped below, 1 long, 8 elements along it."""
    return {"Bodies": {"layer": {
        "Material": {"Young's Modulus": 1, "Poisson's Ratio": ratio},
        "Geometry": {"Vertices": [[-0.5, 0], [0.5, 0], [0.5, thickness], [-0.5, thickness]],
                     "Edges": ["bottom", "end", "top", "end"]},
        "Boundary Conditions": {"bottom": CLAMPED, "top": top}}},
        "Discretization": {"Elements per Edge": [8, 1, 8, 1], "Degree": 1},
        "Adaptivity": {"Strategy": "Graded hp", "Maximum Levels": levels,
                       "Maximum Degrees of Freedom": unknowns}}


def pushed(thickness, shape):
    return {**CLAMPED, "Displacement Y": PRESSED % thickness + "*" + shape}


def indented(thickness):
    return {"Type": "Contact", "Gap": "1e-2*%g*(16*x^2 - 1)" % thickness}


def effectivities(name, *scene):
    finer = saved(name + ", finer", layer(*scene, 40, 400))
    coarse = saved(name, layer(*scene, 4, 400))
    reference, folder = (os.path.join(WORK, name + of) for of in (", reference", ""))
    for file, to, more in ((finer, reference, ()),
                           (coarse, folder, ("--reference", reference + "/solution.hdf"))):
        code, text = epafi("run", file, "--output", to, "--force", "--quiet", *more)
        claim(code == 0, "%s: exit code %d%s" % (name, code, text[-300:]))
    levels = rows(folder, "history.csv")
    claim(all(row["counted"] == 1 for row in levels), name + ": the reference is finer")
    return [row["effectivity"] for row in levels]


BUMP = "exp(-100*x^2)"
for title, thickness, ratio, top in (
        ("bump, 1:1000", 1e-3, 0.3, pushed(1e-3, BUMP)),
        ("bump, 1:100, nearly incompressible", 1e-2, 0.4999, pushed(1e-2, BUMP)),
        ("plate, 1:100, nearly incompressible", 1e-2, 0.4999, pushed(1e-2, "1")),
        ("plate, 1:1000, incompressible", 1e-3, 0.5, pushed(1e-3, "1")),
        ("indenter, 1:10000", 1e-4, 0.3, indented(1e-4)),
        ("indenter, 1:1000, incompressible", 1e-3, 0.5, indented(1e-3))):
    ratios = effectivities(title, thickness, ratio, top)
    claim(min(ratios) >= 1, "%s: estimate over true error %s" % (
        title, " ".join("%.2f" % value for value in ratios)))

finish()
