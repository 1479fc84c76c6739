"""The shipped scenes of several bodies against their closed forms (doc/benchmarks/bodies.md)."""
import math

from runs import balanced, changed, claim, differ, finish, keys_of, read, rows, run, saved, scene
from written import with_sides_swapped


def solved(name, *settings):
    """Its last level, its contact points and bodies.csv of the last level."""
    history, points = run(scene(name + ".xml"), name, settings)
    balanced(name, scale=abs(history[-1]["force_normal"]))
    return history, points, [row for row in rows(name, "bodies.csv")
                             if row["level"] == history[-1]["level"]]


def swapped(name, *settings):
    """The same with the other side of each contact first: its last level, its points."""
    file = saved(name + "-swapped", with_sides_swapped(keys_of(scene(name + ".xml"))))
    history, points = run(file, name + "-swapped", settings)
    return history[-1], points


def worst(points, error):
    return max(abs(error(point)) for point in points)


def hertz(x):
    return math.sqrt(max(0.0, 1 - x * x))


def at(points, x):
    """Pressure between two samples."""
    behind = min((p for p in points if p["x"] >= x), key=lambda p: p["x"])
    before = max((p for p in points if p["x"] <= x), key=lambda p: p["x"])
    share = (x - before["x"]) / (behind["x"] - before["x"] or 1)
    return before["lambda_n"] + share * (behind["lambda_n"] - before["lambda_n"])


# press fit: Lame
history, points, _ = solved("press-fit", "Adaptivity->Maximum Levels=4")
error = worst(points, lambda p: p["lambda_n"] / 6.15234375 - 1)
claim(error < 1e-9, "press fit: pressure within %.1e" % error)
_, other = swapped("press-fit", "Adaptivity->Maximum Levels=4")
error = worst(other, lambda p: p["lambda_n"] / 6.15234375 - 1)
claim(error < 1e-6, "the other side first: within %.1e" % error)

# ring on disc: exponential in the degree
errors = []
for count in (3, 6, 8, 11):
    history, points, _ = solved("ring-on-disc", "Adaptivity->Maximum Levels=%d" % count)
    errors.append(worst(points, lambda p: p["lambda_n"] - 10 - 1.479262672811 * math.cos(
        2 * math.atan2(p["y"], p["x"]))))
claim(all(b < a / 30 for a, b in zip(errors, errors[1:])) and errors[-1] < 1e-10,
      "ring on disc: the error falls exponentially: " + " ".join("%.1e" % e for e in errors))

# bonded inclusion: uniform stress
solved("bonded-inclusion")
inside = rows("bonded-inclusion", "interior.csv")
for key, value in (("sxx", 1.178169078526), ("syy", -0.049486907983), ("sxy", 0)):
    error = max(abs(row[key] - value) for row in inside)
    claim(error < 1e-11, "bonded inclusion: %s is uniform, within %.1e" % (key, error))

# two cylinders: Hertz
a, p0 = 0.005, 3.048780487804878
history, points, _ = solved("two-cylinders")
error = worst([p for p in points if abs(p["x"]) < 0.95 * a],
              lambda p: p["lambda_n"] / p0 - hertz(p["x"] / a))
claim(error < 1e-3, "two cylinders: pressure within %.1e of the largest" % error)
error = history[-1]["contact_length"] / (2 * a) - 1
claim(abs(error) < 1e-3, "contact's width within %.1e" % error)
claim(all(abs(row["contact_length"] - 2 * a) < row["contact_length_error"] + 2e-4 * a for row in history) and
      0 < history[-1]["contact_length_error"] < 0.1 * history[0]["contact_length_error"],
      "its error is told at each level, %.1e at last" % history[-1]["contact_length_error"])
level = history[-1]
claim(abs(level["pressure_max"] - p0) < 1e-3 * p0 and level["pressure_max_error"] < 1e-4 * p0 and
      level["pressure_unbounded"] == 0, "the largest pressure is that of Hertz")

