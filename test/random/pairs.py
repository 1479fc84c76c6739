"""Random pairs of bodies of the shapes of everyday contact, each made from its seed alone.  Standard
library only."""
import math
import random

from bodies import unbalanced
from outlines import arc

QUARTER = math.tan(math.pi / 8)
LAWS = ("None", "None", "Coulomb")
MOST = 3  # times the weight that it carries may a normal force be


class Shape:
    """A body that stands on (0, 0): corners from its lowest edge on, counter-clockwise, bulges and the
    names of edges, of which "face" may touch and "far" is on the other side."""

    KINDS = ("box", "disc", "stadium", "pad", "dome")

    def __init__(self, draw, kind, width):
        w, h = width / 2, width * draw.uniform(0.4, 1.5)
        self.kind = kind
        if kind == "box":
            corners = [(-w, 0), (w, 0), (w, h), (-w, h)]
            self.bulges, self.names = [0] * 4, ["face", "side", "far", "side"]
        elif kind == "disc":
            corners = [(0, 0), (w, w), (0, 2 * w), (-w, w)]
            self.bulges, self.names = [QUARTER] * 4, ["face", "far", "far", "face"]
        elif kind == "stadium" and draw.random() < 0.5:  # upright
            corners = [(-w, w), (w, w), (w, w + h), (-w, w + h)]
            self.bulges, self.names = [1, 0, 1, 0], ["face", "side", "far", "side"]
        elif kind == "stadium":
            corners = [(-w, 0), (w, 0), (w, 2 * h), (-w, 2 * h)]
            self.bulges, self.names = [0, 1, 0, 1], ["face", "side", "far", "side"]
        elif kind == "pad":
            r = draw.uniform(0.1, 0.45) * min(w, h)
            corners = [(-w + r, 0), (w - r, 0), (w, r), (w, h), (-w, h), (-w, r)]
            self.bulges = [0, QUARTER, 0, 0, 0, QUARTER]
            self.names = ["face", "face", "side", "far", "side", "face"]
        else:
            bulge = 10 ** draw.uniform(-1.5, -0.3)
            rise = bulge * w
            corners = [(-w, rise), (w, rise), (w, rise + h), (-w, rise + h)]
            self.bulges, self.names = [bulge, 0, 0, 0], ["face", "side", "far", "side"]
        self.corners = corners

    def sides(self):
        count = len(self.corners)
        return [(self.corners[k], self.corners[(k + 1) % count], self.bulges[k]) for k in range(count)]

    def area(self):
        twice = 0
        for (x, y), (a, b), bulge in self.sides():
            angle = 4 * math.atan(bulge)
            twice += x * b - y * a
            if bulge:
                radius = math.dist((x, y), (a, b)) / (2 * math.sin(angle / 2))
                twice += radius ** 2 * (angle - math.sin(angle))
        return twice / 2

    def lowest(self, x):
        """The height of its lower boundary above x; None beside it."""
        found = []
        for start, end, bulge in self.sides():
            points = arc(start, end, bulge, 256 if bulge else 1)
            for (a, b), (c, d) in zip(points, points[1:]):
                if min(a, c) <= x <= max(a, c) and a != c:
                    found.append(b + (d - b) * (x - a) / (c - a))
        return min(found, default=None)

    def span(self):
        points = [point for side in self.sides() for point in arc(*side, 16)]
        return min(x for x, _ in points), max(x for x, _ in points)


class Race:
    """A ring whose hole stands on (0, 0), for a disc of this radius in it."""

    kind = "race"
    names = ["far"] * 4 + ["face"] * 4

    def __init__(self, draw, disc):
        self.disc = disc
        self.radius = disc * 10 ** draw.uniform(0.01, 1.1)
        self.outer = self.radius * draw.uniform(1.1, 1.5)

    def span(self):
        return -self.outer, self.outer

    @staticmethod
    def circle(radius, middle, name):
        corners = [(radius, 0), (0, radius), (-radius, 0), (0, -radius)]
        return {"Vertices": [(x, y + middle) for x, y in corners], "Edges": [name] * 4,
                "Bulges": [QUARTER] * 4}

    def geometry(self, far, face):
        hole = self.circle(self.radius, self.radius, face)
        return {**self.circle(self.outer, self.radius, far),
                **{"Hole 1 " + key: value for key, value in hole.items()}}

    def height(self, offset):
        """Of the disc's lowest point, when it touches beside the middle."""
        play = self.radius - self.disc
        return play - math.sqrt(play ** 2 - offset ** 2)


