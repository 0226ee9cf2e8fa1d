# SPDX-License-Identifier: MIT
"""Executes the guide's page on Python, block after block, in a folder with a copy of examples/."""

import doctest
import re
import shutil

import pytest

import orthoball

pytestmark = pytest.mark.partner


def test_the_guide_shows_what_python_prints(root, tmp_path, monkeypatch):
    shutil.copytree(root / "examples", tmp_path / "examples")
    monkeypatch.chdir(tmp_path)
    text = (root / "docs" / "guide" / "python.md").read_text()
    blocks = re.findall(r"^```pycon\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    assert len(blocks) == text.count("```pycon") > 8
    parser, names, output = doctest.DocTestParser(), {}, []
    for number, block in enumerate(blocks, 1):
        if ".enforce(" in block and not orthoball.has_linear_solver():
            continue
        test = parser.get_doctest(block, names, f"block {number}", "python.md", 0)
        runner = doctest.DocTestRunner(verbose=False)
        runner.run(test, out=output.append, clear_globs=False)
        names.update(test.globs)
    assert not output, "".join(output)


def test_recipes_have_five_lines_at_most(root):
    text = (root / "docs" / "guide" / "python.md").read_text()
    recipes = re.findall(r"^\*\*.*?^```pycon\n(.*?)^```$", text, re.DOTALL | re.MULTILINE)
    assert len(recipes) == 5
    assert all(recipe.count(">>> ") <= 5 for recipe in recipes)
