"""law.py LAW SOURCES WORK EPAFI MPIEXEC: the program of doc/howto/law does with its own law what
epafi does with those built in; epafi itself does not know it."""
import csv
import os
import subprocess
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import claim, finish  # noqa: E402

LAW, SOURCES, WORK, EPAFI, MPIEXEC = sys.argv[1:6]
SCENE = os.path.join(SOURCES, "slide.xml")


def said(*command):
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True)
    return done.returncode, done.stdout


code, text = said(LAW, "parameters")
claim(code == 0 and "'Shaw'" in text and "'Layer'" in text and "Friction->Exponent" in text, "parameters lists the law")
claim(said(LAW, "check", SCENE)[0] == 0, "check accepts the scene")
code, text = said(LAW, "check", SCENE, "--set",
                  "Bodies->block->Boundary Conditions->floor->Friction->Exponent=0.5")
claim(code == 1 and ">= 1" in text, "the law's range holds")
code, text = said(EPAFI, "check", SCENE)
claim(code == 1 and "Friction->Exponent: unknown" in text, "epafi does not know the laws")

bound = 0.5 / (1 + (0.5 / 0.3) ** 3) ** (1 / 3)
for ranks in (1, 2):
    folder = os.path.join(WORK, "slide.%d" % ranks)
    code, text = said(MPIEXEC, "-n", str(ranks), LAW, "run", SCENE, "--force", "--output", folder)
    claim(code == 0, "runs on %d ranks: %s" % (ranks, text))
    with open(os.path.join(folder, "contact.csv")) as stream:
        points = [{key: float(row[key]) for key in ("lambda_n", "lambda_t", "bound", "friction",
                                                     "normal_closing")}
                  for row in csv.DictReader(stream)]
    claim(len(points) > 8, "there are points")
    for key, value in (("lambda_n", 1), ("lambda_t", bound), ("bound", bound), ("friction", 2),
                       ("normal_closing", 0.01)):
        claim(max(abs(point[key] - value) for point in points) < 1e-9, key + " in closed form")
    with open(os.path.join(folder, "used.xml")) as stream:
        claim("Shaw" in stream.read(), "used.xml repeats the law")
finish()