class Pairs:
    """One body on another, or in it: shapes, widths 1 : 6 and 6 : 1, one beside the middle of the other,
    drawn touching, with a gap or an overlap of what the load moves; all edges of a body under one name or not;
    the lower one clamped, held in the mean or rigid; pressed by weight, by a force, or moved.
    `swapped`: the other side first."""

    def __init__(self, seed, swapped=False):
        self.seed = seed
        draw = self.draw = random.Random("%d pairs" % seed)
        self.size = 10 ** draw.uniform(-3, 3)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.energy = self.modulus * self.size ** 2
        self.stress = self.modulus * 10 ** draw.uniform(-6, -3)
        if draw.random() < 0.15:
            self.upper = Shape(draw, "disc", self.size)
            self.lower = Race(draw, self.size / 2)
        else:
            self.upper = Shape(draw, draw.choice(Shape.KINDS), self.size)
            self.lower = Shape(draw, draw.choice(Shape.KINDS), self.size * 6 ** draw.uniform(-1, 1))
        self.whole = {name: draw.random() < 0.4 for name in ("upper", "lower")}  # under one name
        self.held = draw.choice(("clamp", "mean", "rigid"))
        if self.whole["lower"] and self.held == "clamp":
            self.held = "mean"
        self.load = draw.choice(("weight", "force", "move"))
        if self.whole["upper"] and self.load == "force":
            self.load = "weight"
        self.law = draw.choice(LAWS)
        self.laws = [self.law]
        self.basis = "Gauss-Legendre-Lagrange"
        self.graded = draw.random() < 0.3
        self.move = self.size * self.stress / self.modulus
        room = min(self.width(self.upper), self.width(self.lower))
        if self.lower.kind == "race":
            room = self.lower.radius - self.lower.disc
        self.offset = draw.choice((0, draw.uniform(-0.3, 0.3))) * room
        self.gap = draw.choice((0, 0, self.move, -self.move)) * draw.uniform(0, 1)
        self.height = self.touching() + self.gap
        self.weight = self.stress * self.size
        self.flip = (draw.random() < 0.5) != swapped

    @staticmethod
    def width(shape):
        left, right = shape.span()
        return right - left

    def touching(self):
        """How high the upper one stands on the lower one, turned over."""
        if self.lower.kind == "race":
            return self.lower.height(self.offset)
        left, right = self.upper.span()
        first, last = self.lower.span()
        left, right = max(left, first - self.offset), min(right, last - self.offset)
        most = -math.inf
        for k in range(401):
            x = left + (right - left) * k / 400
            above, below = self.upper.lowest(x), self.lower.lowest(-(x + self.offset))
            if above is not None and below is not None:
                most = max(most, -below - above)
        return most

    def named(self, name, edge):
        return "all" if self.whole[name] else edge

    def geometry(self, name):
        shape = getattr(self, name)
        if shape.kind == "race":
            return shape.geometry(self.named(name, "far"), self.named(name, "face"))
        place = ((lambda x, y: (x + self.offset, y + self.height)) if name == "upper"
                 else (lambda x, y: (-x, -y)))
        return {"Vertices": [place(*corner) for corner in shape.corners], "Bulges": shape.bulges,
                "Edges": [self.named(name, edge) for edge in shape.names]}

    def body(self, name):
        draw, shape = self.draw, getattr(self, name)
        body = {"Geometry": self.geometry(name)}
        if name == "lower" and self.held == "rigid":
            return {"Material": {"Rigid": True}, **body}
        softness = 10 ** draw.uniform(-1.5, 1.5) if name == "lower" else 1
        body["Material"] = {"Young's Modulus": self.modulus * softness,
                            "Poisson's Ratio": draw.uniform(0, 0.45)}
        contact = 8 if shape.kind in ("box", "stadium") else 16
        elements = [draw.randint(contact // 4, contact) if edge == "face" else draw.randint(1, 4)
                    for edge in shape.names]
        body["Mesh"] = {"Degree": draw.randint(1, 3), "Elements per Edge": elements}
        if shape.kind == "race":
            body["Mesh"].update({"Elements per Edge": elements[:4],
                                 "Hole 1 Elements per Edge": elements[4:]})
        if name == "lower":
            return {**body, **self.foot()}
        return {**body, **self.pushed()}

    def foot(self):
        if self.held == "clamp":
            return {"Boundary Conditions": {"far": {
                "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}}
        return {"Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}

    def pushed(self):
        if self.load == "weight":
            return {"Body Loads": {"Force Y": -self.weight / self.upper.area()},
                    "Rigid Motions": {"Fix": ["X", "Rotation"]}}
        if self.load == "force":
            return {"Boundary Conditions": {"far": {"Type": "Neumann", "Force Y": -self.weight}},
                    "Rigid Motions": {"Fix": ["X", "Rotation"]}}
        if not self.whole["upper"]:
            return {"Boundary Conditions": {"far": {
                "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": -self.move}}}
        return {"Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}

    def scene(self):
        draw = self.draw
        bodies = {"upper": self.body("upper"), "lower": self.body("lower")}
        contact = {"Between": [name + ":" + self.named(name, "face") for name in bodies],
                   "Friction": {"Law": self.law}}
        if self.law == "Coulomb":
            contact["Friction"]["Coefficient"] = draw.uniform(0, 0.8)
        if self.load == "move" and self.whole["upper"]:
            contact["Interference"] = self.move
        if self.flip:
            contact["Between"].reverse()
        adaptivity = {"Strategy": "None"}
        if self.graded:
            adaptivity = {"Strategy": "Graded hp", "Tolerance": 0.02,
                          "Maximum Degrees of Freedom": 1500}
        return {"Bodies": bodies, "Contacts": {"joint": contact},
                "Discretization": {"Degree": 1}, "Adaptivity": adaptivity,
                "Output": {"Fields": False}}

    def wrong(self, level, bodies):
        """What is wrong with a level, in words.  bodies: its rows of bodies.csv."""
        complaints = unbalanced(bodies, max(self.size, self.width(self.lower)))
        if self.load != "move" and self.law == "None" and level["force_normal"] > MOST * self.weight:
            complaints.append("presses with %.3g times the weight" % (level["force_normal"] / self.weight))
        return complaints
