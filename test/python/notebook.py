"""Executes a notebook, in the folder WORK, and compares what its cells print with what is stored in it;
each stored picture is drawn again.

    notebook.py NOTEBOOK.ipynb WORK
    notebook.py NOTEBOOK.ipynb WORK --store     stores what its cells show, after a change of them
"""
import os
import sys

import nbformat
from nbclient import NotebookClient

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
from claims import absent, claim, finish  # noqa: E402

FILE, WORK = os.path.abspath(sys.argv[1]), absent(sys.argv[2])
os.makedirs(WORK)


def shown(cell):
    """What a cell prints and returns as text, and the kinds of the others."""
    texts, kinds = [], []
    for output in cell.outputs:
        if output.output_type == "stream" and output.name == "stdout":
            texts.append(output.text)
        data = output.get("data", {})
        if "image/png" in data:
            kinds.append("picture")
        elif "text/plain" in data:
            texts.append(data["text/plain"])
    return "".join(texts), kinds


stored = nbformat.read(FILE, as_version=4)
executed = nbformat.from_dict(stored)
for cell in executed.cells:
    cell.metadata.pop("execution", None)
NotebookClient(executed, timeout=600, kernel_name="python3", record_timing=False,
               resources={"metadata": {"path": WORK}}).execute()
if "--store" in sys.argv:
    for cell in executed.cells:
        for output in cell.get("outputs", []):
            output.get("data", {}).pop("text/html", None)  # texts and pictures say the same
    nbformat.write(executed, FILE)
pictures = 0
for number, (old, new) in enumerate(zip(nbformat.read(FILE, as_version=4).cells, executed.cells)):
    if old.cell_type == "code":
        claim(shown(old) == shown(new), "cell %d shows what is stored: %s%s" % (
            number, shown(old), "" if shown(old) == shown(new) else ", not %s" % (shown(new),)))
        pictures += shown(new)[1].count("picture")
claim(pictures >= 3, "%d pictures" % pictures)
finish()
