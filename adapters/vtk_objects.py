# SPDX-License-Identifier: GPL-3.0-or-later
"""What VTK and ParaView share: objects and camera of an exported scene (docs/exported-scene.md) as VTK's."""

import numpy
from exported_scene import cells, columns, read_ply
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData


def poly_data(thing, folder):
    """Its colours, of four floats, are the points' scalars, named `rgba`."""
    ply = read_ply(folder / thing["file"])
    joined = cells(ply, thing["kind"])
    data, points, array = vtkPolyData(), vtkPoints(), vtkCellArray()
    points.SetData(numpy_to_vtk(columns(ply["vertex"], "x", "y", "z"), deep=True))
    data.SetPoints(points)
    counted = numpy.concatenate([numpy.full((len(joined), 1), joined.shape[1]), joined], 1).astype(numpy.int64)
    array.ImportLegacyFormat(numpy_to_vtkIdTypeArray(counted.ravel(), deep=True))
    {"triangles": data.SetPolys, "lines": data.SetLines, "points": data.SetVerts}[thing["kind"]](array)
    colors = columns(ply["vertex"], "red", "green", "blue", "alpha")
    if thing["opaque"]:
        colors[:, 3] = 1  # whatever its opacity: VTK would blend it
    scalars = numpy_to_vtk(colors, deep=True)
    scalars.SetName("rgba")
    data.GetPointData().SetScalars(scalars)
    return data


def width_in_pixels(thing, scene):
    """Of lines and points, as VTK draws them, one pixel at least; nothing of triangles."""
    if thing["radius"]:
        return max(1, 2 * thing["radius"] * scene["resolution"][1] / scene["camera"].get("height", 2))
    return None


def set_camera(camera, wanted):
    camera.SetPosition(wanted["eye"])
    camera.SetFocalPoint(wanted["target"])
    camera.SetViewUp(wanted["up"])
    camera.SetClippingRange(wanted["near"], wanted["far"])
    if "fov" in wanted:
        camera.SetViewAngle(wanted["fov"])
    else:
        camera.ParallelProjectionOn()
        camera.SetParallelScale(wanted["height"] / 2)
