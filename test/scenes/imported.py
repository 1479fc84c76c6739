"""Several bodies from one file of a mesh or a drawing, on meshes of first order with circles as
polygons: the press fit of press-fit.xml, whose pressure is Lame's."""
import math
import os

from runs import WORK, claim, fails, read, rows, saved, solved, write, finish

PRESSURE = 6.15234375
RADII = (10.0, 20.0, 30.0)


def around(radius, first, count):
    """Nodes of a circle as lines of a file."""
    return [(first + k, radius * math.cos(2 * math.pi * k / count), radius * math.sin(2 * math.pi * k / count))
            for k in range(count)]


def mesh(circles, surfaces):
    """Gmsh's format 4.1: a curve and a physical curve each circle (name, radius, elements), a physical
    surface for each (name, numbers of curves)."""
    names = ['1 %d "%s"' % (k + 1, name) for k, (name, _, _) in enumerate(circles)]
    names += ['2 %d "%s"' % (k + 1, name) for k, (name, _) in enumerate(surfaces)]
    text = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", str(len(names)), *names,
            "$EndPhysicalNames", "$Entities", "0 %d %d 0" % (len(circles), len(surfaces))]
    text += ["%d -9 -9 0 9 9 0 1 %d 0" % (k + 1, k + 1) for k in range(len(circles))]
    text += ["%d -9 -9 0 9 9 0 1 %d %d %s" % (k + 1, k + 1, len(around_it), " ".join(map(str, around_it)))
             for k, (_, around_it) in enumerate(surfaces)]
    nodes, lines, first = [], [], 1
    for k, (_, radius, count) in enumerate(circles):
        nodes.append((k + 1, around(radius, first, count)))
        lines.append((k + 1, [(first + i, first + (i + 1) % count) for i in range(count)]))
        first += count
    text += ["$EndEntities", "$Nodes", "%d %d 1 %d" % (len(nodes), first - 1, first - 1)]
    for curve, own in nodes:
        text += ["1 %d 0 %d" % (curve, len(own)), *[str(tag) for tag, _, _ in own],
                 *["%.17g %.17g 0" % (x, y) for _, x, y in own]]
    text += ["$EndNodes", "$Elements", "%d %d 1 %d" % (len(lines), first - 1, first - 1)]
    number = 1
    for curve, own in lines:
        text.append("1 %d 1 %d" % (curve, len(own)))
        for ends in own:
            text.append("%d %d %d" % (number, *ends))
            number += 1
    return "\n".join([*text, "$EndElements", ""])


def drawing(circles):
    text = ["0", "SECTION", "2", "ENTITIES"]
    for name, radius in circles:
        text += ["0", "CIRCLE", "8", name, "10", "0", "20", "0", "40", repr(radius)]
    return "\n".join([*text, "0", "ENDSEC", "0", "EOF", ""])


