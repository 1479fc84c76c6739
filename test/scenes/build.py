"""Scenes of several bodies, written as XML."""
import os

from runs import WORK

SIDES = "{bottom, right, top, left}"


def parameter(name, kind, value):
    return '<Parameter name="%s" type="%s" value="%s"/>' % (
        name, kind, str(value).replace("&", "&amp;").replace("<", "&lt;"))


def listed(name, *items):
    return '<ParameterList name="%s">%s</ParameterList>' % (name, "".join(items))


def geometry(corners, sides=SIDES):
    numbers = ", ".join("%.17g" % c for corner in corners for c in corner)
    return listed("Geometry",
                  parameter("Vertices", "TwoDArray(double)",
                            "%dx2:{%s}" % (len(corners), numbers)),
                  parameter("Edges", "Array(string)", sides))


def block(left, bottom, right, top):
    return [(left, bottom), (right, bottom), (right, top), (left, top)]


def condition(boundary, kind, **functions):
    return listed(boundary, parameter("Type", "string", kind),
                  *(parameter(key.replace("_", " "), "string", value)
                    for key, value in functions.items()))


def body(name, corners, modulus, conditions="", fix="", mesh="", ratio=0.3, sides=SIDES):
    return listed(name,
                  listed("Material", parameter("Young's Modulus", "double", repr(modulus)),
                         parameter("Poisson's Ratio", "double", repr(ratio))),
                  geometry(corners, sides), listed("Boundary Conditions", conditions),
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


def contact(name, first, second, more=""):
    return listed(name, parameter("Between", "Array(string)", "{%s, %s}" % (first, second)),
                  more)


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

# without stabilisation a basis that is stable by itself
BIORTHOGONAL = parameter("Multiplier", "string", "Biorthogonal")
