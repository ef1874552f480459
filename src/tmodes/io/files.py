"""Files that a robot's file names lie inside its own folder or the folders that the user lists; a file is read whole.

Nothing is fetched, symbolic links are followed before a path is judged, and the size is bounded.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from tmodes.errors import InputError
from tmodes.io.plain_file import whole_file
from tmodes.io.words import shown, shown_path

__all__ = ["ALLOW", "FilePath", "Folders", "Roots", "folders_of", "read_bytes"]

FilePath = str | os.PathLike[str]
Roots = Sequence[FilePath]
"""Further folders in which files that a file names may lie."""

ADDRESS = re.compile(r"([A-Za-z][A-Za-z0-9+.-]*):(//)?(.*)", re.DOTALL)
DRIVE = re.compile(r"[A-Za-z]:[\\/]")
LONGEST = 1_000

ALLOW = "give its folder with --root DIR, or allow every path of this file with --trust-paths"
"""How a user lets a file lie elsewhere: the flags of the command line, in Python ``roots`` and ``trust_paths``."""


@dataclass(frozen=True)
class Folders:
    """``home``, the folder of the robot's file, and the ``roots`` that the user lists; all resolved.

    ``trust`` allows absolute paths and paths that leave the folders; even then nothing is fetched.
    """

    home: Path
    roots: tuple[Path, ...] = ()
    trust: bool = False

    def find(self, name: str, which: str, place: str, base: Path | None = None) -> Path | None:
        """The checked path of a file's ``name`` as written; None for one that is not there, or is only an address.

        Relative names start at ``base`` (default: home). Raises :class:`tmodes.errors.InputError` for a path that
        leaves the folders, an absolute one and an address.
        """
        if not name or len(name) > LONGEST or not name.isprintable():
            raise InputError(which, shown(name), "the path of a file", "write the path", place)
        address = None if DRIVE.match(name) else ADDRESS.fullmatch(name)
        if address and address[1].lower() == "package":
            return self._package(address[3], which, place)
        if address and address[1].lower() != "file":
            return self._refused(None, f"the address {shown(name)}", which, place)
        path = Path(address[3] if address else name.replace("\\", "/"))
        if address or path.is_absolute() or DRIVE.match(name):
            inside = self._is_inside(self._resolved(path, which, place))
            got = f"an absolute path {shown(name)}"
            return path if inside and _exists(path) else self._refused(path, got, which, place)
        return self._inside((base or self.home) / path, name, which, place)

    def _package(self, rest: str, which: str, place: str) -> Path | None:
        """``package://name/path``: the folder ``name`` is a root, lies in one, or is the package around the file."""
        name, _, inner = rest.lstrip("/").partition("/")
        if ".." in (name, *inner.replace("\\", "/").split("/")) and not self.trust:
            got, hint = f"package://{rest}, which climbs with `..`", "name the file inside its package"
            raise InputError(which, shown(got), "a path inside the package", hint, place)
        candidates = [*self.roots, *(root / name for root in self.roots), self.home / name]
        around = (self.home, *self.home.parents)
        candidates += [folder for folder in around if folder.name == name and _exists(folder / "package.xml")]
        for candidate in candidates:
            path = candidate / inner
            if candidate.name == name and _exists(path):
                if not self.trust and not path.resolve().is_relative_to(candidate.resolve()):
                    got, hint = f"{shown_path(path)}, a link that leads outside", "put the file itself there"
                    raise InputError(which, got, "a file inside its package", hint, place)
                return path.resolve()
        return None

    def _inside(self, path: Path, name: str, which: str, place: str) -> Path | None:
        resolved = self._resolved(path, which, place)
        if not self._is_inside(resolved) and not self.trust:
            got, expected = f"{shown(name)}, which leads outside", f"a path inside {shown_path(self.home)}"
            hint = f"move the file there, or {ALLOW}"
            raise InputError(which, got, expected, hint, place)
        return resolved if _exists(resolved) else None

    def _is_inside(self, resolved: Path) -> bool:
        return any(resolved.is_relative_to(folder) for folder in (self.home, *self.roots))

    def _refused(self, path: Path | None, got: str, which: str, place: str) -> Path | None:
        """An absolute path or an address: kept only where it is trusted and on this machine."""
        if self.trust:
            return path.resolve() if path and _exists(path) else None
        hint = f"write a path relative to the robot's file, or {ALLOW}"
        raise InputError(which, got, "a relative path or package://; nothing is ever fetched", hint, place)

    @staticmethod
    def _resolved(path: Path, which: str, place: str) -> Path:
        try:
            return path.resolve()
        except (OSError, RuntimeError, ValueError) as error:
            got = f"a path that cannot be followed ({shown(str(error))})"
            raise InputError(which, got, "the path of a file", "correct it", place) from None


def folders_of(file: FilePath, roots: Roots = (), trust: bool = False) -> Folders:
    """The folders in which the files that ``file`` names may lie."""
    home = Path(file).absolute().parent.resolve()
    return Folders(home, tuple(Path(root).resolve() for root in roots), trust)


def _exists(path: Path) -> bool:
    try:
        return path.exists()
    except OSError:  # a name that no file can have
        return False


def read_bytes(path: FilePath, most: int) -> bytes:
    """The content of a regular file of at most ``most`` bytes; an InputError for anything else."""
    source = shown_path(path)
    try:
        return whole_file(path, most)
    except FileNotFoundError:
        raise InputError(source, "no such file", "an existing file", "check the path and its spelling") from None
    except (OSError, ValueError, MemoryError) as error:
        got, hint = f"“{getattr(error, 'strerror', None) or str(error)}”", "check that this is the file you mean"
        raise InputError(source, got, f"a file of at most {most:,} bytes that can be read", hint) from None
