#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs the program on what may go wrong, and counts what it may never do: soak.py [MINUTES].

Every run has a seed; what broke a promise is printed with it, so that

    soak.py --runs 1 --seed SEED --keep DIR

does it again and leaves the files. A promise is broken by a crash, by a run of more than a minute,
by an exit code other than 0, 1 and 2, by more or less than one line on stderr of a run that fails,
by a line of a refusal that does not name the file, and by a file left behind that was not asked for.
"""

import argparse
import collections
import concurrent.futures
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from files import OPTIONS, PART_OF, Seeds, mutated, scene_of

LONGEST = 60  # seconds a run may take


class Broken(Exception):
    """A promise that a run did not keep: its kind, and what happened."""

    def __init__(self, kind, what):
        super().__init__(what)
        self.kind = kind


class Run:
    """One run's folder, random numbers and program."""

    def __init__(self, program, seed, folder):
        self.program, self.random, self.folder = program, random.Random(seed), Path(folder)

    def call(self, *arguments, environment=None, wait=LONGEST):
        words = [self.program, *map(str, arguments)]
        try:
            return subprocess.run(words, capture_output=True, timeout=wait, cwd=self.folder,
                                  env={**os.environ, **(environment or {})})
        except subprocess.TimeoutExpired:
            raise Broken("hang", f"over {wait} s: {' '.join(words[1:])}") from None

    def kept_promises(self, result, named, outputs, codes=(0, 1, 2)):
        error = result.stderr.decode(errors="surrogateescape")
        if result.returncode < 0:
            raise Broken("crash", f"signal {signal.Signals(-result.returncode).name}: {error[-300:]}")
        if result.returncode not in codes:
            raise Broken("violation", f"exit code {result.returncode}: {error[-300:]}")
        if result.returncode and error.count("\n") != 1:
            raise Broken("violation", f"{error.count(chr(10))} lines on stderr: {error[:300]!r}")
        if result.returncode == 2 and named and not any(name in error for name in named):
            raise Broken("violation", f"does not name {named}: {error!r}")
        left = {p.name for p in self.folder.iterdir()} - self.before - set(outputs)
        if left:
            raise Broken("violation", f"left behind: {sorted(left)}")
        # Outputs are written one after another, each whole: of one that fails, those before it may be there.
        if result.returncode and outputs and (self.folder / outputs[-1]).exists():
            raise Broken("violation", f"failed and left its output: {outputs}")
        for picture in [o for o in outputs[:-1] if result.returncode and (self.folder / o).exists()]:
            if self.call("compare", picture, picture).returncode:
                raise Broken("violation", f"failed and left a part of its output {picture}")

    def check(self, arguments, named=None, outputs=(), **options):
        self.before = {p.name for p in self.folder.iterdir()}
        self.kept_promises(self.call(*arguments, **options), named, outputs)


def command_for(name, rng):
    """The arguments that make the program read this file, and the outputs it may leave."""
    ending = Path(name).suffix
    if name in ("deep.exr", "sums.exr"):
        return ["merge", name, "-o", "out.exr", "--quiet"], ["out.exr"]
    if name == "study.json":
        return ["study", name, "--plan", "--quiet"], []
    if ending in (".exr", ".png"):
        return ["compare", "other" + ending, name], []
    if name == "scene.json":
        return ["render", name, "-m", rng.choice(["raytrace", "linked-list"]), "-o", "out.exr",
                "--quiet"], ["out.exr"]
    if name == "method.json":
        return ["render", "scene.json", "-m", "glsl:file=method.json", "-o", "out.exr", "--quiet"], ["out.exr"]
    if name.startswith("field"):
        return ["trace", "--field", name + OPTIONS.get(ending, ""), "--integrator", "stream-lines:particles=2", "--seed",
                "0.1,0.1,0.1:1,1,1", "--duration", "1", "-o", "out.ply", "--quiet"], ["out.ply"]
    return ["render", "of.json", "-m", "raytrace", "-o", "out.exr", "--quiet"], ["out.exr"]


