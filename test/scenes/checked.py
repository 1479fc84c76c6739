"""What `epafi check` says before anything is solved: bodies that are drawn deep into each other or
that nothing holds, and expressions without a value where contact asks for it, at all times of a
path.  Standard library only."""
from runs import claim, epafi, finish
from written import (CLAMPED, NONE, TIED, block, body, condition, contact, friction, history,
                     listed, rigid, written)

CLAMP = condition("bottom", "Dirichlet", CLAMPED)
PRESS = condition("top", "Neumann", Traction_Y="-0.01")
HISTORY = history([1, 3], [2, 4])


def checked(what, code, words, bodies, contacts=NONE, more=NONE, absent=()):
    """The exit code, and words of what is printed."""
    file = written("checked", bodies, contacts, "Density", more=more)
    done, text = epafi("check", file)
    claim(done == code and all(word in text for word in words) and
          not any(word in text for word in absent),
          "%s: exit %d, %s" % (what, done, text.strip().splitlines()[-1]))
    claim(code == 0 or "checked.yaml: " in text, "%s: names the file" % what)
    if "nothing resists" in words:
        done, same = epafi("run", file, "--force")
        claim(done == 1 and text in same, what + ": so does a run: " + same[-150:])


def lower(height=5, conditions=CLAMP, left=0, right=40):
    return body("lower", block(left, 0, right, height), 1.0, conditions)


def upper(bottom, left, right, top=None, conditions=PRESS, fix="X"):
    return body("upper", block(left, bottom, right, top or bottom + 5), 1.0, conditions, fix)


LAP = contact("lap", "upper:bottom", "lower:top")

# plates of one width: only the sides in contact lie in one another
checked("2 in plates of 5", 0, ["warning: Contacts->lap", "upper:bottom", "lower:top", " 2 deep"],
        [lower(), upper(3, 0, 40)], LAP)
checked("an interference of 2", 0, ["warning: Contacts->lap", " 2 deep"], [lower(), upper(5, 0, 40)],
        contact("lap", "upper:bottom", "lower:top", Interference=2))
checked("one that grows", 0, ["warning: Contacts->lap", " 3 deep"], [lower(), upper(5, 0, 40)],
        contact("lap", "upper:bottom", "lower:top", Interference="t"), HISTORY)
for interference in ("0.1", "-2"):
    checked("of " + interference, 0, ["valid"], [lower(), upper(5, 0, 40)],
            contact("lap", "upper:bottom", "lower:top", Interference=interference), NONE,
            ["warning"])
checked("as deep as an interference", 0, ["valid"], [lower(), upper(4.9, 10, 30)], LAP, NONE,
        ["warning"])

# beside the contact sides without contact run into the other body
for left, right, side in ((20, 60, "lower:right"), (10, 30, "upper:"), (-10, 50, "lower:")):
    checked("a lap joint from %g to %g" % (left, right), 1, [
        "overlap by 2 at", "'lower'", "'upper'", side, "far more than an interference"],
        [lower(), upper(3, left, right)], LAP)
checked("without a contact", 1, ["'lower:right' crosses 'upper:bottom'"], [lower(), upper(3, 20, 60)])
checked("bonded", 1, ["overlap by 2 at"], [lower(), upper(3, 20, 60)],
        contact("lap", "upper:bottom", "lower:top", TIED))
checked("a rigid punch", 1, ["'punch:"], [lower(), rigid("punch", block(10, 3, 30, 8))],
        contact("lap", "lower:top", "punch:bottom"))

# bodies that nothing holds
checked("a free motion", 1, ["Bodies->upper", "nothing resists"],
        [lower(), upper(5, 10, 30, fix="Rotation")], LAP)
checked("a body under one that is held", 1, ["Bodies->lower", "nothing resists"],
        [lower(conditions=NONE), upper(5, 10, 30, fix="X, Rotation")],
        contact("lap", "upper:bottom", "lower:top", friction("0.3")))
checked("a body beside the others", 1, ["Bodies->third", "nothing resists"],
        [lower(), upper(5, 10, 30), body("third", block(70, 0, 80, 5), 1.0)], LAP)
checked("a punch that is free", 1, ["Bodies->punch", "nothing resists"],
        [lower(), rigid("punch", block(10, 5, 30, 8),
                        listed("Motion", Force_X=0, Displacement_Y=-0.01))],
        contact("lap", "lower:top", "punch:bottom"))
checked("friction that holds it", 0, ["valid"], [lower(), upper(5, 10, 30, fix="Rotation")],
        contact("lap", "upper:bottom", "lower:top", friction("0.3")))
PULL = condition("top", "Neumann", Traction_Y="0.01")
checked("a load that lifts", 1, ["drives Bodies->upper in the direction (0, 1)"],
        [lower(), upper(5, 10, 30, conditions=PULL)], LAP)
checked("that lifts later", 1, ["at t = 2.5", "drives Bodies->upper in the direction (0, 1)"],
        [lower(), upper(5, 10, 30, conditions=condition("top", "Neumann", Traction_Y="0.01*(t-2.4)"))],
        LAP, HISTORY)
checked("a body alone", 1, ["drives Bodies->lower in the direction (0, -1)"], [lower(conditions=PRESS)])
checked("more unknowns than allowed, before anything is evaluated", 1,
        ["level 0", "Maximum Degrees of Freedom = 10"], [lower(conditions=PRESS)], NONE, listed("Adaptivity", Maximum_Degrees_of_Freedom=10))
NARROW = "0.01*exp(-((x-7.3)/0.004)^2)"
checked("a load that its elements do not see", 1,
        ["drives Bodies->lower",
         "warning: Bodies->lower->Boundary Conditions->bottom: the traction is narrower"],
        [lower(conditions=PRESS + condition("bottom", "Neumann", Traction_Y=NARROW))])
checked("one whose loads balance", 0, ["valid"], [lower(conditions=PRESS + condition(
    "bottom", "Neumann", Traction_Y="0.01"))])

# expressions at points of contact
for what, text in (("negative friction", "0.3*(x-12)"), ("no number", "0/0*x"),
                   ("a root", "sqrt(x-12)"), ("later negative", "2.4-t"),
                   ("a root later", "sqrt(2.4-t)"), ("nothing at 0", "0.1/t")):
    checked(what, 1, ["Contacts->lap->Friction->Coefficient"], [lower(), upper(5, 10, 30)],
            contact("lap", "upper:bottom", "lower:top", friction(text)), HISTORY if "t" in text.replace(
                "sqrt", "") else NONE)
for what, text in (("no number", "log(-x)"), ("a root", "sqrt(x-12)"), ("a root later", "sqrt(2.4-t)")):
    checked(what, 1, ["Contacts->lap->Interference"], [lower(), upper(5, 10, 30)],
            contact("lap", "upper:bottom", "lower:top", Interference=text), HISTORY)
    checked(what, 1, ["Bodies->lower->Boundary Conditions->bottom->Gap"],
            [lower(conditions=PRESS + condition("bottom", "Contact", Gap=text))], NONE, HISTORY)
finish()
