#!/usr/bin/python3
"""Pictures of a finished run or study.

    epafi_plot.py DIR      convergence, time, contributions, mesh, contact, deformed of a run;
                           convergence, time, contact_stress, work-precision, exponential,
                           effectivity, sweep of a study, and those of a run in each variant's folder

Each picture is written as .png and .svg.  Reads history.csv, contact.csv, boundary.csv and
study.csv; what a folder does not hold is left out.
"""
import csv
import math
import os
import sys

try:
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.colors import BoundaryNorm, ListedColormap
    from matplotlib.lines import Line2D
    from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter
except ImportError as error:
    sys.exit("epafi: plot: Python's matplotlib is missing (%s); install it with\n"
             "    apt-get install python3-matplotlib" % error)

plt.rcParams.update({"figure.dpi": 110, "savefig.bbox": "tight", "axes.grid": True,
                     "grid.alpha": 0.3, "legend.fontsize": 8, "axes.titlesize": 11,
                     "svg.hashsalt": "epafi"})

CONTRIBUTIONS = [("eta_neumann", "residual on Neumann sides"),
                 ("eta_contact", "residual on contact sides"),
                 ("eta_density", "residual of the density"),
                 ("eta_complementarity", "complementarity"),
                 ("eta_penetration", "penetration"),
                 ("eta_tension", "tension"),
                 ("eta_bound", "shear above its bound"),
                 ("eta_slip", "stick and slip")]
MARKERS = "os^vD<>Pph*X"


