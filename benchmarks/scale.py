#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws clouds of up to a billion points by parts, and prints what each step took: scale.py [-o FOLDER] [COUNT …]

    benchmarks/scale.py 1e6 1e7 1e8                      a table, and FOLDER/scale.json
    benchmarks/scale.py 1e9 --methods raytrace,fourier   half an hour, 4 GiB, 4 GB of disk

A cloud of COUNT points is objects of 15 625 000 points at most, of each the stand-in `dark-sky` with a seed of its own. `--bounds` is
written first, then each object is drawn as a part, by `raytrace` into a deep picture, by another method into its sums, and `merge`
composites the parts. Radii shrink with the root of COUNT, so that as many points lie behind a pixel in every cloud. Wall clock,
processor time and the largest resident memory are those of the processes, the helpers that read files among them.
"""

import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

MOST = 15_625_000  # points of an object
RADIUS, AT = 0.0035, 4e6  # of a point in a cloud of so many


def measured(program, *words):
    """Seconds on the wall, seconds of processors, bytes; exits when the program fails."""
    start = time.perf_counter()
    process = subprocess.Popen([program, *map(str, words)], stdout=subprocess.PIPE, text=True)
    told = process.stdout.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{program} {' '.join(map(str, words))}: exit {os.waitstatus_to_exitcode(status)}")
    return {"seconds": time.perf_counter() - start, "processor": usage.ru_utime + usage.ru_stime, "bytes": 1024 * usage.ru_maxrss}, told


def together(runs):
    return {"seconds": sum(run["seconds"] for run in runs), "processor": sum(run["processor"] for run in runs),
            "bytes": max(run["bytes"] for run in runs)}


def write_scene(file, count, size):
    objects = math.ceil(count / MOST)
    each = [count // objects + (i < count % objects) for i in range(objects)]
    radius = RADIUS * math.sqrt(AT / count)
    file.write_text(json.dumps({
        "format": "pellucid-scene", "version": 1, "resolution": [size, size],
        "objects": [{"dataset": f"dark-sky:count={n},seed={i + 1}", "radius": radius, "opacity": 0.3}
                    for i, n in enumerate(each)]}))
    return objects


def draw(program, folder, count, method, size):
    scene, bounds = folder / "scene.json", folder / "bounds.json"
    parts = write_scene(scene, count, size)
    kind = "--deep" if method == "raytrace" else "--partial"
    files = [folder / f"part-{i}.exr" for i in range(1, parts + 1)]
    steps = {"bounds": measured(program, "render", scene, "--bounds", bounds, "--quiet")[0]}
    runs = []
    for i, file in enumerate(files, 1):
        runs.append(measured(program, "render", scene, "-m", method, "--part", f"{i}/{parts}", "--bounds", bounds, kind, file, "--quiet")[0])
        print(f"{count:.0e} {method}: part {i} of {parts}, {runs[-1]['seconds']:.1f} s, {runs[-1]['bytes'] / 2**30:.2f} GiB", file=sys.stderr)
    steps["drawing"] = together(runs)
    steps["merge"], told = measured(program, "merge", *files, "-o", folder / "merged.exr", "--json", "--quiet")
    written = sum(file.stat().st_size for file in files)
    for file in files:
        file.unlink()
    return {"count": count, "method": method, "parts": parts, "written": written, "merged": json.loads(told), **steps}


def row(result):
    steps = [result[step] for step in ("bounds", "drawing", "merge")]
    all_seconds, most = sum(step["seconds"] for step in steps), max(step["bytes"] for step in steps)
    cells = [f"{result['count']:.0e}", result["method"], str(result["parts"]), *(f"{step['seconds']:.1f}" for step in steps),
             f"{1e6 * all_seconds / result['count']:.2f}", f"{most / 2**30:.2f}", f"{result['written'] / 1e9:.2f}"]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("counts", nargs="*", type=float, default=[1e6, 1e7, 1e8], metavar="COUNT")
    parser.add_argument("--methods", default="raytrace")
    parser.add_argument("--size", type=int, default=1000, help="pixels along each side")
    parser.add_argument("--program", default="build/release/pellucid")
    parser.add_argument("-o", "--output", type=pathlib.Path, help="folder that keeps scale.json and the pictures")
    arguments = parser.parse_args()
    results = []
    print("| points | method | parts | bounds [s] | drawing [s] | merge [s] | s per million | most GiB | GB on disk |\n|" + "---|" * 9)
    if arguments.output:
        arguments.output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=arguments.output) as name:
        folder = pathlib.Path(name)
        for count in arguments.counts:
            for method in arguments.methods.split(","):
                results.append(draw(arguments.program, folder, int(count), method, arguments.size))
                print(row(results[-1]), flush=True)
                if arguments.output:
                    (folder / "merged.exr").rename(arguments.output / f"{count:.0e}-{method.split(':')[0]}.exr")
                    (arguments.output / "scale.json").write_text(json.dumps(results, indent=1))


main()
