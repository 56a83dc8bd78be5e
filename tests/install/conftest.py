# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess
from pathlib import Path

import pytest

BUILD = Path(os.environ["PELLUCID_BUILD"])


def run(*words, **options):
    """What a command prints; it has to succeed."""
    done = subprocess.run([str(w) for w in words], capture_output=True, text=True, **options)
    assert done.returncode == 0, f"{words}\n{done.stdout}{done.stderr}"
    return done.stdout


def install(folder, *options):
    """An installation that was moved after it was made, so that nothing may know where it was."""
    run("cmake", "--install", BUILD, "--prefix", folder / "first", *options)
    (folder / "first").rename(folder / "moved")
    return folder / "moved"


@pytest.fixture(scope="session")
def prefix(tmp_path_factory):
    return install(tmp_path_factory.mktemp("installed"))
