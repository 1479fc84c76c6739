"""Load paths: friction remembers.  Cattaneo's and Mindlin's closed forms on a block that stands
for a half-plane (incompressible, so that pressure and shear do not mix), a = 1.

   loading to Q     q = f p0 [s(x) - c s(x/c)],  s(x) = (1 - x^2)^1/2,  c = (1 - Q/(f P))^1/2
   unloading to Q   q = q(Qm) - 2 f p0 [s(x) - c' s(x/c')],  c' = (1 - (Qm - Q)/(2 f P))^1/2
   a closed loop    work (f P)^2/(pi E*) (4 q h - 8 H), q = Qm/(f P), see loop()
"""
import math
import os

from halves import F, P, P0, after, error, loading, loop, stick
from runs import WORK, claim, epafi, finish, fresh, scene, table

SCENE = scene("fretting.xml")
BODY = "Bodies->block->Boundary Conditions->"


def solve(name, settings=(), expect=0, file=SCENE):
    folder = fresh(name)
    arguments = ["run", file, "--output", folder]
    for setting in settings:
        arguments += ["--set", setting]
    code, text = epafi(*arguments)
    claim(code == expect, "%s: exit code %d%s" % (
        name, code, "" if code == expect else " " + text[-300:]))
    return folder


def steps(folder):
    return table(os.path.join(folder, "steps.csv"))


def contact(folder, step=None):
    inside = ["contact.csv"] if step is None else ["steps", str(step), "contact.csv"]
    return table(os.path.join(folder, *inside))


def loads(push, press):
    """Settings for a push and a pressing force, expressions in t."""
    return [BODY + "far->Traction %s=2/pi*((%s)*x - (%s)*y)*(x*nx + y*ny)*%s/(x^2 + y^2)^2" % (
        component, push, press, along) for component, along in (("X", "x"), ("Y", "y"))]


def path(times, counts):
    return ["History->Times={%s}" % ", ".join(map(repr, times)),
            "History->Steps={%s}" % ", ".join(map(str, counts))]


os.makedirs(WORK, exist_ok=True)

# Cattaneo, and the way back to 0 and to -Qm; small elements where slip ends, a node at |x| = a
CUTS = [-40, -16, -6, -2.5, -1.25, -0.95, -0.6, 0.6, 0.95, 1.25, 2.5, 6, 16, 40]
base = solve("cattaneo", path([1, 2, 3, 4], [1]) + [
    "Bodies->block->Geometry->Vertices=16x2:{%s, 40, 80, -40, 80}" % ", ".join(
        "%g, 0" % x for x in CUTS),
    "Bodies->block->Geometry->Edges={%s, far, far, far}" % ", ".join(
        ["free"] * 4 + ["contact"] * 5 + ["free"] * 4),
    "Discretization->Elements per Edge={4, 4, 4, 6, 30, 88, 30, 88, 30, 6, 4, 4, 4, 6, 6, 6}"])
rows = steps(base)
claim([(row["step"], row["t"]) for row in rows] == [(k, k) for k in (1, 2, 3, 4)],
      "a row per step")
sides = [(2, "Q = Qm", lambda x: loading(x, 0.5), math.sqrt(0.5)),
         (3, "Q = 0 after unloading", lambda x: after(x, 0.5, 0), math.sqrt(0.75)),
         (4, "Q = -Qm", lambda x: after(x, 0.5, -0.5), math.sqrt(0.5))]
for step, what, exact, c in sides:
    points = contact(base, step)
    left, right = stick(points)
    width = (right - left) / 2
    claim(abs(width - c) < 1e-2, "%s: stick to %.4f of a, exact %.4f" % (what, width, c))
    worst = error(points, exact)
    claim(worst < 0.02, "%s: shear within %.2e of f p0" % (what, worst))
claim(max(abs(p["lambda_t"]) for p in contact(base, 3)) > 0.1 * F * P0,
      "the shear at Q = 0 after unloading is not zero")
claim(contact(base) == contact(base, 4), "contact.csv is that of the last step")

# work per cycle, counted from +Qm
for q in (0.3, 0.5):
    folder = solve("loop %g" % q, path([1, 2, 6, 10], [1, 10, 40, 40]) + loads(
        "%r*0.5*pi/400*(t < 1 ? 0 : 2/pi*asin(sin(pi/2*(t - 1))))" % q, "pi/400*min(t, 1)"))
    done = {row["step"]: row["energy_dissipated"] for row in steps(folder)}
    first, second = done[51] - done[11], done[91] - done[51]
    claim(abs(first / loop(q) - 1) < 0.01,
          "loop of q = %g: work per cycle %.6e, exact %.6e" % (q, first, loop(q)))
    claim(abs(second / first - 1) < 1e-6,
          "loop of q = %g: the second cycle differs by %.1e" % (q, second / first - 1))

# a path that no point reverses ends where one step does; P and Q together do not
ROW = ["History->Times={1, 2}"]
few = solve("one step", ROW + ["History->Steps={1, 1}"])
many = solve("fifty steps", ROW + ["History->Steps={1, 50}"])
difference = max(abs(a["lambda_t"] - b["lambda_t"]) + abs(a["lambda_n"] - b["lambda_n"])
                 for a, b in zip(contact(few), contact(many))) / (F * P0)
claim(difference < 1e-8, "P, then growing Q: 1 and 50 steps differ by %.1e" % difference)
TOGETHER = loads("0.25*pi/400*t/2", "pi/400*t/2") + ["History->Times={2}"]
one = solve("together, one step", TOGETHER + ["History->Steps={1}"])
along = solve("together, forty steps", TOGETHER + ["History->Steps={40}"])
apart = max(abs(a["lambda_t"] - b["lambda_t"])
            for a, b in zip(contact(along), contact(few))) / (F * P0)
claim(apart > 0.05, "P and Q together is another path: it differs by %.3f f p0" % apart)

# energies
for folder in (base, many, along):
    end = steps(folder)[-1]["level"]
    work = [row["energy_dissipated"] for row in steps(folder) if row["level"] == end]
    claim(all(b >= a >= 0 for a, b in zip([0] + work, work)), "friction's work never falls")


def half_cycle(count):
    """Error of the trapezoidal work from Qm to -Qm."""
    folder = solve("balance %d" % count, path([1, 2, 4], [1, 5, count]))
    done = [row["energy_dissipated_trapezoidal"] for row in steps(folder)]
    return abs((done[5 + count] - done[5]) / (loop(0.5) / 2) - 1)


def pressing(count):
    folder = solve("pressing %d" % count, path([1], [count]))
    last = steps(folder)[-1]
    return abs(last["energy_error"]) / last["energy_outside"]


errors = [pressing(count) for count in (4, 16)]
claim(errors[1] < errors[0] / 10,
      "the balance of energy is of second order: %.1e, %.1e of the work" % tuple(errors))
trapezoidal = [half_cycle(count) for count in (5, 20)]
claim(trapezoidal[1] < trapezoidal[0] / 4 or trapezoidal[1] < 2e-3,
      "the trapezoidal work converges: %.1e, %.1e" % tuple(trapezoidal))
finish()
