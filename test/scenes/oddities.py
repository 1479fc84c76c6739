"""What a scene probably does not mean is said and solved all the same; encodings; memory that is
foretold."""
import math
import os
import subprocess

from runs import (EPAFI, SCENES, WORK, changed, claim, epafi, fails, finish, fresh, levels, options,
                  read, refused, rows, run, scene, table, write)
from written import (CLAMPED, NONE, QUARTERS, block, body, circle, condition, contact, disc,
                     geometry, history, listed, mesh, with_more, written)

SETTINGS = ["Adaptivity->Maximum Levels=1"]
SHORT = {"fretting.xml": ["History->Times={1, 2}", "History->Steps={1, 1}"],
         "rough.xml": ["Adaptivity->Tolerance="],  # which a level misses
         **{name + ".xml": ["Adaptivity->Maximum Levels=20"]
            for name in ("spheres", "hub-on-shaft", "o-ring", "indenter", "spinning-disc", "hot-hub",
                         "hot-sleeve", "turning-hub", "flange")}}
HARD = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "hard", "scenes")
CONDITIONS = "Bodies->block->Boundary Conditions->"


def told(file, name, settings=()):
    """Exit code and warnings, without that of a mesh which is coarse on purpose."""
    code, text = epafi("run", file, "--output", fresh(name), settings=[*SETTINGS, *settings])
    return code, [line for line in text.splitlines() if line.startswith("epafi: warning: ")
                  and "take a finer mesh, or Adaptivity->Tolerance = 0.01" not in line]


for name in sorted(os.listdir(SCENES)):
    code, warnings = told(scene(name), name, SHORT.get(name, []))
    claim(code == 0 and not warnings, name + " is shipped without warnings: %s" % warnings)

PUSHED = CONDITIONS + "top={Type=Dirichlet, Displacement X=0, Displacement Y=-0.4}"
SLID = CONDITIONS + "top={Type=Dirichlet, Displacement X=0.12, Displacement Y=-0.01}"
SMOOTH = CONDITIONS + "foundation->Friction={Law=None}"
HELD = "Bodies->block->Rigid Motions="
FIXED = "Bodies->block->Rigid Motions={Fix={X, Y, Rotation}}"
FREE = CONDITIONS + "top={Type=Neumann}"
for sentence, settings, words in [
        ("no load", [FREE, CONDITIONS + "side={Type=Neumann}"], "nothing loads the scene"),
        ("a load that pulls", [CONDITIONS + "side={Type=Neumann}", CONDITIONS +
                               "top={Type=Dirichlet, Displacement X=0, Displacement Y=0.01}", HELD], "contact never closes"),
        ("a load beyond all bounds",
         [PUSHED, HELD], "% of the body's size"),
        ("a path without t", ["History->Times={1, 2}"], "no expression uses t"),
        ("a corner that two sides move apart",
         [CONDITIONS + "top={Type=Dirichlet, Displacement X=0, Displacement Y=-0.001}",
          CONDITIONS + "side={Type=Dirichlet, Displacement X=1e-4*(x > 0)}", HELD], "of their corner ("),
        ("loads that are nothing beside Young's modulus",
         ["Bodies->block->Material->Young's Modulus=1e300",
          "Discretization->Stabilization->Gamma0=1e-304"], "too small for a number"),
        ("a constant that none uses", ["Constants->tpo=1"], "Constants->tpo = 1 is in no expression")]:
    code, warnings = told(scene("coulomb.xml"), "odd", settings)
    claim(code == 0 and len(warnings) == 1 and words in warnings[0],
          "%s: %s" % (sentence, warnings))
code, warnings = told(scene("o-ring.xml"), "lifted", ["Bodies->lid->Motion->Displacement Y=0.1"])
claim(code == 0 and len(warnings) == 1 and "contact never closes" in warnings[0],
      "a lid that moves away: %s" % warnings)
