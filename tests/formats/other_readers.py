# SPDX-License-Identifier: GPL-3.0-or-later
"""Readers that have nothing of Pellucid: assimp, VTK's and nibabel's Python, meshio, netCDF4, mrcfile, plain NumPy. A
mesh is its triangles' corners, (n, 3, 3), and their colours or None; other data are Samples."""

import os
import re
import subprocess
import tempfile
from typing import NamedTuple

import numpy as np


class Samples(NamedTuple):
    """`means` are those over each cell's corners, `centres` the mean of their places; `choice` is what stands behind
    the file's name to get them."""
    points: np.ndarray
    counts: dict
    data: dict = {}
    centres: np.ndarray = np.zeros((0, 3))
    means: dict = {}
    choice: str = "time=first"


# --- PLY, by NumPy ----------------------------------------------------------------------------


TYPES = {"float": "f4", "float32": "f4", "double": "f8", "uchar": "u1", "uint8": "u1", "uint": "u4", "int": "i4"}


def of_texts(rows, fields):
    words = np.array([row.split() for row in rows], dtype=float)
    elements, column = np.zeros(len(words), fields), 0
    for name in elements.dtype.names:
        width = elements[name][0].size
        elements[name] = words[:, column:column + width].reshape(elements[name].shape)
        column += width
    return elements


def ply_elements(path):
    """The elements of a PLY file, texts without lists, lists of three alone."""
    content = open(path, "rb").read()
    head, body = re.split(rb"end_header\r?\n", content, maxsplit=1)
    elements, offset = {}, 0
    for name, count, lines in re.findall(r"element (\w+) (\d+)\r?\n((?:property .*\n)*)", head.decode()):
        fields = []
        for line in lines.splitlines():
            words = line.split()
            fields += [("count", TYPES[words[2]]), (words[-1], TYPES[words[3]], 3)] if words[1] == "list" else \
                [(words[-1], TYPES[words[1]])]
        if b"format ascii" in head:
            elements[name] = of_texts(body.split(b"\n")[offset:offset + int(count)], fields)
            offset += int(count)
        else:
            elements[name] = np.frombuffer(body, np.dtype(fields).newbyteorder("<"), int(count), offset)
            offset += elements[name].nbytes
    return elements


def ply_vertices(path):
    return ply_elements(path)["vertex"]


def positions(vertices):
    return np.stack([vertices[axis].astype(float) for axis in "xyz"], axis=1)


def ply_triangles(path):
    elements = ply_elements(path)
    vertices, faces = elements["vertex"], elements["face"]
    corners = faces[faces.dtype.names[1]]
    colors = None
    if "red" in vertices.dtype.names:
        scale = 255 if vertices.dtype["red"] == np.uint8 else 1
        colors = np.stack([vertices[c].astype(float) / scale for c in ("red", "green", "blue")], axis=1)[corners]
    return positions(vertices)[corners], colors


def ply_points(path):
    points = positions(ply_vertices(path))
    return Samples(points, {"points": len(points)})


# --- Meshes and lines -------------------------------------------------------------------------


def assimp(path):
    with tempfile.TemporaryDirectory() as folder:
        out = os.path.join(folder, "mesh.ply")
        subprocess.run(["assimp", "export", path, out, "-fply", "-tri"], capture_output=True, check=True)
        return ply_triangles(out)


def obj_lines(path):
    vertices, lines = [], []
    for words in (line.split() for line in open(path, encoding="utf-8")):
        if words and words[0] == "v":
            vertices.append([float(word) for word in words[1:4]])
        elif words and words[0] == "l":
            lines.append([int(word.split("/")[0]) - 1 for word in words[1:]])
    points = np.array(vertices)[[vertex for line in lines for vertex in line]]
    return Samples(points, {"lines": len(lines), "points": len(points)})


def tracks(path):
    import nibabel
    lines = [np.asarray(line, float) for line in nibabel.streamlines.load(str(path)).streamlines]
    points = np.concatenate(lines)
    return Samples(points, {"points": len(points), "lines": len(lines)})


# --- Grids ------------------------------------------------------------------------------------


def middle(values, axes):
    """The means of neighbours along the first `axes` axes."""
    for axis in range(axes):
        if values.shape[axis] > 1:
            ends = np.moveaxis(values, axis, 0)
            values = np.moveaxis((ends[1:] + ends[:-1]) / 2, 0, axis)
    return values


