"""Half-planes pressed together and pushed: blocks whose outer sides carry the tractions of
Boussinesq's and Flamant's forces; Cattaneo's and Mindlin's closed forms.  a = E* = 1, R = 100."""
import math

from runs import claim, largest, points, scene, solved, steps
from written import NONE, body, condition, geometry, listed

P, P0, F = math.pi / 400, 0.005, 0.5
PRESS = "pi/400*min(t, 1)"
TO_AND_FRO = "%r*0.5*pi/400*(t < 1 ? 0 : 2/pi*asin(sin(pi/2*(t - 1))))"  # of f P
# edges of the contact's side, coarse, and with small elements where contact and slip end
COARSE = ([-40, -16, -6, -2.5, -1.25, 1.25, 2.5, 6, 16, 40], [4, 4, 4, 6, 24, 6, 4, 4, 4])
FINE = ([-40, -16, -6, -2.5, -1.25, -0.95, -0.6, 0.6, 0.95, 1.25, 2.5, 6, 16, 40],
        [4, 4, 4, 6, 30, 88, 30, 88, 30, 6, 4, 4, 4])


def path(times, counts):
    """The same as settings."""
    return ["History->Times={%s}" % ", ".join(map(repr, times)),
            "History->Steps={%s}" % ", ".join(map(str, counts))]


def contact_side(cuts, counts):
    """Settings of fretting.xml for edges and elements on the contact's side."""
    return ["Bodies->block->Geometry->Vertices=16x2:{%s, 40, 80, -40, 80}" % ", ".join(
                "%g, 0" % x for x in cuts),
            "Bodies->block->Geometry->Edges={%s, far, far, far}" % ", ".join(
                ["free"] * 4 + ["contact"] * 5 + ["free"] * 4),
            "Discretization->Elements per Edge={%s, 6, 6, 6}" % ", ".join(map(str, counts))]


def loads(push, press, stress="0"):
    """Settings of fretting.xml for a push, a pressing force and a bulk stress, expressions in t."""
    return ["Bodies->block->Boundary Conditions->far->Traction %s="
            "2/pi*((%s)*x - (%s)*y)*(x*nx + y*ny)*%s/(x^2 + y^2)^2 + (%s)" % (
                component, push, press, along, "(%s)*nx" % stress if component == "X" else "0")
            for component, along in (("X", "x"), ("Y", "y"))]


def half(name, up, modulus, push, press=PRESS, ratio=0.3, side=COARSE, uniform=False):
    """A block above (up = 1) or below the contact, as high as wide, and what pushes its outer
    sides: the half-plane's tractions, or uniform ones on the far side."""
    cuts, counts = side
    far = cuts[-1]
    names = ["contact" if -2 < x < 1.2 else "free" for x in cuts[:-1]]
    corners = [(x, 0) for x in cuts] + [(far, 2 * far), (-far, 2 * far)]
    sides = names + ["right", "far", "left"]
    if up < 0:  # counter-clockwise again
        corners = [(-x, 0) for x in cuts] + [(-far, -2 * far), (far, -2 * far)]
        sides = names + ["left", "far", "right"]
    load = NONE if not uniform else condition("far", "Neumann", **{
        "Traction_X": "%d*(%s)/%r" % (up, push, 2 * far),
        "Traction_Y": "%d*(%s)/%r" % (-up, press, 2 * far)})
    for edge, normal in () if uniform else (
            ("left", "-x"), ("right", "x"), ("far", "abs(y)")):
        load += condition(edge, "Neumann", **{
            "Traction_" + c: "%d*2/pi*((%s)*x - (%s)*y)*(%s)*%s/(x^2 + y^2)^2" % (
                up, push, press, normal, c.lower()) for c in "XY"})
    grid = listed("Mesh", Elements_per_Edge=counts + [6, 6, 6], Degree=2)
    return body(name, geometry(corners, sides), modulus, load,
                "X, Y, Rotation" if up < 0 else "Rotation" if uniform else "", grid, ratio)


