#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""f3d draws an exported scene: f3d_transparency.py SCENE.json OUTPUT.png, by Debian's f3d.

It opens the scene's glTF with the scene's camera and with depth peeling; without a display by xvfb:

    xvfb-run -a pellucid conform --output png --command \\
        '/usr/bin/python3 adapters/f3d_transparency.py {scene} {output}'
"""

import json
import subprocess
import sys
import time
from pathlib import Path


def main(scene_file, output):
    scene = json.loads(Path(scene_file).read_text())
    command = ["f3d", Path(scene_file).parent / scene["gltf"], "--dry-run", "--quiet", "--depth-peeling", "--camera-index", "0",
               "--resolution=%d,%d" % tuple(scene["resolution"]), "--bg-color=%.9g,%.9g,%.9g" % tuple(scene["background"]),
               "--output", output]
    start = time.perf_counter()
    subprocess.run(command, check=True)
    seconds = time.perf_counter() - start
    Path(output + ".json").write_text(json.dumps({"ms": 1e3 * seconds}))  # with its start: f3d tells no other time


main(*sys.argv[1:])
