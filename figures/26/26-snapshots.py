#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments of a run as text: the spheres, and the solids fraction averaged over the depth.

    26-snapshots.py DIR FROM POINTS FIELD

Writes x and y of the spheres [mm] to POINTS, and x, y [mm], eps_s of the cells to FIELD,
a block for each picture of DIR from the time FROM [s] on. Debian: apt-get install
python3-vtk9
"""
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader, vtkXMLRectilinearGridReader


def opened(reader, path):
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def spheres(path, out):
    data = opened(vtkXMLPolyDataReader(), path)
    for x, y, _ in 1e3 * vtk_to_numpy(data.GetPoints().GetData()):
        print(f"{x:.2f} {y:.2f}", file=out)


def field(path, out):
    data = opened(vtkXMLRectilinearGridReader(), path)
    x, y, z = (vtk_to_numpy(c) for c in (
        data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates()))
    eps = vtk_to_numpy(data.GetCellData().GetArray("void_fraction"))
    eps_s = 1 - eps.reshape(len(z) - 1, len(y) - 1, len(x) - 1).mean(axis=0)
    for j in range(len(y) - 1):
        for i in range(len(x) - 1):
            print(f"{500 * (x[i] + x[i + 1]):.3f} {500 * (y[j] + y[j + 1]):.3f} "
                  f"{eps_s[j, i]:.4f}", file=out)
        print(file=out)


def time(path):
    data = opened(vtkXMLPolyDataReader(), path)
    return vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]


run, begin, points, cells = sys.argv[1:]
with open(points, "w", encoding="ascii") as dots, open(cells, "w", encoding="ascii") as grid:
    for path in sorted(Path(run, "particles").glob("*.vtp")):
        if time(path) < float(begin) - 1e-9:
            continue
        spheres(path, dots)
        field(Path(run, "fluid", path.name.replace("particles", "fluid")
                   .replace(".vtp", ".vtr")), grid)
        print("\n", file=dots)
        print(file=grid)
