"""A field inside the body, on triangles that end at the boundary's elements."""
import xml.etree.ElementTree as xml

import numpy as np
from matplotlib.tri import Triangulation

from epafi.plot.figures import equal_axes, plt, shape_of

NAMES = {"ux": "displacement in x", "uy": "displacement in y", "sxx": r"$\sigma_{xx}$",
         "syy": r"$\sigma_{yy}$", "sxy": r"$\sigma_{xy}$", "szz": r"$\sigma_{zz}$",
         "von_mises": "von Mises stress", "principal_1": "larger principal stress",
         "principal_2": "smaller principal stress"}
# Of the area, that may be beyond the ends of the colours: singular stresses are.
BEYOND = 1e-3


class Inside:
    """What fields.vtu holds: points (n, 2), corners (m, 3), values by name (n,)."""

    def __init__(self, file):
        arrays = {}
        for array in xml.parse(file).getroot().iter("DataArray"):
            numbers = np.array(array.text.split(),
                               dtype=int if array.get("type") != "Float64" else float)
            width = int(array.get("NumberOfComponents") or 1)
            arrays[array.get("Name")] = numbers.reshape(-1, width) if width > 1 else numbers
        self.points = arrays.pop("Points")[:, :2]
        self.corners = arrays.pop("connectivity").reshape(-1, 3)
        self.values = {name: arrays[name] for name in NAMES}
        self.values["displacement"] = arrays["displacement"][:, :2]

    def area(self):
        """Of each triangle."""
        a, b, c = (self.points[self.corners[:, k]] for k in range(3))
        return 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])


def range_of(values, weights):
    """The values between which all but BEYOND of the area lies."""
    order = np.argsort(values)
    share = np.cumsum(weights[order]) / np.sum(weights)
    low, high = (values[order[min(np.searchsorted(share, part), len(order) - 1)]]
                 for part in (BEYOND / 2, 1 - BEYOND / 2))
    return (low, high) if high > low else (low - abs(low) - 1e-300, high + abs(high) + 1e-300)


def draw(inside, name, title, pictures):
    values = inside.values[name]
    weights = np.zeros(len(values))
    np.add.at(weights, inside.corners, inside.area()[:, None] / 3)
    low, high = range_of(values, weights)
    width, height = np.ptp(inside.points, axis=0)
    size = shape_of(width, height, 8)
    figure, axes = plt.subplots(figsize=(size[0] + 1.6, size[1] + 1.0))
    x, y = inside.points.T
    signed = low < 0 < high and name not in ("von_mises",)
    if signed:
        high = max(high, -low)
        low = -high
    drawn = axes.tripcolor(Triangulation(x, y, inside.corners), values, shading="gouraud",
                           vmin=low, vmax=high, rasterized=True,
                           cmap="RdBu_r" if signed else "viridis")
    cut = ("min" if values.min() < low else "") + ("max" if values.max() > high else "")
    bar = figure.colorbar(drawn, ax=axes, extend={"": "neither", "minmax": "both"}.get(cut, cut),
                          fraction=0.05, pad=0.02)
    bar.set_label(NAMES[name] + (" (up to %.3g)" % values.max() if "max" in cut else ""))
    axes.grid(False)
    equal_axes(axes, width, height)
    axes.set_title("%s: %s" % (title, NAMES[name]))
    pictures.save(figure, name)
