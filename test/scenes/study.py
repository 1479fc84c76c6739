"""Studies: true errors against a reference, failures that are listed, what is refused."""
import math
import os
import shutil
import signal
import time

from runs import SCENES, WORK, claim, epafi, fails, finish, fresh, options, saved, stopped, table


def settings(*words):
    return {"Set": list(words)}


def sweep_of(*values):
    return {**settings("Adaptivity->Strategy=None"), "Sweep": {
        "Key": "Discretization->Stabilization->Gamma0", "Values": list(values)}}


def uniform_to(levels):
    return {"uniform h": settings("Adaptivity->Strategy=Uniform h",
                                  "Adaptivity->Maximum Levels=%d" % levels)}


FIXED_POINT = ("Solver->Coulomb Iteration=Fixed Point", "Solver->Coulomb Maximum Iterations=1")
HOPELESS = {
    "too strong": {"Override": {"Discretization": {"Stabilization": {"Gamma0": 10}}}},
    "unconverged": settings("Adaptivity->Strategy=None", *FIXED_POINT),
    "sweep": sweep_of("1e-6", "1e-3", "1")}
HP = ("Adaptivity->Strategy=Adaptive hp", "Adaptivity->Marking Fraction=0.5")


def up_to(unknowns, levels=100):
    """Settings of a reference."""
    return (*HP, "Adaptivity->Maximum Levels=%d" % levels,
            "Adaptivity->Maximum Degrees of Freedom=%d" % unknowns)


def study(name, variants, reference=up_to(700), scene="coulomb.xml", **more):
    """The file of a study of one scene."""
    file = {"File": os.path.abspath(os.path.join(SCENES, scene))}
    return saved(name, {"Scenes": {scene[:-len(".xml")]: {
        **file, **({"Reference": settings(*reference)} if reference else {})}},
        "Variants": variants, **{key.replace("_", " "): value for key, value in more.items()}})


file = study("small", {**uniform_to(5), **HOPELESS})
folder = fresh("small")
code, text = epafi("study", file, "--output", folder)
claim(code == 3 and "3 variants were not solved" in text,
      "a study with failing variants goes on and ends with 3 (exit %d)" % code)
claim(text.index("level    dof") < text.index("coulomb: uniform h"),
      "its table on the screen has a head")
rows = table(os.path.join(folder, "study.csv"))


def of(name):
    return [row for row in rows if row["variant"] == name]


reference = of("reference")[0]
uniform = of("uniform h")
claim(len(uniform) == 5, "five levels")
claim(reference["estimate"] < 0.2 * uniform[-1]["estimate"],
      "the reference's estimate is quoted, and small: %g" % reference["estimate"])
for coarse, fine in zip(uniform, uniform[1:]):
    claim(fine["error"] < coarse["error"], "the true error falls: %g" % fine["error"])
# The kink at x = 0 is a node: rate 3/2 of the energy norm against dof.
first, last = uniform[-3], uniform[-1]
rate = -math.log(last["error"] / first["error"]) / math.log(last["dof"] / first["dof"])
claim(1.3 < rate < 1.7, "at rate %.2f" % rate)
claim(all(1 < row["effectivity"] < 6 for row in uniform),
      "the estimate is an upper bound within a factor 6")
claim(all((row["counted"] == 1) == (row["estimate"] / row["effectivity"] >=
                                    10 * reference["estimate"]) for row in uniform) and
      {row["counted"] for row in uniform} == {0, 1},
      "levels too near to the reference are not counted")
claim(uniform[-1]["error_multiplier"] < 0.3 * uniform[0]["error_multiplier"],
      "the contact stress converges")
claim(uniform[-1]["error_energy"] < 0.02 * uniform[0]["error_energy"],
      "the energy converges")
claim(all(a["seconds_total"] < b["seconds_total"] for a, b in zip(uniform, uniform[1:])),
      "CPU seconds of a variant add up")
for row in uniform:
    phases = sum(row["seconds_" + phase] for phase in
                 ("assembly", "factorization", "stabilization", "newton", "estimate"))
    claim(row["seconds_total"] >= phases, "and hold every phase")

failed = of("too strong")
claim(len(failed) == 1 and failed[0]["status"] == "failed" and "Gamma0" in
      failed[0]["reason"] and failed[0]["estimate"] == "",
      "an indefinite stiffness is listed with the reason")
claim(of("unconverged")[0]["status"] == "not converged" and of("unconverged")[0]["reason"],
      "what did not converge is listed with the reason")
claim([row["status"] for row in rows if row["variant"].startswith("sweep")] ==
      ["converged", "converged", "failed"], "a sweep has a row per value")
