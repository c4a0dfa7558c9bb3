#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whether spheres at the front of the spouted bed are as fast as those behind them.

    27-front.py FOLDER FROM

Reads the spheres of a run of cases/spouted-bed.cfg at all times written from FROM [s] on.
Prints, at six heights, the mean vertical velocity [m/s] in the middle 8 mm of the spout:
of spheres that touch the front or back, of the middle quarter of the depth, and of all.
"""
import sys
import xml.etree.ElementTree as xml

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

DEPTH, DIAMETER = 0.04, 0.0025  # m


def frames(folder, since):
    """Positions and velocities of all spheres, time after time."""
    for one in xml.parse(f"{folder}/particles.pvd").iter("DataSet"):
        if float(one.get("timestep")) >= since:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(f"{folder}/{one.get('file')}")
            reader.Update()
            data = reader.GetOutput()
            yield (vtk_to_numpy(data.GetPoints().GetData()),
                   vtk_to_numpy(data.GetPointData().GetArray("velocity")))


def main(folder, since):
    found = list(frames(folder, float(since)))
    position, velocity = (numpy.concatenate(part) for part in zip(*found))
    x, y, z = position.T
    off = abs(z - DEPTH / 2)
    print(f"# {len(found)} times; height [mm]; spheres and their velocity [m/s]: at front and "
          "back, in the middle, all")
    for height in (0.03, 0.06, 0.09, 0.12, 0.15, 0.16):
        spout = (abs(x - 0.14) < 0.004) & (abs(y - height) < 0.004)
        row = f"{1000 * height:4.0f}"
        for layer in (off > DEPTH / 2 - DIAMETER, off < DEPTH / 8, off < DEPTH):
            some = velocity[spout & layer, 1]
            row += f"  {len(some):5d} {some.mean():5.2f}"
        print(row)


if __name__ == "__main__":
    main(*sys.argv[1:])
