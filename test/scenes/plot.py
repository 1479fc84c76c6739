"""Pictures of a run: all of them, in both formats, and clear words where there are none."""
import math
import os
import shutil
import struct
import subprocess
import sys
import xml.etree.ElementTree as xml

import matplotlib
import numpy as np

from epafi.plot import __main__ as plot, inside
from epafi.plot.contact import cut
from epafi.plot.figures import Pictures, plt
from epafi.plot.folder import contact_window, draw_field
from epafi.plot.inside import NAMES as FIELDS
from epafi.runs import Run
from runs import (EPAFI, RANKS, WORK, claim, epafi, fails, finish, fresh, levels, read, rows, run,
                  scene, steps, vtu, write)
from written import (CLAMPED, NONE, block, body, condition, confined, friction, geometry, history,
                     keys, listed, mesh, wear, written)

matplotlib.use("Agg")
PICTURES = ["convergence", "time", "contributions", "mesh", "contact", "deformed"]


def drawn(folder, names, sentence):
    for name in names:
        png, svg = (os.path.join(folder, name + ending) for ending in (".png", ".svg"))
        there = os.path.isfile(png) and os.path.isfile(svg)
        claim(there, "%s: %s.png and .svg" % (sentence, name))
        if not there:
            continue
        with open(png, "rb") as stream:
            claim(stream.read(8) == b"\x89PNG\r\n\x1a\n" and os.path.getsize(png) > 5000,
                  "%s: %s.png is a picture" % (sentence, name))
        claim(xml.parse(svg).getroot().tag.endswith("svg"),
              "%s: %s.svg is a picture" % (sentence, name))


def draw(name, pictures, *options):
    """Claims that a folder's pictures are drawn."""
    text = drawing(os.path.join(WORK, name), "--picture", "all", *options)
    claim(text is None, "%s is drawn: %s" % (name, text))
    drawn(os.path.join(WORK, name), pictures, name)


def drawing(*arguments):
    """What `epafi plot` of these says if it fails, without a start of Python for each."""
    sys.argv = ["plot", *arguments]
    try:
        plot.main()
    except SystemExit as end:
        return str(end)


run(scene("disc.xml"), "disc", levels(2))
code, text = epafi("plot", os.path.join(WORK, "disc"), "--picture", "all")
claim(code == 0, "the disc is drawn: " + text.strip())
drawn(os.path.join(WORK, "disc"), PICTURES, "disc")
figure, (outline, sizes) = Run(os.path.join(WORK, "disc")).plot("mesh")
lengths = [y[0] for line in sizes.get_lines() for y in [line.get_ydata()[k:k + 3] for k in range(
    0, len(line.get_ydata()), 4)] if len(y) == 3]
last = rows("disc", "history.csv")[-1]
claim(len(lengths) == last["elements"] and np.allclose([min(lengths), max(lengths)], [
    last["size_min"], last["size_max"]], rtol=1e-2), "the mesh has the sizes of all its elements: %d, %g to %g" % (
        len(lengths), min(lengths), max(lengths)))

# pictures by name, and no others; those that are usual without a name
folder = os.path.join(WORK, "disc")
for name in PICTURES:
    os.remove(os.path.join(folder, name + ".png"))


def pictures_in(folder):
    return sorted(name[:-4] for name in os.listdir(folder) if name.endswith(".png"))


claim(drawing(folder, "--picture", "mesh", "--picture", "syy") is None and
      pictures_in(folder) == ["mesh", "syy"], "pictures by name: %s" % pictures_in(folder))
claim(drawing(folder) is None and pictures_in(folder) == [
    "contact", "convergence", "deformed", "mesh", "syy"], "the usual: %s" % pictures_in(folder))
claim("'contact'" in (drawing(folder, "--picture", "contacts") or ""), "a name that is none")

# a path, and a window of a field
run(scene("fretting.xml"), "fretting", ["History->Steps={1, 2, 2, 2}"])
LEVELS = ["convergence", "time", "contributions"]
draw("fretting", ["mesh", "contact", "deformed", "path", "steps", "slip", "von_mises"], "--field",
     "von_mises", "--window=-3,0,3,3")
claim(not set(LEVELS) & set(pictures_in(os.path.join(WORK, "fretting"))),
      "no picture of a single level beside others")
