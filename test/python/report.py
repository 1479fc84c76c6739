"""The report of a run: its key results against closed forms, numbers without rounding, units, options.

    report.py EPAFI WORK
"""
import math
import os
import re
import subprocess
import sys
import warnings

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish, read  # noqa: E402

EPAFI, WORK = sys.argv[1], absent(sys.argv[2])
import epafi  # noqa: E402
from epafi.plot.figures import Looks, units_of  # noqa: E402
from epafi.plot.results import Contacts, settled  # noqa: E402

warnings.simplefilter("ignore", epafi.EpafiWarning)
SHIPPED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "drivers", "scenes")


def near(found, expected, bound=1e-3):
    return abs(found - expected) <= bound * abs(expected)


def results(run, step=None, revolves=False):
    """{name: result}, of the only contact."""
    table = run.history if step is None else run.steps
    row = -1 if step is None else np.flatnonzero(table["step"] == step)[-1]
    found = list(Contacts(run.contact if step is None else run.step(step), {
        name: table[name][row] for name in table}, revolves).results())
    claim(len({each.where for each in found}) == 1, "results of %s" % found[0].where)
    return {each.name: each for each in found}


# Cattaneo's and Mindlin's cylinder: a = 1, p0 = 0.005, P = pi/400, Q = 0.5 f P
fretting = epafi.run(os.path.join(SHIPPED, "fretting.xml"), os.path.join(WORK, "fretting"), threads=1, set={
    "History->Steps": [1, 2, 2, 2], "Output->Units": {"Length": "mm", "Stress": "MPa"}})
found = results(fretting, 3)
claim(near(found["largest pressure"].value, 0.005) and "at (" in found["largest pressure"].remark and
      near(found["width of contact"].value, 2, 3e-3) and near(found["normal force"].value, math.pi / 400),
      "pressure, width and force are those of Hertz: %s" % found["largest pressure"].remark)
claim(near(abs(found["tangential force"].value), math.pi / 1600, 2e-3) and
      near(found["safety against slip"].value, 2, 2e-3), "friction could hold twice the push")
slips = float(re.search(r"([\d.]+) % of it slips", found["safety against slip"].remark)[1])
claim(near(slips, 100 * (1 - math.sqrt(0.5)), 0.03), "%g %% slips, exactly 29.3" % slips)
pressed = results(fretting, 1)["safety against slip"]
claim(math.isinf(pressed.value) and "no tangential force" in pressed.remark,
      "pressed alone nothing could slip: %s" % pressed.remark)
slides = {"slip_length": 2, "contact_length": 2, "force_tangential": 0}
(_, value, _, words), = Contacts._slip(slides, {"bound": np.ones(2), "shear": np.array([1, -1])}, np.ones(2))
claim(math.isnan(value) and words == "no tangential force; all of it slips",
      "what slips to both sides is at its limit, not safe without one: %s" % words)
claim("moment" not in found, "no moment about the middle, where there is none")

# a punch under a force beside its middle, at 0.7
punch = results(epafi.run(os.path.join(SHIPPED, "tilting-punch.xml"), threads=1))
claim(near(abs(punch["moment"].value), 0.7 * punch["normal force"].value, 1e-6) and
      "about (0, 0)" in punch["moment"].remark and "no bound" in punch["largest pressure"].remark and
      "safety against slip" not in punch and "tangential force" not in punch,
      "a force beside the middle is a moment about it: %s" % punch["moment"].remark)
# a whole revolution: Hertz' spheres of radius 50 pushed together
spheres = results(epafi.run(os.path.join(SHIPPED, "spheres.xml"), threads=1), revolves=True)
claim(near(spheres["normal force"].value * 3 / 2 / math.pi / spheres["width of contact"].value ** 2,
           spheres["largest pressure"].value, 0.02) and "moment" not in spheres,
      "p0 = 3 P / (2 pi a^2), of balls")

# what is rounding beside others of its kind
table = {"a.force_x": np.array([1.0, 2.0]), "b.force_normal": np.array([-4.3e-19, 3.0]),
         "moment": np.array([1e-13, -5.0]), "a.moment": np.array([2e-11, 1e-3]),
         "energy_strain": np.array([1e-18, 1e-17]), "status": np.array(["converged"] * 2),
         "k": np.array([np.nan, np.inf])}
clean = settled(table, length=10)
claim(list(clean["b.force_normal"]) == [0, 3] and list(clean["moment"]) == [0, -5] and
      list(clean["a.moment"]) == [0, 1e-3] and list(clean["energy_strain"]) == [1e-18, 1e-17] and
      list(clean["status"]) == ["converged"] * 2 and list(clean["k"])[1] == np.inf,
      "rounding is 0, small numbers by themselves are none: %s" % clean)

# units
claim(units_of(fretting.folder) == ("mm", "MPa") and
      fretting.plot("contact")[1][0].get_ylabel() == "contact stress [MPa]" and
      fretting.plot("contact", units="m,Pa")[1][0].get_ylabel() == "contact stress [Pa]",
      "labels have the scene's units, or those that are asked for")
for units, quantity, revolves, text in (
        ("mm,MPa", "force", False, "N/mm"), ("mm,MPa", "force", True, "N"), ("m,kPa", "energy", True, "kN m"),
        ("mm,MPa", "energy", False, "N mm/mm"), ("cm,bar", "force", False, "cm bar"),
        ("cm,bar", "energy", True, "cm^3 bar"), (None, "force", False, ""), (("mm", ""), "stress", False, ""),
        (("mm", ""), "length", False, "mm"), ("mm,MPa", "", False, "")):
    claim(Looks(units=units).unit(quantity, revolves) == text, "%s of %s: %r" % (quantity, units, text))
claim(Looks(units="cm,bar").label("work", "energy") == "work [cm$^2$ bar]", "powers in pictures")

# a page
done = subprocess.run([EPAFI, "report", fretting.folder, "--step", "2", "--window", "contact", "--output",
                       os.path.join(WORK, "page.html")], text=True, capture_output=True)
page = read(os.path.join(WORK, "page.html"))
words = re.sub(r"<pre>.*?</pre>|<[^>]*>", " ", page, flags=re.S)
claim(done.returncode == 0 and "after 1 level;" in words and "t = 1.5, step 2 of 7" in words and
      "the window" in words, "a report of a step, and of a window " + done.stderr)
claim("0.005 MPa" in words and "0.007854 N/mm" in words and "what friction can hold" in words, "with units")
claim(not re.search(r"\bnan\b|1 levels|e-1[5-9]|e-2\d", words), "without rounding and nan")
claim("--window=contact --step=2" in words and "used.xml" in words and re.search(r"solved +20\d\d-\d\d-\d\d", words) and "Trilinos" in words,
      "command, date and versions")
order = re.findall(r'<h2 id="([a-z-]*)">', page)
claim(order[0] == "results" and order == re.findall(r'href="#([a-z-]*)"', page),
      "results first, and a link to each part: %s" % order)
finish()
