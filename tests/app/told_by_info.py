# SPDX-License-Identifier: GPL-3.0-or-later
"""What `pellucid info` tells of a file, held to what others read of it: for the scripts beside this one."""

import json
import math
import os
import subprocess

PROGRAM = os.environ["PELLUCID_PROGRAM"]
SKIPPED = 77  # CTest takes it for skipped
failures = []


def info(path):
    result = subprocess.run([PROGRAM, "info", str(path), "--json", "--quiet"], capture_output=True, encoding="utf-8")
    if result.returncode:
        failures.append(f"{path}: {result.stderr.strip()}")
        return None
    return json.loads(result.stdout)


def expect(what, got, expected, tolerance=0.0):
    """Numbers are equal to a share of the larger one, or of 1."""
    got, expected = list(got), list(expected)
    close = len(got) == len(expected) and all(
        math.isclose(a, b, rel_tol=tolerance, abs_tol=tolerance) for a, b in zip(got, expected))
    if not close:
        failures.append(f"{what}: {got}; the other reader: {expected}")


def array_of(told, name):
    return next((a for a in told["arrays"] if a["name"] == name), None)


def flat_bounds(told):
    return told["bounds"]["min"] + told["bounds"]["max"]


def refusal(path):
    result = subprocess.run([PROGRAM, "info", str(path), "--quiet"], capture_output=True, encoding="utf-8")
    return result.stderr if result.returncode == 2 and result.stderr.count("\n") == 1 else f"not refused: {result}"


def expect_in(what, text, part):
    if part not in text:
        failures.append(f"{what}: '{part}' is not in: {text.strip()}")


def end():
    """The exit code, after what failed is printed."""
    for failure in failures:
        print(failure)
    return 1 if failures else 0
