"""What tables and fields tell of surfaces and of each contact: stress on the boundary itself, arc
lengths, forces, moments and shear of a contact, of the whole and of a half; the pressure of loads."""
import math
import os
import re

import matplotlib

from epafi.plot.results import Contacts
from epafi.runs import Run
from runs import (WORK, claim, differ, epafi, finish, fresh, largest, read, rows, saved, scene, solved,
                  write)

matplotlib.use("Agg")

STEEL = {"Young's Modulus": 1000, "Poisson's Ratio": 0.3}
CIRCLE = {"Bulges": [1, 1]}

# Kirsch: a plate with a hole of radius 1, loaded at R by the stresses of the infinite one
kirsch = {"Constants": {"R": 5, "A": "(1 - 1/R^2)/2", "B": "(1 - 4/R^2 + 3/R^4)/2",
                        "C": "(1 + 2/R^2 - 3/R^4)/2"},
          "Bodies": {"plate": {
              "Material": STEEL,
              "Geometry": {"Vertices": [[0, "-R"], [0, "R"]], "Edges": ["rim", "rim"], **CIRCLE,
                           "Hole 1 Vertices": [[0, -1], [0, 1]], "Hole 1 Edges": ["hole", "hole"],
                           "Hole 1 Bulges": [1, 1]},
              "Boundary Conditions": {"rim": {
                  "Type": "Neumann", "Pressure": "-(A + B*(nx^2 - ny^2))",
                  "Traction X": "2*C*nx*ny*ny", "Traction Y": "-2*C*nx*ny*nx"}},
              "Rigid Motions": {"Fix": ["X", "Y", "Rotation"]}}}}
folder, _ = solved("kirsch", saved("kirsch", kirsch, "Kirsch"))
hole = [point for point in rows(folder, "boundary.csv") if point["boundary"] == "hole"]


def hoop(point):
    return 1 - 2 * (point["x"]**2 - point["y"]**2)


error = largest(point["stress_t"] - hoop(point) for point in hole) / 3
claim(error < 2e-3, "Kirsch's hoop stress on a mesh of the program's: %.1e of 3" % error)
error = largest(point["von_mises"] - math.sqrt(1 - 0.3 + 0.3**2) * abs(hoop(point))
                for point in hole) / 3
claim(error < 2e-3, "and von Mises' in plane strain: %.1e" % error)
file = os.path.join(WORK, "hole.csv")
code, text = epafi("fields", folder, "--along", "plate:hole", "--depth", "0", "--output", file)
points = rows(WORK, "hole.csv")
error = largest(p["sxx"] * p["y"]**2 + p["syy"] * p["x"]**2 - 2 * p["sxy"] * p["x"] * p["y"] - hoop(p)
                for p in points) / 3
claim(code == 0 and len(points) > 20 and error < 2e-3 and
      largest(math.hypot(p["x"], p["y"]) - 1 for p in points) < 1e-12,
      "--depth 0 is on the boundary itself: %.1e %s" % (error, text.strip()[-80:]))
peak = max(point["stress_t"] for point in hole)
claim(differ(peak, 3) < 1e-3, "3 at the hole: %.5f" % peak)

# a traction is a pressure times the normal, less
other = {**kirsch["Bodies"]["plate"], "Boundary Conditions": {"rim": {
    "Type": "Neumann", "Traction X": "(A + B*(nx^2 - ny^2))*nx + 2*C*nx*ny*ny",
    "Traction Y": "(A + B*(nx^2 - ny^2))*ny - 2*C*nx*ny*nx"}}}
again, _ = solved("traction", saved("traction", {**kirsch, "Bodies": {"plate": other}}))
a, b = (rows(each, "history.csv")[-1]["energy_strain"] for each in (folder, again))
claim(differ(a, b) < 1e-12, "Pressure is a traction against the normal")

# a side of two edges that the outline's first vertex parts: s runs from its start
block = {"Material": STEEL, "Geometry": {
    "Vertices": [[0, 0], [1, 0], [1, 1], [-1, 1], [-1, 0]],
    "Edges": ["base", "side", "top", "side", "base"]},
    "Boundary Conditions": {"base": {"Type": "Contact", "Friction": {"Law": "Coulomb",
                                                                    "Coefficient": 0.4}},
                            "top": {"Type": "Neumann", "Traction Y": -1, "Traction X": 0.1}},
    "Rigid Motions": {"Fix": ["X"]}}
folder, _ = solved("seam", saved("seam", {"Bodies": {"block": block},
                                          "Discretization": {"Mesh Size": 0.25}}))
claim(largest(point["s"] - (point["x"] + 1) for point in rows(folder)) < 1e-12,
      "arc lengths begin where a side does")
last = rows(folder, "history.csv")[-1]
claim(differ(last["base.force_y"], 2) < 1e-9 and differ(last["base.force_normal"], 2) < 1e-9 and
      abs(last["base.moment"] + last["load_moment"] + last["reaction_moment"]) < 1e-9 and
      differ(last["base.contact_length"], 2) < 1e-9 and last["base.pressure_max"] > 0.9,
      "history.csv has each contact's force, moment, length and pressure: %s" % {
          name: value for name, value in last.items() if name.startswith("base.")})

