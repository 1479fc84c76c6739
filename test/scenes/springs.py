"""Rigid bodies on springs: what the spring says, its limits, a block that a spring pulls over a
rough ground, energies, compressed operators, a restart."""
import math

from runs import claim, epafi, finish, goes_on, refused, rows, solved
from written import block, body, contact, friction, history, listed, pad, rigid, written

COMPONENTS = {"X": ("Displacement X", "Force X", "Stiffness X", "motion_x", "reaction_x", "load_x"),
              "Y": ("Displacement Y", "Force Y", "Stiffness Y", "motion_y", "reaction_y", "load_y"),
              "Rotation": ("Rotation", "Moment", "Stiffness Rotation", "rotation",
                           "reaction_moment", "load_moment")}
PRESS = {"Displacement Y": -0.05}
ORIGIN = {"Reference Point": [0, 0]}


def one(name, motion, *settings):
    """The pad's row without a path."""
    folder, text = solved(name, pad(name, {**ORIGIN, **motion}, friction(0.4)), *settings)
    warnings = [line for line in text.splitlines()
                if "warning" in line and "the estimated error is" not in line]
    claim(not warnings or name == "hangs" and "contact never closes" in warnings[0],
          name + ": nothing but the coarse mesh is warned of")
    return next(row for row in rows(folder, "bodies.csv") if row["body"] == "pad")


def apart(a, b, columns):
    size = max(abs(a[c]) for c in columns)
    return max(abs(a[c] - b[c]) for c in columns) / size


FORCES = ("contact_x", "contact_y", "contact_moment")

# what the spring says; its motion given, and its force given, are the same
for name, end, stiffness, others in (("X", 0.02, 0.7, PRESS), ("Y", -0.05, 0.3, {}),
                                     ("Rotation", 0.02, 0.5, PRESS)):
    moved, pushed, sprung, motion, reaction, load = COMPONENTS[name]
    spring = {**others, moved: end, sprung: stiffness}
    row = one("spring " + name, spring)
    force = row[reaction]
    claim(abs(force - stiffness * (end - row[motion])) < 1e-12 * abs(force) and
          abs(force) > 1e-3 * stiffness * abs(end),
          "%s: F = k (d - a): %.3e of %.3e" % (name, force, stiffness * end))
    given = one("given " + name, {**others, moved: row[motion]})
    claim(apart(row, given, FORCES) < 1e-10, "the motion %s needs that force" % name)
    under = one("under " + name, {**others, pushed: force})
    claim(abs(under[motion] / row[motion] - 1) < 1e-10 and apart(row, under, FORCES) < 1e-10,
          "the force %s makes that motion" % name)
    ground = one("ground " + name, {**others, pushed: stiffness * end, sprung: stiffness})
    claim(abs(ground[motion] / row[motion] - 1) < 1e-10 and
          abs(ground[load] - stiffness * end) < 1e-15 and
          abs(ground[reaction] + stiffness * ground[motion]) < 1e-12 * abs(force),
          "a spring to the ground beside a force k d, %s" % name)
    # 1/k of the way between the two limits
    stiff = {k: one("stiff %s %g" % (name, k), {**others, moved: end, sprung: k})
             for k in (1e4, 1e9)}
    limit = one("limit " + name, {**others, moved: end})
    off = {k: apart(limit, row, FORCES) for k, row in stiff.items()}
    claim(0 < off[1e4] < 1e-3 and off[1e9] < 2e-5 * off[1e4] + 1e-11,
          "%s: stiff springs are as the motion given, %.1e and %.1e" % (name, *off.values()))
    free = one("free " + name, {**others, pushed: force})
    soft = {k: one("soft %s %g" % (name, k), {**others, pushed: force, sprung: k})
            for k in (1e-4, 1e-9)}
    far = one("far " + name, {**others, moved: force / 1e-9 + free[motion], sprung: 1e-9})
    off = {k: abs(row[motion] / free[motion] - 1) for k, row in soft.items()}
    claim(0 < off[1e-4] < 1e-2 and off[1e-9] < 2e-5 * off[1e-4] + 1e-11,
          "%s: soft springs are as the force given, %.1e and %.1e" % (name, *off.values()))
    claim(abs(far[motion] / free[motion] - 1) < 1e-10 and apart(free, far, FORCES) < 1e-10,
          "%s: a soft spring from far away is a force" % name)

code, text = epafi("check", pad("checked", {"Stiffness X": 2, "Force Y": -1}, friction(0.4)))
claim(code == 0 and "X by a spring, Y under a force, Rotation held" in text,
      "check says what drives the pad")

# three springs hold a pad that is above the ground
hang = one("hangs", {"Displacement Y": 1, "Stiffness X": 2, "Stiffness Y": 2,
                     "Stiffness Rotation": 2, "Force Y": -0.5})
claim(abs(hang["motion_y"] - 0.75) < 1e-12 and abs(hang["reaction_y"] - 0.5) < 1e-12 and
      all(abs(hang[c]) < 1e-15 for c in FORCES), "springs alone hold a body")

