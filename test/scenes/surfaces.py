"""Surfaces that yield: normal laws against closed forms, in all bases and forms, dense and
compressed, between bodies, on paths and after a restart."""
import math

from runs import claim, differ, finish, refused, rows, run, solved
from written import (NONE, TIED, WALLS, block, body, condition, confined, contact, disc, friction,
                     geometry, history, keys, listed, pad, written)

E, NU, DELTA = 1.0, 0.3, 0.01
MODULUS = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))


def normal(law, **values):
    return listed("Normal", Law=law, **values)


LINEAR = normal("Linear", Compliance=0.5)
ROOT = normal("Power", Length=0.05, Pressure=1, Exponent=0.5)
SQUARE = normal("Power", Length=0.5, Pressure=0.01, Exponent=2.0)
ROUGH = normal("Exponential", Length=0.002, Pressure=0.001)
EXACT = {"Linear": (LINEAR, 0.00804597701149), "Power": (ROOT, 0.00759551969723),
         "Exponential": (ROUGH, 0.00765207815748)}


def pushed_down(name, law, form="Density", basis="Gauss-Legendre-Lagrange", delta="0.01"):
    return confined(name, law, "-" + delta, form, basis)


def worst(points, exact):
    return max(differ(p["lambda_n"], exact) for p in points)


for law, (yields, exact) in EXACT.items():
    for form in ("None", "Projected", "Exact", "Density"):
        folder, _ = solved("%s %s" % (law, form), pushed_down(law + form, yields, form))
        points = rows(folder)
        off = worst(points, exact)
        closes = max(differ(p["normal_closing"], DELTA - exact / MODULUS) for p in points)
        claim(off < 1e-12 * 5 and closes < 1e-11,
              "confined block, %s, %s: pressure to %.1e, closing to %.1e" % (
                  law, form, off, closes))
# surfaces so soft that bodies hardly press: contact is what the surface lets press
for law, yields, exact in (("Linear", normal("Linear", Compliance=1e10), 1e-12),
                           ("Power", normal("Power", Length=1e4, Pressure=1, Exponent=0.5), 1e-12)):
    folder, text = solved("soft " + law, pushed_down("soft" + law, yields))
    off = worst(rows(folder), exact)
    claim(off < 1e-6 and all(p["contact"] == 1 for p in rows(folder)) and "never closes" not in text,
          "soft surface, %s: pressure to %.1e, all closed" % (law, off))
for basis in ("Gauss-Lobatto-Lagrange", "Bernstein"):
    for form in ("None", "Density", "Projected"):
        folder, _ = solved("%s %s" % (basis, form), pushed_down(basis + form, LINEAR, form, basis))
        off = worst(rows(folder), EXACT["Linear"][1])
        claim(off < 5e-12, "confined block, Linear, %s, %s: to %.1e" % (basis, form, off))
    refused("by %s: a law that is not linear; names the basis to use" % basis,
            pushed_down("refused", ROUGH, "Density", basis), "Gauss-Legendre-Lagrange")
refused("by Biorthogonal: all laws", pushed_down("dual", LINEAR, "None", "Biorthogonal"),
        "Boundary Conditions->bottom: ", "Gauss-Legendre-Lagrange")
refused("by a bond: a law that is not linear", pushed_down("bond", ROUGH + TIED),
        "Boundary Conditions->bottom: ", "Linear")
refused("a roughness of none", pushed_down("smooth", normal("Exponential", Length="x < 0.5 ? 0 : 1",
                                                            Pressure=1)),
        "Boundary Conditions->bottom->Normal->Length is 0", "> 0", command="check")
refused("a negative compliance", pushed_down("negative", normal("Linear", Compliance="-x")),
        "Normal->Compliance", ">= 0", command="check")

# an elastic bond takes tension, too
folder, _ = solved("pulled", pushed_down("pulled", LINEAR + TIED, delta="(-0.01)"))
exact = -EXACT["Linear"][1]
claim(worst(rows(folder), exact) < 1e-12 * 5 and all(
    differ(p["normal_closing"], 0.5 * exact) < 1e-11 for p in rows(folder)),
      "an elastic bond that is pulled")


