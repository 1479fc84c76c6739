"""effectivity: estimate over true error of each variant."""
import numpy as np

from epafi.plot.figures import plain_ticks, styles_of
from epafi.plot.variants import study_figure


def draw(study, scenes, title, pictures):
    if not ((study.numbers("effectivity") > 0) & (study.numbers("counted") > 0)).any():
        return
    figure, axes = study_figure(scenes, ["effectivity"])
    for (cell,), (scene, variants) in zip(axes, scenes.items()):
        styles = styles_of(variants)
        for variant, curve in variants.items():
            good = (curve["effectivity"] > 0) & (curve["counted"] > 0)
            cell.semilogx(curve["dof"][good], curve["effectivity"][good], label=variant,
                          **styles[variant])
        if np.isfinite(cell.dataLim.y1):  # else this scene has nothing that counts
            cell.set_ylim(0, 1.1 * cell.dataLim.y1)
        plain_ticks(cell.xaxis)
        cell.set_xlabel("degrees of freedom")
        cell.set_ylabel("estimate / true error")
        cell.set_title(scene)
        cell.legend(fontsize=7)
    figure.suptitle(title + ": effectivity of the estimate", y=0.99)
    figure.tight_layout()
    pictures.save(figure, "effectivity")
