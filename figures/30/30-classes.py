#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The size classes of cases/seepage.cfg, from the pictures of its runs.

    30-classes.py heights DIR           mean height of each class at each time
    30-classes.py scene DIR SHIFT       a case that begins with the first picture of
                                        DIR, its grains SHIFT [m] beside
    30-classes.py compare A B C         the classes in three runs from one bed
    30-classes.py circles DIR           x, y, radius [mm], class 0 to 2, of each picture

Small, medium and large as in XS11 Fig. 11: d below 0.83, 1.67, 2.5 mm.
"""
import csv
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

CLASSES = {"small": (0, 0.83e-3), "medium": (0.83e-3, 1.67e-3), "large": (1.67e-3, 1)}
BOX = (0.040, 0.200, 0.0075)


def pictures(run):
    return sorted(Path(run, "particles").glob("*.vtp"))


def picture(path):
    """Time [s], and by the grains' numbers their positions and diameters [m]."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    order = np.argsort(vtk_to_numpy(data.GetPointData().GetArray("id")))
    x = vtk_to_numpy(data.GetPoints().GetData())[order]
    d = vtk_to_numpy(data.GetPointData().GetArray("diameter"))[order]
    time = vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]
    return time, x, d


def members(d, name):
    low, high = CLASSES[name]
    return (d >= low) & (d < high)


def heights(run):
    print("# t [s], mean height of small, medium, large [mm], small over large")
    for path in pictures(run):
        time, x, d = picture(path)
        y = [1e3 * x[members(d, name), 1].mean() for name in CLASSES]
        print(f"{time:.1f} {y[0]:7.3f} {y[1]:7.3f} {y[2]:7.3f} {y[0] / y[2]:6.3f}")


def scene(run, shift):
    """A placed grain must lie inside the box, which a pressed one does not."""
    _, x, d = picture(pictures(run)[0])
    room = 0.5001 * d[:, None] + 2e-9
    x = np.clip(x + [float(shift), 0.0, 0.0], room, BOX - room)
    places = ",\n".join(f"{{ position = [{p[0]:.9f}, {p[1]:.9f}, {p[2]:.9f}]; "
                        f"diameter = {size:.9e}; }}" for p, size in zip(x, d))
    case = Path("cases/seepage.cfg").read_text()
    before, rest = case.split("    sizes = (", 1)
    after = rest.split("bed = {", 1)[1].split("\n", 1)[1]
    print(f'{before}    overlaps = "allow";\n    place = ({places});\n{after}')


def drop(run, begin, end):
    """Mean pressure drop and its error, from five blocks of time."""
    with open(Path(run, "history.csv"), encoding="ascii") as file:
        rows = list(csv.DictReader(file))
    p = np.array([float(row["pressure_drop [Pa]"]) for row in rows
                  if begin < float(row["time [s]"]) <= end + 1e-9])
    blocks = [block.mean() for block in np.array_split(p, 5)]
    return p.mean(), np.std(blocks) / 2.0


def compare(runs):
    """Differences grain by grain: of two runs from one bed every grain has a twin."""
    print("# t [s]; class; its mean height [mm] in each run; what the second and the\n"
          "# third are higher than the first, and the spread of that difference among\n"
          "# the grains over the square root of their number [mm]")
    for paths in zip(*(pictures(run) for run in runs)):
        shots = [picture(path) for path in paths]
        d = shots[0][2]
        for name in CLASSES:
            y = [1e3 * x[members(d, name), 1] for _, x, _ in shots]
            means = " ".join(f"{one.mean():7.3f}" for one in y)
            off = " ".join(
                f"{(one - y[0]).mean():7.3f} {(one - y[0]).std() / len(one)**0.5:6.3f}"
                for one in y[1:])
            print(f"{shots[0][0]:.1f} {name:6s} {means}  {off}")
    last = shots[0][0]
    print("# mean drop of the second half and its error [Pa], in each run")
    print(" ".join("%.1f %.1f" % drop(run, 0.5 * last, last) for run in runs))


def circles(run):
    for path in pictures(run):
        _, x, d = picture(path)
        for number, name in enumerate(CLASSES):
            for (a, b, _), size in zip(1e3 * x[members(d, name)], d[members(d, name)]):
                print(f"{a:.3f} {b:.3f} {500 * size:.3f} {number}")
        print("\n")


command, *rest = sys.argv[1:]
{"heights": lambda: heights(*rest), "scene": lambda: scene(*rest),
 "compare": lambda: compare(rest), "circles": lambda: circles(*rest)}[command]()
