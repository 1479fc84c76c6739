"""Random scenes, each made from its seed alone.  Standard library only.

A star-shaped polygon of 4 to 9 corners, radii varying 1 : 6, in every third scene with arcs for
some of its sides; diameters from 1e-3 to 1e3,
E from 1 to 1e11, nu from 0 to 0.49; one or two sides in contact, with every law, kind of gap and
basis; every strategy; but for a cap on the size all other keys have their defaults.  Each scene has a solution, since
nothing but deformation answers its load: see HELD.
"""
import math
import random

from outlines import bulges, polygon

LAWS = {"None": (), "Tresca": ("Threshold",), "Coulomb": ("Coefficient",),
        "Capped Coulomb": ("Coefficient", "Cap")}
BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal")
STRATEGIES = ("None", "Uniform h", "Uniform p", "Adaptive h", "Adaptive hp", "Graded hp")
GAPS = ("zero", "constant", "tilted", "parabola", "wave")
# Clamped on a side; held in the mean; held by a roller on an oblique side, along an axis or along its
# normal, which leaves one motion to be held in the mean; pressed onto a contact side, so that this
# carries the load.
HELD = ("clamp", "mean", "roller", "pressed")
DOF = 600


class Scene:
    """One scene: what was drawn, and its keys."""

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random(seed)
        self.held = draw.choice(HELD)
        self.basis = draw.choice(BASES)
        self.strategy = draw.choice(STRATEGIES)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.ratio = draw.uniform(0, 0.49)
        self.diameter = 10 ** draw.uniform(-3, 3)
        self.energy = self.modulus * self.diameter ** 2
        self.stress = self.modulus * 10 ** draw.uniform(-5, -2)  # of the loads
        self.corners = self.turned(polygon(draw))
        self.sides = len(self.corners)
        self.bulges = bulges(random.Random("%d arcs" % seed), self.corners) if seed % 3 == 2 else []
        self.kinds = self.assign()
        self.laws = []
        self.conditions = [self.condition(k) for k in range(self.sides)]

    def turned(self, corners):
        """At its size; if pressed, side 0 faces down."""
        if self.held == "pressed":
            (x, y), (a, b) = corners[:2]
            angle = -math.atan2(b - y, a - x)
        else:
            angle = self.draw.uniform(0, 2 * math.pi)
        c, s = math.cos(angle), math.sin(angle)
        size = self.diameter / max(math.dist(p, q) for p in corners for q in corners)
        return [(size * (c * x - s * y), size * (s * x + c * y)) for x, y in corners]

    def assign(self):
        """What each side is: contact, support (clamp or roller), load or free."""
        draw, kinds = self.draw, ["free"] * self.sides
        sides = list(range(self.sides))
        draw.shuffle(sides)
        if self.held == "pressed":
            sides.remove(0)
            sides.insert(0, 0)
        contacts = draw.choice((1, 2)) if self.sides > 4 or self.held != "clamp" else 1
        for _ in range(contacts):
            kinds[sides.pop(0)] = "contact"
        if self.held in ("clamp", "roller"):
            kinds[sides.pop(0)] = "support"
        kinds[sides.pop(0)] = "load"
        for k in sides:
            kinds[k] = draw.choice(("load", "free"))
        return kinds

    def along(self, k):
        """The place on side k, 0 to 1, as an expression; exact digits are not needed."""
        (x, y), (a, b) = self.corners[k], self.corners[(k + 1) % self.sides]
        square = (a - x) ** 2 + (b - y) ** 2
        return "((x - (%.9g))*(%.9g) + (y - (%.9g))*(%.9g))" % (
            x, (a - x) / square, y, (b - y) / square)

    def gap(self, k):
        """Nowhere negative, of the order of what the loads move."""
        draw, place = self.draw, self.along(k)
        size = self.diameter * self.stress / self.modulus * 10 ** draw.uniform(-2, 0.5)
        kind = draw.choice(GAPS)
        return {
            "zero": "0",
            "constant": "%.6g" % size,
            "tilted": "%.6g*%s" % (size, place),
            "parabola": "%.6g*(%s - %.4g)^2" % (4 * size, place, draw.uniform(0, 1)),
            "wave": "%.6g*(1 + sin(%.4g*%s + %.4g))" % (
                size / 2, draw.uniform(3, 20), place, draw.uniform(0, 6)),
        }[kind]

    def strength(self, k, field):
        """A friction coefficient up to 1, or a shear stress up to the loads': the same along the
        side, linear, or zero on a part."""
        draw, place = self.draw, self.along(k)
        most = draw.uniform(0, 1) * (1 if field == "Coefficient" else self.stress)
        return draw.choice(("%.6g" % most, "%.6g*abs(1 - %s)" % (most, place),
                            "%.6g*(%s < %.4g)" % (most, place, draw.uniform(0.2, 0.8))))

    def condition(self, k):
        draw = self.draw
        if self.kinds[k] == "contact":
            law = draw.choice(list(LAWS))
            self.laws.append(law)
            friction = {"Law": law, **{field: self.strength(k, field) for field in LAWS[law]}}
            return {"Type": "Contact", "Gap": self.gap(k), "Friction": friction}
        if self.kinds[k] == "support":
            held = "XY" if self.held == "clamp" else draw.choice("XY")
            if self.held == "roller" and random.Random("%d normal" % self.seed).random() < 0.5:
                held = ["Normal"]
            return {"Type": "Dirichlet", **{"Displacement " + axis: "0" for axis in held}}
        if self.kinds[k] == "load":
            return {"Type": "Neumann", **self.traction(k)}
        return None

    def traction(self, k):
        draw, place = self.draw, self.along(k)
        parts = []
        for _ in range(2):
            mean, slope = (self.stress * draw.uniform(-1, 1) for _ in range(2))
            parts.append("%.6g + %.6g*%s" % (mean, slope, place))
        if self.held == "pressed":  # downward everywhere
            mean, slope = self.stress * draw.uniform(-1, -0.1), draw.uniform(-1, 1)
            parts[1] = "%.6g*(1 + %.6g*(%s - 0.5))" % (mean, slope, place)
        return {"Traction X": parts[0], "Traction Y": parts[1]}

    def fixed(self):
        """Motions held in the mean."""
        if self.held == "clamp":
            return []
        if self.held == "roller":
            k = self.kinds.index("support")
            if "Displacement Normal" in self.conditions[k]:  # it goes along a line or turns about a centre
                (x, y), (a, b) = self.corners[k], self.corners[(k + 1) % self.sides]
                turns = self.bulges and self.bulges[k]
                return ["Rotation" if turns else "X" if abs(a - x) > abs(b - y) else "Y"]
            return ["Y" if "Displacement X" in self.conditions[k] else "X"]
        return ["X", "Rotation"] if self.held == "pressed" else ["X", "Y", "Rotation"]

    def scene(self):
        draw = self.draw
        names = ["s%d" % k for k in range(self.sides)]
        # A dual basis wants a free node in each element of contact.
        elements = [max(draw.randint(1, 5), 2 if kind == "contact" else 1)
                    for kind in self.kinds]
        body = {
            "Material": {"Young's Modulus": self.modulus, "Poisson's Ratio": self.ratio},
            "Geometry": {"Vertices": self.corners, "Edges": names},
            "Boundary Conditions": {name: condition for name, condition in zip(
                names, self.conditions) if condition}}
        if self.bulges:
            body["Geometry"]["Bulges"] = self.bulges
        if self.fixed():
            body["Rigid Motions"] = {"Fix": self.fixed()}
        return {
            "Bodies": {"body": body},
            "Discretization": {"Elements per Edge": elements, "Multiplier": self.basis},
            "Adaptivity": {"Strategy": self.strategy, "Maximum Degrees of Freedom": DOF},
            "Output": {"Fields": False}, **self.more()}

    def more(self):
        """Further lists of the scene."""
        return {}
