"""Scenes of several bodies as dictionaries.  Standard library only."""
import math

from runs import saved


class Keys(dict):
    """Keys of a scene and what they hold; they add up."""

    def __add__(self, other):
        return Keys({**self, **other})


NONE = Keys()


def keys(*parts, **values):
    """keys(Displacement_X=1) is {"Displacement X": 1}, behind what the parts hold."""
    return sum(parts, NONE) + {key.replace("_", " "): value for key, value in values.items()}


def listed(name, *parts, **values):
    return Keys({name: keys(*parts, **values)})


def names(text):
    """Of a list, or of a text with commas."""
    return text.split(", ") if isinstance(text, str) else list(text)


def loop(corners, sides, bulges=(), hole=""):
    """The outer loop of an outline, or a hole."""
    return Keys({hole + "Vertices": list(corners), hole + "Edges": names(sides),
                 **({hole + "Bulges": list(bulges)} if bulges else {})})


def geometry(corners, sides="bottom, right, top, left", bulges=(), holes=NONE):
    return listed("Geometry", loop(corners, sides, bulges), holes)


def circle(radius, x=0, y=0):
    """Its corners; each of four arcs has the bulge tan(pi/8)."""
    return [(x + radius, y), (x, y + radius), (x - radius, y), (x, y - radius)]


QUARTERS = (math.tan(math.pi / 8),) * 4


def disc(radius, side, x=0, y=0, holes=NONE):
    return geometry(circle(radius, x, y), [side] * 4, QUARTERS, holes)


def round_hole(radius, side, x=0, y=0):
    return loop(circle(radius, x, y), [side] * 4, QUARTERS, "Hole 1 ")


def block(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def condition(boundary, kind, *parts, **functions):
    return listed(boundary, keys(Type=kind), *parts, **functions)


CLAMPED = keys(Displacement_X=0, Displacement_Y=0)


def body(name, outline, modulus, conditions=NONE, fix="", mesh=NONE, ratio=0.3, inside=NONE,
         **material):
    """An outline: corners of a polygon, or a whole Geometry.  inside: further lists."""
    return listed(name, listed("Material",
                               Keys({"Young's Modulus": modulus, "Poisson's Ratio": ratio}),
                               **material), outline if isinstance(outline, dict) else
                  geometry(outline), listed("Boundary Conditions", conditions),
                  listed("Rigid Motions", Fix=names(fix)) if fix else NONE, mesh, inside)


def with_more(whole, *lists, **material):
    """A body with further lists and more of its Material said."""
    (name, own), = whole.items()
    return listed(name, own, *lists, Material={**own["Material"], **keys(**material)})


def mesh(across, up, degree):
    return listed("Mesh", Elements_per_Edge=[across, up, across, up], Degree=degree)


def rigid(name, corners, *parts, **material):
    return listed(name, listed("Material", Rigid=True, **material), geometry(corners), *parts)


def friction(coefficient):
    return listed("Friction", Law="Coulomb", Coefficient=coefficient)


TIED = listed("Friction", Law="Tied")


def contact(name, first, second, *parts, **values):
    return listed(name, keys(Between=[first, second]), *parts, **values)


def wear(coefficient, jump=1):
    return listed("Wear", Coefficient=coefficient, Cycle_Jump=jump)


def primed(ratio, alpha, plane):
    """E'/E, nu', al' of a plane state."""
    if plane == "Plane Stress":
        return 1, ratio, alpha
    return 1 / (1 - ratio ** 2), ratio / (1 - ratio), (1 + ratio) * alpha


def history(times, steps):
    return listed("History", Times=times, Steps=steps)


def points_at(points):
    return listed("Output", Interior_Points=list(points))


def written(name, bodies, contacts=NONE, form="None", size=0.25, degree=2, more=NONE, **discretization):
    """Its file.  Without stabilisation the basis is one that is stable by itself."""
    stable = {"Multiplier": "Biorthogonal"} if form == "None" else {}
    return saved(name, keys(
        listed("Bodies", *bodies), listed("Contacts", contacts) if contacts else NONE,
        listed("Discretization", Mesh_Size=size, Degree=degree, **{
            **stable, "Stabilization": {} if form == "None" else {"Form": form}, **discretization}),
        more), name)


WALLS = (condition("left", "Dirichlet", Displacement_X=0) +
         condition("right", "Dirichlet", Displacement_X=0))


def confined(name, law, top, form="Density", basis="Gauss-Legendre-Lagrange", more=NONE, size=0.5):
    """A unit block, E = 1, nu = 0.3, between frictionless walls, pushed onto a plane."""
    return written(name, [body("block", block(0, 0, 1, 1), 1.0, WALLS + condition(
        "bottom", "Contact", law) + condition("top", "Dirichlet", Displacement_Y=top))], NONE, form,
                   size, 2, more, Multiplier=basis)


def pad(name, motion, *law, form="Density", size=0.25, more=NONE):
    """A rigid pad on a soft block."""
    soft = body("soft", block(-4, -4, 4, 0), 1.0, condition("bottom", "Dirichlet", CLAMPED))
    return written(name, [soft, rigid("pad", block(-1, 0, 1, 1), listed("Motion", Keys(motion)))],
                   contact("rub", "soft:top", "pad:bottom", *law), form, size, more=more)


def with_sides_swapped(scene):
    """A scene of the package with the other side of each contact first."""
    return scene.changed({"Contacts->%s->Between" % name: contact["Between"][::-1]
                          for name, contact in scene["Contacts"].items()})


def with_moduli(scene, ratio):
    """A scene whose second body is so many times as stiff as its first."""
    (_, first), (name, _) = scene["Bodies"].items()
    return scene.changed({"Bodies->%s->Material->Young's Modulus" % name:
                          ratio * first["Material"]["Young's Modulus"]})


def without_friction(scene):
    return scene.changed({"Contacts->%s->Friction" % name: {"Law": "None"} for name in scene["Contacts"]})
