#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Mean heights of the size classes of cases/seepage.cfg, from its pictures.

    20-classes.py out/seepage

Small, medium and large as in XS11 Fig. 11: d below 0.83, 1.67, 2.5 mm.
"""
import sys
from pathlib import Path

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

print("# t [s], mean height of small, medium, large [mm], small over large")
for path in sorted(Path(sys.argv[1], "particles").glob("*.vtp")):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    y = 1e3 * vtk_to_numpy(data.GetPoints().GetData())[:, 1]
    d = 1e3 * vtk_to_numpy(data.GetPointData().GetArray("diameter"))
    time = vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]
    small, large = y[d < 0.83].mean(), y[d >= 1.67].mean()
    medium = y[(d >= 0.83) & (d < 1.67)].mean()
    print(f"{time:.1f} {small:7.3f} {medium:7.3f} {large:7.3f} "
          f"{small / large:6.3f}")
