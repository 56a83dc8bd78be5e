#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the binary files of the corpus anew: make_corpus.py [FOLDER]. Those of text are written by hand."""

import struct
import sys
from pathlib import Path

TYPES = {"i8": "b", "u8": "B", "i16": "h", "u16": "H", "i32": "i", "u32": "I", "i64": "q", "u64": "Q", "f32": "f",
         "f64": "d"}


def block(name, kind, numbers, components=1):
    """A block as core/files/blocks.h has it; its end is a block without a name."""
    head = struct.pack("<IIIIQQ", len(name), list(TYPES).index(kind), components, 0, len(numbers) // components, 0)
    return head + padded(name.encode()) + padded(struct.pack(f"<{len(numbers)}{TYPES[kind]}", *numbers))


def padded(data):
    return data + b"\0" * (-len(data) % 16)


def blocks(*parts):
    return padded(b"PLBLOCK1") + b"".join(parts) + struct.pack("<IIIIQQ", 0, 0, 0, 0, 0, 0)


def text(name, words):
    return block(name, "u8", words.encode())


def cells(group, *corners):
    ends = [0]
    for cell in corners:
        ends.append(ends[-1] + len(cell))
    return block(f"{group}.offsets", "i64", ends) + block(f"{group}.connectivity", "i64", sum(map(list, corners), []))


NO_ACTIVE = block("point.active", "i32", [-1] * 4) + block("cell.active", "i32", [-1] * 4)
CUBE = [coordinate for corner in range(8) for coordinate in (corner & 1, corner >> 1 & 1, corner >> 2)]


def velocity(points, kind="f32"):
    return block("point:velocity", kind, [0.5 * i for i in range(3 * points)], 3)


def data_sets():
    """One of each kind of VTK's data sets."""
    extent = block("extent", "i32", [0, 1, 0, 1, 0, 1])
    frame = block("origin", "f64", [0, 0, 0]) + block("spacing", "f64", [1, 1, 1])
    turn = block("direction", "f64", [0, 1, 0, -1, 0, 0, 0, 0, 1])
    upright = block("direction", "f64", [1, 0, 0, 0, 1, 0, 0, 0, 1])
    hidden = block("cell:vtkGhostType", "u8", [32]) + block("cell.active", "i32", [-1, -1, -1, 0])
    points = block("points", "f32", CUBE, 3)
    quads = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
    faces = [len(quads)] + sum(([len(quad)] + quad for quad in quads), [])
    active = block("point.active", "i32", [-1, 0, -1, -1]) + block("cell.active", "i32", [-1] * 4)
    yield "image", blocks(text("kind", "image"), extent, frame, upright, velocity(8), active)
    yield "image_turned", blocks(text("kind", "image"), extent, frame, turn, velocity(8, "f64"), NO_ACTIVE)
    yield "image_hidden", blocks(text("kind", "image"), extent, frame, upright, velocity(8),
                                 block("point.active", "i32", [-1] * 4), hidden)
    yield "image_of_nothing", blocks(text("kind", "image"), block("extent", "i32", [0, 2**31 - 2, 0, 2**31 - 2, 0, 0]), frame,
                                     upright, NO_ACTIVE)
    axes = b"".join(block(axis, "f64", [0, 2]) for axis in "xyz")
    yield "rectilinear", blocks(text("kind", "rectilinear"), extent, axes, velocity(8), NO_ACTIVE)
    yield "structured", blocks(text("kind", "structured"), extent, points, velocity(8), NO_ACTIVE)
    yield "hexahedron", blocks(text("kind", "unstructured"), points, block("types", "u8", [12]),
                               cells("cells", [0, 1, 3, 2, 4, 5, 7, 6]), velocity(8), NO_ACTIVE)
    yield "mixed", blocks(text("kind", "unstructured"), points, block("types", "u8", [10, 4, 5, 1]),
                          cells("cells", [0, 1, 2, 4], [0, 1, 3], [5, 6, 7], [3]), velocity(8), NO_ACTIVE)
    yield "polyhedron", blocks(text("kind", "unstructured"), points, block("types", "u8", [42]),
                               cells("cells", list(range(8))), block("faces", "i64", faces),
                               block("face_locations", "i64", [0]), velocity(8), NO_ACTIVE)
    yield "poly", blocks(text("kind", "poly"), points, cells("verts", [0]), cells("lines", [0, 1, 3]),
                         cells("polys", [0, 1, 3, 2]), cells("strips", [4, 5, 6, 7]), velocity(8),
                         block("cell:Colors", "u8", list(range(12)), 3), NO_ACTIVE)


def grid(number, name, kind, values, leaves, tiles=(), grid_class=0):
    """A grid whose leaves, at these places, have all their voxels active."""
    width = 3 if kind.startswith("vec3") else 1
    number_kind = "f64" if kind[-1] == "d" or kind == "double" else "f32"
    masks = [[2**64 - 1] * 8 for _ in leaves]
    flat = [x for _ in leaves for _ in range(512) for x in values]
    return (text(f"{number}.name", name) + text(f"{number}.value", kind) + text(f"{number}.type", f"Tree_{kind}_5_4_3") +
            block(f"{number}.class", "i32", [grid_class]) +
            block(f"{number}.affine", "f64", [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]) +
            block(f"{number}.background", number_kind, [0] * width, width) +
            block(f"{number}.origins", "i32", sum(map(list, leaves), []), 3) +
            block(f"{number}.masks", "u64", sum(masks, []), 8) +
            block(f"{number}.values", number_kind, flat, width) +
            block(f"{number}.tiles", "i32", sum(map(list, tiles), []), 5) +
            block(f"{number}.tile_values", number_kind, [x for _ in tiles for x in values], width))


def grid_files():
    """Grids of scalars and vectors, as boxes, tiles and level sets; points."""
    yield "scalar", blocks(grid(0, "s", "float", [1], [(0, 0, 0)]))
    yield "level_set", blocks(grid(0, "s", "double", [1], [(0, 0, 0)], [(1, 8, 0, 0, 0)], 1))
    yield "tiles", blocks(grid(0, "s", "float", [1], [], [(1, 0, 0, 0, 1), (2, 128, 0, 0, 0)], 2))
    yield "names_only", blocks(text("0.name", "s"), text("0.value", "float"))
    yield "velocity", blocks(grid(0, "velocity", "vec3s", [1, 2, 3], [(0, 0, 0)]))
    yield "leaf_at_the_end", blocks(grid(0, "s", "float", [1], [(2**31 - 8, 0, 0)]))
    yield "tiles_far_apart", blocks(grid(0, "s", "float", [1], [], [(1, x, 0, 0, 1) for x in (-(2**31), 2**31 - 8)], 1))
    yield "says_vectors", blocks(text("0.value", "vec3s"), grid(0, "s", "float", [1], [(0, 0, 0)]))
    yield "points", blocks(block("positions", "f64", [0, 0, 0, 1, 2, 3], 3), block("column:s", "f64", [4, 5]))


def binlines(version, lines, attributes=0, names=()):
    data = struct.pack("<III", version, len(lines), attributes)
    for points in lines:
        data += struct.pack(f"<I{3 * len(points)}f", len(points), *sum(map(list, points), []))
        data += struct.pack(f"<{attributes * len(points)}f", *range(attributes * len(points)))
    if version == 2:
        data += struct.pack("<II", 0, len(names))
    for name in names:
        data += struct.pack("<I", len(name)) + name.encode()
    return data


def line_files():
    two = [[(0, 0, 0), (1, 0, 0)], [(0, 1, 0), (1, 1, 0), (2, 2, 2)]]
    yield "version1", binlines(1, two)
    yield "attributes", binlines(1, two, 2)
    yield "version2", binlines(2, two, 2, ["speed", "importance"])
    yield "empty_line", binlines(1, [[], *two])


def ply(encoding, order):
    header = (f"ply\nformat {encoding} 1.0\nelement vertex 4\nproperty float x\nproperty double y\nproperty float z\n"
              "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n"
              "property list uchar int vertex_indices\nelement edge 2\nproperty int vertex1\nproperty int vertex2\n"
              "end_header\n")
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)]
    data = b"".join(struct.pack(f"{order}fdfBBB", *corner, 255, 128, 0) for corner in corners)
    return header.encode() + data + struct.pack(f"{order}B4i", 4, 0, 1, 2, 3) + struct.pack(f"{order}4i", 0, 1, 1, 2)


