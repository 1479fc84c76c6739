"""The variants of a study as curves, and axes for them."""
import numpy as np

from epafi.plot.figures import plain_ticks, styles_of

ERROR = "true error in the energy norm, relative"


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


def panels(scenes, quantities, abscissa, plot, title, pictures):
    """A figure of a row of axes per scene, a column per quantity (column, label), with room for the
    legends: plot(axes, curve, column, label=..., **style) draws each variant."""
    figure, axes = pictures.subplots(len(scenes), len(quantities), figsize=(
        5.4 * len(quantities) + 2.4, 4.6 * len(scenes)))
    axes = np.reshape(axes, (len(scenes), len(quantities)))
    styles = styles_of(dict.fromkeys(name for variants in scenes.values() for name in variants))
    for row, (scene, variants) in zip(axes, scenes.items()):
        for cell, (column, label) in zip(row, quantities):
            for variant, curve in variants.items():
                plot(cell, curve, column, label=variant, **styles[variant])
            if cell.get_xscale() == "log":
                plain_ticks(cell.xaxis)
            cell.set_xlabel(abscissa)
            cell.set_ylabel(label)
            cell.set_title(scene)
            pictures.legend(cell, fontsize="x-small")
    pictures.title(figure, title)
    return figure
