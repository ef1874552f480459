"""Read a whole file of bounded size, or say why not."""

from __future__ import annotations

import os
import stat
from pathlib import Path

from tmodes.errors import InputError
from tmodes.io.words import shown_path

__all__ = ["read_bytes"]


def read_bytes(path: str | os.PathLike[str], most: int) -> bytes:
    """The content of a regular file of at most ``most`` bytes; an InputError for anything else."""
    source = shown_path(path)
    try:
        status = Path(path).stat()
        if not stat.S_ISREG(status.st_mode):
            got = "a directory" if stat.S_ISDIR(status.st_mode) else "a device, pipe or socket"
            raise InputError(source, got, "a regular file", "name the file itself")
        with Path(path).open("rb") as file:
            content = file.read(most + 1)
    except FileNotFoundError:
        raise InputError(source, "no such file", "an existing file", "check the path and its spelling") from None
    except (OSError, ValueError) as error:
        got = getattr(error, "strerror", None) or str(error)
        raise InputError(source, f"a file that cannot be read: {got}", "a readable file", "check the path") from None
    if len(content) > most:
        got = f"a file of {max(status.st_size, len(content))} bytes"
        raise InputError(source, got, f"at most {most} bytes", "check that this is the file you mean")
    return content
