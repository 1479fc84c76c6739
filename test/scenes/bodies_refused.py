"""Several bodies: what is refused, with the key and the reason."""
from runs import claim, epafi, finish, fresh
from written import (QUARTERS, block, body, circle, condition, contact, friction, geometry, listed,
                     loop, parameter, rigid, written)

PRESS = condition("top", "Neumann", Traction_Y="-1")
ROLLER = condition("bottom", "Dirichlet", Displacement_Y="0")
CLAMP = condition("bottom", "Dirichlet", Displacement_X="0", Displacement_Y="0")
ROUND = "{s, s, s, s}"
HOLE = "Hole 1 "


def refused(what, bodies, contacts, *words):
    code, text = epafi("run", written("bad", bodies, contacts), "--output", fresh("bad"))
    claim(code == 1 and all(word in text for word in words),
          "%s: exit 1 and %s; got %d, %s" % (what, words, code, text))


A = body("a", block(0, 0, 1, 1), 1.0, PRESS, "{X, Rotation}")
B = body("b", block(0, -1, 1, 0), 1.0, CLAMP)
FLOOR = rigid("floor", block(0, -1, 1, 0))
refused("strangers", [A, B], contact("c", "a:bottom", "c:top"), "Contacts->c->Between",
        "no body 'c'")
refused("unknown boundary", [A, B], contact("c", "a:bottom", "b:topp"), "'top'")
refused("no colon", [A, B], contact("c", "a", "b:top"), "body:boundary")
refused("one side", [A, B], listed("c", parameter("Between", "Array(string)", "{a:bottom}")),
        "between two")
refused("itself", [A, B], contact("c", "a:bottom", "a:top"), "itself")
refused("two rigid", [A, FLOOR, rigid("roof", block(0, 2, 1, 3))],
        contact("c", "floor:top", "roof:bottom"), "both bodies are rigid")
refused("all rigid", [FLOOR], "", "at least one must be elastic")
refused("a side with a condition", [A, B], contact("c", "a:top", "b:top"),
        "Boundary Conditions->top")
