#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Read what Winnow writes with the real VTK readers.

    vtk_check.py FOLDER...

A folder with .pvd files is the output of a run: each listed file must load
without a word of complaint, hold a number for each cell or particle, show the
time that its collection gives, and make physical sense; history.csv,
profiles/*.csv and summary.json must be what they should be, and no file may be
left half written.

A folder without .pvd files holds the samples that `test_vtk FOLDER` writes,
whose numbers can be computed from their place and must agree to the bit.

Prints a line for each fault and a count. Exit status 0 if there is no fault,
also where Python has no VTK (Debian: python3-vtk9 python3-numpy), 1 if there
is one, 2 if there is nothing to check.
"""

import csv
import json
import math
import os
import re
import sys
import zlib
import xml.etree.ElementTree as ET
from pathlib import Path

try:
    import numpy as np
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    from vtkmodules.vtkIOXML import (vtkXMLPolyDataReader,
                                     vtkXMLRectilinearGridReader,
                                     vtkXMLUnstructuredGridReader)
except ImportError as missing:
    print(f"vtk_check: no {missing.name} for Python here, left out "
          "(Debian: apt-get install python3-vtk9 python3-numpy)")
    sys.exit(0)

faults = []
checks = 0


def check(holds, path, text):
    global checks
    checks += 1
    if not holds:
        faults.append(f"{path}: {text}")
    return holds


# --- Loading -----------------------------------------------------------------

def read(path):
    """What VTK reads from the file, and what it says meanwhile."""
    window = vtkStringOutputWindow()
    vtkOutputWindow.SetInstance(window)
    reader = {".vtr": vtkXMLRectilinearGridReader,
              ".vtu": vtkXMLUnstructuredGridReader,
              ".vtp": vtkXMLPolyDataReader}[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    said = " ".join(window.GetOutput().split())
    return reader.GetOutput(), said or "an error" * (reader.GetErrorCode() != 0)


def ends_python(path):
    """Some faults end the reader with a signal: let a child go first."""
    child = os.fork()
    if child == 0:
        os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        try:
            read(path)
            os._exit(0)
        finally:
            os._exit(1)
    return os.waitpid(child, 0)[1] != 0


def load(path):
    """The data of a file, or None and a fault."""
    if not check(not ends_python(path), path, "VTK's reader crashes on it"):
        return None
    data, said = read(path)
    good = check(not said, path, f"VTK says: {said[:300]}")
    return data if good else None


def on_cells(path):
    """A fluid and the walls have their numbers on cells, particles on points."""
    return path.suffix == ".vtr" or path.stem.startswith(
        ("fluid", "surfaces", "walls", "contacts", "body_surfaces"))


def arrays_of(path, data):
    """Name and numbers of each array on cells or points."""
    place = data.GetCellData() if on_cells(path) else data.GetPointData()
    arrays = [place.GetArray(i) for i in range(place.GetNumberOfArrays())]
    return {a.GetName(): vtk_to_numpy(a) for a in arrays}


def announced(path):
    """Names and component counts that the XML in front of the bytes lists."""
    head = path.read_bytes().split(b"<AppendedData")[0] + b"</VTKFile>"
    section = ".//CellData" if on_cells(path) else ".//PointData"
    found = [(a.get("Name"), int(a.get("NumberOfComponents")))
             for a in ET.fromstring(head).find(section)]
    check(len(dict(found)) == len(found), path, "a name is used twice")
    return dict(found)


def check_arrays(path, data):
    """As many numbers as cells or particles, for every array in the file."""
    arrays, wanted = arrays_of(path, data), announced(path)
    count = (data.GetNumberOfCells() if on_cells(path)
             else data.GetNumberOfPoints())
    check(set(arrays) == set(wanted), path,
          f"has arrays {sorted(wanted)}, VTK finds {sorted(arrays)}")
    for name, array in arrays.items():
        width = array.size // len(array) if len(array) else wanted.get(name)
        check(len(array) == count and width == wanted.get(name), path,
              f"{name} has the shape {array.shape}, not {count} rows")
    return arrays


def time_of(path, data):
    stamp = data.GetFieldData().GetArray("TimeValue")
    if not check(stamp is not None and stamp.GetNumberOfTuples() == 1, path,
                 "no TimeValue"):
        return math.nan
    return stamp.GetValue(0)


def check_verts(path, data):
    """Each particle is a cell of its own, or it would not be drawn."""
    n = data.GetNumberOfPoints()
    verts = data.GetVerts()
    ids = vtk_to_numpy(verts.GetConnectivityArray())
    check(data.GetNumberOfCells() == n and data.GetNumberOfVerts() == n and
          (ids == np.arange(n)).all(), path, "not one vertex a particle")


def check_polygons(path, data):
    """Walls: each polygon has at least three points of its own, and an area."""
    polys = data.GetPolys()
    check(data.GetNumberOfCells() == data.GetNumberOfPolys() > 0, path,
          "not only polygons")
    ends = vtk_to_numpy(polys.GetOffsetsArray())
    ids = vtk_to_numpy(polys.GetConnectivityArray())
    check((np.diff(ends) >= 3).all() and
          (ids == np.arange(data.GetNumberOfPoints())).all(), path,
          "a polygon shares its points or has too few")
    at = vtk_to_numpy(data.GetPoints().GetData())
    check(np.isfinite(at).all(), path, "a place is not finite")
    for a, b in zip(ends[:-1], ends[1:]):
        ring = at[a:b] - at[a]
        area = np.cross(ring[1:-1], ring[2:]).sum(axis=0)
        check(np.linalg.norm(area) > 0, path, "a polygon has no area")


def check_contacts(path, data, arrays):
    """Lines of linear springs of 100 N/m between spheres of 1 mm."""
    check(data.GetNumberOfCells() == data.GetNumberOfLines(), path,
          "has other cells than lines")
    if not data.GetNumberOfLines():
        return
    force, overlap = arrays["force"], arrays["overlap"]
    check(np.allclose(force, 100 * overlap, rtol=1e-6), path,
          "a force is not that of its overlap")
    ends = vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 2, 3)
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    reach = np.where(arrays["ids"][:, 1] < 0, 0.5e-3, 1e-3)
    check(np.allclose(length + overlap, reach, rtol=1e-6), path,
          "a line is not as long as its spheres are apart")


def check_volumes(path, data):
    """Each cell has a positive volume, and they fill what their box allows: a
    cell whose points are in the wrong order is turned inside out."""
    size = vtkCellSizeFilter()
    size.SetInputData(data)
    size.Update()
    volumes = vtk_to_numpy(size.GetOutput().GetCellData().GetArray("Volume"))
    x0, x1, y0, y1, z0, z1 = data.GetBounds()
    room = (x1 - x0) * (y1 - y0) * (z1 - z0)
    check(volumes.min() > 0, path, f"{(volumes <= 0).sum()} cells have no "
          "volume or are inside out")
    check(volumes.sum() <= room * (1 + 1e-9), path,
          f"cells of {volumes.sum()} m3 in a box of {room} m3")


# --- Samples -----------------------------------------------------------------

def sample(first, count):
    """The numbers of tests/test_vtk.c, exact in single precision too."""
    return (np.arange(first, first + count) % 1009) * 0.375 - 100.0


def check_sample_box(path, data):
    cells = [int(n) for n in re.findall(r"\d+", path.stem)]
    check(data.GetDimensions() == tuple(n + 1 for n in cells), path,
          f"dimensions are {data.GetDimensions()}")
    axes = (data.GetXCoordinates(), data.GetYCoordinates(),
            data.GetZCoordinates())
    for axis, size in zip(axes, (0.3, 0.7, 0.11)):
        edges = vtk_to_numpy(axis)
        check((np.diff(edges) > 0).all() and edges[0] == 0 and
              math.isclose(edges[-1], size, rel_tol=1e-15), path,
              f"edges go from {edges[0]} to {edges[-1]}")


def check_sample_particles(path, data):
    n = int(re.findall(r"\d+", path.stem)[0])
    check(data.GetNumberOfPoints() == n, path,
          f"{data.GetNumberOfPoints()} points")
    check_verts(path, data)
    if n:
        points = vtk_to_numpy(data.GetPoints().GetData())
        wanted = np.stack([sample(3 * k, n) for k in range(3)], axis=1)
        check((points == wanted).all(), path, "points are not the sample's")


def check_sample(path):
    data = load(path)
    if data is None:
        return
    box = path.suffix == ".vtr"
    (check_sample_box if box else check_sample_particles)(path, data)
    check(time_of(path, data) == 0.1, path, "time is not 0.1")
    arrays = check_arrays(path, data)
    check(len(arrays) == 12, path, f"{len(arrays)} arrays, not 12")
    for name, array in arrays.items():
        flat = array.reshape(-1)
        wanted = (7 * np.arange(len(flat)) - 3 if name == "whole"
                  else sample(0, len(flat)))
        kind = {"f32": "float32", "who": "int32"}.get(name[:3], "float64")
        check(flat.dtype == kind and (flat == wanted).all(), path,
              f"{name} ({flat.dtype}) does not hold the sample's numbers")


# --- A run -------------------------------------------------------------------

def check_collection(pvd, box):
    """All files that a collection lists; returns the box of its grids, or the
    one given."""
    before, first = -math.inf, None
    for item in ET.parse(pvd).getroot().iter("DataSet"):
        path, time = pvd.parent / item.get("file"), float(item.get("timestep"))
        check(time > before, pvd, f"time {time} does not come after {before}")
        before = time
        if not check(path.is_file(), path, f"is not there, but in {pvd.name}"):
            continue
        data = load(path)
        if data is None:
            continue
        check(time_of(path, data) == time, path, f"is not of time {time}")
        arrays = check_arrays(path, data)
        shapes = {n: (a.dtype, a.shape[1:]) for n, a in arrays.items()}
        first = first or shapes
        check(shapes == first, path, "has other arrays than the first")
        check_sense(path, data, arrays, box)
        if path.stem.startswith("fluid"):
            box = data.GetBounds()
    return box


def check_sense(path, data, arrays, box):
    """Finite numbers, a fraction that is one, particles in the box."""
    for name, array in arrays.items():
        check(np.isfinite(array).all(), path, f"{name} is not finite")
    void = arrays.get("void_fraction")
    if void is not None:
        check(void.min() > 0 and void.max() <= 1, path,
              f"void_fraction goes from {void.min()} to {void.max()}")
    if path.suffix == ".vtu" and path.stem.startswith("fluid"):
        check_volumes(path, data)
    if path.suffix != ".vtp":
        return
    if path.stem.startswith("contacts"):
        check_contacts(path, data, arrays)
        return
    if on_cells(path):
        check_polygons(path, data)
        return
    check_verts(path, data)
    if data.GetNumberOfPoints():
        at = vtk_to_numpy(data.GetPoints().GetData())
        check(np.isfinite(at).all(), path, "a place is not finite")
        outside = (at < box[0::2]) | (at > box[1::2]) if box else np.zeros(1)
        check(not outside.any(), path, f"{outside.sum()} are outside the box")


def check_table(path, ascending):
    with path.open(newline="") as lines:
        head, *rows = list(csv.reader(lines))
    check(all(re.fullmatch(r"\S.* \[[^\]]+\]", name) for name in head), path,
          f"the head is not `name [unit]` throughout: {head}")
    check(len(set(head)) == len(head), path, "a name is used twice")
    numbers = np.array([[float(x) for x in row] for row in rows if
                        check(len(row) == len(head), path, f"row {row}")])
    if ascending and len(numbers):
        check((np.diff(numbers[:, 0]) > 0).all(), path, "time goes back")


def check_pressed(folder):
    """Contacts by hand; one of them with a surface. What is said of particles."""
    files = sorted((folder / "contacts").glob("*.vtp"))
    lines = [load(p).GetNumberOfLines() for p in files]
    check(lines == [2, 2], folder, f"{lines} contacts, not 2, and then 2")
    others = sorted(arrays_of(files[-1], load(files[-1]))["ids"][:, 1])
    check(others == [-7, -3], folder, f"{others}, not the shelf and the floor")
    for path in sorted((folder / "particles").glob("*.vtp")):
        a = arrays_of(path, load(path))
        check(list(a["id"]) == [0, 1, 2, 3, 4], path, "ids do not ascend")
        check(np.allclose(a["mass"], 1000 * math.pi / 6 * 1e-9, rtol=1e-6),
              path, "a mass is not that of its sphere")
        check((a["material"] == 0).all(), path, "another material")
    check(list(a["contact_number"]) == [0, 0, 0, 1, 1], path,
          f"contact numbers {a['contact_number']}")
    check((a["contact_force"][3:, 1] > 1e-6).all() and
          (a["contact_force"][:3] == 0).all(), path, "a force of no contact")
    check((a["fluid_force"][:3, 1] * a["velocity"][:3, 1] < 0).all() and
          (np.abs(a["fluid_force"]) < 1e-4).all(), path,
          "the drag is not against the motion")


def check_moved(folder, here):
    """What was moved across the seams has the same contacts."""
    for path in sorted((folder / "contacts").glob("*.vtp")):
        pair = [(p, load(p)) for p in (path, here / "contacts" / path.name)]
        lists = []
        for p, data in pair:
            a = arrays_of(p, data)
            ends = vtk_to_numpy(data.GetPoints().GetData()).reshape(-1, 2, 3)
            rows = zip(np.sort(a["ids"], axis=1).tolist(), a["force"],
                       a["overlap"],
                       np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1))
            lists.append(sorted(rows, key=lambda row: row[0]))
        got, want = lists
        check(len(got) == len(want) >= 12 and
              all(g[0] == w[0] and np.allclose(g[1:], w[1:], rtol=1e-5)
                  for g, w in zip(got, want)), path, "contacts have changed")
        number = [arrays_of(p, load(p))["contact_number"].tolist()
                  for p in (folder / "particles" / path.name.replace(
                      "contacts", "particles"),
                      here / "particles" / path.name.replace(
                          "contacts", "particles"))]
        check(number[0] == number[1] == [3] * 8, path,
              f"contact numbers {number}")


def plain(path):
    """The arrays in the order of the bytes, as readers without VTK find them:
    each begins where the one before ends, at the number that its offset is."""
    head, tail = path.read_bytes().split(b'<AppendedData encoding="raw">', 1)
    root = ET.fromstring(head + b"</VTKFile>")
    data = tail.split(b"_", 1)[1].rsplit(b"\n</AppendedData>", 1)[0]
    at, found = 0, {}
    while at < len(data):
        array = root.find(f".//DataArray[@offset='{at}']")
        if not check(array is not None, path, f"no array begins at {at}"):
            return found
        blocks = int.from_bytes(data[at:at + 8], "little")
        sizes = np.frombuffer(data[at + 24:at + 8 * (3 + blocks)], "<u8")
        at += 8 * (3 + blocks)
        numbers = b""
        for size in sizes.tolist():
            numbers += zlib.decompress(data[at:at + size])
            at += size
        kind = array.get("type").lower()
        found[array.get("Name")] = np.frombuffer(numbers, kind)
    return found


def check_grids(folder, other):
    """All files are .vtu, and hold what those of the other run hold."""
    for path in sorted(folder.rglob("*.vt?")):
        check(path.suffix == ".vtu", path, "is no .vtu")
        twin = next((other / path.parent.name).glob(path.stem + ".*"))
        data, same = load(path), load(twin)
        if not check(data.GetNumberOfCells() == same.GetNumberOfCells(), path,
                     "has another number of cells"):
            continue
        # VTK goes around the faces of a hexahedron, and across those of a voxel.
        around = [0, 1, 3, 2, 4, 5, 7, 6] if twin.suffix == ".vtr" else ...
        for i in range(data.GetNumberOfCells()):
            got, want = (vtk_to_numpy(d.GetCell(i).GetPoints().GetData())
                         for d in (data, same))
            check(got.shape == want.shape and (got[around] == want).all(),
                  path, f"cell {i} has other corners")
        a, b = arrays_of(path, data), arrays_of(twin, same)
        check(list(a) == list(b) and
              all((a[n] == b[n]).all() for n in a), path, "has other numbers")
        raw = plain(path)
        check(all(n in raw and (raw[n] == a[n].reshape(-1)).all() for n in a),
              path, "has other bytes where its offsets point")


def check_run(folder):
    box = None
    for pvd in sorted(folder.glob("*.pvd"), key=lambda p: p.stem != "fluid"):
        box = check_collection(pvd, box)
    check((folder / "history.csv").is_file(), folder, "no history.csv")
    for path in sorted(folder.rglob("*.csv")):
        check_table(path, path.name in ("history.csv", "surfaces.csv"))
    if folder.name == "pressed":
        check_pressed(folder)
    if folder.name.endswith("-grids"):
        check_grids(folder, folder.with_name(folder.name[:-6]))
    if folder.name.endswith("-moved"):
        check_moved(folder, folder.with_name(folder.name[:-5] + "here"))
    summary = folder / "summary.json"
    if check(summary.is_file(), folder, "no summary.json"):
        strict = {"parse_constant": lambda word: check(False, summary, word)}
        content = json.loads(summary.read_text(encoding="utf-8"), **strict)
        check(isinstance(content, dict) and content, summary, "says nothing")
    for path in folder.rglob("*.partial"):
        check(False, path, "was left half written")


def main():
    passed = failed = 0
    for folder in map(Path, sys.argv[1:]):
        run = list(folder.glob("*.pvd"))
        for path in [folder] if run else sorted(folder.glob("*.vt[rp]")):
            before = len(faults)
            (check_run if run else check_sample)(path)
            if len(faults) == before:
                passed += 1
            else:
                failed += 1
    print(*faults, sep="\n", end="\n" if faults else "")
    print(f"runs and samples that VTK reads: {passed} passed, {failed} failed")
    return 2 if not checks else 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
