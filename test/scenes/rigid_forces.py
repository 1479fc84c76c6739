"""Rigid bodies under forces: a flat punch that tilts and lifts off (tilting-punch.xml), motions
and forces against each other, balance, and what is refused."""
import math
import os

from runs import (balanced, changed, claim, epafi, fails, finish, fresh, keys_of, never_falls,
                  points, read, refused, rows, saved, scene, solved, steps)
from written import friction, history, pad

SCENE = scene("tilting-punch.xml")
MOTION = "Bodies->punch->Motion->"
P = 0.001


def solve(name, file=SCENE, settings=()):
    return solved(name, file, *settings)[0]


def pressure(x, e):
    """Of the force P at e on the half-width 1."""
    if e <= 0.5:
        return P / (math.pi * math.sqrt(1 - x * x)) * (1 + 2 * e * x)
    c = 2 * (1 - e)
    s = x - (1 - c)
    return P / (math.pi * c) * math.sqrt((c + s) / (c - s)) if s > -c else 0


def tilt(e):
    return -4 * P * e / math.pi if e <= 0.5 else -2 * P / (math.pi * 2 * (1 - e))


folder = solve("tilting")
for step, e in ((1, 0), (2, 0.2), (3, 0.4), (5, 0.6), (6, 0.7)):
    row = steps(folder)[step - 1]
    off = row["punch.rotation"] - tilt(e)
    claim(abs(off) < 1e-3 * max(abs(tilt(e)), 1e-3 * P),
          "force at %g: tilt %.6e, exact %.6e" % (e, row["punch.rotation"], tilt(e)))
    here = points(folder, step)
    # away from the singular edges, and from where the lifted side ends
    worst = max(abs(p["lambda_n"] - pressure(p["x"], e)) for p in here
                if abs(p["x"]) < 0.85 and (e < 0.5 or abs(p["x"] - (4 * e - 3)) > 0.2))
    claim(worst < 1e-3 * P, "pressure within %.1e of P/a" % (worst / P))
    if e > 0.5:
        claim(abs(row["face.contact_length"] - 4 * (1 - e)) < 0.03,
              "contact is %.3f wide, exact %.3f" % (row["face.contact_length"], 4 * (1 - e)))
# The pressure is singular at the edges, where no polynomial follows it: its factor
# (1 - x^2)^1/2 is right on all elements but the last two on each side, here down to 1e-7 from
# the edges, where degree 7 and elements that shrink to a third begin
SHRINK = [0.3**(k + 1) for k in range(17)]
cuts = sorted({s * (1 + d) for s in (-1, 1) for d in [0, *SHRINK, *(-d for d in SHRINK)]} |
              {s * x for s in (-1, 1) for x in (2.5, 6, 20, 60, 200)} |
              {0.1 * k for k in range(-6, 7)} |
              {x + s * d for x in (-0.6, -0.2) for s in (-1, 1) for d in (0.03, 0.009, 0.0027)})
corners = [(-200, -200), (200, -200)] + [(x, 0) for x in reversed(cuts)]
folder = solve("graded", settings=[
    "Bodies->block->Geometry->Vertices=%dx2:{%s}" % (
        len(corners), ", ".join("%.17g, %g" % corner for corner in corners)),
    "Bodies->block->Geometry->Edges={bottom, right, %s, left}" % ", ".join(["top"] * (len(cuts) - 1)),
    "Bodies->block->Mesh->Elements per Edge={2, 2, %s, 2}" % ", ".join(
        "2" if max(abs(a), abs(b)) > 2 else "1" for a, b in zip(cuts[1:], cuts)),
    "Discretization->Degree=7"])
for step, e in ((1, 0), (2, 0.2), (3, 0.4), (5, 0.6), (6, 0.7)):
    here = [p for p in points(folder, step) if abs(p["x"]) < 1 - 1e-7]
    worst = max(abs(p["lambda_n"] - pressure(p["x"], e)) * math.sqrt(1 - p["x"]**2)
                for p in here) / (P / math.pi)
    off = abs(steps(folder)[step - 1]["punch.rotation"] / (tilt(e) or 1) - (e > 0))
    claim(worst < 1e-3 and off < 1e-4 and len(here) > 400,
          "force at %g: pressure times (1 - x^2)^1/2 within %.1e of P/(pi a) on all of the contact "
          "but 1e-7 of it, tilt within %.1e" % (e, worst, off))

claim(all(abs(row["punch.force_y"] + P) < 1e-18 and row["punch.force_x"] == 0
          for row in steps("tilting")), "steps.csv has the force on the punch")
balanced("tilting")

# a contact that is named like a rigid body
folder = solve("named", changed("named", SCENE, ('"face"', '"punch"')), ["Adaptivity->Strategy=None"])
head = read(os.path.join(folder, "steps.csv")).split("\n")[0].split(",")
claim(len(set(head)) == len(head) and "block:punch.force_y" in head and "punch.force_y" in head,
      "a contact named like the punch has its body's name before it in steps.csv")

