# SPDX-License-Identifier: GPL-3.0-or-later
"""Crossings of rays: known ones, and all of a picture against the picture."""

import numpy as np
import pellucid
import pytest
from sheets import CAMERA, stack


def test_crossings_of_a_stack_are_known():
    crossings = stack([0.5, 0.25, 0.125]).crossings(3, 4)
    assert len(crossings) == 3
    assert crossings.depth == pytest.approx([5, 5.1, 5.2], rel=1e-14)
    assert crossings.opacity.tolist() == [0.5, 0.25, 0.125]
    assert crossings.transmittance.tolist() == [1, 0.5, 0.375]
    assert crossings.optical_depth == pytest.approx(-np.cumsum(np.log1p([-0.5, -0.25, -0.125])))
    assert crossings.object.tolist() == [0, 1, 2]
    assert crossings.color.tolist() == [[0.25, 0.5, 0.75]] * 3
    assert crossings.pixel_transmittance == 0.5 * 0.75 * 0.875


def random_scene(seed, resolution=(20, 14)):
    rng = np.random.default_rng(seed)
    mesh = pellucid.Mesh(rng.uniform(-1, 1, (40, 3)), rng.integers(0, 40, (60, 3)),
                         colors=rng.uniform(0, 1, (40, 4)).astype(np.float32))
    return pellucid.load_scene({"camera": CAMERA, "resolution": resolution, "objects": [{"mesh": mesh}]})


@pytest.mark.parametrize("seed", range(5))
def test_a_deep_picture_composites_to_the_picture(seed):
    scene = random_scene(seed)
    picture, deep = scene.render("raytrace"), scene.deep()
    assert deep.shape == (14, 20)
    assert (np.diff(deep.offsets.astype(np.int64)) == picture.layers.ravel()).all()
    weight = deep.transmittance * deep.opacity
    for pixel in range(14 * 20):
        part = slice(*deep.offsets[pixel:pixel + 2].astype(int))
        through = np.prod(1 - deep.opacity[part])
        color = (weight[part, None] * deep.color[part]).sum(axis=0) + through
        # Both are rounded to float once; sums of a few dozen doubles lose far less.
        assert np.abs(picture.image[divmod(pixel, 20)] - [*color, 1 - through]).max() <= 2.0**-24
        assert (np.diff(deep.depth[part]) >= 0).all()


def test_one_ray_is_that_of_the_deep_picture():
    scene = random_scene(11)
    deep = scene.deep()
    for x, y in (0, 0), (19, 13), (7, 9):
        part = slice(*deep.offsets[y * 20 + x:y * 20 + x + 2].astype(int))
        one = scene.crossings(x, y)
        assert (one.depth == deep.depth[part]).all() and (one.primitive == deep.primitive[part]).all()


def test_crossings_follow_the_scene():
    scene = stack([0.5])
    assert len(scene.crossings(0, 0)) == 1
    scene.camera = {**CAMERA, "target": [0, 0, 10]}  # the other way
    with pytest.raises(pellucid.InputError, match="camera"):
        scene.crossings(0, 0)