fretting = Run(os.path.join(WORK, "fretting"))
figure, axes = fretting.plot("slip")
files = [fretting.step(k + 1) for k in range(fretting.steps.size)]
claim(np.ma.allclose(axes.collections[0].get_array().reshape(len(files), -1), np.ma.array(
    [file["slip"] for file in files], mask=[file["contact"] == 0 for file in files])),
      "the map of slip has that of all steps, where closed")
window = contact_window(fretting.folder, 1)
claim(-2.1 < window[0] < -1.9 and 1.9 < window[2] < 2.1 and fretting.plot("von_mises", window="contact", step=1)[
    1].images[0].get_extent()[0] == window[0], "a window finds the contact: %s" % (window,))
exact = max(inside.on_boundary(fretting.folder, 3)[1]["von_mises"])
titles = [fretting.plot("von_mises", window=window, step=3)[1].get_title() for window in (None, "contact")]
claim(all(title.endswith("to %.3g" % exact) for title in titles),
      "a title ends with the largest value on the boundary, in a window, too: %s, %g" % (titles, exact))
stresses = np.append(np.full(99, 2.0), 1e3), np.append(-1e4, np.full(99, 0.5))
axes = plt.subplots()[1]
cut(axes, [(each, np.ones(100)) for each in stresses])
claim(np.allclose(axes.get_ylim(), (-0.48, 8.48)) and [text.get_text().split()[-1] for text in axes.texts]
      == ["-1e+04", "1e+03"], "what is singular is cut by the rest, on each side: %s" % (
          axes.get_ylim(),))
plt.close("all")

# rigid bodies along a path: a movie, and a collection for ParaView whose files say what they hold
run(scene("tilting-punch.xml"), "punch")
draw("punch", ["mesh", "contact", "deformed", "path", "steps", "rigid", "szz"], "--field", "szz")
words = read(os.path.join(WORK, "punch", "rigid.svg"))
claim("<!-- motion y -->" in words and "<!-- motion x -->" not in words,
      "no panel of a motion that is none")
with open(os.path.join(WORK, "punch", "movie.gif"), "rb") as stream:
    movie = stream.read()
claim(movie[:4] == b"GIF8" and movie.count(b"\x21\xf9\x04") == 6, "a movie of a frame per step")
parts = xml.parse(os.path.join(WORK, "punch", "steps.pvd")).getroot().findall(".//DataSet")
claim([float(part.get("timestep")) for part in parts] ==
      [row["t"] for row in steps("punch")],
      "steps.pvd has the times of the steps")
for part in parts:
    arrays = vtu(os.path.join(WORK, "punch", part.get("file")))
    claim(set(arrays["body"]) == {0, 1}, "%s: both bodies" % part.get("file"))
last = steps("punch")[-1]
ends = arrays["connectivity"][2 * arrays["body"].index(1)]  # a corner of the punch, (-1, 0)
claim(abs(arrays["displacement"][3 * ends + 1] - last["punch.motion_y"] +
          last["punch.rotation"]) < 1e-15, "the punch is where steps.csv says")

# a side that the outline's first vertex parts is drawn in its order, as one
wide = body("foot", geometry([(-1, 0), (1, 0), (3, 1), (-3, 1)], "f, f, top, f"), 10.0,
            condition("f", "Contact", friction("0.5"), Gap="y") +
            condition("top", "Neumann", Traction_Y="-0.01*min(t, 1)", Traction_X="0.001*(t - 1)*(t > 1)"),
            mesh=mesh(4, 2, 1), fix="X, Rotation")
run(written("foot", [wide], NONE, "Density", more=history([1, 2], [1, 1])), "foot solved")
turned = Run(os.path.join(WORK, "foot solved"))
for picture, column in (("contact", "pressure"), ("steps", "pressure"), ("slip", "slip")):
    figure, axes = turned.plot(picture)
    low, high = np.ravel(axes)[0].get_xlim()
    curve = next((line.get_xdata() for line in np.ravel(axes)[0].get_lines() if len(line.get_xdata()) > 9), [low, high])
    side = 2 * math.hypot(2, 1) + 2
    claim((np.diff(curve) > 0).all() and abs((low + high - side) / side) < 0.1 and high - low < 1.1 * side,
          "%s of a side that the first vertex parts: %g to %g of %g" % (picture, low, high, side))
    plt.close(figure)

