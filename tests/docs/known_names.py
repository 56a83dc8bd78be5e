# SPDX-License-Identifier: GPL-3.0-or-later
"""The names that a document has to describe: the keys that the program accepts in the document's files, from what it
says of a key that it does not know, and the columns of the tables that the examples have left."""

import csv
import json
import re
import subprocess

UNKNOWN = {"?": 0}
SCENE = {"format": "pellucid-scene", "version": 1}
SEED = {"from": [0, 0, 0], "to": [1, 0, 0]}
LINES = {"field": "rotation", "integrator": "stream-lines", "seed": SEED, "duration": 1}
LEVELS = {"dataset": "sphere-levels:levels=1", "scalar": "q", "value": 0.1}
STACK = {"dataset": "stack"}
STUDY = {"format": "pellucid-study", "version": 1, "scenes": ["stack.json"], "reference": "raytrace",
         "methods": ["linked-list"]}


def scene_with(**item):
    return {**SCENE, "objects": [item]}


# A file for each of its parts: that part has the unknown key.
SCENES = [
    {**SCENE, **UNKNOWN},
    {**SCENE, "camera": UNKNOWN},
    {**SCENE, "energy": UNKNOWN},
    {**SCENE, "objects": [STACK], "camera_path": UNKNOWN},
    scene_with(**UNKNOWN),
    scene_with(**STACK, color=UNKNOWN),
    scene_with(**STACK, opacity=UNKNOWN),
    scene_with(**STACK, transform=UNKNOWN),
    scene_with(**STACK, transform={"rotate": UNKNOWN}),
    scene_with(surface=UNKNOWN),
    scene_with(lines={**LINES, "seed": UNKNOWN}),
    scene_with(lines=UNKNOWN),
    scene_with(lines=LINES, radius=1, halo=UNKNOWN),
    scene_with(lines=LINES, radius=UNKNOWN),
    scene_with(isosurface=UNKNOWN),
    scene_with(isosurface={**LEVELS, "hole": UNKNOWN}),
]
STUDIES = [
    {**STUDY, **UNKNOWN},
    {**STUDY, "methods": [{"method": "*", **UNKNOWN}]},
    {**STUDY, "methods": [{"external": "mine", "command": ["{output}"], **UNKNOWN}]},
    {**STUDY, "methods": [{"picture": "theirs.exr", "name": "theirs", **UNKNOWN}]},
    {**STUDY, "integrators": [{"integrator": "*", **UNKNOWN}]},
    {**STUDY, "timing": UNKNOWN},
    {**STUDY, "budget": UNKNOWN},
    {**STUDY, "claims": [UNKNOWN]},
    {**STUDY, "published": UNKNOWN},
    {**STUDY, "published": {"machine": "", "rows": [UNKNOWN]}},
]


def keys_named(command, folder):
    """Those in the message of a command that fails."""
    message = subprocess.run(command, cwd=folder, capture_output=True, text=True).stderr
    known = re.search(r"unknown key '\?'; known: (.*)", message)
    if not known:
        raise RuntimeError(f"{' '.join(command)}: names no keys, but says {message}")
    return set(known[1].split(", "))


def keys_of(parts, command, options, folder):
    found = set()
    for part in parts:
        (folder / "part.json").write_text(json.dumps(part))
        found |= keys_named(["pellucid", command, "part.json", *options], folder)
    return found


def columns_of(folder):
    """Of every results.csv."""
    found = set()
    for path in folder.rglob("results.csv"):
        with path.open(newline="") as file:
            found.update(next(csv.reader(file)))
    return found


def names_of(document, folder):
    """None for a document that describes no file."""
    if document == "scene-file.md":
        return keys_of(SCENES, "render", ["-m", "raytrace", "-o", "none.png"], folder)
    if document == "study-file.md":
        (folder / "stack.json").write_text(json.dumps(scene_with(**STACK)))
        return keys_of(STUDIES, "study", ["-o", "none"], folder) | columns_of(folder)
    return set()
