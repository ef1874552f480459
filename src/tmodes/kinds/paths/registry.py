"""The paths that tmodes brings; ``@PATHS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.paths.contract import PATHS, Course, Path, Place, Way

__all__ = ["PATHS", "Course", "Path", "Place", "Way"]

PATHS.bring(
    "tmodes.kinds.paths", {"line": "line", "arc": "arc", "via": "via", "turn": "turn", "joints": "joints"}
)  # fmt: skip
