"""A path of one step is the solve without a path: Coulomb and Tresca, bodies in contact, and a
body of nu = 1/2 with closed lines that carry no stress of contact."""
from runs import ENERGIES, claim, differ, finish, levels, run, scene
from written import block, body, condition, friction, geometry, listed, loop, written


def ring(name, base):
    outline = geometry(block(0, 0, 2, 1), "base, right, top, left", holes=loop(
        [(0.8, 0.5), (1.2, 0.5)], "hole, hole", (1, 1), "Hole 1 "))
    top = condition("top", "Dirichlet", Displacement_X=0.002, Displacement_Y=-0.01)
    mesh = listed("Mesh", Elements_per_Edge=[8, 4, 8, 4], Hole_1_Elements_per_Edge=[4, 4], Degree=1)
    return written(name, [body("ring", outline, 200, base + top, mesh=mesh, ratio=0.5)], form="Density")


SLIDES = condition("base", "Contact", friction(0.3))
FREE = condition("base", "Neumann", Traction_Y=10)
for name, file, settings, slips in [
        ("a hole alone is pinned", ring("hole", SLIDES), [], True),
        ("no line is in contact", ring("free", FREE), [], False),
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
