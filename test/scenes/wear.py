"""Wear along paths: closed forms, its balance, fretting, jumps over cycles; dense and compressed,
in all bases, either side first."""

import json
import os
import sys

from runs import (WORK, claim, differ, fails, finish, fresh, refused, rows, scene, solved,
                  write)
from written import (CLAMPED, NONE, TIED, WALLS, block, body, condition, confined, contact,
                     friction, geometry, history, keys, listed, rigid, wear, written)

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "random"))
from surfaces import Surfaces  # noqa: E402

E, NU = 1.0, 0.3
TOP = "-0.01*min(t, 1)"
MODULUS = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))
BASES = ("Gauss-Legendre-Lagrange", "Gauss-Lobatto-Lagrange", "Bernstein")


# steps in which k Δs M/H is 0.4, and one in which it is a million
K = 2.0
SLIDING = "max(0, t-1)*%r" % (0.4 / K / MODULUS)
for basis in BASES:
    # None determines these multipliers on one element, whose side has as many displacements
    for form, size in (("Density", 0.5), ("Projected", 0.5), ("None", 1)):
        folder, _ = solved("confined %s %s" % (basis, form),
                           confined("confined", wear(K) + keys(Sliding=SLIDING), TOP, form, basis,
                                    history([1, 6], [1, 5]), size))
        steps = rows(folder, "steps.csv")
        off = max(differ(row["bottom.force_normal"], 0.01 * MODULUS / 1.4**n)
                  for n, row in enumerate(steps))
        points = rows(folder)
        off = max([off] + [differ(p["worn_depth"], 0.01 - p["lambda_n"] / MODULUS)
                           for p in points])
        claim(off < 5e-12, "confined block that wears, %s, %s: to %.1e" % (basis, form, off))
folder, _ = solved("at once", confined(
    "at once", wear(K) + keys(Sliding="max(0, t-1)*%r" % (1e6 / K / MODULUS)), TOP,
    more=history([1, 2], [1, 1])))
off = differ(rows(folder, "steps.csv")[-1]["bottom.force_normal"], 0.01 * MODULUS / (1 + 1e6))
claim(off < 1e-9, "k Δs M/H = 1e6 in a step: to %.1e" % off)
# jumps are more of the same step; half of it does not wear
folder, _ = solved("jumped", confined(
    "jumped", wear("x < 2 ? 0.2 : 0", "t < 1.5 ? 1 : 10") + keys(Sliding=SLIDING), TOP,
    more=history([1, 6], [1, 5])))
steps = rows(folder, "steps.csv")
off = max(differ(row["bottom.force_normal"], 0.01 * MODULUS / 1.4**n)
          for n, row in enumerate(steps))
claim(off < 5e-12 and steps[-1]["cycles"] == 51, "Cycle Jump 10: to %.1e" % off)
# energies: what the top does is in the block or worn off
coarse = steps[-1]
claim(abs(coarse["energy_error"]) < 1e-12 * coarse["energy_outside"] and
      coarse["energy_worn"] > 0.3 * coarse["energy_outside"],
      "energies balance with wear: %.1e" % coarse["energy_error"])

# a half-plane's block under a rigid parabola that is pressed by a force and slides by
def indented(name, law=NONE, sliding="0.3*max(0, t-1)", size=0.25, path=([1, 3], [1, 4]),
             motion=NONE, form="Density", coefficient=0.4, jump=1):
    outline = [(-4, -4), (4, -4), (4, 0), (1, 0), (-1, 0), (-4, 0)]
    soft = body("soft", geometry(outline, "bottom, right, top, contact, top, left"), 1.0,
                condition("bottom", "Dirichlet", CLAMPED))
    return written(name, [soft, rigid("pad", block(-1, 0, 1, 1), listed(
        "Motion", motion or keys(Force_Y="-0.05*min(t, 1)")))], contact(
            "rub", "soft:contact", "pad:bottom", law, wear(coefficient, jump),
            keys(Sliding=sliding) if sliding else NONE, Interference="-x^2/8"), form, size,
                   more=history(*path) if path else NONE)


