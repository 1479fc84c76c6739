"""Several bodies: what is refused, with the key and the reason.  Each row changes two-blocks.xml."""
from runs import changed, finish, keys_of, refused, saved, scene

PAIR = scene("two-blocks.xml")
PAD, PLATE, JOINT, BETWEEN = ("Bodies->pad->", "Bodies->plate->", "Contacts->joint->",
                              "Contacts->joint->Between=")
OUTLINE, CORNERS, BULGES = PAD + "Geometry=", PAD + "Geometry->Vertices=4x2:", PAD + "Geometry->Bulges="
HOLE = PAD + ("Geometry={Vertices=4x2:{-1,0, 1,0, 1,2, -1,2}, Edges={bottom, right, top, left}, "
              "Hole 1 Vertices=2x2:{%s}, Hole 1 Edges={s, s}, Hole 1 Bulges={1, 1}}")
CLAMPED = "{Type=Dirichlet, Displacement X=0, Displacement Y=0}"


def third(left, bottom, conditions="{bottom=%s}" % CLAMPED):
    """One more body, of side 1, clamped."""
    return ("Bodies->third={Material={Young's Modulus=1, Poisson's Ratio=0.3}, Geometry={Vertices=4x2:"
            "{%g,%g, %g,%g, %g,%g, %g,%g}, Edges={bottom, right, top, left}}, Boundary Conditions=%s}" % (
                left, bottom, left + 1, bottom, left + 1, bottom + 1, left, bottom + 1, conditions))


def rigid(name):
    return ["Bodies->%s->%s" % (name, key) for key in ("Material={Rigid=true}", "Boundary Conditions=")]


for what, settings, *words in (
        # between what
        ("strangers", [BETWEEN + "{pad:bottom, c:top}"], "Contacts->joint->Between", "no body 'c'"),
        ("an unknown boundary", [BETWEEN + "{pad:bottom, plate:topp}"], "'plate:topp'", "'top'"),
        ("no colon", [BETWEEN + "{pad, plate:top}"], "body:boundary"),
        ("one side", [BETWEEN + "{pad:bottom}"], "between two"),
        ("three sides", [BETWEEN + "{pad:bottom, plate:top, pad:top}"], BETWEEN[:-1], "3 sides"),
        ("no sides", [BETWEEN], BETWEEN[:-1], "missing"),
        ("itself", [BETWEEN + "{pad:bottom, pad:top}"], "itself"),
        ("a side with a condition", [BETWEEN + "{pad:top, plate:top}"], "Boundary Conditions->top"),
        ("sides that never meet", [BETWEEN + "{pad:left, plate:top}"], "never meet"),
        ("behind each other", [BETWEEN + "{pad:right, plate:left}"], "Contacts->joint", "never meet"),
        ("the same two sides twice", ["Contacts->second={Between={plate:top, pad:bottom}}"],
         "Contacts->second->Between", "different names"),
        ("a side twice", [third(2, -1), "Contacts->second={Between={pad:bottom, third:top}}"],
         "Contacts->", "different names"),
        ("pressed on and carrying", [third(2, -1), "Contacts->second={Between={plate:top, third:top}}"],
         "Contacts->joint"),
        ("a gap between bodies", [JOINT + "Gap=0"], JOINT + "Gap", "unknown"),
        ("friction that drives", [JOINT + "Friction->Coefficient=-0.3"], JOINT + "Friction->Coefficient",
         ">= 0"),
        ("an interference that is no number", [JOINT + "Interference=1/0"], "Interference"),
        # rigid bodies
        ("two rigid", [third(5, 0), *rigid("pad"), PAD + "Mesh=", *rigid("plate")], "both bodies are rigid"),
        ("all rigid", [*rigid("pad"), PAD + "Mesh=", *rigid("plate"), "Contacts="], "at least one must be elastic"),
        ("a rigid body with a material", [PLATE + "Boundary Conditions=", PLATE + "Material->Rigid=true"],
         "Young's Modulus", "rigid"),
        ("a rigid body with conditions", [PLATE + "Material={Rigid=true}"],
         "Boundary Conditions->bottom", "rigid"),
        ("an elastic body with a motion", [PLATE + "Motion={Rotation=0.1}"], "Motion->Rotation"),
        ("a motion given twice", [*rigid("plate"), PLATE + "Motion={Displacement Y=0, Force Y=1}"],
         PLATE + "Motion->Force Y", "not both"),
        # materials and places
        ("steel of another world", [PAD + "Material->Young's Modulus=1e20"], BETWEEN[:-1],
         "times as stiff", "Rigid"),
        ("no modulus", [PAD + "Material->Young's Modulus="], "Young's Modulus", "missing"),
        ("overlap", [third(0.2, 0.1), "Contacts="], "overlap"),
        ("one inside the other", [CORNERS + "{-0.1,-0.6, 0.1,-0.6, 0.1,-0.4, -0.1,-0.4}", "Contacts="],
         "overlap"),
        ("one in the place of the other", [CORNERS + "{-1,-1, 1,-1, 1,0, -1,0}"], "'pad' and 'plate'",
         "overlap"),
        ("a motion that a clamp holds", [PLATE + "Rigid Motions={Fix={X}}"],
         PLATE + "Rigid Motions->Fix", "clamps"),
        ("a disc that may spin", [OUTLINE + "{Vertices=2x2:{0.3,0.3, -0.3,0.3}, Edges={bottom, bottom}, "
                                  "Bulges={1, 1}}", PAD + "Mesh=", PAD + "Boundary Conditions=",
                                  PAD + "Rigid Motions={Fix={X}}", JOINT + "Friction="], "Bodies->pad",
         "nothing resists"),
        # outlines
        ("a bulge of more than any circle", [BULGES + "{0, 1e300, 0, 0}"], "Bulges", "from -10 to 10"),
        ("a bulge that is no number", [BULGES + "{0, nan, 0, 0}"], "Bulges", "not a number"),
        ("too few bulges", [BULGES + "{0, 0, 0}"], "Bulges", "one bulge each"),
        ("arcs that cross", [BULGES + "{0, -1, -1, 0}"], PAD + "Geometry", "crosses itself"),
        *((what, [OUTLINE + "{Vertices=2x2:{0,0, 1,0}, Edges={bottom, top}%s}" % bulges,
                  PAD + "Mesh="], PAD + "Geometry", words) for what, bulges, words in (
            ("two arcs that lie on each other", ", Bulges={1, -1}", "crosses itself"),
            ("a circle without arcs", "", "at least 3"),
            ("a circle the wrong way round", ", Bulges={-1, -1}", "clockwise"))),
        ("a side without length", [CORNERS + "{0,0, 1,0, 1,0, 1,1}"], PAD + "Geometry", "no length"),
        ("a hole outside", [HOLE % "5.1,5, 4.9,5", PAD + "Mesh="], PAD + "Geometry", "hole 1", "inside"),
        ("a hole that an arc makes too large", [HOLE % "0.99,1, -0.99,0.9", PAD + "Mesh="],
         PAD + "Geometry", "hole 1", "touch or cross")):
    refused(what, PAIR, *words, settings=settings)
whole = saved("whole", keys_of(PAIR).changed({"Contacts->two": {"Between": ["pad:top", "plate:top"]}}))
for what, second, first in (("two bodies of one name", "plate", "pad"), ("a contact twice", "two", "joint")):
    refused(what, changed("twice", whole, ('"%s"' % second, '"%s"' % first)), "->" + first, "twice")
finish()
