"""effectivity: estimate over true error of each variant."""
import numpy as np

from epafi.plot.variants import panels


def semilogx(axes, curve, column, **style):
    good = (curve[column] > 0) & (curve["counted"] > 0)
    axes.semilogx(curve["dof"][good], curve[column][good], **style)
    if np.isfinite(axes.dataLim.y1):  # else this scene has nothing that counts
        axes.set_ylim(0, 1.1 * axes.dataLim.y1)


def draw(study, scenes, title, pictures):
    if not ((study.numbers("effectivity") > 0) & (study.numbers("counted") > 0)).any():
        return
    figure = panels(scenes, [("effectivity", "estimate / true error")], "degrees of freedom",
                    semilogx, title + ": effectivity of the estimate", pictures)
    pictures.save(figure, "effectivity")
