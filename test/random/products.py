"""Random scenes of any kind with further features, each of them or not, drawn from a seed alone."""
import math
import random
import xml.etree.ElementTree as tree

from bodies import Rings, ThreeBodies, TwoBodies
from oddities import Oddities
from outlines import arc, opposite
from scenes import LAWS, Scene


def child(node, name):
    """A parameter or list of this name, or None."""
    return next((each for each in node if each.get("name") == name), None)


def sublist(node, name):
    found = child(node, name)
    return tree.SubElement(node, "ParameterList", name=name) if found is None else found


def put(node, name, kind, value):
    found = child(node, name)
    if found is None:
        found = tree.SubElement(node, "Parameter", name=name)
    found.set("type", kind)
    found.set("value", value)


def words(node, name):
    found = None if node is None else child(node, name)
    return [] if found is None else [
        word.strip() for word in found.get("value").split(":")[-1].strip("{}").split(",")]


class Products:
    """A scene of every kind times: bodies of nu = 1/2 where the conditions allow it; a hole, free,
    under pressure or about a plug; a path on which loads and overlaps come and go; weight, spin and
    heat inside, by any form of the stabilisation.  `paths`: may it have a History?"""

    KINDS = (Scene, TwoBodies, ThreeBodies, Rings, Oddities)

    def __init__(self, seed, paths=True):
        draw = self.draw = random.Random("%d products" % seed)
        scene = draw.choice(self.KINDS)(draw.randrange(10 ** 6))
        self.root = tree.fromstring(scene.xml())
        self.root.set("name", "Random scene %d of products" % seed)
        self.seed, self.laws, self.gaps = seed, list(scene.laws), list(scene.gaps)
        self.basis, self.strategy = scene.basis, scene.strategy
        self.stress, self.held = scene.stress, scene.held
        size = scene.diameter if isinstance(scene, Scene) else scene.size
        self.size, self.energy = size, scene.modulus * size ** 2
        self.features = [type(scene).__name__]
        bodies = child(self.root, "Bodies")
        self.bodies = [body for body in bodies
                       if child(child(body, "Material"), "Rigid") is None]
        self.between = [words(contact, "Between") for contact in self.root.iterfind(
            "ParameterList[@name='Contacts']/ParameterList")]
        if draw.random() < 0.5:
            self.hole(draw.choice(self.bodies))
        if draw.random() < 0.7:
            for body in self.bodies:
                self.incompressible(body)
        history = child(self.root, "History")
        if history is not None and not paths:
            self.root.remove(history)
        elif history is None and paths and draw.random() < 0.5:
            self.path()
        if draw.random() < 0.5:
            self.inside(scene, size)
        self.springs()

    def springs(self):
        """Of bodies without elasticity, each component or not, from a draw of their own."""
        draw = random.Random("%d springs" % self.seed)
        units = {"X": ("Displacement X", "Force X", 0), "Y": ("Displacement Y", "Force Y", 0),
                 "Rotation": ("Rotation", "Moment", 1)}
        move = self.size * self.stress / max(self.modulus(body) for body in self.bodies)
        for body in child(self.root, "Bodies"):
            for key, (moved, pushed, power) in units.items():
                if body in self.bodies or draw.random() < 0.3:
                    continue
                motion = sublist(body, "Motion")
                put(motion, "Stiffness " + key, "double", "%.6g" % (
                    self.modulus(self.bodies[0]) * self.size ** (2 * power) * 10 ** draw.uniform(-9, 9)))
                if draw.random() < 0.5:
                    put(motion, moved, "string", "%.6g" % (
                        move / self.size ** power * draw.uniform(-1, 1)))
                if draw.random() < 0.5:
                    put(motion, pushed, "string", "%.6g" % (
                        self.stress * self.size ** (1 + power) * draw.uniform(-0.2, 0.2)))
                if "springs" not in self.features:
                    self.features.append("springs")

    def inside(self, scene, size):
        """Forces of all bodies at the root, heat of each by itself.  What is free to fall has nothing
        but weight, downwards."""
        draw, factor = self.draw, ""
        if child(self.root, "History") is not None:
            factor = "*(0.6 + 0.4*sin(%.3g*t + %.3g))" % (draw.uniform(1, 4), draw.uniform(0, 6))
        held = isinstance(scene, Rings) or isinstance(scene, Scene) and scene.held in ("clamp", "mean")
        force = self.stress / size  # per volume
        kinds = [kind for kind in ("weight", "spin", "heat") if draw.random() < 0.6]
        bodies, loads = list(child(self.root, "Bodies")), {}
        if "weight" in kinds:
            name = draw.choice(("Gravity", "Force"))
            loads[name + " Y"] = -force * draw.uniform(0.1, 1)
            if held:
                loads[name + " X"] = force * draw.uniform(-1, 1)
        if "spin" in kinds and held:
            loads["Spin"] = (force / size * draw.uniform(0, 1)) ** 0.5
            loads["Angular Acceleration"] = force / size * draw.uniform(-1, 1)
        for body in bodies:
            put(sublist(body, "Material"), "Density", "double", "%.6g" % draw.uniform(0.5, 2))
        owners = [self.root]
        if "heat" in kinds:
            owners = self.bodies
        for owner in owners:
            inner = sublist(owner, "Body Loads") if loads or "heat" in kinds else None
            for key, value in loads.items():
                put(inner, key, "string", "(%.6g)%s" % (value, factor))
            if "heat" in kinds:
                put(child(owner, "Material"), "Thermal Expansion", "double", "1e-5")
                strain = self.stress / self.modulus(owner) / 1e-5
                if draw.random() < 0.5:
                    self.conduction(owner, strain, factor)
                    continue
                terms = ["%.4g*(x/%.6g)^%d*(y/%.6g)^%d" % (
                    draw.uniform(-1, 1), size, a, size, b)
                    for a, b in ((0, 0), (1, 0), (draw.randint(0, 2), draw.randint(0, 2)))]
                put(inner, "Temperature", "string", "%.6g*(%s)%s" % (strain, " + ".join(terms), factor))
        self.features += kinds
        if "incompressible" not in self.features and self.basis != "Biorthogonal":
            put(sublist(child(self.root, "Discretization"), "Stabilization"), "Form", "string",
                draw.choice(("Density", "Projected", "Exact")))

    def conduction(self, body, strain, factor):
        """One temperature, so that it meets no other one, on some boundaries; on others a flux."""
        draw, geometry = self.draw, child(body, "Geometry")
        names = sorted(set(words(geometry, "Edges") + words(geometry, "Hole 1 Edges")))
        draw.shuffle(names)
        held = draw.randint(1, len(names))
        place = draw.choice(("x", "y"))
        inner = sublist(body, "Thermal Conditions")
        strain *= draw.uniform(-1, 1)
        for k, name in enumerate(names):
            if k < held:
                put(sublist(inner, name), "Temperature", "string", "%.6g*(1 + %s/%.6g)%s" % (
                    strain, place, self.size, factor))
            elif draw.random() < 0.7:
                put(sublist(inner, name), "Heat Flux", "string", "%.6g*(0.3 + n%s)%s" % (
                    strain * draw.uniform(-1, 1) / self.size, place, factor))
        self.features.append("conduction")

    def xml(self):
        return tree.tostring(self.root, encoding="unicode")

    def hole(self, body):
        """In the widest place of an outline without one."""
        draw, geometry = self.draw, child(body, "Geometry")
        if child(geometry, "Hole 1 Vertices") is not None:
            return
        numbers = [float(word) for word in words(geometry, "Vertices")]
        corners = list(zip(numbers[::2], numbers[1::2]))
        bulges = [float(word) for word in words(geometry, "Bulges")] or [0] * len(corners)
        outline = [point for k, start in enumerate(corners)
                   for point in arc(start, corners[(k + 1) % len(corners)], bulges[k], 24)[:-1]]
        middle, distance = widest(draw, outline)
        # sides of thin bodies pass between the points
        radius = min(distance * draw.uniform(0.2, 0.6), 0.6 * clearance(middle, outline))
        count = draw.randint(2, 5)
        bulge = math.tan(math.pi / (2 * count)) if count == 2 or draw.random() < 0.5 else 0
        turn = draw.uniform(0, 2 * math.pi)
        corners = [(middle[0] + radius * math.cos(turn + 2 * math.pi * k / count),
                    middle[1] + radius * math.sin(turn + 2 * math.pi * k / count))
                   for k in range(count)]
        put(geometry, "Hole 1 Vertices", "TwoDArray(double)", "%dx2:{%s}" % (
            count, ", ".join("%.16g,%.16g" % corner for corner in corners)))
        put(geometry, "Hole 1 Edges", "Array(string)", "{%s}" % ", ".join(["hole"] * count))
        put(geometry, "Hole 1 Bulges", "Array(double)", "{%s}" % ", ".join(
            ["%.16g" % bulge] * count))
        own = child(body, "Mesh")
        mesh = child(self.root, "Discretization") if own is None else own
        if child(mesh, "Elements per Edge") is not None:
            put(mesh, "Hole 1 Elements per Edge", "Array(int)", "{%s}" % ", ".join(
                str(draw.randint(2, 3)) for _ in range(count)))
        limit = child(child(self.root, "Adaptivity"), "Maximum Degrees of Freedom")
        limit.set("value", str(int(limit.get("value")) + 100))  # a first mesh may need it
        kind = draw.choice(("free", "pressure", "plug"))
        self.features.append("hole (%s)" % kind)
        if kind == "free":
            return
        condition = sublist(sublist(body, "Boundary Conditions"), "hole")
        if kind == "pressure":
            put(condition, "Type", "string", "Neumann")
            pressure = self.stress * draw.uniform(-1, 1)
            for axis in "XY":
                put(condition, "Traction " + axis, "string", "%.6g*n%s" % (pressure, axis.lower()))
            return
        law = draw.choice(list(LAWS))
        self.laws.append(law)
        put(condition, "Type", "string", "Contact")
        put(condition, "Gap", "string", "%.6g" % draw.choice(
            (0, radius * self.stress / self.modulus(body) * draw.uniform(0, 1))))
        friction = sublist(condition, "Friction")
        put(friction, "Law", "string", law)
        for field in LAWS[law]:
            put(friction, field, "string", "%.6g" % (
                draw.uniform(0, 1) * (1 if field == "Coefficient" else self.stress)))

    @staticmethod
    def modulus(body):
        return float(child(child(body, "Material"), "Young's Modulus").get("value"))

    def incompressible(self, body):
        """Where each closed line carries stresses of contact, or without held means has a side
        without any condition."""
        conditions = child(body, "Boundary Conditions")
        geometry, name = child(body, "Geometry"), body.get("name")
        carried, bound = ({side.split(":")[1] for both in self.between for side in both[:count]
                           if side.split(":")[0] == name} for count in (1, 2))
        for condition in conditions if conditions is not None else ():
            bound.add(condition.get("name"))
            if child(condition, "Type").get("value") == "Contact":
                carried.add(condition.get("name"))
        motions = child(body, "Rigid Motions")
        fixes, pinned = motions is not None and len(motions) > 0, False
        for line in ("Edges", "Hole 1 Edges"):
            names = set(words(geometry, line))
            if names and not names & carried:
                if fixes or names <= bound:
                    return
                pinned = True
        put(child(body, "Material"), "Poisson's Ratio", "double", "0.5")
        discretization = child(self.root, "Discretization")
        put(sublist(discretization, "Stabilization"), "Form", "string", "Density")
        if self.basis == "Biorthogonal":  # has no stabilisation
            self.basis = "Gauss-Legendre-Lagrange"
            put(discretization, "Multiplier", "string", self.basis)
        for feature in ["incompressible"] + pinned * ["pinned"]:
            if feature not in self.features:
                self.features.append(feature)

    def path(self):
        draw = self.draw
        for node in self.root.iter("Parameter"):
            if node.get("name") in ("Traction X", "Traction Y", "Interference"):
                node.set("value", "(%s)*(0.6 + 0.4*sin(%.3g*t + %.3g))" % (
                    node.get("value"), draw.uniform(1, 4), draw.uniform(0, 6)))
        history = sublist(self.root, "History")
        put(history, "Times", "Array(double)", "{1, 3}")
        put(history, "Steps", "Array(int)", "{%d, %d}" % (draw.randint(1, 3), draw.randint(2, 4)))
        self.features.append("path")


def widest(draw, outline):
    """A place far from a polygon's corners, and how far."""
    low, high = ([way(point[c] for point in outline) for c in (0, 1)] for way in (min, max))
    outside = (high[0] + high[0] - low[0], high[1] + 0.37 * (high[1] - low[1]))
    best = None, 0
    for _ in range(300):
        place = tuple(draw.uniform(a, b) for a, b in zip(low, high))
        crossings = sum(opposite(place, outside, *side) and opposite(*side, place, outside)
                        for side in zip(outline, outline[1:] + outline[:1]))
        if crossings % 2 == 1:
            distance = min(math.dist(place, point) for point in outline)
            if distance > best[1]:
                best = place, distance
    return best


def clearance(place, outline):
    """Distance from a polygon's sides."""
    def distance(start, end):
        along = [b - a for a, b in zip(start, end)]
        share = sum((p - a) * d for p, a, d in zip(place, start, along)) / sum(d * d for d in along)
        return math.dist(place, [a + min(max(share, 0), 1) * d for a, d in zip(start, along)])
    return min(distance(*side) for side in zip(outline, outline[1:] + outline[:1]))
