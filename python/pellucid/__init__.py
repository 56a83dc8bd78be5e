# SPDX-License-Identifier: GPL-3.0-or-later
"""Pellucid renders transparent flow visualizations exactly, renders them by order-independent methods,
and says how far each is from the truth.

    scene = pellucid.load_scene("scene.json")
    truth = scene.render("raytrace")
    print(pellucid.compare(truth, scene.render("fourier:bands=5"))["rmse"])

Arrays are NumPy's, lengths are in world units, row 0 of a picture is the top. Wrong input raises
InputError, work that fails WorkError.
"""

from ._pellucid import (
    Crossings,
    Deep,
    InputError,
    Lines,
    Mesh,
    Points,
    Rendering,
    Results,
    Scene,
    Surface,
    WorkError,
    __version__,
    compare,
    load_scene,
    run_study,
    trace,
)

__all__ = [
    "Crossings",
    "Deep",
    "InputError",
    "Lines",
    "Mesh",
    "Points",
    "Rendering",
    "Results",
    "Scene",
    "Surface",
    "WorkError",
    "__version__",
    "compare",
    "load_scene",
    "run_study",
    "trace",
]
for _name in __all__:
    if hasattr(globals()[_name], "__module__"):
        try:
            globals()[_name].__module__ = "pellucid"
        except (AttributeError, TypeError):  # functions of C have none that can be set
            pass
del _name