class Table:
    """A file of comma-separated values by columns; numbers where all cells are numbers."""

    def __init__(self, file):
        with open(file, newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.size = len(rows)
        self.columns = {}
        for name in rows[0] if rows else ():
            cells = [row[name] or "" for row in rows]
            try:
                self.columns[name] = np.array([float(cell) if cell else math.nan
                                               for cell in cells])
            except ValueError:
                self.columns[name] = np.array(cells)

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def numbers(self, name):
        """A numeric column; NaN where the file has none."""
        column = self.columns.get(name)
        if column is None or column.dtype.kind != "f":
            return np.full(self.size, math.nan)
        return column


def read(folder, name):
    """The table of a file, or None without the file or without rows in it."""
    file = os.path.join(folder, name)
    if not os.path.isfile(file):
        return None
    table = Table(file)
    return table if table.size else None


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
        axes.loglog(x, np.where(good, y, math.nan), label=label, ms=4, **style)
        return True
    counted = good if counted is None else good & counted
    line, = axes.loglog(x[good], y[good], markevery=list(np.flatnonzero(counted[good])),
                        label=with_slope(label, x[counted], y[counted]), ms=4, **style)
    hollow = good & ~counted
    if hollow.any():
        axes.loglog(x[hollow], y[hollow], ls="", marker=style.get("marker", "o"), ms=4,
                    mfc="white", mec=line.get_color(), label="_")
    return True


def plain_ticks(axis):
    """1, 2, 5, 10 ... in plain digits on a logarithmic axis."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: "%g" % value))
    axis.set_minor_formatter(NullFormatter())


# ---------------------------------------------------------------- one run

def total_energy(history):
    return (history.numbers("energy_strain") - history.numbers("energy_load")
            + np.nan_to_num(history.numbers("energy_friction")))


def error_curves(history):
    """What tells how far a run has come: the estimate, else the energy's distance to that of
    the last level."""
    estimate = history.numbers("estimate")
    if (estimate > 0).any():
        return [("estimate", estimate)], "estimated error"
    energy = total_energy(history)
    distance = np.abs(energy - energy[-1])
    distance[-1] = math.nan
    return [("|energy - energy of the last level|", distance)], "energy difference"


def plot_curves(history, abscissa, name, title, pictures):
    x = history.numbers(abscissa)
    figure, axes = plt.subplots(figsize=(6.4, 4.6))
    curves, label = error_curves(history)
    drawn = [loglog(axes, x, y, text, marker="o") for text, y in curves]
    if not any(drawn):
        axes.text(0.5, 0.5, "a single level: nothing to compare", ha="center",
                  transform=axes.transAxes)
    else:
        plain_ticks(axes.xaxis)
    axes.set_xlabel("degrees of freedom" if abscissa == "dof" else
                    "CPU seconds since the start, all threads")
    axes.set_ylabel(label)
    axes.set_title(title)
    if any(drawn):
        axes.legend()
    pictures.save(figure, name)


def plot_contributions(history, title, pictures):
    x = history.numbers("dof")
    figure, axes = plt.subplots(figsize=(7.2, 5))
    drawn = loglog(axes, x, history.numbers("estimate"), "estimate", color="black",
                   marker="o", lw=2)
    rounding = 1e-8 * history.numbers("estimate")
    for (name, text), marker in zip(CONTRIBUTIONS, MARKERS[1:]):
        y = history.numbers(name)
        drawn = loglog(axes, x, np.where(y > rounding, y, math.nan), text, marker=marker,
                       lw=1, gaps=True) or drawn
    if not drawn:
        plt.close(figure)
        return
    plain_ticks(axes.xaxis)
    axes.set_xlabel("degrees of freedom")
    axes.set_ylabel("contribution to the estimate")
    axes.set_title(title + ": contributions")
    axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.save(figure, "contributions")


class Boundary:
    """boundary.csv element by element."""

    def __init__(self, table):
        self.elements = []
        number = table.numbers("element")
        starts = np.flatnonzero(np.diff(number, prepend=number[0] - 1))
        for first, last in zip(starts, [*starts[1:], table.size]):
            piece = slice(first, last)
            self.elements.append({
                "x": np.column_stack([table["x"][piece], table["y"][piece]]),
                "u": np.column_stack([table["ux"][piece], table["uy"][piece]]),
                "t": np.column_stack([table["tx"][piece], table["ty"][piece]]),
                "degree": int(table["degree"][first])})
        corners = np.concatenate([element["x"] for element in self.elements])
        self.diameter = math.hypot(*np.ptp(corners, axis=0))

    def loops(self):
        """Lists of elements that follow each other; a hole starts a new one."""
        loops, end = [], None
        for element in self.elements:
            if end is None or np.hypot(*(element["x"][0] - end)) > 1e-9 * self.diameter:
                loops.append([])
            loops[-1].append(element)
            end = element["x"][-1]
        return loops


def outward(element):
    """Outward normal: the body lies to the left."""
    tangent = element["x"][-1] - element["x"][0]
    return np.array([tangent[1], -tangent[0]]) / np.hypot(*tangent)


def degree_colours(elements):
    low = min(element["degree"] for element in elements)
    high = max(element["degree"] for element in elements)
    count = high - low + 1
    colours = plt.get_cmap("plasma_r")(np.linspace(0.2, 1, count))
    return (ListedColormap(colours),
            BoundaryNorm(np.arange(low - 0.5, high + 1), count), range(low, high + 1))


def plot_mesh(boundary, title, pictures):
    colours, norm, degrees = degree_colours(boundary.elements)
    figure, (outline, sizes) = plt.subplots(1, 2, figsize=(11, 4.8),
                                            gridspec_kw={"width_ratios": [1, 1.25]})
    tick = 0.015 * boundary.diameter
    for element in boundary.elements:
        a, b = element["x"][0], element["x"][-1]
        colour = colours(norm(element["degree"]))
        outline.plot(*zip(a, b), color=colour, lw=3, solid_capstyle="butt")
        for end in (a, b):
            outline.plot(*zip(end - tick * outward(element), end + tick * outward(element)),
                         color="black", lw=0.6)
    outline.set_aspect("equal")
    outline.grid(False)
    outline.set_xlabel("x")
    outline.set_ylabel("y")
    outline.set_title("elements and degrees")

    at = 0
    for loop in boundary.loops():
        for element in loop:
            length = np.hypot(*(element["x"][-1] - element["x"][0]))
            sizes.semilogy([at, at + length], [length, length], lw=4,
                           color=colours(norm(element["degree"])), solid_capstyle="butt")
            sizes.semilogy(at + length / 2, length, "o", ms=3,  # short ones too
                           color=colours(norm(element["degree"])))
            at += length
        sizes.axvline(at, color="grey", lw=0.5)
    sizes.set_xlabel("length along the outline from its first vertex (holes after it)")
    sizes.set_ylabel("element size h")
    sizes.set_title("%d elements, %s" % (
        len(boundary.elements), "p = %d" % degrees[0] if len(degrees) == 1 else
        "p = %d to %d" % (degrees[0], degrees[-1])))
    bar = figure.colorbar(plt.cm.ScalarMappable(norm, colours), ax=sizes,
                          ticks=list(degrees), label="degree p")
    bar.ax.minorticks_off()
    figure.suptitle(title + ": mesh")
    pictures.save(figure, "mesh")


def round_down(value):
    """1, 2 or 5 times a power of ten, not above the value."""
    power = 10.0**math.floor(math.log10(value))
    return max(step * power for step in (1, 2, 5) if step * power <= value * (1 + 1e-12))


def plot_deformed(boundary, title, pictures):
    figure, axes = plt.subplots(figsize=(6.6, 6))
    largest = max(np.hypot(*element["u"].T).max() for element in boundary.elements)
    scale = round_down(0.1 * boundary.diameter / largest) if largest > 0 else 1
    for k, loop in enumerate(boundary.loops()):
        x = np.concatenate([element["x"] for element in loop])
        u = np.concatenate([element["u"] for element in loop])
        axes.plot(*x.T, color="grey", lw=0.8, ls="--", label="undeformed" if not k else "_")
        axes.plot(*(x + scale * u).T, color="C0", lw=1.6,
                  label="deformed, displacement x %g" % scale if not k else "_")
    arrow = arrows(axes, boundary, scale)
    axes.set_aspect("equal")
    axes.set_xlabel("x")
    axes.set_ylabel("y")
    axes.set_title(title + ": deformed outline and tractions")
    axes.legend(handles=[*axes.get_lines()[:2], *arrow], loc="upper center",
                bbox_to_anchor=(0.5, -0.1))
    pictures.save(figure, "deformed")


def arrows(axes, boundary, scale):
    """Tractions at evenly spaced points; where they are singular, arrows are cut.
    Returns what the legend shows of them."""
    spacing, rest = 0.03 * boundary.diameter, 0
    points, tractions = [], []
    for element in boundary.elements:
        length = np.hypot(*(element["x"][-1] - element["x"][0]))
        along = np.linspace(0, length, len(element["x"]))
        for s in np.arange(rest, length, spacing):
            points.append([np.interp(s, along, (element["x"] + scale * element["u"])[:, c])
                           for c in (0, 1)])
            tractions.append([np.interp(s, along, element["t"][:, c]) for c in (0, 1)])
        rest = (rest - length) % spacing if length < rest else spacing - (length - rest) % spacing
    points, tractions = np.array(points), np.array(tractions)
    sizes = np.hypot(*tractions.T)
    if not sizes.max() > 0:
        return []
    cap = min(sizes.max(), 3 * np.quantile(sizes[sizes > 1e-3 * sizes.max()], 0.75))
    shown = tractions * np.minimum(1, cap / np.maximum(sizes, 1e-300))[:, None]
    shown *= 0.15 * boundary.diameter / cap
    axes.quiver(*points.T, *shown.T, angles="xy", scale_units="xy", scale=1, color="C3",
                width=0.003)
    axes.update_datalim(points + shown)
    axes.autoscale_view()
    text = "traction on the body, longest arrow %.3g" % cap
    if cap < sizes.max():
        text += "; cut there, largest drawn from %.3g" % sizes.max()
    return [Line2D([], [], color="C3", marker=">", ms=4, lw=1, label=text)]


def plot_contact(contact, title, pictures):
    names = contact["boundary"].astype(str)
    x, y = contact["x"], contact["y"]
    step = np.hypot(np.diff(x, prepend=x[0]), np.diff(y, prepend=y[0]))
    fresh = np.append(True, names[1:] != names[:-1])
    step[fresh] = 0
    along = np.cumsum(step)
    one_line = np.ptp(y) < 1e-9 * max(np.ptp(x), 1e-300) and (np.diff(x) > 0).all()
    s, label = (x, "x") if one_line else (along, "length along the contact boundaries")
    breaks = np.flatnonzero(fresh)[1:]

    def line(axes, values, text, **style):
        axes.plot(np.insert(s, breaks, math.nan), np.insert(values, breaks, math.nan),
                  label=text, **style)

    figure, (stress, shift) = plt.subplots(2, 1, figsize=(8, 7.4), sharex=True)
    line(stress, contact["lambda_n"], r"pressure $\lambda_n$", color="C0")
    line(stress, contact["lambda_t"], r"shear $\lambda_t$", color="C1")
    if (contact["bound"] != 0).any():
        line(stress, contact["bound"], "friction bound, both signs", color="grey", ls="--",
             lw=1)
        line(stress, -contact["bound"], "_", color="grey", ls="--", lw=1)
    stress.set_ylabel("contact stress")
    shade(stress, s, contact)
    line(shift, contact["u_n"], "normal displacement $u_n$", color="C0")
    line(shift, contact["gap"], "gap", color="black", ls="--", lw=1)
    line(shift, contact["u_t"], "tangential displacement $u_t$", color="C1")
    room = max(np.ptp(contact["u_n"]), np.ptp(contact["u_t"]), 1e-300)
    reach = max(np.abs(contact["u_n"]).max(), np.abs(contact["u_t"]).max()) + 0.2 * room
    if np.abs(contact["gap"]).max() > 3 * reach:  # a gap far off would flatten the rest
        shift.set_ylim(-reach, 1.5 * reach)
    shift.set_ylabel("displacement along n and t")
    shift.set_xlabel(label)
    shade(shift, s, contact)
    for axes in (stress, shift):
        axes.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle("%s: contact on %s" % (title, ", ".join(dict.fromkeys(names))), y=0.94)
    pictures.save(figure, "contact")


def shade(axes, s, contact):
    """Open, sticking and sliding parts as coloured grounds."""
    closed, friction = contact["contact"] > 0, contact["friction"]
    kinds = [("open", ~closed, "white"), ("closed, no friction", closed & (friction == 0),
                                          "#cfe3f2"),
             ("closed, stick", closed & (friction == 1), "#cde8cd"),
             ("closed, slip", closed & (friction == 2), "#f7dcc4")]
    middle = np.concatenate([[s[0]], 0.5 * (s[1:] + s[:-1]), [s[-1]]])
    for text, here, colour in kinds:
        shown = colour == "white"
        for i in np.flatnonzero(here):
            if not shown:
                axes.axvspan(middle[i], middle[i + 1], color=colour, lw=0, label=text,
                             zorder=0)
                shown = True
            elif colour != "white":
                axes.axvspan(middle[i], middle[i + 1], color=colour, lw=0, zorder=0)


def title_of(folder):
    """The scene's title from used.xml, else the folder's name."""
    import xml.etree.ElementTree as xml
    try:
        return xml.parse(os.path.join(folder, "used.xml")).getroot().get("name")
    except (OSError, xml.ParseError):
        return os.path.basename(os.path.abspath(folder))


def plot_run(folder):
    title = title_of(folder)
    pictures = Pictures(folder)
    history = read(folder, "history.csv")
    if history:
        plot_curves(history, "dof", "convergence", title + ": convergence", pictures)
        plot_curves(history, "seconds_total", "time", title + ": error against time",
                    pictures)
        plot_contributions(history, title, pictures)
    boundary = read(folder, "boundary.csv")
    if boundary and "degree" in boundary:
        elements = Boundary(boundary)
        plot_mesh(elements, title, pictures)
        plot_deformed(elements, title, pictures)
    contact = read(folder, "contact.csv")
    if contact:
        plot_contact(contact, title, pictures)
    return pictures.names


# ---------------------------------------------------------------- a study

class Curve:
    """The levels of one variant on one scene."""

    def __init__(self, study, rows):
        self.rows = rows
        self.study = study

    def __getitem__(self, name):
        return self.study.numbers(name)[self.rows]


def curves_of(study):
    """{scene: {variant: Curve}} of the solved levels, the reference left out."""
    scenes = {}
    solved = np.isfinite(study.numbers("dof"))
    for scene in dict.fromkeys(study["scene"]):
        here = (study["scene"] == scene) & solved & (study["variant"].astype(str) != "reference")
        names = study["variant"].astype(str)
        scenes[scene] = {variant: Curve(study, here & (names == variant))
                         for variant in dict.fromkeys(names[here])}
    return scenes


def study_figure(scenes, columns):
    """A row of axes per scene, a column per quantity, and room for one legend."""
    figure, axes = plt.subplots(len(scenes), len(columns), squeeze=False,
                                figsize=(5.4 * len(columns) + 2.4, 4.6 * len(scenes)))
    return figure, axes


QUANTITIES = [("estimate", "estimate"), ("error", "true error in the energy norm, relative")]
STRESS = [("error_multiplier", "true error of the contact stress, relative")]


def plot_study_curves(study, scenes, abscissa, name, quantities, title, pictures):
    what = "degrees of freedom" if abscissa == "dof" else "CPU seconds, all threads"
    own = study["variant"].astype(str) != "reference"
    shown = [(column, text) for column, text in quantities
             if (study.numbers(column)[own] > 0).any()]
    if not shown:
        return
    figure, axes = study_figure(scenes, shown)
    for row, (scene, variants) in zip(axes, scenes.items()):
        for k, (variant, curve) in enumerate(variants.items()):
            for cell, (column, text) in zip(row, shown):
                counted = None
                if column != "estimate":
                    counted = curve["counted"] > 0
                loglog(cell, curve[abscissa], curve[column], variant, counted,
                       marker=MARKERS[k % len(MARKERS)], color="C%d" % (k % 10),
                       ls="-" if k < 10 else "--")
        for cell, (column, text) in zip(row, shown):
            plain_ticks(cell.xaxis)
            cell.set_xlabel(what)
            cell.set_ylabel(text)
            cell.set_title(scene)
            cell.legend(fontsize=7)
    figure.suptitle("%s: %s" % (title, name), y=0.99)
    figure.tight_layout()
    pictures.save(figure, name)


def plot_work_precision(study, scenes, title, pictures):
    """The true error against CPU time, a column per scene, one legend for all."""
    if not (study.numbers("error") > 0).any():
        return
    figure, axes = plt.subplots(1, len(scenes), squeeze=False, dpi=80,
                                figsize=(4.6 * len(scenes) + 2.6, 4.4))
    names = list(dict.fromkeys(name for variants in scenes.values() for name in variants))
    for cell, (scene, variants) in zip(axes[0], scenes.items()):
        for variant, curve in variants.items():
            k = names.index(variant)
            good = (curve["error"] > 0) & (curve["counted"] > 0)
            cell.loglog(curve["seconds_total"][good], curve["error"][good], ms=4,
                        label=variant, marker=MARKERS[k % len(MARKERS)],
                        color="C%d" % (k % 10), ls="-" if k < 10 else "--")
        plain_ticks(cell.xaxis)
        cell.set_xlabel("CPU seconds, all threads")
        cell.set_title(scene)
    axes[0, 0].set_ylabel(QUANTITIES[1][1])
    axes[0, -1].legend(loc="center left", bbox_to_anchor=(1, 0.5))
    figure.suptitle(title)
    figure.tight_layout()
    pictures.save(figure, "work-precision")


def plot_exponential(study, scenes, title, pictures):
    """Straight here: error ~ exp(-b sqrt(dof))."""
    column, text = ("error", QUANTITIES[1][1]) if (study.numbers("error") > 0).any() else (
        "estimate", "estimate")
    figure, axes = study_figure(scenes, [column])
    for (cell,), (scene, variants) in zip(axes, scenes.items()):
        for k, (variant, curve) in enumerate(variants.items()):
            y = curve[column]
            good = y > 0
            if column == "error":
                good &= curve["counted"] > 0
            cell.semilogy(np.sqrt(curve["dof"][good]), y[good], ms=4, label=variant,
                          marker=MARKERS[k % len(MARKERS)], color="C%d" % (k % 10),
                          ls="-" if k < 10 else "--")
        cell.set_xlabel("square root of the degrees of freedom")
        cell.set_ylabel(text)
        cell.set_title(scene)
        cell.legend(fontsize=7)
    figure.suptitle(title + ": exponential convergence is a straight line", y=0.99)
    figure.tight_layout()
    pictures.save(figure, "exponential")


def plot_effectivity(study, scenes, title, pictures):
    if not (study.numbers("effectivity") > 0).any():
        return
    figure, axes = study_figure(scenes, ["effectivity"])
    for (cell,), (scene, variants) in zip(axes, scenes.items()):
        for k, (variant, curve) in enumerate(variants.items()):
            good = (curve["effectivity"] > 0) & (curve["counted"] > 0)
            cell.semilogx(curve["dof"][good], curve["effectivity"][good], ms=4,
                          label=variant, marker=MARKERS[k % len(MARKERS)],
                          color="C%d" % (k % 10), ls="-" if k < 10 else "--")
        cell.set_ylim(0, 1.1 * cell.dataLim.y1)
        plain_ticks(cell.xaxis)
        cell.set_xlabel("degrees of freedom")
        cell.set_ylabel("estimate / true error")
        cell.set_title(scene)
        cell.legend(fontsize=7)
    figure.suptitle(title + ": effectivity of the estimate", y=0.99)
    figure.tight_layout()
    pictures.save(figure, "effectivity")


def sweep_names(study):
    """A variant of a sweep is named '<variant>, <key> = <value>'."""
    return np.array([name.rsplit(", ", 1)[0] for name in study["variant"].astype(str)])


def plot_sweep(study, title, pictures):
    value = study.numbers("sweep_value")
    if not np.isfinite(value).any():
        return
    families = sweep_names(study)
    key = [name.rsplit(", ", 1)[1].split(" = ")[0]
           for name in study["variant"][np.isfinite(value)].astype(str)][0]
    eigen = study.numbers("smallest_eigenvalue")
    has_eigen = np.isfinite(eigen).any()
    figure, axes = plt.subplots(1 + has_eigen, 1, squeeze=False, sharex=True,
                                figsize=(7.4, 4.2 + 2.8 * has_eigen))
    estimate = axes[0, 0]
    for k, family in enumerate(dict.fromkeys(families[np.isfinite(value)])):
        here = (families == family) & np.isfinite(value)
        y = study.numbers("estimate")
        good = here & (y > 0)
        estimate.loglog(value[good], y[good], color="C%d" % k, marker=MARKERS[k], ms=4,
                        label=family)
        lost = here & ~np.isfinite(y)
        if lost.any():
            top = np.nanmax(y[np.isfinite(value)]) if good.any() else 1
            estimate.loglog(value[lost], np.full(lost.sum(), top * (1.2 + 0.25 * k)), ls="",
                            marker="x", color="C%d" % k, label=family + ": not solved")
        if has_eigen:
            axes[1, 0].semilogx(value[here], eigen[here], color="C%d" % k,
                                marker=MARKERS[k], ms=4, label=family)
    estimate.set_ylabel("estimate")
    estimate.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    if has_eigen:
        axes[1, 0].axhline(0, color="black", lw=0.8)
        axes[1, 0].set_yscale("symlog", linthresh=1)
        axes[1, 0].set_ylabel("smallest eigenvalue of the\nstabilised stiffness, relative to S")
        axes[1, 0].legend(loc="center left", bbox_to_anchor=(1, 0.5))
    axes[-1, 0].set_xlabel(key)
    estimate.set_title("%s: dependence on %s" % (title, key))
    pictures.save(figure, "sweep")


def plot_study(folder):
    title = title_of(folder)
    pictures = Pictures(folder)
    study = read(folder, "study.csv")
    if study is None:
        return []
    scenes = {scene: variants for scene, variants in curves_of(study).items() if variants}
    if np.isfinite(study.numbers("sweep_value")).all():
        plot_sweep(study, title, pictures)
    elif scenes:
        plot_study_curves(study, scenes, "dof", "convergence", QUANTITIES, title, pictures)
        plot_study_curves(study, scenes, "seconds_total", "time", QUANTITIES, title, pictures)
        plot_study_curves(study, scenes, "dof", "contact_stress", STRESS, title, pictures)
        plot_work_precision(study, scenes, title, pictures)
        plot_exponential(study, scenes, title, pictures)
        plot_effectivity(study, scenes, title, pictures)
        plot_sweep(study, title, pictures)
    return pictures.names


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: epafi plot DIR")
    folder = sys.argv[1]
    if not os.path.isdir(folder):
        sys.exit("epafi: plot: there is no folder '%s'" % folder)
    names = plot_study(folder)
    for entry in sorted(os.listdir(folder)) if names else ():
        if os.path.isfile(os.path.join(folder, entry, "history.csv")):
            plot_run(os.path.join(folder, entry))
    names += [name for name in plot_run(folder) if name not in names]
    if not names:
        sys.exit("epafi: plot: '%s' holds no history.csv, contact.csv, boundary.csv or "
                 "study.csv of a run or a study" % folder)
    print("pictures %s: %s (.png and .svg)" % (folder, " ".join(names)))


if __name__ == "__main__":
    try:
        main()
    except (KeyError, ValueError, OSError) as error:
        sys.exit("epafi: plot: the files in '%s' cannot be drawn: %s" %
                 (sys.argv[1], error))
