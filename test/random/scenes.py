"""Random scenes, each made from its seed alone.  Standard library only.

A star-shaped polygon of 4 to 9 corners, radii varying 1 : 6, in every third scene with arcs for
some of its sides; diameters from 1e-3 to 1e3,
E from 1 to 1e11, nu from 0 to 0.49; one or two sides in contact, with every law, kind of gap and
basis; every strategy; but for a cap on the size all other keys have their defaults.  Each scene has a solution, since
nothing but deformation answers its load: see HELD.
"""
import math
import random

LAWS = {"None": (), "Tresca": ("Threshold",), "Coulomb": ("Coefficient",),
        "Capped Coulomb": ("Coefficient", "Cap")}
BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal")
STRATEGIES = ("None", "Uniform h", "Uniform p", "Adaptive h", "Adaptive hp", "Graded hp")
GAPS = ("zero", "constant", "tilted", "parabola", "wave")
# Clamped on a side; held in the mean; held by a roller on an oblique side, which leaves one
# motion to be held in the mean; pressed onto a contact side, so that this carries the load.
HELD = ("clamp", "mean", "roller", "pressed")
DOF = 600


class Scene:
    """One scene: what was drawn, and its text."""

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random(seed)
        self.held = draw.choice(HELD)
        self.basis = draw.choice(BASES)
        self.strategy = draw.choice(STRATEGIES)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.ratio = draw.uniform(0, 0.49)
        self.diameter = 10 ** draw.uniform(-3, 3)
        self.stress = self.modulus * 10 ** draw.uniform(-5, -2)  # of the loads
        self.corners = self.turned(polygon(draw))
        self.sides = len(self.corners)
        self.bulges = bulges(random.Random("%d arcs" % seed), self.corners) if seed % 3 == 2 else []
        self.kinds = self.assign()
        self.laws, self.gaps = [], []
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
        self.gaps.append(kind)
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
            friction = text("Law", law) + "".join(text(field, self.strength(k, field))
                                                  for field in LAWS[law])
            return text("Type", "Contact") + text("Gap", self.gap(k)) + sublist(
                "Friction", friction)
        if self.kinds[k] == "support":
            both = text("Displacement X", "0") + text("Displacement Y", "0")
            return text("Type", "Dirichlet") + (both if self.held == "clamp" else
                                                text("Displacement " + draw.choice("XY"), "0"))
        if self.kinds[k] == "load":
            return text("Type", "Neumann") + self.traction(k)
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
        return text("Traction X", parts[0]) + text("Traction Y", parts[1])

    def fixed(self):
        """Motions held in the mean."""
        if self.held == "clamp":
            return []
        if self.held == "roller":
            support = next(c for c, kind in zip(self.conditions, self.kinds)
                           if kind == "support")
            return ["Y" if "Displacement X" in support else "X"]
        return ["X", "Rotation"] if self.held == "pressed" else ["X", "Y", "Rotation"]

    def xml(self):
        draw = self.draw
        names = ["s%d" % k for k in range(self.sides)]
        points = ", ".join("%.12g,%.12g" % corner for corner in self.corners)
        # A dual basis wants a free node in each element of contact.
        elements = [str(max(draw.randint(1, 5), 2 if kind == "contact" else 1))
                    for kind in self.kinds]
        body = sublist("Material", real("Young's Modulus", self.modulus) +
                       real("Poisson's Ratio", self.ratio))
        body += sublist("Geometry", parameter("Vertices", "TwoDArray(double)", "%dx2:{%s}" % (
            self.sides, points)) + parameter("Edges", "Array(string)",
                                             "{%s}" % ", ".join(names)) +
                       (parameter("Bulges", "Array(double)", "{%s}" % ", ".join(
                           "%.9g" % bulge for bulge in self.bulges)) if self.bulges else ""))
        body += sublist("Boundary Conditions", "".join(
            sublist(name, condition) for name, condition in zip(names, self.conditions)
            if condition))
        if self.fixed():
            body += sublist("Rigid Motions", parameter(
                "Fix", "Array(string)", "{%s}" % ", ".join(self.fixed())))
        return sublist("Random scene %d" % self.seed, sublist("Bodies", sublist("body", body)) +
                       sublist("Discretization", parameter(
                           "Elements per Edge", "Array(int)", "{%s}" % ", ".join(elements)) +
                           text("Multiplier", self.basis)) +
                       sublist("Adaptivity", text("Strategy", self.strategy) +
                               parameter("Maximum Degrees of Freedom", "int", "%d" % DOF)) +
                       sublist("Output", parameter("Fields", "bool", "false")) + self.more())

    def more(self):
        """Further lists of the scene."""
        return ""


