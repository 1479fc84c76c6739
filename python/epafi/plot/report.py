"""A run as one page of HTML: scene, numbers, balance, pictures, warnings, versions."""
from __future__ import annotations

import base64
import html
import io
import os
import xml.etree.ElementTree as xml
from typing import Any, Iterable, Sequence

import numpy as np
from matplotlib.figure import Figure

from epafi.plot.figures import Pictures, plt
from epafi.program import EpafiError
from epafi.runs import Run
from epafi.tables import HISTORY, Table, html_table, own, read, title_of

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>%s</title><style>
body { font-family: sans-serif; max-width: 72em; margin: 2em auto; padding: 0 1em; }
table { border-collapse: collapse; font-size: 85%%; margin: 1em 0; }
th, td { padding: 0.2em 0.7em; text-align: right; border-bottom: 1px solid #ccc; }
td:first-child, th:first-child { text-align: left; }
img { max-width: 100%%; display: block; margin: 1.5em 0; }
pre { background: #f6f6f4; padding: 1em; overflow-x: auto; }
.warning { border-left: 0.4em solid #D55E00; padding-left: 0.8em; }
</style></head><body>
%s
</body></html>
"""
SHARES = ("load", "body_force", "contact", "reaction")
ORDER = ("contact", "deformed", "path", "rigid", "steps", "convergence", "contributions", "mesh",
         "time")


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
        return image(stream.read(), file[-3:], text)


def balance(table: Table) -> str:
    """What acts on each body, or on the one there is, in the last row or rows; the sum is what is
    left of equilibrium."""
    last = np.flatnonzero(table["level"] == table["level"].max())
    if "step" in table:
        last = last[table["step"][last] == table["step"][last].max()]
    rows = []
    for row in last:
        name = table["body"][row] if "body" in table else "body"
        for part in ("x", "y", "moment"):
            shares = [np.nan_to_num(table.numbers(share + "_" + part)[row]) for share in SHARES]
            rows.append([name, part, *shares, sum(shares)])
    return html_table(["body", "", "load", "inside", "contact", "reaction", "sum"], rows)


def intensities(folder: str) -> list[str]:
    """Nothing where no stress is singular; why, where they cannot be found."""
    try:
        table = Run(folder).intensities()
    except EpafiError as error:
        return ['<p class="warning">No stress intensities: %s</p>' % html.escape(str(error))]
    return ["<h2>Stress intensities</h2>", html_table(
        list(table.columns), zip(*table.columns.values()))] if table.size else []


def versions(root: xml.Element) -> Iterable[Sequence[str]]:
    for entry in root.findall("ParameterList[@name='Versions']/Parameter"):
        yield entry.get("name", ""), entry.get("value", "")


def write_report(file: str, pictures: Pictures, warnings: Sequence[str]) -> None:
    """Of what is drawn in the folder already, scene.png included."""
    folder = pictures.folder
    history = read(folder, "history.csv")
    if history is None:
        raise ValueError("there is no history.csv of a run")
    used = xml.parse(own(folder, "used.xml")).getroot()
    title = title_of(folder)

    def section(name: str, *content: Any) -> list[str]:
        return ["<h2>%s</h2>" % name, *content]

    status = str(history["status"][-1])
    parts = ["<h1>%s</h1>" % html.escape(title), "<p>%d levels, the last one %s.</p>" % (
        history.size, html.escape(status))]
    parts += ['<p class="warning">%s</p>' % html.escape(warning) for warning in (
        *filter(None, [Run(folder).no_result]), *warnings)]
    scene = own(folder, "scene.png")
    parts += section("Scene", *([from_file(scene, "the scene")] if os.path.isfile(scene) else []))
    with open(os.path.join(folder, "used.xml"), encoding="utf-8") as stream:
        parts.append("<details><summary>All parameters</summary><pre>%s</pre></details>" %
                     html.escape(stream.read()))
    names = [name for name in HISTORY if name in history]
    parts += section("Numbers", html_table(names, zip(*(history[name] for name in names))))
    if "pressure_max" in history and history["pressure_max"][-1] > 0:
        parts.append("<p>Contact pressure up to %.4g where elements resolve it, with an error of %.2g%s."
                     "</p>" % (history["pressure_max"][-1], history["pressure_max_error"][-1],
                               "; unbounded at an end of a side" * bool(
                                   history["pressure_unbounded"][-1])))
    steps = read(folder, "steps.csv")
    if steps:
        last = steps["level"] == steps["level"].max()
        names = [name for name in steps.columns if name.startswith(
            ("step", "t", "status", "energy_strain", "energy_dissipated")) or "." in name]
        parts.append('<div style="overflow-x: auto">%s</div>' % html_table(
            names, zip(*(steps[name][last] for name in names))))
    parts += section("Balance", balance(read(folder, "bodies.csv") or history))
    parts += intensities(folder)
    order = {name: k for k, name in enumerate(ORDER)}
    parts += section("Pictures", *(
        from_file(os.path.join(folder, name + ".png"), name) for name in sorted(
            dict.fromkeys(pictures.names), key=lambda name: order.get(name, -1))))
    movie = own(folder, "movie.gif")
    if os.path.isfile(movie):
        parts.append(from_file(movie, "movie"))
    parts += section("Versions", html_table(["", "version"], versions(used)))
    with open(file, "w", encoding="utf-8") as stream:
        stream.write(PAGE % (html.escape(title), "\n".join(parts)))
