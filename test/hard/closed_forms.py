"""Contact with known solutions: patch test, shear block, Hertz, flat punch; where definiteness is
lost."""
import math
import re

from runs import claim, finish, run

BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")
MULTIPLIER = "Discretization->Multiplier="
FORM = "Discretization->Stabilization->Form="
BLOCK = "Bodies->block->"


def discretizations():
    """Every basis, form and some degrees, meshes and gamma0, and what rounding makes of it:
    without much stabilisation the multiplier's oscillations cost digits, about 1/gamma."""
    for basis in BASES:
        for form in ("Projected", "Exact"):
            for degree, mesh, gamma, rounding in (
                    (1, "{5, 2, 3, 1}", "0.1", 1e-11), (2, "{7, 1, 2, 3}", "0.01", 1e-10),
                    (5, "{2, 1, 3, 1}", "1e-6", 1e-6)):
                yield [MULTIPLIER + basis, FORM + form, "Discretization->Degree=%d" % degree,
                       "Discretization->Elements per Edge=" + mesh,
                       "Discretization->Stabilization->Gamma0=" + gamma], rounding


def largest(points, column, wanted):
    return max(abs(point[column] - wanted) for point in points)


def uniform(sentence, scene, settings, pressure, shear, chosen):
    """lambda is constant to rounding, whatever the discretisation."""
    worst = count = 0
    for choice, rounding in list(discretizations())[chosen]:
        contact = run(scene, choice + settings).contact
        worst = max(worst, max(largest(contact, "lambda_n", pressure),
                               largest(contact, "lambda_t", shear)) / rounding)
        count += 1
    claim(worst < 1, "%s: exact in %d discretisations (%.1e of what rounding allows)" % (
        sentence, count, worst))


uniform("patch test", "patch", [], 1, 0, slice(None))
uniform("shear block, all sticks", "shear_block", [], 1, 0.3, slice(0, None, 2))  # by turns
SLIP = [BLOCK + "Boundary Conditions->base->Friction->Coefficient=0.3",
        BLOCK + "Boundary Conditions->top->Displacement X=0.3*2.6/100 + 0.002"]
uniform("shear block, all slips", "shear_block", SLIP, 1, 0.3, slice(1, None, 2))
sliding = run("shear_block", SLIP).contact
claim(largest(sliding, "u_t", 0.002) < 1e-12, "it slips by what the top moves too far")
claim({point["friction"] for point in sliding} == {2}, "and is said to slip")
sticking = run("shear_block").contact
claim(largest(sticking, "u_t", 0) < 1e-12 and {point["friction"] for point in sticking} == {1},
      "it sticks where the bound is above the shear")

# Hertz: a = 1, p0 = E* / (2 R)
P0 = 1000 / (1 - 0.3**2) / 200
LEVEL = ["Adaptivity->Maximum Levels=2", "Output->Fields=false"]


def hertz(size, elements):
    """A block `size` wide and high: errors of a, p0, the pressure and the shear stress."""
    half = size / 2
    vertices = "8x2:{%g,0, -4,0, -2,0, 2,0, 4,0, %g,0, %g,%g, %g,%g}" % (
        -half, half, half, size, -half, size)
    result = run("hertz", LEVEL + [
        BLOCK + "Geometry->Vertices=" + vertices,
        BLOCK + "Boundary Conditions->top->Traction Y=-pi/4*1000/(1 - 0.3^2)/100/%g" % size,
        "Discretization->Elements per Edge=" + elements])
    # sqrt(1 - x^2) fitted in the inner half, away from where contact ends
    inner = [point for point in result.contact if abs(point["x"]) < 0.7]
    weights = [math.sqrt(1 - point["x"]**2) for point in inner]
    p0 = sum(w * point["lambda_n"] for w, point in zip(weights, inner)) / sum(
        w * w for w in weights)
    load = math.pi / 4 * 1000 / (1 - 0.3**2) / 100
    a = 2 * load / (math.pi * p0)  # p0 a = 2 P / pi
    ends = max(abs(point["x"]) for point in result.contact if point["contact"] == 1)
    shape = max(abs(point["lambda_n"] / p0 - w) for w, point in zip(weights, inner))
    stress = result.interior[0]
    shear = math.hypot((stress["sxx"] - stress["syy"]) / 2, stress["sxy"]) / P0
    return abs(p0 / P0 - 1), abs(a - 1), abs(ends - 1), shape, shear / 0.30028 - 1


small = hertz(20, "{6, 8, 32, 8, 6, 10, 10, 10}")
large = hertz(40, "{9, 8, 32, 8, 9, 10, 10, 10}")
claim(small[0] < 0.01 and small[1] < 0.01, "Hertz: p0 and a within 1 %% (%.2f %%, %.2f %%)" % (
    100 * small[0], 100 * small[1]))