SIDE = CONDITIONS + "side={Type=Dirichlet, Displacement X=%s, Displacement Y=%s}"
TOP = CONDITIONS + "top={Type=Neumann, Traction Y=-100*%s}"
for sentence, setting, *words in [
        ("a load between the points of a rule", TOP % "(abs(x - 0.0612) < 0.001)",
         "->top: the traction is narrower"),
        ("one that is there half way along a path alone",
         TOP % "t*(1 - t)*(abs(x - 0.0612) < 0.001)", "->top: the traction is narrower"),
        ("a wide one", TOP % "(abs(x - 0.0612) < 0.07)"),
        ("a side that is pushed through an obstacle at both of its corners", SIDE % (0, "-0.01"),
         "'side' moves its corner with 'foundation'"),
        ("one that is pulled away", SIDE % (0, "0.01")),
        ("one that touches but for rounding", SIDE % (0, "-0.01*sin(pi)")),
        ("a side whose displacement jumps between its ends", SIDE % ("1e-3*y + 1e-5*(y > 0.13)", 0),
         "->side->Displacement X: jumps by"),
        ("one that jumps where its expression has a value between", SIDE % ("1e-4*sign(y)", 0),
         "->side->Displacement X: jumps by"),
        ("a displacement that is steep", SIDE % ("1e-4*tanh(1e7*(y - 0.13))", 0)),
        ("one of unbounded slope", SIDE % ("1e-4*sqrt(abs(y - 0.13))", 0))]:
    code, text = epafi("check", scene("coulomb.xml"), settings=[
        setting, FIXED if "top" in setting else HELD, *["History->Times={0.5, 1}"] * ("t*(" in setting)])
    warnings = [line for line in text.splitlines() if line.startswith("warning: ")]
    claim(code == 0 and len(warnings) == len(words) and all(
        word in line for word, line in zip(words, warnings)), "%s: %s" % (sentence, warnings))
# what follows the normal jumps where edges of one boundary meet, not where they are one curve
for sentence, outline, x, y, jumps in [
        ("nx and ny", geometry(block(0, 0, 1, 1), ["side"] * 4), "0.01*nx", "0.01*ny", "XY"),
        ("ny along x", geometry(block(0, 0, 1, 1), ["side"] * 4), "0.01*ny", 0, "X"),
        ("normals of a disc", disc(1, "side"), "0.01*nx", "0.01*ny", ""),
        ("a function of place", geometry(block(0, 0, 1, 1), ["side"] * 4), "0.01*sqrt(x)", "y/99", "")]:
    text = with_more(body("b", outline, 1, condition(
        "side", "Dirichlet", Displacement_X=x, Displacement_Y=y)), listed(
            "Thermal Conditions", side={"Temperature": "5 + 1e3*" + x}), Thermal_Expansion=1e-6)
    code, said = epafi("check", written("normal", [text], form="Density"))
    warnings = [line for line in said.splitlines() if line.startswith("warning: ")]
    words = ["->side->Displacement %s: jumps by" % axis for axis in jumps] + [
        "->Thermal Conditions->side->Temperature: jumps by"] * bool(jumps)
    claim(code == 0 and len(warnings) == len(words) and all(
        word in line for word, line in zip(words, warnings)), "%s: %s" % (sentence, warnings))
for sentence, file, setting, words in [
        ("an unstable pair", "coulomb.xml", "Discretization->Stabilization={Form=None}",
         "stable with Multiplier 'Biorthogonal' only"),
        ("a stiff side that carries the multiplier", "two-blocks.xml",
         "Bodies->pad->Material->Young's Modulus=1e8", "name the softer one first")]:
    code, text = epafi("check", scene(file), "--set", setting)
    claim(code == 0 and words in text, sentence)
PLATE = body("plate", block(0, 0, 4, 1), 1, condition(
    "bottom", "Dirichlet", CLAMPED) + condition("top", "Neumann", Traction_Y=-1e-3))
for depth, count in ((0.05, 1), (0.008, 0)):
    code, warnings = told(written("apart", [PLATE, body("pad", block(1, 1.01, 2, 2), 1, condition(
        "top", "Dirichlet", Displacement_X=0, Displacement_Y=-depth))], form="Density"), "apart")
    claim(code == 0 and len(warnings) == count and all(
        "'plate' and 'pad', deformed, overlap" in line for line in warnings),
          "a pad without a contact, %g down: %s" % (depth, warnings))
# what happens on the way of a path counts as its end does
code, warnings = told(written("back", [body("block", block(-1, 0, 1, 1), 100, condition(
    "bottom", "Dirichlet", CLAMPED) + condition("top", "Dirichlet", Displacement_X="0.8*sin(pi*t)",
                                                Displacement_Y=0))], form="Density",
                              more=history([0.5, 1], [1, 1])), "back")
