"""convergence, time and contact_stress of a study: estimate and true errors of each variant."""
from epafi.plot.figures import loglog, plain_ticks, styles_of
from epafi.plot.variants import ERROR, study_figure

DOF, SECONDS = ("dof", "degrees of freedom"), ("seconds_total", "CPU seconds, all threads")
ERRORS = [("estimate", "estimate"), ("error", ERROR)]
STRESS = [("error_multiplier", "true error of the contact stress, relative")]
HOLLOW = "Hollow: below ten times the estimate of the reference, does not count."
# What is drawn against what: columns of study.csv and their labels.
PICTURES = {"convergence": (DOF, ERRORS), "time": (SECONDS, ERRORS),
            "contact_stress": (DOF, STRESS)}


def draw(study, scenes, name, title, pictures):
    (abscissa, what), quantities = PICTURES[name]
    own = study["variant"].astype(str) != "reference"
    shown = [(column, text) for column, text in quantities
             if (study.numbers(column)[own] > 0).any()]
    if not shown:
        return
    figure, axes = study_figure(scenes, shown)
    for row, (scene, variants) in zip(axes, scenes.items()):
        styles = styles_of(variants)
        for variant, curve in variants.items():
            for cell, (column, text) in zip(row, shown):
                counted = None
                if column != "estimate":
                    counted = curve["counted"] > 0
                loglog(cell, curve[abscissa], curve[column], variant, counted,
                       **styles[variant])
        for cell, (column, text) in zip(row, shown):
            plain_ticks(cell.xaxis)
            cell.set_xlabel(what)
            cell.set_ylabel(text)
            cell.set_title(scene)
            cell.legend(fontsize=7)
    figure.suptitle("%s: %s" % (title, name.replace("_", " ")), y=0.99)
    figure.tight_layout()
    if any((curve["error"] > 0).any() and not (curve["counted"] > 0).all()
           for variants in scenes.values() for curve in variants.values()):
        figure.text(0.5, 0, HOLLOW, ha="center", va="top", fontsize=8)
    pictures.save(figure, name)