# paths whose contacts have one name, or names that look like numbers, and one without contact
LOAD = condition("top", "Neumann", Traction_X="0.001*t", Traction_Y="-0.01*min(t, 1)")


def resting(name, left, bottom="Contact"):
    slides = bottom == "Contact"
    return body(name, geometry(block(left, 0, left + 1, 1), "7, right, top, left"), 10.0,
                condition("7", bottom, friction("0.5") if slides else CLAMPED) + LOAD,
                mesh=mesh(4, 2, 1), fix="X, Rotation" if slides else "")


for name, bodies, wanted in (
        ("twins", [resting("a", 0), resting("b", 2)], ["path", "steps"]),
        ("numbers", [resting("1", 0)], ["path", "steps"]),
        ("clamped", [resting("a", 0, "Dirichlet")], ["path"])):
    file = written(name, bodies, NONE, "Density", more=history([1, 2], [1, 2]))
    run(file, name + " solved")
    for other in ("history.csv", "boundary.csv"):  # no pictures of the mesh and of levels
        os.remove(os.path.join(WORK, name + " solved", other))
    claim(drawing(os.path.join(WORK, name + " solved"), "--picture", "all") is None,
          name + " are drawn")
    drawn(os.path.join(WORK, name + " solved"), wanted, name)

# many contacts, of names that are long or that no font has: pictures stay small, and say the rest
row = [resting("%s %d" % ("_$a_{$ \u63a5\u89e6 of a long name, " * 3, k), 2 * k) for k in range(8)]
run(written("row", row, NONE, "Density", more=history([1, 2], [1, 2])), "row solved")
code, text = epafi("plot", os.path.join(WORK, "row solved"), "--picture", "all")
claim(code == 0 and "Warning" not in text, "no warnings of matplotlib: " + text)
for name in ("contact", "path", "steps"):
    with open(os.path.join(WORK, "row solved", name + ".png"), "rb") as stream:
        size = struct.unpack(">2I", stream.read(24)[16:])
    claim(size[0] < 1600 and size[1] < 1000, "%s of many contacts: %d by %d" % (name, *size))
figure, axes = Run(os.path.join(WORK, "row solved")).plot("path")
figure.canvas.draw()
legend, = figure.legends
claim(all(line.get_marker() in ("", "None") for panel in axes for line in panel.get_lines()
          if line.get_linestyle() == "--"), "no markers on dashes")
words = [text.get_text() for text in legend.get_texts()]
claim("not drawn: 2 others" in words and sum("a_{" in word for word in words) == 6 and
      not any(legend.get_window_extent().overlaps(panel.get_window_extent()) for panel in axes),
      "six contacts and a word about the others, below the curves")
run(scene("two-blocks.xml"), "pair", levels(1))
figure, axes = Run(os.path.join(WORK, "pair")).plot("contact")
claim(figure.texts[0].get_text().endswith(": joint (pad:bottom on plate:top)"),
      "a contact has its names in the title: " + figure.texts[0].get_text())
# where sides that wear and yield touch, u_n is what they may: the gap and what both give way
run(confined("worn", wear(2) + listed("Normal", Law="Linear", Compliance=0.5) + keys(
    Sliding="max(0, t - 1)"), "-0.01*min(t, 1)", more=history([1, 3], [1, 2])), "worn solved")
figure, axes = Run(os.path.join(WORK, "worn solved")).plot("contact", step=3)
curves = {line.get_label(): line.get_ydata() for line in np.ravel(axes)[1].get_lines()}
claim(np.allclose(curves["gap + closing + wear"], curves["normal displacement $u_n$"], 1e-9) and
      not curves["gap as drawn"].any(), "worn sides touch where they may: %s" % list(curves))
plt.close("all")

# what was drawn of one solution does not stay beside another one; other files do
folder = os.path.join(WORK, "punch")
code, text = epafi("fields", folder, "--grid", "5,5")
pictures = Pictures(folder)
plane = [field for field in FIELDS if field != "hoop"]
with plt.rc_context(pictures.looks.style()):
    for field in plane:
        draw_field(field, os.path.join(folder, "fields.vtu"), pictures)
drawn(folder, plane, "inside")
for name in ("mine.png", "sweep_contact_a.svg"):
    shutil.copy(os.path.join(folder, "path.png"), os.path.join(folder, name))