# two halves with the law between them: a block of the same height
def halves(name, law, first, size=0.25, degree=2, curved="-0.01", more=NONE):
    lower = body("lower", block(0, 0, 1, 0.5), E, WALLS + condition(
        "bottom", "Dirichlet", Displacement_Y="0"))
    upper = body("upper", block(0, 0.5, 1, 1), E, WALLS + condition(
        "top", "Dirichlet", Displacement_Y=curved))
    sides = ("upper:bottom", "lower:top")
    return written(name, [lower, upper], contact(
        "layer", *(sides if first == "upper" else sides[::-1]), law), "Density", size, degree,
        more=more)


for law, (yields, exact) in EXACT.items():
    for first in ("upper", "lower"):
        folder, _ = solved("%s between, %s first" % (law, first), halves("halves", yields, first))
        claim(worst(rows(folder), exact) < 5e-12, "two halves, %s, %s first" % (law, first))

# a pressure that varies, opens and rubs: other ways to the same numbers
RUBBED = "-0.006*(1+cos(2*pi*x))"
for law, (yields, _) in EXACT.items():
    got = {}
    for way, first, method in (("upper", "upper", "Dense"), ("lower", "lower", "Dense"),
                               ("compressed", "upper", "Compressed")):
        folder, _ = solved("%s varies, %s" % (law, way), halves(
            "varies", yields + friction("0.3"), first, 1 / 16, 3, RUBBED),
            "Solver->Linear->Method=" + method)
        got[way] = rows(folder, "history.csv")[-1]
    scale = got["upper"]["energy_strain"]
    off = max(abs(got["upper"][k] - got["compressed"][k]) / scale for k in (
        "energy_strain", "energy_interface", "energy_friction"))
    claim(off < 1e-8, "%s: compressed agrees to %.1e" % (law, off))
    off = abs(got["upper"]["energy_strain"] + got["upper"]["energy_interface"] -
              got["lower"]["energy_strain"] - got["lower"]["energy_interface"]) / scale
    bound = sum((got[k]["estimate"]**2 for k in ("upper", "lower")), 0) / scale
    claim(off < max(bound, 1e-6), "%s: swapped sides agree to %.1e, estimates %.1e" % (
        law, off, bound))

# a smooth pressure that opens nowhere is of order p + 1 under each law: elements of degree p against
# degree p + 5 at the same points
def smooth(yields, size, degree):
    file = pushed_down("smooth", yields, delta="0.01*(1+0.5*cos(pi*x))")
    return [p["lambda_n"] for p in run(file, "smooth", [
        "Discretization->Mesh Size=%r" % size, "Discretization->Degree=%d" % degree])[1]]


for law, (yields, _) in EXACT.items():
    for degree in (1, 2, 3):
        off = [sum((a - b)**2 for a, b in zip(smooth(yields, size, degree),
                                              smooth(yields, size, degree + 5))) * size
               for size in (0.125, 0.0625)]
        order = math.log2(off[0] / off[1]) / 2
        claim(order > degree + 0.9, "%s, p = %d: the pressure is of order %.2f" % (
            law, degree, order))


# a path, and the same after a restart
for law, (yields, _) in EXACT.items():
    yields += friction("0.3")
    def path(name, steps):
        file = halves(name, yields, "upper", 0.125, 2, "-0.01*min(t,1)+0.002*max(0,t-1)*x",
                      history([1, 2], [steps, steps]))
        folder, _ = solved("%s, %s" % (law, name), file)
        return folder, rows(folder, "steps.csv")[-1]

    folder, coarse = path("path", 8)
    _, fine = path("fine path", 16)
    ratio = fine["energy_error"] / coarse["energy_error"]
    share = coarse["energy_interface"] / coarse["energy_outside"]
    claim(share > 0.2 and (abs(coarse["energy_error"]) < 1e-12 * coarse["energy_outside"] or
                           ratio < 0.3),
          "%s: energies balance, their error falls to %.2f with twice the steps; %.2f of the work "
          "is in the surfaces" % (law, ratio, share))


# shear: a block of unit height that shears uniformly, its sides loaded to match
MU = E / (2 * (1 + NU))


def sheared(name, law, u, q, path=NONE, form="Density", basis="Gauss-Legendre-Lagrange", more=NONE):
    sides = (condition("left", "Neumann", Traction_Y="-(%s)" % q) +
             condition("right", "Neumann", Traction_Y=q) +
             condition("top", "Dirichlet", Displacement_X=u, Displacement_Y=0))
    return written(name, [body("block", block(0, 0, 1, 1), E, sides + condition(
        "bottom", "Contact", law, more))], NONE, form, 0.5, 2, path, Multiplier=basis)


