"""A body that meets itself: a split ring closed by a band and a slotted beam in bending, against the
same cut into two bodies that are tied; slots from wide to narrow, which pressure closes."""
import math

from runs import (RANKS, claim, differ, finish, goes_on, keys_of, largest, levels, refused,
                  rows, run, saved, solved, steps)
from written import (CLAMPED, NONE, TIED, body, condition, contact, disc, friction, geometry, history,
                     keys, listed, round_hole, written)

INNER, OUTER = 1.0, 1.6


def arcs(radius, angles):
    """Corners of arcs of a circle between angles, and their bulges."""
    return ([(radius * math.cos(a), radius * math.sin(a)) for a in angles],
            [math.tan((b - a) / 4) for a, b in zip(angles, angles[1:])])


def ring(gap, first, last, ends):
    """A part of a ring between two angles, in quarters of a turn; it is split at 0 and 4."""
    def angles(radius):
        off = math.asin(gap / 2 / radius)
        return [k * math.pi / 2 + (off if k == 0 else -off if k == 4 else 0)
                for k in range(first, last + 1)]
    out, bulges = arcs(OUTER, angles(OUTER))
    back, inwards = arcs(INNER, angles(INNER)[::-1])
    count = last - first
    return geometry(out + back, ["outer"] * count + [ends[1]] + ["bore"] * count + [ends[0]],
                    bulges + [0] + inwards + [0])


def split(name, whole, gap=0.02, press=0.01, degree=8, size=0.15, order=1, more=NONE):
    """A split ring in a band that presses it together."""
    band = body("band", disc(2, "edge", holes=round_hole(OUTER, "seat")), 2.0, fix="X, Y, Rotation")
    grip = keys(Interference=press) + friction(0.2)
    if whole:
        bodies = [band, body("ring", ring(gap, 0, 4, ("up", "low")), 1.0)]
        sides = ("ring:up", "ring:low")
        contacts = contact("grip", "ring:outer", "band:seat", grip)
    else:
        bodies = [band, body("above", ring(gap, 0, 2, ("up", "back")), 1.0),
                  body("below", ring(gap, 2, 4, ("back", "low")), 1.0)]
        sides = ("above:up", "below:low")
        contacts = (contact("grip1", "above:outer", "band:seat", grip) +
                    contact("grip2", "below:outer", "band:seat", grip) +
                    contact("back", "above:back", "below:back", TIED))
    return written(name, bodies, contacts + contact("slit", *sides[::order], friction(0.2)), "Density",
                   size, degree, more)


def slotted(name, whole, gap=0.01, push=-0.002, degree=10, size=0.1, law=friction(0.3), order=1,
            more=NONE):
    """A beam with a slot that ends in a round hole, its upper half pushed onto the lower one."""
    r, x = 0.1, 2.0  # of the hole, and its middle
    end = x - math.sqrt(r * r - gap * gap / 4)
    bulge = -math.tan((math.pi - math.asin(gap / 2 / r)) / 4)
    load = condition("tip", "Neumann", Traction_Y=push)
    wall = condition("wall", "Dirichlet", CLAMPED)
    above = [(x + r, 0), (3, 0), (3, 0.5), (0, 0.5), (0, gap / 2), (end, gap / 2)]
    below = [(end, -gap / 2), (0, -gap / 2), (0, -0.5), (3, -0.5), (3, 0), (x + r, 0)]
    if whole:
        bodies = [body("beam", geometry(below[:4] + above[2:] + above[:1],
                                        "low, end, bottom, wall, top, tip, up, hole, hole",
                                        [0] * 7 + [bulge] * 2), 1.0, load + wall)]
        sides, glue = ("beam:up", "beam:low"), NONE
    else:
        bodies = [body("above", geometry(above, "cut, wall, top, tip, up, hole", [0] * 5 + [bulge]), 1.0,
                       load + wall),
                  body("below", geometry(below, "low, end, bottom, wall, cut, hole", [0] * 5 + [bulge]),
                       1.0, wall)]
        sides, glue = ("above:up", "below:low"), contact("glue", "above:cut", "below:cut", TIED)
    return written(name, bodies, glue + contact("slot", *sides[::order], law), "Density", size, degree,
                   more)


def pressed(name, gap, law=NONE, form="Density", order=1, degree=2, ratio=0.3, size=0.25, linear="Dense"):
    """A block with a slot from its left side that a uniform pressure closes, as if it were whole."""
    p = 0.01
    held = (1 - ratio ** 2) * p * gap  # by this the block that the slot leaves out would be shorter
    outline = [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0.5 + gap), (1.25, 0.5 + gap), (1.25, 0.5), (0, 0.5)]
    return written(name, [body(
        "a", geometry(outline, "bottom, right, top, left, up, end, low, left"), 1.0,
        condition("bottom", "Dirichlet", Displacement_Y=0) + condition("top", "Neumann", Traction_Y=-p), "X",
        ratio=ratio)], contact("c", *("a:up", "a:low")[::order], law, keys(
            Adjust=2 * gap, Interference=-held)), form, size, degree,
        listed("Solver", Linear={"Method": linear}))


