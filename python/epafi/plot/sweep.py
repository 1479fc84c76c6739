"""sweep: dependence on one parameter of a study."""
import numpy as np

from epafi.plot.figures import plt, style_of


def sweep_names(study):
    """A variant of a sweep is named '<variant>, <key> = <value>'."""
    return np.array([name.rsplit(", ", 1)[0] for name in study["variant"].astype(str)])


def last_levels(study, value):
    """True for the row that ends each variant with a value of the parameter."""
    scene, variant = study["scene"].astype(str), study["variant"].astype(str)
    last = {}
    for row in np.flatnonzero(np.isfinite(value)):
        last[scene[row], variant[row]] = row
    result = np.zeros(study.size, bool)
    result[list(last.values())] = True
    return result


def set_scale(axes, which, values):
    """Logarithmic where all values are positive and spread; linear near zero where one is not,
    so that none is lost."""
    setter = axes.set_xscale if which == "x" else axes.set_yscale
    sizes = np.abs(values[values != 0])
    if not sizes.size or sizes.max() < 10 * sizes.min():
        return
    if (values > 0).all():
        setter("log")
    else:
        setter("symlog", linthresh=sizes.min())


def draw(study, title, pictures):
    value = study.numbers("sweep_value")
    if not np.isfinite(value).any():
        return
    ends = last_levels(study, value)
    families = sweep_names(study)
    if len(set(study["scene"].astype(str))) > 1:
        families = np.array(["%s: %s" % pair for pair in zip(study["scene"], families)])
    key = [name.rsplit(", ", 1)[1].split(" = ")[0]
           for name in study["variant"][np.isfinite(value)].astype(str)][0]
    eigen = study.numbers("smallest_eigenvalue")
    has_eigen = np.isfinite(eigen).any()
    figure, axes = plt.subplots(1 + has_eigen, 1, squeeze=False, sharex=True,
                                figsize=(7.4, 4.2 + 2.8 * has_eigen))
    estimate = axes[0, 0]
    estimates = study.numbers("estimate")
    solved = ends & np.isfinite(estimates)
    top = np.nanmax(estimates[solved]) if solved.any() else 1
    lows = estimates[solved & (estimates > 0)]
    for k, family in enumerate(dict.fromkeys(families[ends])):
        here = ends & (families == family)
        here = np.flatnonzero(here)[np.argsort(value[here])]
        style = style_of(k)
        good = here[np.isfinite(estimates[here])]
        estimate.plot(value[good], estimates[good], label=family, **style)
        lost = here[~np.isfinite(estimates[here])]
        if lost.size:
            estimate.plot(value[lost], np.full(lost.size, top * (1.2 + 0.25 * k)), ls="",
                          marker="x", ms=6, color=style["color"],
                          label=family + ": not solved")
        if has_eigen:
            axes[1, 0].plot(value[here], eigen[here], label=family, **style)
    estimate.set_ylabel("estimate on the last level")
    if lows.size:
        set_scale(estimate, "y", np.append(lows, estimates[solved].min()))
    set_scale(estimate, "x", value[ends])
    estimate.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    if has_eigen:
        axes[1, 0].axhline(0, color="black", lw=0.8)
        axes[1, 0].set_yscale("symlog", linthresh=1)
        axes[1, 0].set_ylabel("smallest eigenvalue of the\nstabilised stiffness, relative to S")
        axes[1, 0].legend(loc="center left", bbox_to_anchor=(1, 0.5))
    axes[-1, 0].set_xlabel(key)
    estimate.set_title("%s: dependence on %s" % (title, key))
    pictures.save(figure, "sweep")
