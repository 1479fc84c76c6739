"""exponential: the error of each variant against the root of the degrees of freedom."""
import numpy as np

from epafi.plot.figures import styles_of
from epafi.plot.variants import ERROR, study_figure


def draw(study, scenes, title, pictures):
    """Straight here: error ~ exp(-b sqrt(dof))."""
    column, text = ("error", ERROR) if (study.numbers("error") > 0).any() else (
        "estimate", "estimate")
    figure, axes = study_figure(scenes, [column])
    for (cell,), (scene, variants) in zip(axes, scenes.items()):
        styles = styles_of(variants)
        for variant, curve in variants.items():
            y = curve[column]
            good = y > 0
            if column == "error":
                good &= curve["counted"] > 0
            cell.semilogy(np.sqrt(curve["dof"][good]), y[good], label=variant,
                          **styles[variant])
        cell.set_xlabel("square root of the degrees of freedom")
        cell.set_ylabel(text)
        cell.set_title(scene)
        cell.legend(fontsize=7)
    figure.suptitle(title + ": exponential convergence is a straight line", y=0.99)
    figure.tight_layout()
    pictures.save(figure, "exponential")