# the flank of a dovetail's half has the shear of the whole's flank, twice
whole, _ = solved("dovetail", scene("dovetail.xml"))
last = rows(whole, "history.csv")[-1]
claim(differ(abs(last["left.force_tangential"]), 0.2 * last["left.force_normal"]) < 1e-6,
      "a flank slips all along")
ROOT = [(0, 0), (4.571150438746157, 0), (5.571150438746157, 1), (5.571150438746157, 2.935822227524088),
        (3, 6), (3, 12), (0, 12)]
DISC = [(0, -10), (16, -10), (16, 7), (3.192836282905962, 7), (3.192836282905962, 5.770186667064307),
        (5.828265482620773, 2.6294044502764966), (5.828265482620773, -1), (0, -1)]
STEEL = {"Young's Modulus": 210000, "Poisson's Ratio": 0.3}
half, _ = solved("half a dovetail", saved("half a dovetail", {
    "Geometry": {"Symmetry": "X"},
    "Bodies": {
        "root": {"Material": STEEL, "Geometry": {"Vertices": ROOT, "Edges": [
            "free", "free", "free", "right", "free", "blade", "symmetry"]},
            "Boundary Conditions": {"blade": {"Type": "Neumann", "Traction Y": 100}}},
        "disc": {"Material": STEEL, "Geometry": {"Vertices": DISC, "Edges": [
            "base", "free", "free", "free", "right", "free", "free", "symmetry"]},
            "Boundary Conditions": {"base": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0}}}},
    "Contacts": {"right": {"Between": ["root:right", "disc:right"],
                           "Friction": {"Law": "Coulomb", "Coefficient": 0.2}}},
    "Discretization": {"Degree": 2}}))
image = rows(half, "history.csv")[-1]
claim(all(differ(image["right." + force], 2 * last["right." + force]) < 1e-6
          for force in ("force_normal", "force_tangential")),
      "that of its half has the forces of both: %.6f, %.6f" % (
          image["right.force_normal"], image["right.force_tangential"]))

flanks = [{each.name: each for each in Contacts(Run(folder).contact, numbers, False, mirror).results()
           if each.where == "right"} for folder, numbers, mirror in ((whole, last, "None"), (half, image, "X"))]
claim(differ(flanks[1]["moment"].value, flanks[0]["moment"].value) < 2e-3 and
      "; both halves; " in flanks[1]["width of contact"].remark and "; " not in flanks[0]["width of contact"].remark and
      all(each["width of contact"].remark.startswith("± ") for each in flanks) and
      all(differ(each["safety against slip"].value, 1) < 2e-3 for each in flanks),
      "a report has the moment of the drawn flank: %s" % [each["moment"][2:] for each in flanks])

# a load beyond what friction holds: the capacity, and pictures of what is solved
page = read(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "doc", "howto", "capacity.md")).split("```")
file = os.path.join(WORK, "capacity.yaml")
write(file, page[1].removeprefix("yaml\n"))
folder = fresh("capacity")
code, text = epafi("run", file, "--output", folder)
at = re.search(r"all of 'fit' slips: .* holds at most ([\d.]+), a moment of ([\d.]+)\.  The load may drive it beyond \(step (\d+) of", text)
lame = [((1 + q*q) / (1 - q*q) + sign * nu) / e for q, sign, nu, e in (
    (7.5 / 20, -1, 0.33, 70000), (20 / 30, 1, 0.3, 210000))]
torque = 0.15 * 0.02 / 20 / sum(lame) * 2 * math.pi * 20**2
claim(code == 3 and at and differ(float(at[2]), torque) < 1e-3 and differ(float(at[1]) * 20, torque) < 1e-3 and
      "pivoting" not in text and "displacements reach" not in text and "sliding reaches" not in text,
      "a fit holds %.1f by Lame, and the message says that alone: %s" % (torque, text[text.find("epafi: "):].split("\n")[0]))
claim("is that of the first mesh, not refined yet" in text, "and that its mesh is the first one")
claim(at and all(number in page[2] for number in at.groups()), "the page has these numbers: %s" % (at and at.groups(),))
run = Run(folder)
figure, axes = run.plot("path")
twist, turned = axes[2].get_lines()[0].get_data()
claim(len(twist) == int(at[3]) and max(turned) < torque and "last step that is solved" in figure.texts[0].get_text() and
      max(abs(axes[0].get_lines()[0].get_xdata())) < 2, "the path is drawn up to the last step that is solved: %s" % (
          figure.texts[0].get_text()))
titles = [run.plot("contact", step=step)[0].texts[0].get_text() for step in (None, int(at[3]))]
claim("not solved" not in titles[0] and "not solved" in titles[1],
      "pictures are of what is solved, or say what is not: %s" % titles)
finish()
