"""What lies opposite to a side: round bodies on wide ones, fillets, a roller in a wide race, and bodies
with one name for all edges press with what they carry, on both bodies alike."""
import math

from runs import claim, epafi, finish, fresh, rows, saved

STEEL = {"Young's Modulus": 210000, "Poisson's Ratio": 0.3}
QUARTER = math.tan(math.pi / 8)
GUIDED = {"Fix": ["X", "Rotation"]}
HELD = {"Fix": ["X", "Y", "Rotation"]}


def polygon(corners, names, bulges=()):
    return {"Vertices": corners, "Edges": names, **({"Bulges": bulges} if bulges else {})}


def box(left, bottom, right, top, names):
    return polygon([(left, bottom), (right, bottom), (right, top), (left, top)], names)


def circle(radius, name, y=0.0, hole=""):
    corners = [(0, y - radius), (radius, y), (0, y + radius), (-radius, y)]
    return {hole + key: value for key, value in polygon(corners, [name] * 4, [QUARTER] * 4).items()}


def body(geometry, elements, degree=1, **more):
    return {"Material": STEEL, "Geometry": geometry,
            "Mesh": {"Elements per Edge": elements, "Degree": degree}, **more}


def falls(geometry, area, elements, force=1000.0, degree=1):
    return body(geometry, elements, degree, **{"Body Loads": {"Force Y": -force / area},
                                               "Rigid Motions": GUIDED})


def rigid(geometry):
    return {"Material": {"Rigid": True}, "Geometry": geometry}


def claims(name, bodies, between, force=1000.0, adaptivity=None, more=None):
    """That the bodies press on each other with a force, in either order."""
    for sides in (between, between[::-1]):
        out = fresh(name)
        code, text = epafi("run", saved(name, {
            "Bodies": bodies, "Contacts": {"c": {"Between": sides}},
            "Discretization": {"Degree": 1}, "Adaptivity": adaptivity or {"Strategy": "None"},
            "Output": {"Fields": False}, **(more or {})}), "--output", out)
        last = rows(name, "bodies.csv")[-2:]
        first, second = (row["contact_y"] for row in last)
        claim(code == 0 and abs(first - force) < 1e-8 * force and
              abs(first + second) < 1e-12 * force,
              "%s, %s: %.12g and %.12g of %g" % (name, " on ".join(sides), first, second, force))
        # a normal force is longer than its vertical part by the slope of the side
        normal = rows(name, "history.csv")[-1]["force_normal"]
        claim(force * (1 - 1e-9) < normal < 1.02 * force, "%s: normal force %.6g" % (name, normal))
        claim("lies " not in text and "overlap" not in text, "%s: no overlap is told of" % name)


SIDES = ["base", "side", "top", "side"]
for degree in (1, 2, 3):
    disc = falls(circle(10, "rim", 10), math.pi * 100, [24] * 4, degree=degree)
    block = body(box(-30, -20, 30, 0, SIDES), [4, 4, 12, 4], degree, **{"Rigid Motions": HELD})
    claims("disc of degree %d on a wide block" % degree, {"disc": disc, "block": block},
           ["disc:rim", "block:top"])
disc = falls(circle(10, "rim", 10), math.pi * 100, [8] * 4)
claims("disc on a wide rigid floor", {"disc": disc, "floor": rigid(box(-90, -20, 90, 0, SIDES))},
       ["disc:rim", "floor:top"])
claims("graded disc on a wide block", {"disc": disc, "block": block}, ["disc:rim", "block:top"],
       adaptivity={"Strategy": "Graded hp", "Tolerance": 0.02, "Maximum Degrees of Freedom": 2000})
half = falls(polygon([(0, 0), (10, 10), (0, 20)], ["rim", "rim", "line"], [QUARTER, QUARTER, 0]),
             math.pi * 50, [24, 24, 2], force=500)
del half["Rigid Motions"]  # the line holds what Fix would
block = body(box(0, -20, 30, 0, ["base", "side", "top", "line"]), [4, 4, 12, 4],
             **{"Boundary Conditions": {"base": {"Type": "Dirichlet", "Displacement Y": 0}}})
claims("half a disc on half a block", {"disc": half, "block": block}, ["disc:rim", "block:top"],
       more={"Geometry": {"Symmetry": "X"}})

pad = falls(polygon([(-7, 0), (7, 0), (10, 3), (10, 10), (-10, 10), (-10, 3)],
                    ["face", "face", "side", "top", "side", "face"],
                    [0, QUARTER, 0, 0, 0, QUARTER]), 200 - 2 * 9 * (1 - math.pi / 4),
            [10, 12, 2, 4, 2, 12], degree=2)
plate = body(box(-60, -30, 60, 0, SIDES), [6, 2, 24, 2], **{"Rigid Motions": HELD})
claims("pad with fillets on a wide plate", {"pad": pad, "plate": plate}, ["pad:face", "plate:top"])

for times in (6, 12):
    roller = falls(circle(5, "rim", 5 - 5 * times), math.pi * 25, [12] * 4, degree=2)
    ring = body({**circle(5 * times + 10, "out"), **circle(5 * times, "race", hole="Hole 1 ")},
                [4] * 4, 2, **{"Rigid Motions": HELD})
    ring["Mesh"]["Hole 1 Elements per Edge"] = [16] * 4
    claims("roller in a race of %d times its radius" % times, {"roller": roller, "ring": ring},
           ["roller:rim", "ring:race"])

# all edges under one name: drawn flush, with a gap and with an overlap
ALL = ["all"] * 4
for gap in (0, 0.001, -0.001):
    upper = falls(box(-4, gap, 4, gap + 2, ALL), 16, [8, 2, 8, 2])
    for name, width in (("a wider one", 10), ("its like", 4)):
        lower = body(box(-width, -2, width, 0, ALL), [10, 2, 10, 2], **{"Rigid Motions": HELD})
        claims("block on %s, gap %g" % (name, gap), {"up": upper, "lo": lower}, ["up:all", "lo:all"])
disc = falls(circle(5, "all", -5), math.pi * 25, [12] * 4)
ring = body({**circle(20, "all"), **circle(10, "all", hole="Hole 1 ")}, [4] * 4,
            **{"Rigid Motions": HELD})
ring["Mesh"]["Hole 1 Elements per Edge"] = [16] * 4
claims("disc in a ring", {"disc": disc, "ring": ring}, ["disc:all", "ring:all"])
finish()
