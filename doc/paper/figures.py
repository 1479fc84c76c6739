"""The figures of paper.md, from runs:  figures.py [WORK]

With the Python front in PYTHONPATH (doc/howto/python.md).  Writes error.png, cylinders.png and
fretting.png beside this file, and prints the numbers that the paper quotes.
"""
import os
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

import epafi  # noqa: E402
from epafi.plot.figures import Looks  # noqa: E402
from epafi.program import call  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
SCENES = os.path.join(HERE, "..", "..", "drivers", "scenes")
LOOKS = Looks(font=8, dpi=150)


def saved(figure, name):
    figure.savefig(os.path.join(HERE, name), dpi=LOOKS.dpi)
    plt.close(figure)


def error(work):
    """Against CPU seconds of one thread."""
    call(["study", os.path.join(HERE, "error.xml"), "--output", work, "--force", "--threads", "1",
          "--no-plot", "--quiet"])
    study = epafi.Table(os.path.join(work, "study.csv"))
    figure, axes = plt.subplots(figsize=(3.4, 2.5))
    for variant, marker in zip(dict.fromkeys(study["variant"]), "os^vD"):
        here = (study["variant"] == variant) & (study.numbers("counted") > 0)
        if variant == "reference" or not here.any():
            continue
        axes.loglog(study["seconds_total"][here], study["error"][here], marker=marker, label=variant)
        row = np.flatnonzero(here)[np.argmax(study["error"][here] <= 1e-3)]
        if study["error"][row] <= 1e-3:
            print("%s: 1e-3 with %d unknowns, %.2f s" % (variant, study["dof"][row],
                                                         study["seconds_total"][row]))
    axes.set_xlabel("CPU seconds, one thread")
    axes.set_ylabel("relative error, energy norm")
    axes.legend()
    saved(figure, "error.png")


def cylinders():
    """Two elastic cylinders and Hertz' pressure."""
    run = epafi.run(os.path.join(SCENES, "two-cylinders.xml"), threads=1)
    contact = run.contact
    a, largest = 0.005, 3.048780488  # the head of the scene derives them
    x, p = contact["x"], contact["lambda_n"]
    hertz = largest * np.sqrt(np.maximum(0, 1 - (x / a)**2))
    inside = np.abs(x) < 0.9 * a
    print("cylinders: %.1e of the largest pressure within 0.9 a, %d unknowns" % (
        np.abs(p - hertz)[inside].max() / largest, run.history["dof"][-1]))
    figure, axes = plt.subplots(figsize=(3.4, 2.5))
    near = np.abs(x) < 1.6 * a
    axes.plot(x[near] / a, p[near] / largest, label="Epafi")
    axes.plot(x[near] / a, hertz[near] / largest, "--", color="black", label="Hertz")
    axes.set_xlabel("$x / a$")
    axes.set_ylabel("pressure / largest of Hertz")
    axes.legend()
    saved(figure, "cylinders.png")


def fretting():
    """The stress inside at the end of a path, and friction's work along it."""
    run = epafi.run(os.path.join(SCENES, "fretting.xml"), threads=1)
    figure, (field, work) = plt.subplots(1, 2, figsize=(7, 2.6), gridspec_kw={
        "width_ratios": [1.7, 1]})
    run.plot("von_mises", window=(-2.5, 0, 2.5, 2), axes=field, font=LOOKS.font, title=False)
    steps = run.steps
    last = steps["level"] == steps["level"].max()
    work.plot(np.append(0, steps["t"][last]), np.append(0, steps["energy_dissipated"][last]),
              marker=".")
    work.set_xlabel("t")
    work.set_ylabel("friction's work")
    saved(figure, "fretting.png")


if __name__ == "__main__":
    with plt.rc_context(LOOKS.style()), tempfile.TemporaryDirectory() as scratch:
        error(sys.argv[1] if len(sys.argv) > 1 else os.path.join(scratch, "error"))
        cylinders()
        fretting()
