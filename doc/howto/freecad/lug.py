"""A lug with a pin hole, drawn in FreeCAD and exported for Epafi:

    freecadcmd lug.py          writes lug.dxf

One sketch for each boundary; its label becomes the layer, which is the boundary's name.  In the window:
select the sketches, File > Export, "Autodesk DXF 2D".
"""
import math

import FreeCAD
import importDXF
import Part
from FreeCAD import Vector

document = FreeCAD.newDocument("lug")


def sketch(boundary, *pieces):
    """A sketch of the boundary's name."""
    drawn = document.addObject("Sketcher::SketchObject", boundary)
    drawn.addGeometry(list(pieces), False)
    return drawn


def line(x0, y0, x1, y1):
    return Part.LineSegment(Vector(x0, y0, 0), Vector(x1, y1, 0))


def circle(x, y, radius):
    return Part.Circle(Vector(x, y, 0), Vector(0, 0, 1), radius)


sketches = [
    sketch("clamp", line(0, 20, 0, 0)),
    sketch("side", line(0, 0, 40, 0), line(40, 20, 0, 20)),
    sketch("nose", Part.ArcOfCircle(circle(40, 10, 10), -math.pi / 2, math.pi / 2)),
    sketch("hole", circle(40, 10, 4))]
document.recompute()
importDXF.export(sketches, "lug.dxf")