fails("they are the run's", ["--force"], "run", scene("patch.xml"), "--output", folder)
code, text = epafi("run", scene("patch.xml"), "--output", folder, "--force")
new = fresh("patch")
epafi("run", scene("patch.xml"), "--output", new)
claim(code == 0 and sorted(os.listdir(folder)) == sorted(
    os.listdir(new) + ["mine.png", "sweep_contact_a.svg"]),
      "--force leaves no picture and no field: " + " ".join(sorted(os.listdir(folder))))

run(scene("tresca.xml"), "tresca", levels(3))
points = rows("tresca", "boundary.csv")
claim(points[-1]["element"] == 63 and {point["degree"] for point in points} == {1},
      "boundary.csv names each point's element and degree")
claim({point["boundary"] for point in points} ==
      {"foundation", "right", "clamp", "top", "press", "left"}, "and its boundary")

run(scene("patch.xml"), "one", ["Adaptivity->Strategy=None"])  # a single level
drawing(os.path.join(WORK, "one"), "--picture", "all")
drawn(os.path.join(WORK, "one"), ["mesh", "contact", "deformed"], "one")
claim(not set(LEVELS) & set(pictures_in(os.path.join(WORK, "one"))), "of a single level no others")

# looks: exact sizes, formats, units, no titles; and a page with all of it
folder = os.path.join(WORK, "tresca")
code, text = epafi("report", folder, "--size", "5,3", "--dpi", "100", "--font", "8", "--pdf", "--no-title",
                   "--units", "mm,MPa")
claim(code == 0, "a report with looks of one's own: " + text.strip())
for name in PICTURES:
    with open(os.path.join(folder, name + ".png"), "rb") as stream:
        size = struct.unpack(">2I", stream.read(24)[16:])
    with open(os.path.join(folder, name + ".pdf"), "rb") as stream:
        claim(size == (500, 300) and stream.read(5) == b"%PDF-",
              "%s is 5 by 3 inches, and a PDF: %s" % (name, size))
with open(os.path.join(folder, "contact.svg")) as stream:
    words = stream.read()  # matplotlib writes each text as a comment
claim(all(word in words for word in ("contact stress", "[MPa]", "x [mm]")) and
      "Tresca block" not in words, "labels have units, and there is no title")


# a column of a paper: all words within it, and room for what is drawn
for name, picture in [*(("fretting", name) for name in (
        "mesh", "contact", "deformed", "path", "steps", "slip")),
                      ("tresca", "mesh"), ("tresca", "von_mises")]:
    figure, axes = Run(os.path.join(WORK, name)).plot(picture, size=(3.4, 2.6), font=8, title=False,
                                                      units="mm,MPa")
    figure.canvas.draw()
    words = figure.get_tightbbox()
    panels = [panel.get_window_extent().size / figure.dpi for panel in np.ravel(axes)]
    marks = [[label.get_window_extent() for label in panel.get_xticklabels() if label.get_text()]
             for panel in np.ravel(axes)]
    claim(min(*words.min, *(figure.get_size_inches() - words.max)) > -0.02 and
          min(width for width, _ in panels) > (0.6 if len(panels) > 1 else 1.5) and
          not any(a.overlaps(b) for row in marks for a, b in zip(row, row[1:])),
          "%s of %s in 3.4 by 2.6 inches: words in %s, axes %s" % (
              picture, name, words.extents.round(2), np.round(panels, 2).tolist()))
    plt.close(figure)


for option, value in (("--size", "5"), ("--size", "0,3"), ("--dpi", "many"), ("--font", "-1"), ("--units", "mm")):
    claim(option in (drawing(folder, option, value) or ""), "%s %s is refused" % (option, value))

page = read(os.path.join(folder, "report.html"))
claim(code == 0 and page.count('src="data:image/') >= len(PICTURES) + 2 and
      page.count("src=") == page.count('src="data:') and "http" not in page.replace(
          "http://www.w3.org", ""), "a report that needs no other file: " + text.strip())
claim(all(word in page for word in ("Tresca block", "Young&#x27;s Modulus", "Trilinos",
                                    "converged", "reaction")),
      "it has the scene, numbers, the balance and versions")
balances = [float(row.rsplit("<td>", 1)[1].split("<")[0]) for row in page.split('id="balance"')[1].split(
    "</table>")[0].split("</tr>")[1:-1]]
