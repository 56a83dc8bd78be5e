# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads and writes OpenEXR pictures of 32-bit floats by the format's description alone (scan lines, not
tiled; without compression, or ZIP), so that tests need no code of the program for pictures."""

import struct
import zlib

import numpy

MAGIC = 20000630
FLOAT = 2
LINES_OF_A_BLOCK = {0: 1, 2: 1, 3: 16}  # by the compression: none, ZIPS, ZIP


def text(file, start):
    end = file.index(b"\0", start)
    return file[start:end].decode(), end + 1


def header_of(file):
    """The attributes by name, as bytes, and where they end."""
    assert struct.unpack_from("<ii", file) == (MAGIC, 2), "not a plain OpenEXR file"
    attributes, at = {}, 8
    while file[at]:
        name, at = text(file, at)
        _, at = text(file, at)
        (size,) = struct.unpack_from("<i", file, at)
        attributes[name] = file[at + 4:at + 4 + size]
        at += 4 + size
    return attributes, at + 1


def channels_of(attribute):
    names, at = [], 0
    while attribute[at]:
        name, at = text(attribute, at)
        assert struct.unpack_from("<i", attribute, at) == (FLOAT,), name
        names.append(name)
        at += 16
    return names


def inflated(data, size):
    """ZIP's bytes: differences, the even ones first."""
    if len(data) == size:
        return data
    coded = numpy.frombuffer(zlib.decompress(data), numpy.uint8).astype(numpy.int64)
    coded[1:] -= 128
    split = (numpy.cumsum(coded) & 255).astype(numpy.uint8)
    half = (size + 1) // 2
    whole = numpy.empty(size, numpy.uint8)
    whole[0::2], whole[1::2] = split[:half], split[half:]
    return whole.tobytes()


def read(path):
    """Height × width × 4 floats: red, green, blue, alpha."""
    with open(path, "rb") as opened:
        file = opened.read()
    attributes, at = header_of(file)
    names = channels_of(attributes["channels"])
    x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
    width, height = x1 - x0 + 1, y1 - y0 + 1
    lines = LINES_OF_A_BLOCK[attributes["compression"][0]]
    picture = numpy.ones((height, width, 4), numpy.float32)
    for block in range(-(-height // lines)):
        (start,) = struct.unpack_from("<Q", file, at + 8 * block)
        y, size = struct.unpack_from("<ii", file, start)
        rows = min(lines, y1 + 1 - y)
        data = inflated(file[start + 8:start + 8 + size], 4 * width * len(names) * rows)
        values = numpy.frombuffer(data, "<f4").reshape(rows, len(names), width)
        for k, name in enumerate(names):
            picture[y - y0:y - y0 + rows, :, "RGBA".index(name)] = values[:, k]
    return picture


def write(path, picture):
    """Writes height × width × 4 numbers without compression."""
    picture = numpy.asarray(picture, "<f4")
    height, width = picture.shape[:2]
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    channels = b"".join(name + b"\0" + struct.pack("<iiii", FLOAT, 0, 1, 1)
                        for name in (b"A", b"B", b"G", b"R")) + b"\0"
    file = struct.pack("<ii", MAGIC, 2)
    for name, kind, value in ((b"channels", b"chlist", channels), (b"compression", b"compression", b"\0"),
                              (b"dataWindow", b"box2i", window), (b"displayWindow", b"box2i", window),
                              (b"lineOrder", b"lineOrder", b"\0"),
                              (b"pixelAspectRatio", b"float", struct.pack("<f", 1)),
                              (b"screenWindowCenter", b"v2f", struct.pack("<ff", 0, 0)),
                              (b"screenWindowWidth", b"float", struct.pack("<f", 1))):
        file += name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value
    file += b"\0"
    line = 16 * width
    first = len(file) + 8 * height
    file += b"".join(struct.pack("<Q", first + y * (8 + line)) for y in range(height))
    for y in range(height):
        file += struct.pack("<ii", y, line) + picture[y, :, ::-1].T.tobytes()
    with open(path, "wb") as out:
        out.write(file)
