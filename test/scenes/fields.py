"""Fields inside a body after a run: Hooke's law and equilibrium by differences, a uniform stress, the
triangles of the whole inside, and what is refused."""
import math
import os
import shutil
import xml.etree.ElementTree as xml

from runs import (WORK, claim, differ, epafi, fails, finish, fresh, read, rows, scene, solved,
                  steps, table, vtu, write)
from written import block, body, condition, contact, written


def fields(folder, *arguments):
    file = os.path.join(folder, "fields.csv")
    code, text = epafi("fields", folder, *arguments)
    claim(code == 0, "fields %s: %s" % (" ".join(arguments), text.strip()))
    return table(file)


LEVELS = ["Adaptivity->Maximum Levels=9"]
folder, _ = solved("coulomb", scene("coulomb.xml"), *LEVELS)
used = xml.parse(os.path.join(folder, "used.xml")).getroot()


def value(name):
    return float(next(p for p in used.iter("Parameter") if p.get("name") == name).get("value"))


E, NU = value("Young's Modulus"), value("Poisson's Ratio")
MU, LAMBDA = E / 2 / (1 + NU), E * NU / (1 + NU) / (1 - 2 * NU)
grid = fields(folder, "--grid", "12,7")
claim(len(grid) == 84, "a grid of 12 times 7 in a rectangle")
X = sorted({row["x"] for row in grid})
Y = sorted({row["y"] for row in grid})
claim(len(X) == 12 and len(Y) == 7, "its points are the middles of cells")

# differences around a point: strain from displacement, divergence from stress
x, y, h = X[4], Y[3], 1e-3 * (X[1] - X[0])
points = os.path.join(WORK, "points.csv")
with open(points, "w", encoding="utf-8-sig") as stream:  # with a byte order mark
    for dx, dy in ((0, 0), (h, 0), (-h, 0), (0, h), (0, -h)):
        stream.write("%.17g,%.17g\n" % (x + dx, y + dy))
middle, right, left, up, down = fields(folder, "--points", points)
xx = (right["ux"] - left["ux"]) / 2 / h
yy = (up["uy"] - down["uy"]) / 2 / h
xy = ((up["ux"] - down["ux"]) + (right["uy"] - left["uy"])) / 4 / h
size = middle["von_mises"]
for name, hooke in (("sxx", (LAMBDA + 2 * MU) * xx + LAMBDA * yy),
                    ("syy", (LAMBDA + 2 * MU) * yy + LAMBDA * xx), ("sxy", 2 * MU * xy),
                    ("szz", LAMBDA * (xx + yy))):
    claim(differ(middle[name], hooke, size) < 1e-5,
          "%s follows from the displacement by Hooke's law: %g, %g" % (name, middle[name], hooke))
for a, b in ((("sxx", right, left), ("sxy", up, down)), (("sxy", right, left), ("syy", up, down))):
    (n, p, m), (k, q, r) = a, b
    divergence = (p[n] - m[n] + q[k] - r[k]) / 2 / h
    claim(abs(divergence) * (X[1] - X[0]) < 1e-4 * size, "equilibrium: %.1e" % divergence)
row = grid[17]
mises = math.sqrt(((row["sxx"] - row["syy"]) ** 2 + (row["syy"] - row["szz"]) ** 2 +
                   (row["szz"] - row["sxx"]) ** 2) / 2 + 3 * row["sxy"] ** 2)
claim(differ(mises, row["von_mises"]) < 1e-12, "von Mises' stress")
claim(differ(row["principal_1"] + row["principal_2"], row["sxx"] + row["syy"], size) < 1e-12 and
      differ(row["principal_1"] * row["principal_2"],
             row["sxx"] * row["syy"] - row["sxy"] ** 2, size ** 2) < 1e-12 and
      row["principal_1"] >= row["principal_2"], "principal stresses: sum and product")

# along the contact, just below it, the stress is the contact's
touching = rows(folder)
boundary = touching[0]["boundary"]
below = fields(folder, "--along", "block:" + boundary, "--depth", "1e-6")
claim(len(below) > 10 and len({row["y"] for row in below}) == 1, "a line at a depth")
nearest = min(touching, key=lambda row: abs(row["x"]))
there = min(below, key=lambda row: abs(row["x"] - nearest["x"]))
claim(differ(-there["syy"], nearest["lambda_n"], max(row["lambda_n"] for row in touching)) < 0.1,
      "the stress below the contact is its pressure: %g, %g" %
      (-there["syy"], nearest["lambda_n"]))

# triangles of the whole inside
code, text = epafi("fields", folder, "--vtk")
claim(code == 0, text.strip())
inside = vtu(os.path.join(folder, "fields.vtu"))
corners = inside["connectivity"]
place = list(zip(inside["Points"][::3], inside["Points"][1::3]))


