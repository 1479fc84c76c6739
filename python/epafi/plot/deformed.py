"""deformed: the outline moved by the displacements, and the tractions."""
import math

import numpy as np
from matplotlib.lines import Line2D

from epafi.plot.bodies import draw_rigid, roomy
from epafi.plot.figures import equal_axes, plt, shape_of


def round_down(value):
    """1, 2 or 5 times a power of ten, not above the value."""
    power = 10.0**math.floor(math.log10(value))
    return max(step * power for step in (1, 2, 5) if step * power <= value * (1 + 1e-12))


def draw(boundary, rigid, title, pictures):
    figure, axes = plt.subplots()
    largest = max(np.hypot(*element["u"].T).max() for element in boundary.elements)
    scale = round_down(0.1 * boundary.diameter / largest) if largest > 0 else 1
    for k, loop in enumerate(boundary.loops()):
        x = np.concatenate([element["x"] for element in loop])
        u = np.concatenate([element["u"] for element in loop])
        axes.plot(*x.T, color="grey", lw=0.8, ls="--", label="undeformed" if not k else "_")
        axes.plot(*(x + scale * u).T, color="C0", lw=1.6,
                  label="deformed, displacement x %g (gaps are not)" % scale if not k else "_")
    arrow = arrows(axes, boundary, scale)
    shown = axes.dataLim
    room = shape_of(shown.width, shown.height, 5.5)
    figure.set_size_inches(room[0] + 1.1, room[1] + 1.1)
    solid = draw_rigid(axes, rigid, scale, roomy(shown.min, shown.max)) if rigid else []
    equal_axes(axes, shown.width, shown.height)
    axes.set_title(title + ": deformed outline and tractions")
    figure.tight_layout()
    below = axes.get_tightbbox(figure.canvas.get_renderer()).transformed(
        figure.transFigure.inverted())  # labels included: the legend hides none
    figure.legend(handles=[*axes.get_lines()[:2], *solid, *arrow], loc="upper center",
                  bbox_to_anchor=(0.5 * (below.x0 + below.x1), below.y0))
    pictures.save(figure, "deformed")


def arrows(axes, boundary, scale):
    """The force on each piece of the boundary, by the length of a piece; where it is larger than
    could be drawn, arrows are cut.  Returns what the legend shows of them."""
    points, tractions = zip(*(piece for side in boundary.sides()
                              for piece in pieces(side, 0.03 * boundary.diameter, scale)))
    points, tractions = np.array(points), np.array(tractions)
    sizes = np.hypot(*tractions.T)
    if not sizes.max() > 0:
        return []
    cap = min(sizes.max(), 5 * np.quantile(sizes[sizes > 1e-3 * sizes.max()], 0.75))
    shown = tractions * np.minimum(1, cap / np.maximum(sizes, 1e-300))[:, None]
    shown *= 0.15 * boundary.diameter / cap
    axes.quiver(*points.T, *shown.T, angles="xy", scale_units="xy", scale=1, color="C3",
                width=0.003)
    axes.update_datalim(points + shown)
    axes.autoscale_view()
    text = "mean traction on the body, longest arrow %.3g" % cap
    if cap < sizes.max():
        text += "; cut there (largest %.3g)" % sizes.max()
    return [Line2D([], [], color="C3", marker=">", lw=1, label=text)]


def pieces(side, length, scale):
    """Middle and mean traction of the equal pieces, about as long as asked, of a chain of
    elements.  Of a chain shorter than that, what gives its force on the length asked."""
    x = np.concatenate([element["x"] for element in side])
    u = np.concatenate([element["u"] for element in side])
    t = np.concatenate([element["t"] for element in side])
    steps = np.hypot(*np.diff(x, axis=0).T)
    along = np.append(0, np.cumsum(steps))
    force = np.vstack([[0, 0], np.cumsum(steps[:, None] * (t[1:] + t[:-1]) / 2, axis=0)])

    def at(values, s):
        return np.column_stack([np.interp(s, along, column) for column in values.T])

    ends = np.linspace(0, along[-1], max(1, round(along[-1] / length)) + 1)
    middles = (ends[1:] + ends[:-1]) / 2
    mean = np.diff(at(force, ends), axis=0) / max(length, ends[1])
    return zip(at(x + scale * u, middles), mean)
