"""Random scenes of the parts of machines, each made from its seed alone.  Standard library only."""
import math
import random

from bodies import FREE, TwoBodies, elastic, unbalanced
from revolutions import arc
from outlines import circle, rounded, sampled, turned

STRATEGIES = ("None", "None", "Uniform h", "Adaptive hp", "Graded hp", "Graded hp")


class Parts(TwoBodies):
    """Cracks with kinks and arcs, of any angle, in a block or around an axis, pressed together, sheared or
    opened; snap hooks behind a rounded edge; cams that turn below a flat or a roller; teeth; dovetails with
    rounded corners; O-rings in grooves; bellows on a flange and domes under a plate, of 1 : 5 to 1 : 100.
    Sides in either order.  Claimed besides is that forces balance."""

    KINDS = ("crack", "hook", "cam", "tooth", "dovetail", "groove", "shell")
    dof = 1200

    def __init__(self, seed):
        self.seed = seed
        draw = self.draw = random.Random("%d parts" % seed)
        self.kind = self.KINDS[seed % len(self.KINDS)]
        self.basis = "Gauss-Legendre-Lagrange"
        self.strategy = draw.choice(STRATEGIES)
        self.modulus = 10 ** draw.uniform(0, 11)
        self.size = 10 ** draw.uniform(-3, 3)
        self.strain = 10 ** draw.uniform(-6, -3)
        self.stress = self.strain * self.modulus
        self.law = draw.choice([law for law in self.LAWS if law != "Tied"])
        self.laws = [self.law]
        self.around = self.kind == "shell" or self.kind in ("crack", "groove") and draw.random() < 0.4
        self.energy = self.modulus * self.size ** (3 if self.around else 2)
        self.least = -1e-12 * self.stress * self.size ** (2 if self.around else 1)  # where nothing touches
        self.arm = 1  # of moments
        self.angle = 0  # by which all is turned
        self.steps = 0

    def body(self, outline, names, conditions=None, fix=None, rigid=None, mesh=0.5, ratio=0.45):
        """`rigid`: its motion, of a body without elasticity."""
        draw = self.draw
        corners, bulges = outline
        corners = [turned(corner, self.angle, self.size) for corner in corners]
        geometry = {"Vertices": corners, "Bulges": bulges, "Edges": names}
        self.arm = max(self.arm, *(math.hypot(*corner) for corner in corners))
        if rigid is not None:
            return {"Material": {"Rigid": True}, "Geometry": geometry, "Motion": rigid}
        return {"Material": elastic(self.modulus * 10 ** draw.uniform(-1, 1), draw.uniform(0, ratio)),
                "Geometry": geometry, **({"Boundary Conditions": conditions} if conditions else {}),
                **({"Rigid Motions": {"Fix": fix}} if fix else {}),
                "Mesh": {"Mesh Size": self.size * mesh * draw.uniform(0.4, 1), "Degree": draw.randint(1, 3)}}

    def joint(self, *sides, law=None, interference=0):
        return {"Between": self.draw.sample(sides, 2), "Friction": self.friction(law or self.law),
                **({"Interference": interference} if interference else {})}

    def scene(self):
        bodies, contacts = getattr(self, self.kind)()
        for contact in contacts.values():  # a body without elasticity is the second
            contact["Between"].sort(key=lambda side: "Rigid" in bodies[side.partition(":")[0]]["Material"])
        root = {"Bodies": bodies, "Contacts": contacts,
                "Discretization": {"Multiplier": self.basis},
                "Adaptivity": {"Strategy": self.strategy, "Maximum Degrees of Freedom": self.dof},
                "Output": {"Fields": False}}
        if self.strategy == "Graded hp":
            root["Adaptivity"]["Tolerance"] = 0.02
        if self.around:
            root["Geometry"] = {"Type": "Axisymmetric"}
        if self.steps:
            root["History"] = {"Times": [1], "Steps": [self.steps]}
        return root

    def crack(self):
        """A line from side to side, of which pieces next to each other are open and the others tied; loads
        in balance."""
        draw = self.draw
        self.angle = 0 if self.around else draw.uniform(0, 2 * math.pi)
        pieces = draw.randint(2, 5)
        first = 0 if self.around else -3
        places = sorted(first + (3 - first) * (k + draw.uniform(-0.25, 0.25)) / pieces for k in range(1, pieces))
        line = [(first, 0), *((x, draw.uniform(-0.4, 0.4)) for x in places), (3, 0)]
        bulges = [draw.choice((0, draw.uniform(-0.35, 0.35))) for _ in range(pieces)]
        begin = draw.choice((0, 1)) if pieces > 2 and not self.around else 0  # 0: from the side or the axis
        end = draw.randint(begin + 1, pieces - 1)
        names = ["crack" if begin <= k < end else "bond" for k in range(pieces)]
        normal, shear, other = (self.stress * draw.uniform(*limits) for limits in ((-1, 0.2), (-1, 1), (-1, 1)))
        # of axes that are turned with the block
        (a, b), (c, d) = (turned(e, self.angle) for e in ((1, 0), (0, 1)))
        if self.around:
            shear, other = 0, draw.choice((0, other))
        xx, yy, xy = (other * p * q + normal * r * s + shear * (p * s + q * r) for p, q, r, s in (
            (a, a, c, c), (b, b, d, d), (a, b, c, d)))
        load = {"Type": "Neumann", "Traction X": "%.9g*nx + %.9g*ny" % (xx, xy),
                "Traction Y": "%.9g*nx + %.9g*ny" % (xy, yy)}
        inner = "any" if self.around else "far"
        upper = self.body((line + [(3, 3), (first, 3)], bulges + [0] * 3), names + ["far", "far", inner],
                          {"far": load}, mesh=1)
        lower = self.body((line[::-1] + [(first, -3), (3, -3)], [-bulge for bulge in bulges[::-1]] + [0] * 3),
                          names[::-1] + [inner, "far", "far"], {"far": load},
                          ["Y"] if self.around else FREE, mesh=1)
        self.laws.append("Tied")
        contacts = {name: self.joint("upper:" + name, "lower:" + name, law=law)
                    for name, law in (("crack", self.law), ("bond", "Tied"))}
        return {"upper": upper, "lower": lower}, contacts

    def moved(self, along, across=0):
        """By what the load is, a condition or a motion."""
        move = self.strain * self.size
        return {"Displacement X": move * along, "Displacement Y": move * across}

    def hook(self):
        """Its nose behind the edge of a block, which is pulled outwards."""
        draw = self.draw
        length, thick, nose = draw.uniform(2, 5), draw.uniform(0.2, 0.6), draw.uniform(0.25, 0.6)
        tip, clear = draw.uniform(0.1, 0.4), draw.uniform(0.02, 0.4) * nose
        slant = draw.choice((0, draw.uniform(-0.1, 0.2))) * nose  # of the face that catches
        small = 0.3 * min(tip, nose - clear)
        hook = [(0, 0), (length, 0), (length + slant, -nose), (length + tip + max(slant, 0), -nose),
                (length + 2 * tip + nose, thick / 2), (length + tip + nose, thick), (0, thick)]
        if slant < 0:
            hook[3] = (length + tip, -nose)
        radii = [0, draw.choice((0, 0.5 * min(clear, small))), draw.choice((0, small / 2)), 0, 0, 0, 0]
        outline, names = rounded(hook, radii, ["under", "catch", "free", "free", "free", "free", "wall"])
        hook = self.body(outline, names, {"wall": {"Type": "Dirichlet", "Displacement X": 0,
                                                   "Displacement Y": 0}})
        gap = draw.choice((0, self.strain * draw.uniform(0, 1)))
        # along the face, or on what is in front of it
        at = length + (slant * clear / nose if slant > 0 else slant)
        lean = slant / nose if slant > 0 else 0
        width, high, radius = draw.uniform(0.5, 0.8) * length, draw.uniform(0.5, 1.5), draw.uniform(0.2, 1) * small
        edge = [(at - gap - width, -clear - high), (at - gap + lean * high, -clear - high), (at - gap, -clear),
                (at - gap - width, -clear)]
        outline, names = rounded(edge, [0, 0, radius, 0], ["base", "edge", "top", "side"])
        if draw.random() < 0.4:
            edge = self.body(outline, names, rigid=self.moved(1, draw.uniform(-0.2, 0.2)))
        else:
            edge = self.body(outline, names, {"base": {"Type": "Dirichlet", **self.moved(1)}})
        return {"hook": hook, "edge": edge}, {"catch": self.joint("hook:catch", "edge:edge")}

    def cam(self):
        """Base and nose circle with flanks between them, which turns; what follows it rests on it."""
        draw = self.draw
        nose, off = draw.uniform(0.2, 0.6), draw.uniform(1, 1.6)
        flank = 10 ** draw.uniform(0.7, 3)  # radius of
        across = ((flank - 1) ** 2 - (flank - nose) ** 2 + off ** 2) / (2 * off)
        depth = math.sqrt((flank - 1) ** 2 - across ** 2)

        def beyond(x, radius):  # of a circle about (x, 0), where the flank of the upper side touches it
            length = math.hypot(x - across, depth)
            return x + radius * (x - across) / length, radius * depth / length
        (a, b), (c, d) = beyond(0, 1), beyond(off, nose)
        turn = draw.uniform(-math.pi, math.pi)
        corners = [(a, -b), (c, -d), (c, d), (a, b), (-1, 0)]
        bend, back = math.atan2(b, a) - math.atan2(d, c - off), math.atan2(b, a)
        bulges = [arc(bend), arc(2 * math.atan2(d, c - off)), arc(bend)] + [arc(math.pi - back)] * 2
        outline = [turned(corner, turn) for corner in corners], bulges
        x, y = max(sampled(outline, 512), key=lambda point: point[1])
        names = ["cam"] * 5
        self.steps = draw.randint(1, 4)
        angle = draw.choice((-1, 1)) * 10 ** draw.uniform(-4, -1)
        if draw.random() < 0.5:
            cam = self.body(outline, names, rigid={
                "Displacement X": 0, "Displacement Y": 0, "Rotation": "%.6g*t" % angle, "Reference Point": [0, 0]})
        else:  # on a shaft
            angle *= 0.01
            cam = self.body(outline, names, {"shaft": {
                "Type": "Dirichlet", "Displacement X": "%.6g*t*y" % -angle, "Displacement Y": "%.6g*t*x" % angle}})
            corners, bulges = circle((0, 0), 0.5)
            cam["Geometry"].update({
                "Hole 1 Vertices": [turned(corner, 0, self.size) for corner in corners],
                "Hole 1 Edges": ["shaft"] * 4, "Hole 1 Bulges": bulges})
        if draw.random() < 0.5:
            radius = draw.uniform(0.2, 1)
            outline, names = circle((x, y + radius), radius), ["foot", "free", "free", "foot"]
            area = math.pi * radius ** 2
        else:
            wide, high = draw.uniform(0.5, 1.5), draw.uniform(0.3, 1)
            corners = [(x - wide, y), (x + wide, y), (x + wide, y + high), (x - wide, y + high)]
            outline, names, area = (corners, [0] * 4), ["foot", "free", "free", "free"], 2 * wide * high
        foot = self.body(outline, names, fix=["X", "Rotation"])
        foot["Body Loads"] = {"Force Y": -self.stress / self.size / area}
        return {"cam": cam, "foot": foot}, {"joint": self.joint("cam:cam", "foot:foot")}

    def tooth(self):
        """Two teeth that touch somewhere on their flanks, one pushed against the other."""
        draw = self.draw
        bodies, sides = {}, {}
        for name in ("driven", "driver"):
            root, tip, high = draw.uniform(0.7, 1), draw.uniform(0.3, 0.5), draw.uniform(1.5, 1.9)
            bulge, rim = draw.uniform(0.03, 0.15), draw.uniform(0.4, 1)
            outline = ([(-2, -rim), (2, -rim), (2, 0), (root, 0), (tip, high), (-tip, high), (-root, 0), (-2, 0)],
                       [0, 0, 0, bulge, 0, bulge, 0, 0])
            sides[name] = outline, [point for point in sampled((outline[0], outline[1]), 256)
                                    if 0 < point[1] and point[0] > 0]
        level = 2.1 + draw.uniform(0, 0.4)  # between the roots

        def widths(points):
            return sorted((y, x) for x, y in points)

        def at(points, y):
            for (a, x), (b, z) in zip(points, points[1:]):
                if a <= y <= b and b > a:
                    return x + (z - x) * (y - a) / (b - a)
            return -math.inf
        one, other = (widths(sides[name][1]) for name in ("driven", "driver"))
        apart = max(at(one, level * k / 400) + at(other, level - level * k / 400) for k in range(1, 400))
        names = ["base", "side", "free", "flank", "free", "back", "free", "side"]
        held = {"base": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}
        bodies["driven"] = self.body(sides["driven"][0], names, held)
        corners, bulges = sides["driver"][0]
        corners = [(apart - x, level - y) for x, y in corners]
        if draw.random() < 0.5:
            load, fix = {"Type": "Dirichlet", **self.moved(-1)}, None
        else:
            load, fix = {"Type": "Neumann", "Traction X": -self.stress * draw.uniform(0.1, 1)}, ["Y", "Rotation"]
        bodies["driver"] = self.body((corners, bulges), names, {"base": load}, fix)
        return bodies, {"mesh": self.joint("driven:flank", "driver:flank")}

    def dovetail(self):
        """Both flanks carry the pull of a blade; all corners rounded or not."""
        draw = self.draw
        neck, angle, length = draw.uniform(2, 4), math.radians(draw.uniform(35, 60)), draw.uniform(3, 5)

        def flank(t):
            return neck + t * length * math.cos(angle), 6 - t * length * math.sin(angle)

        def mirrored(half):
            return half + [(-x, y) for x, y in half[::-1]]
        above, below = draw.uniform(0.02, 0.1), draw.uniform(0.02, 0.1)  # of the flank are free
        lean = math.tan((math.pi / 2 - angle) / 2)
        # fillets end where nothing is opposite
        neck_radius, slot_radius = (draw.choice((0, draw.uniform(0.2, 0.9))) * free * length / lean
                                    for free in (above, below))
        edge, tip, corner = (draw.choice((0, draw.uniform(0.02, 0.12))) * length for _ in range(3))
        wide, low = flank(1)
        root = mirrored([(wide - 1, low - 2.5), (wide, low - 1.5), (wide, low), (neck, 6), (neck, 12)])
        radii = [tip, tip, edge, neck_radius, 0]
        outline, names = rounded(root, radii + radii[::-1], ["free", "free", "right", "free", "blade", "free", "left",
                                                             "free", "free", "free"])
        bodies = {"root": self.body(outline, names, {
            "blade": {"Type": "Neumann", "Traction Y": self.stress * draw.uniform(0.1, 1)}}, ["X", "Rotation"], mesh=2)}
        (a, b), (c, d) = flank(above), flank(1 + below)
        slot = [(16, -10), (16, 7.5), (a, 7.5), (a, b), (c, d), (c, low - 3)]
        radii = [0, 0, 0, 0.5 * corner, slot_radius, 0.5 * tip]
        corners = mirrored(slot)
        # from the base's right end on, counter-clockwise, to the left one
        outline, names = rounded(corners, radii + radii[::-1], [
            "free", "free", "free", "right", "free", "free", "free", "left", "free", "free", "free", "base"])
        bodies["disc"] = self.body(outline, names, {"base": {
            "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}, mesh=3)
        return bodies, {side: self.joint("root:" + side, "disc:" + side) for side in ("right", "left")}

    def groove(self):
        """An O-ring, pressed by a lid and a pressure from inside, which lays it against the wall."""
        draw = self.draw
        middle = draw.uniform(4, 20) if self.around else 0
        room, radius = draw.choice((0, draw.uniform(0.01, 0.3))), draw.uniform(0.1, 0.4)
        inner, outer, depth = middle - 1.3, middle + 1 + room, draw.uniform(1.5, 1.9)
        left, right = inner - 1, outer + 1
        outline, names = rounded(
            [(left, -1), (right, -1), (right, depth), (outer, depth), (outer, 0), (inner, 0), (inner, depth),
             (left, depth)], [0, 0, 0, draw.choice((0, 0.1)), radius, radius, 0, 0],
            ["back", "free", "free", "wall", "floor", "free", "free", "free"])
        held = {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
        rigid = {"Displacement X": 0, "Displacement Y": 0}
        if self.around:
            del rigid["Displacement X"]
        groove = self.body(outline, names, *(({"back": held},) if draw.random() < 0.5 else (None, None, rigid)))
        move = -draw.uniform(0.1, 1) * self.strain * self.size
        lid = ([(left, 2), (right, 2), (right, 2.8), (left, 2.8)], [0] * 4), ["face", "free", "back", "free"]
        if draw.random() < 0.5:
            lid = self.body(*lid, {"back": dict(held, **{"Displacement Y": move})})
        else:
            lid = self.body(*lid, rigid=dict(rigid, **{"Displacement Y": move}))
        pressure = {"Type": "Neumann", "Pressure": self.stress * draw.uniform(0, 1)}
        against = room == 0 and pressure["Pressure"] > 0.1 * self.stress
        fix = None if self.around else ["Rotation"] if against else ["X", "Rotation"]
        ring = self.body(circle((middle, 1), 1, -0.75 * math.pi), ["bottom", "outer", "top", "inner"],
                         {"inner": pressure}, fix)
        return {"ring": ring, "groove": groove, "lid": lid}, {
            "floor": self.joint("ring:bottom", "groove:floor"), "lid": self.joint("ring:top", "lid:face"),
            "wall": self.joint("ring:outer", "groove:wall")}

    def shell(self):
        """Half circles to and fro, on a flange; or a dome under a plate."""
        draw = self.draw
        thick = 10 ** draw.uniform(-2, -0.7)
        move = {"Displacement Y": -draw.uniform(0.1, 1) * self.strain * self.size}
        held = {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}
        pressure = {"Type": "Neumann", "Pressure": thick * self.stress * draw.uniform(-0.2, 1)}
        if draw.random() < 0.4:
            outline = [(1 - thick, 0), (1, 0), (0, 1), (0, 1 - thick)], [0, arc(math.pi / 2), 0, -arc(math.pi / 2)]
            upper = self.body(outline, ["base", "face", "any", "inside"], {"base": held, "inside": pressure})
            corners = [(0, 1), (0.8, 1), (0.8, 1.4), (0, 1.4)]
            lower, sides = (corners, [0] * 4), ["face", "free", "back", "any"]
            condition, rigid = dict(held, **move), move
        else:
            middle, waves, lip = draw.uniform(3, 8), draw.randint(1, 4), draw.uniform(0.5, 1.5)
            half = thick / 2
            out = [(middle, 2 * k + (-half if k % 2 == 0 else half)) for k in range(waves + 1)]
            back = [(middle, 2 * k + (half if k % 2 == 0 else -half)) for k in range(waves + 1)][::-1]
            bends = [1 if k % 2 == 0 else -1 for k in range(waves)]
            outline = ([(middle - lip, -half), *out, *back, (middle - lip, half)],
                       [0, *bends, 0, *(-bend for bend in bends[::-1]), 0, 0])
            names = ["foot", "foot", *["out"] * (waves - 1), "end", *["inside"] * (waves + 1), "lip"]
            upper = self.body(outline, names, {
                "end": {"Type": "Dirichlet", "Displacement X": 0, **move}, "inside": pressure})
            corners = [(middle - 2, -half - 1), (middle + 2, -half - 1), (middle + 2, -half), (middle - 2, -half)]
            lower, sides = (corners, [0] * 4), ["back", "free", "face", "free"]
            condition, rigid = held, {"Displacement Y": 0}
        plate = (self.body(lower, sides, {"back": condition}) if draw.random() < 0.5
                 else self.body(lower, sides, rigid=rigid))
        return {"shell": upper, "plate": plate}, {"joint": self.joint("shell:" + (
            "face" if "face" in upper["Geometry"]["Edges"] else "foot"), "plate:face")}

    def wrong(self, level, rows):
        """Relative to all forces and to stress times area, since contact may carry next to nothing."""
        rows = [row for row in rows if row.get("step") == rows[-1].get("step")]
        size = max(abs(row[kind + c]) for row in rows for c in "xy"
                   for kind in ("load_", "body_force_", "contact_", "reaction_"))
        return unbalanced(rows, self.arm, "y" if self.around else "xy", max(
            size, level["force_normal"], self.stress * self.size ** (2 if self.around else 1)))
