"""Pressure, shear and worn depth of several solutions of one contact, one upon the other."""
import numpy as np

from epafi.plot.contact import cut, line
from epafi.plot.figures import Pictures, plt
from epafi.plot.layout import finer, in_order, laid_out, lengths, turned, window, within


PRESSURE, SHEAR, WORN = (("pressure", "pressure", "stress"), ("shear", "shear", "stress"),
                         ("worn_depth", "worn depth", "length"))


def quantities(contacts):
    """The pressure, and what else there is."""
    def largest(column):
        return max(np.abs(contact[column]).max() if column in contact else 0
                   for contact in contacts)

    return [PRESSURE, *[SHEAR] * bool(largest("shear") > 1e-12 * largest("pressure")),
            *[WORN] * bool(largest("worn_depth") > 0)]


def draw(contacts, labels, title, name, pictures):
    """Of tables of contact.csv, coloured in their order; shear and wear where there is any."""
    contacts, drawn = [finer(in_order(contact)) for contact in contacts], quantities(contacts)
    figure, panels = pictures.subplots(len(drawn), 1, sharex=True,
                                       figsize=(9.4, 0.4 + 3.5 * len(drawn)))
    panels = np.atleast_1d(panels).ravel()
    turns = turned(contacts)
    shown = [laid_out(contact, turns=turns) for contact in contacts]
    shown = [within(laid, *window(shown)) for laid in shown]
    for number, (laid, text) in enumerate(zip(shown, labels)):
        contact, _, label, _ = laid
        colour = plt.get_cmap("viridis")(0.95 * number / max(1, len(labels) - 1))
        for axes, (column, *_) in zip(panels, drawn):
            line(axes, laid, contact[column], text, color=colour)
        panels[-1].set_xlabel(pictures.looks.label(label, "length"))
    for axes, (column, text, unit) in zip(panels, drawn):
        if unit == "stress":
            cut(axes, [(contact[column], np.concatenate([lengths(s[a:b]) for a, b in parts]))
                       for contact, s, _, parts in shown])
        axes.set_ylabel(pictures.looks.label(text, unit))
    pictures.legend(panels[0], loc="upper left", bbox_to_anchor=(1, 1))
    pictures.title(panels[0], title)
    pictures.save(figure, name)


def figure_of(contacts, labels, axes=None):
    """The same, not written: a figure and its axes."""
    pictures = Pictures("", only="overlay", axes=axes)
    with plt.rc_context(pictures.looks.style()):
        draw(contacts, labels, "", "overlay", pictures)
    return np.ravel(pictures.axes)[0].figure, pictures.axes


def curves_of(abscissa, ordinate, curves, axes=None):
    """Curves (label, x, y), of which those without a label have no legend: a figure and its axes."""
    pictures = Pictures("", only="overlay", axes=axes)
    with plt.rc_context(pictures.looks.style()):
        figure, panel = pictures.subplots(figsize=(6.4, 4.6))
        for label, x, y in curves:
            panel.plot(x, y, marker=".", label=label)
        panel.set_xlabel(abscissa)
        panel.set_ylabel(ordinate)
        if any(label for label, *_ in curves):
            pictures.legend(panel, loc="upper left", bbox_to_anchor=(1, 1))
        pictures.save(figure, "overlay")
    return figure, panel
