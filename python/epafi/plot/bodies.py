"""Bodies without elasticity, of solution.hdf."""
import os

import numpy as np
from matplotlib.patches import PathPatch
from matplotlib.path import Path

from epafi.runs import opened
from epafi.tables import own, used_of


def rigid_outlines(folder, elastic, moved=None):
    """(points, displacements) of each: arrays (2n, 2), the ends of n lines along its outline and
    its holes; `elastic`: how many bodies of the file deform, they stand before the others;
    `moved`: other displacements than the file's."""
    file, root = own(folder, "solution.hdf"), used_of(folder)
    solid = ".//ParameterList[@name='Material']/Parameter[@name='Rigid'][@value='true']"
    if not os.path.isfile(file) or root is not None and root.find(solid) is None:
        return []
    with opened(file) as content:
        grid = content["VTKHDF"]
        body = grid["CellData/body"][()]
        ends = grid["Connectivity"][()].reshape(-1, 2)
        x = grid["Points"][()][:, :2]
        u = (grid["PointData/displacement"][()] if moved is None else moved)[:, :2]
    return [(x[lines.ravel()], u[lines.ravel()])
            for lines in (ends[body == b] for b in range(elastic, body.max() + 1))]


def revolves(columns, x):
    """Are these solids of revolution whose pictures show the whole section?  Not of rings so far from
    the axis that little could be seen of them."""
    return "hoop" in columns and x.min() < 0.5 * x.max()


def with_images(outlines):
    """Of solids of revolution both halves of their sections."""
    return [half for x, u in outlines for half in ((x, u), (x * [-1, 1], u * [-1, 1]))]


def draw_rigid(axes, outlines, scale, view):
    """Fills them where they are in the view (x0, x1, y0, y1), moved by scale times their
    displacements; returns what the legend shows of them."""
    axes.set_xlim(view[:2])
    axes.set_ylim(view[2:])
    patches = []
    for x, u in outlines:
        places = x + scale * u
        follows = np.append(False, (places[2::2] == places[1:-1:2]).all(axis=1))
        codes = np.full(len(places), Path.LINETO)
        codes[::2][~follows] = Path.MOVETO
        patches.append(axes.add_patch(PathPatch(Path(places, codes), facecolor="0.85", lw=1,
                                                edgecolor="0.4", zorder=0.5, label="rigid")))
    return patches[:1]


def roomy(low, high, margin=0.08):
    """A view around a box, its margins those of the larger side."""
    room = margin * max(high - low)
    return low[0] - room, high[0] + room, low[1] - room, high[1] + room
