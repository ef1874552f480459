"""Where the looks of a robot come from, and the surfaces of its links for the runs of one worker, read once."""

from __future__ import annotations

import secrets
import tempfile
import threading
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from tmodes.errors import InputError, TmodesError
from tmodes.robots.load import sheet_names
from tmodes.studio.folders import WorkingFolder, remove
from tmodes.studio.messages import error_record, unseen_records

if TYPE_CHECKING:
    from tmodes.io.urdf_shapes import LinkShape
    from tmodes.result import Result

__all__ = ["GONE", "Shapes", "Shelf", "Source", "source_of"]


MOST_KEPT = 8
"""Uploads that are kept, the newest ones: each at most as large as an upload may be."""

GONE = "gone"
"""In place of a file: the upload is not kept any more."""


class Source(NamedTuple):
    """The robot's file, or the name of a published robot; and the folders in which what it names may lie."""

    file: str
    roots: tuple[str, ...]


class Shelf:
    """Uploads whose links have shapes, in the studio's own folder ``place``, which goes when the studio stops."""

    def __init__(self, place: Path) -> None:
        self._place = place
        self._lock = threading.Lock()  # uploads are read in threads
        self._kept: dict[str, tuple[Path, Source]] = {}
        self._studies: dict[str, str] = {}

    def room(self) -> Path:
        """A new empty folder; raises :class:`tmodes.errors.InputError` where there is no room for one."""
        try:
            return Path(tempfile.mkdtemp(prefix="tmodes-upload-", dir=self._place))
        except OSError as error:
            expected, hint = "files that fit in the temporary folder", "free some space"
            raise InputError("files", str(error.strerror), expected, hint) from None

    def keep(self, room: Path, main: Path, roots: Sequence[Path]) -> str:
        """Keep a room; the name under which its looks can be asked for, which nobody can guess."""
        name = secrets.token_urlsafe(12)
        with self._lock:
            self._kept[name] = (room, Source(str(main), tuple(map(str, roots))))
            olds = [self._kept.pop(old)[0] for old in [*self._kept][:-MOST_KEPT]]
        for old in olds:
            remove(old)
        return f"upload:{name}"

    def found(self, name: str) -> Source | None:
        """Where the upload of a name is; None where it is not kept any more."""
        kept = self._kept.get(name)
        return kept and kept[1]

    def note(self, study: str, looks: str) -> None:
        """Remember that a study of the working folder was made of an upload; another one was not."""
        self._studies.pop(study, None)
        if looks.startswith("upload:"):
            self._studies[study] = looks

    def looks_of(self, study: str) -> str:
        """Where the looks of a study of the working folder come from."""
        return self._studies.get(study, f"study:{study}")


def source_of(looks: Any, folder: WorkingFolder, shelf: Shelf) -> Source | None:
    """What ``robot:NAME``, ``study:FILE`` and ``upload:NAME`` mean; None for anything else: looks are no error."""
    kind, _, name = looks.partition(":") if isinstance(looks, str) else ("", "", "")
    if kind == "robot" and name in sheet_names():
        return Source(name, ())
    if kind == "study":
        with suppress(InputError):
            return Source(str(folder.existing(name)), (str(folder.path),))
    if kind == "upload":
        return shelf.found(name) or Source(GONE, ())
    return None


class Shapes:
    """The surfaces of the robot that was shown last, simplified; ``unseen`` says what of it cannot be shown."""

    def __init__(self) -> None:
        self._key: tuple[Any, ...] = ()
        self._few: list[LinkShape] = []
        self._why: list[Any] = []
        self._source: Mapping[str, Any] = {}

    def look(self, source: Mapping[str, Any] | None) -> None:
        """Take the robot at ``file`` with ``roots``, as :class:`tmodes.studio.looks.Source`; None: no surfaces."""
        key = () if source is None else (source["file"], *source["roots"], _changed(source["file"]))
        if key != self._key:
            self._key, self._few, self._why, self._source = key, [], [], source or {}
            if source is not None and source["file"] != GONE:
                self._read(source)

    def _read(self, source: Mapping[str, Any]) -> None:
        from tmodes.report.meshes import few_shapes, seen_shapes

        try:
            shapes, self._why = seen_shapes(source["file"], source["roots"])
            self._few = few_shapes(shapes)
        except TmodesError as error:
            self._why = [error]

    def on(self, result: Result) -> Result:
        """The result with the surfaces of its links, as ``tmodes run`` keeps them."""
        from tmodes.report.meshes import with_few_shapes

        return with_few_shapes(result, self._few)

    def unseen(self, data: Any) -> list[dict[str, Any]]:
        """What cannot be shown, as the page reports it at the links of the sheet's plain ``data``."""
        if self._source.get("file") == GONE:
            hint = "upload them again"
            return [error_record("", "the shapes of this upload are not kept any more", hint=hint)]
        return unseen_records(self._why, data, self._source.get("roots", ()))


def _changed(file: str) -> int:
    """When a file was changed; 0 for a name."""
    with suppress(OSError):
        return Path(file).stat().st_mtime_ns
    return 0
