"""How the links of a robot look, for the runs of one worker: read once, shown with every run."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.errors import TmodesError
from tmodes.studio.looks import GONE
from tmodes.studio.messages import info_error, info_unseen

if TYPE_CHECKING:
    from tmodes.io.urdf_shapes import LinkShape
    from tmodes.result import Result

__all__ = ["Shapes"]


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
            return [info_error("", "the shapes of this upload are not kept any more", hint=hint)]
        return info_unseen(self._why, data, self._source.get("roots", ()))


def _changed(file: str) -> int:
    """When a file was changed; 0 for a name."""
    with suppress(OSError):
        return Path(file).stat().st_mtime_ns
    return 0
