"""Random scenes with one thing out of the ordinary, each made from its seed alone."""
import random

from scenes import Scene


class Oddities(Scene):
    """A scene with one of TWISTS; laws with coefficients up to 3 and thresholds and caps of zero among
    them, sides of support and contact that touch."""

    # Loose: nothing but contact and friction holds the body, on a broad base.  All around: every
    # side is in contact but one.
    TWISTS = ("far", "thin", "units", "incompressible", "open", "unloaded", "path", "table", "loose",
              "all around", "strong friction", "no friction")

    def __init__(self, seed):
        draw = random.Random("%d twist" % seed)
        self.twist = self.TWISTS[seed % len(self.TWISTS)]
        self.twisted = draw
        super().__init__(seed)

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
            return {"Type": "Contact", "Gap": "0", "Friction": {
                "Law": "Coulomb", "Coefficient": self.strength(k, "")}}
        return super().condition(k)

    def traction(self, k):
        if self.twist == "loose":  # well within the base and the friction cone
            push = self.twisted.uniform(-0.03, 0.03)
            return {"Traction X": push * self.stress, "Traction Y": -self.stress}
        if self.twist == "path":
            x, y = ("(%s)*%s" % (self.stress * self.draw.uniform(-1, 1), phase)
                    for phase in ("cos(2*t)", "sin(3*t)"))
            if self.held == "pressed":
                y = "%.6g*(0.55 + 0.45*sin(3*t))" % -self.stress
            return {"Traction X": x, "Traction Y": y}
        return super().traction(k)

    def fixed(self):
        return [] if self.twist == "loose" else super().fixed()

    def more(self):
        if self.twist == "path":
            return {"History": {"Times": [0.5, 2], "Steps": [2, 4]}}
        if self.twist == "table":
            points = [(k / 6, self.twisted.uniform(0, 1)) for k in range(-6, 13)]
            return {"Tables": {"profile": {"Points": points, "Interpolation": self.twisted.choice(
                ("Linear", "Cubic", "Spline"))}}}
        return {}