# ------------------------------------------------------------------ kinds of runs


def mutate(run, seeds):
    name = run.random.choice(seeds.names)
    for other in seeds.names:
        if other != name:
            shutil.copy(seeds.folder / other, run.folder / other)
    for ending in (".exr", ".png"):
        shutil.copy(seeds.folder / ("a" + ending), run.folder / ("other" + ending))
    (run.folder / name).write_bytes(mutated((seeds.folder / name).read_bytes(), run.random))
    read = PART_OF.get(name, name)
    kind = read.split(".")[0]
    if kind == "levels":
        thing = {"isosurface": {"file": read, "value": 0.5,
                                "scalar": "q" if read.endswith(".vdb") else "ImageScalars"}}
    else:
        thing = {kind: read, "radius": 0.02} if kind in ("lines", "points") else {"mesh": read}
    (run.folder / "of.json").write_text(scene_of([thing]))
    arguments, outputs = command_for(read, run.random)
    run.check(arguments, named=[name, read], outputs=outputs)


STUDY = {"format": "pellucid-study", "version": 1, "scenes": ["one.json", "two.json"],
         "reference": "raytrace", "methods": ["weighted-average", {"method": "fourier", "bands": [1, 2]}],
         "repeats": 1}


def study_folder(run):
    (run.folder / "one.json").write_text(scene_of([{"dataset": "stack:layers=3"}]))
    (run.folder / "two.json").write_text(
        scene_of([{"dataset": "benzene:count=5,seed=1", "radius": 0.05}]))
    (run.folder / "study.json").write_text(json.dumps(STUDY))


def numbers(folder):
    rows = json.loads((folder / "results.json").read_text())["rows"]
    return [(r["scene"], r["method"], r["parameters"], r.get("fragments"), r.get("metrics", {}).get("rmse"))
            for r in rows]


def kill(run, seeds):
    """A study that is killed at any moment and resumed has the numbers of one that was not."""
    study_folder(run)
    whole = run.call("study", "study.json", "-o", "whole", "--quiet")
    if whole.returncode:
        raise Broken("violation", f"the study failed: {whole.stderr.decode()}")
    for _ in range(run.random.choice([1, 2])):
        process = subprocess.Popen([run.program, "study", "study.json", "-o", "part", "--quiet", "--resume"],
                                   cwd=run.folder, stderr=subprocess.DEVNULL)
        time.sleep(run.random.uniform(0.1, 2))
        process.kill()
        process.wait()
    result = run.call("study", "study.json", "-o", "part", "--quiet", "--resume")
    if result.returncode:
        raise Broken("violation", f"resuming failed: {result.stderr.decode()}")
    if numbers(run.folder / "whole") != numbers(run.folder / "part"):
        raise Broken("violation", "resumed, the study has other numbers")
    hidden = [p for p in (run.folder / "part").rglob(".*") if p.is_file()]
    if hidden:
        raise Broken("violation", f"left behind: {hidden}")


def simple_command(run):
    (run.folder / "scene.json").write_text(scene_of([{"dataset": "stack:layers=3"}]))
    return run.random.choice([
        (["render", "scene.json", "-m", "raytrace", "-o", "out.exr", "--quiet"], ["out.exr"]),
        (["render", "scene.json", "-m", "raytrace", "-o", "out.png", "--stats", "out.json", "--quiet"],
         ["out.png", "out.json"]),
        (["data", "stack:layers=40", "-o", "out.ply", "--quiet"], ["out.ply"]),
        (["data", "stack:layers=40", "-o", "out.vtp", "--quiet"], ["out.vtp"]),
        (["data", "sphere-levels", "-o", "out.vdb", "--quiet"], ["out.vdb"]),
        (["trace", "--field", "abc", "--integrator", "fixed-front:particles=30", "--seed",
          "1,1,1:2,2,2", "--duration", "2", "-o", "out.ply", "--quiet"], ["out.ply"])])


