# SPDX-License-Identifier: MIT
"""The viewer's page."""

from __future__ import annotations

import html
import os
import pathlib
import sys
import tempfile
import webbrowser
from typing import TYPE_CHECKING

from . import _core
from ._files import write_whole

if TYPE_CHECKING:
    from ._alpha_shapes import AlphaShapes

_PAGE = pathlib.Path(__file__).with_name("viewer.html")


def is_notebook() -> bool:
    """Whether a notebook shows what a cell gives."""
    ipython = sys.modules.get("IPython")
    shell = ipython.get_ipython() if ipython is not None else None
    return getattr(shell, "kernel", None) is not None


class View:
    """All shapes in one HTML page, with the viewer: made by `AlphaShapes.view`.

    Needs no server, no network and no Python. A notebook shows it as it is.
    """

    def __init__(self, shapes: AlphaShapes, given: tuple[float | int | str | None, ...]):
        if not _PAGE.exists():
            raise RuntimeError(
                "this orthoball was built without the viewer; a build finds Node 20 after "
                "./bootstrap viewer"
            )
        reason = ""
        notable = shapes._named_alpha(*given)  # type: ignore[arg-type]
        if notable is not None:
            index, alpha2, reason = notable.index or 0, notable.alpha2, notable.reason
        else:
            index, alpha2 = shapes._chosen(*given)  # type: ignore[arg-type]
        self._html = _core.page(
            shapes._core,
            shapes._reading,
            shapes._is_molecule,
            _PAGE.read_bytes(),
            index,
            alpha2,
            reason,
            shapes._threads,
        )

    def __repr__(self) -> str:
        return f"<orthoball.View: a page of {len(self._html)} bytes>"

    @property
    def html(self) -> bytes:
        """The page, UTF-8."""
        return self._html

    def _repr_html_(self) -> str:
        text = html.escape(self._html.decode())
        return (
            f'<iframe srcdoc="{text}" style="width: 100%; height: 600px; border: 0" '
            'sandbox="allow-scripts allow-downloads"></iframe>'
        )

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the page to a file, which appears whole or not at all."""
        write_whole(path, self._html)

    def open(self, path: str | os.PathLike[str] | None = None) -> str:
        """Writes the page to a file, by default a temporary one that stays, and opens it in a
        browser. Returns the path."""
        if path is None:
            descriptor, path = tempfile.mkstemp(prefix="orthoball-", suffix=".html")
            os.close(descriptor)
        self.write(path)
        webbrowser.open(pathlib.Path(path).resolve().as_uri())
        return os.fspath(path)
