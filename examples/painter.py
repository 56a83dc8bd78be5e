#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A method of one's own: painter.py SCENE.json OUTPUT.png draws an exported scene's triangles, the farthest first.

Whole triangles are sorted by their mean depth, so that it is wrong where they go through one another, and fast where a
program sorts anyway. What it costs it tells in OUTPUT.png.json."""

import json
import struct
import sys
import time
import zlib
from pathlib import Path

import numpy


def read_triangles(folder, thing):
    """Corners (n × 3 × 3) and colours (n × 3 × 4) of a PLY file of `pellucid export`."""
    header, _, body = (folder / thing["file"]).read_bytes().partition(b"end_header\n")
    names = [line.split()[2] for line in header.decode().split("element face")[0].splitlines() if line.startswith("property")]
    vertices = numpy.frombuffer(body, "<f4", thing["vertices"] * len(names)).reshape(-1, len(names)).astype(float)
    corners = numpy.frombuffer(body[vertices.size * 4:], [("n", "u1"), ("v", "<u4", 3)], thing["count"])["v"]
    of = lambda *columns: vertices[:, [names.index(column) for column in columns]][corners]
    return of("x", "y", "z"), of("red", "green", "blue", "alpha")


def draw(picture, corner, color):
    """Blends a triangle, in pixels, over the pixels whose centres lie in it."""
    height, width = picture.shape[:2]
    low = numpy.maximum(numpy.floor(corner.min(0)).astype(int), 0)
    high = numpy.minimum(numpy.ceil(corner.max(0)).astype(int), [width, height])
    if (low >= high).any():
        return
    x, y = numpy.meshgrid(numpy.arange(low[0], high[0]) + 0.5, numpy.arange(low[1], high[1]) + 0.5)
    (ax, ay), (bx, by), (cx, cy) = corner
    area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
    u = ((bx - x) * (cy - y) - (by - y) * (cx - x)) / (area or 1)
    v = ((cx - x) * (ay - y) - (cy - y) * (ax - x)) / (area or 1)
    inside = (u >= 0) & (v >= 0) & (u + v < 1) & (area != 0)
    shade = u[..., None] * color[0] + v[..., None] * color[1] + (1 - u - v)[..., None] * color[2]
    alpha = numpy.where(inside, shade[..., 3], 0)[..., None]
    part = picture[low[1]:high[1], low[0]:high[0]]
    part += alpha * (shade[..., :3] - part)


def main(scene_file, output):
    scene = json.loads(Path(scene_file).read_text())
    width, height = scene["resolution"]
    clip_from_world = numpy.array(scene["camera"]["projection"]) @ numpy.array(scene["camera"]["view"])
    parts = [read_triangles(Path(scene_file).parent, thing) for thing in scene["objects"] if thing["kind"] == "triangles"]
    corners, colors = (numpy.concatenate(arrays) for arrays in zip(*parts))
    start = time.perf_counter()
    clip = numpy.append(corners, numpy.ones((*corners.shape[:2], 1)), 2) @ clip_from_world.T
    seen = clip[..., :3] / clip[..., 3:]
    pixels = (seen[..., :2] * [1, -1] + 1) / 2 * [width, height]
    order = numpy.argsort(-seen[..., 2].mean(1))
    sorted_at = time.perf_counter()
    picture = numpy.tile(numpy.array(scene["background"]), (height, width, 1))
    for i in order[(clip[order][..., 3] > 0).all(1)]:
        draw(picture, pixels[i], colors[i])
    end = time.perf_counter()
    rows = numpy.round(picture.clip(0, 1) * 255).astype(numpy.uint8)
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    Path(output).write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">2I5B", width, height, 8, 2, 0, 0, 0)) +
                             chunk(b"IDAT", zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows))) + chunk(b"IEND", b""))
    Path(output + ".json").write_text(json.dumps({
        "ms": 1e3 * (end - start), "steps": {"sort": 1e3 * (sorted_at - start), "blend": 1e3 * (end - sorted_at)},
        "bytes": picture.nbytes + order.nbytes + pixels.nbytes}))


main(*sys.argv[1:])
