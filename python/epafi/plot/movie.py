"""movie: all bodies around the contact, or in a window, at steps of a path, moved by the
displacements, in the colours of a field where steps/<k>/fields.vtu are; none where nothing can
touch."""
import os

import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.tri import Triangulation

from epafi.plot.deformed import scale_of, within
from epafi.plot.figures import COLOURS, equal_axes, plt, shape_of
from epafi.plot.inside import NAMES, Inside, arrays, limits, shares
from epafi.tables import own, read

SHOWN = 120  # steps drawn at most


def outlines(step):
    """Per body its lines as x, y with a break behind each."""
    ends = step["connectivity"].reshape(-1, 2)
    for body in np.unique(step["body"]):
        yield body, ends[step["body"] == body]


def broken(points, lines):
    path = np.full((3 * len(lines), 2), np.nan)
    path[0::3], path[1::3] = points[lines[:, 0], :2], points[lines[:, 1], :2]
    return path.T


def window_of(step):
    """What happens is at the contact: that is what fills the picture."""
    touching = step["Points"][step["contact"] >= 0][:, :2]
    if not touching.size:
        return None
    low, high = touching.min(axis=0), touching.max(axis=0)
    middle, half = (low + high) / 2, max(high - low)
    return (*(middle - half), *(middle + half))


def draw(folder, rows, title, pictures):
    files = [own(folder, os.path.join("steps", "%d" % step, "boundary.vtu"))
             for step in rows["step"]]
    if not all(os.path.isfile(file) for file in files):
        return
    chosen = sorted({round(k) for k in np.linspace(0, len(files) - 1, min(SHOWN, len(files)))})
    steps = [arrays(files[k]) for k in chosen]
    view = pictures.window or window_of(steps[0])
    if view is None:
        return
    field = pictures.film
    insides = [Inside(own(os.path.dirname(files[k]), "fields.vtu")) for k in chosen if field]
    points = steps[0]["Points"]
    near = within(points[:, :2], view)
    moves = np.concatenate([step["displacement"][near][:, :2] for step in steps])
    size = max(view[2] - view[0], view[3] - view[1])
    scale = scale_of(size, moves, read(folder, "contact.csv"))
    shape = shape_of(view[2] - view[0], view[3] - view[1], 5)
    figure, axes = pictures.subplots(figsize=(shape[0] + (2 if field else 1), shape[1] + 1))
    for body, lines in outlines(steps[0]):
        axes.plot(*broken(points, lines), color="grey", lw=0.6, ls=":")
    moved = [axes.plot([], [], color="black" if field else COLOURS[body % 7], lw=1.5)[0]
             for body, _ in outlines(steps[0])]
    equal_axes(axes, view[2] - view[0], view[3] - view[1], pictures.looks)
    axes.set_xlim(view[0], view[2])
    axes.set_ylim(view[1], view[3])
    drawn, colours = [], {}
    if field:
        seen = [within(inside.points, view) for inside in insides]
        values, weights = (np.concatenate(parts) for parts in zip(*(
            (inside.values[field][here], shares(inside.points, inside.corners)[here])
            for inside, here in zip(insides, seen))))
        low, high, cmap, _ = limits(values, weights, field, values)
        colours = {"vmin": low, "vmax": high, "cmap": cmap, "shading": "gouraud"}
        bar = figure.colorbar(plt.cm.ScalarMappable(plt.Normalize(low, high), cmap), ax=axes)
        bar.set_label(pictures.looks.field_label(NAMES[field], field))

    def show(k):
        step = steps[k]
        places = step["Points"] + scale * step["displacement"]
        for line, (_, lines) in zip(moved, outlines(step)):
            line.set_data(*broken(places, lines))
        for inside in insides[k:k + 1]:
            for old in drawn:
                old.remove()
            x, y = (inside.points + scale * inside.values["displacement"]).T
            drawn[:] = [axes.tripcolor(Triangulation(x, y, inside.corners), inside.values[field],
                                       zorder=0.5, **colours)]
        pictures.title(axes, "%s, t = %.4g, displacement x %g" % (
            title, rows["t"][chosen[k]], scale))
        return moved

    figure.set_dpi(80)
    show(0)
    figure.canvas.draw()  # lays it out, once for all frames
    figure.set_layout_engine("none")
    movie = FuncAnimation(figure, show, frames=len(steps))
    movie.save(own(pictures.folder, "movie.gif"), PillowWriter(fps=8), dpi=80)
    plt.close(figure)