# a block that a spring pulls to and fro: F = k (d - a), never more than mu P
P, MU, PULL = 0.01, 0.4, "0.4*sin(pi/2*(t - 1))"


def block_on(stiffness, pull, steps=18):
    return pad("block %g" % stiffness, {
        **ORIGIN, "Displacement X": "t < 1 ? 0 : " + pull, "Stiffness X": stiffness,
        "Force Y": "-%r*min(t, 1)" % P}, friction(MU), more=history([1, 4], [1, steps]))


for stiffness, pull in ((0.05, PULL), (1e3, PULL), (1e-9, "2e7*sin(pi/2*(t - 1))")):
    file = block_on(stiffness, pull)
    folder, _ = solved("block %g" % stiffness, file)
    steps = rows(folder, "steps.csv")
    scale = float(pull.split("*")[0])
    ends = [0 if row["t"] < 1 else scale * math.sin(math.pi / 2 * (row["t"] - 1)) for row in steps]
    sliding = 0
    for row, end in zip(steps, ends):
        F = row["pad.force_x"]
        claim(abs(F - stiffness * (end - row["pad.motion_x"])) <
              1e-12 * max(MU * P, stiffness * abs(end) * 1e-3) and abs(F) < MU * P * (1 + 1e-10),
              "t = %.3g: F = k (d - a) = %.6e, not more than mu P" % (row["t"], F))
        sliding += abs(abs(F) - MU * P) < 1e-10 * MU * P
    first = next(k for k, row in enumerate(steps)
                 if abs(abs(row["pad.force_x"]) - MU * P) < 1e-10 * MU * P)
    claim(all(stiffness * abs(end) <= MU * P * (1 + 1e-9) + 0.02 * stiffness or k >= first
              for k, end in enumerate(ends)) and 4 < sliding and first > 0 and
          stiffness * abs(ends[first]) >= MU * P,
          "k = %g: sticks until k d is mu P, then slides: %d of %d steps" % (
              stiffness, sliding, len(steps)))
    claim({1, -1} == {round(row["pad.force_x"] / MU / P) for row in steps if abs(
        abs(row["pad.force_x"]) - MU * P) < 1e-10 * MU * P}, "both ways")
    # energies: the driven ends do the work, springs store
    work, before = 0, {"pad.force_x": 0, "pad.force_y": 0, "pad.motion_y": 0, "end": 0}
    for row, end in zip(steps, ends):
        row["end"] = end
        work += ((row["pad.force_x"] + before["pad.force_x"]) * (end - before["end"]) +
                 (row["pad.force_y"] + before["pad.force_y"]) *
                 (row["pad.motion_y"] - before["pad.motion_y"])) / 2
        claim(abs(row["energy_outside"] - work) < 1e-10 * abs(row["energy_outside"]) and
              abs(row["energy_springs"] - row["pad.force_x"]**2 / 2 / stiffness) <=
              1e-12 * row["energy_springs"],
              "the end's work is energy_outside, F^2 / (2 k) is energy_springs")
        rest = row["energy_outside"] - row["energy_dissipated_trapezoidal"] - sum(
            row["energy_" + key] for key in ("strain", "stabilisation", "interface", "worn", "springs"))
        claim(abs(rest - row["energy_error"]) < 1e-12 * max(row["energy_outside"], 1e-6) and
              abs(row["energy_stored"] - row["energy_strain"] - row["energy_stabilisation"] -
                  row["energy_springs"]) < 1e-12 * row["energy_stored"],
              "energy_error is what remains, %.1e" % row["energy_error"])
        before = row
    worst = max(abs(row["energy_error"]) / row["energy_outside"] for row in steps)
    claim(worst < 1e-12, "and that is rounding: %.1e" % worst)

# the same by compressed operators, and gone on with
folder, _ = solved("dense", block_on(0.05, PULL), "Solver->Linear->Method=Dense")
dense = rows(folder, "steps.csv")
folder, _ = solved("compressed", block_on(0.05, PULL), "Solver->Linear->Method=Compressed")
claim(max(abs(a["pad." + c] - b["pad." + c]) for a, b in zip(dense, rows(folder, "steps.csv"))
          for c in ("force_x", "force_y", "motion_x", "motion_y")) < 1e-9,
      "dense and compressed operators agree")
goes_on("a path of 41 steps", block_on(0.05, PULL, 40), ["Discretization->Mesh Size=0.08"],
        lambda part: True)

refused("no stiffness", pad("zero", {"Stiffness X": 0}), "Motion->Stiffness X", "> 0")
refused("an elastic body", written("elastic",
                                   [body("soft", block(-4, -4, 4, 0), 1.0,
                                         inside=listed("Motion", Stiffness_X=1)),
                                    rigid("pad", block(-1, 0, 1, 1))],
                                   contact("rub", "soft:top", "pad:bottom")),
        "Bodies->soft->Motion->Stiffness X", "Rigid")
finish()
