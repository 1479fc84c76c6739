"""What all pictures share: their looks, their files, lines on logarithmic axes."""
from __future__ import annotations

import dataclasses
import math
import re
import textwrap
from typing import Any, Collection, Mapping, Optional

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, LogLocator, MaxNLocator, NullFormatter
from matplotlib.transforms import offset_copy

from epafi.plot.looks import COLOURS, Looks, plain, units_of
from epafi.program import InputError
from epafi.tables import own

plt.draw_if_interactive()  # loads the backend: within rc_context a notebook's would lose what it sets

MARKERS = "os^vD<>Pph*X"


class Pictures:
    """Makes figures, writes them into a folder and remembers their names.

    looks     how they are drawn
    window    x0, y0, x1, y1 of the plane that pictures of bodies show; all without it
    film      the field of steps/<k>/fields.vtu that colours the movie
    only      the one picture that is wanted: it is not written, but kept with its axes
    axes      what that one is drawn into, instead of a figure of its own
    chosen    the names of the pictures that are drawn; all without it
    step      of a path, that pictures of a solution show; else that of the largest strain energy
    """

    def __init__(self, folder: str, looks: Looks = Looks(),
                 window: Optional[tuple[float, ...]] = None, film: Optional[str] = None,
                 only: Optional[str] = None, axes: Any = None,
                 chosen: Optional[Collection[str]] = None, step: Optional[int] = None) -> None:
        if window is not None and not (np.shape(window) == (4,) and window[0] < window[2]
                                       and window[1] < window[3]):
            raise InputError("window: %r is not (x0, y0, x1, y1), two corners, the lower left one "
                             "first" % (window,))
        if looks.units is None:
            looks = dataclasses.replace(looks, units=units_of(folder))
        self.folder, self.looks, self.window = folder, looks, window
        self.film, self.only, self.chosen, self.step = film, only, chosen, step
        self.names: list[str] = []
        self.named: dict[str, Any] = {}  # of the legend of all axes
        self.small = False  # less than what the figure is made for
        self.folded = False  # axes in two rows instead of one
        self.given = None if axes is None else np.atleast_1d(axes).ravel()
        self.axes: Any = None

    def wants(self, name: str) -> bool:
        return name == self.only if self.only else self.chosen is None or name in self.chosen

    def subplots(self, rows: int = 1, columns: int = 1, **how: Any) -> tuple[Figure, Any]:
        """A figure and its axes: one, a row or column (n,), or (rows, columns)."""
        self.named = {}
        if self.given is None:
            if self.looks.size:
                self.small = (np.array(self.looks.size) < how["figsize"]).any()
                how["figsize"] = self.looks.size
            self.folded = self.small and rows == 1 and columns > 2
            figure, axes = plt.subplots(
                *((2, (columns + 1) // 2) if self.folded else (rows, columns)), squeeze=False, **how)
            for spare in axes.flat[rows * columns:]:
                spare.remove()
            axes = axes.ravel()[:rows * columns].reshape(rows, columns)
        else:
            if len(self.given) != rows * columns:
                raise ValueError("'%s' is drawn into %d axes, %d rows of %d; given: %d" % (
                    self.only, rows * columns, rows, columns, len(self.given)))
            figure, axes = self.given[0].figure, self.given.reshape(rows, columns)
            for each in self.given:
                each.set_prop_cycle(color=COLOURS)
        self.axes = axes.squeeze() if axes.size > 1 else axes[0, 0]
        return figure, self.axes

    def title(self, where: Any, text: str) -> None:
        """Of a figure, if it is one's own, or of axes."""
        if self.looks.title and isinstance(where, Figure):
            if self.given is None:
                where.suptitle(text)
        elif self.looks.title:
            where.set_title(text)

    def legend(self, axes: Any, named: Optional[Mapping[str, Any]] = None, **where: Any) -> None:
        """Of what axes have, or of artists by name; without a place below them, in a small picture
        below all."""
        if named is None:
            named = {text: drawn for drawn, text in zip(*axes.get_legend_handles_labels())}
        if self.given is None and (self.small or not where):
            self.named.update({text.split(" (rate ")[0] if self.small else text: drawn
                               for text, drawn in named.items()})
        else:
            axes.legend(named.values(), named, **(where or {
                "loc": "upper center", "bbox_to_anchor": (0.5, 0), "bbox_transform": offset_copy(
                    axes.transAxes, axes.figure, 0, -5 * self.looks.font, "points")}))

    def fit(self, figure: Figure) -> None:
        """The legend below all axes; words in lines as long as there is room for, and ticks as
        many."""
        # in the place without axes, if they fit there
        spare = self.folded and len(figure.axes) % 2 and len(self.named) < 8
        for columns in range(1 if spare else 6, 0, -1) if self.named else ():
            legend = figure.legend(self.named.values(), self.named, ncol=columns,
                                   loc="lower right" if spare else "lower center")
            for text in legend.get_texts() if columns == 1 else ():
                wrap(text, 0.8 * figure.bbox.width)
            box = legend.get_window_extent()
            if box.width < 0.97 * figure.bbox.width or columns == 1:
                foot = 0 if spare else min(0.6, box.y1 / figure.bbox.height)
                figure.get_layout_engine().set(rect=(0, foot, 1, 1 - foot))
                break
            legend.remove()
        for _ in range(6):
            figure.draw_without_rendering()  # lays it out
            changes = [wrap(text, figure.bbox.width) for text in figure.texts]
            for axes in figure.axes:
                box = axes.get_window_extent()
                above = figure.bbox.width if len(figure.axes) == 1 else box.width
                changes += [wrap(axes.title, above), wrap(axes.xaxis.label, box.width),
                            wrap(axes.yaxis.label, box.height), thin(axes)]
            if not any(changes):
                break
        for axes in 2 * figure.axes if len(figure.axes) == 1 else ():
            figure.draw_without_rendering()  # which does not lay out a bar of colours beside them
            words = figure.get_tightbbox()
            width, place = figure.get_size_inches()[0], axes.get_position()
            left, right = max(0, -words.x0) / width, max(0, words.x1 / width - 1)
            axes.set_position([place.x0 + left, place.y0, place.width - left - right, place.height])

    def save(self, figure: Figure, name: str) -> None:
        if not self.wants(re.sub(r"_\d+$", "", name)):
            plt.close(figure)
            return
        self.names.append(name)
        if self.given is None:
            self.fit(figure)  # lays it out, once for all endings
        if self.only:
            return
        box = None if self.looks.size else figure.get_tightbbox().padded(
            plt.rcParams["savefig.pad_inches"])
        with plt.rc_context({"figure.constrained_layout.use": False}):
            figure.set_layout_engine(None)
            for ending in self.looks.endings:
                # the most compression of PNG costs as much as drawing, for a tenth of the size
                fast = {"pil_kwargs": {"compress_level": 3}} if ending == "png" else {}
                figure.savefig(own(self.folder, "%s.%s" % (name, ending)), **fast,
                               dpi=figure.dpi, bbox_inches=box)
        plt.close(figure)


def short(name: str, size: int = 40) -> str:
    """A plain name, or its beginning and its end."""
    return plain(name if len(name) <= size else name[:size // 2] + " ... " + name[-size // 2:])


def wrap(text: Any, room: float) -> bool:
    """Breaks a text into lines of at most `room` pixels; whether it was longer."""
    long = text.get_window_extent().size[int(text.get_rotation() == 90)]
    words = text.get_text()
    if words and long > 1.05 * room:
        letters = int(max(map(len, words.split("\n"))) * room / long)
        text.set_text(textwrap.fill(words, max(8, letters), break_long_words=letters > 30))
    return text.get_text() != words


def thin(axes: Any) -> bool:
    """Fewer ticks below, if their labels overlap; whether they did."""
    def crowded() -> bool:
        ticks = [label.get_window_extent() for label in axes.get_xticklabels() if label.get_text()]
        return any(b.x0 < a.x1 for a, b in zip(ticks, ticks[1:]))

    if not crowded():
        return False
    for count in range(5, 0, -1):
        axes.xaxis.set_major_locator(MaxNLocator(count, min_n_ticks=1,
                                                 steps=[1, 1.5, 2, 3, 4, 5, 10]))
        if not crowded():
            break
    return True


def settle(axes: Any, size: float, which: str = "y") -> None:
    """An axis whose data differ by rounding only, of quantities as large as size, shows those'
    range: they are a straight line there."""
    low, high = axes.dataLim.intervaly if which == "y" else axes.dataLim.intervalx
    if size > 0 and high - low < 1e-9 * size:
        getattr(axes, "set_%slim" % which)(low - 0.1 * size, low + 0.1 * size)


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
    return {"marker": MARKERS[family % len(MARKERS)], "color": COLOURS[family % len(COLOURS)],
            "ls": LINES[(kind + family // len(COLOURS)) % len(LINES)]}


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


def equal_axes(axes, width, height, looks):
    """x and y on one scale, with no more ticks than there is room for labels."""
    axes.set_aspect("equal")
    axes.set_xlabel(looks.label("x", "length"))
    axes.set_ylabel(looks.label("y", "length"))
    larger = max(width, height)
    for axis, extent in ((axes.xaxis, width), (axes.yaxis, height)):
        axis.set_major_locator(MaxNLocator(nbins=max(2, round(7 * extent / larger)),
                                           steps=[1, 2, 5, 10]))