got = {}
for way, settings in (("dense", ()), ("compressed", ("Solver->Linear->Method=Compressed",))):
    folder, _ = solved("volume %s" % way, indented("volume"), *settings)
    got[way] = rows(folder, "steps.csv")
    off = max(differ(row["rub.worn_volume"], 0.4 * 0.05 * 0.3 * (row["t"] - 1))
              for row in got[way][1:])
    claim(off < 1e-12 and all(r["rub.contact_length"] < 2 for r in got[way]),
          "V = k P s in every step, %s: to %.1e" % (way, off))
    fall = [row["rub.pressure_max"] for row in got[way]]
    claim(fall == sorted(fall, reverse=True) and fall[-1] < 0.9 * fall[0], "the pressure falls")
off = max(differ(a[key], b[key]) for a, b in zip(got["dense"], got["compressed"])
          for key in ("energy_strain", "energy_worn", "rub.pressure_max") if a[key])
claim(off < 1e-8, "compressed agrees to %.1e" % off)
for basis in BASES[1:]:
    folder, _ = solved("volume %s" % basis, indented("volume"),
                       "Discretization->Multiplier=" + basis,
                       "Discretization->Stabilization->Form=Density")
    off = max(differ(row["rub.worn_volume"], 0.4 * 0.05 * 0.3 * (row["t"] - 1))
              for row in rows(folder, "steps.csv")[1:])
    claim(off < 1e-12, "V = k P s, %s: to %.1e" % (basis, off))


def unbalanced(steps):
    """But for the first step, which closes the contact."""
    return abs(steps[-1]["energy_error"] - steps[0]["energy_error"])


folder, _ = solved("finer", indented("finer", path=([1, 3], [1, 8])))
coarse, fine = (unbalanced(steps) for steps in (got["dense"], rows(folder, "steps.csv")))
claim(max(coarse, fine) < 1e-3 * got["dense"][-1]["energy_worn"],
      "energies balance but for what closes: %.1e, in twice as many steps %.1e" % (coarse, fine))

# rubbing to and fro under Coulomb's law: what wears is k/f times friction's work
SHAKEN = keys(Force_Y="-0.05*min(t, 1)", Displacement_X="0.003*sin(2*pi*max(0, t - 1))")
GROSS = keys(Force_Y="-0.05*min(t, 1)", Displacement_X="0.06*sin(2*pi*max(0, t - 1))")
for kind, motion in (("partial", SHAKEN), ("gross", GROSS)):
    for way, settings in (("dense", ()), ("compressed", ("Solver->Linear->Method=Compressed",))):
        folder, text = solved("%s slip %s" % (kind, way), indented(
            kind, law=friction("0.5"), sliding="", motion=motion, coefficient=0.2, jump=2,
            path=([1, 3], [1, 16])), *settings)
        last = got[way] = rows(folder, "steps.csv")
        off = differ(last[-1]["rub.worn_volume"], 2 * 0.2 / 0.5 * last[-1]["energy_dissipated"])
        newton = max(row["newton_iterations"] for row in last)
        claim(off < 1e-10 and last[-1]["cycles"] == 6 and
              (kind == "gross" or last[-1]["rub.slip_length"] < last[-1]["rub.contact_length"]),
              "%s slip, %s: worn as k/f times friction's work to %.1e, %d steps of Newton's at most" % (
                  kind, way, off, newton))
        off = unbalanced(last) / last[-1]["energy_dissipated"]
        claim(off < 1e-2, "its energies balance: %.1e of friction's work" % off)
    off = max(differ(a[key], b[key]) for a, b in zip(got["dense"], got["compressed"])
              for key in ("energy_strain", "rub.pressure_max", "energy_dissipated") if a[key])
    claim(off < 1e-7, "%s slip, compressed agrees to %.1e" % (kind, off))
for basis in BASES:
    folder_of, _ = solved("partial slip %s" % basis, indented(
        "partial", law=friction("0.5"), sliding="", motion=SHAKEN, coefficient=2, size=1 / 16,
        path=([1, 3], [1, 16])), "Discretization->Multiplier=" + basis)
    got[basis] = rows(folder_of, "steps.csv")[-1]["rub.worn_volume"]
    least = min(min(p["worn_depth"], p["slip_distance"]) for p in rows(folder_of))
    claim(least >= 0, "nothing grows where it wears, %s: %.1e" % (basis, least))
claim(all(differ(got[basis], got[BASES[0]]) < 0.05 for basis in BASES),
      "partial slip wears alike in all bases: %s" % [got[basis] for basis in BASES])