claim("Stress intensities" in page and "exponent" in page, "it has the stress intensities")
claim(len(balances) == 3 and max(map(abs, balances)) < 1e-9, "what acts is balanced: %s" % balances)
fails("a folder without a run has none", ["history.csv"], "report", WORK)
for page, words in (("nodir/r.html", "no folder 'nodir'"), ("-", "is a file")):
    claim(words in (drawing(folder, "--report", "--output", page) or ""), "no report into " + page)

file = os.path.join(WORK, "sides.svg")
code, text = epafi("check", scene("two-blocks.xml"), "--plot", file)
words = read(file)
claim(code == 0 and "top (joint)" in words and "bottom (joint)" in words,
      "both sides of a contact are named in the scene's picture")

half = body("block", geometry(block(0, 0, 1, 1), "a, b, c, any"), 1, fix="Y")
code, text = epafi("check", written("half", [half], more=listed("Geometry", Symmetry="X")),
                   "--plot", file)
claim(code == 0 and read(file).count("<!-- symmetry -->") == 1 and "Dirichlet" not in read(file),
      "the line of symmetry is in the legend alone")

code, text = epafi("check", scene("indenter.xml"), "--plot", file)
words = read(file)
claim(code == 0 and "<!-- axis -->" in words and "symmetry" not in words,
      "around an axis the legend has the axis")
for name, told in (("heap", "left post, right post, lintel, table: Gravity X = "), ("shrink-fit", "Fix = {X, Y, Rotation}"),
                   ("tilting-punch", "punch: Force Y = ")):
    code, text = epafi("check", scene(name + ".xml"), "--plot", file)
    claim(code == 0 and told in read(file), "what acts on all of a body is in the scene's picture: " + told)

for name in ("tresca", "disc"):
    file = os.path.join(WORK, name + "-scene.png")
    code, text = epafi("check", scene(name + ".xml"), "--plot", file)
    claim(code == 0 and os.path.getsize(file) > 5000 and not os.path.exists(file + ".csv.part"),
          "the scene %s is drawn before it is solved" % name)
# a program without its plotting: nothing is left behind.  On ranks EPAFI is a script around it
if RANKS == 1:
    os.makedirs(os.path.join(WORK, "bare"), exist_ok=True)
    bare = shutil.copy(EPAFI, os.path.join(WORK, "bare", "epafi"))
    done = subprocess.run([bare, "check", scene("disc.xml"), "--plot", os.path.join(WORK, "no.png")],
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    claim(done.returncode == 1 and "missing" in done.stderr and
          not os.path.exists(os.path.join(WORK, "no.png.csv.part")),
          "a program without its plotting leaves nothing: " + done.stderr.strip())
fails("a picture that cannot be written", ["/nowhere"], "check", scene("disc.xml"), "--plot",
      "/nowhere/disc.png")
for window, words in [("3,0,-3,3", "X0,Y0,X1,Y1"), ("1,2", "X0,Y0,X1,Y1"),
                      ("100,0,101,1", "shows nothing")]:
    claim(words in (drawing(os.path.join(WORK, "one"), "--field", "syy", "--window", window) or ""),
          "the window %s is refused" % window)
for arguments, words, sentence in [
        ([], ["no folder is given"], "no folder"),
        ([os.path.join(WORK, "nowhere")], ["no folder", "nowhere"], "a missing folder"),
        (["--help-me"], ["unknown option"], "an option")]:
    fails(sentence, words, "plot", *arguments)
empty = fresh("empty")
os.makedirs(empty)
claim("history.csv" in drawing(empty), "an empty folder is refused, with what was sought")
damaged = fresh("damaged")
os.makedirs(damaged)
write(os.path.join(damaged, "contact.csv"), "boundary,x\nfoundation,1\n")
code, text = epafi("plot", damaged)
claim(code == 1 and text.startswith("epafi: plot: the files in") and text.strip() == drawing(damaged),
      "a damaged file is named: " + text)
whole = os.path.join(WORK, "one")
for name, content in (("contact.csv", "garbage"), ("history.csv", ""), ("boundary.csv", "x,\xe4\n")):
    shutil.copytree(whole, fresh("damaged"))
    with open(os.path.join(damaged, name), "w", encoding="latin-1") as stream:
        stream.write(content)
    claim("'%s' cannot be read" % name in drawing(damaged), "it is named")
finish()