def rows(values):
    """Of numbers over three axes, or of vectors."""
    return values.reshape(-1, 3) if values.ndim > 3 else values.ravel()


def grid(points, data):
    """Of arrays over the grid's three axes; points has a fourth."""
    return Samples(points.reshape(-1, 3), {"points": points[..., 0].size}, {k: rows(v) for k, v in data.items()},
                   rows(middle(points, 3)), {k: rows(middle(v, 3)) for k, v in data.items()})


def placed(shape, matrix):
    """The points of voxels by a matrix of 4 by 4, in the order of their indices."""
    indices = np.moveaxis(np.indices(shape), 0, -1)
    return indices @ matrix[:3, :3].T + matrix[:3, 3]


def nifti(path, name="NIFTI"):
    import nibabel
    image = nibabel.load(str(path))
    values = image.get_fdata().reshape((*image.shape, 1)[:3])
    return grid(placed(values.shape, image.affine), {name: values})


def meta_image(path):
    """As ITK's examples have it: along the axes, of bytes."""
    head = dict(re.findall(r"(\w+) = (.*)", open(path, encoding="latin-1").read()))
    sizes = [int(word) for word in head["DimSize"].split()]
    values = np.fromfile(path.parent / head["ElementDataFile"].strip(), np.uint8).reshape(sizes[::-1]).T.astype(float)
    spacing = np.diag([*map(float, head["ElementSpacing"].split()), 1])
    return grid(placed(sizes, spacing), {"MetaImage": values})._replace(means={})  # no field: they are no vectors


def mrc(path):
    import mrcfile
    with mrcfile.open(path) as image:
        matrix = np.diag([*(float(image.voxel_size[axis]) for axis in "xyz"), 1])
        matrix[:3, 3] = [image.header.origin[axis] for axis in "xyz"]
        values = image.data.astype(float).transpose()
    return grid(placed(values.shape, matrix), {"ImageScalars": values})


def axis_of(coordinate):
    """The coordinates; depths are negative."""
    values = np.asarray(coordinate[:], float)
    return -values if getattr(coordinate, "positive", "").lower() == "down" else values


def netcdf(path, *names):
    """The first time of variables whose last axes are z, y, x, or y, x."""
    import netCDF4
    with netCDF4.Dataset(path) as file:
        variables = [file.variables[name] for name in names]
        dimensions = [d for d in variables[0].dimensions if not d.lower().startswith("time")]
        axes = [axis_of(file.variables[d]) for d in dimensions]
        values = [variable[0] if len(variable.dimensions) > len(dimensions) else variable[:] for variable in variables]
    axes = [np.zeros(1)] * (3 - len(axes)) + axes
    shape = [len(axis) for axis in axes]
    points = np.stack(np.meshgrid(*axes, indexing="ij")[::-1], axis=-1)
    arrays = [np.ma.filled(np.ma.asarray(v).astype(float), np.nan).reshape(shape) for v in values]
    return grid(points, dict(zip(names, arrays)))


def netcdf_curved(path, lon, lat, *names):
    """Samples at longitudes and latitudes of their own; cells across the seam, 359 to 1, are left out."""
    import netCDF4
    with netCDF4.Dataset(path) as file:
        x, y, *values = (np.ma.filled(file.variables[name][:].astype(float), np.nan)[None]
                         for name in (lon, lat, *names))
    samples = grid(np.stack([x, y, 0 * x], axis=-1), dict(zip(names, values)))
    across = np.abs(np.diff(x, axis=2)) > 180, np.abs(np.diff(x, axis=1)) > 180
    folded = across[0][:, 1:] | across[0][:, :-1] | across[1][:, :, 1:] | across[1][:, :, :-1]
    return samples._replace(means={name: np.where(folded.ravel(), np.nan, v) for name, v in samples.means.items()})


