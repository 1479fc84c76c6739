"""Random scenes of one body that meets itself.  Standard library only."""
import math
import random

from bodies import FREE, TwoBodies, elastic


class Slots(TwoBodies):
    """A beam with a slot from one end, from a tenth of its height to 1e-8 of it, whose faces loads press
    together, rub or pull apart, or a bond holds; clamped at the other end or held in the mean, turned
    by any angle.  Either face first; laws, bases, strategies, sizes and overlaps of TwoBodies."""

    def __init__(self, seed):
        super().__init__(seed)
        self.slot = random.Random("%d slots" % seed)

    def scene(self):
        draw = self.slot
        length, at = draw.uniform(1, 4), draw.uniform(0.2, 0.8)
        depth, gap = draw.uniform(0.2, 0.9) * length, 10 ** draw.uniform(-8, -1)
        outline = [(0, 0), (length, 0), (length, 1), (0, 1), (0, at + gap), (depth, at + gap), (depth, at),
                   (0, at)]
        angle, size = draw.uniform(0, 2 * math.pi), self.size / math.hypot(length, 1)
        c, s = size * math.cos(angle), size * math.sin(angle)

        def load():
            along, down = self.stress * draw.uniform(-0.5, 0.5), self.stress * draw.uniform(-1, 0.3)
            return {"Type": "Neumann", "Traction X": (c * along - s * down) / size,
                    "Traction Y": (s * along + c * down) / size}
        held = {"wall": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}
        clamped = self.held != "mean"
        body = {"Material": elastic(self.modulus, draw.uniform(0, 0.49)),
                "Geometry": {"Vertices": [(c * x - s * y, s * x + c * y) for x, y in outline],
                             "Edges": ["bottom", "wall", "top", "tip", "up", "end", "low", "heel"]},
                "Boundary Conditions": {"top": load(), "tip": load(), **(held if clamped else {})},
                **({} if clamped else {"Rigid Motions": {"Fix": FREE}}),
                "Mesh": {"Elements per Edge": [draw.randint(1, 6) for _ in outline],
                         "Degree": draw.randint(1, 4)}}
        sides = ["beam:up", "beam:low"][::draw.choice((1, -1))]
        return self.of({"beam": body}, {"slot": self.contact(
            *sides, self.interference(self.gaps[0]), self.friction(self.law))})
