"""doc/gallery.md: each shipped scene with its picture, its command and a number, and doc/verification.md:
those with a closed form.  The numbers of the pages are those of the scenes, closed forms are met; quick
scenes, or all.

    gallery.py EPAFI SCENES WORK [all]       checks
    gallery.py EPAFI SCENES WORK write       writes the pages' tables, and the pictures
    gallery.py EPAFI SCENES WORK numbers     writes the tables alone
"""
import math
import os
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml

from runs import EPAFI, SCENES, claim, finish, read, rows, solved, write

DOC = os.path.join(SCENES, "..", "..", "doc")
PAGE = os.path.join(DOC, "gallery.md")
VERIFICATION = os.path.join(DOC, "verification.md")
CASES = []


def case(name, number, value, exact=None, picture="contact", quick=True):
    """`value` of the folder; `exact`: a closed form."""
    CASES.append((name, number, value, exact, picture, quick))


def history(column):
    return lambda folder: rows(folder, "history.csv")[-1][column]


def steps(column, t):
    return lambda folder: next(row[column] for row in reversed(rows(folder, "steps.csv"))
                               if abs(row["t"] - t) < 1e-9)


def peak(folder):
    return max(point["pressure"] for point in rows(folder))


def pressure_at(x):
    def nearest(folder):
        before, behind = sorted(sorted(rows(folder), key=lambda p: abs(p["x"] - x))[:2],
                                key=lambda p: p["x"])
        share = (x - before["x"]) / (behind["x"] - before["x"])
        return before["pressure"] + share * (behind["pressure"] - before["pressure"])
    return nearest


def mean_pressure(folder):
    last = rows(folder, "history.csv")[-1]
    return last["force_normal"] / last["contact_length"]


def inside(column, row=0):
    return lambda folder: rows(folder, "interior.csv")[row][column]


def amplitude(folder):
    pressures = [point["pressure"] for point in rows(folder)]
    return (max(pressures) - min(pressures)) / 2


def sticking(folder):
    at, slips = (steps("indent." + column, 1)(folder) for column in ("contact_length", "slip_length"))
    return 1 - slips / at


def creep(folder):
    last, before = (rows(folder, "steps.csv")[k] for k in (-1, -5))
    speed = (last["slab.motion_x"] - before["slab.motion_x"]) / (last["t"] - before["t"])
    return abs(speed) * 1000 / 0.3


case("blade-root", "force of a flank at half the speed, down", steps("left.force_normal", 1.5),
     469.9, quick=False)
case("bonded-inclusion", "σ_xx inside", inside("sxx"), 1.178169078526, "sxx")
case("coulomb", "force_normal", history("force_normal"), 0.125, "von_mises")
case("cylinder-on-block", "largest pressure", peak, 0.5494505495, quick=False)
case("disc", "largest pressure", peak, 10.989010989)
case("dovetail", "force_normal", history("force_normal"), 753.7721601, "von_mises")
case("flange", "force_normal", history("force_normal"), 39893.80702, "von_mises")
case("fretting-wear", "friction's work", history("energy_friction"), None, "steps", False)
case("fretting", "friction's work", history("energy_friction"), None, "slip", False)
case("gasket", "largest pressure", peak)
case("heap", "length that slips", history("slip_length"), None, "deformed")
case("hertz", "largest pressure", peak, 5.4945054945)
case("hot-hub", "force_normal at 8000/s", steps("fit.force_normal", 3), None, "hoop")
case("hot-sleeve", "friction's work", history("energy_friction"), None, "hoop")
case("hot-tube", "hoop stress inside", inside("syy"), -220.314893, "von_mises")
case("hub-on-shaft", "force_normal", history("force_normal"), 101289.43104, "hoop")
case("incline", "force over weight", lambda folder: abs(rows(
    folder, "bodies.csv")[-1]["reaction_x"]) / 0.01, 0.4 / 0.97)
