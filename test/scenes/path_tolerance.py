"""Paths whose steps are chosen: History->Tolerance against closed forms and against many steps."""
from halves import contact_side, loads, loop
from runs import claim, finish, goes_on, refused, rows as rows_of, saved, scene, solved, steps

SCENE = scene("fretting.xml")
COARSE = ["Discretization->Elements per Edge={2, 2, 2, 3, 1, 5, 12, 5, 1, 3, 2, 2, 2, 3, 3, 3}"]


def solve(name, settings):
    return solved(name, SCENE, *settings)


def path(times, count, tolerance):
    return ["History->Times={%s}" % ", ".join(map(str, times)), "History->Steps={%d}" % count] + (
        ["History->Tolerance=%g" % tolerance] if tolerance else [])


# where bounds stay, few steps are exact; what the mesh errs by is in paths.py
folder, text = solve("loop", path([1, 2, 4, 6], 1, 1e-3))
rows = steps(folder)
claim([row["t"] for row in rows] == [1, 2, 4, 6], "a row for each time that is asked for")
claim([row["parts"] for row in rows] == [8] * 4,
      "eight steps each are enough under a constant pressure")
cycle = rows[3]["energy_dissipated"] - rows[1]["energy_dissipated"]
claim(abs(cycle / loop(0.5) - 1) < 1e-3, "a cycle's work is off by %.1e" % (cycle / loop(0.5) - 1))

# loops of other amplitudes, on small elements where slip is
CUTS = [-40, -16, -6, -2.5, -1.25, -1.02, -0.8, 0.8, 1.02, 1.25, 2.5, 6, 16, 40]
LAYERS = contact_side(CUTS, [4, 4, 4, 6, 4, 36, 64, 36, 4, 6, 4, 4, 4])
for q in (0.2, 0.9):
    folder, text = solve("loop of %g" % q,
                         LAYERS + ["Constants->Q=%g*f*P" % q] + path([1, 2, 4, 6], 1, 1e-3))
    rows = steps(folder)
    error = (rows[3]["energy_dissipated"] - rows[1]["energy_dissipated"]) / loop(q) - 1
    claim(abs(error) < 5e-4, "a cycle's work at %g f P is off by %.1e" % (q, error))

# pressure and push swing, not in time with each other
SWING = COARSE + loads("0.2*pi/400*(t < 1 ? 0 : sin(pi*(t - 1)/2))",
                       "pi/400*min(t, 1)*(t < 1 ? 1 : 1 + 0.4*sin(pi*(t - 1)/2 + 1))")
many = steps(solve("many", SWING + path([1, 3, 5], 320, 0))[0])
exact = {row["t"]: row["energy_dissipated_trapezoidal"] for row in many}
for tolerance in (1e-2, 2e-3):
    folder, text = solve("swing %g" % tolerance, SWING + path([1, 3, 5], 1, tolerance))
    rows = steps(folder)
    for row in rows[1:]:
        error = abs(row["energy_dissipated"] / exact[row["t"]] - 1)
        told = row["energy_dissipated_error"] / row["energy_dissipated"]
        claim(error < tolerance,
              "tolerance %g: work up to t = %g in %d steps off by %.1e, told %.1e" %
              (tolerance, row["t"], row["parts"], error, told))
        claim(error < told < 6 * error, "what is told is larger, by less than 6")
    claim(8 < max(row["parts"] for row in rows) < 320, "their number is chosen")
    claim("error in time" not in text, "no warning")

