"""Scenes of several bodies as text.  Standard library only."""
import math
import os
import re

from runs import WORK

SIDES = "{bottom, right, top, left}"


def parameter(name, kind, value):
    return '<Parameter name="%s" type="%s" value="%s"/>' % (
        name, kind, str(value).replace("&", "&amp;").replace("<", "&lt;"))


def listed(name, *items):
    return '<ParameterList name="%s">%s</ParameterList>' % (name, "".join(items))


def loop(corners, sides, bulges=(), hole=""):
    """The outer loop of an outline, or a hole."""
    numbers = ", ".join("%.17g" % c for corner in corners for c in corner)
    return (parameter(hole + "Vertices", "TwoDArray(double)",
                      "%dx2:{%s}" % (len(corners), numbers)) +
            parameter(hole + "Edges", "Array(string)", sides) +
            (parameter(hole + "Bulges", "Array(double)",
                       "{%s}" % ", ".join("%.17g" % b for b in bulges)) if bulges else ""))


def geometry(corners, sides=SIDES, bulges=(), holes=""):
    return listed("Geometry", loop(corners, sides, bulges) + holes)


def circle(radius, x=0, y=0):
    """Its corners; each of four arcs has the bulge tan(pi/8)."""
    return [(x + radius, y), (x, y + radius), (x - radius, y), (x, y - radius)]


QUARTERS = (math.tan(math.pi / 8),) * 4


def block(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def condition(boundary, kind, **functions):
    return listed(boundary, parameter("Type", "string", kind),
                  *(parameter(key.replace("_", " "), "string", value)
                    for key, value in functions.items()))


def body(name, outline, modulus, conditions="", fix="", mesh="", ratio=0.3):
    """An outline: corners of a polygon, or a whole Geometry."""
    return listed(name,
                  listed("Material", parameter("Young's Modulus", "double", repr(modulus)),
                         parameter("Poisson's Ratio", "double", repr(ratio))),
                  outline if isinstance(outline, str) else geometry(outline),
                  listed("Boundary Conditions", conditions),
                  listed("Rigid Motions", parameter("Fix", "Array(string)", fix))
                  if fix else "", mesh)


def mesh(across, up, degree):
    return listed("Mesh", parameter("Elements per Edge", "Array(int)",
                                    "{%d, %d, %d, %d}" % (across, up, across, up)),
                  parameter("Degree", "int", degree))


def rigid(name, corners, motion=""):
    return listed(name, listed("Material", parameter("Rigid", "bool", "true")),
                  geometry(corners), motion)


def friction(coefficient):
    return listed("Friction", parameter("Law", "string", "Coulomb"),
                  parameter("Coefficient", "string", coefficient))


def tied():
    return listed("Friction", parameter("Law", "string", "Tied"))


def contact(name, first, second, more=""):
    return listed(name, parameter("Between", "Array(string)", "{%s, %s}" % (first, second)),
                  more)


# without stabilisation a basis that is stable by itself
BIORTHOGONAL = parameter("Multiplier", "string", "Biorthogonal")


def wear(coefficient, jump="1"):
    return listed("Wear", parameter("Coefficient", "string", coefficient),
                  parameter("Cycle Jump", "string", jump))


def written(name, bodies, contacts="", form="None", size=0.25, degree=2, more=""):
    os.makedirs(WORK, exist_ok=True)
    path = os.path.join(WORK, name + ".xml")
    with open(path, "w") as file:
        file.write(listed(name, listed("Bodies", *bodies), listed("Contacts", contacts),
                          listed("Discretization", parameter("Mesh Size", "double", size),
                                 parameter("Degree", "int", degree),
                                 BIORTHOGONAL if form == "None" else listed(
                                     "Stabilization", parameter("Form", "string", form))),
                          more))
    return path


def with_sides_swapped(text):
    """A scene with the other side of each contact first."""
    return re.sub(r'("Between"[^{]*\{)([^,}]*), ([^}]*)\}', r"\1\3, \2}", text)


def with_moduli(text, ratio):
    """A scene whose second body is so many times as stiff as its first."""
    key = "Young's Modulus\" type=\"double\" value=\""
    head, first, second = text.split(key, 2)
    modulus = float(first.split('"')[0])
    return key.join((head, first, "%r%s" % (ratio * modulus, second[second.index('"'):])))


def without_friction(text):
    return re.sub(r'value="Coulomb"/>\s*<Parameter name="Coefficient"[^>]*>', 'value="None"/>',
                  text)