case("indenter", "radius that sticks over that of contact", sticking, 0.6983, "von_mises", False)
case("lap-joint", "friction's work", history("energy_friction"), None, "slip", False)
case("o-ring", "largest pressure", peak, None, "von_mises", False)
case("patch", "pressure", peak, 1)
case("press-fit", "pressure", peak, 6.15234375, "von_mises")
case("punch", "pressure in the middle", pressure_at(0), 1 / math.pi)
case("ring-on-disc", "amplitude of the pressure", amplitude, 1.479262672811)
case("rolling", "creep", creep, 0.4, "slip", False)
case("rotating-fit", "pressure at 3000/s", peak, 13.6807031, "path")
case("rough", "mean pressure", mean_pressure)
case("rounded-punch", "pressure in the middle", pressure_at(0), 1.359703)
case("shrink-fit", "mean pressure, cold", mean_pressure, 49.21875, "von_mises")
case("spheres", "largest pressure", peak, 699.5821675, "von_mises")
case("spinning-disc", "hoop stress in the middle", inside("hoop"), 129.8165714, "hoop")
case("there-and-back", "friction's work", history("energy_friction"), None, "steps")
case("tilting-punch", "length in contact", history("contact_length"), 1.2)
case("tresca", "strain energy", history("energy_strain"), None, "von_mises")
case("turning-hub", "force_normal, found again", steps("fit.force_normal", 2), 101289.43104, "path")
case("two-blocks", "length that slips", history("slip_length"), None, "von_mises")
case("two-cylinders", "largest pressure", peak, 3.048780488, quick=False)


# Of each closed form: whose, what, and what it leaves out; "": nothing, the difference is the mesh's.
FORMS = {
    "blade-root": ("balance of forces", "R/(2 (cos 50° - f sin 50°)), R = pull and centrifugal force of the root", ""),
    "bonded-inclusion": ("Muskhelishvili", "q + s, uniform in the inclusion", ""),
    "coulomb": ("balance of forces", "the vertical load", ""),
    "cylinder-on-block": ("Cattaneo, Mindlin", "p₀ = 2P/(πa)", "half-planes, a/R = 0.002"),
    "disc": ("Hertz", "p₀ = E* a/(2R)", "half-planes, a/R = 0.02"),
    "dovetail": ("balance of forces", "2N, N (cos 50° + f sin 50°) = 300", ""),
    "flange": ("balance of forces", "bolts - π r² p", ""),
    "hertz": ("Hertz", "p₀ = E*/(2R)", "a half-plane; the block is 20 a wide"),
    "hot-tube": ("Timoshenko", "T = 100 ln(20/r)/ln 2", "just below the surface"),
    "hub-on-shaft": ("extrapolated", "an independent program's 2.41165312e-3, times E size²", ""),
    "incline": ("balance of forces", "(tan α + f)/(1 - f tan α)", ""),
    "indenter": ("Spence", "c/a of growing loads, by f and ν", "a half-space; the steps of the path"),
    "patch": ("uniform stress", "q", ""),
    "press-fit": ("Lamé", "δE/(2r) (r² - rᵢ²)(rₒ² - r²)/(r² (rₒ² - rᵢ²))", ""),
    "punch": ("Sadowsky", "P/(π √(a² - x²))", "a half-plane; the block is 40 a wide"),
    "ring-on-disc": ("Michell", "Fourier series of ring and disc", "the largest sample for the peak"),
    "rolling": ("Carter", "a' = 0.6 a: (a - a')/a", "elements of a/16, creep of the last steps"),
    "rotating-fit": ("Lamé", "(δ - S ω²)/C", ""),
    "rounded-punch": ("Ciavarella, Hills, Monno", "0.8058354 P/(2a)", "a half-plane; the block is 40 a wide"),
    "shrink-fit": ("Lamé", "δ/C", ""),
    "spheres": ("Hertz", "p₀ = (6 P E*²/(π³ R²))^(1/3)", "half-spaces"),
    "spinning-disc": ("Love", "ρω²((3+ν)R²/8 + ν(1+ν)h²/(24(1-ν)))", "stresses of the rim, far from the middle"),
    "tilting-punch": ("Sadowsky", "2c = 4 (a - e)", "ends at a node"),
    "turning-hub": ("extrapolated", "that of the hub on a shaft", ""),
    "two-cylinders": ("Hertz", "p₀ = 2P/(πa)", "half-planes, a/R = 0.0075"),
}


