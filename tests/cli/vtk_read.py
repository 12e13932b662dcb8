"""vtk_read.py FOLDER [CSV]: opens the snapshots that the collections (.pvd) of a folder list with VTK's own
reader and prints, a line a file: name, time, points, cells, and the range of every array's first component.
With CSV, what --particles wrote at the same end, the last particles must have just these numbers. Exit
status 1 if anything is wrong; the reader itself keeps silent about much that is."""
import csv
import os
import sys
import xml.etree.ElementTree as tree

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

wrong = []


def complain(path, what):
    wrong.append(path)
    print("WRONG", os.path.basename(path), what)


def check_arrays(data, tuples, path):
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if array.GetNumberOfTuples() != tuples:
            complain(path, "%s has %d tuples, not %d" % (array.GetName(), array.GetNumberOfTuples(), tuples))
        low, high = array.GetRange(0)
        yield "%s[%d]=%.9g..%.9g" % (array.GetName(), array.GetNumberOfComponents(), low, high)


def read(path, t):
    try:
        piece = tree.parse(path).getroot().find("PolyData/Piece").attrib
    except (OSError, tree.ParseError) as error:
        return complain(path, error)
    errors = []
    reader = vtkXMLPolyDataReader()
    for event in ("ErrorEvent", "WarningEvent"):
        reader.AddObserver(event, lambda *_: errors.append(1))
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    points, cells = data.GetNumberOfPoints(), data.GetNumberOfCells()
    if errors:
        complain(path, "the reader reports an error")
    if points != int(piece["NumberOfPoints"]) or cells != int(piece["NumberOfVerts"]) + int(piece["NumberOfPolys"]):
        complain(path, "%d points and %d cells came" % (points, cells))
    if any(data.GetCell(k).GetNumberOfPoints() < 3 for k in range(data.GetNumberOfPolys())):
        complain(path, "a polygon of less than three points")
    time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
    if abs(time - t) > 1e-12 * max(1, abs(t)):
        complain(path, "time %g, the collection says %g" % (time, t))
    found = list(check_arrays(data.GetPointData(), points, path)) + list(check_arrays(data.GetCellData(), cells, path))
    print(os.path.basename(path), "t=%.9g points=%d cells=%d" % (t, points, cells), *found)
    return data


COLUMNS = {"x": ("", 0), "y": ("", 1), "X": ("X", 0), "vx": ("v", 0), "vy": ("v", 1), "Fxx": ("F", 0), "Fxy": ("F", 1),
           "Fyx": ("F", 3), "Fyy": ("F", 4), "sxx": ("stress", 0), "sxy": ("stress", 1), "syy": ("stress", 4),
           "szz": ("stress", 8), "von_mises": ("von_mises", 0), "mass": ("mass", 0), "surface": ("surface", 0),
           "id": ("id", 0), "energy": ("energy", 0)}


def compare(data, path):
    rows = list(csv.DictReader(open(path)))
    if len(rows) != data.GetNumberOfPoints():
        return complain(path, "%d rows, %d points" % (len(rows), data.GetNumberOfPoints()))
    for column, (name, k) in COLUMNS.items():
        array = data.GetPointData().GetArray(name) if name else data.GetPoints().GetData()
        values = [row[column] for row in rows]
        if not any(values):  # a direction that the scene does not have
            continue
        if any(value == "" or array.GetComponent(i, k) != float(value) for i, value in enumerate(values)):
            complain(path, "%s differs" % column)
    u, X = data.GetPointData().GetArray("displacement"), data.GetPointData().GetArray("X")
    for i in range(len(rows)):
        if any(u.GetComponent(i, d) != data.GetPoint(i)[d] - X.GetComponent(i, d) for d in range(3)):
            return complain(path, "u is not x - X")


folder = sys.argv[1]
for kind in ("nodes", "cells", "particles"):
    collection = os.path.join(folder, kind + ".pvd")
    if os.path.exists(collection):
        for entry in tree.parse(collection).getroot().iter("DataSet"):
            last = read(os.path.join(folder, entry.get("file")), float(entry.get("timestep")))
if len(sys.argv) > 2 and last:
    compare(last, sys.argv[2])
sys.exit(1 if wrong else 0)
