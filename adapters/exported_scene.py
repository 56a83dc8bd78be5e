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
