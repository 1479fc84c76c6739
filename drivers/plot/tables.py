"""The files of a run or a study as columns of numbers."""
import csv
import math
import os
import xml.etree.ElementTree as xml

import numpy as np


class Table:
    """A file of comma-separated values by columns; numbers where all cells are numbers."""

    def __init__(self, file):
        with open(file, newline="") as stream:
            rows = list(csv.DictReader(stream))
        self.size = len(rows)
        self.columns = {}
        for name in rows[0] if rows else ():
            cells = [row[name] or "" for row in rows]
            try:
                self.columns[name] = np.array([float(cell) if cell else math.nan
                                               for cell in cells])
            except ValueError:
                self.columns[name] = np.array(cells)

    def __getitem__(self, name):
        return self.columns[name]

    def __contains__(self, name):
        return name in self.columns

    def numbers(self, name):
        """A numeric column; NaN where the file has none."""
        column = self.columns.get(name)
        if column is None or column.dtype.kind != "f":
            return np.full(self.size, math.nan)
        return column


def read(folder, name):
    """The table of a file, or None without the file or without rows in it."""
    file = os.path.join(folder, name)
    if not os.path.isfile(file):
        return None
    table = Table(file)
    return table if table.size else None


def title_of(folder):
    """The scene's title from used.xml, else the folder's name."""
    try:
        return xml.parse(os.path.join(folder, "used.xml")).getroot().get("name")
    except (OSError, xml.ParseError):
        return os.path.basename(os.path.abspath(folder))