for name in ("convergence", "time", "contact_stress", "work-precision", "exponential",
             "effectivity", "sweep", "sweep_forces", "sweep_contact"):
    for ending in (".png", ".svg"):
        picture = os.path.join(folder, name + ending)
        claim(os.path.isfile(picture) and os.path.getsize(picture) > 5000,
              name + ending + " is drawn")
claim(all(os.path.isfile(os.path.join(folder, "uniform_h", name + ".png")) for name in (
    "convergence", "contact", "deformed")),
      "and a variant's own pictures")
swept = [row for row in rows if row["variant"].startswith("sweep") and row["folder"]]
claim(len(swept) == 2 and all(sorted(os.listdir(os.path.join(folder, row["folder"]))) ==
                              ["contact.csv", "used.xml"] for row in swept),
      "a value of a sweep keeps its contact: " + swept[0]["folder"])
claim(all(row["error_path"] == row["worst_step"] == "" for row in uniform),
      "one load is no path")

# a path: every step is compared, the worst one is named
path = study("path", {name: settings(*HP, "Adaptivity->Maximum Levels=3", "History->Steps={%s}" % steps)
                      for name, steps in (("same", "1, 1, 1"), ("halved", "2, 2, 2"))},
             up_to(900, 3), "there-and-back.xml")
paths = fresh("path")
code, text = epafi("study", path, "--output", paths, "--no-plot")
rows = table(os.path.join(paths, "study.csv"))
claim(code == 0, "a study of paths (exit %d) %s" % (code, "" if code == 0 else text))
same, halved = of("same"), of("halved")
claim(len(same) == 3 and same[-1]["error_path"] == same[-1]["error_path_friction"] == 0,
      "what is solved as the reference has no error in any step")
for row in same[:-1]:
    claim(row["error_path"] > 0 and row["error_path_multiplier"] > 0 and
          row["error_path_friction"] > 0 and row["worst_step"] in (1, 2, 3),
          "a coarser mesh has: %g, step %d" % (row["error_path"], row["worst_step"]))
claim(same[1]["error_path"] < same[0]["error_path"], "it falls")
claim(halved[-1]["error_path"] > 0 and halved[-1]["worst_step"] in (2, 4, 6),
      "with other steps, those at common times are compared: %d" % halved[-1]["worst_step"])
alone = fresh("path alone")  # without the folders of its variants, whose pictures others draw
os.makedirs(alone)
for name in ("study.csv", "used.xml"):
    shutil.copy(os.path.join(paths, name), alone)
code, text = epafi("plot", alone)
claim(code == 0 and os.path.isfile(os.path.join(alone, "path.png")), "path.png is drawn: " + text)

# --quiet draws, and says nothing; pictures that cannot be drawn are told
sweep = study("sweep", {"sweep": HOPELESS["sweep"]})
quiet = fresh("quiet")
code, text = epafi("study", sweep, "--output", quiet, "--quiet")
claim(code == 3 and os.path.isfile(os.path.join(quiet, "sweep.png")) and
      text.startswith("epafi: 1 variant was"), "--quiet draws all the same: " + text)
sweep = study("sweep", {"sweep": sweep_of("1e-6", "1e-3")})
os.makedirs(os.path.join(fresh("undrawn"), "sweep.png"))
fails("pictures that fail", ["cannot be drawn"], "study", sweep, "--output", os.path.join(WORK, "undrawn"))

# solutions of a sweep, if asked for
sweep = study("kept", {"sweep": {**sweep_of("1e-6", "1e-3"), "Override": {"Discretization": {
    "Elements per Edge": [4, 2, 4, 2], "Degree": 2}}}}, Keep_Solutions=True)
kept = fresh("kept")
code, text = epafi("study", sweep, "--output", kept, "--quiet", "--no-plot")
last = table(os.path.join(kept, "study.csv"))[-1]
claim((last["elements"], last["degree_min"]) == (12, 2), "an Override has an array: " + text)
value = os.path.join(kept, last["folder"])
code, text = epafi("fields", value, "--grid", "3,3")
claim(code == 0 and os.path.isfile(os.path.join(value, "fields.csv")),
      "fields of a value of a sweep: " + text.strip())

# a variant of several bodies keeps their sums on all levels, and so does a run that goes on from it
TWO = ["Adaptivity->Strategy=Uniform h"]
file_of = study("two", {"few": settings(*TWO, "Adaptivity->Maximum Levels=2")}, None,
                "two-blocks.xml", Keep_Solutions=True)
