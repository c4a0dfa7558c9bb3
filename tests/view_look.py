"""How much of a picture is not white, how much is coloured, and its spread."""
import sys
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader
reader = vtkPNGReader()
reader.SetFileName(sys.argv[1])
reader.Update()
size = reader.GetOutput().GetDimensions()
rgb = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())[:, :3].astype(int)
rgb = rgb.reshape(size[1], size[0], 3)
up = rgb[::-1] # VTK's first row is the lowest
left = up[:int(0.84 * size[1]), :size[0] // (2 if sys.argv[2] == "two" else 1)] # above the bar
ink = left.min(axis=2) < 250
rows, columns = ink.any(axis=1).nonzero()[0], ink.any(axis=0).nonzero()[0]
colour = rgb.max(axis=2) - rgb.min(axis=2) > 40
orange = (rgb[:, :, 0] > rgb[:, :, 2] + 60) & (rgb[:, :, 0] > rgb[:, :, 1] + 40)
print("ink %.4f" % ink.mean(), "colour %.4f" % colour.mean(), "orange %.4f" % orange.mean(),
      "tall %.2f" % (len(rows) / len(columns)), "kinds %d" % len({tuple(c) for c in rgb[::4, ::4].reshape(-1, 3)}))
