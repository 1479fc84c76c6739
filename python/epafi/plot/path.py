"""path: forces and friction's work along a load path, loops of force over slip, without friction the length
in contact over the force; rigid: motions and
forces of rigid bodies; steps: pressure, shear and worn depth at chosen steps, overlaid; slip and
movie, see there."""
import numpy as np

from epafi.plot import overlay, slip
from epafi.plot.figures import COLOURS, settle, short
from epafi.plot.layout import chains, lengths, samples_at
from epafi.tables import read

SHOWN = 6  # steps overlaid, contacts or bodies drawn


def contacts_of(steps):
    """The names before '.force_tangential', in the order of the columns."""
    ending = ".force_tangential"
    return [name[:-len(ending)] for name in steps if name.endswith(ending)]


def largest(rows, names, column, count=SHOWN):
    """Of contacts or bodies those with the largest values, in their order."""
    sizes = [-np.abs(rows[name + column]).max() for name in names]
    return [names[k] for k in sorted(np.argsort(sizes, kind="stable")[:count])]


def tell_rest(axes, names, shown):
    if len(names) > len(shown):
        axes.plot([], [], ls="", label="not drawn: %d others" % (len(names) - len(shown)))


def solved_steps(steps):
    """The rows of the last level that are solved, as arrays by column."""
    here = (steps["level"] == steps["level"].max()) & (steps["status"] == "converged")
    return {name: column[here] for name, column in steps.columns.items()}


# What pictures of a path take of contact.csv.
COLUMNS = {"boundary", "element", "x", "y", "s", "body", "contact_name", "pressure", "shear", "u_n",
           "u_t", "slip", "worn_depth", "contact", "friction"}


def samples_of(contact, name):
    """Which samples are of a contact; of several of one name steps.csv says body:contact."""
    short = contact["contact_name"]
    return (short == name) | (np.char.add(np.char.add(contact["body"], ":"), short) == name)


def slip_column(files):
    """`slip` where the opposite side slides by, which u_t does not know."""
    others = [file["u_t"] - file["slip"] for file in files]
    slides = max(np.abs(other - others[0]).max() for other in others)
    return "slip" if slides > 1e-9 * max(np.abs(file["slip"]).max() for file in files) else "u_t"


def mean_slip(contact, name, column):
    """Of a column along one contact where it is closed, weighted by length; of all of an open one."""
    here = samples_of(contact, name)
    closed = here & (contact["contact"] > 0)
    here = closed if closed.any() else here
    weights = np.concatenate([lengths(np.cumsum(np.append(0, np.hypot(
        np.diff(contact["x"][a:b]), np.diff(contact["y"][a:b]))))) for a, b in chains(contact)])
    return np.average(contact[column][here], weights=weights[here])


def torsion(folder, rows, contacts, contact):
    """Of two bodies that meet all around and turn each other, at the steps: how far the one that turns the
    other is ahead [radian], and the torque on that one about its middle; None of others, and where the force
    between them does more work than the torque."""
    bodies = read(folder, "bodies.csv")
    if len(contacts) != 1 or bodies is None or len(set(bodies["body"])) != 2:
        return None
    x = np.column_stack([contact["x"], contact["y"]])
    steps = np.hypot(*np.diff(x, axis=0).T)
    if np.hypot(*(x[-1] - x[0])) > 2 * max(steps[0], steps[-1]):
        return None
    last = (bodies["level"] == bodies["level"].max()) & np.isin(bodies["step"], rows["step"])
    driven = last & (bodies["body"] == contact["body"][0])
    driving = last & (bodies["body"] != contact["body"][0])
    if not driven.sum() == driving.sum() == len(rows["step"]):
        return None
    twist, (x, y) = bodies["rotation"][driving] - bodies["rotation"][driven], x.mean(axis=0)
    torque = (bodies["contact_moment"] - x * bodies["contact_y"] + y * bodies["contact_x"])[driven]
    pushed = sum((bodies["motion_" + axis][driving] - bodies["motion_" + axis][driven])
                 * bodies["contact_" + axis][driven] for axis in "xy")
    return (twist, torque) if np.abs(twist * torque).max() > np.abs(pushed).max() else None


def draw(folder, steps, title, pictures):
    rows = solved_steps(steps)
    if not rows["step"].size:
        return
    if steps["status"][-1] != "converged":
        title += " up to t = %g, the last step that is solved" % rows["t"][-1]
    t = np.append(0, rows["t"])
    drawn = any(map(pictures.wants, ("path", "steps", "slip")))
    files = [samples_at(folder, step, COLUMNS) for step in rows["step"]] if drawn else [None]
    loops = all(file is not None for file in files)
    if pictures.wants("path"):
        draw_path(folder, rows, t, files if loops else [], title, pictures)
    if pictures.wants("rigid"):
        rigid(rows, t, title, pictures)
    if pictures.only is None and pictures.wants("movie"):
        from epafi.plot import movie  # whose imports cost as much as a picture

        movie.draw(folder, rows, title, pictures)
    if loops and len(files) > 1 and pictures.wants("steps"):
        chosen = sorted({round(k) for k in np.linspace(0, len(files) - 1, SHOWN)})
        overlay.draw([files[k] for k in chosen],
                     ["step %d, t = %g" % (rows["step"][k], rows["t"][k]) for k in chosen],
                     title + ": contact along the path", "steps", pictures)
    if loops and pictures.wants("slip"):
        slip.draw(files, rows["t"], title, pictures)


