"""Compressed against dense operators over combinations of body, mesh, law, form and size: energies
to 1e-9, the same states of contact, no more steps of Newton's.

    agreement.py EPAFI SCENES WORK [--only WORD]... [--large]

Prints a line for each combination, and a summary by kind as the table of
doc/benchmarks/compression.md.  --large: with 2048 and 4096 elements.
"""
import argparse
import os
import sys

from runs import ENERGIES, WORK, absent, claim, differ, epafi, finish, saved, table
from written import CLAMPED, NONE, block, body, condition, contact, geometry, keys, listed, loop

LAWS = {"frictionless": {}, "Tresca": {"Threshold": "0.002*(1 + x)"}, "Coulomb": {"Coefficient": "0.3"}}
FORMS = {  # multiplier, form
    "GLL": ("Gauss-Legendre-Lagrange", "Density"), "GLoL": ("Gauss-Lobatto-Lagrange", "Density"),
    "Bernstein": ("Bernstein", "Density"), "Biorthogonal": ("Biorthogonal", "None")}
FORMED = 1000  # multipliers up to which compressed operators form D
SMALLEST = 1e-8  # edge of an outline that is cut towards its corners, of its side
# Graded hp, from few elements: a tenth of the smallest with every other level
GRADED = ["Adaptivity->Strategy=Graded hp", "Adaptivity->Maximum Levels=20",
          "Adaptivity->Marking Fraction=0.3", "Adaptivity->Maximum Degrees of Freedom=1500"]


def cut(corners, sides):
    """Outline whose sides are cut towards both ends, halved until SMALLEST remains."""
    points, names = [], []
    for k, (x, y) in enumerate(corners):
        a, b = corners[(k + 1) % len(corners)]
        shares = [0.0]
        place = 0.25
        while place > SMALLEST:
            shares.insert(1, place)
            place /= 2
        shares += [0.5] + [1 - share for share in reversed(shares[1:])]
        points += [(x + s * (a - x), y + s * (b - y)) for s in shares]
        names += [sides[k]] * len(shares)
    return points, names


def friction(law):
    return listed("Friction", keys(Law={"frictionless": "None"}.get(law, law)), **LAWS[law])


def counts(number, edges, weights):
    """Elements of each edge, `number` in all, some per weight."""
    share = number / sum(weights)
    return [max(1, round(share * w)) for w in weights[:edges]]


