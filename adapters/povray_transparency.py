#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""POV-Ray draws an exported scene: povray_transparency.py SCENE.json OUTPUT.png, by Debian's povray. The picture has 16 bits a
channel (.exr: half floats).

    pellucid conform --output png --command '/usr/bin/python3 adapters/povray_transparency.py {scene} {output}'

Ribbons are the triangles that docs/exported-scene.md makes of them, the tube of a line merged cones and spheres, discs and
spheres POV-Ray's own, each segment and point of one colour. Over a triangle POV-Ray interpolates what its corners give, colours times
opacity, where the exported scene interpolates both by themselves: the same where a triangle has one of each.
"""

import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy

from exported_scene import cells, columns, read_ply, ribbon_triangles

DEEPEST = 256  # POV-Ray allows no more


def vector(numbers):
    return "<" + ",".join(f"{float(number):.17g}" for number in numbers) + ">"


def texture(rgba, opaque):
    """Light of its own, and of what lies behind it the share that it lets through."""
    return f"texture{{pigment{{rgbt {vector([*rgba[:3], 0 if opaque else 1 - rgba[3]])}}}finish{{emission 1 ambient 0 diffuse 0}}}}"


def mesh(positions, triangles, colors, opaque):
    """A texture for each colour. Between three textures POV-Ray goes on behind each of them by itself, 3^n times behind n
    layers: corners of one colour give the triangle one."""
    unique, of_vertex = numpy.unique(colors, axis=0, return_inverse=True)
    textures = of_vertex.ravel()[triangles]
    faces = ",".join(f"{vector(t)},{of[0] if len(set(of)) == 1 else ','.join(map(str, of))}" for t, of in zip(triangles, textures))
    return (f"mesh2{{vertex_vectors{{{len(positions)},{','.join(map(vector, positions))}}}"
            f"texture_list{{{len(unique)},{' '.join(texture(rgba, opaque) for rgba in unique)}}}"
            f"face_indices{{{len(triangles)},{faces}}}}}")


def frustum(a, b, radius_a, radius_b):
    """What lies between two balls, around their common tangents; nothing where one holds the other."""
    axis = b - a
    length = numpy.linalg.norm(axis)
    if length <= abs(radius_a - radius_b):
        return None
    axis, sine = axis / length, (radius_a - radius_b) / length
    cosine = numpy.sqrt(1 - sine * sine)
    return (f"cone{{{vector(a + radius_a * sine * axis)},{radius_a * cosine:.17g},"
            f"{vector(b + radius_b * sine * axis)},{radius_b * cosine:.17g}")


def tubes(vertices, segments, radius, opaque):
    """A solid for each line."""
    x, colors = columns(vertices, "x", "y", "z").astype(float), columns(vertices, "red", "green", "blue", "alpha")
    parts = {}
    for a, b in segments:
        if shape := frustum(x[a], x[b], radius[a], radius[b]):
            parts.setdefault(vertices["line"][a], []).append(f"{shape} {texture((colors[a] + colors[b]) / 2, opaque)}}}")
    for p, r, color, line in zip(x, radius, colors, vertices["line"]):
        if r > 0:
            parts.setdefault(line, []).append(f"sphere{{{vector(p)},{r:.17g} {texture(color, opaque)}}}")
    return " ".join(f"merge{{{' '.join(of_line)}}}" for of_line in parts.values())


def points(vertices, radius, forward, profile, opaque):
    x, colors = columns(vertices, "x", "y", "z"), columns(vertices, "red", "green", "blue", "alpha")
    shape = ((lambda p, r: f"sphere{{{vector(p)},{r:.17g}") if profile == "sphere" else
             (lambda p, r: f"disc{{{vector(p)},{vector(forward)},{r:.17g}"))
    return " ".join(f"{shape(p, r)} {texture(c, opaque)}}}" for p, r, c in zip(x, radius, colors))


def shape_of(thing, scene, folder):
    ply, opaque = read_ply(folder / thing["file"]), thing["opaque"]
    vertices, camera = ply["vertex"], scene["camera"]
    joined = cells(ply, thing["kind"])
    forward = -numpy.array(camera["view"][2][:3])
    if thing["kind"] == "triangles":
        return mesh(columns(vertices, "x", "y", "z"), joined, columns(vertices, "red", "green", "blue", "alpha"), opaque)
    radius = vertices["radius"].astype(float) if thing["radius"] is None else numpy.full(len(vertices), thing["radius"])
    if thing["kind"] == "points":
        return points(vertices, radius, forward, thing["profile"], opaque)
    if thing["profile"] == "tube":
        return tubes(vertices, joined, radius, opaque)
    return mesh(*ribbon_triangles(vertices, joined, radius, numpy.array(camera["eye"]) if "fov" in camera else None, forward), opaque)


def camera_of(scene):
    camera, (width, height) = scene["camera"], scene["resolution"]
    right, up, back = (numpy.array(row[:3]) for row in camera["view"][:3])
    size = 2 * numpy.tan(numpy.radians(camera["fov"]) / 2) if "fov" in camera else camera["height"]
    kind = "" if "fov" in camera else "orthographic "
    return (f"camera{{{kind}location {vector(camera['eye'])} direction {vector(-back)} "
            f"up {vector(size * up)} right {vector(size * width / height * right)}}}")


def main(scene_file, output):
    scene = json.loads(Path(scene_file).read_text())
    text = [f"#version 3.7; global_settings{{assumed_gamma 1 max_trace_level {DEEPEST} adc_bailout 0}}",
            f"background{{rgb {vector(scene['background'])}}}", camera_of(scene),
            *(shape_of(thing, scene, Path(scene_file).parent) for thing in scene["objects"])]
    width, height = scene["resolution"]
    with tempfile.TemporaryDirectory() as folder:
        source = Path(folder) / "scene.pov"
        source.write_text("\n".join(text))
        start = time.perf_counter()
        subprocess.run(["povray", f"+I{source}", f"+O{output}", f"+W{width}", f"+H{height}", "+FE" if output.endswith(".exr") else "+FN16",
                        "File_Gamma=1.0", "-A", "-D", "-P", "-GA", "Output_Alpha=off"], check=True, stdin=subprocess.DEVNULL, capture_output=True, cwd=folder)
        Path(output + ".json").write_text(json.dumps({"ms": 1e3 * (time.perf_counter() - start)}))


main(*sys.argv[1:])