class Oddities(Scene):
    """A scene with one thing out of the ordinary, see TWISTS; laws with coefficients up to 3 and thresholds
    and caps of zero among them, sides of support and contact that touch."""

    # Loose: nothing but contact and friction holds the body, on a broad base.  All around: every
    # side is in contact but one.
    TWISTS = ("far", "thin", "units", "incompressible", "open", "unloaded", "path", "table", "loose",
              "all around", "strong friction", "no friction")

    def __init__(self, seed):
        draw = random.Random("%d twist" % seed)
        self.twist = self.TWISTS[seed % len(self.TWISTS)]
        self.twisted = draw
        super().__init__(seed)
        self.gaps = [self.twist]

    def turned(self, corners):
        draw, twist = self.twisted, self.twist
        if twist == "incompressible":
            self.ratio = 0.5 - 10 ** draw.uniform(-4, -2)
        if twist == "units":
            self.diameter = 10 ** draw.uniform(-6, 6)
        if twist == "unloaded":
            self.stress = 0
        if twist == "thin":
            corners = [(x, y / 30) for x, y in corners]
        if twist in ("loose", "all around"):
            self.held = "pressed" if twist == "loose" else "mean"
        if twist == "loose":
            corners = [(-1, 0), (1, 0), (draw.uniform(0.2, 1.2), draw.uniform(0.3, 3)),
                       (draw.uniform(-1.2, -0.2), draw.uniform(0.3, 3))]
        corners = super().turned(corners)
        far = self.diameter * 1e3 if twist == "far" else 0
        return [(x + far, y - far) for x, y in corners]

    def assign(self):
        if self.twist == "loose":
            return ["contact", "free", "load", "free"]
        if self.twist == "all around":
            return ["contact"] * (self.sides - 1) + ["load"]
        return super().assign()

    def gap(self, k):
        if self.twist == "loose":
            return "0"
        size = self.diameter * self.stress / self.modulus
        if self.twist == "open":
            # out of reach of a body that something else holds; one that is pressed falls as far
            return "%.6g*(1 + %s)" % (100 * size, self.along(k))
        if self.twist == "table":
            return "%.6g*profile(%s)" % (size, self.along(k))
        if self.twist == "unloaded":
            return self.twisted.choice(("0", "%.6g*abs(%s)" % (1e-3 * self.diameter, self.along(k))))
        return super().gap(k)

    def strength(self, k, field):
        draw = self.twisted
        if self.twist == "no friction":
            return "0"
        if self.twist == "loose":
            return "%.6g" % draw.uniform(0.5, 1)
        if self.twist == "strong friction" and field == "Coefficient":
            return "%.6g" % draw.uniform(1, 3)
        return super().strength(k, field)

    def condition(self, k):
        if self.twist == "loose" and self.kinds[k] == "contact":
            self.laws.append("Coulomb")
            return text("Type", "Contact") + text("Gap", "0") + sublist(
                "Friction", text("Law", "Coulomb") + text("Coefficient", self.strength(k, "")))
        return super().condition(k)

    def traction(self, k):
        if self.twist == "loose":  # well within the base and the friction cone
            push = self.twisted.uniform(-0.03, 0.03)
            return text("Traction X", "%.6g" % (push * self.stress)) + text(
                "Traction Y", "%.6g" % -self.stress)
        if self.twist == "path":
            x, y = ("(%s)*%s" % (self.stress * self.draw.uniform(-1, 1), phase)
                    for phase in ("cos(2*t)", "sin(3*t)"))
            if self.held == "pressed":
                y = "%.6g*(0.55 + 0.45*sin(3*t))" % -self.stress
            return text("Traction X", x) + text("Traction Y", y)
        return super().traction(k)

    def fixed(self):
        return [] if self.twist == "loose" else super().fixed()

    def more(self):
        if self.twist == "path":
            return sublist("History", parameter("Times", "Array(double)", "{0.5, 2}") +
                           parameter("Steps", "Array(int)", "{2, 4}"))
        if self.twist == "table":
            values = ", ".join("%.4g, %.4g" % (k / 6, self.twisted.uniform(0, 1)) for k in range(-6, 13))
            return sublist("Tables", sublist("profile", text("Interpolation", self.twisted.choice(
                ("Linear", "Cubic", "Spline"))) + parameter(
                    "Points", "TwoDArray(double)", "19x2:{%s}" % values)))
        return ""