refused("sides that never meet", [A, B], contact("c", "a:left", "b:top"), "never meet")
refused("twice", [A, B, body("d", block(2, -1, 3, 0), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top") + contact("e", "a:bottom", "d:top"),
        "Contacts->c", "different names")
refused("pressed on and carrying",
        [A, B, body("d", block(2, -1, 3, 0), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top") + contact("e", "b:top", "d:top"), "Contacts->c")
refused("a rigid body with a material", [A, listed(
    "floor", listed("Material", parameter("Rigid", "bool", "true"),
                    parameter("Young's Modulus", "double", 1.0)), geometry(
                        block(0, -1, 1, 0)))], contact("c", "a:bottom", "floor:top"),
        "Young's Modulus", "rigid")
refused("a rigid body with conditions", [A, listed(
    "floor", listed("Material", parameter("Rigid", "bool", "true")),
    geometry(block(0, -1, 1, 0)), listed("Boundary Conditions", CLAMP))],
        contact("c", "a:bottom", "floor:top"), "Boundary Conditions->bottom", "rigid")
refused("an elastic body with a motion", [A, listed(
    "b", listed("Material", parameter("Young's Modulus", "double", 1.0),
                parameter("Poisson's Ratio", "double", 0.3)), geometry(block(0, -1, 1, 0)),
    listed("Motion", parameter("Rotation", "string", "0.1")))],
        contact("c", "a:bottom", "b:top"), "Motion->Rotation")
refused("steel of another world", [body("a", block(0, 0, 1, 1), 1e20, PRESS, "{X, Rotation}"), B],
        contact("c", "a:bottom", "b:top"), "Contacts->c->Between", "1e+20 times as stiff", "Rigid")
refused("no modulus", [listed("a", listed("Material"), geometry(block(0, 0, 1, 1)))], "",
        "Young's Modulus", "missing")
refused("overlap", [A, body("b", block(0.5, 0.2, 1.5, 0.8), 1.0, CLAMP)], "", "overlap")
refused("one inside the other", [A, body("b", block(0.4, 0.4, 0.6, 0.6), 1.0, CLAMP)], "",
        "overlap")
refused("one in the place of the other", [A, body("b", block(0, 0, 1, 1), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top"), "'a' and 'b'", "overlap")
refused("behind each other", [A, body("b", block(0, -1, 1, 0), 1.0, ROLLER, "{X}")],
        contact("c", "a:right", "b:left"), "Contacts->c", "never meet")
refused("a motion that a clamp holds", [A, body("b", block(0, -1, 1, 0), 1.0, CLAMP, "{X}")],
        contact("c", "a:bottom", "b:top"), "Bodies->b->Rigid Motions->Fix", "clamps")
for what, outline, words in (
        ("a bulge of more than any circle", geometry(block(0, 0, 1, 1), bulges=(0, 1e300, 0, 0)),
         ("Bulges", "from -10 to 10")),
        ("a bulge that is no number", geometry(block(0, 0, 1, 1), bulges=(0, float("nan"), 0, 0)),
         ("Bulges", "entry 1")),
        ("too few bulges", geometry(block(0, 0, 1, 1), bulges=(0, 0, 0)), ("Bulges", "one bulge each")),
        ("arcs that cross", geometry(block(0, 0, 1, 1), bulges=(0, -1, -1, 0)), ("crosses itself",)),
        ("two arcs that lie on each other", geometry([(0, 0), (1, 0)], "{bottom, top}", (1, -1)),
         ("crosses itself",)),
        ("a circle without arcs", geometry([(0, 0), (1, 0)], "{bottom, top}"), ("at least 3",)),
        ("a circle the wrong way round", geometry([(0, 0), (1, 0)], "{bottom, top}", (-1, -1)),
         ("clockwise",)),
        ("a side without length", geometry([(0, 0), (1, 0), (1, 0), (1, 1)]), ("no length",)),
        ("a hole outside", geometry(block(0, 0, 1, 1), holes=loop(
            circle(0.1, 5, 5), ROUND, QUARTERS, HOLE)), ("hole 1", "inside")),
        ("a hole that an arc makes too large", geometry(block(0, 0, 1, 1), holes=loop(
            circle(0.5, 0.5, 0.5), ROUND, QUARTERS, HOLE)), ("hole 1", "touch or cross"))):
    refused(what, [body("a", outline, 1.0), B], contact("c", "a:bottom", "b:top"),
            "Bodies->a->Geometry", *words)
SIDES = parameter("Between", "Array(string)", "{a:bottom, b:top}")
for what, contacts, words in (
        ("one contact twice", 2 * contact("c", "a:bottom", "b:top"), ("Contacts->c", "twice")),
        ("the same two sides twice", contact("c", "a:bottom", "b:top") +
         contact("d", "b:top", "a:bottom"), ("Contacts->d->Between", "different names")),
        ("three sides", listed("c", parameter("Between", "Array(string)", "{a:bottom, b:top, a:top}")),
         ("Contacts->c->Between", "3 sides")),
        ("no sides", listed("c"), ("Contacts->c->Between", "missing")),
        ("a gap between bodies", listed("c", SIDES, parameter("Gap", "string", "0")),
         ("Contacts->c->Gap", "unknown")),
        ("friction that drives", listed("c", SIDES, friction("-0.3")),
         ("Contacts->c->Friction->Coefficient", ">= 0"))):
    refused(what, [A, B], contacts, *words)
refused("two of one name", [A, A, B], contact("c", "a:bottom", "b:top"), "Bodies->a", "twice")
refused("a motion given twice", [A, rigid("floor", block(0, -1, 1, 0), listed(
    "Motion", parameter("Displacement Y", "string", "0"), parameter("Force Y", "string", "1")))],
        contact("c", "a:bottom", "floor:top"), "Bodies->floor->Motion->Force Y", "not both")
refused("a disc that may spin", [body("d", geometry(circle(0.3, 0.5, 0.3), ROUND, QUARTERS), 1.0, "",
                                      "{X}"), B], contact("c", "d:s", "b:top"), "Bodies->d",
        "nothing resists")
refused("a free motion", [body("a", block(0, 0, 1, 1), 1.0, PRESS), B],
        contact("c", "a:bottom", "b:top"), "Bodies->a", "nothing resists")
refused("a body without hold", [A, B, body("d", block(3, 0, 4, 1), 1.0)],
        contact("c", "a:bottom", "b:top"), "Bodies->d", "nothing resists")
refused("an interference that is no number", [A, B],
        contact("c", "a:bottom", "b:top", parameter("Interference", "string", "1/0")),
        "Interference")
finish()
