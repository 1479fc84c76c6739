"""Random scenes of two bodies whose surfaces yield, shear and slide.  Standard library only."""
import random

from bodies import TwoBodies
from scene_text import parameter, real, sublist, text

BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")


class Surfaces(TwoBodies):
    """Every normal law that goes with basis and friction, from a hundredth to a hundred times as
    soft as the bodies; elastic shear in every second scene, sliding in every second."""

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
        self.features = [self.normal] + ["shears"] * self.shears + ["slides"] * self.slides

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
                       sublist("Normal", law) + sliding * self.slides)
