#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Opens large files, beside VTK's readers of them: large_files.py [-o FOLDER] [--share SHARE] [NAME …]

    benchmarks/large_files.py                        all of them: ten minutes, 12 GiB of memory, 12 GB of disk
    benchmarks/large_files.py vdb vti --share 0.1    two of them, with a tenth of the numbers

Files are written first, into FOLDER, where they stay, or a temporary folder. `pellucid info` then reads each whole and looks at every
number; VTK's reader, in a Python process of its own, reads it. `isosurface` draws a surface, `lines` follows streamlines through cells
beside vtkStreamTracer by the same scheme and the same steps. Memory is the most of the proportional set size of all processes of a
command, every 50 ms: what two of them share counts once. Of VTK's streamlines the time of one, whose cells have to be sorted as well, is
left out. Needs NumPy and VTK's Python.
"""

import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

POINTS, IMAGE, VOXELS, CELLS = 16_300_000, 430_000_000, 512_000_000, 5_000_000
RUNS = 3  # of which the median counts: the first may wait for its memory


# What is measured


def children(of):
    with open(f"/proc/{of}/task/{of}/children", encoding="ascii") as file:
        for child in file.read().split():
            yield int(child)
            yield from children(int(child))


def proportional_bytes(process):
    total = 0
    try:
        for one in [process, *children(process)]:
            with open(f"/proc/{one}/smaps_rollup", encoding="ascii") as file:
                total += next(1024 * int(line.split()[1]) for line in file if line.startswith("Pss:"))
    except (OSError, StopIteration):
        pass  # one has just ended
    return total


def measured(*words):
    """Seconds, most bytes and what is told; exits when the command fails."""
    start = time.perf_counter()
    process = subprocess.Popen([str(word) for word in words], stdout=subprocess.PIPE, text=True)
    told = []
    reading = threading.Thread(target=lambda: told.append(process.stdout.read()))
    reading.start()
    most = 0
    while process.poll() is None:
        most = max(most, proportional_bytes(process.pid))
        time.sleep(0.05)
    reading.join()
    if process.returncode:
        sys.exit(f"{' '.join(map(str, words))}: exit {process.returncode}")
    return {"seconds": time.perf_counter() - start, "bytes": most}, told[0]


def median_of(runs):
    return {what: statistics.median(run[what] for run in runs) for what in runs[0]}


# What VTK does, in a process of its own: large_files.py --vtk FILE [TRACE]

READERS = {".vtp": vtk.vtkXMLPolyDataReader, ".ply": vtk.vtkPLYReader, ".vti": vtk.vtkXMLImageDataReader,
           ".vtu": vtk.vtkXMLUnstructuredGridReader}  # of .csv one keeps texts, minutes long


def read_by_vtk(path):
    reader = READERS[path.suffix]()
    reader.SetFileName(str(path))
    reader.Update()
    return reader


def time_reading(path):
    start = time.perf_counter()
    read_by_vtk(path)
    print(json.dumps({"seconds": time.perf_counter() - start}))


def trace_by_vtk(path, seeds, step, length):
    """Prints the number of steps and the seconds, without those of reading."""
    reader = read_by_vtk(path)
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(seeds, deep=True))
    source = vtk.vtkPolyData()
    source.SetPoints(points)
    vtk.vtkSMPTools.Initialize(1)  # one thread
    tracer = vtk.vtkStreamTracer()
    tracer.SetInputConnection(reader.GetOutputPort())
    tracer.SetSourceData(source)
    tracer.SetIntegratorTypeToRungeKutta4()
    tracer.SetInterpolatorTypeToCellLocator()
    tracer.SetIntegrationStepUnit(vtk.vtkStreamTracer.LENGTH_UNIT)
    tracer.SetInitialIntegrationStep(step)
    tracer.SetMaximumPropagation(length)
    tracer.SetMaximumNumberOfSteps(1_000_000)
    tracer.SetComputeVorticity(False)
    lines = tracer.GetOutput()
    start = time.perf_counter()
    tracer.Update()
    seconds, steps = time.perf_counter() - start, lines.GetNumberOfPoints() - lines.GetNumberOfLines()
    one = vtk.vtkPolyData()
    one_place = vtk.vtkPoints()
    one_place.InsertNextPoint(seeds[0])
    one.SetPoints(one_place)
    tracer.SetSourceData(one)
    start = time.perf_counter()
    tracer.Update()  # sorts the cells again
    print(json.dumps({"steps": steps, "seconds": seconds - (time.perf_counter() - start)}))


# Files


def random_points(count):
    return np.random.default_rng(1).random((count, 3), dtype=np.float32)


def write_vtp(path, count):
    points, data = vtk.vtkPoints(), vtk.vtkPolyData()
    numbers = random_points(count)
    points.SetData(numpy_to_vtk(numbers, deep=True))
    data.SetPoints(points)
    mass = numpy_to_vtk(np.ascontiguousarray(numbers[:, 0]), deep=True)
    mass.SetName("m")
    data.GetPointData().AddArray(mass)
    write_xml(vtk.vtkXMLPolyDataWriter(), data, path)


def write_xml(writer, data, path):
    writer.SetFileName(str(path))
    writer.SetInputData(data)
    writer.SetDataModeToAppended()
    writer.EncodeAppendedDataOff()
    writer.SetCompressorTypeToNone()
    writer.Write()


def write_ply(path, count):
    numbers = random_points(count)
    vertices = np.zeros(count, dtype=[("place", "<f4", 3), ("m", "<f4")])
    vertices["place"], vertices["m"] = numbers, numbers[:, 0]
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty float x\nproperty float y\nproperty float z\n"
                   "property float m\nend_header\n".encode())
        file.write(vertices.tobytes())


def write_csv(path, count):
    numbers = random_points(count)
    with open(path, "w", encoding="ascii") as file:
        file.write("x,y,z,m\n")
        for start in range(0, count, 1 << 16):
            rows = numbers[start : start + (1 << 16)].tolist()
            file.writelines(f"{x:.9g},{y:.9g},{z:.9g},{x:.9g}\n" for x, y, z in rows)


def write_vti(path, count):
    """Vectors of a vortex, a layer at a time: they need not be in memory."""
    side = round(count ** (1 / 3))
    x = np.linspace(-1, 1, side, dtype=np.float32)
    layer = np.empty((side, side, 3), dtype="<f4")
    layer[..., 0], layer[..., 1], layer[..., 2] = -x[:, None], x[None, :], 0.1
    extent = f"0 {side - 1} 0 {side - 1} 0 {side - 1}"
    with open(path, "wb") as file:
        file.write(f'<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64"><ImageData WholeExtent="{extent}" '
                   f'Origin="-1 -1 -1" Spacing="{2 / (side - 1)} {2 / (side - 1)} {2 / (side - 1)}"><Piece Extent="{extent}"><PointData Vectors="v">'
                   '<DataArray type="Float32" Name="v" NumberOfComponents="3" format="appended" offset="0"/></PointData></Piece></ImageData>'
                   '<AppendedData encoding="raw">_'.encode())
        file.write(np.uint64(12 * side**3).tobytes())
        for _ in range(side):
            file.write(layer.tobytes())
        file.write(b"</AppendedData></VTKFile>")


def write_vdb(path, count):
    """The distance to a sphere, in a cube of active voxels."""
    import pyopenvdb

    side, slab = round(count ** (1 / 3)), 80
    x = np.arange(side, dtype=np.float32) - side / 2
    grid = pyopenvdb.FloatGrid(-1e30)
    grid.name = "d"
    for k in range(0, side, slab):
        z = x[k : k + slab]
        grid.copyFromArray(np.sqrt(x[:, None, None] ** 2 + x[None, :, None] ** 2 + z[None, None, :] ** 2) - side / 3, ijk=(0, 0, k))
    pyopenvdb.write(str(path), [grid])


def write_vtu(path, count):
    """Tetrahedra, five of each cube, with the velocity of a vortex at their corners."""
    side = round((count / 5) ** (1 / 3)) + 1
    at = np.linspace(-1, 1, side)
    z, y, x = np.meshgrid(at, at, at, indexing="ij")
    places = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    i = np.arange(side - 1)
    k, j, i = np.meshgrid(i, i, i, indexing="ij")
    corner = [(i + (c & 1) + side * (j + (c >> 1 & 1) + side * (k + (c >> 2)))).ravel() for c in range(8)]
    even = ((i + j + k) % 2 == 0).ravel()
    tetrahedra = {True: [(0, 1, 3, 5), (0, 3, 2, 6), (0, 5, 6, 4), (3, 6, 5, 7), (0, 3, 6, 5)],
                  False: [(1, 0, 4, 2), (1, 2, 7, 3), (1, 4, 5, 7), (2, 4, 6, 7), (1, 2, 4, 7)]}
    cells = np.concatenate([np.stack([corner[c][even == parity] for c in four], axis=-1) for parity in (True, False) for four in tetrahedra[parity]])
    grid, points, connectivity = vtk.vtkUnstructuredGrid(), vtk.vtkPoints(), vtk.vtkCellArray()
    points.SetData(numpy_to_vtk(places, deep=True))
    grid.SetPoints(points)
    connectivity.SetData(numpy_to_vtkIdTypeArray(np.arange(0, 4 * len(cells) + 1, 4, dtype=np.int64), deep=True),
                         numpy_to_vtkIdTypeArray(np.ascontiguousarray(cells, dtype=np.int64).ravel(), deep=True))
    grid.SetCells(vtk.VTK_TETRA, connectivity)
    velocity = numpy_to_vtk(np.stack([-places[:, 1], places[:, 0], np.full(len(places), 0.1)], axis=-1), deep=True)
    velocity.SetName("v")
    grid.GetPointData().SetVectors(velocity)
    write_xml(vtk.vtkXMLUnstructuredGridWriter(), grid, path)


def seed_places():
    at = np.linspace(-0.5, 0.5, 20)
    return np.stack(np.meshgrid(at, at, at, indexing="ij"), axis=-1).reshape(-1, 3)


# Rows of the table


def row_of_reading(program, path, numbers):
    """`numbers`: bytes of them in memory."""
    ours = median_of([measured(program, "info", path)[0] for _ in range(RUNS)])
    by_vtk = None
    if path.suffix in READERS:
        runs = [measured(sys.executable, __file__, "--vtk", path) for _ in range(RUNS)]
        by_vtk = median_of([run | json.loads(told) for run, told in runs])  # without the start of Python
    return {"what": path.name, "numbers": numbers, "ours": ours, "vtk": by_vtk}


def row_of_isosurface(program, path, numbers, folder):
    scene = folder / "sphere.json"
    scene.write_text(json.dumps({"format": "pellucid-scene", "version": 1, "resolution": [500, 500], "objects": [
        {"isosurface": {"file": path.name, "scalar": "d", "value": 0}, "opacity": 0.5}]}))
    ours = median_of([measured(program, "render", scene, "-m", "raytrace", "-o", folder / "sphere.png", "--quiet")[0] for _ in range(RUNS)])
    return {"what": f"isosurface of {path.name}", "numbers": numbers, "ours": ours, "vtk": None}


def row_of_lines(program, path, folder):
    """Streamlines of 8000 seeds on one thread, by Runge and Kutta's steps of one size: ours and vtkStreamTracer's."""
    step, length = 0.002, 2.0  # VTK's in space; ours in time, where the speed is 0.5 on average
    seeds = folder / "seeds.csv"
    seeds.write_text("x,y,z\n" + "".join(f"{x},{y},{z}\n" for x, y, z in seed_places()))
    integrator = f"stream-lines:stepper=rk4,dt={2 * step},cells=1000"
    _, told = measured(program, "trace", "--field", path, "--integrator", integrator, "--seeds", seeds, "--duration", 2 * length,
                       "-o", folder / "lines.vtp", "--threads", "1", "--json", "--quiet")
    ours = json.loads(told)
    ours["steps"] = ours["evaluations"] / 4
    _, told = measured(sys.executable, __file__, "--vtk", path, "--step", step, "--length", length)
    return {"ours": ours, "vtk": json.loads(told)}


def told_of_lines(lines):
    ours, by_vtk = (lines[who]["steps"] / lines[who]["seconds"] for who in ("ours", "vtk"))
    return f"steps of streamlines per second and core: {ours:.0f}, vtkStreamTracer {by_vtk:.0f}, {ours / by_vtk:.1f} times"


def table_row(row):
    vtk_seconds = row["vtk"]["seconds"] if row["vtk"] else None
    cells = [f"`{row['what']}`" if "." in row["what"] and " " not in row["what"] else row["what"], f"{row['numbers'] / 1e9:.2f}", f"{row['ours']['seconds']:.1f}",
             f"{vtk_seconds:.1f}" if vtk_seconds else "", f"{row['ours']['seconds'] / vtk_seconds:.2f}" if vtk_seconds else "",
             f"{row['ours']['bytes'] / row['numbers']:.2f}", f"{row['vtk']['bytes'] / row['numbers']:.2f}" if row["vtk"] else ""]
    return "| " + " | ".join(cells) + " |"


def main():
    names = ["vtp", "ply", "csv", "vti", "vdb", "vtu"]  # each has a write_…()
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(names))
    parser.add_argument("--share", type=float, default=1, help="of the numbers of points, voxels and cells")
    parser.add_argument("--program", default="build/release/pellucid")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="folder that keeps the files and large-files.json")
    parser.add_argument("--vtk", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--step", type=float, help=argparse.SUPPRESS)
    parser.add_argument("--length", type=float, help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    if unknown := set(arguments.names) - set(names):
        parser.error(f"'{unknown.pop()}'; accepted: {', '.join(names)}")
    arguments.names = arguments.names or names
    if arguments.vtk and arguments.step:
        return trace_by_vtk(arguments.vtk, seed_places(), arguments.step, arguments.length)
    if arguments.vtk:
        return time_reading(arguments.vtk)
    if arguments.output:
        arguments.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        run(arguments, arguments.output or pathlib.Path(temporary))


def run(arguments, folder):
    counts = {"vtp": POINTS, "ply": POINTS, "csv": POINTS, "vti": IMAGE, "vdb": VOXELS, "vtu": CELLS}
    bytes_each = {"vtp": 16, "ply": 16, "csv": 32, "vti": 12, "vdb": 4, "vtu": 4 * 8 + 8 + 1 + 24 / 5 + 24 / 5}
    results = {"rows": []}
    print("| | GB of numbers | s | VTK [s] | times VTK's | memory, times the numbers | VTK's |\n|" + "---|" * 7)
    for name in arguments.names:
        path, count = folder / f"large.{name}", int(arguments.share * counts[name])
        if not path.exists():
            print(f"writing {path}", file=sys.stderr)
            globals()[f"write_{name}"](path, count)
        rows = [row_of_reading(arguments.program, path, count * bytes_each[name])]
        if name == "vdb":
            rows.append(row_of_isosurface(arguments.program, path, count * bytes_each[name], folder))
        for row in rows:
            print(table_row(row), flush=True)
        results["rows"] += rows
        if name == "vtu":
            results["lines"] = row_of_lines(arguments.program, path, folder)
            print(f"\n{told_of_lines(results['lines'])}")
    if arguments.output:
        (arguments.output / "large-files.json").write_text(json.dumps(results, indent=1))


if __name__ == "__main__":
    main()