def tck(kind, numbers, order="<"):
    """Tracks of MRtrix: a point of NaN ends a track, one of infinities the file."""
    head = f"mrtrix tracks\ndatatype: {kind}\nfile: . 80\nEND\n".encode()
    letter = "d" if "64" in kind else "f"
    return head.ljust(80, b"\0") + struct.pack(f"{order}{len(numbers)}{letter}", *numbers)


def trk(order, scalars=0, properties=0, cut=0):
    """A header of TrackVis and two tracks, of two points and of one."""
    head = bytearray(1000)
    head[:5] = b"TRACK"
    struct.pack_into(f"{order}3h", head, 6, 8, 6, 5)
    struct.pack_into(f"{order}3f", head, 12, 1, 2, 4)
    struct.pack_into(f"{order}h", head, 36, scalars)
    struct.pack_into(f"{order}h", head, 238, properties)
    head[240:246] = b"pair\0002"
    struct.pack_into(f"{order}16f", head, 440, 1, 0, 0, 10, 0, -2, 0, 20, 0, 0, 4, 30, 0, 0, 0, 1)
    head[948:951] = b"LPS"
    struct.pack_into(f"{order}i", head, 996, 1000)
    data = bytes(head)
    for points in (2, 1):
        numbers = points * (3 + scalars) + properties
        data += struct.pack(f"{order}i{numbers}f", points, *range(numbers))
    return data[:len(data) - cut]


