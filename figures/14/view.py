#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A view into a bed, drawn by VTK without a screen.

    xvfb-run -a /usr/bin/python3 figures/14/view.py out/mueller-bed [SECONDS] PNG

Left: the particles of the back half, coloured by speed. Right: the surface on
which the void fraction is 0.8, the skin of a bubble. Without SECONDS the last
state. Debian: apt-get install python3-vtk9 xvfb
"""
import os
import sys
import xml.etree.ElementTree as ET

from vtkmodules import vtkRenderingOpenGL2  # noqa: F401  (draws)
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersCore import (vtkArrayCalculator,
                                       vtkCellDataToPointData,
                                       vtkContourFilter)
from vtkmodules.vtkFiltersModeling import vtkOutlineFilter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader,
                                 vtkXMLRectilinearGridReader)
from vtkmodules.vtkRenderingCore import (vtkActor, vtkDataSetMapper,
                                         vtkColorTransferFunction,
                                         vtkPointGaussianMapper, vtkRenderer,
                                         vtkRenderWindow,
                                         vtkWindowToImageFilter)

# A point is drawn as a disc that is shaded like a sphere.
SPHERE = """//VTK::Color::Impl
float r2 = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);
if (r2 > 1.0) { discard; }
diffuseColor *= 0.4 + 0.6 * sqrt(1.0 - r2);
"""


def opened(reader, folder, name, seconds):
    """The file that the collection lists at this time, or last."""
    listed = ET.parse(os.path.join(folder, name + ".pvd")).iter("DataSet")
    files = {float(d.get("timestep")): d.get("file") for d in listed}
    time = min(files, key=lambda t: abs(t - (seconds or max(files))))
    reader.SetFileName(os.path.join(folder, files[time]))
    reader.Update()
    return reader


def particles(points, middle):
    """Spheres behind the middle of the box, by speed."""
    speed = vtkArrayCalculator()
    speed.SetInputConnection(points.GetOutputPort())
    speed.AddVectorArrayName("velocity")
    speed.SetFunction("mag(velocity)")
    speed.SetResultArrayName("speed")
    mapper = vtkPointGaussianMapper()
    mapper.SetInputConnection(speed.GetOutputPort())
    mapper.SetScaleArray("diameter")
    mapper.SetScaleFactor(0.5)
    mapper.EmissiveOff()
    mapper.SetSplatShaderCode(SPHERE)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectColorArray("speed")
    mapper.GetLookupTable()
    mapper.SetScalarRange(0.0, 0.6)
    back = vtkPlane()
    back.SetOrigin(middle)
    back.SetNormal(0, 0, -1)
    mapper.AddClippingPlane(back)
    mapper.SetLookupTable(shades())
    return mapper


def shades():
    """Viridis: lighter is larger, also in grey and to every eye."""
    table = vtkColorTransferFunction()
    for k, (r, g, b) in enumerate(((0.267, 0.005, 0.329), (0.229, 0.322, 0.546),
                                   (0.128, 0.567, 0.551), (0.369, 0.789, 0.383),
                                   (0.993, 0.906, 0.144))):
        table.AddRGBPoint(0.15 * k, r, g, b)
    return table


def scale(mapper):
    """The bar that says which shade is which speed."""
    bar = vtkScalarBarActor()
    bar.SetLookupTable(mapper.GetLookupTable())
    bar.SetTitle("m/s")
    bar.SetNumberOfLabels(4)
    bar.SetLabelFormat("%.1f")
    bar.UnconstrainedFontSizeOn()
    bar.SetPosition(0.02, 0.3)
    bar.SetWidth(0.09)
    bar.SetHeight(0.4)
    for words in (bar.GetTitleTextProperty(), bar.GetLabelTextProperty()):
        words.SetColor(0.2, 0.2, 0.2)
        words.ShadowOff()
        words.ItalicOff()
        words.BoldOff()
        words.SetFontSize(18)
    return bar


def skin(grid):
    """The surface of void fraction 0.8."""
    smooth = vtkCellDataToPointData()
    smooth.SetInputConnection(grid.GetOutputPort())
    surface = vtkContourFilter()
    surface.SetInputConnection(smooth.GetOutputPort())
    surface.SetInputArrayToProcess(0, 0, 0, 0, "void_fraction")
    surface.SetValue(0, 0.8)
    mapper = vtkDataSetMapper()
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    return mapper


def panel(window, k, grid, mapper, colour, bar=None):
    """Half of the picture: what the mapper draws, and the edges of the box."""
    edges = vtkOutlineFilter()
    edges.SetInputConnection(grid.GetOutputPort())
    lines = vtkDataSetMapper()
    lines.SetInputConnection(edges.GetOutputPort())
    renderer = vtkRenderer()
    for m, c in ((mapper, colour), (lines, (0.4, 0.4, 0.4))):
        actor = vtkActor()
        actor.SetMapper(m)
        actor.GetProperty().SetColor(c)
        actor.GetProperty().SetAmbient(0.35)
        actor.GetProperty().SetDiffuse(0.65)
        renderer.AddActor(actor)
    if bar:
        renderer.AddActor2D(bar)
    renderer.SetViewport(0.5 * k, 0, 0.5 * k + 0.5, 1)
    renderer.SetBackground(1, 1, 1)
    camera = renderer.GetActiveCamera()
    camera.Azimuth(22)
    camera.Elevation(18)
    renderer.ResetCamera()
    camera.Zoom(1.4)
    camera.SetWindowCenter(0.0, -0.3)
    window.AddRenderer(renderer)


folder, png = sys.argv[1], sys.argv[-1]
seconds = float(sys.argv[2]) if len(sys.argv) > 3 else None
grid = opened(vtkXMLRectilinearGridReader(), folder, "fluid", seconds)
points = opened(vtkXMLPolyDataReader(), folder, "particles", seconds)
window = vtkRenderWindow()
window.SetOffScreenRendering(1)
window.SetSize(1000, 800)
speeds = particles(points, grid.GetOutput().GetCenter())
panel(window, 0, grid, speeds, (1, 1, 1), scale(speeds))
panel(window, 1, grid, skin(grid), (0.75, 0.62, 0.42))
window.Render()
image = vtkWindowToImageFilter()
image.SetInput(window)
image.ReadFrontBufferOff()
writer = vtkPNGWriter()
writer.SetFileName(png)
writer.SetInputConnection(image.GetOutputPort())
writer.Write()
