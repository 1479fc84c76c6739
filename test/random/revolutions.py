"""Random scenes of solids of revolution, each made from its seed alone.  Standard library only."""
import math
import random

from bodies import TwoBodies, elastic
from scenes import STRATEGIES


def arc(angle):
    return math.tan(angle / 4)


class Revolutions(TwoBodies):
    """A ball, a cone, a flat punch or an O-ring pressed onto a block or a ring, with or without an
    axis, elastic or rigid; the block alone under an obstacle; sleeves shrunk on a shaft; hollow balls
    in one another.  Every law and Tied, strategy and normal law; overlaps and play; paths, wear,
    sliding along the meridian; nu up to 1/2; some compressed; in every second scene bodies weigh, spin, are pulled outwards
    or hot.  Claimed besides is that forces along the axis balance."""

    KINDS = ("pressed", "alone", "sleeve", "shells")

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random("%d revolutions" % seed)
        self.kind = draw.choice(self.KINDS)
        self.basis = "Gauss-Legendre-Lagrange"
        self.strategy = draw.choice(STRATEGIES)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.size = 10 ** draw.uniform(-3, 3)
        self.stress = self.modulus * 10 ** draw.uniform(-5, -2)
        self.energy = self.modulus * self.size ** 3
        self.rounding = 1e-12 * self.stress * self.size ** 2
        self.law = draw.choice(list(self.LAWS))
        self.laws = [self.law]
        self.path = draw.random() < 0.3
        self.compressed = random.Random("%d compressed" % seed).random() < 0.3
        if self.compressed:
            self.nothing = 1e-18  # forces of a motion are rounding, not exactly none

    def material(self, softer=1):
        draw = self.draw
        return elastic(self.modulus * 10 ** draw.uniform(-softer, softer), draw.uniform(0, 0.49))

    def grown(self, value):
        """A load, on a path forth and half of the way back."""
        return "(%.6g)*min(t, 2 - t)" % value if self.path else "%.6g" % value

    def body(self, corners, names, bulges=None, conditions=None, rigid=False, motion=None):
        draw, size = self.draw, self.size
        body = {"Material": {"Rigid": True} if rigid else self.material(),
                "Geometry": {"Vertices": [[size * x, size * y] for x, y in corners], "Edges": names,
                             "Bulges": bulges or [0] * len(corners)}}
        if conditions:
            body["Boundary Conditions"] = conditions
        if motion:
            body["Motion"] = motion
        if not rigid:
            body["Mesh"] = {"Mesh Size": size * draw.uniform(0.25, 1), "Degree": draw.randint(1, 4)}
        return body

    def block(self, top, obstacle=None):
        """Below y = 0, held at its base."""
        draw = self.draw
        bore = draw.choice((0, draw.uniform(0.1, 0.4)))
        width, height = draw.uniform(0.8, 2), draw.uniform(0.3, 2)
        held = {"Type": "Dirichlet", "Displacement Y": "0",
                **({"Displacement X": "0"} if draw.random() < 0.5 else {})}
        return self.body([(bore, -height), (width, -height), (width, 0), (bore, 0)],
                         ["base", "side", top, "inside" if bore else "any"], None,
                         {"base": held, **({top: obstacle} if obstacle else {})})

    def upper(self, load):
        """A body above y = 0 that touches it; its side is called contact."""
        draw = self.draw
        r, centre = draw.uniform(0.3, 1), draw.uniform(0.6, 1)
        angle = draw.uniform(0.3, math.pi / 2)
        slope = draw.uniform(0.05, 0.4)
        corners, names, bulges = draw.choice((
            ([(0, 0), (r * math.sin(angle), r * (1 - math.cos(angle))),
              (0, r * (1 - math.cos(angle)))], ["contact", "top", "any"], [arc(angle), 0, 0]),
            ([(0, 0), (r, r * slope), (r, 1), (0, 1)], ["contact", "side", "top", "any"], None),
            ([(0, 0), (r, 0), (r, 1), (0, 1)], ["contact", "side", "top", "any"], None),
            ([(centre - 0.3, 0.3), (centre, 0), (centre + 0.3, 0.3), (centre, 0.6)],
             ["contact", "contact", "top", "top"], [arc(math.pi / 2)] * 4)))
        if draw.random() < 0.3:
            force = {"Force Y": self.grown(-self.stress * self.size ** 2)}
            moved = {"Displacement Y": self.grown(-self.stress / self.modulus * self.size)}
            return self.body(corners, names, bulges, rigid=True, motion=draw.choice((force, moved)))
        return self.body(corners, names, bulges, {"top": load})

    def load(self):
        draw, stress = self.draw, self.stress
        return draw.choice((
            {"Type": "Neumann", "Traction X": self.grown(stress * draw.uniform(-0.2, 0.2)),
             "Traction Y": self.grown(-stress * draw.uniform(0.1, 1))},
            {"Type": "Dirichlet", "Displacement Y": self.grown(
                -stress / self.modulus * self.size * draw.uniform(0.1, 1))}))

    def contact(self, first, second, interference, friction):
        draw, length = self.draw, self.size * self.stress / self.modulus
        contact = super().contact(first, second, interference, friction)
        if draw.random() < 0.2 and self.law != "Tied":
            contact["Normal"] = {"Law": "Linear", "Compliance": length / self.stress}
        if self.law not in ("None", "Tied") and draw.random() < 0.2:
            contact["Sliding"] = self.grown(length * draw.uniform(-1, 1))
        if self.path and self.law not in ("None", "Tied") and draw.random() < 0.3:
            contact["Wear"] = {"Coefficient": 0.1 * draw.random() / self.stress}
        return contact

    def shell(self, inner, outer, names, bore=False):
        quarter = arc(math.pi / 2)
        body = self.body(
            [(0, -outer), (outer, 0), (0, outer), (0, inner), (inner, 0), (0, -inner)],
            [names[1], names[1], "any", names[0], names[0], "any"],
            [quarter, quarter, 0, -quarter, -quarter, 0])
        body["Rigid Motions"] = {"Fix": ["Y"]}
        return body

    def scene(self):
        parts = getattr(self, self.kind)()
        if self.draw.random() < 0.2:  # of what carries the stresses of contact
            sides = [contact["Between"][0] for contact in parts["Contacts"].values()]
            name = sides[0].partition(":")[0] if sides else "block"
            parts["Bodies"][name]["Material"]["Poisson's Ratio"] = 0.5
        draw = self.draw = random.Random("%d loads" % self.seed)
        if draw.random() < 0.5:
            for body in parts["Bodies"].values():
                if draw.random() < 0.7:
                    self.add_loads(body)
            draw = self.draw = random.Random("%d conduction" % self.seed)
            for body in parts["Bodies"].values():
                if "Rigid" not in body["Material"] and draw.random() < 0.4:
                    self.conduct(body)
        if self.compressed:
            parts["Solver"] = {"Linear": {"Method": "Compressed"}}
        return {"Geometry": {"Type": "Axisymmetric"}, **parts,
                **({"History": {"Times": [1, 1.5], "Steps": [2, 2]}} if self.path else {})}

    def add_loads(self, body):
        """As large as those of boundaries; weight acts down, so that all rests on what carries it."""
        draw, stress, size = self.draw, self.stress, self.size
        density, expansion = 10 ** draw.uniform(-9, 4), 10 ** draw.uniform(-6, -4)
        terms = ["(%.6g)*%s" % (draw.uniform(-1, 1) / size ** (i + j), "*".join(["r"] * i + ["z"] * j) or "1")
                 for i in (0, 2, 4) for j in range(5 - i) if draw.random() < 0.4]
        loads = {
            "Gravity Y": self.grown(-stress / size / density * draw.uniform(0.05, 1)),
            "Spin": self.grown(math.sqrt(stress / density * draw.uniform(0.05, 1)) / size),
            "Force X": self.grown(stress / size * draw.uniform(-0.5, 0.5)),
            "Temperature": "(%s)*(%s)" % (self.grown(stress / self.modulus / expansion * draw.uniform(-1, 1)),
                                          " + ".join(terms or ["1"]))}
        rigid = "Rigid" in body["Material"]
        names = ["Gravity Y"] if rigid else draw.sample(list(loads), draw.randint(1, 3))
        body["Body Loads"] = {name: loads[name] for name in names}
        body["Material"]["Density"] = density
        if not rigid:
            body["Material"]["Thermal Expansion"] = expansion

    def conduct(self, body):
        """One temperature on some boundaries, fluxes on others, nothing on the axis."""
        draw = self.draw
        names = sorted({*body["Geometry"]["Edges"]} - {"any"})
        draw.shuffle(names)
        held = draw.randint(1, len(names))
        expansion = body["Material"].setdefault("Thermal Expansion", 10 ** draw.uniform(-6, -4))
        hot = self.stress / self.modulus / expansion * draw.uniform(-1, 1)
        body["Material"]["Conductivity"] = conductivity = 10 ** draw.uniform(-2, 3)
        body.get("Body Loads", {}).pop("Temperature", None)
        body["Thermal Conditions"] = inner = {}
        for k, name in enumerate(names):
            if k < held:
                inner[name] = {"Temperature": "(%s)*(1 + %s/%.6g)" % (
                    self.grown(hot), draw.choice(("y", "x^2/%.6g" % self.size)) if held == 1 else "y",
                    self.size)}
            elif draw.random() < 0.7:
                inner[name] = {"Heat Flux": "(%s)*(0.3 + n%s)" % (
                    self.grown(hot * conductivity / self.size * draw.uniform(-1, 1)), draw.choice("xy"))}

    def pressed(self):
        bodies = {"upper": self.upper(self.load()), "lower": self.block("contact")}
        bore = bodies["lower"]["Geometry"]["Vertices"][0][0]
        if max(x for x, _ in bodies["upper"]["Geometry"]["Vertices"]) < 1.2 * bore:  # it would fall through
            bodies["lower"]["Geometry"]["Vertices"][0][0] = bodies["lower"]["Geometry"]["Vertices"][3][0] = 0
            bodies["lower"]["Geometry"]["Edges"][3] = "any"
        sides = ["upper:contact", "lower:contact"]
        if "Rigid" in bodies["upper"]["Material"]:
            sides.reverse()
        elif self.draw.random() < 0.3 and "Bulges" in bodies["upper"]["Geometry"]:
            sides.reverse()
        gap = self.draw.choice(("zero", "overlap"))
        return self.of(bodies, {"joint": self.contact(
            *sides, self.interference(gap), self.friction(self.law))})

    def alone(self):
        draw = self.draw
        self.law = draw.choice([law for law in self.LAWS if law != "Tied"])
        self.laws = [self.law]
        gap = self.stress / self.modulus * self.size
        return self.of({"block": self.block("contact", {
            "Type": "Contact", "Friction": self.friction(self.law),
            "Gap": "%.6g*(x/%.6g)^2 + %s" % (
                gap * draw.uniform(0, 2), self.size, self.grown(-gap * draw.random()))})}, {})

    def sleeve(self):
        draw = self.draw
        wide, short, tall = draw.uniform(1.2, 3), draw.uniform(0.3, 1.5), draw.uniform(1.6, 3)
        hub = self.body([(1, -short), (wide, -short), (wide, short), (1, short)],
                        ["end", "outside", "end", "bore"])
        shaft = self.body([(0, -tall), (1, -tall), (1, tall), (0, tall)],
                          ["foot", "seat", "head", "any"])
        hub["Rigid Motions"] = shaft["Rigid Motions"] = {"Fix": ["Y"]}
        return self.of({"hub": hub, "shaft": shaft}, {"fit": self.contact(
            "hub:bore", "shaft:seat", self.grown(self.stress / self.modulus * self.size),
            self.friction(self.law))})

    def shells(self):
        draw = self.draw
        radii = [draw.uniform(0.2, 0.6), 1, draw.uniform(1.1, 2)]
        bodies = {"inner": self.shell(radii[0], radii[1], ("bore", "fit")),
                  "outer": self.shell(radii[1], radii[2], ("fit", "outside"))}
        bodies["outer"]["Boundary Conditions"] = {"outside": {
            "Type": "Neumann", "Pressure": self.grown(self.stress * draw.uniform(-0.5, 1))}}
        sides = draw.sample(["inner:fit", "outer:fit"], 2)
        return self.of(bodies, {"fit": self.contact(
            *sides, self.grown(self.stress / self.modulus * self.size * draw.uniform(0.2, 1)),
            self.friction(self.law))})

    def wrong(self, level, rows):
        """Forces of a body along the axis, and those of contacts."""
        found, forces = [], {row["body"]: row for row in rows if row.get("step") == rows[-1].get("step")}
        size = abs(level["force_normal"]) + sum(abs(row[kind]) for row in forces.values() for kind in (
            "load_y", "body_force_y", "contact_y", "reaction_y"))
        for name, row in forces.items():
            rest = row["load_y"] + row["body_force_y"] + row["contact_y"] + row["reaction_y"]
            if abs(rest) > 1e-10 * size + self.rounding:
                found.append("'%s' is off balance by %.1e of the forces" % (name, rest / size))
        if len(forces) > 1 and abs(sum(row["contact_y"] for row in forces.values())) > 1e-10 * size + self.rounding:
            found.append("contacts are off balance")
        return found
