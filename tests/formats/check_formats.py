#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Follows particles through fields that other programs' files hold. PELLUCID_PROGRAM is the program; exits with 77,
which CTest takes for skipped, where VTK or SciPy for Python are missing. Files of Debian's packages are read where
PELLUCID_DEBIAN_DATA names a folder that they were unpacked in (dpkg -x)."""

import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import vtk
    import written_files
    from scipy.io import netcdf_file
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

PROGRAM = os.environ.get("PELLUCID_PROGRAM", "build/release/pellucid")
TURN = 2 * math.pi
failures = []


def trace(field, seed, duration, *options):
    """The line's points, or what the program complains of."""
    with tempfile.TemporaryDirectory() as folder:
        line = os.path.join(folder, "line.vtp")
        call = [PROGRAM, "trace", "--field", str(field), "--integrator", "path-lines:particles=1",
                "--seed", ",".join(map(repr, seed)), "--duration", repr(duration), "-o", line, "--json", *options]
        run = subprocess.run(call, capture_output=True, text=True, check=False)
        if run.returncode != 0:
            return None, run.stderr.strip()
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(line)
        reader.Update()
        points = reader.GetOutput()
        return [points.GetPoint(i) for i in range(points.GetNumberOfPoints())], json.loads(run.stdout)["field"]


def expect(name, end, wanted, tolerance):
    off = math.dist(end, wanted) if end else math.inf
    print(f"{'ok  ' if off <= tolerance else 'FAIL'} {name}: {off:.2g} off, at most {tolerance:.2g}")
    if off > tolerance:
        failures.append(name)


def check_end(name, field, wanted, tolerance, seed=(1.0, 0.0, 0.0), duration=TURN, *options):
    points, told = trace(field, seed, duration, *options)
    if points is None:
        print(told)
    expect(name, points and points[-1], wanted, tolerance)


def check_written(folder):
    """A turn around the axis, exact for all linear interpolation. Numbers are kept in floats at least, 1e-7 of the
    velocity, for a way of 2 pi."""
    rounding = 1e-5
    for write in written_files.STEADY:
        check_end(write.__name__, folder / write(folder), (1, 0, 0.1 * TURN), rounding)
    # VTK's writer leaves the origin out: the axis is at (2, 2), the middle at z = 1.
    check_end("nifti", folder / written_files.write_nifti(folder), (3, 2, 0.1 * TURN + 0.2), rounding,
              (3.0, 2.0, 0.2))
    # The angle is the integral of 1 + t from 0 to 1.
    angle = 1.5
    check_end("netcdf_times", folder / written_files.write_netcdf_times(folder),
              (math.cos(angle), math.sin(angle), 0.1 * angle), rounding, (1.0, 0.0, 0.0), 1.0)
    # Means of cells are exact inside, for linear fields; at t = 1 the velocity is twice that at t = 0.
    foam = folder / written_files.write_foam(folder)
    check_end("foam", foam, (math.cos(angle), math.sin(angle), 0.1 * angle), rounding, (1.0, 0.0, 0.0), 1.0)
    check_end("foam_last", f"{foam}:time=last,block=internalMesh", (1, 0, 0.1 * TURN), rounding, (1.0, 0.0, 0.0),
              TURN / 2)


def check_left_out(folder):
    """What a grid of three axes has no room for is said."""
    told = subprocess.run([PROGRAM, "info", str(folder / "turned.nc")], capture_output=True, text=True, check=False)
    if "left out: [\"ground(nx, ny): it has other dimensions\"]" not in told.stdout:
        failures.append("left out")
        print(f"FAIL left out: {told.stdout}{told.stderr}")


def bilinear(values, x, y):
    i, j = int(x), int(y)
    s, t = x - i, y - j
    east = (i + 1) % values.shape[1]
    return ((1 - t) * ((1 - s) * values[j, i] + s * values[j, east]) +
            t * ((1 - s) * values[j + 1, i] + s * values[j + 1, east]))


def check_winds(path):
    """A wind of ferret-datasets across 360 degrees, against Euler steps through SciPy's numbers."""
    data = netcdf_file(path, "r", mmap=False)
    step = 100
    u, v = (np.array(data.variables[name][step], dtype=float) for name in ("UWND", "VWND"))
    longitude, latitude = (np.array(data.variables[name][:], dtype=float) for name in ("FNOCX", "FNOCY"))
    time = data.variables["TIME"][step]
    width, height = longitude[1] - longitude[0], latitude[1] - latitude[0]
    x, y, count, duration = 375.0, -45.0, 20000, 3.0
    for _ in range(count):
        place = ((x - longitude[0]) % 360) / width, (y - latitude[0]) / height
        x, y = x + duration / count * bilinear(u, *place), y + duration / count * bilinear(v, *place)
    # Euler's error is about h/2 |a| T: winds of 10, changing by 1 a degree.
    check_end("navy winds", f"{path}:array=UWND,VWND,time={time!r}", (x, y, 0), 5e-3, (375.0, -45.0, 0.0), duration)


def check_disk(path):
    """Mayavi's rotating disk, against VTK's probe along the line: dx/dt is what VTK interpolates."""
    points, _ = trace(f"{path}:array=V,time=last", (2.0, 1.0, 3.0), 0.02)
    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(reader.NODAL, 1)
    reader.Update()
    grid = reader.GetOutput().GetBlock(0).GetBlock(0)
    locator = vtk.vtkStaticCellLocator()
    locator.SetDataSet(grid)
    cell, place, weights = vtk.vtkGenericCell(), [0.0] * 3, [0.0] * 8
    x, count = np.array([2.0, 1.0, 3.0]), 2000
    for _ in range(count):
        locator.FindCell(x, 0, cell, place, weights)
        vectors = grid.GetPointData().GetArray("V")
        velocity = sum(weights[k] * np.array(vectors.GetTuple3(cell.GetPointId(k)))
                       for k in range(cell.GetNumberOfPoints()))
        x = x + 0.02 / count * velocity
    way = math.dist(x, (2.0, 1.0, 3.0))
    expect("rotating disk", points and points[-1], tuple(x), 1e-3 * way)


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_written(pathlib.Path(folder))
        check_left_out(pathlib.Path(folder))
    data = os.environ.get("PELLUCID_DEBIAN_DATA")
    if data:
        check_winds(next(pathlib.Path(data).rglob("monthly_navy_winds.cdf")))
        check_disk(next(pathlib.Path(data).rglob("disk_out_ref.ex2")))
    sys.exit(1 if failures else 0)


if __name__ == "__main__":
    main()
