"""The files of a run or a study as columns of numbers."""
from __future__ import annotations

import csv
import difflib
import html
import math
import os
import xml.etree.ElementTree as xml
from itertools import zip_longest
from typing import TYPE_CHECKING, Any, Container, Iterable, Iterator, Mapping, Optional, Sequence

import numpy as np

from epafi.program import InputError

if TYPE_CHECKING:
    import pandas

# Columns of names and words, also where all of these look like numbers.
TEXTS = {"boundary", "body", "contact_name", "folder", "operators", "reason", "scene", "status",
         "variant"}


# Strain energies of steps that differ by less are those of one load, to and fro.
EQUAL = 1e-6

# What a reader of a level looks at first.
HISTORY = ("level", "dof", "estimate", "estimate_relative", "force_normal", "force_tangential", "contact_length",
           "slip_length", "energy_strain", "status")


class Table:
    """A file of comma-separated values by columns, arrays of shape (size,): texts in columns of
    names (TEXTS), else numbers where all cells are numbers or empty (NaN), else texts."""

    columns: dict[str, np.ndarray]
    size: int  # rows

    def __init__(self, file: str, only: Optional[Container[str]] = None) -> None:
        """`only`: of these columns."""
        with open(file, newline="") as stream:
            names, *rows = list(csv.reader(stream)) or [[]]
        self.size = len(rows)
        self.columns = {}
        for name, cells in zip(names, zip_longest(*rows, fillvalue="")):
            if only is not None and name not in only:
                continue
            try:
                self.columns[name] = np.array(cells if name in TEXTS else [
                    float(cell) if cell else math.nan for cell in cells])
            except ValueError:
                self.columns[name] = np.array(cells)

    @classmethod
    def of(cls, columns: Mapping[str, np.ndarray]) -> Table:
        """Of columns that are no file."""
        table = cls.__new__(cls)
        table.columns = dict(columns)
        table.size = len(next(iter(table.columns.values())))
        return table

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.columns:
            raise unknown_column(name, self.columns)
        return self.columns[name]

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return self.size

    def keys(self) -> Iterable[str]:
        """The names of the columns: dict(table) has all of them."""
        return self.columns.keys()

    def __repr__(self) -> str:
        return "Table of %d rows: %s" % (self.size, ", ".join(self.columns))

    def frame(self) -> pandas.DataFrame:
        """The same as a frame of pandas, which has to be installed."""
        return frame_of(self.columns)

    def numbers(self, name: str) -> np.ndarray:
        """A numeric column; NaN where the file has none."""
        column = self.columns.get(name)
        if column is None or column.dtype.kind != "f":
            return np.full(self.size, math.nan)
        return column


def nearest(name: str, known: Iterable[str]) -> str:
    """The end of a sentence about a name that is not known."""
    near = isinstance(name, str) and difflib.get_close_matches(name, known, 1, 0)
    return "; did you mean %r?" % near[0] if near else ""


def unknown_column(name: str, known: Iterable[str]) -> KeyError:
    return KeyError("there is no column %r%s; columns: %s" % (
        name, nearest(name, known), ", ".join(known)))


def frame_of(columns: Mapping[str, Any]) -> pandas.DataFrame:
    import pandas

    return pandas.DataFrame(dict(columns))


def cell_text(value: Any) -> str:
    return "%.6g" % value if isinstance(value, (float, np.floating)) else str(value)


def text_table(names: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """Columns to the right, wide enough for their cells."""
    lines = [list(names), *([cell_text(value) for value in row] for row in rows)]
    widths = [max(map(len, column)) for column in zip(*lines)]
    return "\n".join("  ".join(cell.rjust(width) for cell, width in zip(line, widths)).rstrip()
                     for line in lines)


def html_table(names: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    def line(cells: Iterable[str], tag: str) -> str:
        return "<tr>%s</tr>" % "".join("<%s>%s</%s>" % (tag, html.escape(cell), tag)
                                       for cell in cells)

    return "<table>%s</table>" % "".join([line(names, "th"), *(line(
        ["" if isinstance(value, (float, np.floating)) and math.isnan(value) else cell_text(value)
         for value in row], "td") for row in rows)])


def counted(count: int, word: str) -> str:
    """1 level, 2 levels."""
    return "%d %s%s" % (count, word, "s" * (count != 1))


def own(folder: str, name: str) -> str:
    """The path of a file in a folder, which may be from somebody else.

    InputError where the name or a link leads out of it.
    """
    file, root = os.path.join(folder, name), os.path.realpath(folder)
    real = os.path.realpath(file)
    if os.path.commonpath([root, real]) != root:
        raise InputError("'%s' leads out of its folder, to '%s'; what is drawn and written is in the "
                         "folder itself" % (file, real))
    return file


def read(folder: str, name: str, only: Optional[Container[str]] = None) -> Optional[Table]:
    """The table of a file, of all columns or of some, or None without the file or without rows.

    ValueError for a file that is no table.
    """
    file = own(folder, name)
    if not os.path.isfile(file):
        return None
    try:
        table = Table(file, only)
        with open(file) as stream:
            if "," not in stream.readline():
                raise ValueError("it has no heading")
    except (ValueError, csv.Error) as error:
        raise ValueError("'%s' cannot be read: %s" % (name, error)) from error
    return table if table.size else None


def shown_step(folder: str) -> Optional[int]:
    """The step of a path that pictures show: of those that are solved that of the largest strain energy, of
    equal ones the last.  None: the last step, or there is no path."""
    steps = read(folder, "steps.csv")
    if not steps:
        return None
    here = steps["level"] == steps["level"].max()
    energy = np.where(steps["status"] == "converged", steps["energy_strain"], 0)[here]
    if not energy.max() > 0:
        return None
    most = np.flatnonzero(energy > (1 - EQUAL) * energy.max())[-1]
    step = int(steps["step"][here][most])
    written = os.path.isfile(own(folder, os.path.join("steps", str(step), "boundary.vtu")))
    return step if written and most + 1 < len(energy) else None


def title_of(folder: str) -> str:
    """The scene's title from used.xml, else the folder's name."""
    root = used_of(folder)
    name = None if root is None else root.get("name")
    return name or os.path.basename(os.path.abspath(folder))


def used_of(folder: str) -> Optional[xml.Element]:
    """used.xml of a run, if it can be read."""
    try:
        return xml.parse(own(folder, "used.xml")).getroot()
    except (OSError, xml.ParseError):
        return None
