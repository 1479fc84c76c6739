"""[P] section 8.3: where definiteness is lost on 256 elements, and what the program says."""
import re

from runs import claim, finish, run

ONCE = ["Adaptivity->Strategy=None", "Output->Fields=false",
        "Discretization->Elements per Edge={64, 64, 64, 64}"]


def solve(form, gamma, code):
    return run("coulomb", ONCE + ["Discretization->Stabilization->Form=" + form,
                                  "Discretization->Stabilization->Gamma0=%r" % gamma], code)


for form in ("Projected", "Exact"):
    text = solve(form, 0.152, 2).text
    said = float(re.search(r"below (\S+) it is definite", text).group(1))
    claim(0.11 < said < 0.16, "%s: definiteness is lost at gamma0 = %g" % (form, said))
    solve(form, said * 0.999, 0)
    solve(form, said * 1.001, 2)
    claim(True, "%s: a thousandth below it is solved, above refused" % form)
finish()
