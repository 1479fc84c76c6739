"""exponential: the error of each variant against the root of the degrees of freedom."""
import numpy as np

from epafi.plot.variants import ERROR, panels


def semilogy(axes, curve, column, **style):
    good = curve[column] > 0
    if column == "error":
        good &= curve["counted"] > 0
    axes.semilogy(np.sqrt(curve["dof"][good]), curve[column][good], **style)


def draw(study, scenes, title, pictures):
    """Straight here: error ~ exp(-b sqrt(dof))."""
    quantity = ("error", ERROR) if (study.numbers("error") > 0).any() else ("estimate", "estimate")
    figure = panels(scenes, [quantity], "square root of the degrees of freedom", semilogy,
                    title + ": exponential convergence is a straight line", pictures)
    pictures.save(figure, "exponential")
