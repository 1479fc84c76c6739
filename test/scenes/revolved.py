"""Scenes of solids of revolution, as dictionaries."""
import math

from runs import claim, epafi, run, saved

ELASTIC = {"Young's Modulus": 1, "Poisson's Ratio": 0.3}
QUARTER = math.tan(math.pi / 8)
GRADED = {"Strategy": "Graded hp", "Maximum Levels": 60, "Maximum Degrees of Freedom": 4000}


def clamp(**displacements):
    return {"Type": "Dirichlet", **{"Displacement " + c: u for c, u in displacements.items()}}


def body(vertices, edges, conditions=None, material=ELASTIC, **more):
    outline = {"Vertices": vertices, "Edges": edges}
    if "bulges" in more:
        outline["Bulges"] = more.pop("bulges")
    return {"Material": material, "Geometry": outline,
            **({"Boundary Conditions": conditions} if conditions else {}), **more}


def scene(bodies, size=1, degree=1, adaptivity=None, **more):
    return {"Geometry": {"Type": "Axisymmetric"}, "Bodies": bodies,
            "Discretization": {"Mesh Size": size, "Degree": degree},
            **({"Adaptivity": adaptivity} if adaptivity else {}), **more}


def last(name, keys):
    history, points = run(saved(name, keys), name)
    return history[-1], points


def column(vertices, conditions, **more):
    return body(vertices, ["base", "side", "top", "axis"], conditions, **more)


CYLINDER = [[0, 0], [1, 0], [1, 2], [0, 2]]


def refused(name, words, keys):
    code, text = epafi("check", saved(name, keys))
    claim(code == 1 and all(word in text for word in words),
          "%s: refused: %s" % (name, text.strip()[-300:]))
