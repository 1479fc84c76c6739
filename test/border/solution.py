"""solution.hdf of 2 and 3 ranks is that of 1 rank, with compressed operators, and of 3 with dense
ones; a run goes on with any number of ranks."""
import os
import subprocess

import h5py
import numpy

import ranks

TRESCA = os.path.join(ranks.SCENES, "tresca.xml")
METHODS = {"Dense": ["--set", "Solver->Linear->Method=Dense"],
           "Compressed": ["--set", "Solver->Linear->Method=Compressed",
                          "--set", "Discretization->Stabilization->Form=Density"]}
EPSILON = 1e-9  # of a data set's largest number; lambda is only as exact as Newton's last step


def solve(count, name, levels, *more):
    arguments = ["run", TRESCA, "--set", "Adaptivity->Strategy=Adaptive hp", "--set",
                 "Adaptivity->Maximum Levels=%d" % levels, *more]
    run = ranks.Run(count, arguments)
    ranks.claim(run.codes == [0] * count, "%s: %s %s" % (name, run.codes, run.messages))


def iterations(folder):
    return [row["newton_iterations"] for row in ranks.table(os.path.join(folder, "history.csv"))]


def datasets(folder):
    """All arrays; tables, whose columns are told, hold seconds."""
    result = {}
    with h5py.File(os.path.join(folder, "solution.hdf"), "r") as file:
        file.visititems(lambda name, item: result.update({name: item[()]})
                        if isinstance(item, h5py.Dataset) and item.dtype.kind != "S" and
                        name + "_columns" not in file else None)
    return result


def compare(one, other, what):
    a, b = datasets(one), datasets(other)
    ranks.claim(list(a) == list(b) and len(a) > 25, "%s: the same data sets" % what)
    worst = (0, "")
    for name in a:
        x, y = a[name].astype(float), b[name].astype(float)
        if x.shape != y.shape or not numpy.array_equal(numpy.isnan(x), numpy.isnan(y)):
            worst = (float("inf"), name)
        elif numpy.isfinite(x).any():
            scale = numpy.nanmax(numpy.abs(x)) or 1
            worst = max(worst, (numpy.nanmax(numpy.abs(x - y)) / scale, name))
    ranks.claim(worst[0] <= EPSILON, "%s: the same numbers, %.1e in %s" % (what, *worst))


for method, settings in METHODS.items():
    whole = {}
    # dense levels are computed by each rank for itself, however many there are
    for count in (1, 2, 3) if method == "Compressed" else (1, 3):
        name = "%s, %d ranks" % (method, count)
        whole[count] = ranks.fresh("whole-%s-%d" % (method, count))
        solve(count, name, 6, *settings, "--output", whole[count])
        compare(whole[1], whole[count], name)
    for first, second in ((2, 3), (3, 1), (1, 2)) if method == "Compressed" else ((3, 1), (1, 3)):
        name = "%s, %d ranks, then %d" % (method, first, second)
        folder = ranks.fresh("part-%s-%d-%d" % (method, first, second))
        solve(first, name, 3, *settings, "--output", folder)
        solve(second, name, 6, *settings, "--restart", folder)
        compare(whole[1], folder, name)
        ranks.claim(iterations(folder) == iterations(whole[1]), name + ": the same iterations")

# What is wrong with the file or the disk is one message on all ranks.
with open(os.path.join(folder, "solution.hdf"), "r+b") as stream:
    stream.truncate(20000)
run = ranks.Run(2, ["run", TRESCA, "--restart", folder])
ranks.claim(run.codes == [1, 1] and len(run.messages) == 1 and "solution.hdf" in
            run.messages[0], "a damaged file: %s %s" % (run.codes, run.messages))
tiny = ranks.fresh("tiny")
os.makedirs(tiny)
if os.geteuid() == 0 and subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=160k", "epafi", tiny],
        stderr=subprocess.DEVNULL).returncode == 0:
    try:
        out = os.path.join(tiny, "out")
        grow = ["--set", "Adaptivity->Strategy=Adaptive hp", "--set", "Adaptivity->Maximum Levels=%d"]
        first = ranks.Run(2, ["run", TRESCA, "--output", out, *grow[:-1], grow[-1] % 2])
        ranks.claim(first.codes == [0, 0], "two levels fit: %s" % first.codes)
        run = ranks.Run(2, ["run", TRESCA, "--restart", out, *grow[:-1], grow[-1] % 40])
        ranks.claim(run.codes == [1, 1] and len(run.messages) == 1 and "No space left" in
                    run.messages[0] and len(run.text.strip().splitlines()) < 35,
                    "a full disk: %s %s" % (run.codes, run.messages))
        ranks.claim(len(iterations(out)) >= 2 and
                    len(datasets(out)) > 25, "leaves the level before")
    finally:
        subprocess.run(["umount", tiny], check=True)
ranks.finish()