# cylinder on block: Hertz, and Cattaneo's shear
a, p0, f = 0.002, 1000 / 0.91 / 2 * 0.002 / 2, 0.3
c = a * math.sqrt(0.5)
# where stick ends the pressure needs elements as short as a thousandth of a
history, points, _ = solved("cylinder-on-block", "Adaptivity->Maximum Degrees of Freedom=8000",
                            "Adaptivity->Maximum Levels=31")
inner = [p for p in points if abs(p["x"]) < 0.9 * a]
error = worst(inner, lambda p: p["lambda_n"] / p0 - hertz(p["x"] / a))
claim(error < 5e-4, "cylinder on block: pressure within %.1e of the largest" % error)
error = worst([p for p in inner if abs(abs(p["x"]) / c - 1) > 0.05],
              lambda p: abs(p["lambda_t"]) / (f * p0) - hertz(p["x"] / a) +
              c / a * hertz(p["x"] / c))
claim(error < 0.015, "shear within %.1e of the largest" % error)
stick = 1 - history[-1]["slip_length"] / history[-1]["contact_length"]
claim(differ(stick, c / a) < 1e-2, "c/a = %.4f, closed form %.4f" % (stick, c / a))

# flat punch: unbounded at its edges
history, points = run(scene("punch.xml"), "punch")
exact = [1 / math.pi / math.sqrt(1 - p["x"] ** 2) for p in points]
claim(all(abs(p["lambda_n"] - e) < 1.2 * p["pressure_error"] + 3e-3 * e
          for p, e in zip(points, exact)), "flat punch: errors are told, beside its edges too")
away = [abs(p["pressure"] / e - 1) for p, e in zip(points, exact) if abs(p["x"]) < 31 / 32]
claim(max(away) < 0.13, "the elements at its edges leave the others alone: %.3f" % max(away))
peak = history[-1]["pressure_max"]
claim(history[-1]["pressure_unbounded"] == 1 and 1 < peak < max(exact) / 2,
      "the pressure, %.2f where elements resolve it, is told to be unbounded" % peak)

# rounded punch: within 1e-3, falling with the block's size
def ofPunch(points):
    return (at(points, 0) / 1.3597030051 - 1, at(points, 0.3) / 1.4854060604 - 1)


history, points, _ = solved("rounded-punch")
errors = ofPunch(points)
claim(max(map(abs, errors)) < 1e-3, "rounded punch: p(0), p(0.3 a) within %.1e, %.1e" % errors)
claim(abs(history[-1]["contact_length"] / 2 - 1) < 1e-3, "its contact ends at a")
text = read(scene("rounded-punch.xml"))
load = text.split('"Traction Y" type="string" value="')[1].split('"')[0]
file = changed("large-block", scene("rounded-punch.xml"),
               ("-20,-40, 20,-40, 20,0", "-80,-160, 80,-160, 80,0"), ("-20,0}", "-80,0}"),
               ("{4, 4, 6, 4, 16, 4, 6, 4}", "{4, 4, 12, 4, 16, 4, 12, 4}"),
               ('value="%s"' % load, 'value="%.16g"' % (float(load) / 4)))
larger = ofPunch(run(file, "large-block", ["Adaptivity->Maximum Levels=22"])[1])
claim(abs(larger[0]) < 0.5 * abs(errors[0]),
      "four times the block: p(0) within %.1e instead of %.1e" % (larger[0], errors[0]))

# incline: statics alone
_, _, bodies = solved("incline", "Adaptivity->Maximum Levels=2")
force = next(-row["reaction_x"] for row in bodies if row["body"] == "block")
claim(differ(abs(force) / 0.01, 0.4 / 0.97) < 1e-9, "incline: F/G = %.10f" % (force / 0.01))

# dovetail
angle = math.radians(50)
history, points, _ = solved("dovetail")
claim(differ(history[-1]["force_normal"], 600 / (math.cos(angle) + 0.2 * math.sin(angle))) < 1e-9,
      "dovetail: flanks that slip carry the pull")
claim(history[-1]["estimate"] < 0.2 * history[0]["estimate"], "the estimate falls")
finish()
