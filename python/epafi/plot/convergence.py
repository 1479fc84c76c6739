"""convergence and time: how the error of a run falls with degrees of freedom, with seconds."""
import math

import numpy as np

from epafi.plot.figures import loglog, plain_ticks


def total_energy(history):
    return (history.numbers("energy_strain") - history.numbers("energy_load")
            + np.nan_to_num(history.numbers("energy_friction")))


def error_curves(history):
    """What tells how far a run has come: the estimate, else the energy's distance to that of
    the last level."""
    estimate = history.numbers("estimate")
    if (estimate > 0).any():
        return [("estimate", estimate)], "estimated error"
    energy = total_energy(history)
    distance = np.abs(energy - energy[-1])
    distance[-1] = math.nan
    return [("|energy - energy of the last level|", distance)], "energy difference"


def draw(history, abscissa, name, title, pictures):
    x = history.numbers(abscissa)
    figure, axes = pictures.subplots(figsize=(6.4, 4.6))
    curves, label = error_curves(history)
    drawn = [loglog(axes, x, y, text, marker="o") for text, y in curves]
    if not any(drawn):
        axes.text(0.5, 0.5, "a single level: nothing to compare", ha="center",
                  transform=axes.transAxes)
    else:
        for axis in (axes.xaxis, axes.yaxis):
            plain_ticks(axis)
    axes.set_xlabel("degrees of freedom" if abscissa == "dof" else
                    "CPU seconds since the start, all threads")
    axes.set_ylabel(label)
    pictures.title(axes, title)
    if any(drawn):
        axes.legend()
    pictures.save(figure, name)
