"""Stabilisation by the densities of both bodies in contact (doc/theory/contact.md)."""
import math

from runs import claim, differ, finish, run
from written import (TIED, block, body, condition, contact, friction, geometry, keys, listed, mesh,
                     written)

# A crack in a plate that shears: closed under the pressure Q, slipping, and bonded ahead of its
# tips.  Of the faces' shear what exceeds friction, S, is carried round them:
#   s_xx - i s_xy etc. by  S z/(z^2 - 1)^1/2,  K_II = S pi^1/2;  the pressure is Q throughout.
Q, F, K = 2.5, 0.3, 6.34560992142
S = K / math.sqrt(math.pi)
PLACES = {"a": "(atan2(y,x-1)+atan2(y,x+1))/2", "r": "sqrt(sqrt((x-1)^2+y^2)*sqrt((x+1)^2+y^2))"}
RE = "((x*cos({a})+y*sin({a}))/{r})".format(**PLACES)
IM = "((y*cos({a})-x*sin({a}))/{r})".format(**PLACES)
# of the derivative  -1/(z^2 - 1)^3/2
RE_SLOPE = "(-cos(3*{a})/({r})^3)".format(**PLACES)
IM_SLOPE = "(sin(3*{a})/({r})^3)".format(**PLACES)
XX = "(-7.5+%.16g*(2*%s+y*%s))" % (S, IM, RE_SLOPE)
YY = "(-%.16g-%.16g*y*%s)" % (Q, S, RE_SLOPE)
XY = "(%.16g+%.16g*(%s-y*%s))" % (F * Q, S, RE, IM_SLOPE)


def loaded(sign):
    """Tractions of the exact stresses on the outer edges."""
    return (condition("right", "Neumann", Traction_X=XX, Traction_Y=XY) +
            condition("left", "Neumann", Traction_X="-" + XX, Traction_Y="-" + XY) +
            condition("far", "Neumann", Traction_X="%d*%s" % (sign, XY),
                      Traction_Y="%d*%s" % (sign, YY)))


def crack(name, first="upper", elements=(3, 6, 3, 3, 6, 3), degrees=(2, 2), tolerance=1e-3,
          method="Dense"):
    upper, lower = elements[:3], elements[3:]
    second = "lower" if first == "upper" else "upper"
    return run(written(name, [
        body("upper", geometry([(-3, 0), (-1, 0), (1, 0), (3, 0), (3, 3), (-3, 3)],
                               "bond, crack, bond, right, far, left"), 1000, loaded(1),
             mesh=listed("Mesh", Elements_per_Edge=[*upper, 4, 6, 4], Degree=degrees[0])),
        body("lower", geometry([(-3, 0), (-3, -3), (3, -3), (3, 0), (1, 0), (-1, 0)],
                               "left, far, right, bond, crack, bond"), 1000, loaded(-1),
             "X, Y, Rotation",
             listed("Mesh", Elements_per_Edge=[4, 6, 4, *lower], Degree=degrees[1]))],
        contact("bond", first + ":bond", second + ":bond", TIED) +
        contact("crack", first + ":crack", second + ":crack", friction(F)), "Density",
        more=listed("Adaptivity", keys(Strategy="Graded hp", Maximum_Levels=60,
                                       Maximum_Degrees_of_Freedom=3000, Tolerance=tolerance)) +
        listed("Solver", listed("Linear", Method=method))), name)


WORK = .0153525655122
for name, bound, ways in (("matched", 1e-5, {}), ("lower-first", 1e-5, {"first": "lower"}),
                          ("compressed", 1e-3, {"method": "Compressed"}),
                          ("nodes", 0.1, {"elements": (3, 6, 3, 4, 5, 2)}),
                          ("degrees", 0.1, {"degrees": (2, 3)})):
    levels, points = crack(name, **ways)
    faces = [p for p in points if p["contact_name"] == "crack"]
    error = max(abs(p["lambda_n"] - Q) for p in faces)
    claim(error < bound and all(p["contact"] == 1 for p in faces),
          "closed crack, %s: the pressure is even within %.1e, nothing opens" % (name, error))
    claim(differ(levels[-1]["energy_friction"], WORK) < 5e-6, "friction's work, %.1e" % differ(
        levels[-1]["energy_friction"], WORK))
    claim(levels[-1]["dof"] < 1100, "with %d unknowns" % levels[-1]["dof"])

# nodes of both sides become the same to rounding, and stay so: pairs that lose each other would gain
# degrees one by one, and contact would open from 1e-3 of the tip on
levels, points = crack("tight", elements=(3, 6, 3, 4, 5, 2), tolerance=2e-5)
faces = [p for p in points if p["contact_name"] == "crack"]
error = max(abs(p["lambda_n"] - Q) for p in faces if abs(p["x"]) < 1 - 1e-8)
claim(error < 1e-3 and all(p["contact"] == 1 for p in faces),
      "closed crack, other nodes, tight: the pressure is even within %.1e from 1e-8 of the tips on" % error)

# what acts on the body that the side sees is in the residual: without it the strength of the
# stabilisation would matter
for name, held, inside in (
        ("weight", condition("bottom", "Dirichlet", Displacement_X=0, Displacement_Y=0),
         listed("Body Loads", Force_X=0.006, Force_Y=-0.02)),
        ("fix", condition("bottom", "Neumann", Traction_Y="0.02*(1+x)"), keys())):
    energies = []
    for gamma in (0.5, 50):
        more = listed("Adaptivity", Strategy="Uniform h", Maximum_Levels=2)
        levels, _ = run(written(name, [
            body("pad", block(-1, 0, 1, 1), 1.0, condition("top", "Neumann", Traction_Y="-0.02"),
                 "X, Rotation", mesh(6, 3, 3), inside=inside),
            body("plate", block(-1, -1, 1, 0), 3.0, held, "X, Y, Rotation" if name == "fix" else "",
                 mesh(6, 3, 3), inside=inside)],
            contact("c", "pad:bottom", "plate:top"), more=more, form="Density",
            Stabilization={"Form": "Density", "Gamma0": gamma}), name)
        energies.append(levels[-1]["energy_strain"])
    claim(differ(*energies) < 1e-5, "%s: energies with Gamma0 0.5 and 50 differ by %.1e" % (
        name, differ(*energies)))
finish()
