"""Contacts->Adjust: small gaps and overlaps of parallel and concentric sides count as zero."""
from runs import claim, differ, epafi, finish, largest, refused, run, scene
from written import (NONE, TIED, block, body, condition, contact, disc, friction, keys, mesh, round_hole,
                     written)

PRESS = condition("top", "Neumann", Traction_Y="-0.01")
FOOT = condition("bottom", "Dirichlet", Displacement_Y=0)


def stack(name, gap, *more):
    """Two blocks, drawn with a gap between them."""
    return written(name, [
        body("a", block(0, 1 + gap, 1, 2 + gap), 1.0, PRESS, "X", mesh(3, 3, 2), 0.0),
        body("b", block(-0.5, 0, 1.5, 1), 1.0, FOOT, "X", mesh(4, 3, 1), 0.0)],
        contact("c", *more), "Density")


SIDES = (("a:bottom", "b:top"), ("b:top", "a:bottom"))
for sides in SIDES:
    for gap in (1e-3, -1e-3):
        settled = [run(stack("stack", drawn, *sides, friction("0.2") + keys(Adjust=2e-3)), "stack")
                   for drawn in (gap, 0)]
        forces = [history[-1]["force_normal"] for history, _ in settled]
        energies = [history[-1]["energy_strain"] for history, _ in settled]
        claim(differ(*energies) < 1e-11 and differ(*forces) < 1e-11,
              "blocks drawn with a gap of %g are as those drawn without, first %s" % (gap, sides[0]))
        claim(largest(q["gap"] for q in settled[0][1]) == 0, "their gap is zero")
    plain, wide = (run(stack("wide", -1e-3, *sides, part), "wide")[0][-1]
                   for part in (NONE, keys(Adjust=5e-4)))
    claim(plain == wide or differ(plain["energy_strain"], wide["energy_strain"]) == 0,
          "an overlap that is larger stays as drawn")

# a ring on a disc, drawn too wide or too narrow: no stress by itself, and the pressure of the
# Interference alone
for gap in (1e-4, -1e-4):
    for interference, adjusted in ((0, True), (1e-3, True), (1e-3 + gap, False)):
        history, points = run(written("fit", [
            body("disc", disc(1, "rim"), 1.0, fix="X, Y, Rotation"),
            body("ring", disc(2, "outer", holes=round_hole(1 + gap, "bore")), 1.0)],
            contact("fit", "disc:rim", "ring:bore",
                    keys(Interference=interference, **({"Adjust": 2e-4} if adjusted else {})) + friction(
                        "0.1")), "Density", degree=6, size=0.8), "fit")
        if interference == 0:
            claim(history[-1]["energy_strain"] < 1e-26 and largest(q["lambda_n"] for q in points) < 1e-13,
                  "a ring drawn with a gap of %g is free of stress" % gap)
        elif adjusted:
            pressed = points
        else:
            claim(largest(q["lambda_n"] / p["lambda_n"] - 1 for p, q in zip(pressed, points)) < 1e-10,
                  "with Interference it has that overlap's pressure, %.6g" % points[0]["lambda_n"])

# neither parallel nor concentric: as drawn, and told
hertz = scene("two-cylinders.xml")
code, text = epafi("check", hertz, settings=["Contacts->line->Adjust=0.001"])
claim(code == 0 and "neither parallel nor concentric" in text, "round sides stay as drawn, with a sentence")
refused("a bond needs none", stack("tied", 1e-3, *SIDES[0], TIED + keys(Adjust=0.1)), "Contacts->c->Adjust",
        "Tied")
refused("not negative", stack("negative", 1e-3, *SIDES[0], keys(Adjust=-0.1)), "Contacts->c->Adjust")
finish()
