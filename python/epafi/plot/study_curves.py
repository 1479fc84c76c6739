"""convergence, time, contact_stress, path and path_time of a study: estimate and true errors of each
variant."""
from epafi.plot.figures import loglog
from epafi.plot.variants import ERROR, panels

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


def draw(study, scenes, name, title, pictures):
    (abscissa, what), quantities = PICTURES[name]
    own = study["variant"].astype(str) != "reference"
    shown = [(column, text) for column, text in quantities
             if column in study and (study.numbers(column)[own] > 0).any()]
    if not shown:
        return

    def curves(axes, curve, column, label, **style):
        counted = None if column == "estimate" else curve["counted"] > 0
        loglog(axes, curve[abscissa], curve[column], label, counted, **style)

    figure = panels(scenes, shown, what, curves, "%s: %s" % (title, name.replace("_", " ")),
                    pictures)
    if any((curve["error"] > 0).any() and not (curve["counted"] > 0).all()
           for variants in scenes.values() for curve in variants.values()):
        figure.text(0.5, 0, HOLLOW, ha="center", va="top", fontsize="small")
    pictures.save(figure, name)