def hair(arrays, segments=(2, 1)):
    points = sum(segments) + len(segments)
    data = b"HAIR" + struct.pack("<IIIIfffff", len(segments), points, arrays, 1, 0.5, 0.25, 1, 0.5, 0) + bytes(88)
    data += struct.pack(f"<{len(segments)}H", *segments) if arrays & 1 else b""
    for bit, numbers in ((2, 3), (4, 1), (8, 1), (16, 3)):
        data += struct.pack(f"<{numbers * points}f", *[0.5] * (numbers * points)) if arrays & bit else b""
    return data


def glb(document, binary=b""):
    document = document.encode()
    document += b" " * (-len(document) % 4)
    chunks = struct.pack("<II", len(document), 0x4E4F534A) + document
    chunks += struct.pack("<II", len(binary), 0x004E4942) + binary if binary else b""
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def gltf_files():
    """A triangle, a strip and a line over three points and their colours; nodes that name each other."""
    binary = struct.pack("<9f12B3HH", *[0, 0, 0, 1, 0, 0, 0, 1, 0], *[255, 0, 51, 128] * 3, 0, 1, 2, 0)
    rest = ('"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},'
            '{"bufferView":0,"byteOffset":36,"componentType":5121,"normalized":true,"count":3,"type":"VEC4"},'
            '{"bufferView":0,"byteOffset":48,"componentType":5123,"count":3,"type":"SCALAR"}],'
            '"bufferViews":[{"buffer":0,"byteLength":56}],"buffers":[{"byteLength":56}]}')
    head = '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"scale":[1,2,3]}],"meshes":'
    for name, mode in (("triangle", 4), ("line_strip", 3), ("fan", 6)):
        yield name, glb(f'{head}[{{"primitives":[{{"attributes":{{"POSITION":0,"COLOR_0":1}},"indices":2,'
                        f'"mode":{mode}}}]}}],{rest}', binary)
    yield "count_beyond", glb(f'{head}[{{"primitives":[{{"attributes":{{"POSITION":0}}}}]}}],'
                              + rest.replace('"count":3,"type":"VEC3"', '"count":9007199254740991,"type":"VEC3"'), binary)
    yield "round", glb('{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"children":[0]}]}')
    instances = '{"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{"TRANSLATION":0}}},"mesh":0,'
    yield "instances", glb(head.replace('{"mesh":0,', instances) + f'[{{"primitives":[{{"attributes":'
                           f'{{"POSITION":0}}}}]}}],{rest}', binary)
    yield "text", b'{"asset":{"version":"2.0"},"meshes":[{"primitives":3}]}'


def trx_files():
    """Two streamlines of two and one vertices, with and without the last offset, data of both kinds, and a wrong count."""
    head = text("header.json", '{"NB_VERTICES": 3, "NB_STREAMLINES": 2}')
    points = block("positions.3.float16", "u8", struct.pack("<9e", *range(9)))
    first = block("offsets.uint32", "u8", struct.pack("<2I", 0, 2))
    data = (block("dpv/fa.float32", "u8", struct.pack("<3f", 1, 2, 3)), block("dps/seed.3.uint8", "u8", bytes(range(6))))
    yield "plain", blocks(head, points, first)
    yield "all", blocks(head, points, block("offsets.uint64", "u8", struct.pack("<3Q", 0, 2, 3)), *data)
    yield "count_beyond", blocks(text("header.json", '{"NB_VERTICES": 3, "NB_STREAMLINES": 4000000000}'), points, first)


