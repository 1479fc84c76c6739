"""Several bodies: what is refused, with the key and the reason."""
from runs import changed, finish, refused
from written import (CLAMPED, NONE, Keys, block, body, condition, contact, disc, friction, geometry,
                     keys, listed, rigid, round_hole, written)

PRESS = condition("top", "Neumann", Traction_Y="-1")
ROLLER = condition("bottom", "Dirichlet", Displacement_Y="0")
CLAMP = condition("bottom", "Dirichlet", CLAMPED)


def spoiled(what, bodies, contacts, *words):
    refused(what, written("bad", bodies, contacts), *words)


A = body("a", block(0, 0, 1, 1), 1.0, PRESS, "X, Rotation")
B = body("b", block(0, -1, 1, 0), 1.0, CLAMP)
FLOOR = rigid("floor", block(0, -1, 1, 0))
spoiled("strangers", [A, B], contact("c", "a:bottom", "c:top"), "Contacts->c->Between",
        "no body 'c'")
spoiled("unknown boundary", [A, B], contact("c", "a:bottom", "b:topp"), "'b:topp'",
        "'top'")
spoiled("no colon", [A, B], contact("c", "a", "b:top"), "body:boundary")
spoiled("one side", [A, B], listed("c", Between=["a:bottom"]),
        "between two")
spoiled("itself", [A, B], contact("c", "a:bottom", "a:top"), "itself")
spoiled("two rigid", [A, FLOOR, rigid("roof", block(0, 2, 1, 3))],
        contact("c", "floor:top", "roof:bottom"), "both bodies are rigid")
spoiled("all rigid", [FLOOR], NONE, "at least one must be elastic")
spoiled("a side with a condition", [A, B], contact("c", "a:top", "b:top"),
        "Boundary Conditions->top")
