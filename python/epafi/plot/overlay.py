"""Pressure and shear of several solutions of one contact, one upon the other."""
import math

import numpy as np

from epafi.plot.contact import cap_of, laid_out, lengths, say_cut, window, within
from epafi.plot.figures import STYLE, plt


def cut(axes, shown, column):
    """Cuts stresses that are singular, so that the others can be read, and marks it."""
    sizes = [np.abs(contact[column]) for contact, *_ in shown]
    weights = [np.concatenate([lengths(s[a:b]) for a, b in parts]) for _, s, _, parts in shown]
    cap = max(cap_of(*both) for both in zip(sizes, weights))
    largest = max(size.max() for size in sizes)
    if largest > cap > 0:
        low = min(contact[column].min() for contact, *_ in shown)
        axes.set_ylim(max(low, -cap) - 0.05 * cap, 1.05 * cap)
        say_cut(axes, largest)


def figure_of(contacts, labels, title):
    """Of tables of contact.csv, coloured in their order."""
    figure, (pressure, shear) = plt.subplots(2, 1, figsize=(8, 7.4), sharex=True)
    shown = [laid_out(contact) for contact in contacts]
    shown = [within(laid, *window(shown)) for laid in shown]
    for number, ((contact, s, label, parts), text) in enumerate(zip(shown, labels)):
        breaks = [a for a, _ in parts[1:]]
        colour = plt.get_cmap("viridis")(0.95 * number / max(1, len(labels) - 1))
        for axes, column in ((pressure, "lambda_n"), (shear, "lambda_t")):
            axes.plot(np.insert(s, breaks, math.nan),
                      np.insert(contact[column], breaks, math.nan), color=colour, label=text)
        shear.set_xlabel(label)
    for axes, column in ((pressure, "lambda_n"), (shear, "lambda_t")):
        cut(axes, shown, column)
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
