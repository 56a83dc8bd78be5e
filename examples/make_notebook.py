#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes notebook.ipynb beside this file and executes it (Debian: python3-nbclient, python3-ipykernel):
PYTHONPATH=build/release/python examples/make_notebook.py"""

from pathlib import Path

import nbformat
from nbclient import NotebookClient

CELLS = [
    """# From arrays to an error
A surface of the ABC flow, exactly and by two order-independent methods; what a pixel's ray crosses; what it costs.""",
    ["import numpy as np", "import pellucid"],
    """A stream surface, integrated from a segment. Lengths are in world units; `quality` says how far the mesh is from the true
surface at 200 points.""",
    ["surface = pellucid.trace('abc', 'hultquist:particles=40', [[2.6, 3.1, 3.1], [3.6, 3.1, 3.1]], duration=4, samples=200)",
     "print(surface)",
     "print('farthest from the true surface:', round(surface.quality['distance']['max'], 4))"],
    "A scene of it, coloured by the time since the seed. The camera that is not given sees all.",
    ["scene = pellucid.load_scene({'resolution': (320, 240), 'objects': [",
     "    {'mesh': surface, 'opacity': 0.4, 'color': {'by': 't', 'map': 'viridis'}}]})",
     "truth = scene.render('raytrace')",
     "truth"],
    "Its error by methods that do not sort.",
    ["for method in ['weighted-sum', 'weighted-average', 'fourier:bands=5', 'linked-list']:",
     "    metrics = pellucid.compare(truth, scene.render(method))",
     "    print(f\"{method:20} RMSE {metrics['rmse']:.4f}  SSIM {metrics['ssim']:.3f}\")"],
    "What the ray of the pixel with most layers crosses, and the composite made by hand.",
    ["y, x = np.unravel_index(truth.layers.argmax(), truth.layers.shape)",
     "ray = scene.crossings(x, y)",
     "color = (ray.color * (ray.transmittance * ray.opacity)[:, None]).sum(axis=0) + ray.pixel_transmittance",
     "print(len(ray), 'layers; by hand and in the picture equal:', np.allclose(color, truth.image[y, x, :3], atol=1e-7))"],
    "Where layers are many: the deep picture as flat arrays.",
    ["deep = scene.deep()",
     "layers, pixels = np.unique(np.diff(deep.offsets), return_counts=True)",
     "print(dict(zip(layers.tolist(), pixels.tolist())))"],
]


def main():
    notebook = nbformat.v4.new_notebook(metadata={"kernelspec": {"name": "python3", "language": "python",
                                                                 "display_name": "Python 3"}})
    for number, cell in enumerate(CELLS):
        made = (nbformat.v4.new_markdown_cell(cell) if isinstance(cell, str)
                else nbformat.v4.new_code_cell("\n".join(cell)))
        made["id"] = f"cell-{number}"
        notebook.cells.append(made)
    NotebookClient(notebook, kernel_name="python3").execute()
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)  # times, which differ on each run
    nbformat.write(notebook, Path(__file__).with_name("notebook.ipynb"))


if __name__ == "__main__":
    main()
