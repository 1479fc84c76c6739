"""convergence and time: how the error of a run falls with degrees of freedom, with seconds;
contributions: what its estimate is made of."""
import math

import numpy as np

from epafi.plot.figures import COLOURS, LINES, MARKERS, loglog, plain_ticks, plt

DOF = "dof", "degrees of freedom"
ERRORS = {"convergence": (DOF, "convergence"),
          "time": (("seconds_total", "CPU seconds since the start, all threads"),
                   "error against time")}
CONTRIBUTIONS = [("eta_neumann", "residual on Neumann sides"),
                 ("eta_contact", "residual on contact sides"),
                 ("eta_density", "residual of the density"),
                 ("eta_complementarity", "complementarity"),
                 ("eta_penetration", "penetration"),
                 ("eta_tension", "tension"),
                 ("eta_bound", "shear above its bound"),
                 ("eta_slip", "stick and slip")]


def total_energy(history):
    return (history.numbers("energy_strain") - history.numbers("energy_load")
            + np.nan_to_num(history.numbers("energy_friction")))


def error_curve(history):
    """What tells how far a run has come: the estimate, else the energy's distance to that of
    the last level; and its labels."""
    estimate = history.numbers("estimate")
    if (estimate > 0).any():
        return estimate, "estimate", "estimated error"
    energy = total_energy(history)
    distance = np.abs(energy - energy[-1])
    distance[-1] = math.nan
    return distance, "|energy - energy of the last level|", "energy difference"


def finish(axes, labels, title, pictures):
    for axis in (axes.xaxis, axes.yaxis):
        plain_ticks(axis)
    axes.set_xlabel(labels[0])
    axes.set_ylabel(labels[1])
    pictures.title(axes, title)


def draw(history, title, pictures):
    """Nothing of a single level, which has nothing to be compared with."""
    if history.size < 2:
        return
    for name, ((abscissa, what), text) in ERRORS.items():
        if pictures.wants(name):
            figure, axes = pictures.subplots(figsize=(6.4, 4.6))
            error, curve, label = error_curve(history)
            drawn = loglog(axes, history.numbers(abscissa), error, curve, marker="o")
            if not drawn:  # all levels have the same energy, and no estimate
                plt.close(figure)
                continue
            finish(axes, (what, label), "%s: %s" % (title, text), pictures)
            axes.legend()
            pictures.save(figure, name)
    if pictures.wants("contributions"):
        draw_contributions(history, title, pictures)


def draw_contributions(history, title, pictures):
    x, estimate = (history.numbers(name) for name in (DOF[0], "estimate"))
    figure, axes = pictures.subplots(figsize=(8.6, 4.8))
    drawn = loglog(axes, x, estimate, "estimate", color="black", marker="o", lw=2)
    for k, ((name, text), marker) in enumerate(zip(CONTRIBUTIONS, MARKERS[1:])):
        y = history.numbers(name)
        drawn = loglog(axes, x, np.where(y > 1e-8 * estimate, y, math.nan), text, marker=marker,
                       lw=1, ls=LINES[k // 6], color=COLOURS[k % 6], gaps=True) or drawn
    if not drawn:
        plt.close(figure)
        return
    finish(axes, (DOF[1], "contribution to the estimate"), title + ": contributions", pictures)
    pictures.legend(axes, loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.save(figure, "contributions")
