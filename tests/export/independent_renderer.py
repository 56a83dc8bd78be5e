#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A renderer of exported scenes that shares no code with the program: independent_renderer.py SCENE.json OUTPUT.exr.

It knows scene.json and the PLY files alone: rays through pixel centres, triangles (of meshes, and of ribbons, which it
makes itself) and discs, all fragments of a pixel sorted by depth and composited, in double."""

import json
import sys
from pathlib import Path

import numpy

import exr


def read_ply(path):
    """The vertices by property, and the corners of the faces."""
    content = Path(path).read_bytes()
    header, _, body = content.partition(b"end_header\n")
    types = {"float": "<f4", "uint": "<u4"}
    elements = []
    for line in header.decode().splitlines():
        words = line.split()
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].extend([("n", "u1"), ("corners", "<u4", 3)])
        elif words[0] == "property":
            elements[-1][2].append((words[2], types[words[1]]))
    read, at = {}, 0
    for name, count, properties in elements:
        read[name] = numpy.frombuffer(body, numpy.dtype(properties), count, at)
        at += read[name].nbytes
    return read


def columns(vertices, *names):
    return numpy.stack([vertices[name].astype(float) for name in names], -1)


class View:
    """The rays of the pixels, and the points of view space: x right, y up, z the depth."""

    def __init__(self, scene):
        self.width, self.height = scene["resolution"]
        rows = numpy.array(scene["camera"]["view"])
        self.turn, self.move = rows[:3, :3] * [[1], [1], [-1]], rows[:3, 3] * [1, 1, -1]
        self.perspective = "fov" in scene["camera"]
        half = numpy.tan(numpy.radians(scene["camera"]["fov"]) / 2) if self.perspective else scene["camera"]["height"] / 2
        self.pixel = 2 * half / self.height
        self.x = (numpy.arange(self.width) + 0.5 - self.width / 2) * self.pixel
        self.y = (self.height / 2 - numpy.arange(self.height) - 0.5) * self.pixel

    def of_world(self, x):
        return x @ self.turn.T + self.move

    def origins_and_directions(self):
        x, y = numpy.meshgrid(self.x, self.y)
        flat, one = numpy.zeros_like(x), numpy.ones_like(x)
        if self.perspective:
            return numpy.stack([flat, flat, flat], -1), numpy.stack([x, y, one], -1)
        return numpy.stack([x, y, flat], -1), numpy.stack([flat, flat, one], -1)


class Fragments:
    """All crossings of all rays, in any order."""

    def __init__(self, view):
        self.view, self.parts, self.opaque = view, [], numpy.full((view.height, view.width), numpy.inf)
        self.origins, self.directions = view.origins_and_directions()

    def add(self, mask, depth, color, order, opaque):
        mask = mask & (depth > 0)
        if opaque:
            self.opaque[mask] = numpy.minimum(self.opaque[mask], depth[mask])
            color = color * [1, 1, 1, 0] + [0, 0, 0, 1]
        pixels = numpy.flatnonzero(mask)
        self.parts.append((pixels, depth[mask], numpy.full(len(pixels), order), color[mask]))

    def add_triangle(self, corners, colors, order, opaque, shade):
        """By barycentric coordinates from signed volumes; a zero belongs to one side by the top-left rule of none here:
        scenes of tests have no pixel centre on an edge."""
        a, b, c = (corner - self.origins for corner in corners)
        d = self.directions
        u, v, w = ((numpy.cross(p, q) * d).sum(-1) for p, q in ((b, c), (c, a), (a, b)))
        total = u + v + w
        inside = ((u > 0) & (v > 0) & (w > 0)) | ((u < 0) & (v < 0) & (w < 0))
        with numpy.errstate(divide="ignore", invalid="ignore"):
            weights = numpy.stack([u, v, w], -1) / total[..., None]
        weights[~inside] = 1 / 3
        depth = weights @ numpy.array(corners)[:, 2]
        self.add(inside, depth, shade(weights @ colors, weights, d), order, opaque)

    def add_disc(self, center, radius, color, order, opaque, light):
        at = self.origins + self.directions * center[2]
        fraction2 = ((at - center) ** 2).sum(-1) / radius ** 2  # of the radius, squared
        inside = fraction2 < 1
        facing = numpy.sqrt(numpy.maximum(1 - fraction2, 0))  # of the sphere that it stands for
        colors = light(numpy.broadcast_to(color, (*inside.shape, 4)), facing)
        self.add(inside, numpy.full(inside.shape, center[2]), colors, order, opaque)

    def composite(self, background):
        """Front to back; nothing shows behind what is opaque."""
        pixel, depth, order, color = (numpy.concatenate(part) for part in zip(*self.parts))
        picture = numpy.zeros((self.view.height * self.view.width, 4))
        shown = numpy.flatnonzero(depth <= self.opaque.ravel()[pixel])
        for i in shown[numpy.lexsort((order[shown], depth[shown]))]:
            left = (1 - picture[pixel[i], 3]) * color[i, 3]
            picture[pixel[i]] += left * numpy.append(color[i, :3], 1)
        picture[:, :3] += (1 - picture[:, 3:]) * background
        return picture.reshape(self.view.height, self.view.width, 4)


def unit(vectors):
    return vectors / numpy.linalg.norm(vectors, axis=-1, keepdims=True)


def directions_of(points):
    """Of a line at its points: between the nearest ones that lie elsewhere, one-sided at ends and where it turns back."""
    directions = []
    for i, x in enumerate(points):
        before = next((p for p in points[:i][::-1] if (p != x).any()), x)
        after = next((p for p in points[i + 1:] if (p != x).any()), x)
        directions.append(after - (before if (after != before).any() else x))
    return numpy.array(directions)


def ribbon(points, radius, view):
    """The rims of a strip that faces the eye: x ± radius · (t × v) / |t × v|, radius one or each point's."""
    t = directions_of(points)
    # The world is right-handed and this view is not, which turns a product round.
    v = points if view.perspective else numpy.broadcast_to([0.0, 0, 1], t.shape)
    across = -numpy.cross(unit(t), unit(v))
    for i, w in enumerate(across):
        before = across[i - 1] if i else numpy.array([1.0, 0, 0])
        across[i] = before if numpy.linalg.norm(w) < 1e-9 else unit(w) * (1 if not i or w @ before >= 0 else -1)
    across *= numpy.reshape(radius, (-1, 1))
    return points - across, points + across


