"""solution.hdf as h5py reads it: the structure that ParaView 5.11 wants, and the same numbers
as in the other files."""
import csv
import math
import os

import h5py
import numpy

from runs import WORK, claim, finish, run, scene, table


def read(name, settings):
    """Solves; the file, its VTKHDF group and the folder."""
    run(scene("tresca.xml"), name, settings)
    folder = os.path.join(WORK, name)
    file = h5py.File(os.path.join(folder, "solution.hdf"), "r")
    return file, file["VTKHDF"], folder


def text(folder, name):
    with open(os.path.join(folder, name)) as stream:
        return stream.read()


def check_structure(name, vtk, degrees):
    kind = vtk.attrs.get_id("Type").get_type()
    claim(kind.get_class() == h5py.h5t.STRING and not kind.is_variable_str() and
          kind.get_cset() == h5py.h5t.CSET_ASCII and
          vtk.attrs["Type"] == b"UnstructuredGrid",
          name + ": Type is a fixed-length ASCII string")
    claim(list(vtk.attrs["Version"]) == [1, 0] and
          numpy.issubdtype(vtk.attrs["Version"].dtype, numpy.integer), name + ": version 1.0")
    claim(set(vtk) == {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Points",
                       "Connectivity", "Offsets", "Types", "PointData", "CellData"},
          name + ": what an UnstructuredGrid has, no Steps")
    points, cells, ids = (vtk["NumberOf" + what][:] for what in
                          ("Points", "Cells", "ConnectivityIds"))
    claim(len(points) == len(cells) == len(ids) == 1, name + ": one part")
    lines = 2 * (numpy.array(degrees) + 1)
    claim(cells[0] == lines.sum() and points[0] == (lines + 1).sum() and
          ids[0] == 2 * cells[0], name + ": 2(p+1) lines per element of degree p")
    claim(vtk["Points"].shape == (points[0], 3) and vtk["Connectivity"].shape == (ids[0],),
          name + ": all points and ends are there")
    claim(numpy.array_equal(vtk["Offsets"][:], 2 * numpy.arange(cells[0] + 1)),
          name + ": two ends per line")
    claim(vtk["Types"].dtype == numpy.uint8 and set(vtk["Types"][:]) == {3},
          name + ": all cells are lines")
    for group, size in (("PointData", points[0]), ("CellData", cells[0])):
        claim(all(len(data) == size for data in vtk[group].values()),
              "%s: %s has one row each: %s" % (name, group, " ".join(vtk[group])))
    ends = vtk["Points"][:][vtk["Connectivity"][:].reshape(-1, 2)]
    length = numpy.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    claim(abs(length.sum() - 4) < 1e-12 and length.min() > 0,
          name + ": the lines are as long as the outline")
    claim(numpy.abs(ends[1:, 0] - ends[:-1, 1]).max() < 1e-15, name + ": and follow each other")
    claim(numpy.array_equal(numpy.repeat(degrees, lines), vtk["CellData/degree"][:]),
          name + ": lines know their element's degree")


def check_numbers(name, file, vtk, folder):
    epafi = file["Epafi"]
    boundary = table(os.path.join(folder, "boundary.csv"))
    fields = {"Points": ("x", "y"), "PointData/displacement": ("ux", "uy"),
              "PointData/traction": ("tx", "ty")}
    for data, columns in fields.items():
        values = numpy.array([[row[column] for column in columns] + [0] for row in boundary])
        claim(numpy.array_equal(vtk[data][:], values), name + ": " + data +
              " as in boundary.csv")
    names = epafi["boundaries"][()].decode().splitlines()
    where = numpy.array([names[k] for k in vtk["CellData/boundary"][:]])
    sides = sorted({row["boundary"] for row in table(os.path.join(folder, "contact.csv"))})
    touches = numpy.zeros(len(vtk["Points"]), bool)
    touches[vtk["Connectivity"][:].reshape(-1, 2)[numpy.isin(where, sides)].ravel()] = True
    for data in ("lambda_n", "lambda_t", "gap"):
        claim(numpy.array_equal(numpy.isfinite(vtk["PointData"][data][:]), touches),
              name + ": %s on the contact boundary only" % data)
    for data in ("contact", "friction"):
        claim(numpy.array_equal(vtk["PointData"][data][:] >= 0, touches),
              name + ": %s on the contact boundary only" % data)
    numbers, columns = (list(csv.reader(lines.splitlines())) for lines in (
        text(folder, "history.csv"), epafi["history_columns"][()].decode()))
    claim(epafi["used"][()].decode() == text(folder, "used.xml") and
          columns[0] == numbers[0] and len(columns[1]) == len(columns[2]) == len(columns[0]) and
          all(float(cell) == number if kind != "word" else cell == columns[3][int(number)]
              for cells, row in zip(numbers[1:], epafi["history"][()])
              for kind, cell, number in zip(columns[1], cells, row)) and
          epafi["history"].shape == (len(numbers) - 1, len(columns[0])),
          name + ": used.xml and history.csv are inside")
    row = table(os.path.join(folder, "history.csv"))[-1]
    claim(epafi.attrs["level"] == row["level"] and epafi.attrs["format"] == 10 and
          len(epafi["multiplier"]) == row["dof_multiplier"] and
          len(epafi["edge"]) == row["elements"], name + ": /Epafi is the last level")
    claim(abs(math.sqrt(epafi["indicators"][:].sum()) - row["estimate"]) <
          1e-14 * row["estimate"], name + ": the indicators add up to the estimate")


HP = ["Adaptivity->Strategy=Adaptive hp", "Adaptivity->Maximum Levels=8"]
file, vtk, folder = read("hp", HP)
degrees = file["Epafi/degree"][:]
claim(degrees.max() > degrees.min(), "hp: degrees differ")
check_structure("hp", vtk, degrees)
check_numbers("hp", file, vtk, folder)

# with p + 1 samples every second point of the grid is one of contact.csv
file, vtk, folder = read("p", ["Adaptivity->Strategy=None", "Discretization->Degree=4",
                               "Output->Contact Samples per Element=5"])
check_structure("p", vtk, file["Epafi/degree"][:])
check_numbers("p", file, vtk, folder)
contact = table(os.path.join(folder, "contact.csv"))
on = numpy.flatnonzero(vtk["PointData/contact"][:] >= 0).reshape(-1, 11)[:, 1::2].ravel()
claim(len(on) == len(contact), "p: as many points as contact.csv")
for column in ("lambda_n", "lambda_t", "gap", "contact", "friction"):
    values = numpy.array([point[column] for point in contact])
    claim(numpy.abs(vtk["PointData"][column][:][on] - values).max() <=
          1e-13 * max(1e-300, numpy.abs(values).max()), "p: %s as in contact.csv" % column)
states = file["Epafi"]
claim(set(states["contact_state"][:]) <= {0, 1} and set(states["friction_state"][:]) <=
      {0, 1, 2, 3} and len(states["contact_state"]) + len(states["friction_state"]) ==
      len(states["multiplier"]), "p: a state for each coefficient")
finish()
