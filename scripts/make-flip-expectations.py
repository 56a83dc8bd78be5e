#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes tests/compare/data/flip.json: LDR-FLIP of pairs of pictures by dense filters in double.

Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020, written from the paper's formulas and
constants, with none of the program's short cuts: whole two-dimensional kernels, YCxCz with its scales, numpy's powers.
The pictures are formulas that tests/compare/pictures/metric_pairs.h repeats. Needs Debian's python3-scipy:

    /usr/bin/python3 scripts/make-flip-expectations.py
"""

import json
import pathlib

import numpy as np
from scipy.ndimage import correlate
from test_patterns import gradient, grainy, hashed, noise, rings

PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * np.pi / 180
XYZ_OF_LINEAR = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                          [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                          [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = XYZ_OF_LINEAR.sum(axis=1)
SENSITIVITY = {"achromatic": [(1, 0.0047)], "red-green": [(1, 0.0053)], "blue-yellow": [(34.1, 0.04), (13.5, 0.025)]}


def linear(srgb):
    return np.where(srgb > 0.04045, ((srgb + 0.055) / 1.055) ** 2.4, srgb / 12.92)


def ycxcz(rgb):
    x, y, z = np.moveaxis(rgb @ XYZ_OF_LINEAR.T / WHITE, -1, 0)
    return [116 * y - 16, 500 * (x - y), 200 * (y - z)]


def linear_of_ycxcz(big_y, cx, cz):
    y = (big_y + 16) / 116
    xyz = np.stack([y + cx / 500, y, y - cz / 200], -1) * WHITE
    return xyz @ np.linalg.inv(XYZ_OF_LINEAR).T


def hunt_lab(rgb):
    delta = 6 / 29
    t = rgb @ XYZ_OF_LINEAR.T / WHITE
    f = np.where(t > delta**3, np.cbrt(t), t / (3 * delta**2) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    a, b = 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])
    return np.stack([lightness, 0.01 * lightness * a, 0.01 * lightness * b], -1)


def hyab(p, q):
    d = p - q
    return np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])


def square(radius):
    return np.mgrid[-radius:radius + 1, -radius:radius + 1]


def sensitivity_kernel(channel):
    widest = max(b for terms in SENSITIVITY.values() for _, b in terms)
    y, x = square(int(np.ceil(3 * np.sqrt(widest / (2 * np.pi**2)) * PIXELS_PER_DEGREE))) / PIXELS_PER_DEGREE
    kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi**2 * (x**2 + y**2) / b) for a, b in SENSITIVITY[channel])
    return kernel / kernel.sum()


def feature_kernel(kind):
    sd = 0.5 * 0.082 * PIXELS_PER_DEGREE
    y, x = square(int(np.ceil(3 * sd)))
    kernel = np.exp(-(x**2 + y**2) / (2 * sd**2)) * (-x if kind == "edge" else x**2 / sd**2 - 1)
    return np.where(kernel < 0, kernel / -kernel[kernel < 0].sum(), kernel / kernel[kernel > 0].sum())


def filtered(plane, kernel):
    return correlate(plane, kernel, mode="nearest")


def features(y, kind):
    kernel = feature_kernel(kind)
    return np.hypot(filtered(y, kernel), filtered(y, kernel.T))


def seen_colors(rgb):
    planes = [filtered(plane, sensitivity_kernel(c)) for plane, c in zip(ycxcz(rgb), SENSITIVITY)]
    return hunt_lab(np.clip(linear_of_ycxcz(*planes), 0, 1))


def color_error(p, q):
    largest = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1])))**0.7
    error, knee = hyab(p, q)**0.7, 0.4 * largest
    return np.where(error < knee, 0.95 / knee * error, 0.95 + (error - knee) / (largest - knee) * 0.05)


def flip(reference, test):
    p, q = (linear(np.clip(image, 0, 1)) for image in (reference, test))
    colors = color_error(seen_colors(p), seen_colors(q))
    luminances = [(ycxcz(rgb)[0] + 16) / 116 for rgb in (p, q)]
    differences = [np.abs(features(luminances[0], kind) - features(luminances[1], kind)) for kind in ("edge", "point")]
    return colors**(1 - np.sqrt(np.maximum(*differences) / np.sqrt(2)))


def waves(x, y, c):
    return 0.5 + 0.4 * np.sin(0.05 * x + 0.03 * y + 2.0 * c)


PAIRS = [
    ("gradient against itself with noise", 64, 48, gradient, grainy),
    ("odd sizes", 37, 53, rings, lambda x, y, c: 0.5 * rings(x, y, c) + 0.25),
    ("smaller than the filters", 7, 5, gradient, noise),
    ("one pixel", 1, 1, lambda x, y, c: 0.2, lambda x, y, c: 0.3 + 0.1 * c),
    ("grey constants", 30, 20, lambda x, y, c: 0.25, lambda x, y, c: 0.75),
    ("red against blue", 30, 20, lambda x, y, c: 1.0 * (c == 0), lambda x, y, c: 1.0 * (c == 2)),
    ("green against blue, the largest", 30, 20, lambda x, y, c: 1.0 * (c == 1),
     lambda x, y, c: 1.0 * (c == 2)),
    ("nearly constant", 33, 29, lambda x, y, c: 0.5, lambda x, y, c: 0.5 + noise(x, y, c) / 4096.0),
    ("dark", 40, 40, lambda x, y, c: noise(x, y, c) / 64.0, lambda x, y, c: hashed(x, y, c, 2) / 64.0),
    ("HDR, clamped", 61, 47, lambda x, y, c: 3.0 * rings(x, y, c), lambda x, y, c: 3.0 * grainy(x, y, c)),
    ("negative values, clamped", 40, 33, lambda x, y, c: noise(x, y, c) - 0.5, lambda x, y, c: rings(x, y, c) - 0.5),
    ("lines beside each other", 90, 70, lambda x, y, c: 0.1 + 0.9 * (x % 16 == 8), lambda x, y, c: 0.1 + 0.9 * (x % 16 == 9)),
    ("lone points gone", 90, 70, lambda x, y, c: 0.5 - 0.5 * (x % 23 == 11) * (y % 19 == 7), lambda x, y, c: 0.5),
    ("waves, more rows than a band", 150, 200, waves, lambda x, y, c: 0.9 * waves(x, y, c) + 0.1 * noise(x, y, c)),
    ("equal", 50, 41, rings, rings),
]


def picture(width, height, formula):
    y, x = np.mgrid[0:height, 0:width].astype(np.int64)
    planes = [formula(x, y, c) + 0.0 * x for c in range(3)]
    return np.stack(planes, axis=-1).astype(np.float32).astype(np.float64)


def write_expectations():
    pairs = []
    for name, width, height, fx, fy in PAIRS:
        error = flip(picture(width, height, fx), picture(width, height, fy))
        last = error[-1, -1]
        pairs.append({"name": name, "width": width, "height": height, "mean": error.mean(), "max": error.max(),
                      "last pixel": last})
    path = pathlib.Path(__file__).parent.parent / "tests/compare/data/flip.json"
    path.write_text(json.dumps({"made_by": "scripts/make-flip-expectations.py", "pairs": pairs}, indent=1) + "\n")


if __name__ == "__main__":
    write_expectations()
