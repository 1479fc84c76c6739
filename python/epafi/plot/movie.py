"""movie: the outlines of all bodies around the contact at steps of a path, moved by the
displacements; none where nothing can touch."""
import base64
import os
import xml.etree.ElementTree as xml

import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter

from epafi.plot.deformed import round_down
from epafi.plot.figures import equal_axes, plt, shape_of

SHOWN = 120  # steps drawn at most
TYPES = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}


def arrays(file):
    """The data of a .vtu by names; vectors as rows."""
    result = {}
    for item in xml.parse(file).getroot().iter("DataArray"):
        values = np.frombuffer(base64.b64decode(item.text)[8:], TYPES[item.get("type")])
        components = int(item.get("NumberOfComponents"))
        result[item.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return result


def outlines(step):
    """Per body its lines as x, y with a break behind each."""
    ends = step["connectivity"].reshape(-1, 2)
    for body in np.unique(step["body"]):
        yield body, ends[step["body"] == body]


def broken(points, lines):
    path = np.full((3 * len(lines), 2), np.nan)
    path[0::3], path[1::3] = points[lines[:, 0], :2], points[lines[:, 1], :2]
    return path.T


def draw(folder, rows, title, pictures):
    files = [os.path.join(folder, "steps", "%d" % step, "boundary.vtu") for step in rows["step"]]
    if not all(os.path.isfile(file) for file in files):
        return
    chosen = sorted({round(k) for k in np.linspace(0, len(files) - 1, min(SHOWN, len(files)))})
    steps = [arrays(files[k]) for k in chosen]
    # what happens is at the contact: that is what fills the picture
    touching = steps[0]["contact"] >= 0
    if not touching.any():
        return
    points = steps[0]["Points"]
    low, high = points[touching].min(axis=0)[:2], points[touching].max(axis=0)[:2]
    width = 2 * max(high - low)
    middle = (low + high) / 2
    near = (np.abs(points[:, :2] - middle) < width / 2).all(axis=1)
    largest = max(np.hypot(*step["displacement"][near].T[:2]).max() for step in steps)
    scale = round_down(0.15 * width / largest) if largest > 0 else 1
    size = shape_of(width, width, 5)
    figure, axes = plt.subplots(figsize=(size[0] + 1, size[1] + 1))
    for body, lines in outlines(steps[0]):
        axes.plot(*broken(points, lines), color="grey", lw=0.6, ls=":")
    moved = [axes.plot([], [], color="C%d" % (body % 10), lw=1.5)[0]
             for body, _ in outlines(steps[0])]
    equal_axes(axes, width, width)
    axes.set_xlim(middle[0] - width / 2, middle[0] + width / 2)
    axes.set_ylim(middle[1] - width / 2, middle[1] + width / 2)

    def show(k):
        step = steps[k]
        places = step["Points"] + scale * step["displacement"]
        for line, (_, lines) in zip(moved, outlines(step)):
            line.set_data(*broken(places, lines))
        axes.set_title("%s, t = %.4g, displacement x %g" % (title, rows["t"][chosen[k]], scale))
        return moved

    movie = FuncAnimation(figure, show, frames=len(steps))
    movie.save(os.path.join(pictures.folder, "movie.gif"), PillowWriter(fps=8), dpi=80)
    plt.close(figure)
