"""mesh: elements, their sizes and degrees."""
import numpy as np
from matplotlib.colors import BoundaryNorm, ListedColormap

from epafi.plot.figures import equal_axes, plain_ticks, plt, shape_of


def outward(tangent):
    """Outward normal: the body lies to the left.  Zero of a tangent that rounding made zero."""
    return np.array([tangent[1], -tangent[0]]) / (np.hypot(*tangent) or 1)


def arc_length(element):
    return np.hypot(*np.diff(element["x"], axis=0).T).sum()


def broken(pieces):
    """x and y of one line through all pieces, broken between them: it draws as fast as one."""
    gap = np.full((1, 2), np.nan)
    return np.concatenate([part for piece in pieces for part in (piece, gap)] or [gap]).T


def degree_colours(elements):
    low = min(element["degree"] for element in elements)
    high = max(element["degree"] for element in elements)
    count = high - low + 1
    colours = plt.get_cmap("plasma_r")(np.linspace(0.2, 1, count))
    return (ListedColormap(colours),
            BoundaryNorm(np.arange(low - 0.5, high + 1), count), range(low, high + 1))


def draw(boundary, title, pictures):
    colours, norm, degrees = degree_colours(boundary.elements)
    width, height = boundary.extent
    room = shape_of(width, height, 4.4)
    beside = height > 0.4 * width  # a flat body's outline stands above its sizes
    figure, (outline, sizes) = pictures.subplots(
        *((1, 2) if beside else (2, 1)), figsize=(room[0] + 6.6, 4.8) if beside else (9, 6.6),
        gridspec_kw={"width_ratios": [room[0], 5.5]} if beside else {"height_ratios": [1, 2]})
    tick = 0.015 * boundary.diameter
    for degree in degrees:
        outline.plot(*broken([element["x"] for element in boundary.elements
                              if element["degree"] == degree]),
                     color=colours(norm(degree)), lw=3, solid_capstyle="butt")
    ticks = []
    for element in boundary.elements:
        x = element["x"]
        for end, tangent in ((x[0], x[1] - x[0]), (x[-1], x[-1] - x[-2])):
            ticks.append(end + np.outer([-tick, tick], outward(tangent)))
    outline.plot(*broken(ticks), color="black", lw=0.6)
    equal_axes(outline, width, height, pictures.looks)
    outline.grid(False)
    outline.set_title("elements and degrees")

    at = 0
    bars = {degree: [] for degree in degrees}
    for loop in boundary.loops():
        for element in loop:
            length = arc_length(element)
            bars[element["degree"]].append(np.array([
                [at, length], [at + length / 2, length], [at + length, length]]))
            at += length
        sizes.axvline(at, color="grey", lw=0.5)
    for degree, steps in bars.items():
        sizes.semilogy(*broken(steps), lw=4, color=colours(norm(degree)), solid_capstyle="butt",
                       marker="o", ms=3, markevery=slice(1, None, 4))  # short ones too
    low, high = sizes.dataLim.intervaly
    if high < 2 * low:  # one size: rounding is no structure
        low, high = 0.5 * low, 2 * high
    sizes.set_ylim(0.8 * low, 1.25 * high)
    plain_ticks(sizes.yaxis)
    sizes.set_xlabel(pictures.looks.label(
        "length along the outline, holes after it", "length"))
    sizes.set_ylabel(pictures.looks.label("element size h", "length"))
    sizes.set_title("%d elements, %s" % (
        len(boundary.elements), "p = %d" % degrees[0] if len(degrees) == 1 else
        "p = %d to %d" % (degrees[0], degrees[-1])))
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, colours), ax=sizes,
                          ticks=list(degrees), label="degree p")
    bar.ax.minorticks_off()
    pictures.title(figure, title + ": mesh")
    pictures.save(figure, "mesh")
