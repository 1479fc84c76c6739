"""Random scenes of two bodies whose surfaces yield, shear, slide and wear.  Standard library only."""
import random

from bodies import TwoBodies
from scene_text import parameter, real, sublist, text

BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")


class Surfaces(TwoBodies):
    """Every normal law that goes with basis and friction, from a hundredth to a hundred times as
    soft as the bodies; elastic shear in every second scene, sliding in every second; wear in every third that is not
    bonded, on a path of four steps, up to n k f p = 0.3 at the pressure of the load."""

    def __init__(self, seed):
        super().__init__(seed)
        draw = self.surface = random.Random("%d surfaces" % seed)
        self.basis = draw.choice(BASES)
        self.normal = draw.choice(("Rigid", "Linear", "Power", "Exponential"))
        if self.normal in ("Power", "Exponential"):
            if self.law == "Tied":
                self.normal = "Linear"
            else:
                self.basis = BASES[0]
        self.shears = self.law != "None" and draw.random() < 0.5
        self.slides = draw.random() < 0.5
        self.wear = random.Random("%d wear" % seed)
        self.wears = self.law != "Tied" and self.wear.random() < 1 / 3
        self.features = ["wears"] * self.wears + [self.normal] + ["shears"] * self.shears + ["slides"] * self.slides

    def contact(self, name, first, second, interference, friction):
        draw, length = self.surface, self.size * self.stress / self.modulus

        def soft(unit):
            return "%.6g" % (unit * 10 ** draw.uniform(-2, 2))

        law = text("Law", self.normal)
        if self.normal == "Linear":
            law += text("Compliance", soft(length / self.stress))
        elif self.normal != "Rigid":
            law += text("Length", soft(length)) + text("Pressure", soft(self.stress))
        if self.normal == "Power":
            law += real("Exponent", draw.choice((0.3, 0.5, 1.5, 3.0)))
        if self.shears:
            friction += text("Compliance", soft(length / self.stress))
        sliding = text("Sliding", "%s*t" % soft(draw.choice((-1, 1)) * length))
        return sublist(name, parameter("Between", "Array(string)", "{%s, %s}" % (first, second)) +
                       text("Interference", interference) + sublist("Friction", friction) +
                       sublist("Normal", law) + sliding * self.slides + self.worn())

    def worn(self):
        if not self.wears:
            return ""
        jump = self.wear.choice((1, 10))
        return sublist("Wear", text("Coefficient", "%.6g" % (
            0.3 * 10 ** self.wear.uniform(-3, 0) / jump / self.stress)) + text("Cycle Jump", "%d" % jump))

    def scene(self, kind, bodies, contacts):
        path = sublist("History", parameter("Times", "Array(double)", "{1, 2}") + parameter(
            "Steps", "Array(int)", "{1, 3}"))
        return super().scene(kind, bodies, contacts).replace(
            '<ParameterList name="Contacts">', path * self.wears + '<ParameterList name="Contacts">')
