# SPDX-License-Identifier: GPL-3.0-or-later
"""A project of a user finds the library, which shows only what is public."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest
from conftest import install, run

CONSUMER = Path(__file__).parent / "consumer"


@pytest.fixture(scope="session")
def library(tmp_path_factory):
    return install(tmp_path_factory.mktemp("installed"), "--component", "library")


def configure(library, folder, **changed):
    shutil.copytree(CONSUMER, folder / "consumer")
    file = folder / "consumer/CMakeLists.txt"
    for old, new in changed.items():
        file.write_text(re.sub(old, new, file.read_text()))
    return subprocess.run(["cmake", "-S", folder / "consumer", "-B", folder / "build", f"-DCMAKE_PREFIX_PATH={library}"],
                          capture_output=True, text=True)


def test_a_project_links_it(library, tmp_path):
    done = configure(library, tmp_path)
    assert done.returncode == 0, done.stderr
    run("cmake", "--build", tmp_path / "build")
    assert "counts 1, sides 1, nearest 1, refused 1" in run(tmp_path / "build/consumer")


def test_another_version_is_refused(library, tmp_path):
    done = configure(library, tmp_path, **{r"pellucid \d+\.\d+": "pellucid 0.1"})
    assert done.returncode != 0 and "compatible with requested version" in done.stderr


def test_only_what_is_public_shows(library):
    shown = run("nm", "-DC", "--defined-only", next(library.glob("lib/**/libpellucid.so"))).splitlines()
    foreign = [symbol for symbol in shown if "pellucid::MeshRays::" not in symbol]
    assert not foreign and len(shown) > 6


def test_it_loads_no_library_of_other_rooms(library):
    needed = run("readelf", "-d", next(library.glob("lib/**/libpellucid.so")))
    assert not re.search(r"NEEDED.*(vtk|openvdb|OpenImageIO|OSMesa|embree)", needed), needed
