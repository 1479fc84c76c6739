"""Rigid motions deform nothing: bodies that are moved together, or slid over each other, have the
forces and the states of those at rest, from a millionth of their size to a million times it."""
from runs import claim, differ, finish, points, rows, solved, steps
from written import NONE, block, body, condition, contact, friction, history, keys, listed, rigid, written

FRICTION, DEPTH = 0.3, 1e-5
LAW = friction(str(FRICTION))
PRESSED = "-%r*min(t, 1)" % DEPTH


def within(far):
    """Some hundred rounding errors of the motion, over what presses."""
    return 1e-9 + 100 * 1.1e-16 * far / DEPTH


def given(boundary, x, y):
    return condition(boundary, "Dirichlet", **{
        key: value for key, value in (("Displacement_X", x), ("Displacement_Y", y)) if value is not None})


# a block is pressed, by its top or by a load, then pulled over a plane, or a plate under it
def pulled(plate, far, first):
    way = "%r*max(0, t-1)" % far
    if plate == "loaded":
        held = given("left", way, None) + condition("top", "Neumann", Traction_Y=PRESSED)
    else:
        held = given("top", way if plate == "plane" else "0", PRESSED)
    more = history([1, 2], [1, 1])
    outline = block(0, 0, 1, 0.5)
    if plate in ("plane", "loaded"):
        return written("pulled", [body("block", outline, 1.0, held + condition(
            "bottom", "Contact", LAW))], NONE, "Density", more=more)
    under = block(-1, -1, 2, 0)
    other = (rigid("plate", under, listed("Motion", Displacement_X="-" + way)) if plate == "rigid" else
             body("plate", under, 1.0, given("bottom", "-" + way, "0")))
    sides = ("block:bottom", "plate:top")[::first]
    return written("pulled", [body("block", outline, 1.0, held), other],
                   contact("bottom", *sides, LAW), "Density", more=more)


for plate, first in (("plane", 1), ("loaded", 1), ("rigid", 1), ("clamped", 1), ("clamped", -1)):
    known = None
    for far in (1, 1e3, 1e6):
        folder, _ = solved("pulled %s %g %d" % (plate, far, first), pulled(plate, far, first))
        last = steps(folder)[-1]
        normal, shear = last["bottom.force_normal"], abs(last["bottom.force_tangential"])
        known = known or normal
        off = max(differ(normal, known), differ(shear, FRICTION * normal))
        slips = last["bottom.slip_length"] / (last["bottom.contact_length"] or 1)
        claim(off < within(far) and abs(slips - 1) < 1e-9,
              "pulled by %g, %s: the forces to %.1e, %.4f of the contact slips" % (
                  far, plate, off, slips))


# a tower on a clamp: a free block, a block on it that is pressed and pushed, and a rigid pad beside it on
# a spring; all are moved and turned
def tower(far, turn, first):
    def moved(x, y):
        """The displacement that the whole has at a boundary, beside x and y."""
        return ("%r - %r*y + %s" % (far, turn, x), "%r + %r*x + %s" % (far, turn, y))

    lower = body("lower", block(-1, -1, 2, 0), 1.0, given("bottom", *moved("0", "0")))
    free = body("free", block(0, 0, 1, 0.5), 2.0)
    upper = body("upper", block(0, 0.5, 1, 1), 1.0, given("top", *moved("1e-6", "-%r" % DEPTH)))
    pad = rigid("pad", block(1, 0.1, 1.5, 0.4), listed("Motion", **{
        "Reference Point": [0, 0], "Displacement X": "%r - 2e-6" % far, "Stiffness X": 0.5,
        "Displacement Y": "%r" % far, "Rotation": "%r" % turn}))
    return written("tower", [lower, free, upper, pad], keys(
        contact("low", *("free:bottom", "lower:top")[::first], LAW),
        contact("high", *("upper:bottom", "free:top")[::first], LAW),
        contact("beside", "free:right", "pad:left")), "Density", size=0.5)


for first in (1, -1):
    known = None
    for far, turn in ((0, 0), (1e-6, 0), (1, 0), (1, 1e-3), (1e3, 0), (1e6, 0)):
        folder, _ = solved("tower %g %g %d" % (far, turn, first), tower(far, turn, first))
        forces = [row[key] for row in rows(folder, "bodies.csv") for key in ("contact_x", "contact_y")]
        states = [(p["contact"], p["friction"]) for p in points(folder)]
        known = known or (forces, states)
        off = max(abs(a - b) for a, b in zip(forces, known[0])) / max(map(abs, known[0]))
        claim(off < within(max(far, turn)) and states == known[1],
              "a tower moved by %g, turned by %g, order %d: forces to %.1e, %d of %d states" % (
                  far, turn, first, off, sum(a == b for a, b in zip(states, known[1])), len(states)))
finish()
