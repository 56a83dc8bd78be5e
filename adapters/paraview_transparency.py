#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""ParaView draws an exported scene: paraview_transparency.py PEELS SCENE.json OUTPUT.png, by Debian's python3-paraview.

PEELS is the render view's MaximumNumberOfPeels; ParaView's own setting is 4. Lines and points are of the width in whole pixels,
everything unlit. ParaView needs a display, which has to stay as it is from one program to the next:

    xvfb-run -a -s -noreset pellucid conform --output png --command \\
        '/usr/bin/python3 adapters/paraview_transparency.py 4 {scene} {output}'
"""

import json
import sys
import time
from pathlib import Path

from paraview import simple
from vtk_objects import poly_data, set_camera, width_in_pixels


def show(thing, scene, folder, view):
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(poly_data(thing, folder))
    drawn = simple.Show(source, view)
    drawn.Representation = "Points" if thing["kind"] == "points" else "Surface"
    drawn.ColorArrayName = ["POINTS", "rgba"]
    drawn.MapScalars = 0  # they are colours
    drawn.Ambient, drawn.Diffuse, drawn.Specular = 1, 0, 0
    if pixels := width_in_pixels(thing, scene):
        drawn.LineWidth = drawn.PointSize = pixels


def main(peels, scene_file, output):
    simple._DisableFirstRenderCameraReset()
    scene = json.loads(Path(scene_file).read_text())
    view = simple.CreateRenderView(ViewSize=scene["resolution"], DepthPeeling=1, MaximumNumberOfPeels=int(peels), MultiSamples=0,
                                   UseFXAA=0, OrientationAxesVisibility=0, UseColorPaletteForBackground=0,
                                   Background=scene["background"])
    for thing in scene["objects"]:
        show(thing, scene, Path(scene_file).parent, view)
    set_camera(simple.GetActiveCamera(), scene["camera"])
    simple.Render(view)
    start = time.perf_counter()
    simple.Render(view)
    seconds = time.perf_counter() - start
    simple.SaveScreenshot(output, view, ImageResolution=scene["resolution"], OverrideColorPalette="")
    Path(output + ".json").write_text(json.dumps({"ms": 1e3 * seconds}))


main(*sys.argv[1:])