def fail_write(run, seeds):
    arguments, outputs = simple_command(run)
    run.check(arguments, outputs=outputs,
              environment={"LD_PRELOAD": seeds.preload, "FAIL_WRITE": str(run.random.randrange(1, 12))})


def fail_allocation(run, seeds):
    arguments, outputs = simple_command(run)
    run.check(arguments, outputs=outputs,
              environment={"LD_PRELOAD": seeds.preload, "FAIL_SIZE": str(1 << run.random.randrange(16, 23)),
                           "FAIL_ALLOCATION": str(run.random.randrange(1, 30))})


def full_disk(run, seeds):
    """Writes into a file system of a few KiB, where the machine lets us mount one."""
    disk = run.folder / "disk"
    disk.mkdir()
    size = f"size={run.random.choice([4, 16, 64, 256])}k"
    if subprocess.run(["mount", "-t", "tmpfs", "-o", size, "tmpfs", disk], capture_output=True).returncode:
        return
    try:
        arguments, outputs = simple_command(run)
        inside = ["disk/" + a if a in outputs else a for a in arguments]
        run.before = {p.name for p in run.folder.iterdir()}
        result = run.call(*inside)
        run.kept_promises(result, None, [])
        left = sorted(p.name for p in disk.iterdir())
        if result.returncode and set(left) - set(outputs):
            raise Broken("violation", f"left on the full disk: {left}")
    finally:
        subprocess.run(["umount", disk], check=True)


KINDS = [(mutate, 90), (kill, 1), (fail_write, 4), (fail_allocation, 3), (full_disk, 2)]


# ------------------------------------------------------------------ all of it


def one(program, seeds, seed, keep):
    folder = Path(keep) if keep else Path(tempfile.mkdtemp(prefix="pellucid-soak-"))
    folder.mkdir(exist_ok=True)
    rng = random.Random(seed)
    kind = rng.choices([k for k, _ in KINDS], [w for _, w in KINDS])[0]
    try:
        kind(Run(program, seed, folder), seeds)
        return kind.__name__, None, None
    except Broken as broken:
        return kind.__name__, broken.kind, f"seed {seed}, {kind.__name__}: {broken}"
    finally:
        if not keep:
            shutil.rmtree(folder, ignore_errors=True)


def compiled_preload(folder):
    source = Path(__file__).with_name("fail_nth.c")
    library = Path(folder) / "fail_nth.so"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", "-o", library, source, "-ldl"], check=True)
    return str(library)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("minutes", nargs="?", type=float, default=10)
    parser.add_argument("--runs", type=int, help="so many runs instead of minutes")
    parser.add_argument("--seed", type=int, default=1, help="of the first run")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--program", default="build/release/pellucid")
    parser.add_argument("--keep", help="leave the files of a single run in this folder")
    arguments = parser.parse_args()
    program = str(Path(arguments.program).resolve())
    count, broken = collections.Counter(), collections.Counter()
    end = time.time() + 60 * arguments.minutes
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        (Path(folder) / "seeds").mkdir()
        seeds = Seeds(program, Path(folder) / "seeds")
        seeds.preload = compiled_preload(folder)
        pending, seed = set(), arguments.seed
        more = lambda: (seed - arguments.seed < arguments.runs) if arguments.runs else time.time() < end
        while pending or more():
            while more() and len(pending) < 2 * arguments.jobs:
                pending.add(pool.submit(one, program, seeds, seed, arguments.keep))
                seed += 1
            done, pending = concurrent.futures.wait(pending, return_when=concurrent.futures.FIRST_COMPLETED)
            for result in done:
                kind, what, why = result.result()
                count[kind] += 1
                if what:
                    broken[what] += 1
                    print(why, flush=True)
    kinds = ", ".join(f"{k} {n}" for k, n in sorted(count.items()))
    print(f"{sum(count.values())} runs ({kinds}): {broken['crash']} crashes, {broken['hang']} hangs, "
          f"{broken['violation']} violations")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
