#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""A study by Snakemake on this machine's cores, beside the same study in one run. Ends with 77, skipped, without Snakemake."""

import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("PELLUCID_PROGRAM", str(ROOT / "build/release/pellucid"))

SCENE = {"format": "pellucid-scene", "version": 1, "resolution": [48, 40], "objects": [{"dataset": "stack:layers=4"}]}
SHEET = """ply
format ascii 1.0
element vertex 3
property float x
property float y
property float z
property float alpha
element face 1
property list uchar int vertex_indices
end_header
-1 -1 0 0.5
1 -1 0 0.25
0 1 0 0.75
3 0 1 2
"""
# A program that fails when it is run for the first time.
SCRIPT = """#!/bin/sh
[ -e {folder}/tried ] || {{ touch {folder}/tried; exit 3; }}
cp {folder}/theirs.exr "$1"
"""


class Workflow(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name in "one", "two":
            (self.folder / f"{name}.json").write_text(json.dumps(SCENE))
        subprocess.run([PROGRAM, "render", "one.json", "-m", "weighted-sum", "-o", "theirs.exr", "--quiet"],
                       cwd=self.folder, check=True, stdout=subprocess.DEVNULL)

    def study(self, methods, repeats=2, scenes=("one.json", "two.json")):
        study = {"format": "pellucid-study", "version": 1, "scenes": list(scenes), "reference": "raytrace",
                 "methods": methods, "repeats": repeats}
        (self.folder / "study.json").write_text(json.dumps(study))

    def run_workflow(self, *more):
        return subprocess.run(["snakemake", "-s", ROOT / "workflow/Snakefile", "--cores", "2", "--keep-going", "--nocolor",
                               "--config", "study=study.json", "out=cells", f"pellucid={PROGRAM}", *more],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)

    def rows(self, folder):
        """The rows of a table without times, and without bytes: ray tracing has some for each thread that took part."""
        with open(self.folder / folder / "results.csv", newline="") as file:
            return [{key: value for key, value in row.items()
                     if "seconds" not in key and not key.startswith("ms") and not key.endswith("_ms") and key != "bytes"}
                    for row in csv.DictReader(file)]

    def expect_as_in_one_run(self):
        subprocess.run([PROGRAM, "study", "study.json", "-o", "whole", "--quiet"], cwd=self.folder, check=True)
        self.assertEqual(self.rows("cells"), self.rows("whole"))
        for picture in (self.folder / "whole/images").rglob("*.*"):
            there = self.folder / "cells" / picture.relative_to(self.folder / "whole")
            self.assertEqual(picture.read_bytes(), there.read_bytes(), picture)

    def test_timed_scenes_and_a_picture_make_the_table_of_one_run(self):
        self.study(["weighted-average", {"method": "fourier", "bands": [1, 2]},
                    {"picture": "theirs.exr", "name": "theirs"}])
        done = self.run_workflow()
        self.assertEqual(done.returncode, 0, done.stdout)
        self.expect_as_in_one_run()
        logs = sorted(p.relative_to(self.folder / "cells/log").as_posix() for p in (self.folder / "cells/log").rglob("*.done"))
        self.assertEqual(logs, ["report.done", "single/4.done", "single/9.done", "timed/one.done", "timed/two.done"])
        self.assertIn("Nothing to be done", self.run_workflow().stdout)

    def add_mesh_scene(self, name):
        """A scene of a file beside it, which its own text says nothing of."""
        (self.folder / "sheet.ply").write_text(SHEET)
        (self.folder / name).write_text(json.dumps({**SCENE, "objects": [{"mesh": "sheet.ply"}]}))

    def test_what_has_changed_beneath_a_study_is_computed_again(self):
        # Braces, which Snakemake takes for a wildcard, and what Python takes for the end of a line.
        self.add_mesh_scene("{mesh}\u2028.json")
        self.study(["weighted-average"], scenes=("one.json", "{mesh}\u2028.json"))
        self.assertEqual(self.run_workflow().returncode, 0)
        (self.folder / "sheet.ply").write_text(SHEET.replace("0 1 0 0.75", "0 0.5 0 0.25"))
        row = self.folder / "cells/cells/one/raytrace.json"
        of_another_build = json.loads(row.read_text())
        of_another_build["machine"]["build"] = "another"
        row.write_text(json.dumps(of_another_build))
        again = self.run_workflow()
        self.assertEqual(again.returncode, 0, again.stdout)
        self.expect_as_in_one_run()
        self.assertNotIn('"another"', row.read_text())
        self.assertIn("Nothing to be done", self.run_workflow().stdout)

    def test_without_times_each_cell_is_a_job_and_one_that_failed_is_tried_again(self):
        script = self.folder / "mine.sh"
        script.write_text(SCRIPT.format(folder=self.folder))
        self.study(["weighted-average", {"external": "mine", "command": ["sh", "mine.sh", "{output}"]}], repeats=1)
        done = self.run_workflow()
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("Trying to restart", done.stdout)
        self.assertEqual(len(list((self.folder / "cells/log/single").glob("*.done"))), 6)
        self.expect_as_in_one_run()

    def test_a_scene_that_comes_back_on_another_node_is_measured_anew(self):
        self.study(["weighted-average"])
        self.assertEqual(self.run_workflow().returncode, 0)
        rows = [self.folder / f"cells/cells/{scene}/raytrace.json" for scene in ("one", "two")]
        before = [row.stat().st_mtime_ns for row in rows]
        (self.folder / "cells/log/timed/two.node").write_text("another\n")
        again = self.run_workflow("--forcerun", "timed")
        self.assertEqual(again.returncode, 0, again.stdout)
        after = [row.stat().st_mtime_ns for row in rows]
        self.assertEqual(after[0], before[0])
        self.assertGreater(after[1], before[1])

    def test_what_fails_for_good_is_in_the_report_beside_the_rest(self):
        self.study(["weighted-average", {"external": "mine", "command": ["false", "{output}"]}])
        done = self.run_workflow()
        self.assertNotEqual(done.returncode, 0)
        rows = self.rows("cells")
        self.assertEqual([bool(row["error"]) for row in rows], [False, False, True] * 2)
        self.assertTrue((self.folder / "cells/report.html").is_file())
        self.assertIn("2 of 6 cells failed", done.stdout)


if __name__ == "__main__":
    if not shutil.which("snakemake"):
        print("skipped: snakemake (Debian's package of that name) is not installed")
        sys.exit(77)
    unittest.main()