# one load, no path
ONE = ["History->Times={1}", "History->Steps={1}", MOTION + "Force Y=-0.001", MOTION + "Moment=-0.0004"]
once = solve("one step", settings=ONE)
alone = solve("no path", saved("no path", keys_of(SCENE).changed({"History": None})), ONE[2:] + [
    "Adaptivity->Strategy=Adaptive h", "Adaptivity->Maximum Levels=3"])
punch = [row for row in rows(alone, "bodies.csv") if row["body"] == "punch"]
claim(abs(punch[0]["rotation"] / steps(once)[0]["punch.rotation"] - 1) < 1e-10,
      "bodies.csv has the motion without a path")
claim(abs(punch[2]["rotation"] / tilt(0.4) - 1) < 1e-3, "and after refinement")
balanced(alone)

# a load above the edge of a foot, where the two elements under it are too coarse to balance it
for place in (0.9, -0.96):
    folder = solve("edge", pad("edge", {"Force X": "0", "Force Y": "-0.01", "Moment": repr(-0.01 * place)},
                               friction(0.4), size=1))
    balanced(folder)
fails("and one beside it is not", ("balance",), "run", pad("beside", {
    "Force X": "0", "Force Y": "-0.01", "Moment": "-0.0101"}, friction(0.4), size=1), "--output", fresh("beside"),
      code=2)
# a rough pad: what a force makes of it, given as its motion, needs the same force
PATH = {"form": "Projected", "more": history([1, 2, 3], [2, 4, 4])}
pushed = solve("pushed", pad("pushed", {
    "Force X": "0.003*sin(pi/2*max(0, t - 1))", "Force Y": "-0.01*min(t, 1)",
    "Moment": "0.001*max(0, t - 2)"}, friction(0.4), **PATH))
# straight between the steps as they were: t counts them
given = {}
path = steps(pushed)
for key, column in (("Displacement X", "motion_x"), ("Displacement Y", "motion_y"),
                    ("Rotation", "rotation")):
    text = "0"
    for row in reversed(path):
        text = "(t < %r ? %r : %s)" % (row["t"] + 1e-6, row["pad." + column], text)
    given[key] = text
moved = solve("moved", pad("moved", given, friction(0.4), **PATH))
size = max(abs(row["pad.force_y"]) for row in path)
claim(max(abs(a["pad." + c] - b["pad." + c]) for a, b in zip(path, steps(moved))
          for c in ("force_x", "force_y", "moment")) < 1e-8 * size,
      "the motions that forces make need these forces")
claim(abs(path[-1]["energy_dissipated"] / steps(moved)[-1]["energy_dissipated"] - 1) < 1e-6
      and path[-1]["energy_dissipated"] > 0, "and do the same work against friction")
for folder in (pushed, moved):
    never_falls(folder)
    balanced(folder)


refused("nothing resists", SCENE, "Bodies->punch", "nothing resists",
        "Displacement", settings=[MOTION + "Force X=0"])
refused("both", SCENE, "Motion->Force Y", "not both", settings=[MOTION + "Displacement Y=0"])
# a round hub that may turn presses on its hole by rounding alone
FIT, HUB = scene("press-fit.xml"), "Bodies->hub->"
TURNS = [HUB + "Rigid Motions->Fix={X, Y}"]
RIGID = [HUB + key for key in ("Rigid Motions=", "Mesh=", "Material={Rigid=true}", "Motion={Moment=1}")]
for kind, settings in (("elastic", TURNS), ("rigid", RIGID)):
    refused("an %s hub that turns freely" % kind, FIT, "Bodies->hub", "nothing resists",
            settings=settings)
for shear, code in ((4.9, 0), (4.95, 3)):  # on the bore; 0.2 x 6.15234375 x 20^2/10^2 = 4.922
    twisted = TURNS + ["Contacts->fit->Friction={Law=Coulomb, Coefficient=0.2}", HUB +
                       "Boundary Conditions={bore={Type=Neumann, Traction X=-%g*ny, Traction Y=%g*nx}}"
                       % (shear, shear)]
    fails("a hub under %.3f of the torque at which it slips" % (shear / 4.921875), (), "run", FIT,
          "--output", fresh("twisted"), code=code, settings=twisted)
refused("half a point", SCENE, "Reference Point", "two", settings=[MOTION + "Reference Point={1}"])
refused("no number", SCENE, "Moment", settings=[MOTION + "Moment=1/0"])

def unsolved(what, code, text):
    claim(code == 3 and "balance" in text, "%s: exit 3 and why; got %d, %s" % (
        what, code, text.strip().splitlines()[-1] if text else ""))


unsolved("a punch that is pulled off", *epafi(
    "run", SCENE, "--quiet", "--output", fresh("pulled"), "--set", MOTION + "Force Y=0.001*t"))
unsolved("a pad that is pushed beyond friction",
         *epafi("run", pad("slides", {"Force X": "0.0041*t", "Force Y": "-0.01*t"}, friction(0.4),
                           **PATH), "--quiet", "--output", fresh("slides")))
finish()
