"""Random scenes of any kind with further features, each of them or not, drawn from a seed alone."""
import math
import random

from bodies import Rings, ThreeBodies, TwoBodies
from oddities import Oddities
from outlines import arc, opposite
from scenes import LAWS, Scene


def lists(keys):
    """All lists in a list."""
    for value in keys.values():
        if isinstance(value, dict):
            yield value
            yield from lists(value)


class Products:
    """A scene of every kind times: bodies of nu = 1/2 where the conditions allow it; a hole, free,
    under pressure or about a plug; a path on which loads and overlaps come and go; weight, spin and
    heat inside, by any form of the stabilisation.  `paths`: may it have a History?"""

    KINDS = (Scene, TwoBodies, ThreeBodies, Rings, Oddities)

    def __init__(self, seed, paths=True):
        draw = self.draw = random.Random("%d products" % seed)
        scene = draw.choice(self.KINDS)(draw.randrange(10 ** 6))
        self.root = scene.scene()
        self.seed, self.laws = seed, list(scene.laws)
        self.basis, self.strategy = scene.basis, scene.strategy
        self.stress = scene.stress
        size = scene.diameter if isinstance(scene, Scene) else scene.size
        self.size, self.energy = size, scene.modulus * size ** 2
        self.bodies = {name: body for name, body in self.root["Bodies"].items()
                       if "Rigid" not in body["Material"]}
        self.between = [contact["Between"] for contact in self.root.get("Contacts", {}).values()]
        if draw.random() < 0.5:
            self.hole(draw.choice(list(self.bodies.values())))
        if draw.random() < 0.7:
            for name, body in self.bodies.items():
                self.incompressible(name, body)
        if "History" in self.root and not paths:
            del self.root["History"]
        elif "History" not in self.root and paths and draw.random() < 0.5:
            self.path()
        if draw.random() < 0.5:
            self.inside(scene, size)
        self.springs()

    def springs(self):
        """Of bodies without elasticity, each component or not, from a draw of their own."""
        draw = random.Random("%d springs" % self.seed)
        units = {"X": ("Displacement X", "Force X", 0), "Y": ("Displacement Y", "Force Y", 0),
                 "Rotation": ("Rotation", "Moment", 1)}
        moduli = [modulus(body) for body in self.bodies.values()]
        move = self.size * self.stress / max(moduli)
        for name, body in self.root["Bodies"].items():
            for key, (moved, pushed, power) in units.items():
                if name in self.bodies or draw.random() < 0.3:
                    continue
                motion = body.setdefault("Motion", {})
                motion["Stiffness " + key] = (
                    moduli[0] * self.size ** (2 * power) * 10 ** draw.uniform(-9, 9))
                if draw.random() < 0.5:
                    motion[moved] = move / self.size ** power * draw.uniform(-1, 1)
                if draw.random() < 0.5:
                    motion[pushed] = self.stress * self.size ** (1 + power) * draw.uniform(-0.2, 0.2)

    def inside(self, scene, size):
        """Forces of all bodies at the root, heat of each by itself.  What is free to fall has nothing
        but weight, downwards."""
        draw, factor = self.draw, ""
        if "History" in self.root:
            factor = "*(0.6 + 0.4*sin(%.3g*t + %.3g))" % (draw.uniform(1, 4), draw.uniform(0, 6))
        held = isinstance(scene, Rings) or isinstance(scene, Scene) and scene.held in ("clamp", "mean")
        force = self.stress / size  # per volume
        kinds = [kind for kind in ("weight", "spin", "heat") if draw.random() < 0.6]
        loads = {}
        if "weight" in kinds:
            name = draw.choice(("Gravity", "Force"))
            loads[name + " Y"] = -force * draw.uniform(0.1, 1)
            if held:
                loads[name + " X"] = force * draw.uniform(-1, 1)
        if "spin" in kinds and held:
            loads["Spin"] = (force / size * draw.uniform(0, 1)) ** 0.5
            loads["Angular Acceleration"] = force / size * draw.uniform(-1, 1)
        for body in self.root["Bodies"].values():
            body["Material"]["Density"] = draw.uniform(0.5, 2)
        for owner in self.bodies.values() if "heat" in kinds else [self.root]:
            inner = {key: "(%.6g)%s" % (value, factor) for key, value in loads.items()}
            if loads or "heat" in kinds:
                owner["Body Loads"] = inner
            if "heat" in kinds:
                owner["Material"]["Thermal Expansion"] = 1e-5
                strain = self.stress / modulus(owner) / 1e-5
                if draw.random() < 0.5:
                    self.conduction(owner, strain, factor)
                    continue
                terms = ["%.4g*(x/%.6g)^%d*(y/%.6g)^%d" % (
                    draw.uniform(-1, 1), size, a, size, b)
                    for a, b in ((0, 0), (1, 0), (draw.randint(0, 2), draw.randint(0, 2)))]
                inner["Temperature"] = "%.6g*(%s)%s" % (strain, " + ".join(terms), factor)
        if self.basis != "Biorthogonal" and "Stabilization" not in self.root["Discretization"]:
            self.stabilise(draw.choice(("Density", "Projected", "Exact")))

    def stabilise(self, form):
        self.root["Discretization"]["Stabilization"] = {"Form": form}

    def conduction(self, body, strain, factor):
        """One temperature, so that it meets no other one, on some boundaries; on others a flux."""
        draw, geometry = self.draw, body["Geometry"]
        names = sorted({*geometry["Edges"], *geometry.get("Hole 1 Edges", [])})
        draw.shuffle(names)
        held = draw.randint(1, len(names))
        place = draw.choice(("x", "y"))
        inner = body["Thermal Conditions"] = {}
        strain *= draw.uniform(-1, 1)
        for k, name in enumerate(names):
            if k < held:
                inner[name] = {"Temperature": "%.6g*(1 + %s/%.6g)%s" % (
                    strain, place, self.size, factor)}
            elif draw.random() < 0.7:
                inner[name] = {"Heat Flux": "%.6g*(0.3 + n%s)%s" % (
                    strain * draw.uniform(-1, 1) / self.size, place, factor)}

    def scene(self):
        return self.root

    def hole(self, body):
        """In the widest place of an outline without one."""
        draw, geometry = self.draw, body["Geometry"]
        if "Hole 1 Vertices" in geometry:
            return
        corners = geometry["Vertices"]
        bulges = geometry.get("Bulges", [0] * len(corners))
        outline = [point for k, start in enumerate(corners)
                   for point in arc(start, corners[(k + 1) % len(corners)], bulges[k], 24)[:-1]]
        middle, distance = widest(draw, outline)
        # sides of thin bodies pass between the points
        radius = min(distance * draw.uniform(0.2, 0.6), 0.6 * clearance(middle, outline))
        count = draw.randint(2, 5)
        bulge = math.tan(math.pi / (2 * count)) if count == 2 or draw.random() < 0.5 else 0
        turn = draw.uniform(0, 2 * math.pi)
        geometry.update({
            "Hole 1 Vertices": [(middle[0] + radius * math.cos(turn + 2 * math.pi * k / count),
                                 middle[1] + radius * math.sin(turn + 2 * math.pi * k / count))
                                for k in range(count)],
            "Hole 1 Edges": ["hole"] * count, "Hole 1 Bulges": [bulge] * count})
        mesh = body.get("Mesh", self.root["Discretization"])
        if "Elements per Edge" in mesh:
            mesh["Hole 1 Elements per Edge"] = [draw.randint(2, 3) for _ in range(count)]
        self.root["Adaptivity"]["Maximum Degrees of Freedom"] += 100  # a first mesh may need it
        kind = draw.choice(("free", "pressure", "plug"))
        if kind == "free":
            return
        condition = body.setdefault("Boundary Conditions", {})["hole"] = {}
        if kind == "pressure":
            pressure = self.stress * draw.uniform(-1, 1)
            condition.update({"Type": "Neumann", "Traction X": "%.6g*nx" % pressure,
                              "Traction Y": "%.6g*ny" % pressure})
            return
        law = draw.choice(list(LAWS))
        self.laws.append(law)
        condition.update({
            "Type": "Contact",
            "Gap": draw.choice((0, radius * self.stress / modulus(body) * draw.uniform(0, 1))),
            "Friction": {"Law": law, **{field: draw.uniform(0, 1) * (
                1 if field == "Coefficient" else self.stress) for field in LAWS[law]}}})

    def incompressible(self, name, body):
        """Where each closed line carries stresses of contact, or has a side without a given
        displacement."""
        carried, bound = ({side.split(":")[1] for both in self.between for side in both[:count]
                           if side.split(":")[0] == name} for count in (1, 2))
        for boundary, condition in body.get("Boundary Conditions", {}).items():
            if condition["Type"] == "Contact":
                carried.add(boundary)
            if condition["Type"] == "Dirichlet":
                bound.add(boundary)
        for line in ("Edges", "Hole 1 Edges"):
            names = set(body["Geometry"].get(line, []))
            if names and not names & carried and names <= bound:
                return
        body["Material"]["Poisson's Ratio"] = 0.5
        self.stabilise("Density")
        if self.basis == "Biorthogonal":  # has no stabilisation
            self.basis = self.root["Discretization"]["Multiplier"] = "Gauss-Legendre-Lagrange"

    def path(self):
        draw = self.draw
        for keys in lists(self.root):
            for key in [key for key in keys if key in ("Traction X", "Traction Y", "Interference")]:
                keys[key] = "(%s)*(0.6 + 0.4*sin(%.3g*t + %.3g))" % (
                    keys[key], draw.uniform(1, 4), draw.uniform(0, 6))
        self.root["History"] = {"Times": [1, 3], "Steps": [draw.randint(1, 3), draw.randint(2, 4)]}


def modulus(body):
    return body["Material"]["Young's Modulus"]


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
