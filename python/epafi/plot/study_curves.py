"""convergence, time, contact_stress, path, path_time, work-precision, exponential and effectivity of
a study: estimate and true errors of each variant."""
import numpy as np

from epafi.plot.figures import loglog, plain_ticks, styles_of

ERROR = "true error in the energy norm, relative"
DOF, SECONDS = ("dof", "degrees of freedom"), ("seconds_total", "CPU seconds, all threads")
ERRORS = [("estimate", "estimate"), ("error", ERROR)]
STRESS = [("error_multiplier", "true error of the contact stress, relative")]
PATH = [("error_path", "largest true error of any step, energy norm"),
        ("error_path_multiplier", "of the contact stress"),
        ("error_path_friction", "of friction's work")]
HOLLOW = "Hollow: below ten times the estimate of the reference, does not count."
# What is drawn against what: columns of study.csv and their labels.
PICTURES = {"convergence": (DOF, ERRORS), "time": (SECONDS, ERRORS),
            "contact_stress": (DOF, STRESS), "path": (DOF, PATH), "path_time": (SECONDS, PATH)}


class Curve:
    """The levels of one variant on one scene."""

    def __init__(self, study, rows):
        self.rows = rows
        self.study = study

    def __getitem__(self, name):
        return self.study.numbers(name)[self.rows]

    def good(self, column):
        """Levels with a value; of true errors those that count."""
        has = self[column] > 0
        return has if column == "estimate" else has & (self["counted"] > 0)


def curves_of(study):
    """{scene: {variant: Curve}} of the solved levels, the reference left out."""
    scenes = {}
    names = study["variant"].astype(str)
    solved = np.isfinite(study.numbers("dof")) & (names != "reference")
    for scene in dict.fromkeys(study["scene"]):
        here = (study["scene"] == scene) & solved
        if here.any():
            scenes[scene] = {variant: Curve(study, here & (names == variant))
                             for variant in dict.fromkeys(names[here])}
    return scenes


def styles(scenes):
    return styles_of(dict.fromkeys(name for variants in scenes.values() for name in variants))


def panels(scenes, quantities, abscissa, plot, title, pictures):
    """A figure of a row of axes per scene, a column per quantity (column, label), with room for the
    legends: plot(axes, curve, column, label=..., **style) draws each variant."""
    figure, axes = pictures.subplots(len(scenes), len(quantities), figsize=(
        5.4 * len(quantities) + 2.4, 4.6 * len(scenes)))
    axes = np.reshape(axes, (len(scenes), len(quantities)))
    looks = styles(scenes)
    for row, (scene, variants) in zip(axes, scenes.items()):
        for cell, (column, label) in zip(row, quantities):
            for variant, curve in variants.items():
                plot(cell, curve, column, label=variant, **looks[variant])
            if cell.get_xscale() == "log":
                plain_ticks(cell.xaxis)
            cell.set_xlabel(abscissa)
            cell.set_ylabel(label)
            cell.set_title(scene)
            pictures.legend(cell, fontsize="x-small")
    pictures.title(figure, title)
    return figure


def draw(study, scenes, title, pictures):
    for name, ((abscissa, what), quantities) in PICTURES.items():
        own = study["variant"].astype(str) != "reference"
        shown = [(column, text) for column, text in quantities
                 if column in study and (study.numbers(column)[own] > 0).any()]
        if shown:
            draw_errors(scenes, shown, abscissa, what, name, title, pictures)
    counted = study.numbers("counted") > 0
    if ((study.numbers("error") > 0) & counted).any():
        draw_work(scenes, title, pictures)
    draw_exponential(study, scenes, title, pictures)
    if ((study.numbers("effectivity") > 0) & counted).any():
        pictures.save(panels(scenes, [("effectivity", "estimate / true error")], DOF[1], effectivity,
                             title + ": effectivity of the estimate", pictures), "effectivity")


def draw_errors(scenes, shown, abscissa, what, name, title, pictures):
    def curves(axes, curve, column, label, **style):
        counted = None if column == "estimate" else curve["counted"] > 0
        loglog(axes, curve[abscissa], curve[column], label, counted, **style)

    figure = panels(scenes, shown, what, curves, "%s: %s" % (title, name.replace("_", " ")),
                    pictures)
    if any((curve["error"] > 0).any() and not (curve["counted"] > 0).all()
           for variants in scenes.values() for curve in variants.values()):
        figure.text(0.5, 0, HOLLOW, ha="center", va="top", fontsize="small")
    pictures.save(figure, name)


def draw_work(scenes, title, pictures):
    """A column per scene, one legend for all."""
    figure, axes = pictures.subplots(1, len(scenes), figsize=(4.6 * len(scenes) + 2.6, 4.4))
    axes = np.reshape(axes, (1, len(scenes)))
    looks = styles(scenes)
    for cell, (scene, variants) in zip(axes[0], scenes.items()):
        for variant, curve in variants.items():
            good = curve.good("error")
            cell.loglog(curve["seconds_total"][good], curve["error"][good], label=variant,
                        **looks[variant])
        plain_ticks(cell.xaxis)
        cell.set_xlabel(SECONDS[1])
        cell.set_title(scene)
    axes[0, 0].set_ylabel(ERROR)
    pictures.legend(axes[0, -1], loc="center left", bbox_to_anchor=(1, 0.5))
    pictures.title(figure, title)
    pictures.save(figure, "work-precision")


def draw_exponential(study, scenes, title, pictures):
    """Against the root of the degrees of freedom: straight here is error ~ exp(-b sqrt(dof))."""
    def semilogy(axes, curve, column, **style):
        good = curve.good(column)
        axes.semilogy(np.sqrt(curve["dof"][good]), curve[column][good], **style)

    quantity = ERRORS[1] if (study.numbers("error") > 0).any() else ERRORS[0]
    figure = panels(scenes, [quantity], "square root of the degrees of freedom", semilogy,
                    title + ": exponential convergence is a straight line", pictures)
    pictures.save(figure, "exponential")


def effectivity(axes, curve, column, **style):
    good = curve.good(column)
    axes.semilogx(curve["dof"][good], curve[column][good], **style)
    if np.isfinite(axes.dataLim.y1):  # else this scene has nothing that counts
        axes.set_ylim(0, 1.1 * axes.dataLim.y1)
