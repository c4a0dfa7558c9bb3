#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments of a run as text: the spheres, and the solids fraction averaged over the depth.

    26-snapshots.py DIR FROM POINTS FIELD [DEPTH]

Writes x and y of the spheres [mm] to POINTS, and x, y [mm], eps_s of the cells to FIELD,
a block for each picture of DIR from the time FROM [s] on. With DEPTH [m], it is the spheres
that the plane half-way through the depth cuts, which are not further from it than DEPTH,
and the upward velocity of the fluid [m/s] in that plane. Debian: apt-get install
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


def spheres(path, middle, out):
    data = opened(vtkXMLPolyDataReader(), path)
    for x, y, z in vtk_to_numpy(data.GetPoints().GetData()):
        if depth is None or abs(z - middle) <= depth:
            print(f"{1e3 * x:.2f} {1e3 * y:.2f}", file=out)


def field(path, out):
    """Returns the middle of the depth."""
    data = opened(vtkXMLRectilinearGridReader(), path)
    x, y, z = (vtk_to_numpy(c) for c in (
        data.GetXCoordinates(), data.GetYCoordinates(), data.GetZCoordinates()))
    shape = len(z) - 1, len(y) - 1, len(x) - 1
    if depth is None:
        eps = vtk_to_numpy(data.GetCellData().GetArray("void_fraction"))
        of = 1 - eps.reshape(shape).mean(axis=0)
    else: # the one layer, or the two layers, beside the plane
        u = vtk_to_numpy(data.GetCellData().GetArray("velocity"))[:, 1].reshape(shape)
        of = (u[(len(z) - 2) // 2] + u[(len(z) - 1) // 2]) / 2
    for j in range(len(y) - 1):
        for i in range(len(x) - 1):
            print(f"{500 * (x[i] + x[i + 1]):.3f} {500 * (y[j] + y[j + 1]):.3f} "
                  f"{of[j, i]:.4f}", file=out)
        print(file=out)
    return (z[0] + z[-1]) / 2


def time(path):
    data = opened(vtkXMLPolyDataReader(), path)
    return vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]


run, begin, points, cells = sys.argv[1:5]
depth = float(sys.argv[5]) if len(sys.argv) > 5 else None
with open(points, "w", encoding="ascii") as dots, open(cells, "w", encoding="ascii") as grid:
    for path in sorted(Path(run, "particles").glob("*.vtp")):
        if time(path) < float(begin) - 1e-9:
            continue
        middle = field(Path(run, "fluid", path.name.replace("particles", "fluid")
                            .replace(".vtp", ".vtr")), grid)
        spheres(path, middle, dots)
        print("\n", file=dots)
        print(file=grid)
