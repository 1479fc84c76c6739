"""path: forces and friction's work along a load path, loops of force over slip; rigid: motions and
forces of rigid bodies; steps: pressure and shear at chosen steps, overlaid."""
import os

import numpy as np

from epafi.plot import movie, overlay
from epafi.plot.figures import plt
from epafi.plot.layout import chains, lengths
from epafi.tables import read

SHOWN = 6  # steps overlaid


def contacts_of(steps):
    """The names before '.force_tangential', in the order of the columns."""
    ending = ".force_tangential"
    return [name[:-len(ending)] for name in steps.columns if name.endswith(ending)]


def last_level(steps):
    """The rows of the last level, as arrays by column."""
    here = steps["level"] == steps["level"].max()
    return {name: column[here] for name, column in steps.columns.items()}


def step_file(folder, step):
    return read(os.path.join(folder, "steps", "%d" % step), "contact.csv")


def mean_slip(contact, name):
    """Of u_t along one contact, weighted by length; of several of one name steps.csv says
    body:contact."""
    short = contact["contact_name"]
    here = (short == name) | (np.char.add(np.char.add(contact["body"], ":"), short) == name)
    weights = np.concatenate([lengths(np.cumsum(np.append(0, np.hypot(
        np.diff(contact["x"][a:b]), np.diff(contact["y"][a:b]))))) for a, b in chains(contact)])
    return np.average(contact["u_t"][here], weights=weights[here])


def draw(folder, steps, title, pictures):
    rows = last_level(steps)
    contacts = contacts_of(steps)
    files = [step_file(folder, step) for step in rows["step"]]
    loops = all(file is not None for file in files)
    figure, axes = plt.subplots(1, 3 if loops else 2, figsize=(13 if loops else 9, 4))
    t = np.append(0, rows["t"])

    def along(panel, name, label, **style):
        panel.plot(t, np.append(0, rows[name]), label=label, marker=".", **style)

    for k, name in enumerate(contacts):
        along(axes[0], name + ".force_normal", "normal, " + name, color="C%d" % k)
        along(axes[0], name + ".force_tangential", "tangential, " + name, color="C%d" % k,
              ls="--")
    axes[0].set_ylabel("contact force")
    along(axes[1], "energy_dissipated", "friction's work")
    along(axes[1], "energy_dissipated_trapezoidal", "by the trapezoidal rule", ls="--")
    axes[1].set_ylabel("friction's work so far")
    for panel in axes[:2]:
        panel.set_xlabel("t")
        panel.legend()
    if loops:
        for k, name in enumerate(contacts):
            axes[2].plot([0, *(mean_slip(file, name) for file in files)],
                         np.append(0, rows[name + ".force_tangential"]), marker=".",
                         label=name, color="C%d" % k)
        axes[2].set_xlabel("mean of $u_t$ along the contact")
        axes[2].set_ylabel("tangential force")
        axes[2].ticklabel_format(axis="x", scilimits=(-2, 3))  # or their zeros run together
        axes[2].legend()
    figure.suptitle(title + ": path")
    figure.tight_layout()
    pictures.save(figure, "path")
    rigid(rows, t, title, pictures)
    movie.draw(folder, rows, title, pictures)
    if loops:
        chosen = sorted({round(k) for k in np.linspace(0, len(files) - 1, SHOWN)})
        overlay.draw([files[k] for k in chosen],
                     ["step %d, t = %g" % (rows["step"][k], rows["t"][k]) for k in chosen],
                     title + ": contact along the path", "steps", pictures)


def rigid(rows, t, title, pictures):
    """Bodies without elasticity: their motions, and what moves or holds them there."""
    bodies = [name[:-len(".rotation")] for name in rows if name.endswith(".rotation")]
    if not bodies:
        return
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.5))
    panels = (("motion_x", "force_x"), ("motion_y", "force_y"), ("rotation", "moment"))
    for column, (motion, force) in enumerate(panels):
        for k, name in enumerate(bodies):
            where, what = (np.append(0, rows[name + "." + item]) for item in (motion, force))
            axes[0, column].plot(t, where, marker=".", label=name, color="C%d" % k)
            axes[1, column].plot(where, what, marker=".", label=name, color="C%d" % k)
        axes[0, column].set_xlabel("t")
        axes[0, column].set_ylabel(motion.replace("_", " "))
        axes[1, column].set_xlabel(motion.replace("_", " "))
        axes[1, column].set_ylabel(force.replace("_", " "))
        for panel in axes[:, column]:
            panel.ticklabel_format(scilimits=(-3, 4))
    axes[0, 0].legend()
    figure.suptitle(title + ": rigid bodies")
    figure.tight_layout()
    pictures.save(figure, "rigid")