claim(code == 0 and any("displacements reach 36 %" in line for line in warnings),
      "there and back: %s" % warnings)
code, warnings = told(written("apart", [PLATE, body("pad", block(1, 1.01, 2, 2), 1, condition(
    "top", "Dirichlet", Displacement_X=0, Displacement_Y="-0.05*sin(pi*t)"))], form="Density",
                              more=history([0.5, 1], [1, 1])), "apart")
claim(code == 0 and any("'plate' and 'pad', deformed, overlap" in line for line in warnings),
      "a pad without a contact, down and up: %s" % warnings)
# nu = 1/2 without room, and with some
ROUND = geometry(circle(1), ["side"] * 4, QUARTERS)
for gap, code in ((-0.02, 1), (0.001, 0)):
    full = written("full", [body("disc", ROUND, 100, condition("side", "Contact", Gap=gap),
                                 "X, Y, Rotation", ratio=0.5)], form="Density", size=0.5)
    fails("an incompressible disc in a hole, gap %s" % gap, ["enclosed", "take 0.12566"] * code,
          "run", full, "--output", fresh("full"), code=code)
code, warnings = told(scene("tilting-punch.xml"), "untouched", ["Contacts=",
                      "Bodies->punch->Motion=", "History->Times={1}", "History->Steps={1}"])
claim(any("Bodies->punch: is rigid, and no contact names it" in line for line in warnings),
      "a rigid body that nothing touches: %s" % warnings)
# a side that ends too early; one that ends where what it meets has a corner
for order in (["upper:contact", "lower:contact"], ["lower:contact", "upper:contact"]):
    code, warnings = told(scene("two-cylinders.xml"), "cut", [
        "Contacts->line->Between={%s}" % ", ".join(order),
        "Bodies->upper->Boundary Conditions->load->Traction Y=-0.3"])
    claim(code == 0 and len(warnings) == 1 and "'line' presses at an end of its side" in warnings[0] and
          "give the edge 'side' the name 'contact'" in warnings[0],
          order[0] + " first: contact that reaches the end of an arc is told: %s" % warnings)
BED = geometry([(-2, -2), (2, -2), (2, 0), (1, 0), (-1, 0), (-2, 0)],
               "bottom, right, top, middle, top, left")
for side in ("bed:middle", "pad:bottom"):
    pad = body("pad", block(-1, 0, 1, 1), 1, condition("top", "Dirichlet", Displacement_X=0,
                                                       Displacement_Y=-0.01))
    met = {"bed:middle": "pad:bottom", "pad:bottom": "bed:middle"}[side]
    code, warnings = told(written("middle", [
        body("bed", BED, 1, condition("bottom", "Dirichlet", CLAMPED)), pad],
        contact("under", side, met), "Density"), "middle")
    claim(code == 0 and not warnings, side + " first: at the corners of a pad contact ends: %s" % warnings)

code, warnings = told(scene("coulomb.xml"), "slid", [SLID, HELD, SMOOTH])
claim(code == 0 and any("'foundation': sliding reaches 14 %" in line for line in warnings),
      "sliding beyond a tenth of the contact: %s" % warnings)
code, text = epafi("run", scene("coulomb.xml"), "--output", fresh("quiet"), "--quiet",
                   "--set", PUSHED, "--set", HELD)
claim(code == 0 and not text, "--quiet says nothing of it")

corners = [(math.cos(a), 1 + math.sin(a))
           for a in (2 * math.pi * (k + 0.5) / 64 - math.pi / 2 for k in range(64))]
sides = ["low" if k < 16 or k >= 48 else "top" for k in range(64)]
polygon = written("polygon", [body("cylinder", geometry(corners, sides), 1, condition(
    "low", "Contact", Gap="y") + condition("top", "Dirichlet", Displacement_X=0, Displacement_Y=-0.02))],
    form="Density", size=0.1, degree=1)
code, warnings = told(polygon, "polygon")
claim(code == 0 and len(warnings) == 1 and "31 corners of up to 5.6 degrees" in warnings[0],
      "a polygon for a curve: %s" % warnings)
