"""The files of a run or a study as columns of numbers."""
import csv
import math
import os
import xml.etree.ElementTree as xml
from typing import Optional

import numpy as np


# Columns of names and words, also where all of these look like numbers.
TEXTS = {"boundary", "body", "contact_name", "folder", "operators", "reason", "scene", "status",
         "variant"}


class Table:
    """A file of comma-separated values by columns, arrays of shape (size,): texts in columns of
    names (TEXTS), else numbers where all cells are numbers or empty (NaN), else texts."""

    columns: dict[str, np.ndarray]
    size: int  # rows

    def __init__(self, file: str) -> None:
        with open(file, newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.size = len(rows)
        self.columns = {}
        for name in rows[0] if rows else ():
            cells = [row[name] or "" for row in rows]
            try:
                self.columns[name] = np.array(cells if name in TEXTS else [
                    float(cell) if cell else math.nan for cell in cells])
            except ValueError:
                self.columns[name] = np.array(cells)

    def __getitem__(self, name: str) -> np.ndarray:
        return self.columns[name]

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __repr__(self) -> str:
        return "Table of %d rows: %s" % (self.size, ", ".join(self.columns))

    def numbers(self, name: str) -> np.ndarray:
        """A numeric column; NaN where the file has none."""
        column = self.columns.get(name)
        if column is None or column.dtype.kind != "f":
            return np.full(self.size, math.nan)
        return column


def read(folder: str, name: str) -> Optional[Table]:
    """The table of a file, or None without the file or without rows in it."""
    file = os.path.join(folder, name)
    if not os.path.isfile(file):
        return None
    table = Table(file)
    return table if table.size else None


def title_of(folder: str) -> str:
    """The scene's title from used.xml, else the folder's name."""
    try:
        name = xml.parse(os.path.join(folder, "used.xml")).getroot().get("name")
    except (OSError, xml.ParseError):
        name = None
    return name or os.path.basename(os.path.abspath(folder))
