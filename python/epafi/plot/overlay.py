"""Pressure and shear of several solutions of one contact, one upon the other."""
import math

import numpy as np

from epafi.plot.contact import abscissa, chains
from epafi.plot.figures import STYLE, plt


def figure_of(contacts, labels, title):
    """Of tables of contact.csv, coloured in their order."""
    figure, (pressure, shear) = plt.subplots(2, 1, figsize=(8, 7.4), sharex=True)
    for number, (contact, text) in enumerate(zip(contacts, labels)):
        parts = chains(contact)
        s, label = abscissa(contact, parts)
        breaks = [a for a, _ in parts[1:]]
        colour = plt.get_cmap("viridis")(0.95 * number / max(1, len(labels) - 1))
        for axes, column in ((pressure, "lambda_n"), (shear, "lambda_t")):
            axes.plot(np.insert(s, breaks, math.nan),
                      np.insert(contact[column], breaks, math.nan), color=colour, label=text)
        shear.set_xlabel(label)
    pressure.set_ylabel(r"pressure $\lambda_n$")
    shear.set_ylabel(r"shear $\lambda_t$")
    pressure.legend(loc="upper left", bbox_to_anchor=(1, 1))
    figure.suptitle(title, y=0.94)
    return figure


def draw(contacts, labels, title, name, pictures):
    pictures.save(figure_of(contacts, labels, title), name)


def draw_file(file, contacts, labels, title=""):
    with plt.rc_context(STYLE):
        figure = figure_of(contacts, labels, title)
        figure.savefig(file, dpi=figure.dpi)
        plt.close(figure)