# a bulged pad that swings while it is pressed: differences of its work fall by chance, and what it
# did before it closed counts later
def pad(**history):
    return saved("pad", {
        "Bodies": {
            "up": {"Material": {"Young's Modulus": 1000, "Poisson's Ratio": 0.3},
                   "Geometry": {"Vertices": [[-1, 0], [1, 0], [1, 1], [-1, 1]],
                                "Edges": ["b", "s", "t", "w"], "Bulges": [0.02, 0, 0, 0]},
                   "Boundary Conditions": {"t": {
                       "Type": "Dirichlet", "Displacement X": "0.004*sin(2*t)",
                       "Displacement Y": "-0.03*(1 - exp(-3*t)) - 0.003*sin(5*t)"}}},
            "lo": {"Material": {"Young's Modulus": 2000, "Poisson's Ratio": 0.2},
                   "Geometry": {"Vertices": [[-3, -2], [3, -2], [3, -0.02], [-3, -0.02]],
                                "Edges": ["b", "s", "t", "s"]},
                   "Boundary Conditions": {"b": {
                       "Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}}},
        "Contacts": {"c": {"Between": ["up:b", "lo:t"],
                           "Friction": {"Law": "Coulomb", "Coefficient": 0.3}}},
        "History": {"Times": [1, 2], **history},
        "Discretization": {"Mesh Size": 0.25, "Degree": 2},
        "Adaptivity": {"Maximum Levels": 1}})


# against as many steps as a section may have
exact = [row["energy_dissipated"] for row in steps(solved("pad", pad(Tolerance=1e-9))[0])]
for tolerance in (3e-2, 1e-2, 3e-3):
    rows = steps(solved("pad %g" % tolerance, pad(Tolerance=tolerance))[0])
    for row, work in zip(rows, exact):
        error, told = abs(row["energy_dissipated"] - work), row["energy_dissipated_error"]
        claim(error < told, "tolerance %g: the pad's work up to t = %g in %d steps off by %.1e, "
              "told %.1e" % (tolerance, row["t"], row["parts"], error, told))

# places that slip before they close: friction does little until they are pushed
MIXED = COARSE + ["Bodies->block->Material->Poisson's Ratio=0.3"] + loads(
    "0.1*pi/400*max(0, t - 1)", "pi/400*min(t, 1)")
exact = steps(solve("mixed, many", MIXED + path([1, 2], 200, 0))[0])[-1][
    "energy_dissipated_trapezoidal"]
rows = steps(solve("mixed", MIXED + path([1, 2], 1, 2e-3))[0])
error = abs(rows[-1]["energy_dissipated"] / exact - 1)
claim(error < 2e-3, "pressed in %d steps, pushed in %d: work off by %.1e" % (
    rows[0]["parts"], rows[1]["parts"], error))

# a section that ends where it begins
folder, text = solve("there and back", COARSE + path([1, 5], 1, 1e-2))
claim(steps(folder)[1]["energy_dissipated"] > 0.7 * loop(0.5), "what goes and comes back is seen")
parts, reported = (rows_of(name, "history.csv")[-1]["eta_slip"] for name in (
    folder, solve("there and back in steps", COARSE + path([1, 5], 16, 0))[0]))
claim(0 < parts < 2 * reported,
      "slip of a part is estimated as that of a step: %.2e, %.2e" % (parts, reported))

# as short as steps may be is not short enough
folder, text = solve("too long", SWING + path([1, 3], 1, 1e-4) + ["History->Minimum Step=0.125"])
claim("error in time" in text and "History->Tolerance" in text, "what is missing is told")
claim(steps(folder)[1]["parts"] == 16, "down to the shortest step")
refused("steps that leave nothing to compare", SCENE, "at least 8 steps from t = 0 to 1; at most 0.125",
        settings=SWING + path([1, 3], 1, 1e-4) + ["History->Minimum Step=0.126"])

# stopped behind a step, gone on with: the same steps
LONG = SWING + path([1, 2, 3, 4, 5], 1, 5e-3) + ["Adaptivity->Strategy=Adaptive h",
                                                 "Adaptivity->Maximum Levels=2"]
goes_on("stopped", SCENE, LONG, lambda part: len(steps(part)) >= 5)
# what is missing of the worn volume is told, too
_, *texts = goes_on("worn too fast", scene("fretting-wear.xml"), path([1, 2, 3, 4, 5], 1, 1e-4) + [
    "History->Minimum Step=0.03125"], lambda part: len(steps(part)) >= 2)
told = [[line for line in text.splitlines() if "the worn volume has an estimated error" in line]
        for text in texts]
claim(len(told[0]) == 1 and told[0] == told[1], "of the worn volume, too: %s" % told)
finish()
