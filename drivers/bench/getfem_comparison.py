#!/usr/bin/python3
"""One contact problem by finite elements and by boundary elements: what does an error cost?

    drivers/bench/getfem_comparison.py EPAFI [--levels FILE.csv]

Wants GetFEM with its Python interface and MUMPS: apt-get install python3-getfem.  drivers/scenes/
tresca.xml is solved by Epafi and by GetFEM (triangles, augmented Lagrangian, multipliers of the
degree of the displacements, Newton's method), on one thread.  The tables "getfem" of README.md and
doc/benchmarks/work-precision.md are written anew; --levels writes all levels that were solved.

The error of a level is the larger of the relative errors of strain energy and normal contact force,
against a run of Epafi to an estimate of 4e-9.  GetFEM's own limit, extrapolated from its finest
meshes, is printed beside that reference.  A cell of the tables: unknowns and CPU seconds of the
first level from which on errors stay at most the column's.  GetFEM's seconds are those of that level
alone, assembly and solution, the median of three, without meshing; Epafi's are those of the whole
program, all levels up to that one and their estimates included.
"""
import argparse
import csv
import os
import statistics
import sys
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[variable] = "1"

import getfem as gf  # noqa: E402
import numpy as np  # noqa: E402

import study_tables  # noqa: E402

sys.path.insert(0, os.path.join(study_tables.ROOT, "python"))
import epafi  # noqa: E402

SCENE = os.path.join(study_tables.ROOT, "drivers", "scenes", "tresca.xml")
BOUNDS = [1e-2, 1e-3, 1e-4, 1e-5]
# Where u ~ r^a, and a: ends of the clamp; from Epafi's solution, ends of contact and of stick.
SINGULAR = [((0.25, 0.5), 0.5), ((0.5, 0.5), 0.7),
            ((-0.0912, -0.5), 1.5), ((0.0270, -0.5), 1.5), ((0.1072, -0.5), 1.5)]
BOTTOM, PRESS, CLAMP, LEFT = 1, 2, 3, 4


def mesh_of(cells, degree, graded):
    """Triangles of size h = 1/cells; graded: of size h (2 r)^(1 - a/p) at the distance r of a
    singular point and h^(p/a) there, so that the order is that of smooth solutions."""
    sides = np.linspace(-0.5, 0.5, cells + 1)
    mesh = gf.Mesh("regular simplices", sides, sides)
    while graded:
        numbers = mesh.cvid()
        corners = mesh.pts()[:, mesh.pid_from_cvid(numbers)[0]].reshape(2, -1, 3)
        edges = corners - np.roll(corners, 1, axis=2)
        size = np.sqrt((edges ** 2).sum(axis=0).max(axis=1) / 2)
        coarse = np.zeros(len(numbers), bool)
        for point, strength in SINGULAR:
            away = corners - np.array(point)[:, None, None]
            distance = np.sqrt((away ** 2).sum(axis=0).min(axis=1)) / 0.5
            smallest = cells ** (-degree / strength)
            coarse |= size > 1.05 / cells * np.maximum(distance, smallest) ** (1 - strength / degree)
        if not coarse.any():
            break
        mesh.refine(numbers[coarse])
    tiny = 1e-9
    for region, low, high in ((BOTTOM, (-0.6, -0.5 - tiny), (0.6, -0.5 + tiny)),
                              (PRESS, (-0.6, 0.5 - tiny), (-0.25 + tiny, 0.6)),
                              (CLAMP, (0.25 - tiny, 0.5 - tiny), (0.6, 0.6)),
                              (LEFT, (-0.6, -0.6), (-0.5 + tiny, 0.6))):
        mesh.set_region(region, mesh.outer_faces_in_box(low, high))
    return mesh


