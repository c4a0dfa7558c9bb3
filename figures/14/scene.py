#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Moments of a run side by side, drawn by VTK without a screen.

    xvfb-run -a /usr/bin/python3 figures/14/scene.py out/chute PNG \\
        X,Y,Z speed:MOST|id:ID|ARRAY:MOST WIDTH HEIGHT ZOOM TIME...

Spheres by speed up to MOST m/s, or one of them red; walls grey, or without
spheres by an array of their faces; a panel for each of several, with commas
between; seen from the direction X,Y,Z. Debian: apt-get install python3-vtk9 xvfb
"""
import os
import sys
import xml.etree.ElementTree as ET

from vtkmodules import vtkRenderingFreeType  # noqa: F401  (writes)
from vtkmodules import vtkRenderingOpenGL2  # noqa: F401  (draws)
from vtkmodules.vtkFiltersCore import vtkArrayCalculator, vtkGlyph3D
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction,
                                         vtkPolyDataMapper,
                                         vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)


def opened(folder, name, seconds):
    """The file that the collection lists at this time, or the last before."""
    listed = list(
        ET.parse(os.path.join(folder, name + ".pvd")).iter("DataSet"))
    files = {float(d.get("timestep")): d.get("file") for d in listed}
    time = min(files, key=lambda t: abs(t - seconds))
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, files[time]))
    reader.Update()
    return reader


def viridis(top):
    colours = vtkColorTransferFunction()  # viridis: lighter is larger
    for k, (r, g, b) in enumerate(((0.267, 0.005, 0.329), (0.229, 0.322, 0.546),
                                   (0.128, 0.567, 0.551), (0.369, 0.789, 0.383),
                                   (0.993, 0.906, 0.144))):
        colours.AddRGBPoint(0.25 * top * k, r, g, b)
    return colours


def spheres(points, shown, number):
    value = vtkArrayCalculator()
    value.SetInputConnection(points.GetOutputPort())
    value.AddVectorArrayName("velocity")
    value.AddScalarArrayName("id")
    value.SetFunction("mag(velocity)" if shown == "speed"
                      else f"if(abs(id - {number}) < 0.5, 1, 0)")
    value.SetResultArrayName("shown")
    ball = vtkSphereSource()
    ball.SetRadius(0.5)
    ball.SetThetaResolution(24)
    ball.SetPhiResolution(24)
    glyph = vtkGlyph3D()
    glyph.SetInputConnection(value.GetOutputPort())
    glyph.SetSourceConnection(ball.GetOutputPort())
    glyph.SetInputArrayToProcess(0, 0, 0, 0, "diameter")
    glyph.SetInputArrayToProcess(3, 0, 0, 0, "shown")
    glyph.SetScaleModeToScaleByScalar()
    glyph.SetColorModeToColorByScalar()
    top = float(number) if shown == "speed" else 1.0
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(glyph.GetOutputPort())
    mapper.SetLookupTable(viridis(top))
    mapper.SetScalarRange(0.0, top)
    actor = vtkActor()
    actor.SetMapper(mapper)
    return actor


def walls(reader, array, most):
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(reader.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    if array not in ("speed", "id"):
        mapper.ScalarVisibilityOn()
        mapper.SetScalarModeToUseCellFieldData()
        mapper.SelectColorArray(array)
        mapper.SetLookupTable(viridis(float(most)))
        actor.GetProperty().LightingOff()
        return actor
    actor.GetProperty().SetColor(0.6, 0.6, 0.62)
    actor.GetProperty().SetOpacity(0.45)
    actor.GetProperty().EdgeVisibilityOn()
    actor.GetProperty().SetEdgeColor(0.35, 0.35, 0.4)
    return actor


def look(renderer, towards, bounds, zoom):
    middle = [0.5 * (bounds[2 * k] + bounds[2 * k + 1]) for k in range(3)]
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.SetFocalPoint(middle)
    camera.SetPosition([middle[k] + towards[k] for k in range(3)])
    camera.SetViewUp(0, 1, 0)
    renderer.ResetCamera(bounds)
    camera.Zoom(zoom)


def main():
    folder, png, towards, colour, width, height, zoom = sys.argv[1:8]
    panels = [(float(t), *c.split(":"))
              for c in colour.split(",") for t in sys.argv[8:]]
    towards = [float(x) for x in towards.split(",")]
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(int(width) * len(panels), int(height))
    window.SetMultiSamples(8)
    bounds = None
    for i, (time, shown, most) in enumerate(panels):
        renderer = vtkRenderer()
        renderer.SetBackground(1, 1, 1)
        renderer.SetViewport(i / len(panels), 0, (i + 1) / len(panels), 1)
        if os.path.exists(os.path.join(folder, "surfaces.pvd")):
            renderer.AddActor(walls(opened(folder, "surfaces", time), shown,
                                    most))
        if shown in ("speed", "id"):
            renderer.AddActor(spheres(opened(folder, "particles", time), shown,
                                      most))
        text = vtkTextActor()
        text.SetInput(f"{time:g} s")
        text.GetTextProperty().SetColor(0, 0, 0)
        text.GetTextProperty().SetFontSize(20)
        text.SetPosition(12, 10)
        renderer.AddActor(text)
        window.AddRenderer(renderer)
        bounds = bounds or renderer.ComputeVisiblePropBounds()
        look(renderer, towards, bounds, float(zoom))
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(png)
    writer.Write()


if __name__ == "__main__":
    main()
