#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes tests/compare/data/metrics.json: what scikit-image says about pairs of pictures.

The pictures are formulas that tests/compare/metric_pairs.h repeats in the same order of operations,
all in double, then rounded to float. Run again with Debian's python3-skimage only when a pair changes:

    /usr/bin/python3 scripts/make-metric-expectations.py

With --time it says how long SSIM of 1000×1000 RGB takes here, to be held against bench_metrics.
"""

import json
import pathlib
import sys
import timeit

import numpy as np
import skimage
from skimage.metrics import structural_similarity


def hashed(x, y, c, seed):
    """A 32-bit integer hash of the pixel, as noise in [0, 1)."""
    h = (x * 73856093 ^ y * 19349663 ^ c * 83492791 ^ seed * 2654435761) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 0x45D9F3B) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 0x45D9F3B) & 0xFFFFFFFF
    return (h ^ (h >> 16)) / 4294967296.0


# name, width, height, picture x, picture y: functions of integer arrays x, y and channel c
def gradient(x, y, c):
    return (3 * x + 5 * y + 40 * c) % 256 / 255.0


def rings(x, y, c):
    return (x * x + y * y + 17 * c) % 301 / 300.0


def noise(x, y, c):
    return hashed(x, y, c, 1)


def grainy(x, y, c):
    return 0.9 * gradient(x, y, c) + 0.1 * noise(x, y, c)


PAIRS = [
    ("gradient against itself with noise", 64, 48, gradient, grainy),
    ("odd sizes", 37, 53, rings, lambda x, y, c: 0.5 * rings(x, y, c) + 0.25),
    ("one window", 11, 11, gradient, noise),
    ("narrow", 11, 200, rings, gradient),
    ("wide, more rows than a band", 131, 75, noise, lambda x, y, c: 1.0 - noise(x, y, c)),
    ("constants", 30, 20, lambda x, y, c: 0.25 + 0.0 * x, lambda x, y, c: 0.75 + 0.0 * x),
    ("nearly constant", 33, 29, lambda x, y, c: 0.5 + 0.0 * x,
     lambda x, y, c: 0.5 + noise(x, y, c) / 1048576.0),
    ("tiny values", 40, 40, lambda x, y, c: noise(x, y, c) / 65536.0,
     lambda x, y, c: hashed(x, y, c, 2) / 65536.0),
    ("HDR, to 64", 61, 47, lambda x, y, c: 64.0 * rings(x, y, c), lambda x, y, c: 64.0 * grainy(x, y, c)),
    ("HDR, bright with small differences", 45, 51, lambda x, y, c: 1000.0 + noise(x, y, c),
     lambda x, y, c: 1000.0 + grainy(x, y, c)),
    ("negative values", 40, 33, lambda x, y, c: noise(x, y, c) - 0.5,
     lambda x, y, c: rings(x, y, c) - 0.5),
    ("equal", 50, 41, rings, rings),
]


def picture(width, height, formula):
    y, x = np.mgrid[0:height, 0:width].astype(np.int64)
    planes = [formula(x, y, c) for c in range(3)]
    return np.stack(planes, axis=-1).astype(np.float32).astype(np.float64)


def displayed(image):
    """The nearest n/255, rounded in float as the program does."""
    shown = np.clip(image, 0, 1).astype(np.float32) * np.float32(255) + np.float32(0.5)
    return np.floor(shown).astype(np.float64)


def ssim(a, b, data_range):
    return structural_similarity(a, b, channel_axis=-1, gaussian_weights=True, sigma=1.5,
                                 use_sample_covariance=False, data_range=data_range)


def metrics(a, b, data_range):
    error = b - a
    rmse = np.sqrt(np.mean(error**2)) / data_range
    largest = np.abs(error).max(axis=-1)
    where = int(np.argmax(largest))
    return {
        "rmse": rmse,
        "psnr": None if rmse == 0 else -20 * np.log10(rmse),
        "ssim": ssim(a, b, data_range),
        "max_error": {"value": float(largest.max() / data_range), "x": where % a.shape[1],
                      "y": where // a.shape[1]},
    }


def ssim_milliseconds():
    """The fastest of five, on the pictures of benchmarks/metrics_bench.cpp."""
    y, x = np.mgrid[0:1000, 0:1000]
    a, b = (np.stack([x * y % p / p, x % 256 / 255, y % 256 / 255], -1).astype(np.float32) for p in (251, 241))
    return 1e3 * min(timeit.repeat(lambda: ssim(a, b, 1), number=1, repeat=5))


def write_expectations():
    pairs = []
    for name, width, height, fx, fy in PAIRS:
        a, b = picture(width, height, fx), picture(width, height, fy)
        pairs.append({"name": name, "width": width, "height": height,
                      "linear": metrics(a, b, 1), "displayed": metrics(displayed(a), displayed(b), 255)})
    path = pathlib.Path(__file__).parent.parent / "tests/compare/data/metrics.json"
    made_by = f"scikit-image {skimage.__version__}, scripts/make-metric-expectations.py"
    path.write_text(json.dumps({"made_by": made_by, "pairs": pairs}, indent=1) + "\n")


if __name__ == "__main__":
    if "--time" in sys.argv:
        print(f"scikit-image's SSIM: {ssim_milliseconds():.0f} ms")
    else:
        write_expectations()
