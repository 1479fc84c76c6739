"""Several bodies: what is refused, with key and reason.  Each row changes two-blocks.xml."""
from runs import changed, finish, keys_of, refused, saved, scene

PAIR = scene("two-blocks.xml")
PAD, PLATE, JOINT = "Bodies->pad->", "Bodies->plate->", "Contacts->joint->"
SIDES = JOINT + "Between"
BETWEEN = SIDES + "={%s}"
OUTLINE = PAD + "Geometry={%s}"
CORNERS = PAD + "Geometry->Vertices=4x2:{%s}"
NO_MESH = PAD + "Mesh="


def third(x, y):
    """One more body, of side 1, clamped at its bottom."""
    return ("Bodies->third={Material={Young's Modulus=1, Poisson's Ratio=0.3}, Geometry={"
            "Vertices=4x2:{%g,%g, %g,%g, %g,%g, %g,%g}, Edges={bottom, right, top, left}}, "
            "Boundary Conditions={bottom={Type=Dirichlet, Displacement X=0, Displacement Y=0}}}" % (
                x, y, x + 1, y, x + 1, y + 1, x, y + 1))


def rigid(body):
    return [body + "Material={Rigid=true}", body + "Boundary Conditions="]


BOTH = [*rigid(PAD), NO_MESH, *rigid(PLATE)]
for what, settings, *words in (
        # between what
        ("strangers", [BETWEEN % "pad:bottom, c:top"], SIDES, "no body 'c'"),
        ("an unknown boundary", [BETWEEN % "pad:bottom, plate:topp"], "'plate:topp'", "'top'"),
        ("no colon", [BETWEEN % "pad, plate:top"], "body:boundary"),
        ("one side", [BETWEEN % "pad:bottom"], "between two"),
        ("three sides", [BETWEEN % "pad:bottom, plate:top, pad:top"], SIDES, "3 sides"),
        ("no sides", [SIDES + "="], SIDES, "missing"),
        ("a side with a condition", [BETWEEN % "pad:top, plate:top"], "Boundary Conditions->top"),
        ("sides that never meet", [BETWEEN % "pad:left, plate:top"], "never meet"),
        ("behind each other", [BETWEEN % "pad:right, plate:left"], JOINT[:-2], "never meet"),
        ("the same two sides twice", ["Contacts->two={Between={plate:top, pad:bottom}}"],
         "Contacts->two->Between", "different names"),
        ("a side twice", [third(2, -1), "Contacts->two={Between={pad:bottom, third:top}}"],
         "Contacts->", "different names"),
        ("pressed on and carrying",
         [third(2, -1), "Contacts->two={Between={plate:top, third:top}}"], JOINT[:-2]),
        ("a gap between bodies", [JOINT + "Gap=0"], JOINT + "Gap", "unknown"),
        ("friction that drives", [JOINT + "Friction->Coefficient=-0.3"],
         JOINT + "Friction->Coefficient", ">= 0"),
        ("an interference that is no number", [JOINT + "Interference=1/0"], "Interference"),
        # rigid bodies
        ("two rigid", [third(5, 0), *BOTH], "both bodies are rigid"),
        ("all rigid", [*BOTH, "Contacts="], "at least one must be elastic"),
        ("a rigid body with a material",
         [PLATE + "Boundary Conditions=", PLATE + "Material->Rigid=true"], "Young's Modulus",
         "rigid"),
        ("a rigid body with conditions", [PLATE + "Material={Rigid=true}"],
         "Boundary Conditions->bottom", "rigid"),
        ("an elastic body with a motion", [PLATE + "Motion={Rotation=0.1}"], "Motion->Rotation"),
        ("a motion given twice", [*rigid(PLATE), PLATE + "Motion={Displacement Y=0, Force Y=1}"],
         PLATE + "Motion->Force Y", "not both"),
        # materials, places and motions
        ("steel of another world", [PAD + "Material->Young's Modulus=3e20"], SIDES,
         "1e+20 times as stiff", "Rigid"),
        ("no modulus", [PAD + "Material->Young's Modulus="], "Young's Modulus", "missing"),
        ("overlap", [third(0.2, 0.1), "Contacts="], "overlap"),
        ("one inside the other",
         [CORNERS % "-0.1,-0.6, 0.1,-0.6, 0.1,-0.4, -0.1,-0.4", "Contacts="], "overlap"),
        ("one in the place of the other", [CORNERS % "-1,-1, 1,-1, 1,0, -1,0"],
         "'pad' and 'plate'", "overlap"),
        ("a motion that a clamp holds", [PLATE + "Rigid Motions={Fix={X}}"],
         PLATE + "Rigid Motions->Fix", "clamps"),
        ("a disc that may spin",
         [OUTLINE % "Vertices=2x2:{0.3,0.3, -0.3,0.3}, Edges={bottom, bottom}, Bulges={1, 1}",
          NO_MESH, PAD + "Boundary Conditions=", PAD + "Rigid Motions={Fix={X}}",
          JOINT + "Friction="],
         "Bodies->pad", "nothing resists")):
    refused(what, PAIR, *words, settings=settings)
whole = saved("whole", keys_of(PAIR).changed({"Contacts->two": {"Between": ["pad:top", "a:b"]}}))
for what, second, first, key in (("two bodies of one name", "plate", "pad", PAD),
                                 ("one contact twice", "two", "joint", JOINT)):
    refused(what, changed("twice", whole, ('"%s"' % second, '"%s"' % first)), key[:-2], "twice")
finish()
