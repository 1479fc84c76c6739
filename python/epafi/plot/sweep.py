"""sweep, sweep_forces, sweep_contact: dependence on one parameter of a study; sweep_column: of any
columns of study.csv."""

import numpy as np

from epafi.plot import overlay
from epafi.plot.figures import settle, styles_of
from epafi.tables import nearest, own, read

FORCES = [("force_normal", "normal force"), ("force_tangential", "tangential force"),
          ("contact_length", "length in contact"), ("slip_length", "length that slips")]
SHOWN = 9  # values whose stresses are overlaid


def sweep_names(study):
    """A variant of a sweep is named '<variant>, <key> = <value>'."""
    return np.array([name.rsplit(", ", 1)[0] for name in study["variant"].astype(str)])


def last_levels(study, value):
    """True for the row that ends each variant with a value of the parameter."""
    scene, variant = study["scene"].astype(str), study["variant"].astype(str)
    last = {}
    for row in np.flatnonzero(np.isfinite(value)):
        last[scene[row], variant[row]] = row
    result = np.zeros(study.size, bool)
    result[list(last.values())] = True
    return result


def set_scale(axes, which, values):
    """Logarithmic where all values are positive and spread; linear near zero where one is not,
    so that none is lost."""
    setter = axes.set_xscale if which == "x" else axes.set_yscale
    sizes = np.abs(values[values != 0])
    if not sizes.size or sizes.max() < 10 * sizes.min():
        return
    if (values > 0).all():
        setter("log")
    else:
        setter("symlog", linthresh=sizes.min())


def draw(study, title, pictures, columns=()):
    value = study.numbers("sweep_value")
    if not np.isfinite(value).any():
        if columns:
            raise ValueError("--column: the study has no Sweep")
        return
    ends = last_levels(study, value)
    families = sweep_names(study)
    if len(set(study["scene"].astype(str))) > 1:
        families = np.array(["%s: %s" % pair for pair in zip(study["scene"], families)])
    key = [name.rsplit(", ", 1)[1].split(" = ")[0]
           for name in study["variant"][np.isfinite(value)].astype(str)][0]
    eigen = study.numbers("smallest_eigenvalue")
    has_eigen = np.isfinite(eigen).any()
    figure, axes = pictures.subplots(1 + has_eigen, 1, sharex=True,
                                     figsize=(9, 4.2 + 2.8 * has_eigen))
    axes = np.reshape(axes, (-1, 1))
    estimate = axes[0, 0]
    estimates = study.numbers("estimate")
    solved = ends & np.isfinite(estimates)
    top = np.nanmax(estimates[solved]) if solved.any() else 1
    lows = estimates[solved & (estimates > 0)]
    styles = styles_of(dict.fromkeys(families[ends]))
    for k, family in enumerate(styles):
        here = ends & (families == family)
        here = np.flatnonzero(here)[np.argsort(value[here])]
        style = styles[family]
        good = here[np.isfinite(estimates[here])]
        estimate.plot(value[good], estimates[good], label=family, **style)
        lost = here[~np.isfinite(estimates[here])]
        if lost.size:
            estimate.plot(value[lost], np.full(lost.size, top * (1.2 + 0.25 * k)), ls="",
                          marker="x", ms=6, color=style["color"],
                          label=family + ": not solved")
        if has_eigen:
            axes[1, 0].plot(value[here], eigen[here], label=family, **style)
    estimate.set_ylabel("estimate on the last level")
    if lows.size:
        set_scale(estimate, "y", np.append(lows, estimates[solved].min()))
    set_scale(estimate, "x", value[ends])
    pictures.legend(estimate, loc="center left", bbox_to_anchor=(1, 0.5))
    if has_eigen:
        axes[1, 0].axhline(0, color="black", lw=0.8)
        axes[1, 0].set_yscale("symlog", linthresh=1)
        axes[1, 0].set_ylabel("smallest eigenvalue of the\nstabilised stiffness, relative to S")
        pictures.legend(axes[1, 0], loc="center left", bbox_to_anchor=(1, 0.5))
    axes[-1, 0].set_xlabel(key)
    pictures.title(estimate, "%s: dependence on %s" % (title, key))
    pictures.save(figure, "sweep")
    figure = draw_columns(study, value, ends, families, key, FORCES, pictures)
    pictures.title(figure, "%s: contact against %s" % (title, key))
    pictures.save(figure, "sweep_forces")
    if columns:
        for column in columns:
            if not np.isfinite(study.numbers(column)).any():
                raise ValueError("--column: study.csv has no numbers in a column '%s'%s" % (
                    column, nearest(column, [name for name in study
                                             if np.isfinite(study.numbers(name)).any()])))
        figure = draw_columns(study, value, ends, families, key,
                              [(name, name.replace("_", " ")) for name in columns], pictures)
        pictures.title(figure, "%s: dependence on %s" % (title, key))
        pictures.save(figure, "sweep_column")
    draw_contact(study, value, ends, families, key, title, pictures)


def draw_columns(study, value, ends, families, key, columns, pictures):
    """(column, label) against the parameter, a panel for each; the figure."""
    rows = -(-len(columns) // 2)
    figure, axes = pictures.subplots(rows, min(2, len(columns)), sharex=True,
                                     figsize=(10.5 if len(columns) > 1 else 7, 0.4 + 3 * rows))
    axes = np.ravel(axes)
    sizes = [np.nanmax(np.abs(study.numbers(name)[ends])) for name, _ in columns
             if name in FORCES[0] + FORCES[1]]
    for cell, (column, text) in zip(axes, columns):
        numbers = study.numbers(column)
        for family, style in styles_of(dict.fromkeys(families[ends])).items():
            here = np.flatnonzero(ends & (families == family) & np.isfinite(numbers))
            here = here[np.argsort(value[here])]
            cell.plot(value[here], numbers[here], label=family, **style)
        quantity = next((word for word in ("force", "length", "energy") if word in column), "")
        cell.set_ylabel(pictures.looks.label(text, quantity) if quantity else text)
        cell.margins(y=0.15)
        cell.set_xlabel(key)
        cell.xaxis.set_tick_params(labelbottom=True)
        if column.startswith("force"):
            settle(cell, max(sizes))
    for spare in axes[len(columns):]:
        spare.remove()
    set_scale(axes[0], "x", value[ends])
    pictures.legend(axes[min(1, len(columns) - 1)], loc="upper left", bbox_to_anchor=(1, 1))
    return figure


def draw_contact(study, value, ends, families, key, title, pictures):
    """Pressure and shear for the values, a picture per scene and variant."""
    if "folder" not in study:
        return
    names = list(dict.fromkeys(families[ends]))
    for number, family in enumerate(names, 1):
        here = np.flatnonzero(ends & (families == family))
        here = here[np.argsort(value[here])]
        tables = [(value[row], read(own(pictures.folder, str(study["folder"][row])),
                                    "contact.csv")) for row in here if study["folder"][row]]
        tables = [(x, table) for x, table in tables if table]
        if not tables:
            continue
        chosen = sorted({round(k) for k in np.linspace(0, len(tables) - 1, SHOWN)})
        overlay.draw([tables[k][1] for k in chosen],
                     ["%s = %g" % (key, tables[k][0]) for k in chosen],
                     "%s: %s" % (title, family),
                     "sweep_contact" if len(names) == 1 else "sweep_contact_%d" % number, pictures)