folders = fresh("bodies"), fresh("bodies.run")
code, text = epafi("study", file_of, "--output", folders[0], "--quiet", "--no-plot")
few = os.path.join(folders[0], "few")
more = options(TWO + ["Adaptivity->Maximum Levels=3"])
two_blocks = os.path.join(SCENES, "two-blocks.xml")
epafi("run", two_blocks, "--output", folders[1], *more)
expected = table(os.path.join(folders[1], "bodies.csv"))
file_of = os.path.join(few, "bodies.csv")
claim(code == 0 and os.path.exists(file_of) and
      table(file_of) == [row for row in expected if row["level"] < 2],
      "a study keeps bodies.csv of all levels: " + text)
code, text = epafi("run", two_blocks, "--restart", few, *more)
claim(code == 0 and table(file_of) == expected, "and a run goes on with it: " + text[-200:])

# a load path keeps its steps, and the fields of each
file_of = study("paths", {"coarse": settings(
    "History->Times={1, 2}", "History->Steps={1, 2}", "Adaptivity->Strategy=Adaptive h",
    "Discretization->Elements per Edge={2, 2, 2, 3, 1, 4, 10, 4, 1, 3, 2, 2, 2, 3, 3, 3}",
    "Adaptivity->Maximum Levels=2")}, None, "fretting.xml", Keep_Solutions=True)
paths = fresh("paths")
code, text = epafi("study", file_of, "--output", paths, "--quiet", "--no-plot")
steps = table(os.path.join(paths, "coarse", "steps.csv")) if code == 0 else []
claim([(row["level"], row["step"]) for row in steps] == [(k, i) for k in (0, 1) for i in (1, 2, 3)],
      "a study of a load path keeps steps.csv: %d rows %s" % (len(steps), text))
code, text = epafi("fields", os.path.join(paths, "coarse"), "--grid", "4,4", "--step", "2")
claim(code == 0, "and what is inside at each step: " + text.strip())

# the reference is kept and met again to the last bit
code, text = epafi("study", file, "--output", folder)
claim(code == 1 and "--force" in text and "keeps its references" in text and
      "--restart" not in text, "an earlier study is not overwritten; the advice is a study's")
again = study("again", uniform_to(5))
code, text = epafi("study", again, "--output", folder, "--force", "--no-plot")
claim(code == 0 and "kept from before" in text, "the reference is kept")
claim([row["error"] for row in table(os.path.join(folder, "study.csv"))[1:]] ==
      [row["error"] for row in uniform], "and gives the same errors")
# a run adds the same errors to its history.csv; one that goes on has none of those before
coulomb = os.path.join(SCENES, "coulomb.xml")
solution = os.path.join(folder, "reference-coulomb.hdf")
alone = fresh("alone run")
two, three = (options(uniform_to(count)["uniform h"]["Set"]) for count in (2, 3))
against = ("--reference", solution, "--smallest-eigenvalue")
code, text = epafi("run", coulomb, *two, "--output", alone, *against)
rows = table(os.path.join(alone, "history.csv"))
same = ("error", "error_multiplier", "error_energy", "counted", "effectivity")
claim(code == 0 and [[row[name] for name in same] for row in rows] ==
      [[row[name] for name in same] for row in uniform[:2]], "a run has the same errors: " + text)
claim(all(0.9 < row["smallest_eigenvalue"] <= 1 for row in rows), "S^ is small: %s" % [
    row["smallest_eigenvalue"] for row in rows])
code, text = epafi("run", coulomb, *three, "--restart", alone, *against)
rows = table(os.path.join(alone, "history.csv"))
claim(code == 0 and [row["error"] for row in rows] == ["", "", uniform[2]["error"]],
      "and one that goes on: " + text)
for what, scene, reference, words in (
        ("of other bodies", "tresca.xml", os.path.join(few, "solution.hdf"), "other bodies"),
        ("that is none", "coulomb.xml", coulomb, coulomb)):
    fails("a reference " + what, ["--reference: ", words], "run", os.path.join(SCENES, scene),
          "--output", fresh("no reference"), "--reference", reference)
fails("a reference at another time", ["ends at t = 2, the scene at 1"], "run",
      os.path.join(SCENES, "fretting.xml"), *options(["History->Times={1}", "History->Steps={1}"]),
      "--output", fresh("no reference"),
      "--reference", os.path.join(paths, "coarse", "solution.hdf"))
COEFFICIENT = "Bodies->block->Boundary Conditions->foundation->Friction->Coefficient"
fails("a reference of another problem", [COEFFICIENT + " differs"], "run", coulomb,
      *options([COEFFICIENT + "=0.31"]), "--output", fresh("no reference"), "--reference", solution)
