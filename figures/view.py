# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures or a film of any output folder, without a screen, by ParaView's Python.

    xvfb-run -a -s -noreset pvpython figures/view.py DIR PICTURE.png [time=S] [field=NAME]
    xvfb-run -a -s -noreset pvpython figures/view.py DIR FILM.avi    [field=NAME] [rate=N]

First: the particles by speed or by colour=NAME, resolved bodies, surfaces of walls,
and the box. Beside it, or below it in a wide box, if there is a fluid: a slice through
its middle, by void fraction, or by speed where there are no grains in it; show=solids
or show=slice leaves one of the two. Up is against gravity, and one looks along the
thinnest of the other two directions. A film has all states that were written, or those
from=S on; its name ends in .avi, .ogv or in .png with a film=1 (a picture a state).
Debian: apt-get install paraview xvfb
"""
import math
import os
import re
import sys

from paraview import servermanager, simple as pv

UNITS = {"speed": " [m/s]", "velocity": " [m/s]", "diameter": " [m]", "pressure": " [Pa]"}
KINDS = ("fluid", "particles", "bodies", "body_clumps", "body_surfaces", "surfaces")


def wrong(message):
    print("view.py: " + message, file=sys.stderr)
    sys.exit(2)


def asked(words):
    """DIR, the picture, and the options, each a name = value."""
    files = [w for w in words if "=" not in w]
    options = dict(w.split("=", 1) for w in words if "=" in w)
    unknown = set(options) - {"time", "field", "rate", "size", "film", "from", "colour",
                              "show"}
    if len(files) != 2 or unknown:
        wrong("usage: pvpython view.py DIR PICTURE.png|FILM.avi [time=S] "
              "[field=NAME] [colour=NAME] [show=solids|slice] [rate=N] "
              "[size=WIDTHxHEIGHT] [film=1] [from=S]")
    return files[0], files[1], options


def sources(folder):
    """What the run has written, by kind; empty collections are left out."""
    found = {}
    for kind in KINDS:
        name = os.path.join(folder, kind + ".pvd")
        if os.path.exists(name):
            reader = pv.PVDReader(registrationName=kind, FileName=name)
            reader.UpdatePipelineInformation()
            if reader.TimestepValues:
                found[kind] = reader
    if not found:
        wrong("%s has no fluid.pvd, particles.pvd, bodies.pvd or surfaces.pvd with "
              "a state: name the output folder of a run" % folder)
    return found


def times_of(found):
    """The times of the collection that has most of them."""
    values = [r.TimestepValues for r in found.values()]
    lists = [v if hasattr(v, "__len__") else [v] for v in values]
    return sorted(max(lists, key=len))


def case_of(folder):
    """The case of the run, without comments; empty if the folder has none."""
    try:
        with open(os.path.join(folder, "case.cfg"), encoding="utf-8") as case:
            return re.sub(r"#.*", "", case.read())
    except OSError:
        return ""


def vector(text, key):
    """The first vector of this name in the case, or None."""
    number = r"\s*(-?[\d.]+(?:e[-+]?\d+)?)\s*"
    found = re.search(r"\b" + key + r"\s*=\s*\[" + ",".join([number] * 3) + r"\]",
                      text)
    return [float(x) for x in found.groups()] if found else None


def upward(text):
    """Against gravity; y without gravity."""
    down = vector(text, "gravity") or [0.0, -1.0, 0.0]
    length = math.sqrt(sum(x * x for x in down))
    return [-x / length for x in down] if length else [0.0, 1.0, 0.0]


def bounds_of(found, text):
    """The box of the fluid or of the case, or of all that there is, first and last."""
    size = vector(text[text.find("mesh"):], "size") if "mesh" in text else None
    if size and "fluid" not in found:
        return [x for s in size for x in (0.0, s)]
    box = [math.inf, -math.inf] * 3
    for reader in [found["fluid"]] if "fluid" in found else found.values():
        for time in (times_of(found)[0], times_of(found)[-1]):
            reader.UpdatePipeline(time)
            b = reader.GetDataInformation().GetBounds()
            for k in range(0, 6, 2):
                box[k] = min(box[k], b[k])
                box[k + 1] = max(box[k + 1], b[k + 1])
    return box


def across(box, up):
    """The direction to look along: the thinnest that is not up."""
    vertical = max(range(3), key=lambda k: abs(up[k]))
    widths = [box[2 * k + 1] - box[2 * k] for k in range(3)]
    others = [k for k in (2, 0, 1) if k != vertical]
    return min(others, key=lambda k: round(widths[k], 12))


def speed_of(source, association):
    speed = pv.Calculator(Input=source, AttributeType=association,
                          ResultArrayName="speed", Function="mag(velocity)")
    return speed


def letter_of(view):
    return max(9, round(view.ViewSize[1] / 40))


def shade(display, source, association, name, view, times):
    """Colours by a field with one scale for all times, and a bar that says it."""
    low, high = math.inf, -math.inf
    for time in times[::1 + len(times) // 12] + times[-1:]:
        source.UpdatePipeline(time)
        if source.GetDataInformation().GetNumberOfPoints() == 0:
            continue  # before the first grain
        data = source.PointData if association == "POINTS" else source.CellData
        if name not in data.keys():
            wrong("there is no field %s; there are: %s"
                  % (name, ", ".join(sorted(data.keys()))))
        first, last = data[name].GetRange(-1 if data[name].GetNumberOfComponents() > 1
                                          else 0)
        low, high = min(low, first), max(high, last)
    pv.ColorBy(display, (association, name))
    table = pv.GetColorTransferFunction(name)
    table.ApplyPreset("Viridis (matplotlib)", True)
    table.RescaleTransferFunction(low, high if high > low else low + 1.0)
    bar = pv.GetScalarBar(table, view)
    bar.Title = name.replace("_", " ") + UNITS.get(name, "")
    bar.ComponentTitle = ""
    bar.RangeLabelFormat = "%.2g"
    bar.AddRangeLabels = 1
    bar.DrawTickMarks = bar.DrawTickLabels = 0
    bar.HorizontalTitle = 1
    bar.Orientation = "Horizontal"
    bar.WindowLocation = "Any Location"
    bar.Position, bar.ScalarBarLength = [0.2, 0.03], 0.6
    letter = letter_of(view)
    bar.TitleFontSize = bar.LabelFontSize = letter
    bar.ScalarBarThickness = letter // 2
    bar.TitleColor = bar.LabelColor = [0.2, 0.2, 0.2]
    display.SetScalarBarVisibility(view, True)


def spheres(source, view):
    display = pv.Show(source, view, "GeometryRepresentation")
    display.SetRepresentationType("Point Gaussian")
    display.ShaderPreset = "Sphere"
    display.ScaleByArray = 1
    display.SetScaleArray = ["POINTS", "diameter"]
    display.UseScaleFunction = 0
    display.GaussianRadius = 0.5
    return display


def plain(source, view, colour, opacity=1.0):
    display = pv.Show(source, view, "GeometryRepresentation")
    display.ColorArrayName = ["POINTS", ""]
    display.DiffuseColor = display.AmbientColor = colour
    display.Opacity = opacity
    return display


def outline(box, view):
    frame = pv.Box(XLength=box[1] - box[0] or 1e-9, YLength=box[3] - box[2] or 1e-9,
                   ZLength=box[5] - box[4] or 1e-9,
                   Center=[(box[k] + box[k + 1]) / 2 for k in (0, 2, 4)])
    display = pv.Show(frame, view, "GeometryRepresentation")
    display.SetRepresentationType("Outline")
    display.DiffuseColor = display.AmbientColor = [0.4, 0.4, 0.4]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def new_view(size, box, up, along, turn):
    """A view that shows all of the box: from the front, turned a little if deep."""
    view = pv.CreateView("RenderView")
    view.ViewSize = size
    view.Background = [1, 1, 1]
    view.UseColorPaletteForBackground = 0
    view.OrientationAxesVisibility = 0
    view.CameraParallelProjection = 1
    middle = [(box[k] + box[k + 1]) / 2 for k in (0, 2, 4)]
    size_of = math.sqrt(sum((box[k + 1] - box[k]) ** 2 for k in (0, 2, 4))) or 1.0
    toward = [0.0, 0.0, 0.0]
    toward[along] = 1.0
    side = cross(up, toward)
    if turn:
        toward = [0.9 * t + 0.35 * s + 0.27 * u for t, s, u in zip(toward, side, up)]
    view.CameraFocalPoint = middle
    view.CameraPosition = [m + 3 * size_of * t for m, t in zip(middle, toward)]
    view.CameraViewUp = up
    return view


def are_clumps(source):
    """Bodies whose balls are particles; a state may have none."""
    for time in source.TimestepValues:
        source.UpdatePipeline(time)
        if "angular_momentum" in source.PointData.keys():
            return True
    return False


def bodies(found, view):
    """Outlines, and a sphere for each body that has none."""
    colour = [0.85, 0.45, 0.2]
    outlined = set()
    for kind in ("body_surfaces", "body_clumps"):
        if kind in found:
            found[kind].UpdatePipeline()
            data = servermanager.Fetch(found[kind])
            data = data.GetBlock(0) if data.IsA("vtkMultiBlockDataSet") else data
            of = (data.GetCellData() if kind == "body_surfaces"
                  else data.GetPointData()).GetArray("body")
            outlined |= {int(of.GetTuple1(i)) for i in range(of.GetNumberOfTuples())}
    for kind in ("bodies", "body_clumps"):
        if kind not in found:
            continue
        if are_clumps(found[kind]):
            continue
        alone = "".join("*(id!=%d)" % i for i in outlined) if kind == "bodies" else ""
        source = pv.Calculator(Input=found[kind], AttributeType="Point Data",
                               ResultArrayName="diameter", Function="diameter" + alone)
        display = spheres(source, view)
        display.ColorArrayName = ["POINTS", ""]
        display.DiffuseColor = display.AmbientColor = colour
    if "body_surfaces" in found:
        plain(found["body_surfaces"], view, colour)


def solids(found, view, times, colour):
    if "particles" in found:
        speed = speed_of(found["particles"], "Point Data")
        shade(spheres(speed, view), speed, "POINTS", colour, view, times)
    bodies(found, view)
    if "surfaces" in found:
        plain(found["surfaces"], view, [0.6, 0.6, 0.65], 0.25)


def slice_of(found, field, box, along, view, times):
    fluid = found["fluid"]
    normal = [0.0, 0.0, 0.0]
    normal[along] = 1.0
    middle = [(box[k] + box[k + 1]) / 2 for k in (0, 2, 4)]
    field = field or ("void_fraction" if "particles" in found else "speed")
    if field == "speed":
        fluid = speed_of(fluid, "Cell Data")
    cut = pv.Slice(Input=fluid, SliceType="Plane")
    cut.SliceType.Origin = middle
    cut.SliceType.Normal = normal
    display = pv.Show(cut, view, "GeometryRepresentation")
    # Behind the bodies that it cuts.
    display.Position = [(box[2 * k] - box[2 * k + 1]) * (k == along) for k in range(3)]
    shade(display, cut, "CELLS", field, view, times)


def fit(view, box):
    """The box fills the view above the bar."""
    toward = [p - f for p, f in zip(view.CameraPosition, view.CameraFocalPoint)]
    side = cross(view.CameraViewUp, toward)
    corners = [[box[i], box[2 + j], box[4 + k]] for i in (0, 1) for j in (0, 1)
               for k in (0, 1)]
    across = []
    for direction in (side, cross(toward, side)):
        length = math.sqrt(sum(x * x for x in direction)) or 1.0
        along = [sum(x * d for x, d in zip(c, direction)) / length for c in corners]
        across.append(max(along) - min(along))
    width, height = view.ViewSize
    bar = 5 * letter_of(view)
    scale = 1.06 * max(across[0] / 2 * height / width, across[1] / 2 * height / (height - bar))
    view.CameraParallelScale = scale
    for place in ("CameraPosition", "CameraFocalPoint"):
        setattr(view, place, [x - bar / height * scale * d / length for x, d in
                              zip(getattr(view, place), cross(toward, side))])


def main():
    folder, picture, options = asked(sys.argv[1:])
    if os.path.splitext(picture)[1] not in (".png", ".avi", ".ogv"):
        wrong("%s: the name of the picture must end in .png, .avi or .ogv" % picture)
    found = sources(folder)
    times = times_of(found)
    text = case_of(folder)
    up, box = upward(text), bounds_of(found, text)
    along = across(box, up)
    width, height = map(int, options.get("size", "1280x800").split("x"))
    wanted = options.get("show")
    flow = "fluid" in found and wanted != "solids"
    only = flow and (len(found) == 1 or wanted == "slice")
    count = 2 if flow and not only else 1
    thin = [box[2 * k + 1] - box[2 * k] for k in range(3)]
    tall = max(range(3), key=lambda k: abs(up[k]))
    wide = thin[3 - tall - along] > 1.5 * thin[tall]
    size = [width, height // count] if wide else [width // count, height]
    views = []
    if not only:
        views.append(new_view(size, box, up, along, thin[along] > 0.3 * max(thin)))
        solids(found, views[-1], times, options.get("colour", "speed"))
        outline(box, views[-1])
    if flow:
        views.append(new_view(size, box, up, along, False))
        slice_of(found, options.get("field"), box, along, views[-1], times)
        bodies(found, views[-1])
        outline(box, views[-1])
    layout = pv.CreateLayout("picture")
    layout.AssignView(0, views[0])
    if count == 2:
        (layout.SplitVertical if wide else layout.SplitHorizontal)(0, 0.5)
        layout.AssignView(2, views[1])
    layout.SetSize(width, height)
    scene = pv.GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    first = sum(t < float(options.get("from", "-inf")) for t in times)
    wanted = float(options.get("time", times[-1]))
    scene.AnimationTime = min(times, key=lambda t: abs(t - wanted))
    for view in views:
        fit(view, box)
    if picture.endswith(".png") and "film" not in options:
        pv.SaveScreenshot(picture, layout, ImageResolution=[width, height])
    else:
        pv.SaveAnimation(picture, layout, ImageResolution=[width, height],
                         FrameRate=int(options.get("rate", 10)),
                         FrameWindow=[first, len(times) - 1])


main()