def rub(law, **values):
    return listed("Friction", Law=law, **values)


C, U = 0.7, 0.01
SHEAR = U / (1 / MU + C)
for law, values in (("Tresca", {"Threshold": 1}), ("Tied", {})):
    for basis, form in (("Gauss-Legendre-Lagrange", "Density"), ("Bernstein", "Projected"),
                        ("Gauss-Lobatto-Lagrange", "Projected")):
        folder, _ = solved("shear %s %s" % (law, basis), sheared(
            "shear", rub(law, Compliance=C, **values), U, SHEAR, NONE, form, basis))
        points = rows(folder)
        off = max(max(differ(p["lambda_t"], SHEAR), differ(p["u_t"], C * SHEAR)) for p in points)
        claim(off < 1e-11 and all(p["friction"] == 1 for p in points),
              "elastic shear, %s, %s, %s: to %.1e" % (law, basis, form, off))
        estimate = rows(folder, "history.csv")[0]
        claim(estimate["estimate"] < 1e-9 * math.sqrt(estimate["energy_strain"]) + 1e-9,
              "no error is estimated: %.1e" % estimate["estimate"])

# forth, back and forth: elastic up to the threshold, then slip
F = 0.002
TO = "0.01*(t<1 ? t : t<2 ? 2-t : 0)"
LIMITED = "max(-%r, min(%r, (%s)/(1/%r+%r)))" % (F, F, "0.01*t", MU, C)
folder, _ = solved("slip", sheared("slip", rub("Tresca", Threshold=F, Compliance=C), "0.01*t",
                                   LIMITED, history([0.1, 1], [2, 9])))
steps = rows(folder, "steps.csv")
first, last = steps[1], steps[-1]
claim(first["energy_dissipated"] == 0 and differ(
    first["energy_interface"], 0.5 * C * (0.1 * SHEAR)**2) < 1e-9,
      "below the threshold shear is stored")
claim(differ(last["energy_dissipated"], F * (U - F * (1 / MU + C))) < 1e-9 and differ(
    last["energy_interface"], 0.5 * C * F * F) < 1e-9 and
      abs(last["energy_error"]) < 1e-12 * last["energy_outside"],
      "above it the rest slips: %.6e dissipated" % last["energy_dissipated"])
# the plane moves instead, whatever its motion begins with: the same, the work comes from it
MORE = keys(Sliding="5-0.01*t")
folder, _ = solved("slid", sheared("slid", rub("Tresca", Threshold=F, Compliance=C), 0, LIMITED,
                                   history([0.1, 1], [2, 9]), more=MORE))
for a, b in zip(steps, rows(folder, "steps.csv")):
    off = max(abs(a[k] - b[k]) for k in ("energy_strain", "energy_dissipated", "energy_interface",
                                         "bottom.force_x"))
    claim(off < 1e-15 and abs(b["energy_error"]) < 1e-14,
          "Sliding of the plane at t = %g: as motion of the block to %.1e" % (b["t"], off))
folder, _ = solved("bond slid",
                   sheared("bond slid", rub("Tied", Compliance=C), 0, SHEAR, history([1], [1]),
                           more=MORE))
claim(max(differ(p["lambda_t"], SHEAR) for p in rows(folder)) < 1e-11, "a bond gets a jump along")
claim(all(differ(p["slip"], 0) < 1e-15 for p in rows(folder)), "slip begins at the first step")

# a rigid pad that is pushed, and one that stays while its surface slides by: the same numbers
PUSH = "0.004*sin(pi/2*max(0, t - 1))"
FINE = {"size": 0.5, "more": history([1, 2, 4], [2, 4, 8])}
DOWN = {"Displacement Y": "-0.02*min(t, 1)"}
pushed, _ = solved("pushed", pad(
    "pushed", {"Displacement X": PUSH, **DOWN}, friction(0.3) + ROUGH, **FINE))
slid, _ = solved("pad slid", pad(
    "padslid", DOWN, friction(0.3) + ROUGH + keys(Sliding="-" + PUSH), **FINE))