def root(x):
    return math.sqrt(max(0, 1 - x * x))


def partial(x, c):
    return root(x) - (c * root(x / c) if c > 0 else 0)


def loading(x, q):
    """The shear under the push q, in f P, after the pressing."""
    return F * P0 * partial(x, math.sqrt(1 - q))


def after(x, qm, q):
    """The shear on the way back from qm to q (in f P)."""
    return F * P0 * (partial(x, math.sqrt(1 - qm)) - 2 * partial(x, math.sqrt(1 - (qm - q) / 2)))


# Cattaneo's loop, one step each behind the pressing: step, push, shear, half the stick width
SIDES = [(2, "Q = Qm", lambda x: loading(x, 0.5), math.sqrt(0.5)),
         (3, "Q = 0 after unloading", lambda x: after(x, 0.5, 0), math.sqrt(0.75)),
         (4, "Q = -Qm", lambda x: after(x, 0.5, -0.5), math.sqrt(0.5))]


def remembers(folder):
    """Claims that a path is that loop."""
    claim([(row["step"], row["t"]) for row in steps(folder)] == [(k, k) for k in (1, 2, 3, 4)],
          "a row per step")
    for step, what, exact, c in SIDES:
        here = points(folder, step)
        left, right = stick(here)
        width = (right - left) / 2
        claim(abs(width - c) < 1e-2, "%s: stick to %.4f a, exact %.4f" % (what, width, c))
        worst = error(here, exact)
        claim(worst < 0.02, "%s: shear within %.2e of f p0" % (what, worst))
    claim(largest(p["lambda_t"] for p in points(folder, 3)) > 0.1 * F * P0,
          "the shear at Q = 0 after unloading is not zero")


def loop(q):
    """Friction's work in a closed loop between q and -q."""
    h = (1 - q) * math.log(1 - q) + q
    big = -1 / 4 - (1 - q)**2 * math.log(1 - q) / 2 + (1 - q)**2 / 4 + q * q / 2
    return (4 * q * h - 8 * big) * (F * P)**2 / math.pi


def fretting(name, settings):
    return solved(name, scene("fretting.xml"), "Adaptivity->Maximum Degrees of Freedom=20000",
                  *settings)[0]


def cycles(q):
    """Friction's work in two cycles between q and -q, counted from +q, and the folder."""
    folder = fretting("loop %g" % q, path([1, 2, 6, 10], [1, 10, 40, 40]) +
                      loads(TO_AND_FRO % q, PRESS))
    done = {row["step"]: row["energy_dissipated"] for row in steps(folder)}
    return done[51] - done[11], done[91] - done[51], folder


def half_cycle(count):
    """The work from Qm to -Qm, and that by the trapezoidal rule."""
    rows = steps(fretting("half a cycle, %d" % count, path([1, 2, 4], [1, 5, count])))
    return [rows[5 + count][key] - rows[5][key] for key in
            ("energy_dissipated", "energy_dissipated_trapezoidal")]


def pressing(count):
    """The error of the balance of energy over the work from outside."""
    last = steps(fretting("pressing, %d" % count, path([1], [count])))[-1]
    return abs(last["energy_error"]) / last["energy_outside"]


def stick(points):
    """Both ends of where friction sticks."""
    inside = [p["x"] for p in points if p["friction"] == 1 and p["contact"] == 1]
    return min(inside), max(inside)


def rms(points, exact):
    """The same in the mean over the contact, 2 a wide."""
    square = sum(abs(a["x"] - b["x"]) / 2 * ((a["lambda_t"] - exact(a["x"]))**2 +
                                             (b["lambda_t"] - exact(b["x"]))**2)
                 for a, b in zip(points, points[1:]))
    return math.sqrt(square / 2) / (F * P0)


def error(points, exact):
    """Largest error of the shear over f p0.  The shear on the body is -lambda_t along x."""
    return max(abs(p["lambda_t"] - exact(p["x"])) for p in points) / (F * P0)
