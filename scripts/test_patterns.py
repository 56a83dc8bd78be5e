# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the tests of metrics, as functions of integer arrays: the pixel x, y and the channel c."""


def hashed(x, y, c, seed):
    """A 32-bit integer hash of the pixel, as noise in [0, 1)."""
    h = (x * 73856093 ^ y * 19349663 ^ c * 83492791 ^ seed * 2654435761) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 0x45D9F3B) & 0xFFFFFFFF
    h = ((h ^ (h >> 16)) * 0x45D9F3B) & 0xFFFFFFFF
    return (h ^ (h >> 16)) / 4294967296.0


def gradient(x, y, c):
    return (3 * x + 5 * y + 40 * c) % 256 / 255.0


def rings(x, y, c):
    return (x * x + y * y + 17 * c) % 301 / 300.0


def noise(x, y, c):
    return hashed(x, y, c, 1)


def grainy(x, y, c):
    return 0.9 * gradient(x, y, c) + 0.1 * noise(x, y, c)
