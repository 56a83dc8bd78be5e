#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the profile for Slurm says of a job by what scontrol, here one that a test makes, says."""

import os
import subprocess
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


class Status(unittest.TestCase):
    def status(self, said, code=0, accounts=""):
        with tempfile.TemporaryDirectory() as folder:
            for name, text, ends in ("scontrol", said, code), ("sacct", accounts, 0):
                program = Path(folder) / name
                program.write_text(f"#!/bin/sh\nprintf '%s' '{text}'\nexit {ends}\n")
                program.chmod(0o755)
            env = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}"}
            return subprocess.run([ROOT / "workflow/slurm/status", "7"], env=env, stdout=subprocess.PIPE, text=True).stdout

    def test_states(self):
        for state, expected in (("RUNNING", "running"), ("PENDING", "running"), ("COMPLETING", "running"),
                                ("COMPLETED", "success"), ("FAILED", "failed"), ("NODE_FAIL", "failed"),
                                ("OUT_OF_MEMORY", "failed"), ("TIMEOUT", "failed"), ("CANCELLED", "failed")):
            self.assertEqual(self.status(f"JobId=7 JobName=a JobState={state} Reason=None"), expected + "\n", state)

    def test_a_job_that_was_forgotten_is_looked_up(self):
        self.assertEqual(self.status("error: Invalid job id specified", 1, "COMPLETED"), "success\n")
        self.assertEqual(self.status("error: Invalid job id specified", 1, ""), "failed\n")

    def test_a_controller_that_does_not_answer_is_no_failure(self):
        self.assertEqual(self.status("Unable to contact slurm controller", 1), "running\n")


if __name__ == "__main__":
    unittest.main()
