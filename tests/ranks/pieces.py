# SPDX-License-Identifier: GPL-3.0-or-later
# Reads the last files of two series with the real VTK readers and compares them.
#
#   python3 pieces.py A B      folders of two runs of one case
#
# Cells are compared in their order, particles by their ids. Says how many there
# are, and the largest difference over the largest value of each array.
import os
import re
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
import vtkmodules.vtkIOXML as xml

READERS = {".vtr": xml.vtkXMLRectilinearGridReader, ".pvtr": xml.vtkXMLPRectilinearGridReader,
           ".vtp": xml.vtkXMLPolyDataReader, ".pvtp": xml.vtkXMLPPolyDataReader}


def last(folder, series):
    """The arrays of the last file that the collection lists, and the box or the centres."""
    text = open(os.path.join(folder, series + ".pvd")).read()
    name = os.path.join(folder, re.findall(r'file="([^"]+)"', text)[-1])
    reader = READERS[os.path.splitext(name)[1]]()
    failures = []
    reader.AddObserver("ErrorEvent", lambda *_: failures.append(name))
    reader.SetFileName(name)
    reader.Update()
    data = reader.GetOutput()
    if failures:
        sys.exit(name + " cannot be read")
    if series == "fluid":
        place = data.GetCellData()
        found = {"box": numpy.array(data.GetBounds()), "cells": numpy.array(data.GetDimensions())}
    else:
        place = data.GetPointData()
        found = {"position": vtk_to_numpy(data.GetPoints().GetData())}
    for i in range(place.GetNumberOfArrays()):
        array = place.GetArray(i)
        if not array.GetName().startswith("vtkGhost"):
            found[array.GetName()] = vtk_to_numpy(array)
    if "id" in found:
        order = numpy.argsort(found["id"])
        found = {key: value[order] for key, value in found.items()}
    return found


worst = 0.0
for series in ("fluid", "particles"):
    a, b = last(sys.argv[1], series), last(sys.argv[2], series)
    if sorted(a) != sorted(b):
        sys.exit("%s: other arrays: %s and %s" % (series, sorted(a), sorted(b)))
    for key in a:
        if a[key].shape != b[key].shape:
            sys.exit("%s: %s and %s of %s" % (series, a[key].shape, b[key].shape, key))
        scale = numpy.abs(a[key]).max() or 1.0
        off = numpy.abs(a[key].astype(float) - b[key]).max() / scale
        worst = max(worst, off)
        print(series, key, a[key].shape, "%.1e" % off)
# Float32 has seven digits
sys.exit(0 if worst < 1e-6 else 1)
