"""A scene before it is solved: boundaries with their names and conditions, loads as arrows, what acts on whole
bodies as words, obstacles where their gap puts them."""
import numpy as np
from matplotlib.lines import Line2D

from epafi.plot.boundary import on_arc
from epafi.plot.figures import equal_axes, plain, plt, shape_of
from epafi.tables import Table

COLOURS = {"Dirichlet": "C1", "Neumann": "C0", "Contact": "C2", "free": "black", "rigid": "grey",
           "symmetry": "C3", "axis": "C3"}
LINES = "symmetry", "axis"  # which the legend names


def runs_of(table):
    """Slices of points that follow each other on one boundary, elements together."""
    keys = [table["body"].astype(str), table["boundary"].astype(str)]
    step = np.hypot(np.diff(table["x"]), np.diff(table["y"]))
    room = 1e-9 * max(np.ptp(table["x"]), np.ptp(table["y"]))
    element = np.diff(table["element"]) != 0
    fresh = np.any([key[1:] != key[:-1] for key in keys], axis=0) | (element & (step > room))
    starts = np.append(0, np.flatnonzero(fresh) + 1)
    return [slice(a, b) for a, b in zip(starts, [*starts[1:], table.size])]


def fill_rigid(axes, table):
    """Their areas: which side of a line is solid."""
    rigid = np.flatnonzero(table["condition"] == "rigid")
    if not rigid.size:
        return
    x, y, body = table["x"][rigid], table["y"][rigid], table["body"][rigid]
    apart = np.hypot(np.diff(x), np.diff(y)) > 1e-9 * max(np.ptp(table["x"]), np.ptp(table["y"]))
    for loop in np.split(np.arange(len(x)), np.flatnonzero(apart | (body[1:] != body[:-1])) + 1):
        starts = np.flatnonzero(np.diff(table["element"][rigid][loop])) + 1
        lines = [on_arc(points) for points in np.split(np.column_stack([x[loop], y[loop]]), starts)]
        axes.fill(*np.concatenate(lines).T, color="0.85", zorder=0)


def write_names(axes, table, names):
    """Beside the middle of each (is free, part, colour), inside if there is room; free ones that
    would stand upon others are left out."""
    figure, taken = axes.figure, []
    figure.canvas.draw()
    for free, part, colour in names:
        middle = (part.stop - part.start) // 2
        words, contact = (str(table[column][part][0]) for column in ("boundary", "contact_name"))
        words += " (%s)" % contact if contact else ""
        at, n = ([float(table[column][part][middle]) for column in both]
                 for both in (("x", "y"), ("nx", "ny")))
        for away in (-9, 9, -20, 20, -31, 31):  # points, along the outward normal
            side = -n[0] if away < 0 else n[0]
            text = axes.annotate(
                plain(words), at, xytext=(away * n[0], away * n[1]),
                textcoords="offset points", fontsize="small", color=colour, va="center", zorder=6,
                ha="left" if side > 0.5 else "right" if side < -0.5 else "center",
                bbox={"facecolor": "white", "alpha": 0.7, "lw": 0, "pad": 0.5})
            box = text.get_window_extent()
            if not any(box.overlaps(other) for other in taken):
                taken.append(box)
                break
            text.remove()
        else:
            if not free:
                axes.add_artist(text)


def notes_of(table):
    """What acts on whole bodies, in words by name, and the boundaries."""
    is_note = table["condition"] == "note"
    notes = dict(zip(table["body"][is_note], table["contact_name"][is_note]))
    return notes, Table.of({name: column[~is_note] for name, column in table.columns.items()})


def write_notes(axes, notes):
    """Below the picture, a line for all bodies of which the same is said."""
    lines = []
    for words in dict.fromkeys(notes.values()):
        lines.append("%s: %s" % (", ".join(name for name in notes if notes[name] == words), words))
    axes.annotate(plain("\n".join(lines)), (0, 0), xycoords="axes fraction", xytext=(0, -38),
                  textcoords="offset points", fontsize="small", va="top")


def draw(table, title, file, looks):
    """Into a file of its own name."""
    with plt.rc_context(looks.style()):
        figure = figure_of(table, title, looks)
        figure.savefig(file, dpi=figure.dpi, bbox_inches=None if looks.size else "tight")
        plt.close(figure)


def figure_of(table, title, looks):
    told, table = notes_of(table)
    x, y = table["x"], table["y"]
    extent = np.ptp(x), np.ptp(y)
    size = shape_of(*extent, 7)
    figure, axes = plt.subplots(figsize=looks.size or (size[0] + 2.5, size[1] + 1.2))
    larger = max(extent)
    tx, ty, gap = (table.numbers(name) for name in ("tx", "ty", "gap"))
    largest = max(np.nanmax(np.hypot(tx, ty), initial=0), 1e-300)
    met, names = {}, []
    fill_rigid(axes, table)
    for part in runs_of(table):
        kind = "Contact" if table["contact_name"][part][0] else str(table["condition"][part][0])
        colour = met.setdefault(kind, COLOURS[kind])
        ends = table["element"][part]
        nodes = np.append(np.flatnonzero(np.diff(ends)), len(ends) - 1)
        lines = [on_arc(points) for points in np.split(np.column_stack([x[part], y[part]]), nodes[:-1] + 1)]
        axes.plot(*np.concatenate(lines).T, color=colour, lw=2.5, zorder=2)
        axes.plot(x[part][nodes], y[part][nodes], ".", color=colour, ms=5, zorder=3)
        if kind not in LINES:
            names.append((kind == "free", part, colour))
        here = np.isfinite(gap[part])
        if here.any():
            near = np.minimum(gap[part][here], 0.15 * larger)  # far ones would widen the view
            axes.plot(x[part][here] + near * table["nx"][part][here],
                      y[part][here] + near * table["ny"][part][here], color="grey", lw=1.2)
            met["obstacle at its gap"] = "grey"
    loaded = np.hypot(tx, ty) > 1e-6 * largest
    loaded[np.isnan(tx)] = False
    if loaded.any():
        scale = 0.12 * larger / largest
        axes.quiver(x[loaded], y[loaded], scale * tx[loaded], scale * ty[loaded], color="C0",
                    angles="xy", scale_units="xy", scale=1, width=0.003, zorder=4)
        axes.update_datalim(np.column_stack([x + scale * tx, y + scale * ty])[loaded])
        met[looks.label("traction, up to %.3g" % largest, "stress")] = "C0"
    axes.margins(0.15)
    equal_axes(axes, *extent, looks)
    write_names(axes, table, sorted(names, key=lambda name: name[0]))
    write_notes(axes, told)
    axes.legend([Line2D([], [], color=colour, lw=2) for colour in met.values()], list(met),
                loc="upper left", bbox_to_anchor=(1, 1))
    if looks.title:
        axes.set_title(plain(title))
    return figure