# but not one of another scene, nor a damaged one
changed = study("changed", uniform_to(2), up_to(300))
code, text = epafi("study", changed, "--output", folder, "--force", "--no-plot")
claim(code == 0 and "reference computed" in text, "a reference of other settings is not taken")
with open(os.path.join(folder, "reference-coulomb.hdf"), "r+b") as stream:
    stream.truncate(20000)
code, text = epafi("study", changed, "--output", folder, "--force", "--no-plot")
claim(code == 0 and "reference computed" in text, "nor a damaged one")

# nor one that was interrupted, did not converge or failed: of these there is no file
endless = study("endless", uniform_to(5), up_to(700000))


def computing():
    """The reference is begun."""
    begun = os.path.exists(os.path.join(parts, "used.xml"))
    time.sleep(0.2 * begun)
    return begun


parts = fresh("endless")
code = stopped(computing, "study", endless, "--output", parts, "--no-plot", how=signal.SIGINT)
claim(code == 130 and "used.xml" in os.listdir(parts) and
      "reference-coulomb.hdf" not in os.listdir(parts),
      "an interrupted reference is not kept: " + " ".join(sorted(os.listdir(parts))))
for name, reference in (("unconverged", (*HP, "Adaptivity->Maximum Levels=100", *FIXED_POINT)),
                        ("small", up_to(10))):
    file_of = study("reference " + name, uniform_to(2), reference)
    failing = fresh("reference " + name)
    code, text = epafi("study", file_of, "--output", failing, "--no-plot")
    rows = table(os.path.join(failing, "study.csv"))
    claim(code == 3 and ": reference failed on level" in text and
          rows[0]["variant"] == "reference" and rows[0]["status"] == "failed" and
          rows[0]["reason"] and len(rows) == 3 and rows[-1]["error"] == "" and
          "reference-coulomb.hdf" not in os.listdir(failing),
          "a reference that fails (%s) is listed, the variants are solved: %s" %
          (name, rows[0]["reason"]))

# a variant's folder lies in the study's, whatever its name
parent = fresh("parent")
os.makedirs(parent)
shutil.copy(os.path.join(folder, "uniform_h", "history.csv"), parent)
dots = study("dots", {"..": uniform_to(2)["uniform h"]}, up_to(100))
code, text = epafi("study", dots, "--output", os.path.join(parent, "own"), "--no-plot", "--quiet")
claim(code == 0 and "history.csv" in os.listdir(parent) and "used.xml" not in os.listdir(parent)
      and "_.." in os.listdir(os.path.join(parent, "own")), "a variant named '..': " + text)

for name, variants, words in [
        ("key", {"uniform h": settings("Adaptivity->Maximum Level=5")},
         ["Variants->uniform h", "'Maximum Levels'"]),
        ("name", {"uniform h": {"Sets": ["Adaptivity->Maximum Levels=5"]}},
         ["Variants->uniform h->Sets", "'Set'"]),
        ("scenes", {"uniform h": {**uniform_to(5)["uniform h"], "Scenes": ["coulmb"]}},
         ["Variants->uniform h->Scenes", "'coulomb'"]),
        ("none", {}, ["Variants"])]:
    fails("wrong " + name, words, "study", study(name, variants), "--output", fresh(name))
before = sorted(os.listdir(folder))
fails("a wrong key", ["'Maximum Levels'"], "study", os.path.join(WORK, "key.yaml"), "--force",
      "--output", folder)
claim("study.csv" in before and sorted(os.listdir(folder)) == before,
      "what is refused replaces nothing")
fails("a missing study", ["nowhere.xml"], "study", os.path.join(WORK, "nowhere.xml"))
fails("a study takes no --set", ["unknown option"], "study", file, "--set", "Solver->Tolerance=1")
# what only a mesh shows to be no number fails its variant, not the study
undefined = study("undefined", {
    "bad": settings("Adaptivity->Strategy=None", "Bodies->block->Rigid Motions=",
                    "Bodies->block->Boundary Conditions->side="
                    "{Type=Dirichlet, Displacement X=sqrt(x-100)}"),
    "good": settings("Adaptivity->Strategy=None")}, None)
folder = fresh("undefined")
code, text = epafi("study", undefined, "--output", folder, "--no-plot")
rows = table(os.path.join(folder, "study.csv"))
claim(code == 3 and [(row["variant"], row["status"]) for row in rows] ==
      [("bad", "failed"), ("good", "converged")], "a condition that is no number: exit %d, %s" % (
          code, [(row["variant"], row["status"], row["reason"][-60:]) for row in rows]))
finish()