def told(value):
    return "%.6g" % value


def row_of(name, title, number, value, exact, picture):
    error = "" if exact is None else "%.1e" % abs(value / exact - 1)
    return "| %s<br>[%s.xml](../drivers/scenes/%s.xml) | ![%s](images/gallery/%s.png) | %s | %s | %s | %s |" % (
        title, name, name, title, name, number, told(value),
        "" if exact is None else "%.10g" % exact, error)


def verified(name, title, number, value, exact, row):
    """A row of the other page."""
    author, form, without = FORMS[name]
    return "| [%s](../drivers/scenes/%s.xml) | %s | %s: %s | %.10g | %.10g | %.1e | %d | %s |" % (
        title, name, number, author, form, exact, value, abs(value / exact - 1), row["dof"], without)


def numbers_of(line):
    return [cell.strip() for cell in line.split("|")[4:6]]


if __name__ == "__main__":
    how = sys.argv[4] if len(sys.argv) > 4 else ""
    shipped = sorted(name[:-4] for name in os.listdir(SCENES) if name.endswith(".xml"))
    claim(shipped == sorted(name for name, *_ in CASES), "each shipped scene is in the gallery")
    page = read(PAGE)
    lines = {re.search(r"\[([\w-]+)\.xml\]", line)[1]: line for line in page.split("\n")
             if line.startswith("| ") and ".xml](" in line}
    claim(sorted(FORMS) == sorted(name for name, _, _, exact, _, _ in CASES if exact is not None),
          "each closed form is named")
    for name in FORMS:
        claim("%s.xml)" % name in read(VERIFICATION), "%s is verified" % name)
    made, forms = [], []
    for name, number, value, exact, picture, quick in CASES:
        if not (quick or how):
            continue
        folder, _ = solved(name, os.path.join(SCENES, name + ".xml"))
        found = value(folder)
        if how in ("write", "numbers"):
            title = xml.parse(os.path.join(folder, "used.xml")).getroot().get("name")
            if how == "write":
                subprocess.run([EPAFI, "plot", folder, "--picture", picture, "--size", "5,3.2", "--dpi", "70",
                                "--font", "8"], check=True, stdout=subprocess.DEVNULL)
                shutil.copy(os.path.join(folder, picture + ".png"),
                            os.path.join(DOC, "images", "gallery", name + ".png"))
            made.append(row_of(name, title, number, found, exact, picture))
            if exact is not None:
                forms.append(verified(name, title, number, found, exact, rows(folder, "history.csv")[-1]))
            continue
        shown, form = numbers_of(lines[name])
        claim(math.isclose(float(shown), found, rel_tol=1e-3), "%s: %s is %s, the page says %s" % (
            name, number, told(found), shown))
        claim((form == "") == (exact is None) and (
            exact is None or math.isclose(float(form), exact, rel_tol=1e-9)), name + ": its closed form")
        claim(os.path.isfile(os.path.join(DOC, "images", "gallery", name + ".png")), "and its picture")
    if how in ("write", "numbers"):
        head = read(VERIFICATION)
        write(VERIFICATION, head[:head.index("| scene")] + "\n".join([
            "| scene | quantity | closed form | its value | computed | relative difference | unknowns | left out |",
            "|---|---|---|---|---|---|---|---|", *forms]) + "\n")
        head = page[:page.index("| scene")]
        write(PAGE, head + "\n".join([
            "| scene | picture | number | computed | closed form | relative difference |",
            "|---|---|---|---|---|---|", *made]) + "\n")
    finish()
