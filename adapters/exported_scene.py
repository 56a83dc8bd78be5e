# SPDX-License-Identifier: GPL-3.0-or-later
"""What the adapters share: the objects of an exported scene (docs/exported-scene.md) as NumPy's arrays."""

import numpy


def read_ply(path):
    """The elements of a PLY file of `pellucid export`."""
    header, _, body = path.read_bytes().partition(b"end_header\n")
    types, elements = {"float": "<f4", "uint": "<u4"}, []
    for words in (line.split() for line in header.decode().splitlines()):
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].extend([("n", "u1"), ("corners", "<u4", 3)] if words[1] == "list" else [(words[2], types[words[1]])])
    read, at = {}, 0
    for name, count, properties in elements:
        read[name] = numpy.frombuffer(body, numpy.dtype(properties), count, at)
        at += read[name].nbytes
    return read


def columns(vertices, *names):
    """Some numbers of each vertex, a row each."""
    return numpy.stack([vertices[name] for name in names], -1)


def cells(ply, kind):
    """The vertices of each triangle, segment or point, a row each."""
    if kind == "triangles":
        return ply["face"]["corners"]
    if kind == "lines":
        return columns(ply["edge"], "vertex1", "vertex2")
    return numpy.arange(len(ply["vertex"]))[:, None]


def ribbon_directions(line, eye, forward):
    """t × v at each point of a line, made units, each on the side of the one before."""
    tangents = line[numpy.minimum(numpy.arange(len(line)) + 1, len(line) - 1)] - line[numpy.maximum(numpy.arange(len(line)) - 1, 0)]
    across = numpy.cross(tangents, forward if eye is None else line - eye)
    across /= numpy.linalg.norm(across, axis=1)[:, None]
    for i in range(1, len(across)):
        across[i] *= 1 if across[i] @ across[i - 1] >= 0 else -1
    return across


def ribbon_triangles(vertices, segments, radius, eye, forward):
    """Positions, triangles and colours of the strips that face the eye (None: of a parallel camera, which looks `forward`)."""
    x, colors, ids = columns(vertices, "x", "y", "z").astype(float), columns(vertices, "red", "green", "blue", "alpha"), vertices["line"]
    w = numpy.zeros_like(x)
    for line in numpy.unique(ids):
        if (ids == line).sum() > 1:
            w[ids == line] = radius[ids == line, None] * ribbon_directions(x[ids == line], eye, forward)
    sides, n = numpy.concatenate([x - w, x + w]), len(x)
    a, b = segments.astype(int).T
    triangles = numpy.concatenate([numpy.stack([a, a + n, b + n], -1), numpy.stack([a, b + n, b], -1)])
    return sides, triangles, numpy.concatenate([colors, colors])
