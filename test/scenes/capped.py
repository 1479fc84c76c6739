"""A block that slides at the cap of Coulomb's law, and below it: closed forms.

Uniform stress sigma_yy = -p, sigma_xy = s, sigma_xx = 0 in plane strain, u linear and larger
than zero along the base: lambda_n = p and lambda_t = s = min(F p, C), for every basis.
"""
from runs import claim, fails, finish, fresh, run
from written import Keys, block, body, condition, listed, written

YOUNG, NU, P = 100.0, 0.3, 1.0


def conditions(along, shear, coefficient, **cap):
    law = "Capped Coulomb" if cap else "Coulomb"
    return (condition("bottom", "Contact",
                      listed("Friction", Law=law, Coefficient=coefficient, **cap)) +
            condition("top", "Dirichlet", Displacement_X=along,
                      Displacement_Y=-P * (1 - NU ** 2) / YOUNG) +
            condition("right", "Neumann", Traction_Y=shear) +
            condition("left", "Neumann", Traction_Y=-shear))


CASES = {  # coefficient, cap, shear
    "cap": ("0.5", "0.2", 0.2),
    "cap_varying": ("0.5 + 0.1*x", "0.2", 0.2),
    "below": ("0.15", "0.2", 0.15),
    "below_varying": ("0.15", "0.3 + 0.05*x", 0.15),
}
for name, (coefficient, cap, shear) in CASES.items():
    for basis in ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal"):
        for degree in (1, 3):
            case = "%s.%s.%d" % (name, basis, degree)
            stretch = P * NU * (1 + NU) / YOUNG
            along = "%r*x + %r" % (stretch, shear * 2 * (1 + NU) / YOUNG + 0.05)
            file = written(case, [body(
                "block", block(-1, 0, 1, 1), YOUNG, conditions(along, shear, coefficient, Cap=cap),
                mesh=listed("Mesh", Elements_per_Edge=[4, 2, 3, 2], Degree=degree))], Multiplier=basis)
            _, contact = run(file, case)
            claim(max(abs(c["lambda_n"] - P) for c in contact) < 1e-9, case + ": pressure")
            claim(max(abs(c["lambda_t"] - shear) for c in contact) < 1e-9, case + ": shear")
            claim(max(abs(c["bound"] - shear) for c in contact) < 1e-9, case + ": bound")
            claim(all(c["friction"] == 2 for c in contact), case + ": slides")
# a coefficient that falls with the pressure: F p = 0.3 p/(1 + p) is 0.15 at p = 1
for name, coefficient in (("everywhere", "0.3/(1 + pressure)"),
                          ("varying", "(0.3 + 0.1*x)/(1 + pressure + 2*x/3)")):
    for basis in ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein", "Biorthogonal"):
        for iteration in ("Newton", "Fixed Point"):
            case = "pressure.%s.%s.%s" % (name, basis, iteration.replace(" ", ""))
            stretch = P * NU * (1 + NU) / YOUNG
            along = "%r*x + %r" % (stretch, 0.15 * 2 * (1 + NU) / YOUNG + 0.05)
            file = written(case, [body(
                "block", block(-1, 0, 1, 1), YOUNG, conditions(along, 0.15, coefficient),
                mesh=listed("Mesh", Elements_per_Edge=[4, 2, 3, 2], Degree=2))], Multiplier=basis)
            _, contact = run(file, case, ["Solver->Coulomb Iteration=" + iteration])
            for column, exact in (("lambda_n", P), ("lambda_t", 0.15), ("bound", 0.15)):
                claim(max(abs(c[column] - exact) for c in contact) < 1e-9, "%s: %s" % (case, column))
# 0.1 on a length of 2 holds 0.2, whatever presses
for law in ({"Law": "Capped Coulomb", "Coefficient": 0.5, "Cap": 0.1},
            {"Law": "Tresca", "Threshold": 0.1}):
    for force, words in ((0.1, ""), (0.3, "in the direction (1, 0), ")):
        pushed = written("pushed", [body("block", block(-1, 0, 1, 1), YOUNG, condition(
            "bottom", "Contact", listed("Friction", Keys(law))) + condition(
                "top", "Neumann", Force_X=force, Force_Y=-1))], form="Density")
        for command, code in (("check", 1), ("run", 2)):
            fails("a force of %g on %s" % (force, law["Law"]), [words] + [
                "Bodies->block", "of a force of 0.3 they hold at most 0.2"] * bool(words), command,
                  pushed, *(["--output", fresh("pushed")] if command == "run" else []),
                  code=code if words else 0)
# what a coefficient may be
for coefficient, words in (
        ("0.3*exp(-pressure/10)", ["Friction->Coefficient", "pressure times Coefficient", "min(pressure"]),
        ("0.3 - pressure/10", ["Friction->Coefficient is -", "pressure = ", ">= 0"])):
    falling = written("falling", [body("block", block(-1, 0, 1, 1), YOUNG, conditions(
        "0.01", 0.15, coefficient))])
    for command in ("check", "run"):
        fails("%s of a Coefficient %s" % (command, coefficient), words, command, falling,
              *(["--output", fresh("falling")] if command == "run" else []))
fails("the pressure is known to coefficients alone", ["of Law Coulomb alone"], "check", written(
    "unknown", [body("block", block(-1, 0, 1, 1), YOUNG, conditions("pressure", 0, "0.3"))]))
finish()
