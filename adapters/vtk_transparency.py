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

import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtk_objects import poly_data, set_camera, width_in_pixels
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkWindowToImageFilter)


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
    if pixels := width_in_pixels(thing, scene):
        actor.GetProperty().SetLineWidth(pixels)
        actor.GetProperty().SetPointSize(pixels)
    return actor


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
