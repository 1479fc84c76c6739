"""A field inside the body, on triangles that end at the boundary's elements."""
import base64
import os
import xml.etree.ElementTree as xml

import numpy as np
from matplotlib.tri import Triangulation

from epafi.plot.bodies import draw_rigid, revolves, roomy, with_images
from epafi.plot.figures import equal_axes, shape_of
from epafi.tables import Table, own, read

NAMES = {"ux": "displacement in x", "uy": "displacement in y", "sxx": r"$\sigma_{xx}$",
         "syy": r"$\sigma_{yy}$", "sxy": r"$\sigma_{xy}$", "szz": r"$\sigma_{zz}$",
         "hoop": "hoop stress", "von_mises": "von Mises stress", "principal_1": "larger principal stress",
         "principal_2": "smaller principal stress",
         "temperature": "temperature"}
# Of the area, that may be beyond the ends of the colours: singular stresses are.
BEYOND = 1e-3
TYPES = {"Float64": "<f8", "Int64": "<i8", "Int32": "<i4", "UInt8": "u1"}


def arrays(file):
    """The data of a .vtu by names; vectors as rows."""
    result = {}
    try:
        root = xml.parse(file).getroot()
    except xml.ParseError as error:
        raise ValueError("'%s' cannot be read: %s" % (file, error)) from error
    for item in root.iter("DataArray"):
        values = np.frombuffer(base64.b64decode(item.text)[8:], TYPES[item.get("type")])
        components = int(item.get("NumberOfComponents"))
        result[item.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return result


class Inside:
    """What fields.vtu holds: points (n, 2), corners (m, 3), values by name (n,); of solids of
    revolution also the other half of the section."""

    def __init__(self, file):
        read = arrays(file)
        self.points = read["Points"][:, :2]
        self.corners = read["connectivity"].reshape(-1, 3)
        self.values = {name: read[name] for name in NAMES if name in read}
        self.values["displacement"] = read["displacement"][:, :2]
        self.revolves = revolves(self.values, self.points[:, 0])
        if self.revolves:
            self.add_image()

    def add_image(self):
        """The other half of the section."""
        self.corners = np.vstack([self.corners, self.corners[:, ::-1] + len(self.points)])
        self.points = np.vstack([self.points, self.points * [-1, 1]])
        for name, values in self.values.items():
            odd = {"ux": -1, "sxy": -1, "displacement": [-1, 1]}.get(name, 1)
            self.values[name] = np.concatenate([values, values * odd])


def on_boundary(folder, step):
    """Points of the boundary, and fields there, exact ones of the traction and of the strain along it; at a
    step, else at the last one."""
    if step:
        found = arrays(own(folder, os.path.join("steps", str(step), "boundary.vtu")))
        points, moved = found["Points"], found["displacement"]
    else:
        found = read(folder, "boundary.csv") or {"x": np.zeros(0), "y": np.zeros(0)}
        points, moved = (np.column_stack([found[x], found[y]]) if x in found else np.zeros((0, 2))
                         for x, y in (("x", "y"), ("ux", "uy")))
    columns = {"ux": moved[:, 0], "uy": moved[:, 1],
               **{name: found[name] for name in NAMES if name in found}}
    return points[:, :2], columns


def known(name, file, folder, step, window=None):
    """Wherever a field is known: points and values.  Of `file`, see draw_field, of the fields.vtu beside it
    and of the boundary, so that a window holds what the whole has there."""
    parts = [on_boundary(folder, step)]
    if window is not None:
        cells = Table(file)
        parts.append((np.column_stack([cells["x"], cells["y"]]), cells.columns))
        file = os.path.join(os.path.dirname(file), "fields.vtu")
    if os.path.isfile(file):
        inside = Inside(file)
        parts.append((inside.points, inside.values))
    parts = [(x, values[name]) for x, values in parts if name in values]
    if not parts:
        return np.zeros((0, 2)), np.zeros(0)
    x, values = (np.concatenate(part) for part in zip(*parts))
    here = np.isfinite(values)
    if window is not None:
        here &= ((x >= window[:2]) & (x <= window[2:])).all(axis=1)
    return x[here], values[here]


def shares(points, corners):
    """Of each point a third of the area of its triangles."""
    a, b, c = (points[corners[:, k]] for k in range(3))
    area = 0.5 * ((b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0])
    result = np.zeros(len(points))
    np.add.at(result, corners, area[:, None] / 3)
    return result


def range_of(values, weights):
    """The values between which all but BEYOND of the area lies."""
    order = np.argsort(values)
    share = np.cumsum(weights[order]) / np.sum(weights)
    low, high = (values[order[min(np.searchsorted(share, part), len(order) - 1)]]
                 for part in (BEYOND / 2, 1 - BEYOND / 2))
    size = max(abs(low), abs(high))
    if high - low > 1e-6 * size:
        return low, high
    return low - size - 1e-300, high + size + 1e-300  # rounding is no field


def limits(values, weights, name, everything):
    """Ends of the colours, their map, and which ends any of the known values lie beyond."""
    low, high = range_of(values, weights)
    signed = low < 0 < high and name != "von_mises"
    if signed:
        high = max(high, -low)
        low = -high
    cut = "min" * bool(everything.min() < low) + "max" * bool(everything.max() > high)
    return low, high, "RdBu_r" if signed else "viridis", cut


def finish(figure, axes, drawn, cut, values, name, title, extent, pictures):
    place = axes.inset_axes([1.02, 0, 0.2 / axes.figure.get_figwidth(), 1])  # as high as the body
    bar = figure.colorbar(drawn, cax=place,
                          extend={"": "neither", "minmax": "both"}.get(cut, cut))
    bar.set_label(pictures.looks.field_label("", name))
    axes.grid(False)
    equal_axes(axes, *extent, pictures.looks)
    if np.ptp(values) == 0:
        axes.text(0.5, 0.5, "%s is %g everywhere" % (NAMES[name], values[0]), ha="center",
                  transform=axes.transAxes, bbox={"facecolor": "white"})
    # not beside the bar, which may be too low for words
    pictures.title(axes, "%s: %s" % (title, NAMES[name]) +
                   {"": "", "max": ", up to %.3g" % values.max(), "min": ", down to %.3g" % values.min(),
                    "minmax": ", from %.3g to %.3g" % (values.min(), values.max())}[cut])
    pictures.save(figure, name)


def figure_for(extent, pictures):
    size = shape_of(*extent, 8)
    return pictures.subplots(figsize=(size[0] + 1.6, size[1] + 1.0))


def draw(inside, name, everything, rigid, title, pictures):
    if name not in inside.values:
        raise ValueError("there is no field %r here; fields: %s" % (
            name, ", ".join(each for each in NAMES if each in inside.values)))
    values = inside.values[name]
    low, high, colours, cut = limits(values, shares(inside.points, inside.corners), name,
                                     everything)
    extent = np.ptp(inside.points, axis=0)
    figure, axes = figure_for(extent, pictures)
    x, y = inside.points.T
    drawn = axes.tripcolor(Triangulation(x, y, inside.corners), values, shading="gouraud",
                           vmin=low, vmax=high, rasterized=True, cmap=colours)
    if rigid:
        if inside.revolves:
            rigid = with_images(rigid)
        draw_rigid(axes, rigid, 0, roomy(inside.points.min(axis=0), inside.points.max(axis=0)))
    finish(figure, axes, drawn, cut, everything, name, title, extent, pictures)


def filled(image):
    """Cells without a value get the mean of their neighbours', as far as they touch any: the
    picture is cut at the outline, which runs through cells."""
    for _ in range(3):
        padded = np.pad(image, 1, constant_values=np.nan)
        around = np.stack([padded[1 + j:padded.shape[0] - 1 + j, 1 + i:padded.shape[1] - 1 + i]
                           for j in (-1, 0, 1) for i in (-1, 0, 1)])
        known = np.isfinite(around)
        mean = np.where(known, around, 0).sum(axis=0) / np.maximum(known.sum(axis=0), 1)
        image = np.where(np.isfinite(image) | ~known.any(axis=0), image, mean)
    return image


def draw_window(cells, name, everything, outline, rigid, title, pictures):
    """Of middles of equal cells; those outside of the bodies are missing.  `everything`: known values,
    `outline`: the path of the bodies."""
    values = cells[name]
    low, high, colours, cut = limits(values, np.ones(len(values)), name, everything)
    (x, column), (y, row) = (np.unique(cells[axis], return_inverse=True) for axis in ("x", "y"))
    image = np.full((len(y), len(x)), np.nan)
    image[row, column] = values
    steps = [np.diff(axis).min() for axis in (x, y) if len(axis) > 1] or [1.0]
    extent = (x[0] - steps[0] / 2, x[-1] + steps[0] / 2, y[0] - steps[-1] / 2, y[-1] + steps[-1] / 2)
    shape = (extent[1] - extent[0], extent[3] - extent[2])
    figure, axes = figure_for(shape, pictures)
    drawn = axes.imshow(filled(image), origin="lower", extent=extent, interpolation="bilinear",
                        vmin=low, vmax=high, cmap=colours)
    drawn.set_clip_path(outline, axes.transData)
    draw_rigid(axes, rigid, 0, extent)
    finish(figure, axes, drawn, cut, everything, name, title, shape, pictures)