def area(a, b, c):
    (ax, ay), (bx, by), (cx, cy) = place[a], place[b], place[c]
    return ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2


areas = [area(*corners[k:k + 3]) for k in range(0, len(corners), 3)]
width = max(x for x, y in place) - min(x for x, y in place)
height = max(y for x, y in place) - min(y for x, y in place)
claim(min(areas) > 0 and differ(sum(areas), width * height) < 1e-12,
      "%d triangles fill the block" % len(areas))
claim(min(areas) < 0.1 * max(areas), "and are small at small elements: %.1e, %.1e" %
      (min(areas), max(areas)))
claim(len(inside["von_mises"]) == len(place) and all(map(math.isfinite, inside["von_mises"])),
      "with a finite stress at all of their %d corners" % len(place))
# a uniform stress
folder, _ = solved("patch", scene("patch.xml"))
row = fields(folder, "--grid", "3,2")
for name in ("sxx", "syy", "sxy"):
    values = [point[name] for point in row]
    claim(max(values) - min(values) < 1e-9 * max(point["von_mises"] for point in row),
          "%s of the patch is uniform: %.1e" % (name, max(values) - min(values)))

# Interior Points are evaluated once, on the last level
points = "Output->Interior Points=1x2:{%.17g, %.17g}" % (x, y)
folder, _ = solved("coulomb", scene("coulomb.xml"), *LEVELS, points)
inside = rows(folder, "interior.csv")[0]
claim(all(differ(inside[key], middle[key], size) < 1e-12 for key in middle if key != "body") and
      inside["body"] == "block",
      "interior.csv has the same numbers")

# the steps of a load path: the fields of a step are those of the path that ends there
COARSE = ["Discretization->Elements per Edge={2, 2, 2, 3, 1, 4, 10, 4, 1, 3, 2, 2, 2, 3, 3, 3}"]
path, _ = solved("fretting", scene("fretting.xml"), *COARSE, "History->Times={1, 2, 4}",
                 "History->Steps={1, 2, 2}")
shorter = fresh("shorter")
code, text = epafi("run", scene("fretting.xml"), "--output", shorter, "--quiet",
                   settings=[*COARSE, "History->Times={1, 1.5}", "History->Steps={1, 1}"])
claim(code == 0, "a path that ends at t = 1.5 " + text)
ends = fields(shorter, "--grid", "9,9")
for step, there in (("2", ends), ("5", fields(path, "--grid", "9,9"))):
    here = fields(path, "--grid", "9,9", "--step", step)
    sizes = {key: max(abs(point[key]) for point in there) for key in there[0] if key != "body"}
    claim(len(here) == len(there) and all(
        abs(a[key] - b[key]) < 1e-10 * (size or 1) for a, b in zip(here, there)
        for key, size in sizes.items()), "step %s of 5 has the fields of the path up to it" % step)
claim(max(abs(a["sxy"] - b["sxy"]) for a, b in zip(ends, there)) > 1e-3 * sizes["sxy"],
      "which are not those of its end")
alone = fresh("alone")  # without the tables of which other pictures are drawn
shutil.copytree(path, alone)
for name in ("history.csv", "contact.csv", "boundary.csv"):
    os.remove(os.path.join(alone, name))
code, text = epafi("plot", alone, "--field", "von_mises", "--step", "2")
with open(os.path.join(alone, "von_mises.svg")) as file:
    claim(code == 0 and ", t = %g" % steps(path)[-4]["t"] in file.read(),
          "the field at a step is drawn, and its title says when " + text[-100:])

# bodies that overlap as drawn: each has its own fields
lower, upper = (body(name, block(0, low, 2, low + 1), 100.0, condition(
    side, "Dirichlet", Displacement_X=0, Displacement_Y=uy))
    for name, low, side, uy in (("a", 0, "bottom", 0), ("b", 0.9, "top", -0.01)))
pair, _ = solved("pair", written("overlap", [lower, upper], contact(
    "c", "a:top", "b:bottom", Interference=-0.1), "Density"))
for name, sign in (("a:top", 1), ("b:bottom", -1)):
    found = fields(pair, "--along", name, "--depth", "0.05")
    claim({row["body"] for row in found} == {name[0]} and
          all(sign * (row["uy"] + 0.005) > 0 for row in found),
          "fields along %s are its body's: uy from %g" % (name, found[0]["uy"]))

