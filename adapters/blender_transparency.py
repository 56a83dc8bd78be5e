#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Blender's Cycles draws an exported scene: blender_transparency.py SCENE.json OUTPUT.exr, by Debian's blender on the CPU. The
picture has floats (.png: 16 bits a channel).

    pellucid conform --output exr --command '/usr/bin/python3 adapters/blender_transparency.py {scene} {output}'

One ray a pixel through its centre, surfaces that emit their colour and let through what their opacity leaves, as many of them as
Cycles follows a ray through. Ribbons are the triangles that docs/exported-scene.md makes of them, discs polygons, spheres and tubes
are refused.
"""

import json
import subprocess
import sys
import time
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).parent))
from exported_scene import cells, columns, read_ply, ribbon_triangles

DEEPEST = 1024  # Cycles allows no more
CORNERS = 128  # of a disc: it lacks 4e-4 of its area


def discs(x, colors, radius, right, up):
    """A fan of triangles for each point."""
    angles = numpy.linspace(0, 2 * numpy.pi, CORNERS, endpoint=False)
    rim = numpy.outer(numpy.cos(angles), right) + numpy.outer(numpy.sin(angles), up)
    corners = numpy.concatenate([numpy.zeros((1, 3)), rim])
    around = numpy.arange(CORNERS)
    fan = numpy.stack([numpy.zeros(CORNERS, int), 1 + around, 1 + (around + 1) % CORNERS], -1)
    of_point = len(corners) * numpy.arange(len(x))
    return ((x[:, None] + radius[:, None, None] * corners).reshape(-1, 3), (of_point[:, None, None] + fan).reshape(-1, 3),
            numpy.repeat(colors, len(corners), 0))


def triangles_of(thing, scene, folder):
    """Positions, triangles and colours."""
    ply, camera = read_ply(folder / thing["file"]), scene["camera"]
    vertices, joined = ply["vertex"], cells(ply, thing["kind"])
    x, colors = columns(vertices, "x", "y", "z").astype(float), columns(vertices, "red", "green", "blue", "alpha")
    if thing["kind"] == "triangles":
        return x, joined, colors
    if thing["profile"] in ("tube", "sphere"):
        sys.exit(f"{thing['name']}: it is round; accepted: triangles, ribbons, discs")
    radius = vertices["radius"].astype(float) if thing["radius"] is None else numpy.full(len(vertices), thing["radius"])
    right, up, back = (numpy.array(row[:3]) for row in camera["view"][:3])
    if thing["kind"] == "points":
        return discs(x, colors, radius, right, up)
    return ribbon_triangles(vertices, joined, radius, numpy.array(camera["eye"]) if "fov" in camera else None, -back)


def material(bpy, opaque):
    """Emits what the attribute layer_color says, layer_opacity of it; the rest comes through."""
    made = bpy.data.materials.new("layer")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    color, emission, output = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeOutputMaterial")
    color.attribute_name = "layer_color"
    links.new(color.outputs["Vector"], emission.inputs["Color"])
    if opaque:
        links.new(emission.outputs[0], output.inputs["Surface"])
        return made
    opacity, through, mix = nodes.new("ShaderNodeAttribute"), nodes.new("ShaderNodeBsdfTransparent"), nodes.new("ShaderNodeMixShader")
    opacity.attribute_name = "layer_opacity"
    for start, end in ((opacity.outputs["Fac"], mix.inputs[0]), (through.outputs[0], mix.inputs[1]),
                       (emission.outputs[0], mix.inputs[2]), (mix.outputs[0], output.inputs["Surface"])):
        links.new(start, end)
    return made


def add_mesh(bpy, positions, triangles, colors, opaque):
    mesh = bpy.data.meshes.new("layer")
    mesh.from_pydata(positions.tolist(), [], triangles.tolist())
    mesh.attributes.new("layer_color", "FLOAT_VECTOR", "POINT").data.foreach_set("vector", colors[:, :3].astype("f4").ravel())
    mesh.attributes.new("layer_opacity", "FLOAT", "POINT").data.foreach_set("value", colors[:, 3].astype("f4"))
    mesh.materials.append(material(bpy, opaque))
    bpy.context.scene.collection.objects.link(bpy.data.objects.new("layer", mesh))


def add_camera(bpy, scene):
    camera, made = scene["camera"], bpy.data.cameras.new("camera")
    made.sensor_fit = "VERTICAL"
    if "fov" in camera:
        made.angle = numpy.radians(camera["fov"])
    else:
        made.type, made.ortho_scale = "ORTHO", camera["height"]
    depth = scene["depth"]
    made.clip_start, made.clip_end = max(1e-6, 0.5 * depth["near"]), 2 * depth["far"]
    placed = bpy.data.objects.new("camera", made)
    placed.matrix_world = numpy.linalg.inv(numpy.array(camera["view"])).T.tolist()  # a list of columns
    bpy.context.scene.collection.objects.link(placed)
    bpy.context.scene.camera = placed


def set_up(bpy, scene, output):
    drawn = bpy.context.scene
    drawn.render.engine = "CYCLES"
    drawn.render.resolution_x, drawn.render.resolution_y = scene["resolution"]
    drawn.render.resolution_percentage = 100
    drawn.view_settings.view_transform = "Raw"
    cycles = drawn.cycles
    cycles.device, cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = "CPU", 1, False, False
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 0.01  # Cycles has no narrower one
    cycles.transparent_max_bounces = cycles.min_transparent_bounces = DEEPEST
    drawn.world = bpy.data.worlds.new("background")
    drawn.world.use_nodes = True
    drawn.world.node_tree.nodes["Background"].inputs["Color"].default_value = (*scene["background"], 1)
    settings = drawn.render.image_settings
    settings.file_format, settings.color_mode = ("OPEN_EXR" if output.endswith(".exr") else "PNG"), "RGB"
    settings.color_depth = "32" if output.endswith(".exr") else "16"
    drawn.render.filepath = output


def draw(scene_file, output):
    """Within Blender."""
    import bpy  # noqa: PLC0415: there is none outside

    scene = json.loads(Path(scene_file).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    set_up(bpy, scene, output)
    add_camera(bpy, scene)
    for thing in scene["objects"]:
        add_mesh(bpy, *triangles_of(thing, scene, Path(scene_file).parent), thing["opaque"])
    start = time.perf_counter()
    bpy.ops.render.render(write_still=True)
    Path(output + ".json").write_text(json.dumps({"ms": 1e3 * (time.perf_counter() - start)}))


if "--" in sys.argv:
    draw(*sys.argv[sys.argv.index("--") + 1:])
else:
    scene_file, output = (str(Path(name).resolve()) for name in sys.argv[1:])
    done = subprocess.run(["blender", "--background", "--factory-startup", "--python-exit-code", "1", "--python", __file__, "--",
                           scene_file, output], stdin=subprocess.DEVNULL, capture_output=True, text=True)
    if done.returncode or not Path(output).exists():
        sys.exit(done.stderr.strip() or done.stdout.strip()[-400:])
