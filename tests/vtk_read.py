"""vtk_read.py FOLDER...: opens the snapshots that the collections (.pvd) of each folder list with VTK's own
reader and prints, a line a file: name, time, points, cells, and the range of every array's first component.
Exit status 1 if anything is wrong: the reader keeps silent about broken files but for ErrorEvents and counts."""
import os
import sys
import xml.etree.ElementTree as tree

from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

wrong = []


def complain(path, what):
    wrong.append(path)
    print("WRONG", path, what)


def arrays(data, tuples, path):
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        if array.GetNumberOfTuples() != tuples:
            complain(path, "%s has %d tuples, not %d" % (array.GetName(), array.GetNumberOfTuples(), tuples))
        low, high = array.GetRange(0)
        yield "%s[%d]=%.9g..%.9g" % (array.GetName(), array.GetNumberOfComponents(), low, high)


def read(path, t):
    piece = tree.parse(path).getroot().find("PolyData/Piece").attrib
    errors = []
    reader = vtkXMLPolyDataReader()
    reader.AddObserver("ErrorEvent", lambda *_: errors.append(1))
    reader.AddObserver("WarningEvent", lambda *_: errors.append(1))
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    points, cells = data.GetNumberOfPoints(), data.GetNumberOfCells()
    if errors:
        complain(path, "reader reports an error")
    if points != int(piece["NumberOfPoints"]) or cells != int(piece["NumberOfVerts"]) + int(piece["NumberOfPolys"]):
        complain(path, "%d points and %d cells came" % (points, cells))
    for k in range(cells):
        if data.GetNumberOfPolys() and data.GetCell(k).GetNumberOfPoints() < 3:
            complain(path, "polygon %d is none" % k)
    time = data.GetFieldData().GetArray("TimeValue").GetValue(0)
    if abs(time - t) > 1e-12 * max(1, abs(t)):
        complain(path, "time %g, the collection says %g" % (time, t))
    found = list(arrays(data.GetPointData(), points, path)) + list(arrays(data.GetCellData(), cells, path))
    print(os.path.basename(path), "t=%.9g points=%d cells=%d" % (t, points, cells), *found)


for folder in sys.argv[1:]:
    for kind in ("particles", "nodes", "cells"):
        collection = os.path.join(folder, kind + ".pvd")
        if os.path.exists(collection):
            for entry in tree.parse(collection).getroot().iter("DataSet"):
                read(os.path.join(folder, entry.get("file")), float(entry.get("timestep")))
sys.exit(1 if wrong else 0)