code, text = epafi("check", polygon)
claim(code == 0 and "warning: Bodies->cylinder->Geometry, 'low'" in text, "check says so, too")

# limits far from what scenes have
for sentence, file, settings in [
        ("as many steps as an integer has", os.path.join(HARD, "thin_layer.xml"),
         ["Solver->Maximum Iterations=2147483647"]),
        ("a small body on a large one, its motions fixed", scene("two-blocks.xml"), [
            "Bodies->pad->Geometry->Vertices=4x2:{-2e-4,0, 2e-4,0, 2e-4,4e-4, -2e-4,4e-4}",
            "Bodies->pad->Rigid Motions={Fix={X, Rotation}}"])]:
    code, text = epafi("run", file, "--output", fresh("limit"), settings=[*SETTINGS, *settings])
    claim(code == 0, sentence + ": " + text.strip().splitlines()[-1][-90:])

# digits that rounding takes
COULOMB = listed("Friction", Law="Coulomb", Coefficient=0.3)


def beam(slender, friction):
    """Clamped at its left, over a plane; without friction far above it."""
    height = 1 / slender
    load = "-1e-8*%g*(0.3 + sin(40*x))" % height if friction else "-%g" % (1e-3 * height ** 3)
    law = COULOMB if friction else NONE
    return written("beam", [body("beam", block(0, 0, 1, height), 1, condition(
        "bottom", "Contact", law, Gap=0 if friction else 1) + condition(
            "top", "Neumann", Traction_Y=load) + condition("left", "Dirichlet", CLAMPED),
        mesh=mesh(100, 4, 1 if friction else 3))], form="Density")


for slender, friction, method, words in [
        (300, False, "Dense", ""), (5000, False, "Dense", "out of balance by"),
        (300, True, "Compressed", ""), (10000, True, "Compressed", "contact is met up to")]:
    code, warnings = told(beam(slender, friction), "beam", ["Solver->Linear->Method=" + method])
    lost = [line for line in warnings if "rounding has taken" in line]
    claim(code == 0 and (words in lost[0] if words and lost else not words and not lost),
          "a beam of 1 : %d, %s: %s" % (slender, method, lost))

# of this one the stiffness is singular to rounding: factorised it may be, or not
code, text = epafi("run", beam(10000, False), "--output", fresh("beam"), settings=[
    *SETTINGS, "Solver->Linear->Method=Dense"])
claim((code == 0 and "out of balance by" in text or code == 2) and "slender by more than 1 : 1000" in text,
      "a beam of 1 : 10000: exit %d, %s" % (code, text[-200:]))

# of this one products with compressed operators lose half of the force: no result, but it is written
code, text = epafi("run", beam(5000, False), "--output", fresh("lost"), settings=[
    *SETTINGS, "Solver->Linear->Method=Compressed"])
claim(code == 2 and "Bodies->beam is not in balance: a force of (" in text and "1 : 1000" in text,
      "what is not in balance ends the run: exit %d, %s" % (code, text[-400:]))
claim([row["status"] for row in rows("lost", "history.csv")] == ["not converged"] and
      os.path.exists(os.path.join(WORK, "lost", "solution.hdf")), "and is written")
claim("Solver->Linear->Method = Dense" in text, "compressed operators are named")


# what the solver leaves of free motions is none of rounding
def resting(load, tolerance, law=NONE, beside=()):
    """A disc in a groove, in balance by contact and friction alone."""
    weight = listed("Body Loads", Force_X=0.1 * load, Force_Y=-load)
    bank = 3 - math.sqrt(2)  # a right angle about the disc
    groove = geometry([(-2, -2), (2, -2), (2, bank), (0, bank - 2), (-2, bank)], "bottom, right, top, top, left")
    return written("resting", [
        body("disc", disc(1, "rim", 0, 1), 1000, inside=weight),
        body("block", groove, 1000, condition("bottom", "Dirichlet", CLAMPED)), *beside],
        contact("pair", "disc:rim", "block:top", COULOMB, law), "Projected", 0.3,
        more=listed("Solver", Tolerance=tolerance))


power = listed("Normal", Law="Power", Length=0.01, Pressure=1, Exponent=3)
heavy = body("heavy", block(5, 0, 7, 2), 1000, condition("bottom", "Dirichlet", CLAMPED) +
             condition("top", "Neumann", Traction_Y=-1000))