def view(*properties, group="views"):
    """A view of ParaView's: (name, numbers) of its properties."""
    lines = "".join(f'<Property name="{name}">' + "".join(f'<Element index="{i}" value="{x}"/>' for i, x in enumerate(numbers))
                    + "</Property>" for name, numbers in properties)
    return f'<Proxy group="{group}" type="RenderView">{lines}</Proxy>'


def camera_files():
    """A view as it is saved, a state with one of another kind, one that lacks its angle, and cameras of glTF."""
    place = (("CameraPosition", (1, 2, 3)), ("CameraFocalPoint", (0, 0, 0)), ("CameraViewUp", (0, 1, 0)))
    flat = (("CameraParallelProjection", (1,)), ("CameraParallelScale", (2.5,)))
    yield "view", f'<?xml version="1.0"?><P>{view(*place, ("CameraViewAngle", (30,)))}</P>'.encode()
    yield "state", f'<P>{view(("ViewSize", (1, 2)))}{view(*place, *flat)}{view(group="sources")}</P>'.encode()
    yield "no_angle", f"<P>{view(*place)}</P>".encode()
    cameras = '"cameras":[{"type":"perspective","perspective":{"yfov":1}},{"type":"orthographic","orthographic":{"ymag":1}}]'
    head = '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":'
    yield "gltf", f'{head}[{{"camera":0,"children":[1]}},{{"camera":1,"translation":[1,2,3]}}],{cameras}}}'.encode()
    yield "gltf_flat", f'{head}[{{"camera":0,"scale":[0,0,0]}}],{cameras}}}'.encode()


def track_files():
    nan, inf = float("nan"), float("inf")
    points = [1, 2, 3, 4, 5, 6, nan, nan, nan, 7, 8, 9, 1, 1, 1, inf, inf, inf]
    yield "tck/little_endian", tck("Float32LE", points)
    yield "tck/big_endian", tck("Float64BE", points, ">")
    yield "tck/no_end", tck("Float32LE", points[:-3])
    yield "tck/offset_beyond", b"mrtrix tracks\ndatatype: Float32LE\nfile: . 4e9\nEND\n"
    yield "trk/little_endian", trk("<")
    yield "trk/values", trk(">", 1, 2)
    yield "trk/cut", trk("<", 1, 2, 6)
    yield "hair/plain", hair(3)
    yield "hair/full", hair(31)
    yield "hair/no_segments", hair(2, (1, 1))
    yield "hair/points_beyond", b"HAIR" + struct.pack("<III", 1 << 31, 1 << 31, 2) + bytes(112)


def meta_image(letter, more="", size="2 2 2"):
    return (f"NDims = 3\nDimSize = {size}\nElementNumberOfChannels = 3\nElementType = "
            f"{'MET_FLOAT' if letter == 'f' else 'MET_DOUBLE'}\n{more}ElementDataFile = LOCAL\n"
            ).encode() + struct.pack(f"<24{letter}", *range(24))


def main():
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent / "corpus")
    files = {f"vtk_blocks/{name}": data for name, data in data_sets()}
    files |= {f"vdb_blocks/{name}": data for name, data in grid_files()}
    files |= {f"binlines/{name}": data for name, data in line_files()}
    files |= {f"gltf/{name}": data for name, data in gltf_files()}
    files |= {f"trx_blocks/{name}": data for name, data in trx_files()}
    files |= {f"cameras/{name}": data for name, data in camera_files()}
    files |= dict(track_files())
    files |= {"ply/little_endian": ply("binary_little_endian", "<"), "ply/big_endian": ply("binary_big_endian", ">"),
              "meta_image/local_float": meta_image("f"),
              "meta_image/local_double": meta_image("d", "Offset = 1 2 3\nElementSpacing = 1 2 3\n"),
              "meta_image/big_endian": meta_image("f", "BinaryDataByteOrderMSB = True\n"),
              "meta_image/spacing_without_inverse": meta_image("f", "ElementSpacing = 1 1e-310 1\n"),
              "meta_image/bytes_beyond_64_bits": meta_image("d", size="949063 914846 885249")[:-192] + bytes(13232),
              "blocks/empty": blocks(), "blocks/one": blocks(block("a", "f64", [1, 2, 3, 4, 5, 6], 3)),
              "blocks/texts": blocks(text("kind", "image"), text("b", ""), text("c", "word")),
              "blocks/no_numbers": blocks(block("none", "u64", [], 8), block("i", "i16", [1, 2, 3]))}
    for name, data in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)


if __name__ == "__main__":
    main()
