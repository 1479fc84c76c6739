"""deformed: the outline moved by the displacements, and the tractions."""
import math

import numpy as np
from matplotlib.lines import Line2D

from epafi.plot.bodies import draw_rigid, roomy, with_images
from epafi.plot.figures import COLOURS, equal_axes, shape_of


def round_down(value):
    """1, 2 or 5 times a power of ten, not above the value."""
    power = 10.0**math.floor(math.log10(value))
    return max(step * power for step in (1, 2, 5) if step * power <= value * (1 + 1e-12))


def scale_of(size, displacements, contact):
    """By what displacements (n, 2) are multiplied in a picture of this size: to a tenth of it, but
    gaps that close are not multiplied, so that sides overlap by scale - 1 times their size: that
    stays below half a hundredth of the picture."""
    largest = np.hypot(*displacements.T).max(initial=0)
    if not largest > 1e-12 * size:  # rounding, as where loads are gone
        return 1
    closed = np.abs(contact["gap"][contact["contact"] > 0]) if contact else np.zeros(0)
    overlap = closed[np.isfinite(closed)].max(initial=0)
    return round_down(min(0.1 * size / largest, 1 + 0.005 * size / max(overlap, 1e-300)))


def within(points, view):
    """Which of them a window x0, y0, x1, y1 shows."""
    return (points >= view[:2]).all(axis=1) & (points <= view[2:]).all(axis=1)


def draw(boundary, rigid, contact, title, pictures):
    view = pictures.window
    size = max(view[2] - view[0], view[3] - view[1]) if view else boundary.diameter
    x, u = (np.concatenate([element[key] for element in boundary.elements]) for key in "xu")
    scale = scale_of(size, u[within(x, view)] if view else u, contact)
    low, high = (np.array(view[:2]), np.array(view[2:])) if view else (
        np.minimum(x, x + scale * u).min(axis=0), np.maximum(x, x + scale * u).max(axis=0))
    if boundary.revolves:
        rigid = with_images(rigid)
        low = low if view else np.array([-high[0], low[1]])
    room = shape_of(*(high - low), 5.5)
    figure, axes = pictures.subplots(figsize=(room[0] + 1.3, room[1] + 1.9))
    for k, loop in enumerate(boundary.loops()):
        x = np.concatenate([element["x"] for element in loop])
        u = np.concatenate([element["u"] for element in loop])
        for side in ([1, 1], [-1, 1])[:1 + boundary.revolves]:  # and its image behind the axis
            first = not k and side == [1, 1]
            axes.plot(*(side * x).T, color="grey", lw=0.8, ls="--",
                      label="undeformed" if first else "_")
            axes.plot(*(side * (x + scale * u)).T, color=COLOURS[0], lw=1.6,
                      label="deformed, displacement x %g (gaps are not)" % scale if first else "_")
    arrow = arrows(axes, boundary, size, scale, pictures)
    shown = axes.dataLim
    if view:
        axes.set_xlim(view[0], view[2])
        axes.set_ylim(view[1], view[3])
    solid = draw_rigid(axes, rigid, scale, (view[0], view[2], view[1], view[3]) if view else roomy(
        shown.min, shown.max)) if rigid else []
    equal_axes(axes, *(high - low), pictures.looks)
    pictures.title(axes, title + ": deformed outline and tractions")
    pictures.legend(axes, {drawn.get_label(): drawn
                           for drawn in (*axes.get_lines()[:2], *solid, *arrow)})
    pictures.save(figure, "deformed")


def arrows(axes, boundary, size, scale, pictures):
    """The force on each piece of the boundary, by the length of a piece; where it is larger than
    could be drawn, arrows are cut.  Returns what the legend shows of them."""
    points, tractions = zip(*(piece for side in boundary.sides()
                              for piece in pieces(side, 0.03 * size, scale)))
    points, tractions = np.array(points), np.array(tractions)
    if pictures.window:
        x0, y0, x1, y1 = pictures.window
        here = within(points, (x0 - 0.1 * size, y0 - 0.1 * size, x1 + 0.1 * size, y1 + 0.1 * size))
        points, tractions = points[here], tractions[here]
    sizes = np.hypot(*tractions.T)
    if not sizes.max(initial=0) > 0:
        return []
    cap = min(sizes.max(), 5 * np.quantile(sizes[sizes > 1e-3 * sizes.max()], 0.75))
    shown = tractions * np.minimum(1, cap / np.maximum(sizes, 1e-300))[:, None]
    shown *= 0.15 * size / cap
    axes.quiver(*points.T, *shown.T, angles="xy", scale_units="xy", scale=1,
                color=COLOURS[1], width=0.003)
    axes.update_datalim(points + shown)
    axes.autoscale_view()
    text = pictures.looks.label("mean traction on the body, longest arrow %.3g" % cap, "stress")
    if cap < sizes.max():
        text += "; cut there (largest %.3g)" % sizes.max()
    return [Line2D([], [], color=COLOURS[1], marker=">", lw=1, label=text)]


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