for sentence, values in [("of a large tolerance", (0.1, 1e-3, power)),
                         ("of a light body beside a heavy one", (1e-6, 1e-12, NONE, [heavy]))]:
    code, warnings = told(resting(*values), "resting", ["Solver->Coulomb Iteration=Fixed Point"])
    claim(code == 0 and any("Bodies->disc: its forces are out of balance by" in line and
                            "Solver->Tolerance" in line for line in warnings),
          "an imbalance %s is a warning: exit %d, %s" % (sentence, code, warnings))

# encodings
text = read(scene("patch.xml"))
marked = os.path.join(WORK, "marked.xml")
for encoding, code in [("utf-8-sig", 0), ("utf-16", 1), ("utf-16-le", 1), ("utf-16-be", 1)]:
    with open(marked, "w", encoding=encoding) as stream:
        stream.write(text)
    done, said = epafi("check", marked)
    claim(done == code and (code == 0 or "encoding" in said), "%s: exit %d, %s" % (
        encoding, done, said.splitlines()[-1][-70:]))
with open(marked, "w", encoding="latin-1") as stream:
    stream.write(text.replace('name="', 'name="\xe4', 1))
refused("latin-1", marked, "UTF-8", ": line ", command="check")
for sentence, before, after, words in [
        ("a separator of thousands", "Modulus: 1", "Modulus: 210,000", "with a point"),
        ("a decimal comma", "Displacement X: 0", "Displacement X: 0,002", "with a point"),
        ("a count beyond all meshes", "Edge: [1", "Edge: [99999999999", "too large")]:
    file = write(os.path.join(WORK, "number.yaml"), """Numbers:
  Bodies: {disc: {Material: {Young's Modulus: 1, Poisson's Ratio: 0},
    Geometry: {Vertices: [[0, 0], [1, 0]], Edges: [low, high], Bulges: [1, 1]},
    Boundary Conditions: {low: {Type: Dirichlet, Displacement X: 0, Displacement Y: 0}}}}
  Discretization: {Elements per Edge: [1, 1]}
""".replace(before, after))
    refused(sentence, file, words, command="check")
refused("nan in an array", changed("nan", scene("patch.xml"), ("4x2:{-1,", "4x2:{nan,")),
        "not a number", command="check")
loud = write(os.path.join(WORK, "LOUD.YAML"), "Loud:\n  Bodis: {}\n")
refused("YAML in a file whose name is in capitals", loud, "'Bodies'", command="check")

# memory: what is foretold against what is taken, and levels that would not fit; sanitizers take
# memory of their own, and addresses by the terabyte
with open(EPAFI, "rb") as program:
    sanitized = b"__asan_init" in program.read()
history, _ = run(scene("coulomb.xml"), "large", levels(7))
for row in history[-2:]:
    share = row["memory_forecast_mb"] / row["memory_mb"]
    claim(sanitized or 0.75 < share < 1.35, "%d unknowns: %.0f MiB foretold, %.0f taken" % (
        row["dof"], row["memory_forecast_mb"], row["memory_mb"]))
limit = "Adaptivity->Maximum Memory=%d" % (history[-2]["memory_forecast_mb"] + 1)
code, text = epafi("run", scene("coulomb.xml"), "--output", fresh("limited"),
                   settings=[*levels(9), limit])
claim(code == 0 and "Maximum Degrees of Freedom" in text.split("ended")[1] and
      len(table(os.path.join(WORK, "limited", "history.csv"))) == 6,
      "a level that would not fit ends the run: " + text.split("ended")[1].splitlines()[0])
refused("a first one is bad input", scene("coulomb.xml"), "coarser",
        settings=["Adaptivity->Maximum Memory=10"])
if not sanitized:
    done = subprocess.run(
        ["bash", "-c", 'ulimit -v 800000; exec "$0" "$@"', EPAFI, "run", scene("coulomb.xml"),
         "--threads", "1", "--output", fresh("ulimit"),
         *options(levels(20))],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True,
        env={**os.environ, "OPENBLAS_NUM_THREADS": "1"})
    claim(done.returncode == 0 and "that are free" in done.stdout,
          "also where a limit on addresses is what there is: " + done.stdout.split("ended")[-1].splitlines()[0])
finish()