worst_of = 0
for a, b in zip(rows(pushed, "steps.csv"), rows(slid, "steps.csv")):
    worst_of = max([worst_of] + [abs(a[k] - b[k]) for k in a if k.startswith(("energy", "rub."))
                                and not k.endswith("_length")])
claim(worst_of < 1e-14, "a pad pushed, and slid by: the same steps to %.1e" % worst_of)
a, b = rows(pushed, "history.csv")[-1], rows(slid, "history.csv")[-1]
claim(differ(a["estimate"], b["estimate"]) < 1e-7 and a["energy_friction"] > 1e-6,
      "and estimates: %g, %g" % (a["estimate"], b["estimate"]))
off = max(max(abs(a[k] - b[k]) for k in ("slip", "slip_amplitude", "work"))
          for a, b in zip(rows(pushed), rows(slid)))
claim(off < 1e-9, "slip counts what slides by: %.1e" % off)

# a force that comes back to zero but for rounding: displacements are rounding, too
_, text = solved("unloaded", pad("unloaded", keys(Force_Y="-0.05*sin(pi*t)^2"), normal(
    "Linear", Compliance=10), keys(Interference="-x^2/8"), more=history([1], [4])))
claim("contact is met" not in text, "an unloaded step loses no digits")

# gross sliding, either side first: the number is the same, t turns with the side
got = {}
for first in ("upper", "lower"):
    folder, _ = solved("gross, %s first" % first, halves(
        "gross", friction("0.3") + keys(Sliding="0.05*t"), first, 0.25, 2,
        "-0.01*min(1, 4*t)", history([1], [8])))
    got[first] = rows(folder, "steps.csv")[-1]
    slips = differ(got[first]["layer.force_tangential"],
                   -0.3 * got[first]["layer.force_normal"])
    claim(slips < 1e-10 and got[first]["energy_dissipated"] > 0.3 * 0.0095 * 0.03,
          "gross sliding, %s first: shear at its bound, against the motion" % first)
off = differ(got["upper"]["energy_dissipated"], got["lower"]["energy_dissipated"])
claim(off < 1e-3, "either side first: dissipated alike to %.1e" % off)
refused("elastic shear without friction", sheared("none", rub("None", Compliance=C), U, 0),
        "Compliance", command="check")

# a disc in a groove, held by friction alone: tangents where Newton's steps end go round with them
bank = 3 - math.sqrt(2)  # a right angle about the disc
GROOVE = geometry([(-2, -2), (2, -2), (2, bank), (0, bank - 2), (-2, bank)], "bottom, right, top, top, left")
for aside in (0.07, 0.1, 0.12):
    solved("a disc in a groove, pulled by %g" % aside, written("groove", [
        body("disc", disc(1, "rim", 0, 1), 1000,
             inside=listed("Body Loads", Force_X=aside, Force_Y=-1)),
        body("block", GROOVE, 1000, condition("bottom", "Dirichlet", Displacement_X=0, Displacement_Y=0))],
        contact("pair", "disc:rim", "block:top", friction(0.3), normal(
            "Power", Length=0.01, Pressure=1, Exponent=3)), "Projected", 0.3))

# laws of infinite slope at zero: on the way residuals grow by any factor, and end small
for exponent, pressure, gap in ((0.15, 1e-4, 0.05), (0.15, 1e-6, 0.05), (0.15, 1e-6, 0.3), (0.3, 1e-6, 0.05)):
    name = "steep %g, %g, %g" % (exponent, pressure, gap)
    folder, _ = solved(name, written("steep", [
        body("block", [(-1, 0), (1, 0), (1, 2), (-1, 2)], 1,
             condition("top", "Neumann", Traction_Y=-3e-4) +
             condition("bottom", "Contact", normal(
                 "Power", Length=0.4, Pressure=pressure, Exponent=exponent), Gap="%g*x^2" % gap),
             fix="X, Rotation")], NONE, "Density", 0.5, 6))
    off = differ(rows(folder, "history.csv")[0]["force_normal"], 6e-4)
    claim(off < 1e-10, "%s: presses as much as it is pressed, to %.1e" % (name, off))

# pressures of smaller exponents underflow
FLAT = normal("Power", Length=1, Pressure=0.01, Exponent=0.09)
refused("an exponent of 0.09", confined("flat", FLAT, -0.1), "Exponent", "0.09", "0.1")
finish()
