"""work-precision: the true error of each variant against CPU time."""
import numpy as np

from epafi.plot.figures import plain_ticks, styles_of
from epafi.plot.variants import ERROR


def draw(study, scenes, title, pictures):
    """A column per scene, one legend for all."""
    if not ((study.numbers("error") > 0) & (study.numbers("counted") > 0)).any():
        return
    figure, axes = pictures.subplots(1, len(scenes), figsize=(4.6 * len(scenes) + 2.6, 4.4))
    axes = np.reshape(axes, (1, len(scenes)))
    names = list(dict.fromkeys(name for variants in scenes.values() for name in variants))
    styles = styles_of(names)
    for cell, (scene, variants) in zip(axes[0], scenes.items()):
        for variant, curve in variants.items():
            good = (curve["error"] > 0) & (curve["counted"] > 0)
            cell.loglog(curve["seconds_total"][good], curve["error"][good], label=variant,
                        **styles[variant])
        plain_ticks(cell.xaxis)
        cell.set_xlabel("CPU seconds, all threads")
        cell.set_title(scene)
    axes[0, 0].set_ylabel(ERROR)
    pictures.legend(axes[0, -1], loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.title(figure, title)
    pictures.save(figure, "work-precision")