def plot3d(path):
    """Blocks of floats of Fortran, each with its solution beside it; momenta over densities are the velocity."""
    def records(file):
        content, result, at = file.read_bytes(), [], 0
        while at < len(content):
            length = int.from_bytes(content[at:at + 4], "little")
            result.append(content[at + 4:at + 4 + length])
            at += length + 8
        return result
    blocks = [np.frombuffer(r, "<f4").reshape(3, -1).T for r in records(path)[2:]]
    states = [np.frombuffer(r, "<f4").reshape(5, -1).T for r in records(path.with_suffix(".q"))[3::2]]
    state = np.concatenate(states).astype(float)
    points = np.concatenate(blocks).astype(float)
    means = {"Velocity": np.stack([(s[:, 1:4] / s[:, :1]).mean(axis=0) for s in states]).astype(float)}
    return Samples(points, {"points": len(points), "cells": len(blocks)},
                   {"Density": state[:, 0], "Velocity": state[:, 1:4] / state[:, :1]},
                   np.stack([block.mean(axis=0) for block in blocks]).astype(float), means)


# --- Cells ------------------------------------------------------------------------------------


def cells_of(points, data, cells, counts=None):
    """`cells` are arrays of indices, one row a cell."""
    def means(values):
        return np.concatenate([values[corners].mean(axis=1) for corners in cells])
    counts = counts or {"points": len(points), "cells": sum(len(corners) for corners in cells)}
    return Samples(points, counts, data, means(points), {name: means(values) for name, values in data.items()})


def flat_to_space(points):
    return np.pad(np.asarray(points, float), ((0, 0), (0, 3 - points.shape[1])))


def meshio_file(path, file_format=None):
    import meshio
    mesh = meshio.read(path, file_format)
    data = {name: np.asarray(values, float).squeeze() for name, values in mesh.point_data.items()}
    data = {name: values for name, values in data.items() if values.ndim == 1 or values.shape[1] == 3}
    return cells_of(flat_to_space(mesh.points), data, [block.data for block in mesh.cells])


def exodus(path):
    """By NetCDF alone: its displacements are none."""
    import netCDF4
    with netCDF4.Dataset(path) as file:
        variables = file.variables
        points = np.array(variables["coord"][:], float).T if "coord" in variables else \
            np.stack([np.array(variables["coord" + axis][:], float) for axis in "xyz"], axis=1)
        names = [b"".join(row.compressed()).decode().strip("\0 ") for row in variables["name_nod_var"][:]]
        if "vals_nod_var" in variables:
            values = np.array(variables["vals_nod_var"][0], float)
        else:
            values = [np.array(variables[f"vals_nod_var{i + 1}"][0], float) for i in range(len(names))]
        cells = [np.array(variables[name][:]) - 1 for name in variables if name.startswith("connect")]
    data = dict(zip(names, values))
    vectors = sorted({name[:-1] for name in names if {name[:-1] + c for c in "XYZ"} <= set(names)})
    for vector in vectors:
        data[vector.rstrip("_")] = np.stack([data.pop(vector + c) for c in "XYZ"], axis=1)
    return cells_of(points, data, cells)


def vtk_arrays(attributes):
    from vtk.util.numpy_support import vtk_to_numpy
    arrays = [attributes.GetArray(i) for i in range(attributes.GetNumberOfArrays())]
    return {a.GetName(): vtk_to_numpy(a).astype(float) for a in arrays if a.GetNumberOfComponents() in (1, 3)}


def vtk_cells(data):
    """Volumes by their numbers of corners; voxels and pixels have theirs in another order, which means do not mind."""
    by_size = {}
    volumes = [i for i in range(data.GetNumberOfCells()) if data.GetCell(i).GetCellDimension() == 3]
    for i in volumes:
        ids = data.GetCell(i).GetPointIds()
        by_size.setdefault(ids.GetNumberOfIds(), []).append([ids.GetId(k) for k in range(ids.GetNumberOfIds())])
    return [np.array(rows) for rows in by_size.values()]


def vtk_data(data):
    points = np.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return cells_of(points, vtk_arrays(data.GetPointData()), vtk_cells(data) or [np.zeros((0, 1), int)],
                    {"points": len(points)})


def vtk_file(path):
    import vtk
    reader = {".vti": vtk.vtkXMLImageDataReader, ".vtr": vtk.vtkXMLRectilinearGridReader,
              ".vts": vtk.vtkXMLStructuredGridReader, ".vtk": vtk.vtkDataSetReader}[path.suffix]()
    reader.SetFileName(str(path))
    if path.suffix == ".vtk":
        reader.ReadAllScalarsOn()
        reader.ReadAllVectorsOn()
    reader.Update()
    return vtk_data(reader.GetOutput())
