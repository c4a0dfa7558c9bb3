#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Counts the spheres themselves: the void fraction across the Mueller bed, from
the particle files of a run, without any averaging.

    26-count.py FOLDER HEIGHT [SECONDS]

In 11 slots of 4 mm, 2.4 mm high around HEIGHT [mm] and as deep as the bed: the
mean of all files later than SECONDS (1), of the slot and its mirror image, and
what the mean may be off by chance; and what was measured, as linear between its
points. A sphere is a cloud of points, so that a slot has its exact part of it to
a thousandth.
"""
import math
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

WIDTH, DEPTH, HIGH, SLOTS = 0.044, 0.010, 2.4e-3, 11
MEASURED = "figures/data/mueller-2009.txt"


def picture(path):
    """Time [s], centres [m], 3 a sphere, and diameters [m]."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    data = reader.GetOutput()
    time = vtk_to_numpy(data.GetFieldData().GetArray("TimeValue"))[0]
    x = vtk_to_numpy(data.GetPoints().GetData()).astype(float)
    return time, x, vtk_to_numpy(data.GetPointData().GetArray("diameter"))


def ball(n=16):
    """Points of a grid that are in the ball of radius 1."""
    line = (np.arange(n) + 0.5) * 2 / n - 1
    points = np.array(np.meshgrid(line, line, line)).reshape(3, -1).T
    return points[(points**2).sum(axis=1) < 1]


def void_fraction(x, d, height):
    """Of each slot [-]."""
    near = abs(x[:, 1] - height) < HIGH / 2 + d / 2
    points = ball()
    at = x[near][:, None] + d[near][:, None, None] / 2 * points
    volume = np.repeat(math.pi / 6 * d[near] ** 3 / len(points), len(points))
    at = at.reshape(-1, 3)
    inside = abs(at[:, 1] - height) < HIGH / 2
    solid, _ = np.histogram(
        at[inside, 0], bins=SLOTS, range=(0, WIDTH), weights=volume[inside])
    return 1 - solid / (WIDTH / SLOTS * HIGH * DEPTH)


def measured(height, places):
    """At the places [m]; [-]."""
    rows = [line.split() for line in open(MEASURED) if line[0] != "#"]
    points = [(float(r[3]), float(r[4])) for r in rows
              if r[:2] == ["measured", "eps_f"] and float(r[2]) == height]
    return np.interp(places, *zip(*points))


def main(run, height, begin="1"):
    frames = []
    for path in sorted(Path(run, "particles").glob("*.vtp")):
        time, x, d = picture(path)
        if time > float(begin):
            eps = void_fraction(x, d, float(height) / 1000)
            frames.append((eps + eps[::-1]) / 2)
    mean = np.mean(frames, axis=0)
    chance = np.std(frames, axis=0) / math.sqrt(len(frames))
    places = (np.arange(SLOTS) + 0.5) * WIDTH / SLOTS
    seen = measured(float(height), places)
    seen = (seen + seen[::-1]) / 2
    print(f"# {height} mm, {len(frames)} instants: x [mm], counted, +-, measured")
    for i in range((SLOTS + 1) // 2):
        print(f"{1000 * places[i]:4.0f}  {mean[i]:.3f} +-{chance[i]:.3f}  {seen[i]:.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