def radii_of(thing, ply):
    """Of each vertex: its own, or the object's."""
    if thing["radius"] is None:
        return ply["vertex"]["radius"].astype(float)
    return numpy.full(len(ply["vertex"]), thing["radius"])


def facing_of_mesh(normals):
    """|n · v| of a triangle with these corners' normals, by the weights of its corners and the ray's direction."""
    return lambda weights, d: abs((unit(weights @ normals) * unit(d)).sum(-1))


def facing_of_tube(across, t):
    """The same of the tube that a ribbon stands for: √(1 - c²) |t × v|, c the place across, t the line's direction."""
    return lambda weights, d: (numpy.sqrt(numpy.maximum(1 - (weights @ across) ** 2, 0)) *
                               numpy.linalg.norm(numpy.cross(unit(weights @ t), unit(d)), axis=-1))


def triangles_of(thing, ply, positions, colors, view):
    """Corners and colours, triangle by triangle, and how it faces the eye where that matters."""
    if thing["kind"] == "triangles":
        normals = None if thing["lit"] else columns(ply["vertex"], "nx", "ny", "nz") @ view.turn.T
        for t in ply["face"]["corners"]:
            yield positions[t], colors[t], None if normals is None else facing_of_mesh(normals[t])
    elif thing["kind"] == "lines":
        for line in numpy.unique(ply["vertex"]["line"]):
            i = numpy.flatnonzero(ply["vertex"]["line"] == line)
            low, high = ribbon(positions[i], radii_of(thing, ply)[i], view)
            t = unit(directions_of(positions[i]))
            for k, (p, q) in enumerate(zip(i, i[1:])):
                yield (low[k], high[k], high[k + 1]), colors[[p, p, q]], facing_of_tube(numpy.array([-1, 1, 1]), t[[k, k, k + 1]])
                yield (low[k], high[k + 1], low[k + 1]), colors[[p, q, q]], facing_of_tube(numpy.array([-1, 1, -1]), t[[k, k + 1, k + 1]])


def light_of(scene, lit):
    """What the light makes of a colour that faces the eye by c = |n · v|."""
    def headlight(color, c):
        return numpy.concatenate([color[..., :3] * c[..., None], color[..., 3:]], -1)

    def phong(color, c):
        shine = 0.35 * numpy.maximum(0, 2 * c * c - 1) ** 24
        return numpy.concatenate([numpy.minimum(color[..., :3] * (0.15 + 0.85 * c)[..., None] + shine[..., None], 1), color[..., 3:]], -1)

    if lit:
        return lambda color, c: color
    return {"headlight": headlight, "phong": phong}[scene["lighting"]]


def render(path, fragments_of=Fragments):
    scene = json.loads(Path(path).read_text())
    view = View(scene)
    fragments = fragments_of(view)
    for order, thing in enumerate(scene["objects"]):
        ply = read_ply(Path(path).parent / thing["file"])
        positions = view.of_world(columns(ply["vertex"], "x", "y", "z"))
        colors = columns(ply["vertex"], "red", "green", "blue", "alpha")
        light = light_of(scene, thing["lit"])
        for corners, corner_colors, facing in triangles_of(thing, ply, positions, colors, view):
            shade = lambda color, weights, d: light(color, facing(weights, d) if facing else None)
            fragments.add_triangle(corners, corner_colors, order, thing["opaque"], shade)
        if thing["kind"] == "points":
            for center, color, radius in zip(positions, colors, radii_of(thing, ply)):
                if radius > 0:
                    fragments.add_disc(center, radius, color, order, thing["opaque"], light)
    return fragments.composite(scene["background"])


if __name__ == "__main__":
    exr.write(sys.argv[2], render(sys.argv[1]))
