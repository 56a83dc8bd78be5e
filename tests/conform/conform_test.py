#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""`pellucid conform` passes a right renderer that shares no code with it, and tells what is wrong with faulty ones. The
program is $PELLUCID_PROGRAM."""

import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import mock_renderers
from mock_renderers import independent

PROGRAM = os.environ["PELLUCID_PROGRAM"]
TOO_MANY = {"layers-1000", "layers-10000"}  # for a test in Python


class Conform(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.temporary.name)
        subprocess.run([PROGRAM, "conform", "--make", cls.folder / "suite", "--quiet"], check=True)
        cls.names = [case["name"] for case in json.loads((cls.folder / "suite/cases.json").read_text())["cases"]]

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    def faults(self, mock, *names):
        """The fault of each case that it fails."""
        pictures = self.folder / mock
        pictures.mkdir(exist_ok=True)
        for name in names:
            independent.exr.write(pictures / f"{name}.exr", mock_renderers.render(mock, self.folder / "suite" / name / "scene.json"))
        done = subprocess.run([PROGRAM, "conform", "--pictures", pictures, "--json", "--quiet"], capture_output=True, text=True)
        results = {case["name"]: case for case in json.loads(done.stdout)["cases"] if case["name"] in names}
        self.assertEqual(set(results), set(names))
        return {name: case.get("fault", "") for name, case in results.items() if not case["passed"]}

    def test_a_right_renderer_passes(self):
        self.assertEqual(self.faults("right", *(set(self.names) - TOO_MANY)), {})

    def test_faulty_renderers_are_told(self):
        several = "layers-1", "layers-2", "layers-10"
        self.assertEqual(self.faults("capped", *several, "layers-100"), {"layers-10": "capped", "layers-100": "capped"})
        self.assertEqual(self.faults("backwards", *several), dict.fromkeys(several[1:], "misordered"))
        self.assertEqual(self.faults("black", *several), dict.fromkeys(several, "background"))
        self.assertEqual(self.faults("eight", "layers-100", "opacity-1-510"),
                         {"layers-100": "8 bits", "opacity-1-510": "8 bits"})
        self.assertEqual(self.faults("loses", "layers-10", "equal-depth-2", "equal-depth-50"),
                         {"equal-depth-2": "missed", "equal-depth-50": "missed"})
        self.assertEqual(self.faults("doubles", "layers-10", "edges-through"), {"edges-through": "doubled"})
        self.assertEqual(self.faults("misses", "layers-10", "edges-through", "edges-vertices"),
                         {"edges-through": "missed", "edges-vertices": "missed"})

    def test_a_command_draws_the_cases(self):
        mock = Path(__file__).parent / "mock_renderers.py"

        def conform(*arguments):
            return subprocess.run([PROGRAM, "conform", "--quiet", "--only", "edges-through", *arguments], capture_output=True, text=True)

        done = conform("--all", "--command", f"{sys.executable} -B '{mock}' right {{scene}} {{output}}")
        self.assertEqual((done.returncode, "passed" in done.stdout), (0, True), done.stdout + done.stderr)
        done = conform("--command", "sh -c 'echo no licence >&2; exit 1' {output}")
        self.assertEqual(done.returncode, 1)
        self.assertIn("no licence", done.stdout)
        self.assertIn("1 of 1 cases failed", done.stderr)
        for wrong in ([], ["--command", "true"], ["--command", "true {output}", "-m", "raytrace"], ["--pictures", "/nowhere"]):
            done = conform(*wrong)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)


if __name__ == "__main__":
    unittest.main()
