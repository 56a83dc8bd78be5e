# SPDX-License-Identifier: GPL-3.0-or-later
"""Sheets across the picture: what lies behind each pixel is known."""

import numpy as np
import pellucid

CAMERA = {"type": "orthographic", "eye": [0, 0, 5], "target": [0, 0, 0], "up": [0, 1, 0], "height": 2}


def sheet(z, rgba, half=2.0):
    """A square at height z, larger than the picture."""
    vertices = np.array([[-half, -half, z], [half, -half, z], [half, half, z], [-half, half, z]])
    colors = np.tile(np.array(rgba, dtype=np.float32), (4, 1))
    return pellucid.Mesh(vertices, [[0, 1, 2], [0, 2, 3]], colors=colors)


def stack(opacities, color=(0.25, 0.5, 0.75), resolution=(24, 16)):
    """Sheets of one colour behind each other, the first one in front."""
    objects = [{"mesh": sheet(-0.1 * i, (*color, a))} for i, a in enumerate(opacities)]
    return pellucid.load_scene({"camera": CAMERA, "resolution": resolution, "objects": objects})
