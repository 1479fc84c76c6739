"""contributions: what the estimate of a run is made of."""
import math

import numpy as np

from epafi.plot.figures import COLOURS, LINES, MARKERS, loglog, plain_ticks, plt

CONTRIBUTIONS = [("eta_neumann", "residual on Neumann sides"),
                 ("eta_contact", "residual on contact sides"),
                 ("eta_density", "residual of the density"),
                 ("eta_complementarity", "complementarity"),
                 ("eta_penetration", "penetration"),
                 ("eta_tension", "tension"),
                 ("eta_bound", "shear above its bound"),
                 ("eta_slip", "stick and slip")]


def draw(history, title, pictures):
    x = history.numbers("dof")
    figure, axes = pictures.subplots(figsize=(8.6, 4.8))
    drawn = loglog(axes, x, history.numbers("estimate"), "estimate", color="black",
                   marker="o", lw=2)
    rounding = 1e-8 * history.numbers("estimate")
    for k, ((name, text), marker) in enumerate(zip(CONTRIBUTIONS, MARKERS[1:])):
        y = history.numbers(name)
        drawn = loglog(axes, x, np.where(y > rounding, y, math.nan), text, marker=marker,
                       lw=1, ls=LINES[k // 6], color=COLOURS[k % 6], gaps=True) or drawn
    if not drawn:
        plt.close(figure)
        return
    for axis in (axes.xaxis, axes.yaxis):
        plain_ticks(axis)
    axes.set_xlabel("degrees of freedom")
    axes.set_ylabel("contribution to the estimate")
    pictures.title(axes, title + ": contributions")
    pictures.legend(axes, loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.save(figure, "contributions")