def getfem_level(mesh, degree):
    """Unknowns, strain energy, contact force, CPU seconds."""
    began = time.process_time()
    displacements, stresses = gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 1)
    for space in displacements, stresses:
        space.set_fem(gf.Fem("FEM_PK(2,%d)" % degree))
    rule = gf.MeshIm(mesh, gf.Integ("IM_TRIANGLE(%d)" % (6 if degree > 1 else 4)))
    model = gf.Model("real")
    model.add_fem_variable("u", displacements)
    for name in "pressure", "shear":
        model.add_filtered_fem_variable(name, stresses, BOTTOM)
    young, poisson = 500.0, 0.3
    model.add_initialized_data("lame", young * poisson / (1 + poisson) / (1 - 2 * poisson))
    model.add_initialized_data("mu", young / 2 / (1 + poisson))
    model.add_initialized_data("r", young)
    model.add_isotropic_linearized_elasticity_brick(rule, "u", "lame", "mu")
    model.add_Dirichlet_condition_with_simplification("u", CLAMP)
    model.add_source_term(rule, "(0.5-X(2))*(0.5+X(2))*Test_u(1)", LEFT)
    model.add_source_term(rule, "20*(-0.5-X(1))*(-0.25-X(1))*Test_u(2)", PRESS)
    # The saddle point of ([p + r (u_n - gap)]_+^2 - p^2)/(2 r) and the like for shear: contact
    # stresses are the projections of what is in brackets.
    closing = "pos_part(pressure+r*(-u(2)-1+sqrt(1-sqr(X(1))/100)))"
    trial, bound = "(shear+r*u(1))", "(0.211+0.412*X(1))"
    sliding = "({0}-pos_part({0}-{1})+pos_part(-{0}-{1}))".format(trial, bound)
    model.add_nonlinear_term(
        rule, "-{0}*Test_u(2)+{1}*Test_u(1)-(1/r)*(pressure-{0})*Test_pressure"
        "-(1/r)*(shear-{1})*Test_shear".format(closing, sliding), BOTTOM, True, False)
    steps, converged = model.solve("max_res", 1e-10, "max_iter", 60, "lsolver", "mumps",
                                   "lsearch", "simplest")
    seconds = time.process_time() - began
    if not converged:
        raise SystemExit("GetFEM: no convergence with %d triangles" % mesh.nbcvs())
    energy = gf.asm_generic(
        rule, 0, "0.5*lame*sqr(Trace(Grad_u))+mu*Norm_sqr(Sym(Grad_u))", -1, model)
    force = gf.asm_generic(rule, 0, "pressure", BOTTOM, model)
    unknowns = sum(model.variable(name).size for name in ("u", "pressure", "shear"))
    return [unknowns, energy, force, seconds]


def getfem_levels(degree, graded, cells):
    levels = []
    for count in cells:
        mesh = mesh_of(count, degree, graded)
        runs = [getfem_level(mesh, degree) for _ in range(3)]
        levels.append(runs[0][:3] + [statistics.median(run[3] for run in runs)])
        print("GetFEM P%d%s, 1/%d:" % (degree, " graded" * graded, count), *levels[-1], flush=True)
    return levels


def epafi_levels(strategy, **changes):
    """The same numbers of every level; seconds are those up to that level, the median of three."""
    settings = {"Discretization->Stabilization": {}, "Adaptivity->Strategy": strategy,
                "Adaptivity->Maximum Degrees of Freedom": 6000}
    settings.update({"Adaptivity->" + key.replace("_", " "): value
                     for key, value in changes.items()})
    runs = [epafi.run(SCENE, set=settings, threads=1).history for _ in range(3)]
    seconds = np.median([run["seconds_total"] for run in runs], axis=0)
    return [list(level) for level in zip(runs[0]["dof"].astype(int), runs[0]["energy_strain"],
                                         runs[0]["force_normal"], seconds)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("--levels")
    options = parser.parse_args()
    os.environ["EPAFI"] = os.path.abspath(options.epafi)
    gf.util_trace_level(0)
    reference = epafi_levels("Graded hp", Marking_Fraction=0.5, Maximum_Levels=200,
                             Maximum_Degrees_of_Freedom=3000, Target_Estimate=4e-9)[-1]
    families = {
        "GetFEM, P1, uniform": getfem_levels(1, False, (16, 32, 64, 128, 256)),
        "GetFEM, P2, uniform": getfem_levels(2, False, (4, 8, 16, 32, 64)),
        "GetFEM, P2, graded by hand": getfem_levels(2, True, (4, 8, 12, 16, 24)),
        "Epafi, p = 1, uniform": epafi_levels("Uniform h"),
        "Epafi, the paper's hp algorithm": epafi_levels("Adaptive hp", Maximum_Levels=200,
                                                        Maximum_Degrees_of_Freedom=1500),
        "Epafi, graded hp": epafi_levels("Graded hp", Maximum_Levels=200,
                                         Maximum_Degrees_of_Freedom=1500)}

    def error(level):
        return max(abs(level[k] / reference[k] - 1) for k in (1, 2))

    def cell(levels, bound):
        first = len(levels)
        while first > 0 and error(levels[first - 1]) <= bound:
            first -= 1
        return "%d, %.2f s" % (levels[first][0], levels[first][3]) if first < len(levels) else "-"

    rows = [[name] + [cell(levels, bound) for bound in BOUNDS] for name, levels in families.items()]
    table = study_tables.markdown(
        ["refinement"] + ["%.0e" % bound for bound in BOUNDS], rows).replace("e-0", "e-")
    coarse, fine = (families["GetFEM, P2, graded by hand"][k] for k in (2, 4))  # 1/12, 1/24: order 3
    limits = ["%.6e (GetFEM's limit %.6e)" % (reference[k], fine[k] + (fine[k] - coarse[k]) / 7)
              for k in (1, 2)]
    print(table, "reference: strain energy %s, contact force %s" % tuple(limits), sep="\n")
    if options.levels:
        with open(options.levels, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow(["family", "unknowns", "energy", "force", "seconds", "error"])
            writer.writerows([name] + level + [error(level)]
                             for name, levels in families.items() for level in levels)
    for page in "README.md", os.path.join("doc", "benchmarks", "work-precision.md"):
        study_tables.replace(os.path.join(study_tables.ROOT, page), {"getfem": table})


if __name__ == "__main__":
    main()