# against the same cut into two, whose bond has an error of its own
for maker, form, given, within in (
        (split, "Projected", {"size": 0.125}, 1e-8), (slotted, "Projected", {"size": 0.125}, 1e-8),
        (slotted, "Density", {"size": 0.125}, 1e-8),
        (slotted, "Density", {"order": -1}, 1e-6), (split, "Density", {"size": 0.3}, 1e-6)):
    one, two = (run(maker("cut", whole, **given), "cut", [
        "Discretization->Stabilization->Form=" + form])[0][-1] for whole in (True, False))
    name = "slit" if maker is split else "slot"
    apart = {key: differ(one[key], two[key]) for key in ("energy_strain", name + ".force_y",
                                                         name + ".contact_length", "estimate_relative")}
    claim(apart["energy_strain"] < within and apart[name + ".force_y"] < 10 * within,
          "%s, %s: as the same cut into two, energy to %.1e, force to %.1e" % (
              maker.__name__, form, apart["energy_strain"], apart[name + ".force_y"]))
    claim(one[name + ".contact_length"] > 0 and apart[name + ".contact_length"] < 0.01 and
          apart["estimate_relative"] < 0.05 and abs(one["contact_y"]) < 1e-12,
          "so are length and estimate, to %.1e and %.1e; its contact forces cancel" % (
              apart[name + ".contact_length"], apart["estimate_relative"]))

# closed slots, however narrow: the stress of the whole block
for gap in (0.25, 2.5e-3, 2.5e-5, 2.5e-7):
    for law, form, order, degree in ((NONE, "Density", 1, 2), (friction(0.3), "Density", -1, 5),
                                     (NONE, "Projected", 1, 2), (NONE, "None", 1, 2)):
        row, points = run(pressed("pressed", gap, law, form, order, degree), "pressed")
        error = largest(q["lambda_n"] / 0.01 - 1 for q in points)
        claim(error < 1e-9 and largest(q["uy"] + 0.91 * 0.01 * q["y"]
                                        for q in rows("pressed", "boundary.csv")) < 1e-13,
              "a slot of %g of an element, Form %s, degree %d: pressure to %.1e" % (
                  gap / 0.25, form, degree, error))
    _, points = run(pressed("squeezed", gap, linear="Compressed"), "squeezed")
    error = largest(q["lambda_n"] / 0.01 - 1 for q in points)
    claim(error < 1e-8, "compressed: to %.1e" % error)
_, points = run(pressed("wide", 0.25, size=0.02, linear="Compressed"), "wide")
error = largest(q["lambda_n"] / 0.01 - 1 for q in points)
claim(error < 1e-8, "compressed, faces that are far apart for their elements: to %.1e" % error)
for gap, within in ((2.5e-3, 1e-8), (2.5e-5, 1e-5)):
    folder, text = solved("soft", pressed("soft", gap, ratio=0.5))
    error = largest(q["lambda_n"] / 0.01 - 1 for q in rows("soft"))
    claim(error < within and ("lose the pressure's digits" in text) == (gap < 1e-4),
          "at Poisson's ratio 1/2 to %.1e, and told of" % error)

# work on a path, restart, levels, compressed operators
PATH = slotted("path", True, push="-0.002*sin(pi*t/2)", degree=3, size=0.5, more=history([1, 2], 4))
goes_on("path", PATH, levels(2), ["Adaptivity->Maximum Levels=1"])
last, parts = (steps("path, at once")[-1], steps("path, at once"))
claim(last["energy_dissipated"] > 0 and abs(last["energy_error"]) < 1e-4 * last["energy_dissipated"],
      "unloaded, a path has lost what friction took: %.3e and %.1e" % (
          last["energy_dissipated"], last["energy_error"]))
DEEP = listed("Adaptivity", Strategy="Graded hp", Tolerance=0.003)
deep = [run(slotted("deep%d" % k, k == 0, degree=2, size=0.5, more=DEEP), "deep%d" % k)[0][-1]
        for k in (0, 1)]
claim(all(row["estimate_relative"] < 0.003 for row in deep) and
      differ(deep[0]["energy_strain"], deep[1]["energy_strain"]) < 1e-5 and
      deep[0]["dof"] < 1.1 * deep[1]["dof"], "refined as the same cut into two: %d and %d unknowns" % (
          deep[0]["dof"], deep[1]["dof"]))
squeezed = [run(slotted("squeezed", True, degree=3, more=listed("Solver", Linear={"Method": method})),
                "squeezed", levels(2))[0][-1] for method in ("Dense", "Compressed")]
claim(differ(*(row["energy_strain"] for row in squeezed)) < 1e-8 and
      differ(*(row["slot.force_y"] for row in squeezed)) < 1e-6, "compressed as dense")

# a body that nothing holds, under loads that balance
def loose(fix):
    scene = keys_of(slotted("loose", True, degree=3, size=0.5, law=NONE))
    loads = {side: {"Type": "Neumann", "Traction Y": "%g * (3 - x)" % p} for side, p in (
        ("top", -0.001), ("bottom", 0.001))}
    return run(saved("loose", scene.changed({
        "Bodies->beam->Boundary Conditions": loads,
        **({"Bodies->beam->Rigid Motions->Fix": fix} if fix else {})})), "loose")[0][0]


free, fixed = loose([]), loose(["X", "Y", "Rotation"])
claim(fixed["slot.contact_length"] > 0 and differ(free["energy_strain"], fixed["energy_strain"]) < 1e-10,
      "a loose body closes its slot as one that is held in the mean")

# refused
if RANKS == 1:
    crack = [(0, 0), (2, 0), (2, 1), (0, 1), (0, 0.5), (1, 0.5), (0, 0.5)]
    refused("faces that coincide", written("crack", [body(
        "a", geometry(crack, "bottom, right, top, left, up, low, left"), 1.0,
        condition("bottom", "Dirichlet", CLAMPED))], contact("c", "a:up", "a:low"), "Density"),
        "cut the body along the crack")
    refused("one boundary", written("one", [body("a", disc(1, "rim"), 1.0, fix="X, Y, Rotation")],
                                    contact("c", "a:rim", "a:rim"), "Density"), "Contacts->c->Between",
            "'a:rim' twice")
finish()
