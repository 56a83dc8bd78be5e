# SPDX-License-Identifier: GPL-3.0-or-later
"""pip install ./python: builds the module by Pellucid's CMake and packs it with what it needs at run time.

PELLUCID_BUILD=FOLDER takes what is built there, such as build/release, instead of building afresh.
"""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).resolve().parent.parent


def version():
    return re.search(r"project\(pellucid VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


class BuildByCMake(build_ext):
    """Its one extension stands for all of the package that is not Python."""

    def build_extension(self, extension):
        given = os.environ.get("PELLUCID_BUILD")
        build = Path(given or self.build_temp).resolve()
        if not given:
            self.configure(build)
        module = Path(self.get_ext_fullpath(extension.name)).resolve()
        subprocess.run(["cmake", "--build", build, "--target", "pellucid_python"], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "wheel", "--prefix", module.parent, "--strip"], check=True)
        if not module.exists():
            sys.exit(f"{build} builds the module for another Python than {sys.executable}: configure it with "
                     f"-DPython_EXECUTABLE={sys.executable}, or leave PELLUCID_BUILD out")

    @staticmethod
    def configure(build):
        build.mkdir(parents=True, exist_ok=True)
        options = [f"-DPython_EXECUTABLE={sys.executable}", "-DPELLUCID_PYTHON=ON", "-DBUILD_TESTING=OFF"]
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", *options], check=True)


setup(
    name="pellucid",
    version=version(),
    description="Transparent flow visualization: exact, approximate, and how far apart",
    license="GPL-3.0-or-later",
    python_requires=">=3.9",
    install_requires=["numpy"],
    packages=["pellucid"],
    package_data={"pellucid": ["py.typed", "__init__.pyi"]},
    ext_modules=[Extension("pellucid._pellucid", sources=[])],
    cmdclass={"build_ext": BuildByCMake},
    zip_safe=False,
)