class TwoBodies:
    """One body pressed onto another, or bonded to it: the upper one's side 0 faces down, the lower
    one's up, straight or arcs that bulge; all else of both is on its own side.  Moduli up to
    1 : 1000, sizes 1 : 10; either side first; every law and Tied, basis and strategy; overlaps and
    gaps.  The lower one is clamped, held in the mean, or rigid."""

    LAWS = dict(LAWS, Tied=())
    dof = DOF

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random("%d bodies" % seed)
        self.held = draw.choice(("clamp", "mean", "rigid"))
        self.basis = draw.choice(BASES)
        self.strategy = draw.choice(STRATEGIES)
        self.law = draw.choice(list(self.LAWS))
        self.laws = [self.law]
        self.modulus = 10 ** draw.uniform(0, 11)
        self.size = 10 ** draw.uniform(-3, 3)
        self.stress = self.modulus * 10 ** draw.uniform(-5, -2)
        self.upper = self.outline(1)
        self.lower = self.outline(-1)
        self.first = draw.choice(("upper", "lower")) if self.held != "rigid" else "upper"
        self.gaps = [draw.choice(("zero", "overlap", "parabola"))]

    def outline(self, way):
        """Corners and bulges; side 0 on y = 0 from right to left of its body's inside."""
        draw = self.draw
        size = self.size * (1 if way > 0 else 10 ** draw.uniform(-0.5, 0.5))
        while True:
            corners = polygon(draw)
            (x, y), (a, b) = corners[:2]
            angle = -math.atan2(b - y, a - x)
            c, s = math.cos(angle), math.sin(angle)
            corners = [(c * (p - (x + a) / 2) - s * (q - (y + b) / 2),
                        s * (p - (x + a) / 2) + c * (q - (y + b) / 2)) for p, q in corners]
            width = max(math.dist(p, q) for p in corners for q in corners)
            # the angle at side 0's ends at least 10 degrees and the rest clear of it
            if all(q > 0.02 * width + 0.2 * max(0, abs(p) - corners[1][0]) for p, q in corners[2:]):
                break
        bulge = draw.choice((0, 10 ** draw.uniform(-3, -1)))
        sagitta = corners[1][0] * bulge
        shift = draw.uniform(-0.3, 0.3) * corners[1][0] if way > 0 else 0
        # the lower one is turned by half a turn
        corners = [(way * size / width * p + size / width * shift,
                    way * size / width * (q + sagitta)) for p, q in corners]
        return corners, [bulge] + [0] * (len(corners) - 1)

    def body(self, name, modulus, ratio):
        draw = self.draw
        corners, values = getattr(self, name)
        count = len(corners)
        names = ["contact"] + ["s%d" % k for k in range(1, count)]
        rigid = name == "lower" and self.held == "rigid"
        inner = sublist("Material", parameter("Rigid", "bool", "true") if rigid else
                        real("Young's Modulus", modulus) + real("Poisson's Ratio", ratio))
        inner += sublist("Geometry", parameter("Vertices", "TwoDArray(double)", "%dx2:{%s}" % (
            count, ", ".join("%.15g,%.15g" % c for c in corners))) + parameter(
                "Edges", "Array(string)", "{%s}" % ", ".join(names)) + parameter(
                    "Bulges", "Array(double)", "{%s}" % ", ".join("%.9g" % b for b in values)))
        if rigid:
            return sublist(name, inner)
        away = names[2]  # no neighbour of the contact side
        condition, fix = "", ""
        if name == "upper":
            condition = sublist(away, text("Type", "Neumann") + text(
                "Traction X", "%.6g" % (self.stress * draw.uniform(-0.2, 0.2))) + text(
                    "Traction Y", "%.6g" % (-self.stress * draw.uniform(0.1, 1))))
            fix = "X, Rotation"
        elif self.held == "clamp":
            condition = sublist(away, text("Type", "Dirichlet") + text("Displacement X", "0") +
                                text("Displacement Y", "0"))
        else:
            fix = "X, Y, Rotation"
        inner += sublist("Boundary Conditions", condition)
        if fix:
            inner += sublist("Rigid Motions", parameter("Fix", "Array(string)", "{%s}" % fix))
        elements = [draw.randint(2, 7)] + [draw.randint(1, 4) for _ in range(count - 1)]
        inner += sublist("Mesh", parameter("Elements per Edge", "Array(int)", "{%s}" % ", ".join(
            map(str, elements))) + parameter("Degree", "int", "%d" % draw.randint(1, 4)))
        return sublist(name, inner)

    def xml(self):
        draw = self.draw
        interference = self.interference(self.gaps[0])
        friction = self.friction(self.law)
        second = {"upper": "lower", "lower": "upper"}[self.first]
        bodies = self.body("upper", self.modulus, draw.uniform(0, 0.49)) + self.body(
            "lower", self.modulus * 10 ** draw.uniform(-3, 3), draw.uniform(0, 0.49))
        return self.scene("two bodies", bodies, self.contact(
            "joint", self.first + ":contact", second + ":contact", interference, friction))

    def interference(self, gap):
        draw, length = self.draw, self.size * self.stress / self.modulus  # what the load moves
        if gap == "zero":
            return "0"
        if gap == "overlap":
            return "%.6g" % (length * draw.uniform(-1, 1))
        return "%.6g*(x/%.6g)^2" % (-length * 10 ** draw.uniform(-1, 1), self.size)

    def friction(self, law):
        draw = self.draw
        fields = {"Threshold": draw.uniform(0, 1) * self.stress, "Cap": draw.uniform(0, 1) * self.stress,
                  "Coefficient": draw.uniform(0, 1)}
        return text("Law", law) + "".join(
            text(field, "%.6g" % fields[field]) for field in self.LAWS[law])

    def contact(self, name, first, second, interference, friction):
        return sublist(name, parameter("Between", "Array(string)", "{%s, %s}" % (first, second)) +
                       text("Interference", interference) + sublist("Friction", friction))

    def scene(self, kind, bodies, contacts):
        return sublist("Random scene %d of %s" % (self.seed, kind), sublist("Bodies", bodies) +
                       sublist("Contacts", contacts) +
                       sublist("Discretization", text("Multiplier", self.basis) +
                               real("Mesh Size", 10 * self.size)) +
                       sublist("Adaptivity", text("Strategy", self.strategy) +
                               parameter("Maximum Degrees of Freedom", "int", "%d" % self.dof)) +
                       sublist("Output", parameter("Fields", "bool", "false")))


