#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes scenes/budget/abc-16.mha: one period of the ABC flow, 16 samples along each axis, whose error of
interpolation the study `budget` measures."""
import math
import pathlib
import struct

SAMPLES = 16
A, B, C = math.sqrt(3), math.sqrt(2), 1


def velocity(x, y, z):
    return (A * math.sin(z) + C * math.cos(y), B * math.sin(x) + A * math.cos(z), C * math.sin(y) + B * math.cos(x))


def main():
    step = 2 * math.pi / SAMPLES
    header = (
        f"ObjectType = Image\nNDims = 3\nDimSize = {SAMPLES} {SAMPLES} {SAMPLES}\nElementType = MET_FLOAT\n"
        f"ElementNumberOfChannels = 3\nElementSpacing = {step!r} {step!r} {step!r}\nOffset = 0 0 0\n"
        "BinaryDataByteOrderMSB = False\nElementDataFile = LOCAL\n"
    )
    places = [i * step for i in range(SAMPLES)]
    samples = [velocity(x, y, z) for z in places for y in places for x in places]
    data = b"".join(struct.pack("<3f", *sample) for sample in samples)
    folder = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "budget"
    (folder / "abc-16.mha").write_bytes(header.encode() + data)


main()
