# SPDX-License-Identifier: MIT
"""The viewer's page."""

import html
import os
import pathlib
import re
import subprocess
import sys
import types

import pytest

import orthoball
from orthoball import AlphaShapes, View, _view

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = os.environ.get("ORTHOBALL_PROGRAM", str(ROOT / "build" / "release" / "orthoball"))

needs_page = pytest.mark.skipif(
    not _view._PAGE.exists(), reason="the package was built without the viewer"
)


@needs_page
@pytest.mark.partner
@pytest.mark.parametrize(
    "name, options",
    [
        ("c60.xyz", {}),
        ("bdna_dodecamer.pdb", {"alpha2": 1.0}),
        ("figure_eight.csv", {"index": 7}),
        ("linked_tori.csv", {"alpha2": "auto:signature"}),
        ("bdna_dodecamer.pdb", {"weights": "density:5"}),
    ],
)
def test_the_page_is_that_of_the_program(samples, tmp_path, name, options):
    options = dict(options)
    path = tmp_path / "page.html"
    words = [word for key, value in options.items() for word in (f"--{key}", str(value))]
    command = [PROGRAM, "view", samples / name, "-o", path, "--no-open", "--quiet", *words]
    subprocess.run(command, check=True, capture_output=True)
    weights = options.pop("weights", None)
    view = AlphaShapes(orthoball.read(samples / name), weights).view(open=False, **options)
    assert view.html == path.read_bytes()


@needs_page
def test_a_notebook_shows_it_and_a_browser_elsewhere(cloud, tmp_path, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    shapes = AlphaShapes(cloud)
    view = shapes.view()
    assert isinstance(view, View) and len(opened) == 1 and opened[0].startswith("file://")
    path = pathlib.Path(opened[0].removeprefix("file://"))
    assert path.read_bytes() == view.html
    path.unlink()
    assert view.open(tmp_path / "page.html") == str(tmp_path / "page.html") and len(opened) == 2
    view.write(tmp_path / "other.html")
    assert (tmp_path / "other.html").read_bytes() == view.html
    assert f"{len(view.html)} bytes" in repr(view)

    kernel = types.SimpleNamespace(get_ipython=lambda: types.SimpleNamespace(kernel=object()))
    monkeypatch.setitem(sys.modules, "IPython", kernel)
    shown = shapes.view()._repr_html_()
    assert len(opened) == 2
    (page,) = re.findall(r'<iframe srcdoc="([^"]*)"', shown)
    assert html.unescape(page).encode() == view.html


def test_without_the_page_it_says_so(cloud, tmp_path, monkeypatch):
    monkeypatch.setattr(_view, "_PAGE", tmp_path / "missing.html")
    with pytest.raises(RuntimeError, match="built without the viewer"):
        AlphaShapes(cloud).view()