class ThreeBodies(TwoBodies):
    """A plate between the two, pressed and rubbed from both sides, each with a law of its own."""

    def __init__(self, seed):
        super().__init__(seed)
        draw = self.draw
        self.laws.append(draw.choice(list(self.LAWS)))
        self.gaps.append(draw.choice(("zero", "overlap")))
        self.height = self.size * 10 ** draw.uniform(-1.5, 0)
        corners, values = self.lower
        self.lower = [(x, y - self.height) for x, y in corners], values
        self.plate = 0.5 * self.size * 10 ** draw.uniform(-0.3, 0.5)  # half its width

    def middle(self):
        draw, w, h = self.draw, self.plate, self.height
        return sublist("middle", sublist("Material", real(
            "Young's Modulus", self.modulus * 10 ** draw.uniform(-2, 2)) +
            real("Poisson's Ratio", draw.uniform(0, 0.49))) + sublist("Geometry", parameter(
                "Vertices", "TwoDArray(double)", "4x2:{%.15g,%.15g, %.15g,%.15g, %.15g,0, %.15g,0}" % (
                    -w, -h, w, -h, w, -w)) + parameter(
                        "Edges", "Array(string)", "{bottom, side, top, side}")) +
            sublist("Rigid Motions", parameter("Fix", "Array(string)", "{X, Rotation}")) +
            sublist("Mesh", parameter("Elements per Edge", "Array(int)", "{%d, 1, %d, 1}" % (
                draw.randint(2, 7), draw.randint(2, 7))) +
                parameter("Degree", "int", "%d" % draw.randint(1, 4))))

    def xml(self):
        draw = self.draw
        bodies = self.body("upper", self.modulus, draw.uniform(0, 0.49)) + self.middle() + self.body(
            "lower", self.modulus * 10 ** draw.uniform(-3, 3), draw.uniform(0, 0.49))
        contacts = ""
        for name, sides, law, gap in zip(("above", "below"), (
                ["upper:contact", "middle:top"], ["middle:bottom", "lower:contact"]),
                self.laws, self.gaps):
            contacts += self.contact(name, *draw.sample(sides, 2), self.interference(gap),
                                     self.friction(law))
        return self.scene("three bodies", bodies, contacts)


