# SPDX-License-Identifier: MIT
"""The source distribution: what it holds, and that it configures where there is no Node."""

import os
import pathlib
import shutil
import subprocess
import sys
import tarfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILT_FROM = (
    "src",
    "cmake",
    "python",
    "CMakeLists.txt",
    "pyproject.toml",
    "LICENSE",
    "THIRD_PARTY.md",
)
LEFT_OUT = (
    "tests",
    "benchmarks",
    "docs",
    "examples",
    "build",
    "out",
    ".tools",
    "viewer/node_modules",
)
pytestmark = pytest.mark.partner


@pytest.fixture(scope="module")
def sources(tmp_path_factory):
    """The folder of an unpacked source distribution of the checkout."""
    pytest.importorskip("scikit_build_core")
    if not (ROOT / ".git").exists():
        pytest.skip("not a checkout")
    folder = tmp_path_factory.mktemp("sdist")
    program = (
        "import sys; from scikit_build_core.build import build_sdist; build_sdist(sys.argv[1])"
    )
    command = [sys.executable, "-c", program, str(folder)]
    subprocess.run(command, cwd=ROOT, check=True, capture_output=True)
    (archive,) = folder.glob("orthoball-*.tar.gz")
    with tarfile.open(archive) as tar:
        tar.extractall(folder)
    return folder / archive.name.removesuffix(".tar.gz")


def configure(sources, build, path):
    """What CMake says of the package's build with the programs of `path` only."""
    command = ["cmake", "-S", str(sources), "-B", str(build), "-G", "Ninja"]
    command += ["-D", "ORTHOBALL_PYTHON=ON", "-D", "ORTHOBALL_CLI=OFF", "-D", "ORTHOBALL_TESTS=OFF"]
    command += ["-D", f"Python_EXECUTABLE={sys.executable}"]
    # Where CMake looks whatever the PATH.
    command += ["-D", "CMAKE_IGNORE_PATH=/bin;/usr/bin;/usr/local/bin"]
    done = subprocess.run(command, env=os.environ | {"PATH": path}, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return " ".join((done.stdout + done.stderr).split())


@pytest.fixture
def path_without_node(tmp_path):
    """A PATH with what CMake and Ninja need, and no Node."""
    folder = tmp_path / "bin"
    folder.mkdir()
    for name in ("cmake", "ninja", "c++", "cc", "ld", "as", "ar", "ranlib", "sh", "uname"):
        found = shutil.which(name)
        if found:
            (folder / name).symlink_to(found)
    return str(folder)


def test_it_holds_what_a_build_needs_and_no_more(sources):
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--", *BUILT_FROM],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    )
    needed = [name for name in listed.stdout.split("\0") if name and (ROOT / name).exists()]
    assert len(needed) > 100
    assert [name for name in needed if not (sources / name).exists()] == []
    assert [name for name in LEFT_OUT if (sources / name).exists()] == []


def test_the_viewer_in_it_is_used_without_node(sources, tmp_path, path_without_node):
    page = sources / "viewer/built/index.html"
    if not page.exists():
        pytest.skip("the source distribution was made without Node")
    assert "built without `view`" not in configure(sources, tmp_path / "build", path_without_node)
    assert str(page) in (tmp_path / "build/python/cmake_install.cmake").read_text()


def test_without_viewer_and_node_it_says_what_is_left_out(sources, tmp_path, path_without_node):
    bare = tmp_path / "bare"
    shutil.copytree(sources, bare)
    shutil.rmtree(bare / "viewer/built", ignore_errors=True)
    assert "built without `view`" in configure(bare, tmp_path / "build", path_without_node)
    assert "viewer.html" not in (tmp_path / "build/python/cmake_install.cmake").read_text()
