# SPDX-License-Identifier: GPL-3.0-or-later
"""Renderers with one fault each, on top of the independent renderer of exported scenes."""

import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).parent.parent / "export"))
import independent_renderer as independent  # noqa: E402


class Fragments(independent.Fragments):
    """A pixel's centre on an edge belongs to one side: all rays are moved by far less than a pixel, the same way."""

    def __init__(self, view):
        super().__init__(view)
        self.origins = self.origins + numpy.array([1, 0.3, 0]) * 1e-7 * view.pixel * (not view.perspective)
        self.directions = self.directions + numpy.array([1, 0.3, 0]) * 1e-7 * view.pixel * view.perspective

    def in_pixels(self):
        """Of each pixel its colours, the nearest first, and its depths."""
        pixel, depth, order, color = (numpy.concatenate(part) for part in zip(*self.parts))
        shown = numpy.flatnonzero(depth <= self.opaque.ravel()[pixel])
        shown = shown[numpy.lexsort((order[shown], depth[shown]))]
        for p in range(self.view.width * self.view.height):
            at = shown[pixel[shown] == p]
            yield color[at], depth[at]

    def composite(self, background):
        return numpy.array([self.pixel(c, d, numpy.array(background)) for c, d in self.in_pixels()]).reshape(
            self.view.height, self.view.width, 4)

    def pixel(self, colors, depths, background):
        picture, left = numpy.zeros(3), 1.0
        for c in colors:
            picture, left = picture + left * c[3] * c[:3], left * (1 - c[3])
        return numpy.append(picture + left * background, 1 - left)


class Capped(Fragments):
    def pixel(self, colors, depths, background):
        return super().pixel(colors[:4], depths, background)


class Backwards(Fragments):
    def pixel(self, colors, depths, background):
        return super().pixel(colors[::-1], depths, background)


class LosesEqualDepths(Fragments):
    """Peeling that discards what is not behind the last layer."""

    def pixel(self, colors, depths, background):
        new = numpy.append(True, numpy.diff(depths) > 0)[:len(colors)]
        return super().pixel(colors[new], depths, background)


class EightBits(Fragments):
    """Blending into a frame buffer of 8 bits, sorted."""

    def pixel(self, colors, depths, background):
        picture = numpy.round(background * 255) / 255
        for c in colors[::-1]:
            picture = numpy.round((picture * (1 - c[3]) + c[:3] * c[3]) * 255) / 255
        return numpy.append(picture, 1)


class BlackBehind(Fragments):
    def pixel(self, colors, depths, background):
        return super().pixel(colors, depths, 0 * background)


class Doubles(Fragments):
    """Both triangles of an edge have it."""

    def __init__(self, view):
        super().__init__(view)
        self.origins, self.directions = view.origins_and_directions()

    def add_triangle(self, corners, colors, order, opaque, shade):
        a, b, c = (corner - self.origins for corner in corners)
        volumes = numpy.stack([(numpy.cross(p, q) * self.directions).sum(-1) for p, q in ((b, c), (c, a), (a, b))], -1)
        inside = (volumes >= 0).all(-1) | (volumes <= 0).all(-1)
        weights = numpy.where(inside[..., None], volumes / volumes.sum(-1, keepdims=True), 1 / 3)
        self.add(inside, weights @ numpy.array(corners)[:, 2], shade(weights @ colors, weights, None), order, opaque)


class MissesEdges(Doubles):
    def add_triangle(self, corners, colors, order, opaque, shade):
        independent.Fragments.add_triangle(self, corners, colors, order, opaque, shade)


MOCKS = {"right": Fragments, "capped": Capped, "backwards": Backwards, "loses": LosesEqualDepths, "eight": EightBits,
         "black": BlackBehind, "doubles": Doubles, "misses": MissesEdges}


def render(mock, scene):
    return independent.render(scene, MOCKS[mock])


if __name__ == "__main__":
    independent.exr.write(sys.argv[3], render(sys.argv[1], sys.argv[2]))
