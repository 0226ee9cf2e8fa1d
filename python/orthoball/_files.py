# SPDX-License-Identifier: MIT
"""Files: each appears whole or not at all."""

from __future__ import annotations

import os
import stat
import threading
from collections.abc import Mapping
from typing import Any, ClassVar


def write_whole(path: str | os.PathLike[str], content: bytes) -> None:
    """Writes a file that appears whole or not at all; what a link leads to, and what was there keeps
    its permissions. What is no plain file, such as a pipe, is written to as it is."""
    path = os.path.realpath(path)
    if os.path.exists(path) and not os.path.isfile(path):
        with open(path, "wb") as file:
            file.write(content)
        return
    beside = f"{path}.{os.getpid()}.{threading.get_ident()}.part"
    try:
        with open(beside, "wb") as file:
            file.write(content)
        if os.path.exists(path):
            os.chmod(beside, stat.S_IMODE(os.stat(path).st_mode))
        os.replace(beside, path)
    except BaseException as error:
        if os.path.exists(beside):
            os.remove(beside)
        if isinstance(error, OSError):
            error.filename, error.filename2 = path, None
        raise


def ending_of(path: str | os.PathLike[str]) -> str:
    """What a file name ends in, without the dot, in small letters."""
    return os.path.splitext(os.fspath(path))[1].lstrip(".").lower()


class Written:
    """What can be written to a file, in one of some formats."""

    _format_of_ending: ClassVar[Mapping[str, str]] = {}

    def to_bytes(self, format: str) -> bytes:
        """The bytes of a file."""
        raise NotImplementedError

    def write(self, path: str | os.PathLike[str], **options: Any) -> None:
        """Writes a file, the format told by its name; takes what `to_bytes` takes. The file appears
        whole or not at all."""
        ending = ending_of(path)
        write_whole(path, self.to_bytes(self._format_of_ending.get(ending, ending), **options))