points = rows(folder)
middle = [p for p in points if abs(p["x"]) < 0.1]
claim(max(p["worn_depth"] for p in points) > 0 and all(p["worn_depth"] > 0 for p in middle),
      "gross slip wears the middle, too")

# two blocks: either side may carry the pressure and what is worn
def pressed(name, first, law):
    lower = body("lower", block(-2, -1, 2, 0), 1.0, WALLS + condition("bottom", "Dirichlet", CLAMPED))
    upper = body("upper", block(-2, 0, 2, 1), 3.0, WALLS + condition(
        "top", "Dirichlet", Displacement_X="0", Displacement_Y="-0.01*(1+0.5*cos(pi*x/2))*min(t, 1)"))
    sides = ("lower:top", "upper:bottom")
    return written(name, [lower, upper], contact("rub", *sides[::first], law + keys(Sliding=
        "0.2*max(0, t-1)") + wear("1")), "Density", 0.25, 2, more=history([1, 2], [1, 4]))


for kind, law in (("frictionless", NONE), ("gross", friction("0.2"))):
    last, estimate = {}, {}
    for first in (1, -1):
        folder, _ = solved("%s %+d" % (kind, first), pressed(kind, first, law))
        last[first] = rows(folder, "steps.csv")[-1]
        estimate[first] = rows(folder, "history.csv")[-1]["estimate_relative"]
    for key in ("energy_strain", "energy_worn", "rub.worn_volume"):
        off = differ(last[1][key], last[-1][key])
        claim(off < min(1e-2, 2 * max(estimate.values())), "%s, either side first, %s: to %.1e, "
              "estimate %.1e" % (kind, key, off, max(estimate.values())))


# nothing slides while a cylinder is pressed on: no step is halved for what rounding wears
folder, _ = solved("pressed on", scene("fretting-wear.xml"), "History->Times={1}", "History->Steps={1}",
                   "History->Tolerance=1e-2")
claim(rows(folder, "steps.csv")[-1]["parts"] == 8, "rounding does not halve steps")
# refused, and warned of
refused("a bond", indented("bond", law=TIED), "Wear", "Tied", command="check")
refused("no slip", indented("unslipped", sliding=""), "Wear", "give Sliding", command="check")
refused("no path", indented("pathless", path=None), "Contacts->rub->Wear", "History->Times",
        command="check")
refused("a jump", indented("jump", jump=0.5), "Cycle Jump", "0.5", command="check")
refused("growth", indented("growth", coefficient="-x"), "Wear->Coefficient", ">= 0", command="check")
refused("dual", indented("dual", form="None"), "Contacts->rub: ", "Biorthogonal")
fails("a motion that stays", ["warning: Contacts->rub->Sliding", "does not use t"], "check",
      indented("still", sliding="0.3*x"), code=0)
fails("a jump of what does not wear", ["warning: Contacts->rub->Wear->Cycle Jump", "Coefficient"],
      "check", indented("unworn"), "--set", "Contacts->rub->Wear={Cycle Jump=10}", code=0)
fails("a long jump", ["Cycle Jump", "0.3"], "run", indented(
    "long", law=friction(0.5), sliding="", motion=SHAKEN, coefficient=0.2, jump=400,
    path=([1, 1.1], [1, 1])), "--output", fresh("long"), code=0)
# where sides shear and do not yield, slip and wear may drive each other on short elements
for share in (1, 0.9, 0.5):
    torn = Surfaces(100709).scene()
    torn["Contacts"]["joint"]["Wear"]["Coefficient"] *= share
    solved("wear of %g" % share,
           write(os.path.join(WORK, "much.yaml"), json.dumps({"much": torn})))
torn = Surfaces(100709).scene()
torn["Contacts"]["joint"]["Wear"]["Coefficient"] *= 1000
endless = Surfaces(101171).scene()
endless["Contacts"]["joint"]["Wear"]["Coefficient"] *= 1000
solved("a thousand times the wear that settles by shares",
       write(os.path.join(WORK, "endless.yaml"), json.dumps({"endless": endless})))
torn = write(os.path.join(WORK, "torn.yaml"), json.dumps({"torn": torn}))
solved("wear that ends", torn, "Contacts->joint->Normal->Law=Linear",
       "Contacts->joint->Normal->Compliance=1e-10")
finish()