class Combination:
    """A scene.  Body: block, hole, arcs, two, beam (1 : 30); mesh: uniform, graded, cut (an
    outline with many corners, no arcs)."""

    def __init__(self, kind, mesh, law, form, elements, degree=1, ratio=1000):
        self.kind, self.mesh, self.law, self.form = kind, mesh, law, form
        self.elements, self.degree, self.ratio = elements, degree, ratio

    def name(self):
        return "%s, %s, %s, %s, %d elements, p = %d" % (
            self.kind, self.mesh, self.law, self.form, self.elements, self.degree)

    def outline(self, corners, sides, elements, bulges=(), hole=False):
        holes = more = NONE
        weights = [15, 1, 15, 1] if self.kind == "beam" else [1] * len(corners)
        if self.mesh == "cut":
            corners, sides = cut(corners, sides)
            weights = [1] * len(corners)
        if hole:
            holes = loop(block(-0.1, 0.2, 0.1, 0.5), ["rim"] * 4, hole="Hole 1 ")
            more = keys(Hole_1_Elements_per_Edge=counts(elements // 4, 4, [1] * 4))
            elements = elements - elements // 4
        mesh = listed("Mesh", more, Degree=self.degree,
                      Elements_per_Edge=counts(elements, len(corners), weights))
        return geometry(corners, sides, bulges, holes), mesh

    def scene(self):
        sides = ["bottom", "right", "top", "left"]
        press = condition("top", "Neumann", Traction_X="0.001", Traction_Y="-0.01*(1 + 0.3*x)")
        touch = condition("bottom", "Contact", friction(self.law), Gap="0.002*x^2")
        contacts = NONE
        upper = block(-0.5, 0, 29.5, 1) if self.kind == "beam" else block(-0.5, 0, 0.5, 0.75)
        bulges = (0.05, 0, 0, 0) if self.kind == "arcs" else ()
        share = self.elements // 2 if self.kind == "two" else self.elements
        outline, mesh = self.outline(upper, sides, share, bulges, self.kind == "hole")
        if self.kind == "two":
            under, coarse = self.outline(block(-1, -1, 1, 0), sides, self.elements - share)
            bodies = [body("pad", outline, 1.0, press, "X, Rotation", mesh),
                      body("plate", under, self.ratio, condition("bottom", "Dirichlet", CLAMPED),
                           mesh=coarse)]
            contacts = contact("joint", "pad:bottom", "plate:top", friction(self.law))
        elif self.kind == "hole":
            held = condition("rim", "Dirichlet", Displacement_X="0", Displacement_Y="-0.01")
            bodies = [body("block", outline, 1.0, press + touch + held, mesh=mesh)]
        elif self.kind == "arcs":
            held = condition("right", "Dirichlet", CLAMPED)
            bodies = [body("block", outline, 1.0, press + touch + held, mesh=mesh)]
        else:
            bodies = [body("block", outline, 1.0, press + touch, "X, Rotation", mesh)]
        multiplier, form = FORMS[self.form]
        return keys(listed("Bodies", *bodies), listed("Contacts", contacts) if contacts else NONE,
                    listed("Discretization", listed("Stabilization", Form=form), Mesh_Size=10,
                           Multiplier=multiplier),
                    listed("Adaptivity", Strategy="None", Maximum_Degrees_of_Freedom=1000000),
                    listed("Output", Fields=False, Contact_Samples_per_Element=2))


class Result:
    def __init__(self, file, folder, method, settings=()):
        self.code, self.text = epafi("run", file, "--quiet", "--threads", "1", "--output",
                                     absent(folder), settings=["Solver->Linear->Method=" + method,
                                                               *settings])
        if self.code != 0:
            return
        self.rows = table(os.path.join(folder, "history.csv"))
        points = table(os.path.join(folder, "contact.csv"))
        self.states = [(point["contact"], point["friction"]) for point in points]
        self.pressures = [point["lambda_n"] for point in points]
        self.steps = sum(int(row["newton_iterations"]) for row in self.rows)
        last = self.rows[-1]
        self.seconds = sum(last["seconds_" + phase] for phase in (
            "assembly", "factorization", "stabilization", "newton", "estimate"))


class Comparison:
    """Of the two methods."""

    def __init__(self, name, file, settings=()):
        self.name = name
        folder = os.path.join(WORK, "run")
        self.dense = Result(file, folder + "-dense", "Dense", settings)
        self.own = Result(file, folder + "-compressed", "Compressed", settings)
        self.solved = self.dense.code == 0 and self.own.code == 0
        if not self.solved:
            return
        rows = list(zip(self.dense.rows, self.own.rows))
        self.energy = max(differ(a[key], b[key], a["energy_strain"])
                          for a, b in rows for key in ENERGIES)
        scale = max(map(abs, self.dense.pressures), default=0) or 1
        self.pressure = max((abs(a - b) for a, b in zip(self.dense.pressures, self.own.pressures)),
                            default=0) / scale
        self.sets = sum(a != b for a, b in zip(self.dense.states, self.own.states)) + abs(
            len(self.dense.states) - len(self.own.states))
        self.smallest = self.own.rows[-1]["size_min"]
        self.more = self.own.steps - self.dense.steps

    def line(self):
        if not self.solved:
            return "%s: dense exit %d, compressed exit %d\n    %s\n    %s" % (
                self.name, self.dense.code, self.own.code, self.dense.text, self.own.text)
        return "%-75s energy %.1e  pressure %.1e  sets %d  steps %d %d  s %.2f %.2f" % (
            self.name, self.energy, self.pressure, self.sets, self.dense.steps, self.own.steps,
            self.dense.seconds, self.own.seconds)

    def holds(self):
        if not self.solved:
            return self.dense.code == 2  # what dense operators do not solve, nobody is asked to
        # where D is formed steps are the same ones; else what rounding leaves of a residual
        # may ask for one more on a level
        isFormed = max(row["dof_multiplier"] for row in self.own.rows) <= FORMED
        return self.energy < 1e-9 and self.sets == 0 and self.more <= (
            0 if isFormed else max(len(self.own.rows), 0.1 * self.dense.steps))


def combinations(large):
    kinds = ("block", "hole", "arcs", "two")
    turn = [(law, form) for law in LAWS for form in FORMS]
    chosen = [Combination(kind, "uniform", law, form, 256) for kind in kinds for law, form in turn]
    chosen += [Combination(kind, "graded", law, form, 16) for kind in kinds for law, form in turn]
    for degree in range(2, 13):
        for k, kind in enumerate(kinds):
            law, form = turn[(4 * degree + 7 * k) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, max(24, 512 // degree), degree))
    for k, kind in enumerate(("block", "hole")):
        for i in range(3):
            law, form = turn[(2 * k + 5 * i) % len(turn)]
            chosen.append(Combination(kind, "cut", law, form, 512))
    chosen += [Combination("two", "cut", "frictionless", form, 512) for form in FORMS]
    for k, kind in enumerate(kinds):
        for i in range(3):
            law, form = turn[(2 * k + 5 * i) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, 1024))
    for i in range(12):
        law, form = turn[5 * i % len(turn)]
        chosen.append(Combination("beam", "uniform", law, form, 1024 if i % 4 == 0 else 512, 1 + i % 2))
    if large:
        for k, kind in enumerate(kinds):
            law, form = turn[(4 * k + 1) % len(turn)]
            chosen.append(Combination(kind, "uniform", law, form, 2048))
        chosen.append(Combination("block", "uniform", "Coulomb", "GLL", 4096))
        chosen.append(Combination("two", "uniform", "Tresca", "Biorthogonal", 4096))
    return chosen


def summary(results):
    """Rows of a Markdown table."""
    groups = {}
    for case, result in results:
        for kind in ("all", case.kind, case.mesh, case.law, case.form,
                     "p = 2 to 12" if case.degree > 1 else "p = 1",
                     "1024 elements and more" if case.elements >= 1024 else "fewer"):
            groups.setdefault(kind, []).append(result)
    print(
        "| | scenes | energies to | pressures to | points of another state | smallest element | Newton steps, "
        "dense and compressed | scenes with more |\n|---|---|---|---|---|---|---|---|")
    for kind, group in groups.items():
        both = [result for result in group if result.solved]
        if both:
            print("| %s | %d | %.0e | %.0e | %d | %.0e | %d, %d | %d |" %
                  (kind, len(both), max(r.energy for r in both), max(r.pressure for r in both),
                   sum(r.sets for r in both), min(r.smallest for r in both),
                   sum(r.dense.steps for r in both), sum(r.own.steps for r in both),
                   sum(r.more > 0 for r in both)))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--large", action="store_true")
    options = parser.parse_args(sys.argv[4:])
    results = []
    for case in combinations(options.large):
        if not all(word in case.name() for word in options.only):
            continue
        file = saved("scene", case.scene(), case.name())
        result = Comparison(case.name(), file, GRADED if case.mesh == "graded" else ())
        claim(result.holds(), result.line())
        sys.stdout.flush()
        results.append((case, result))
    summary(results)
    finish()


if __name__ == "__main__":
    main()