def fit(hub, ring):
    def body(geometry):
        return {"Material": {"Young's Modulus": 210000, "Poisson's Ratio": 0.3, "Plane State": "Plane Stress"},
                "Geometry": geometry, "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}
    return {"Bodies": {"hub": body(hub), "ring": body(ring)},
            "Contacts": {"fit": {"Between": ["hub:fit", "ring:" + ring.get("Boundaries", ["fit"])[0]],
                                 "Interference": 0.0025}},
            "Adaptivity": {"Tolerance": 1e-3}}


def claim_pressure(name, scene):
    folder, _ = solved(name, saved(name, scene))
    off = max(abs(row["pressure"] / PRESSURE - 1) for row in rows(folder))
    claim(off < 1e-3, "%s: the pressure is Lame's to %.1e" % (name, off))


# one curve between both bodies, or two whose nodes differ; inches
FILES = {
    "shared": ([("bore", 10, 16), ("fit", 20, 24), ("outside", 30, 30)], ((1, 2), (2, 3))),
    "apart": ([("bore", 10, 16), ("fit", 20, 24), ("fit", 20, 22), ("outside", 30, 30)], ((1, 2), (3, 4)))}
for name, (circles, (hub, ring)) in FILES.items():
    scaled = [(boundary, radius / 25.4, count) for boundary, radius, count in circles]
    write(os.path.join(WORK, name + ".msh"), mesh(scaled, (("hub", hub), ("ring", ring))))
    claim_pressure("mesh, " + name, fit(*[{"File": name + ".msh", "Surface": surface, "Scale": 25.4}
                                          for surface in ("hub", "ring")]))
write(os.path.join(WORK, "fit.dxf"), drawing(zip(("bore", "fit", "fit of the ring", "outside"), (10, 20, 20, 30))))
claim_pressure("drawing", fit({"File": "fit.dxf", "Boundaries": ["fit", "bore"]},
                              {"File": "fit.dxf", "Boundaries": ["fit of the ring", "outside"]}))

# the drawing of FreeCAD on its page: lines, an arc with a negative angle, a circle; the page's scene is its file
FREECAD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "doc", "howto", "freecad")
page = read(FREECAD + ".md")
claim(page.split("```yaml\n")[1].split("```")[0] == read(os.path.join(FREECAD, "lug.yaml")), "the page has the scene")
folder, _ = solved("lug", os.path.join(FREECAD, "lug.yaml"))
outline, last = rows(folder, "boundary.csv"), rows(folder, "history.csv")[-1]
claim({row["boundary"] for row in outline} == {"lug:" + name for name in ("clamp", "side", "nose", "hole")} | {
    "pin:pin"} and all(abs(math.hypot(row["x"] - 40, row["y"] - 10) - (10 if row["boundary"] == "lug:nose" else 4)) <
                       1e-6 for row in outline if row["boundary"] in ("lug:nose", "lug:hole")),
      "sketches of FreeCAD are boundaries with their names and radii")
claim(abs(last["bearing.force_x"] / (20 * math.pi * 3.98 ** 2) + 1) < 1e-3 and
      abs(last["pressure_max"] / 186 - 1) < 0.01, "the lug holds the pin: %g, pressure %g" % (
          last["bearing.force_x"], last["pressure_max"]))

# coincident nodes of two curves are one
square = [(1, 0, 0), (2, 1, 0), (3, 1, 0), (4, 1, 1), (5, 0, 1)]
write(os.path.join(WORK, "square.msh"), "\n".join([
    "$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$Entities", "0 2 0 0", "1 0 0 0 1 0 0 1 1 0", "2 0 0 0 1 1 0 1 2 0",
    "$EndEntities", "$Nodes", "1 5 1 5", "0 1 0 5", *[str(tag) for tag, _, _ in square],
    *["%d %d 0" % (x, y) for _, x, y in square], "$EndNodes",
    "$Elements", "2 4 1 4", "1 1 1 1", "1 1 2", "1 2 1 3", "2 3 4", "3 4 5", "4 5 1", "$EndElements", ""]))
ALONE = {"Material": {"Young's Modulus": 1, "Poisson's Ratio": 0.3}, "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}


def alone(**geometry):
    return saved("alone", {"Bodies": {"a": {**ALONE, "Geometry": geometry}}})


fails("coincident nodes are one", ["4 edges"], "check", alone(File="square.msh"), code=0)
fails("a surface that is none", ["no physical surface", "'hub'", "'ring'"], "check", alone(File="shared.msh", Surface="hob"))
fails("a layer that is none", ["no line is named 'bored'", "'bore'"], "check",
      alone(File="fit.dxf", Boundaries=["bored"]))
fails("two bodies in a file", ["Geometry->Boundaries", "Surface"], "check", alone(File="fit.dxf"))
fails("a surface of a drawing", ["no physical surfaces", "layers"], "check", alone(File="fit.dxf", Surface="hub"))
fails("a scale without a file", ["->Scale", "File"], "check",
      alone(Vertices=[[0, 0], [1, 0], [0, 1]], Edges=["a", "a", "a"], Scale=2))
finish()
