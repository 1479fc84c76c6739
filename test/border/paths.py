"""A load path on 2 and 3 ranks is that of 1 rank, with dense and with compressed operators:
history.csv, steps.csv and contact.csv.

All columns agree to 1e-10 of their scale. At nu = 1/2 the density knows the mean pressure from
gamma alone, so that rounding of u comes back in it 1e7 times as large: what is made of it, the
residuals of the estimate, agrees to 1e-8, the contact point by point to 1e-9."""
import os

import ranks
from scales import difference, worst

SETTINGS = ["Discretization->Elements per Edge={2, 2, 2, 3, 1, 9, 20, 9, 1, 3, 2, 2, 2, 3, 3, 3}",
            "History->Times={1, 2, 4}", "History->Steps={1, 2, 4}"]
OF_DENSITY = ("eta_neumann", "eta_density", "estimate", "estimate_relative",
              "worst_step_estimate")


def solve(count, ratio, method):
    folder, _ = ranks.solved(count, "%s-%g" % (method, ratio), "fretting", [
        *SETTINGS, "Solver->Linear->Method=" + method,
        "Bodies->block->Material->Poisson's Ratio=%g" % ratio])
    return [ranks.table(os.path.join(folder, name)) for name in
            ("history.csv", "steps.csv", "contact.csv")]


for method, ratio, aside, point in (("Dense", 0.3, (), 1e-10), ("Dense", 0.5, OF_DENSITY, 1e-9),
                                    ("Compressed", 0.3, (), 1e-10)):
    alone = solve(1, ratio, method)
    for count in (2, 3):
        together = solve(count, ratio, method)
        for name, one, other, bound in zip(("history.csv", "steps.csv", "contact.csv"), alone,
                                           together, (1e-10, 1e-10, point)):
            apart = worst(one, other, [column for column in one[0] if column not in aside])
            ranks.claim(apart[0] <= bound, "%s, nu = %g, %d ranks, %s: %.1e, in %s" % (
                method, ratio, count, name, *apart))
        for column in aside:
            apart = difference(alone[0], together[0], column)
            ranks.claim(apart <= 1e-8, "nu = %g, %d ranks, %s: %.1e" % (ratio, count, column, apart))
ranks.finish()
