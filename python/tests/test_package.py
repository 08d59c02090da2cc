# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The Gonio authors
"""`python -m gonio`, and the wheel that pip makes of a build."""
import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

import gonio

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run_module(*arguments):
    return subprocess.run([sys.executable, "-m", "gonio", *arguments], capture_output=True, text=True)


def test_the_module_runs():
    assert run_module("--version").stdout == f"gonio {gonio.__version__}\n"
    assert str(len(gonio.library())) in run_module().stdout
    described = run_module("library:rgl/satin_purple")
    assert described.stdout == "library:rgl/satin_purple: RGL, " + described.stdout.split("RGL, ")[1]
    assert "isotropic" in described.stdout and described.returncode == 0


def test_a_file_that_is_missing_is_told():
    missing = run_module("no-such-file.binary")
    assert missing.returncode == 1 and missing.stdout == "" and missing.stderr.count("\n") == 1
    assert "no-such-file.binary" in missing.stderr


def test_the_wheel_holds_module_stubs_and_licence(tmp_path):
    pytest.importorskip("pip")
    pytest.importorskip("wheel")
    # A copy: setuptools writes beside its sources.
    copy = tmp_path / "sources"
    copy.mkdir()
    for name in ("CMakeLists.txt", "pyproject.toml", "setup.py", "README.md", "LICENSES", "resources", "python"):
        (copy / name).symlink_to(ROOT / name)
    subprocess.run([sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir",
                    tmp_path, copy], check=True, env={**os.environ, "GONIO_BUILD_DIR": os.environ["GONIO_BUILD_FOLDER"]})
    wheel, = tmp_path.glob("gonio-*.whl")
    assert gonio.__version__ in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    for name in [f"gonio/{file.name}" for file in (ROOT / "python" / "gonio").glob("*.py*") if file.is_file()] + ["gonio/py.typed"]:
        assert name in names, name
    assert any(name.startswith("gonio/_core.") and name.endswith(".so") for name in names)
    for end in ("Apache-2.0.txt", "ATTRIBUTIONS.md", "METADATA"):
        assert any(".dist-info/" in name and name.endswith(end) for name in names), end
