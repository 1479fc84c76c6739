"""contact: stresses, gap and displacements along the contact boundaries."""
import math

import numpy as np

from figures import plt


def draw(contact, title, pictures):
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
    """Sticking and sliding parts as coloured grounds; what is open stays white."""
    closed, friction = contact["contact"] > 0, contact["friction"]
    kinds = [("closed, no friction", closed & (friction == 0), "#cfe3f2"),
             ("closed, stick", closed & (friction == 1), "#cde8cd"),
             ("closed, slip", closed & (friction == 2), "#f7dcc4")]
    middle = np.concatenate([[s[0]], 0.5 * (s[1:] + s[:-1]), [s[-1]]])
    for text, here, colour in kinds:
        for i in np.flatnonzero(here):
            axes.axvspan(middle[i], middle[i + 1], color=colour, lw=0, label=text, zorder=0)
            text = "_"  # once in the legend
