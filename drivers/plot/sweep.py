"""sweep: dependence on one parameter of a study."""
import numpy as np

from figures import MARKERS, plt


def sweep_names(study):
    """A variant of a sweep is named '<variant>, <key> = <value>'."""
    return np.array([name.rsplit(", ", 1)[0] for name in study["variant"].astype(str)])


def draw(study, title, pictures):
    value = study.numbers("sweep_value")
    if not np.isfinite(value).any():
        return
    families = sweep_names(study)
    key = [name.rsplit(", ", 1)[1].split(" = ")[0]
           for name in study["variant"][np.isfinite(value)].astype(str)][0]
    eigen = study.numbers("smallest_eigenvalue")
    has_eigen = np.isfinite(eigen).any()
    figure, axes = plt.subplots(1 + has_eigen, 1, squeeze=False, sharex=True,
                                figsize=(7.4, 4.2 + 2.8 * has_eigen))
    estimate = axes[0, 0]
    for k, family in enumerate(dict.fromkeys(families[np.isfinite(value)])):
        here = (families == family) & np.isfinite(value)
        y = study.numbers("estimate")
        good = here & (y > 0)
        estimate.loglog(value[good], y[good], color="C%d" % k, marker=MARKERS[k],
                        label=family)
        lost = here & ~np.isfinite(y)
        if lost.any():
            top = np.nanmax(y[np.isfinite(value)]) if good.any() else 1
            estimate.loglog(value[lost], np.full(lost.sum(), top * (1.2 + 0.25 * k)), ls="",
                            marker="x", ms=6, color="C%d" % k,
                            label=family + ": not solved")
        if has_eigen:
            axes[1, 0].semilogx(value[here], eigen[here], color="C%d" % k,
                                marker=MARKERS[k], label=family)
    estimate.set_ylabel("estimate")
    estimate.legend(loc="center left", bbox_to_anchor=(1, 0.5))
    if has_eigen:
        axes[1, 0].axhline(0, color="black", lw=0.8)
        axes[1, 0].set_yscale("symlog", linthresh=1)
        axes[1, 0].set_ylabel("smallest eigenvalue of the\nstabilised stiffness, relative to S")
        axes[1, 0].legend(loc="center left", bbox_to_anchor=(1, 0.5))
    axes[-1, 0].set_xlabel(key)
    estimate.set_title("%s: dependence on %s" % (title, key))
    pictures.save(figure, "sweep")
