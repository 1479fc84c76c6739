"""Random scenes of two bodies whose surfaces yield, shear, slide and wear.  Standard library only."""
import random

from bodies import TwoBodies

BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")


class Surfaces(TwoBodies):
    """Every normal law that goes with basis and friction, from a hundredth to a hundred times as
    soft as the bodies; elastic shear in every second scene, sliding in every second; wear in every third of those with
    friction or sliding, on a path of four steps, up to n k f p = 0.3 at the pressure of the load."""

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
        self.wears = (self.law != "Tied" and (self.law != "None" or self.slides) and
                      self.wear.random() < 1 / 3)

    def contact(self, first, second, interference, friction):
        draw, length = self.surface, self.size * self.stress / self.modulus

        def soft(unit):
            return "%.6g" % (unit * 10 ** draw.uniform(-2, 2))

        law = {"Law": self.normal}
        if self.normal == "Linear":
            law["Compliance"] = soft(length / self.stress)
        elif self.normal != "Rigid":
            law.update({"Length": soft(length), "Pressure": soft(self.stress)})
        if self.normal == "Power":
            law["Exponent"] = draw.choice((0.3, 0.5, 1.5, 3.0))
        if self.shears:
            friction["Compliance"] = soft(length / self.stress)
        sliding = "%s*t" % soft(draw.choice((-1, 1)) * length)
        return {**super().contact(first, second, interference, friction), "Normal": law,
                **({"Sliding": sliding} if self.slides else {}), **self.worn()}

    def worn(self):
        if not self.wears:
            return {}
        jump = self.wear.choice((1, 10))
        return {"Wear": {"Cycle Jump": jump, "Coefficient":
                         0.3 * 10 ** self.wear.uniform(-3, 0) / jump / self.stress}}

    def of(self, bodies, contacts):
        path = {"History": {"Times": [1, 2], "Steps": [1, 3]}} if self.wears else {}
        return {**super().of(bodies, contacts), **path}
