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
from scipy.ndimage import gaussian_filter
from skimage.metrics import structural_similarity
from test_patterns import gradient, grainy, hashed, noise, rings


# name, width, height, picture x, picture y: functions of integer arrays x, y and channel c
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


# Pictures that have five scales: the least, odd sizes, wide ones.
SCALED = [
    ("the least size", 176, 176, gradient, grainy),
    ("odd sizes at every scale", 211, 195, rings, lambda x, y, c: 0.5 * rings(x, y, c) + 0.25),
    ("wide", 400, 180, grainy, gradient),
    ("each other's negative", 200, 190, noise, lambda x, y, c: 1.0 - noise(x, y, c)),
]


def in_mask(x, y):
    return hashed(x // 3, y // 3, 0, 7) < 0.3


def layers(x, y, seed):
    """0 to 3 layers, in blocks, so that two seeds agree now and then."""
    return np.floor(4 * hashed(x // 4, y // 4, 0, seed)).astype(np.int64)


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


def masked(a, b, mask):
    """Of the pixels of a mask alone: SSIM is the mean of scikit-image's map over those whose window lies inside."""
    error = (b - a)[mask]
    largest = np.sort(np.abs(error).max(axis=-1))
    rank = lambda share: largest[max(int(np.ceil(share * largest.size)), 1) - 1]
    scores = structural_similarity(a, b, channel_axis=-1, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
                                   data_range=1, full=True)[1].mean(axis=-1)
    inside = np.zeros_like(mask)
    inside[5:-5, 5:-5] = mask[5:-5, 5:-5]
    return {"pixels": int(mask.sum()), "rmse": np.sqrt(np.mean(error**2)), "max_error": largest[-1], "p95": rank(0.95),
            "p99": rank(0.99), "bias_r": error[:, 0].mean(), "bias_g": error[:, 1].mean(), "bias_b": error[:, 2].mean(),
            "ssim": scores[inside].mean()}


def luma(shown):
    return np.floor(shown @ [0.299, 0.587, 0.114] + 0.5)


def factors(a, b):
    """Means over a channel of SSIM and of its factor of contrast and structure, windows inside alone."""
    blur = lambda plane: gaussian_filter(plane, 1.5, truncate=3.5)[5:-5, 5:-5]
    ux, uy = blur(a), blur(b)
    vx, vy, vxy = blur(a * a) - ux * ux, blur(b * b) - uy * uy, blur(a * b) - ux * uy
    contrast = (2 * vxy + 0.03**2) / (vx + vy + 0.03**2)
    return ((2 * ux * uy + 0.01**2) / (ux**2 + uy**2 + 0.01**2) * contrast).mean(), contrast.mean()


def halved(plane):
    padded = np.pad(plane, [(0, plane.shape[0] % 2), (0, plane.shape[1] % 2)], mode="symmetric")
    return (padded[::2, ::2] + padded[1::2, ::2] + padded[::2, 1::2] + padded[1::2, 1::2]) / 4


def ms_ssim(a, b):
    """Wang, Simoncelli, Bovik 2003, Eq. 7, the mean over channels."""
    weights = [0.0448, 0.2856, 0.3001, 0.2363, 0.1333]
    products = []
    for c in range(3):
        x, y, product = a[..., c], b[..., c], 1.0
        for scale, weight in enumerate(weights):
            whole, contrast = factors(x, y)
            product *= max(whole if scale == 4 else contrast, 0.0) ** weight
            x, y = halved(x), halved(y)
        products.append(product)
    return np.mean(products)


def others(a, b):
    """Of pictures that have a window: None for smaller ones."""
    shown = luma(displayed(a)), luma(displayed(b))
    return {"ssim_skimage": structural_similarity(a, b, channel_axis=-1, data_range=1),
            "ssim_luma8": structural_similarity(*shown, gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
                                                data_range=255)}


def ssim_milliseconds():
    """The fastest of five, on the pictures of benchmarks/metrics_bench.cpp."""
    y, x = np.mgrid[0:1000, 0:1000]
    a, b = (np.stack([x * y % p / p, x % 256 / 255, y % 256 / 255], -1).astype(np.float32) for p in (251, 241))
    return 1e3 * min(timeit.repeat(lambda: ssim(a, b, 1), number=1, repeat=5))


def expectation(name, width, height, fx, fy):
    a, b = picture(width, height, fx), picture(width, height, fy)
    y, x = np.mgrid[0:height, 0:width].astype(np.int64)
    found = {"name": name, "width": width, "height": height, "linear": metrics(a, b, 1),
             "displayed": metrics(displayed(a), displayed(b), 255), "others": others(a, b)}
    regions = {"masked": in_mask(x, y), "covered": layers(x, y, 3) > 0, "equal": layers(x, y, 3) == layers(x, y, 4)}
    if min(width, height) > 20:
        found |= {region: masked(a, b, mask) for region, mask in regions.items()}
    return found


def write_expectations():
    scaled = []
    for name, width, height, fx, fy in SCALED:
        value = ms_ssim(picture(width, height, fx), picture(width, height, fy))
        scaled.append({"name": name, "width": width, "height": height, "ms_ssim": value})
    path = pathlib.Path(__file__).parent.parent / "tests/compare/data/metrics.json"
    made_by = f"scikit-image {skimage.__version__}, scripts/make-metric-expectations.py"
    found = {"made_by": made_by, "pairs": [expectation(*pair) for pair in PAIRS], "scaled": scaled}
    path.write_text(json.dumps(found, indent=1) + "\n")


if __name__ == "__main__":
    if "--time" in sys.argv:
        print(f"scikit-image's SSIM: {ssim_milliseconds():.0f} ms")
    else:
        write_expectations()
