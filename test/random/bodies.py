"""Random scenes of several bodies, each made from its seed alone.  Standard library only."""
import math
import random

from outlines import polygon
from scenes import BASES, DOF, LAWS, STRATEGIES

FREE = ["X", "Y", "Rotation"]
SMALL = 1e-9  # of the largest force


def elastic(modulus, ratio):
    return {"Young's Modulus": modulus, "Poisson's Ratio": ratio}


def unbalanced(bodies, arm, components="xy", size=None):
    """In words; bodies: rows of bodies.csv of one state.  Moments count over `arm`; `size`: of forces, else
    the largest one of contact."""
    found = []
    if size is None:
        size = max(abs(body["contact_" + c]) for body in bodies for c in "xy")
    for c in components:
        rest = abs(sum(body["contact_" + c] for body in bodies))
        if rest > SMALL * size:
            found.append("contact_%s adds to %.1e of the largest" % (c, rest / size))
    units = [(c, size) for c in components] + ([("moment", size * arm)] if "x" in components else [])
    for body in bodies if size > 0 else []:
        for c, unit in units:
            rest = abs(sum(body[kind + c] for kind in (
                "load_", "body_force_" if c != "moment" else "body_", "contact_", "reaction_")))
            if rest > SMALL * unit:
                found.append("%s is out of balance in %s by %.1e" % (body["body"], c, rest / unit))
    return found


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
        whole = {"Material": {"Rigid": True} if rigid else elastic(modulus, ratio),
                 "Geometry": {"Vertices": corners, "Edges": names, "Bulges": values}}
        if rigid:
            return whole
        condition, fix = {}, []
        if name == "upper":
            condition = {"Type": "Neumann",
                         "Traction X": self.stress * draw.uniform(-0.2, 0.2),
                         "Traction Y": -self.stress * draw.uniform(0.1, 1)}
            fix = ["X", "Rotation"]
        elif self.held == "clamp":
            condition = {"Type": "Dirichlet", "Displacement X": "0", "Displacement Y": "0"}
        else:
            fix = FREE
        away = names[2]  # no neighbour of the contact side
        whole["Boundary Conditions"] = {away: condition} if condition else {}
        if fix:
            whole["Rigid Motions"] = {"Fix": fix}
        elements = [draw.randint(2, 7)] + [draw.randint(1, 4) for _ in range(count - 1)]
        whole["Mesh"] = {"Elements per Edge": elements, "Degree": draw.randint(1, 4)}
        return whole

    def between(self):
        """Further bodies, below the upper one."""
        return {}

    def bodies(self):
        draw = self.draw
        return {"upper": self.body("upper", self.modulus, draw.uniform(0, 0.49)),
                **self.between(),
                "lower": self.body("lower", self.modulus * 10 ** draw.uniform(-3, 3),
                                   draw.uniform(0, 0.49))}

    def scene(self):
        interference = self.interference(self.gaps[0])
        friction = self.friction(self.law)
        second = {"upper": "lower", "lower": "upper"}[self.first]
        return self.of(self.bodies(), {"joint": self.contact(
            self.first + ":contact", second + ":contact", interference, friction)})

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
        return {"Law": law, **{field: fields[field] for field in self.LAWS[law]}}

    def contact(self, first, second, interference, friction):
        return {"Between": [first, second], "Interference": interference, "Friction": friction}

    def of(self, bodies, contacts):
        return {"Bodies": bodies, "Contacts": contacts,
                "Discretization": {"Multiplier": self.basis, "Mesh Size": 10 * self.size},
                "Adaptivity": {"Strategy": self.strategy, "Maximum Degrees of Freedom": self.dof},
                "Output": {"Fields": False}}


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

    def between(self):
        draw, w, h = self.draw, self.plate, self.height
        return {"middle": {
            "Material": elastic(self.modulus * 10 ** draw.uniform(-2, 2), draw.uniform(0, 0.49)),
            "Geometry": {"Vertices": [(-w, -h), (w, -h), (w, 0), (-w, 0)],
                         "Edges": ["bottom", "side", "top", "side"]},
            "Rigid Motions": {"Fix": ["X", "Rotation"]},
            "Mesh": {"Elements per Edge": [draw.randint(2, 7), 1, draw.randint(2, 7), 1],
                     "Degree": draw.randint(1, 4)}}}

    def scene(self):
        draw = self.draw
        return self.of(self.bodies(), {
            name: self.contact(*draw.sample(sides, 2), self.interference(gap), self.friction(law))
            for name, sides, law, gap in zip(("above", "below"), (
                ["upper:contact", "middle:top"], ["middle:bottom", "lower:contact"]),
                self.laws, self.gaps)})


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
        return {hole + "Vertices": corners, hole + "Edges": [name] * count,
                hole + "Bulges": [math.tan(math.pi / (2 * count))] * count}

    def ring(self, k):
        """Between circle k - 1 and circle k."""
        draw = self.draw
        if k == 0 and self.held == "rigid":
            return {"Material": {"Rigid": True},
                    "Geometry": self.circle(self.radii[0], "outside")}
        inner = self.radii[k - 1] if k > 0 else draw.uniform(0.2, 0.8) * self.radii[0]
        loops = self.circle(self.radii[k], "outside")
        if k > 0 or self.held == "hole":
            loops.update(self.circle(inner, "inside", "Hole 1 "))
        last = k == len(self.radii) - 1
        load = "%.6g + %.6g*cos(2*atan2(y, x))" % (
            self.stress * draw.uniform(0.5, 1), self.stress * draw.uniform(-1, 1))
        pressed = {"outside": {"Type": "Neumann", "Traction X": "-nx*(%s)" % load,
                               "Traction Y": "-ny*(%s)" % load}}
        return {
            "Material": elastic(self.modulus * 10 ** draw.uniform(-1.5, 1.5), draw.uniform(0, 0.49)),
            "Geometry": loops, **({"Boundary Conditions": pressed} if last else {}),
            "Rigid Motions": {"Fix": FREE},
            "Mesh": {"Mesh Size": self.radii[k] * draw.uniform(0.5, 1.5),
                     "Degree": draw.randint(1, 4)}}

    def scene(self):
        draw, rings = self.draw, range(len(self.radii))
        bodies = {"body%d" % k: self.ring(k) for k in rings}
        return self.of(bodies, {"fit%d" % k: self.contact(
            *draw.sample(["body%d:outside" % (k - 1), "body%d:inside" % k], 2),
            self.interference(self.gaps[k - 1]), self.friction(self.laws[k - 1])) for k in rings[1:]})