# a point outside has an empty row, the others have theirs
write(os.path.join(WORK, "outside.csv"), "x,y\n%g,%g\n%g,%g\n" % (x, 1e3, x, y))
code, text = epafi("fields", folder, "--points", os.path.join(WORK, "outside.csv"))
written_rows = read(os.path.join(folder, "fields.csv"))
empty, full = ([cell for cell in line.split(",")] for line in written_rows.splitlines()[1:])
claim(code == 0 and "1 outside" in text and float(empty[1]) == 1e3 and not any(empty[2:]) and
      all(full) and len(full) == len(empty), "a point outside has an empty row: " + text.strip())
code, text = epafi("fields", folder, "--points", os.path.join(WORK, "outside.csv"), "--output", "-")
claim(code == 0 and text == written_rows, "--output - writes the file to standard output, no more")

# all steps as a series for ParaView
code, text = epafi("fields", path, "--vtk", "--step", "all")
claim(code == 0 and "5 steps" in text, "a series: " + text.strip())
parts = xml.parse(os.path.join(path, "fields.pvd")).getroot().findall(".//DataSet")
claim([float(part.get("timestep")) for part in parts] ==
      [row["t"] for row in steps(path)][-5:], "fields.pvd has the times")
single = os.path.join(WORK, "single.vtu")
code, text = epafi("fields", path, "--vtk", "--step", "2", "--output", single)
with open(single, "rb") as one, open(os.path.join(path, parts[1].get("file")), "rb") as same:
    claim(one.read() == same.read(), "and the fields of each step")
side = ["--along", "block:" + rows(path)[0]["boundary"], "--depth", "0", "--step"]
every = fields(path, *side, "all")
for number, t in enumerate([row["t"] for row in steps(path)][-5:], 1):
    claim([{**row, "step": number, "t": t} for row in fields(path, *side, "%d" % number)] ==
          [row for row in every if row["step"] == number], "a table of all steps has step %d" % number)
start, = {round(row["x"] - row["s"], 9) for row in rows(path)}
elements = {row["element"] for row in rows(path)}
claim(all((row["n_x"], row["n_y"]) == (0, -1) and row["element"] in elements and
          abs(row["x"] - row["s"] - start) < 1e-8 for row in every) and
      {row["element"] for row in every} == elements,
      "along a boundary each row has its normal, element and arc length, as contact.csv")
code, text = epafi("plot", alone, "--field", "sxy", "--step", "all")
claim(code == 0 and os.path.isfile(os.path.join(alone, "movie.gif")),
      "which colour a movie " + text[-100:])

for sentence, words, arguments in [
        ("no folder", "no folder", ["fields", os.path.join(WORK, "nowhere")]),
        ("no solution", "solution.hdf", ["fields", WORK]),
        ("a table of all steps of no path", "no History", ["fields", folder, "--step", "all"]),
        ("a series elsewhere", "--output", ["fields", path, "--vtk", "--step", "all",
                                            "--output", "x"]),
        ("a series of no path", "no History", ["fields", folder, "--vtk", "--step", "all"]),
        ("an unknown boundary", "'block:" + boundary, ["fields", folder, "--along",
                                                       "block:bottm", "--depth", "1"]),
        ("a boundary without its body", "mean 'block:" + boundary, [
            "fields", folder, "--along", boundary, "--depth", "1"]),
        ("a depth below 0", ">= 0", ["fields", folder, "--along", "block:" + boundary,
                                     "--depth=-1"]),
        ("two ways", "one of", ["fields", folder, "--grid", "3,3", "--points", "x"]),
        ("points of no file", "'nofile': there is", ["fields", folder, "--points", "nofile"]),
        ("csv in a .vtu", "needs --vtk", ["fields", folder, "--output", "x.vtu"]),
        ("VTK in a .csv", "no csv", ["fields", folder, "--vtk", "--output", "x.csv"]),
        ("half a grid", "NX,NY", ["fields", folder, "--grid", "3"]),
        ("a grid beyond any file", "1e+07", ["fields", folder, "--grid", "100000,100000"]),
        ("a window outside", "another --window", ["fields", folder, "--window=1e3,1e3,1e4,1e4"]),
        ("a window without end", "X0,Y0,X1,Y1", ["fields", folder, "--window=-inf,0,inf,1"]),
        ("a window beyond numbers", "X0,Y0,X1,Y1",
         ["fields", folder, "--window=-1.7e308,0,1.7e308,1"]),
        ("a step behind the last", "has 5 steps", ["fields", path, "--step", "6"]),
        ("a step of no path", "no History", ["fields", folder, "--step", "1"]),
        ("step 0", "--step", ["fields", path, "--step", "0"]),
        ("a picture of a step behind the last", "has 5 steps", ["plot", path, "--step", "6"]),
        ("all steps of no field", "--field", ["plot", path, "--step", "all"]),
        ("an unknown field", "did you mean 'von_mises'", ["plot", folder, "--field", "mises"])]:
    fails(sentence, [words], *arguments)
finish()
