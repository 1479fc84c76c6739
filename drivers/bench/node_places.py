#!/usr/bin/env python3
"""Errors of two forms of the stabilisation on many uniform meshes: where a mesh cuts the ends of
contact decides its error, so that one mesh does not compare forms.

    node_places.py EPAFI DIR [--degrees 1,2,3] [--elements 20:64:2]

Solves scenes/coulomb.xml under Projected, gamma0 = 0.1, and Density with some gamma0; prints for
each degree the ratios of the errors of u, psi and of lambda, against a reference in DIR.
"""
import argparse
import csv
import math
import os
import statistics
import subprocess

SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "scenes", "coulomb.xml")
FORMS = [("Projected", 0.1), ("Density", 0.5), ("Density", 2), ("Density", 10)]
HEAD = """<ParameterList name="Places of nodes"><ParameterList name="Scenes"><ParameterList
  name="Coulomb"><Parameter name="File" type="string" value="%s"/><Parameter name="Set"
  type="Array(string)" value="{Discretization->Stabilization->Scaling=Stiffness}"/><ParameterList
  name="Reference"><Parameter name="Set" type="Array(string)" value="{
  Adaptivity->Marking Fraction=0.5, Adaptivity->Maximum Levels=200,
  Adaptivity->Maximum Degrees of Freedom=3000, Adaptivity->Target Estimate=4e-9,
  Discretization->Stabilization->Form=Density, Discretization->Stabilization->Gamma0=0.5}"/>
  </ParameterList></ParameterList></ParameterList><ParameterList name="Variants">"""
VARIANT = """<ParameterList name="%s %g %d"><ParameterList name="Override"><ParameterList
  name="Adaptivity"><Parameter name="Strategy" type="string" value="None"/><Parameter
  name="Maximum Degrees of Freedom" type="int" value="100000"/></ParameterList><ParameterList
  name="Discretization"><Parameter name="Degree" type="int" value="%d"/><Parameter
  name="Elements per Edge" type="Array(int)" value="{%d, %d, %d, %d}"/><ParameterList
  name="Stabilization"><Parameter name="Form" type="string" value="%s"/><Parameter
  name="Gamma0" type="double" value="%g"/></ParameterList></ParameterList></ParameterList>
  </ParameterList>"""


def errors(epafi, folder, degree, elements):
    os.makedirs(folder, exist_ok=True)
    study = os.path.join(folder, "study.xml")
    with open(study, "w") as file:
        file.write(HEAD % os.path.abspath(SCENE))
        for n in elements:
            for form, gamma0 in FORMS:
                file.write(VARIANT % (form, gamma0, n, degree, n, n, n, n, form, gamma0))
        file.write("</ParameterList></ParameterList>")
    subprocess.run([epafi, "study", study, "--output", folder, "--force", "--quiet",
                    "--threads", "1"], check=False)
    with open(os.path.join(folder, "study.csv"), newline="") as file:
        return {row["variant"]: (float(row["error"]), float(row["error_multiplier"]))
                for row in csv.DictReader(file) if row["variant"] != "reference"}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("epafi")
    parser.add_argument("folder")
    parser.add_argument("--degrees", default="1,2,3")
    parser.add_argument("--elements", default="20:64:2")
    options = parser.parse_args()
    first, last, step = map(int, options.elements.split(":"))
    elements = range(first, last + 1, step)
    print("| p | gamma0 | of | geometric mean | median | least | most | above 1 |")
    for degree in map(int, options.degrees.split(",")):
        found = errors(options.epafi, options.folder, degree, elements)
        for form, gamma0 in FORMS[1:]:
            for k, what in enumerate(["u, psi", "lambda"]):
                ratios = [found["%s %g %d" % (form, gamma0, n)][k] /
                          found["%s %g %d" % (*FORMS[0], n)][k] for n in elements]
                mean = math.exp(statistics.fmean(map(math.log, ratios)))
                print("| %d | %g | %s | %.2f | %.2f | %.2f | %.2f | %d of %d |" % (
                    degree, gamma0, what, mean, statistics.median(ratios), min(ratios),
                    max(ratios), sum(r > 1 for r in ratios), len(ratios)), flush=True)


if __name__ == "__main__":
    main()
