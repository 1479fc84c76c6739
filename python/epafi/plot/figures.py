"""What all pictures share: their looks, their files, lines on logarithmic axes."""
import math
import os

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter

STYLE = {"figure.dpi": 110, "savefig.bbox": "tight", "axes.grid": True, "grid.alpha": 0.3,
         "legend.fontsize": 8, "axes.titlesize": 11, "lines.markersize": 4,
         "svg.hashsalt": "epafi"}

MARKERS = "os^vD<>Pph*X"


class Pictures:
    """Writes figures into a folder and remembers their names."""

    def __init__(self, folder):
        self.folder = folder
        self.names = []

    def save(self, figure, name):
        for ending in ("png", "svg"):
            figure.savefig(os.path.join(self.folder, "%s.%s" % (name, ending)),
                           dpi=figure.dpi)
        plt.close(figure)
        self.names.append(name)


LINES = ("-", "--", ":", "-.")


def styles_of(names):
    """{name: how it is drawn} for the variants of a study.  Names that share what stands before
    their first comma ("graded hp", "graded hp, projected") share colour and marker."""
    split = {name: name.partition(", ") for name in names}
    families = list(dict.fromkeys(family for family, _, _ in split.values()))
    kinds = list(dict.fromkeys(kind for _, _, kind in split.values()))
    return {name: family_style(families.index(family), kinds.index(kind))
            for name, (family, _, kind) in split.items()}


def family_style(family, kind):
    strong = family < 10
    return {"marker": MARKERS[family % len(MARKERS)],
            "color": plt.get_cmap("tab20")(2 * (family % 10) + (0 if strong else 1)),
            "ls": LINES[(kind + (0 if strong else 1)) % len(LINES)]}


def slope(x, y):
    """Exponent r of y ~ x^-r, least squares over the last two thirds of the levels."""
    good = np.isfinite(x) & np.isfinite(y) & (x > 0) & (y > 0)
    x, y = np.log(x[good]), np.log(y[good])
    first = len(x) // 3
    if len(x) - first < 2 or np.ptp(x[first:]) == 0:
        return None
    return -np.polyfit(x[first:], y[first:], 1)[0]


def with_slope(label, x, y):
    rate = slope(x, y)
    return label if rate is None else "%s (rate %.2f)" % (label, rate)


def loglog(axes, x, y, label, counted=None, gaps=False, **style):
    """A line with markers, hollow where a value does not count; whether there was any.
    With gaps, the line breaks where a value is missing, and no rate is given."""
    good = np.isfinite(x) & np.isfinite(y) & (x > 0) & (y > 0)
    if not good.any():
        return False
    if gaps and not good.all():
        axes.loglog(x, np.where(good, y, math.nan), label=label, **style)
        return True
    counted = good if counted is None else good & counted
    line, = axes.loglog(x[good], y[good], markevery=list(np.flatnonzero(counted[good])),
                        label=with_slope(label, x[counted], y[counted]), **style)
    hollow = good & ~counted
    if hollow.any():
        axes.loglog(x[hollow], y[hollow], ls="", marker=style.get("marker", "o"),
                    mfc="white", mec=line.get_color(), label="_")
    return True


def power_of_ten(value):
    """2 x 10^-4 as matplotlib sets it."""
    exponent = math.floor(math.log10(value) + 1e-9)
    factor = round(value / 10.0**exponent)
    return "$%s10^{%d}$" % ("" if factor == 1 else r"%d\times" % factor, exponent)


def plain_ticks(axis):
    """1, 2, 5, 10 ... in plain digits on a logarithmic axis, 1, 10 ... on a long one; where
    digits would grow long, powers."""
    low, high = axis.get_view_interval()
    axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 60 * low else (1,)))
    plain = low >= 9e-4 and high <= 2e5
    axis.set_major_formatter(FuncFormatter(lambda value, _: "%g" % value if plain
                                           else power_of_ten(value)))
    axis.set_minor_formatter(NullFormatter())


def shape_of(width, height, room):
    """Size in inches of equal axes for a body, within room inches each way."""
    larger = max(width, height)
    return (max(room * width / larger, 0.25 * room), max(room * height / larger, 0.12 * room))


def equal_axes(axes, width, height):
    """x and y on one scale, with no more ticks than there is room for labels."""
    axes.set_aspect("equal")
    axes.set_xlabel("x")
    axes.set_ylabel("y")
    larger = max(width, height)
    for axis, extent in ((axes.xaxis, width), (axes.yaxis, height)):
        axis.set_major_locator(MaxNLocator(nbins=max(2, round(7 * extent / larger)),
                                           steps=[1, 2, 5, 10]))
