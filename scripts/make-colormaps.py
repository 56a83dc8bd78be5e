#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes scene/appearance/colormap_tables.inc from Matplotlib's colour maps (256 sRGB bytes triples each).

viridis, magma, inferno, plasma (Smith, van der Walt; CC0), cividis (Nuñez et al. 2018; CC0), turbo
(Mikhailov 2019; Apache-2.0), coolwarm (Moreland 2009).
"""
import matplotlib
import numpy as np

NAMES = ["viridis", "magma", "inferno", "plasma", "cividis", "turbo", "coolwarm"]

with open("scene/appearance/colormap_tables.inc", "w") as out:
    out.write("// Made by scripts/make-colormaps.py. 256 × RGB bytes.\n// clang-format off\n")
    for name in NAMES:
        rgb = np.round(matplotlib.colormaps[name](np.linspace(0, 1, 256))[:, :3] * 255).astype(int)
        out.write(f"constexpr std::uint8_t {name}_table[256][3] = {{\n")
        for row in rgb.reshape(32, 8, 3):
            out.write("  " + "".join("{%d,%d,%d}," % tuple(c) for c in row) + "\n")
        out.write("};\n")
    out.write("// clang-format on\n")
