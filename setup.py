# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""Builds the extension gonio._core by CMake, in build/pip; pyproject.toml describes the package.

GONIO_BUILD_DIR names another build folder, such as build/release of ./run, so that core is not compiled again.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class CMakeExtension(build_ext):
    def build_extension(self, ext):
        folder = pathlib.Path(os.environ.get("GONIO_BUILD_DIR", ROOT / "build" / "pip")).resolve()
        if "GONIO_BUILD_DIR" not in os.environ:
            # Python_EXECUTABLE: the extension is for the Python that runs pip.
            subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-Wno-dev",
                            "-DGONIO_BUILD_GUI=OFF", "-DGONIO_BUILD_BENCHMARKS=OFF", "-DBUILD_TESTING=OFF",
                            f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", folder, "--target", "gonio_python"], check=True)
        target = pathlib.Path(self.get_ext_fullpath(ext.name)).resolve()
        built = folder / "python" / "gonio" / target.name
        if not built.exists():
            raise SystemExit(f"{built} was not built: it needs python3-dev and pybind11-dev, and this version of Python")
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(built, target)


version = re.search(r"project\(gonio VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)
setup(version=version, ext_modules=[Extension("gonio._core", sources=[])], cmdclass={"build_ext": CMakeExtension})
