"""A run as one page of HTML: key results, scene, mesh, balance, pictures, warnings, command, versions."""
from __future__ import annotations

import base64
import datetime
import html
import io
import math
import os
import re
import shlex
import xml.etree.ElementTree as xml
from typing import Iterable, Optional, Sequence

import numpy as np
from matplotlib.figure import Figure

from epafi.plot.figures import Pictures, plt
from epafi.plot.folder import when
from epafi.plot.inside import NAMES as FIELDS
from epafi.plot.results import ROUNDING, Contacts, extent, largest_stress, settled
from epafi.program import EpafiError
from epafi.runs import Run
from epafi.tables import HISTORY, Table, counted, html_table, own, read, shown_step, title_of

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%s</title><style>
body { font-family: sans-serif; max-width: 72em; margin: 2em auto; padding: 0 1em; }
nav a { margin-right: 1.2em; }
table { border-collapse: collapse; font-size: 85%%; margin: 1em 0; }
th, td { padding: 0.2em 0.7em; text-align: right; border-bottom: 1px solid #ccc; }
td:first-child, th:first-child { text-align: left; }
.results td { text-align: left; } .results { font-size: 100%%; }
.results td:nth-child(3) { text-align: right; font-weight: bold; white-space: nowrap; }
.wide { overflow-x: auto; }
img { max-width: 100%%; display: block; margin: 0.5em 0; }
figure { margin: 1.5em 0; } figcaption { color: #444; }
pre { background: #f6f6f4; padding: 1em; overflow-x: auto; }
.warning { border-left: 0.4em solid #D55E00; padding-left: 0.8em; }
</style></head><body>
%s
</body></html>
"""
SHARES = ("load", "body_force", "contact", "reaction")
# The pictures in their order, and what they show; a field comes first.
SHOWN = {
    "contact": "Contact: pressure, shear and the bound of friction; displacements and gap.",
    "deformed": "Deformed bodies; arrows are tractions on them.",
    "path": "Forces along the path, friction's work or the length in contact.",
    "slip": "Slip over place and time.",
    "rigid": "Motions of rigid bodies and forces on them.",
    "steps": "Contact at several steps of the path.",
    "convergence": "Estimated error against unknowns.",
    "contributions": "Terms of the estimate.",
    "mesh": "Sizes and degrees of elements.",
    "time": "Estimated error against seconds."}


def image(data: bytes, kind: str, text: str) -> str:
    return '<img alt="%s" src="data:image/%s;base64,%s">' % (
        html.escape(text), kind, base64.b64encode(data).decode())


def embedded(figure: Figure, text: str) -> str:
    """A figure as an element of HTML; it is closed."""
    stream = io.BytesIO()
    figure.savefig(stream, format="png", bbox_inches="tight")
    plt.close(figure)
    return image(stream.getvalue(), "png", text)


def from_file(file: str, text: str) -> str:
    with open(file, "rb") as stream:
        return "<figure>%s<figcaption>%s</figcaption></figure>" % (
            image(stream.read(), file[-3:], text), html.escape(text))


def wide(table: str) -> str:
    return '<div class="wide">%s</div>' % table


def balance(table: Table, step: Optional[int], outline: Optional[Table]) -> str:
    """What acts on each body, or on the one there is, on the last level at a step, else at the last
    one; the sum is what is left of equilibrium."""
    rows = np.flatnonzero(table["level"] == table["level"].max())
    if "step" in table:
        rows = rows[table["step"][rows] == (step or table["step"][rows].max())]
    lines = []
    parts = ("x", "y", "moment")
    shares = np.array([[np.nan_to_num(table.numbers(
        "body_moment" if (share, part) == ("body_force", "moment") else share + "_" + part)[rows])
        for share in SHARES] for part in parts])
    acting = np.concatenate([shares, shares.sum(axis=1, keepdims=True)], axis=1)
    length = extent(outline)
    # tractions that balance each other leave no force, but rounding of their size
    force = max(np.abs(acting[:2]).max(), length * np.hypot(
        outline["tx"], outline["ty"]).mean() if outline else 0)
    acting[:2][np.abs(acting[:2]) <= ROUNDING * force] = 0
    acting[2][np.abs(acting[2]) <= ROUNDING * max(np.abs(acting[2]).max(), length * force)] = 0
    for k, row in enumerate(rows):
        for part, values in zip(parts, acting[:, :, k]):
            lines.append([table["body"][row] if "body" in table else "body", part, *values])
    return html_table(["body", "", "load", "inside", "contact", "reaction", "sum"], lines)


def intensities(run: Run, step: Optional[int]) -> tuple[Optional[Table], str]:
    """Their table, and as HTML; why, where they cannot be found."""
    try:
        table = run.intensities(step)
    except EpafiError as error:
        return None, '<p class="warning">No stress intensities: %s</p>' % html.escape(str(error))
    return table, wide(html_table(list(table.columns), zip(*settled(table.columns).values())))


def versions(root: xml.Element) -> Iterable[tuple[str, str]]:
    for entry in root.findall("ParameterList[@name='Versions']/Parameter"):
        yield entry.get("name", ""), entry.get("value", "")


def figure(value: float) -> str:
    """Four digits, without a power of ten where that is short."""
    return "%.4g" % value if not 1e4 <= abs(value) < 1e7 else "%d" % float("%.4g" % value)


def key_results(pictures: Pictures, run: Run, step: Optional[int], fields: str,
                singular: Optional[Table]) -> str:
    """Contacts, then the largest stress."""
    numbers = {name: run.history[name][-1] for name in run.history}
    points = read(run.folder, "contact.csv")
    if step:
        here = (run.steps["level"] == run.steps["level"].max()) & (run.steps["step"] == step)
        numbers, points = {name: run.steps[name][here][0] for name in run.steps}, run.step(step)
    geometry = run.scene.get("Geometry", {})
    revolves = geometry.get("Type") == "Axisymmetric"
    found = list(Contacts(points, numbers, revolves, geometry.get("Symmetry")).results()) if points else []
    found.append(largest_stress(fields, pictures, singular))
    rows, last = [], ""
    for each in found:
        unit = re.sub(r"\^(\d)", r"<sup>\1</sup>", html.escape(pictures.looks.unit(
            each.quantity, revolves)).replace("\\$", "$"))
        value = "" if math.isnan(each.value) else "unlimited" if math.isinf(
            each.value) else "%s %s" % (figure(each.value), unit)
        rows.append("<tr><td>%s</td><td>%s</td><td>%s</td><td>%s</td></tr>" % (
            html.escape(each.where) if each.where != last else "", each.name, value,
            html.escape(each.remark)))
        last = each.where
    return '<table class="results">%s</table>' % "".join(rows)


def state(run: Run) -> str:
    """How a run ended, in a sentence."""
    last = {name: run.history[name][-1] for name in run.history}
    error = last["estimate_relative"]
    return "%s on %s, %s after %s%s." % (
        str(last["status"]).capitalize(), counted(int(last["elements"]), "element"),
        counted(int(last["dof"]), "unknown"), counted(run.history.size, "level"),
        "; estimated error %.2g %% of the energy norm" % (100 * error) if math.isfinite(error)
        and run.scene["Adaptivity"]["Weights"] != "Paper" else "")


def about(run: Run, command: str, used: xml.Element) -> str:
    """How to repeat it, when it was solved, and by what."""
    solved = datetime.datetime.fromtimestamp(os.path.getmtime(own(run.folder, "history.csv")))
    lines = [("solved", solved.strftime("%Y-%m-%d %H:%M")),
             ("solve it again", "epafi run %s" % shlex.quote(os.path.join(run.folder, "used.xml"))),
             ("this page", command), *versions(used)]
    return '<table class="results">%s</table>' % "".join(
        "<tr><td>%s</td><td>%s</td></tr>" % (html.escape(name), html.escape(value))
        for name, value in lines)


def write_report(file: str, pictures: Pictures, fields: str, warnings: Sequence[str],
                 command: str) -> None:
    """Of what is drawn in the folder already, scene.png included.  `fields`: the file that the inside
    is drawn of."""
    folder = pictures.folder
    if read(folder, "history.csv") is None:
        raise ValueError("there is no history.csv of a run")
    run, title = Run(folder), title_of(folder)
    used = xml.parse(own(folder, "used.xml")).getroot()
    step = pictures.step or shown_step(folder)
    outline = read(folder, "boundary.csv")
    length = extent(outline)
    singular, told = intensities(run, step)
    sections: dict[str, list[str]] = {}
    sections["Results"] = [key_results(pictures, run, step, fields, singular)]
    if run_steps := read(folder, "steps.csv"):
        sections["Results"].append("<p>Numbers and pictures are those at%s, step %d of %d%s.</p>" % (
            when(folder, step)[1:], step or run_steps["step"][-1], run_steps["step"][-1],
            ", of those that are solved where the strain energy is largest" if step and not pictures.step else ""))
    named = sorted(dict.fromkeys(pictures.names), key=lambda name: (
        list(SHOWN).index(name) if name in SHOWN else -1))
    sections["Pictures"] = [from_file(os.path.join(folder, name + ".png"), SHOWN.get(
        name, "Inside the bodies: %s." % FIELDS.get(name, name))) for name in named]
    movie = own(folder, "movie.gif")
    if os.path.isfile(movie):
        sections["Pictures"].append(from_file(movie, "The bodies as they move."))
    if singular is None or singular.size:
        sections["Stress intensities"] = [told]
    scene = own(folder, "scene.png")
    with open(os.path.join(folder, "used.xml"), encoding="utf-8") as stream:
        sections["Scene"] = [
            *([from_file(scene, "The scene as it is read.")] if os.path.isfile(scene) else []),
            "<details><summary>All parameters</summary><pre>%s</pre></details>" %
            html.escape(stream.read())]
    names = [name for name in HISTORY if name in run.history]
    history = settled(run.history.columns)
    sections["Levels"] = [wide(html_table(names, zip(*(history[name] for name in names))))]
    if run_steps:
        last = run_steps["level"] == run_steps["level"].max()
        names = [name for name in run_steps.columns if name.startswith(
            ("step", "t", "status", "energy_strain", "energy_dissipated")) or "." in name]
        rows = settled({name: run_steps[name][last] for name in names}, length)
        sections["Path"] = [wide(html_table(names, zip(*rows.values())))]
    sections["Balance"] = [balance(read(folder, "bodies.csv") or run.history, step, outline)]
    sections["About"] = [about(run, command, used)]
    parts = ["<h1>%s</h1>" % html.escape(title), "<p>%s</p>" % html.escape(state(run)),
             *('<p class="warning">%s</p>' % html.escape(warning)
               for warning in (*filter(None, [run.no_result]), *warnings)),
             "<nav>%s</nav>" % "".join('<a href="#%s">%s</a>' % (
                 name.replace(" ", "-").lower(), name) for name in sections)]
    for name, content in sections.items():
        parts += ['<h2 id="%s">%s</h2>' % (name.replace(" ", "-").lower(), name), *content]
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(PAGE % (html.escape(title), "\n".join(parts)))