class Rings(TwoBodies):
    """Two to four rings in one another, about a disc or a shaft without elasticity: press fits,
    fits with play and bonds, each circle of two to five arcs that begin anywhere; outside pressure
    of two waves and shear."""

    dof = 1000

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random("%d rings" % seed)
        self.basis = draw.choice(BASES)
        self.strategy = draw.choice(STRATEGIES)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.size = 10 ** draw.uniform(-3, 3)
        self.stress = self.modulus * 10 ** draw.uniform(-5, -2)
        self.held = draw.choice(("disc", "hole", "rigid"))
        self.radii = [self.size]
        for _ in range(draw.randint(1, 3)):
            self.radii.append(self.radii[-1] * draw.uniform(1.1, 2.5))
        self.laws = [draw.choice(list(self.LAWS)) for _ in self.radii[1:]]
        self.gaps = [draw.choice(("zero", "overlap")) for _ in self.radii[1:]]

    def circle(self, radius, name, hole=""):
        draw = self.draw
        count = draw.randint(2, 5)
        start = draw.uniform(0, 2 * math.pi)
        corners = [(radius * math.cos(start + 2 * math.pi * k / count),
                    radius * math.sin(start + 2 * math.pi * k / count)) for k in range(count)]
        return parameter(hole + "Vertices", "TwoDArray(double)", "%dx2:{%s}" % (
            count, ", ".join("%.16g,%.16g" % c for c in corners))) + parameter(
                hole + "Edges", "Array(string)", "{%s}" % ", ".join([name] * count)) + parameter(
                    hole + "Bulges", "Array(double)", "{%s}" % ", ".join(
                        ["%.16g" % math.tan(math.pi / (2 * count))] * count))

    def ring(self, k):
        """Between circle k - 1 and circle k."""
        draw = self.draw
        if k == 0 and self.held == "rigid":
            return sublist("body0", sublist("Material", parameter("Rigid", "bool", "true")) +
                           sublist("Geometry", self.circle(self.radii[0], "outside")))
        inner = self.radii[k - 1] if k > 0 else draw.uniform(0.2, 0.8) * self.radii[0]
        loops = self.circle(self.radii[k], "outside")
        if k > 0 or self.held == "hole":
            loops += self.circle(inner, "inside", "Hole 1 ")
        last = k == len(self.radii) - 1
        load = "%.6g + %.6g*cos(2*atan2(y, x))" % (
            self.stress * draw.uniform(0.5, 1), self.stress * draw.uniform(-1, 1))
        return sublist("body%d" % k, sublist("Material", real(
            "Young's Modulus", self.modulus * 10 ** draw.uniform(-1.5, 1.5)) +
            real("Poisson's Ratio", draw.uniform(0, 0.49))) + sublist("Geometry", loops) +
            (sublist("Boundary Conditions", sublist("outside", text("Type", "Neumann") + text(
                "Traction X", "-nx*(%s)" % load) + text("Traction Y", "-ny*(%s)" % load)))
             if last else "") +
            sublist("Rigid Motions", parameter("Fix", "Array(string)", "{X, Y, Rotation}")) +
            sublist("Mesh", real("Mesh Size", self.radii[k] * draw.uniform(0.5, 1.5)) +
                    parameter("Degree", "int", "%d" % draw.randint(1, 4))))

    def xml(self):
        draw, rings = self.draw, range(len(self.radii))
        bodies = "".join(self.ring(k) for k in rings)
        contacts = "".join(self.contact(
            "fit%d" % k, *draw.sample(["body%d:outside" % (k - 1), "body%d:inside" % k], 2),
            self.interference(self.gaps[k - 1]), self.friction(self.laws[k - 1])) for k in rings[1:])
        return self.scene("rings", bodies, contacts)


