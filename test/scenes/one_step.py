"""A path of one step is the solve without a path: Coulomb and Tresca, bodies in contact, and a
body of nu = 1/2 with closed lines that carry no stress of contact."""
from runs import ENERGIES, claim, differ, finish, levels, run, saved, scene


def ring(name, base):
    return saved(name, {"Bodies": {"ring": {
        "Material": {"Young's Modulus": 200, "Poisson's Ratio": 0.5},
        "Geometry": {"Vertices": [[0, 0], [2, 0], [2, 1], [0, 1]],
                     "Edges": ["base", "right", "top", "left"],
                     "Hole 1 Vertices": [[0.8, 0.5], [1.2, 0.5]],
                     "Hole 1 Edges": ["hole", "hole"], "Hole 1 Bulges": [1, 1]},
        "Boundary Conditions": {"base": base, "top": {
            "Type": "Dirichlet", "Displacement X": 0.002, "Displacement Y": -0.01}}}},
        "Discretization": {"Elements per Edge": [8, 4, 8, 4], "Hole 1 Elements per Edge": [4, 4],
                           "Stabilization": {"Form": "Density"}}})


SLIDES = {"Type": "Contact", "Friction": {"Law": "Coulomb", "Coefficient": 0.3}}
for name, file, settings, slips in [
        ("a hole alone is pinned", ring("hole", SLIDES), [], True),
        ("no line is in contact", ring("free", {"Type": "Neumann", "Traction Y": 10}), [], False),
        ("Tresca", scene("tresca.xml"), levels(2), True),
        ("Coulomb", scene("coulomb.xml"), levels(2), True),
        ("two blocks", scene("two-blocks.xml"), levels(2), True)]:
    once, path = (run(file, kind, [*settings, *more])[0]
                  for kind, more in (("once", []), ("path", ["History->Times={1}"])))
    size = max(abs(once[-1][energy]) for energy in ENERGIES)
    off = max(differ(a[energy], b[energy], size) for a, b in zip(once, path) for energy in ENERGIES)
    claim(len(once) == len(path) and off < 1e-12, "%s: one step is the whole, off by %.1e" % (name, off))
    claim((once[-1]["energy_friction"] > 0) == slips, "  and friction works: %s" % slips)
finish()
