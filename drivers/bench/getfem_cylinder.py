#!/usr/bin/python3
"""A solid of revolution by finite elements and by boundary elements: what does an error cost?

    drivers/bench/getfem_cylinder.py EPAFI

Wants GetFEM with its Python interface and MUMPS: apt-get install python3-getfem.  A cylinder R = 1,
H = 2, nu = 0.3 is shortened by 0.01 between clamped ends; one half is solved, by GetFEM with quadrilaterals
of degree 2 (uniform, and graded toward the rim of the clamp by the square of a uniform grid), by
Epafi with Graded hp, on one thread.  The error is that of the force, 1.656095199650e-2.  Prints the table of
doc/theory/axisymmetric.md: unknowns and CPU seconds of the first level with an error at most the
column's.  GetFEM's are those of that level's assembly and solution, the median of three; Epafi's those of
the whole program, its start, all levels up to that one and their estimates included.
"""
import csv
import json
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ[variable] = "1"

import getfem as gf  # noqa: E402
import numpy as np  # noqa: E402

from study_tables import markdown, told  # noqa: E402

FORCE = 1.656095199650e-2
BOUNDS = [1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10]
CLAMP, MIDDLE, AXIS = 1, 2, 3
ENERGY = ("pi*X(1)*(lame*sqr(Grad_u(1)+u/X(1)+Grad_w(2))"
          "+2*mu*(sqr(Grad_u(1))+sqr(u/X(1))+sqr(Grad_w(2))+0.5*sqr(Grad_u(2)+Grad_w(1))))")


def getfem_level(cells, grading):
    """Unknowns, error of the force, CPU seconds."""
    sides = np.linspace(0, 1, cells + 1)
    mesh = gf.Mesh("cartesian", 1 - (1 - sides) ** grading, sides ** grading)
    tiny = 1e-9
    for region, low, high in ((CLAMP, (-1, -1), (2, tiny)), (MIDDLE, (-1, 1 - tiny), (2, 2)),
                              (AXIS, (-1, -1), (tiny, 2))):
        mesh.set_region(region, mesh.outer_faces_in_box(low, high))
    began = time.process_time()
    space = gf.MeshFem(mesh, 1)
    space.set_fem(gf.Fem("FEM_QK(2,2)"))
    rule = gf.MeshIm(mesh, gf.Integ("IM_GAUSS_PARALLELEPIPED(2,8)"))
    model = gf.Model("real")
    model.add_initialized_data("lame", 0.3 / 1.3 / 0.4)
    model.add_initialized_data("mu", 1 / 2.6)
    model.add_initialized_data("moved", [0.005])
    for name in "u", "w":
        model.add_fem_variable(name, space)
    model.add_linear_term(
        rule, "2*pi*X(1)*(lame*(Grad_u(1)+u/X(1)+Grad_w(2))*(Grad_Test_u(1)+Test_u/X(1)+Grad_Test_w(2))"
        "+2*mu*(Grad_u(1)*Grad_Test_u(1)+u*Test_u/sqr(X(1))+Grad_w(2)*Grad_Test_w(2)"
        "+0.5*(Grad_u(2)+Grad_w(1))*(Grad_Test_u(2)+Grad_Test_w(1))))")
    for name, region in (("u", CLAMP), ("u", AXIS), ("w", MIDDLE)):
        model.add_Dirichlet_condition_with_simplification(name, region)
    model.add_Dirichlet_condition_with_simplification("w", CLAMP, "moved")
    model.solve("lsolver", "mumps")
    seconds = time.process_time() - began
    energy = 2 * gf.asm_generic(rule, 0, ENERGY, -1, model)
    return 2 * space.nbdof(), abs(2 * energy / 0.01 / FORCE - 1), seconds


def epafi_levels(program):
    scene = {"Geometry": {"Type": "Axisymmetric"}, "Bodies": {"half": {
        "Material": {"Young's Modulus": 1, "Poisson's Ratio": 0.3},
        "Geometry": {"Vertices": [[0, 0], [1, 0], [1, 1], [0, 1]],
                     "Edges": ["clamp", "side", "middle", "axis"]},
        "Boundary Conditions": {
            "clamp": {"Type": "Dirichlet", "Displacement X": 0, "Displacement Y": 0.005},
            "middle": {"Type": "Dirichlet", "Displacement Y": 0}}}},
        "Discretization": {"Mesh Size": 1, "Degree": 2},
        "Adaptivity": {"Strategy": "Graded hp", "Maximum Levels": 18}, "Output": {"Fields": False}}
    with tempfile.TemporaryDirectory() as folder:
        file, results = (os.path.join(folder, name) for name in ("scene.yaml", "results"))
        with open(file, "w", encoding="utf-8") as stream:
            json.dump({"cylinder": scene}, stream)
        runs = []
        for _ in range(3):
            before = resource.getrusage(resource.RUSAGE_CHILDREN)
            subprocess.run([program, "run", file, "--quiet", "--threads", "1", "--force", "--output", results],
                           check=True)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            with open(os.path.join(results, "history.csv"), newline="", encoding="utf-8") as stream:
                rows = list(csv.DictReader(stream))
            start = after.ru_utime - before.ru_utime - float(rows[-1]["seconds_total"])
            runs.append([max(0, start) + float(row["seconds_total"]) for row in rows])
    return [(int(row["dof_displacement"]) + int(row["dof_density"]),
             abs(2 * float(row["energy_strain"]) / 0.005 / FORCE - 1), statistics.median(seconds))
            for row, seconds in zip(rows, zip(*runs))]


def cells(levels):
    """The first level from which on errors stay at most the bound."""
    for bound in BOUNDS:
        good = [k for k in range(len(levels)) if all(error <= bound for _, error, _ in levels[k:])]
        yield "%d, %.3g s" % (levels[good[0]][0], levels[good[0]][2]) if good else "-"


if __name__ == "__main__":
    rows = []
    for title, grading in (("uniform", 1), ("graded by hand", 2)):
        levels = []
        for count in (4, 8, 16, 32, 64, 128):
            found = [getfem_level(count, grading) for _ in range(3)]
            levels.append((*found[0][:2], statistics.median(seconds for _, _, seconds in found)))
            print("GetFEM,", title, *levels[-1], flush=True)
        rows.append(["GetFEM, Q2, " + title, *cells(levels)])
    levels = epafi_levels(sys.argv[1])
    for level in levels:
        print("Epafi", *level)
    rows.append(["Epafi, graded hp", *cells(levels)])
    print(markdown(["refinement", *map(told, BOUNDS)], rows))
