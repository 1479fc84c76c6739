"""The variants of a study as curves, and axes for them."""
import numpy as np

from epafi.plot.figures import plt

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


def study_figure(scenes, columns):
    """A row of axes per scene, a column per quantity, and room for the legends."""
    return plt.subplots(len(scenes), len(columns), squeeze=False,
                        figsize=(5.4 * len(columns) + 2.4, 4.6 * len(scenes)))