def polygon(draw):
    """Around the origin, which sees every corner; counter-clockwise."""
    count = draw.randint(4, 9)
    while True:
        shares = [draw.uniform(0.3, 1) for _ in range(count)]
        if max(shares) < 0.45 * sum(shares):
            break
    angles = [2 * math.pi * sum(shares[:k]) / sum(shares) for k in range(count)]
    radii = [draw.uniform(1, 6) for _ in range(count)]
    return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(radii, angles)]


def bulges(draw, corners):
    """Arcs for about half of the sides, up to 90 degrees, flattened until they keep clear of each
    other and meet at 10 degrees and more."""
    values = [draw.choice((0, draw.uniform(-0.4, 0.4))) for _ in corners]
    while not is_simple(corners, values):
        values = [value / 2 if abs(value) > 1e-3 else 0 for value in values]
        if not any(values):
            return []
    return values


def arc(start, end, bulge, pieces):
    """Points along an arc, its ends included."""
    (x, y), (a, b) = start, end
    angle = 4 * math.atan(bulge)
    points = []
    for k in range(pieces + 1):
        t = 2 * k / pieces - 1  # a chord has the direction of the tangent half way
        if bulge == 0:
            along, across = (1 + t) / 2, 0
        else:
            length = math.sin((1 + t) * angle / 4) / math.sin(angle / 2)
            along = length * math.cos((t - 1) * angle / 4)
            across = length * math.sin((t - 1) * angle / 4)
        points.append((x + along * (a - x) - across * (b - y), y + along * (b - y) + across * (a - x)))
    return points


def is_simple(corners, values):
    """By polygons of the arcs: no two lines that are not neighbours are near each other."""
    pieces = 12
    sides = [arc(corners[k], corners[(k + 1) % len(corners)], values[k], pieces)
             for k in range(len(corners))]
    for k, side in enumerate(sides):
        (x, y), (a, b), (c, d) = side[-2], side[-1], sides[(k + 1) % len(sides)][1]
        turn = math.atan2((a - x) * (d - b) - (b - y) * (c - a), (a - x) * (c - a) + (b - y) * (d - b))
        if abs(turn) > math.radians(170):
            return False
    points = [point for side in sides for point in side[:-1]]
    size = max(math.dist(p, q) for p in corners for q in corners)
    count = len(points)
    for i in range(count):
        for j in range(i + 2, count):
            if (j + 1) % count == i:
                continue
            a, b, c, d = points[i], points[i + 1], points[j], points[(j + 1) % count]
            if opposite(a, b, c, d) and opposite(c, d, a, b):
                return False
            if j - i > 2 * pieces and count - (j - i) > 2 * pieces and math.dist(a, c) < 0.02 * size:
                return False
    return True


def opposite(a, b, c, d):
    """Does the line through a and b part c from d?"""
    def side(p):
        return (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
    return side(c) * side(d) <= 0


def parameter(name, kind, value):
    value = value.replace("&", "&amp;").replace("<", "&lt;")
    return '<Parameter name="%s" type="%s" value="%s"/>\n' % (name, kind, value)


def text(name, value):
    return parameter(name, "string", value)


def real(name, value):
    return parameter(name, "double", "%.9g" % value)


def sublist(name, inner):
    return '<ParameterList name="%s">\n%s</ParameterList>\n' % (name, inner)