claim(small[2] < 0.07, "contact ends at a, up to an element (%.3f)" % small[2])
claim(small[3] < 0.02, "the pressure is an ellipse (%.1e)" % small[3])
claim(large[0] < 0.5 * small[0],
      "the error of p0 falls with the block's size (%.1e to %.1e)" % (small[0], large[0]))
# The mean stress P / size of the block adds to Hertz' field.
claim(0.4 < large[4] / small[4] < 0.6 and abs(2 * large[4] - small[4]) < 0.003,
      "the shear stress at depth 0.7862 a tends to 0.30028 p0 like 1 / size (%.2f %%, %.2f %%, "
      "extrapolated %.2f %%)" % tuple(100 * e for e in (small[4], large[4],
                                                        2 * large[4] - small[4])))


# Hertz on a disc of arcs, R = 1: what differs from the half-plane falls like a
def disc(a):
    result = run("disc", [
        "Adaptivity->Maximum Levels=14", "Output->Fields=false",
        "Discretization->Elements per Edge={%d, 4, 4, 6, 4, 6, 4, 4}" % round(0.48 / a),
        "Bodies->disc->Boundary Conditions->load->Traction Y=-%g^2*1000/(1 - 0.3^2)/4*3" % a])
    inner = [point for point in result.contact if abs(point["x"]) < 0.6 * a]
    p0 = 1000 / (1 - 0.3**2) * a / 2
    ratios = [point["lambda_n"] / (p0 * math.sqrt(1 - (point["x"] / a)**2)) for point in inner]
    return sum(ratios) / len(ratios) - 1, result.history[-1]


wide, state = disc(0.02)
narrow, _ = disc(0.01)
claim(abs(wide) < 3e-3, "Hertz: the pressure under a disc of arcs (%.2f %%)" % (100 * wide))
claim(0.3 < narrow / wide < 0.7 and abs(2 * narrow - wide) < 5e-4,
      "what it differs by falls like a/R (%.2f %%, %.2f %%)" % (100 * wide, 100 * narrow))
imbalance = max(abs(sum(float(state[part + "_" + x]) for part in ("load", "contact", "reaction")))
                for x in ("x", "y", "moment"))
claim(imbalance < 1e-12, "forces and moments on the disc balance (%.0e)" % imbalance)


# Flat punch: lambda_n = P / (pi sqrt(1 - x^2)), P = 1
def punch(settings):
    contact = run("punch", settings + ["Output->Fields=false"]).contact
    # The best straight line through s^(-1/2) on an edge's element vanishes at its inner end.
    at_edge = [1 - abs(point["x"]) for point in contact
               if point["element"] == contact[0]["element"]]
    inside = 1 - min(at_edge) - max(at_edge)
    claim({point["contact"] for point in contact if abs(point["x"]) < inside} == {1}
          and sum(point["contact"] == 0 for point in contact) <= 2,
          "all of the punch is in contact")
    means = {}  # over elements
    for point in contact:
        means.setdefault(point["element"], []).append(point)
    error = 0
    for points in means.values():
        if max(abs(point["x"]) for point in points) < 0.8:
            exact = sum(1 / (math.pi * math.sqrt(1 - point["x"]**2)) for point in points)
            error = max(error, abs(sum(point["lambda_n"] for point in points) / exact - 1))
    return error


errors = [punch(["Adaptivity->Maximum Levels=%d" % level]) for level in (1, 2, 3)]
for level in (1, 2, 3):  # projected, the pressure stays above zero at the edges, too
    contact = run("punch", ["Adaptivity->Maximum Levels=%d" % level, FORM + "Projected",
                            "Output->Fields=false"]).contact
    claim({point["contact"] for point in contact} == {1}, "all of it, projected")
claim(errors[2] < 0.01, "flat punch: the pressure's means within 1 %% in |x| < 0.8 "
      "(%.2f %%, %.2f %%, %.2f %%)" % tuple(100 * e for e in errors))

# [P] section 8.3: 256 elements, and what the program says
ONCE = ["Adaptivity->Strategy=None", "Output->Fields=false",
        "Discretization->Elements per Edge={64, 64, 64, 64}"]


def solve(form, gamma, code):
    return run("coulomb", [*ONCE, FORM + form, "Discretization->Stabilization->Gamma0=%r" % gamma],
               code)


for form in ("Projected", "Exact"):
    text = solve(form, 0.152, 2).text
    said = float(re.search(r"below (\S+) it is definite", text).group(1))
    claim(0.11 < said < 0.16, "%s: definiteness is lost at gamma0 = %g" % (form, said))
    solve(form, said * 0.999, 0)
    solve(form, said * 1.001, 2)
    claim(True, "%s: a thousandth below it is solved, above refused" % form)
finish()
