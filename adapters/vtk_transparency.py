#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""VTK draws an exported scene: vtk_transparency.py MODE SCENE.json OUTPUT.png, by Debian's python3-vtk9.

MODE is `oit`, VTK's order-independent pass, or the largest number of peels of its dual depth peeling, `4` or `100`.
Lines and points are VTK's own, of the width in whole pixels. VTK needs a display:

    xvfb-run -a pellucid conform --output png --command \\
        '/usr/bin/python3 adapters/vtk_transparency.py 100 {scene} {output}'
"""

import json
import sys
import time
from pathlib import Path

import numpy
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)

from exported_scene import cells, columns, read_ply


def poly_data(thing, folder):
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
    data.GetPointData().SetScalars(numpy_to_vtk(colors, deep=True))
    return data


def actor_of(thing, scene, folder):
    mapper, actor = vtkPolyDataMapper(), vtkActor()
    mapper.SetInputData(poly_data(thing, folder))
    mapper.SetColorModeToDirectScalars()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    if thing["opaque"]:
        actor.ForceOpaqueOn()
    else:
        actor.ForceTranslucentOn()
    if thing["radius"]:
        pixels = 2 * thing["radius"] * scene["resolution"][1] / scene["camera"].get("height", 2)
        actor.GetProperty().SetLineWidth(max(1, pixels))
        actor.GetProperty().SetPointSize(max(1, pixels))
    return actor


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


def main(mode, scene_file, output):
    scene = json.loads(Path(scene_file).read_text())
    renderer, window = vtkRenderer(), vtkRenderWindow()
    renderer.SetBackground(scene["background"])
    for thing in scene["objects"]:
        renderer.AddActor(actor_of(thing, scene, Path(scene_file).parent))
    set_camera(renderer.GetActiveCamera(), scene["camera"])
    window.OffScreenRenderingOn()
    window.SetMultiSamples(0)
    window.SetAlphaBitPlanes(1)
    window.SetSize(scene["resolution"])
    window.AddRenderer(renderer)
    if mode != "oit":
        renderer.UseDepthPeelingOn()
        renderer.SetMaximumNumberOfPeels(int(mode))
        renderer.SetOcclusionRatio(0)
    window.Render()
    start = time.perf_counter()
    window.Render()
    window.WaitForCompletion()
    seconds = time.perf_counter() - start
    grab, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(output)
    writer.Write()
    Path(output + ".json").write_text(json.dumps({"ms": 1e3 * seconds}))


main(*sys.argv[1:])