def draw_path(folder, rows, t, files, title, pictures):
    contacts, label = contacts_of(rows), pictures.looks.label
    turning = torsion(folder, rows, contacts, files[-1]) if files else None
    force = max((np.abs(rows[name]).max() for name in rows if "force_" in name), default=0)
    # without friction two of the panels would be empty
    rubs = max((np.abs(rows[name + ".force_tangential"]).max() for name in contacts), default=0) > 1e-9 * force or \
        np.abs(rows["energy_dissipated"]).max() > 1e-9 * np.abs(rows["energy_strain"]).max()
    files = files if rubs else []
    grows = bool(contacts) and not rubs
    panels = 1 + rubs + bool(files) + grows
    figure, axes = pictures.subplots(1, panels, figsize=(0.5 + 4.2 * panels, 4))
    axes = np.ravel(axes)
    shown = largest(rows, contacts, ".force_normal", 3 if pictures.small else SHOWN)

    def along(panel, name, label, ls="-", **style):  # markers would hide dashes
        panel.plot(t, np.append(0, rows[name]), label=label, ls=ls,
                   marker="." if ls == "-" else "", **style)

    for k, name in enumerate(shown):
        along(axes[0], name + ".force_normal", short(name), color=COLOURS[k])
        if rubs:
            along(axes[0], name + ".force_tangential", "_", color=COLOURS[k], ls="--")
    if rubs:
        axes[0].plot([], [], color="grey", ls="--", label="dashed: tangential")
    tell_rest(axes[0], contacts, shown)
    axes[0].set_ylabel(label("contact force", "force"))
    settle(axes[0], force)
    if rubs:
        along(axes[1], "energy_dissipated", "friction's work", color="black")
        along(axes[1], "energy_dissipated_trapezoidal", "by the trapezoidal rule", color="black",
              ls="--")
        axes[1].set_ylabel(label("friction's work so far", "energy"))
        settle(axes[1], np.abs(rows["energy_strain"]).max())
    for panel in axes[:1 + rubs]:
        panel.set_xlabel("t")
        pictures.legend(panel)
    if grows:
        for k, name in enumerate(shown):
            axes[1].plot(rows[name + ".force_normal"], rows[name + ".contact_length"], marker=".", color=COLOURS[k])
        settle(axes[1], force, "x")
        axes[1].set_ylim(bottom=0)
        axes[1].set_xlabel(label("normal force", "force"))
        axes[1].set_ylabel(label("contact length", "length"))
    if files:
        moved = slip_column(files)
        loops = {name: ([mean_slip(file, name, moved) for file in files],
                        rows[name + ".force_tangential"])
                 for name in shown} if turning is None else {contacts[0]: turning}
        for k, (name, (places, pushed)) in enumerate(loops.items()):
            axes[2].plot([0, *places], [0, *pushed], marker=".", label=short(name),
                         color=COLOURS[k])
        reach = max(np.abs(file[key]).max() for file in files for key in ("u_n", moved))
        arm = 1 if turning is None else 0.5 * max(np.ptp(files[-1]["x"]), np.ptp(files[-1]["y"]))
        settle(axes[2], reach / arm, "x")
        settle(axes[2], force * arm)
        meant = "mean %s where closed" % moved.replace("u_t", "slip $u_t$")
        axes[2].set_xlabel(label(meant, "length") if turning is None
                           else "twist of the bodies [rad]", labelpad=9)
        axes[2].set_ylabel(label("tangential force", "force") if turning is None
                           else label("torque", "energy"))
        axes[2].ticklabel_format(axis="x", scilimits=(-2, 3))  # or their zeros run together
    pictures.title(figure, title + ": path")
    pictures.save(figure, "path")


def rigid(rows, t, title, pictures):
    """Bodies without elasticity: their motions, and what moves or holds them there."""
    bodies = [name[:-len(".rotation")] for name in rows if name.endswith(".rotation")]
    if not bodies:
        return
    shown = largest(rows, bodies, ".force_y")
    panels = (("motion_x", "force_x"), ("motion_y", "force_y"), ("rotation", "moment"))
    sizes = {item: max(np.abs(rows[name + "." + item]).max() for name in bodies)
             for pair in panels for item in pair}
    moved = max(sizes["motion_x"], sizes["motion_y"])
    pushed = max(sizes["force_x"], sizes["force_y"])
    # around an axis bodies move and are pushed along it alone
    if pictures.given is None:
        panels = [pair for pair in panels
                  if sizes[pair[0]] > 1e-12 * moved or sizes[pair[1]] > 1e-9 * pushed] or panels
    figure, axes = pictures.subplots(2, len(panels), figsize=(4 * len(panels), 6.5))
    axes = np.reshape(axes, (2, -1))
    tell_rest(axes[0, 0], bodies, shown)
    for column, (motion, force) in enumerate(panels):
        for k, name in enumerate(shown):
            where, what = (np.append(0, rows[name + "." + item]) for item in (motion, force))
            axes[0, column].plot(t, where, marker=".", label=short(name), color=COLOURS[k])
            axes[1, column].plot(where, what, marker=".", label=short(name), color=COLOURS[k])
        turns = motion == "rotation"
        where = "rotation [rad]" if turns else pictures.looks.label(motion.replace("_", " "),
                                                                    "length")
        settle(axes[0, column], moved)  # of rotations by the same number, whatever the unit
        settle(axes[1, column], moved, "x")
        settle(axes[1, column], pushed)
        axes[0, column].set_xlabel("t")
        axes[0, column].set_ylabel(where)
        axes[1, column].set_xlabel(where, labelpad=9)  # below the power of ten
        axes[1, column].set_ylabel(pictures.looks.label(force.replace("_", " "),
                                                        "energy" if turns else "force"))
        for panel in axes[:, column]:
            panel.ticklabel_format(scilimits=(-3, 4))
    pictures.legend(axes[0, 0])
    pictures.title(figure, title + ": rigid bodies")
    pictures.save(figure, "rigid")