spoiled("sides that never meet", [A, B], contact("c", "a:left", "b:top"), "never meet")
spoiled("twice", [A, B, body("d", block(2, -1, 3, 0), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top") + contact("e", "a:bottom", "d:top"),
        "Contacts->c", "different names")
spoiled("pressed on and carrying",
        [A, B, body("d", block(2, -1, 3, 0), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top") + contact("e", "b:top", "d:top"), "Contacts->c")
spoiled("a rigid body with a material", [A, listed(
    "floor", listed("Material", Keys({"Young's Modulus": 1}), Rigid=True), geometry(
                        block(0, -1, 1, 0)))], contact("c", "a:bottom", "floor:top"),
        "Young's Modulus", "rigid")
spoiled("a rigid body with conditions", [A, listed(
    "floor", listed("Material", Rigid=True),
    geometry(block(0, -1, 1, 0)), listed("Boundary Conditions", CLAMP))],
        contact("c", "a:bottom", "floor:top"), "Boundary Conditions->bottom", "rigid")
spoiled("an elastic body with a motion", [A, body(
    "b", block(0, -1, 1, 0), 1.0, inside=listed("Motion", Rotation=0.1))],
        contact("c", "a:bottom", "b:top"), "Motion->Rotation")
spoiled("steel of another world", [body("a", block(0, 0, 1, 1), 1e20, PRESS, "X, Rotation"), B],
        contact("c", "a:bottom", "b:top"), "Contacts->c->Between", "1e+20 times as stiff", "Rigid")
spoiled("no modulus", [listed("a", listed("Material"), geometry(block(0, 0, 1, 1)))], NONE,
        "Young's Modulus", "missing")
spoiled("overlap", [A, body("b", block(0.5, 0.2, 1.5, 0.8), 1.0, CLAMP)], NONE, "overlap")
spoiled("one inside the other", [A, body("b", block(0.4, 0.4, 0.6, 0.6), 1.0, CLAMP)], NONE,
        "overlap")
spoiled("one in the place of the other", [A, body("b", block(0, 0, 1, 1), 1.0, CLAMP)],
        contact("c", "a:bottom", "b:top"), "'a' and 'b'", "overlap")
spoiled("behind each other", [A, body("b", block(0, -1, 1, 0), 1.0, ROLLER, "X")],
        contact("c", "a:right", "b:left"), "Contacts->c", "never meet")
spoiled("a motion that a clamp holds", [A, body("b", block(0, -1, 1, 0), 1.0, CLAMP, "X")],
        contact("c", "a:bottom", "b:top"), "Bodies->b->Rigid Motions->Fix", "clamps")
for what, outline, words in (
        ("a bulge of more than any circle", geometry(block(0, 0, 1, 1), bulges=(0, 1e300, 0, 0)),
         ("Bulges", "from -10 to 10")),
        ("a bulge that is no number", geometry(block(0, 0, 1, 1), bulges=(0, float("nan"), 0, 0)),
         ("Bulges", "NaN")),
        ("too few bulges", geometry(block(0, 0, 1, 1), bulges=(0, 0, 0)), ("Bulges", "one bulge each")),
        ("arcs that cross", geometry(block(0, 0, 1, 1), bulges=(0, -1, -1, 0)), ("crosses itself",)),
        ("two arcs that lie on each other", geometry([(0, 0), (1, 0)], "bottom, top", (1, -1)),
         ("crosses itself",)),
        ("a circle without arcs", geometry([(0, 0), (1, 0)], "bottom, top"), ("at least 3",)),
        ("a circle the wrong way round", geometry([(0, 0), (1, 0)], "bottom, top", (-1, -1)),
         ("clockwise",)),
        ("a side without length", geometry([(0, 0), (1, 0), (1, 0), (1, 1)]), ("no length",)),
        ("a hole outside", geometry(block(0, 0, 1, 1), holes=round_hole(0.1, "s", 5, 5)),
         ("hole 1", "inside")),
        ("a hole that an arc makes too large", geometry(block(0, 0, 1, 1), holes=round_hole(
            0.5, "s", 0.5, 0.5)), ("hole 1", "touch or cross"))):
    spoiled(what, [body("a", outline, 1.0), B], contact("c", "a:bottom", "b:top"),
            "Bodies->a->Geometry", *words)
SIDES = keys(Between=["a:bottom", "b:top"])
for what, contacts, words in (
        ("the same two sides twice", contact("c", "a:bottom", "b:top") +
         contact("d", "b:top", "a:bottom"), ("Contacts->d->Between", "different names")),
        ("three sides", listed("c", Between=["a:bottom", "b:top", "a:top"]),
         ("Contacts->c->Between", "3 sides")),
        ("no sides", listed("c"), ("Contacts->c->Between", "missing")),
        ("a gap between bodies", listed("c", SIDES, Gap=0),
         ("Contacts->c->Gap", "unknown")),
        ("friction that drives", listed("c", SIDES, friction("-0.3")),
         ("Contacts->c->Friction->Coefficient", ">= 0"))):
    spoiled(what, [A, B], contacts, *words)
for what, second, words in (("two bodies of one name", "a2", "Bodies->a"),
                            ("one contact twice", "c2", "Contacts->c")):
    file = written("twice", [A, B, body("a2", block(5, 5, 6, 6), 1.0)], contact(
        "c", "a:bottom", "b:top") + contact("c2", "a:bottom", "b:top"))
    refused(what, changed("twice", file, ('"%s"' % second, '"%s"' % second[0])), words, "twice")
spoiled("a motion given twice",
        [A, rigid("floor", block(0, -1, 1, 0), listed("Motion", Displacement_Y=0, Force_Y=1))],
        contact("c", "a:bottom", "floor:top"), "Bodies->floor->Motion->Force Y", "not both")
spoiled("a disc that may spin", [body("d", disc(0.3, "s", 0.5, 0.3), 1.0, NONE, "X"), B],
        contact("c", "d:s", "b:top"), "Bodies->d", "nothing resists")
spoiled("a free motion", [body("a", block(0, 0, 1, 1), 1.0, PRESS), B],
        contact("c", "a:bottom", "b:top"), "Bodies->a", "nothing resists")
spoiled("a body without hold", [A, B, body("d", block(3, 0, 4, 1), 1.0)],
        contact("c", "a:bottom", "b:top"), "Bodies->d", "nothing resists")
spoiled("an interference that is no number", [A, B],
        contact("c", "a:bottom", "b:top", Interference="1/0"),
        "Interference")
finish()
