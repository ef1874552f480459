"""A robot's run and its folder."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.report.folder import RunFolder
from tmodes.result import Result
from tmodes.result.ready import ready_to_run, result_bytes
from tmodes.result.run import run
from tmodes.sheet import Robot

if TYPE_CHECKING:
    from tmodes.io.urdf_shapes import LinkShape
    from tmodes.plot.save import Drawing

__all__ = ["MotionFolder"]

Progress = Callable[[str, float], None]


class MotionFolder(RunFolder):
    """The folder of an arm's run: ``result.nc``, ``report.html``, ``figures/``; ``shapes`` are how its links look.

    Raises :class:`tmodes.errors.InputError` for an arm that nothing moves, or a result too large for memory, before
    anything is made; and on entry as :class:`tmodes.report.folder.RunFolder`.
    """

    def __init__(
        self, path: Path, arm: Robot, overwrite: bool = False, shapes: Sequence[LinkShape] = (), *, live: bool = True
    ) -> None:
        super().__init__(path, ready_to_run(arm), overwrite, live=live)
        self._size, self._shapes = result_bytes(self.robot), shapes

    def _sheet(self) -> str:
        from tmodes.io.sheet_check import sheet_data

        return json.dumps(sheet_data(self.robot))

    def _bytes(self) -> int:
        return self._size

    def _load(self) -> Result:
        return Result.load(self.result_file)

    def _computed(self, progress: Progress) -> Result:
        from tmodes.report.meshes import with_shapes

        return with_shapes(run(self.robot, progress=progress, journals=self._journal), self._shapes)

    def _drawn(self, result: Any) -> dict[str, Drawing]:
        from tmodes.plot import drawings

        return drawings(result)

    def _write_report(self, result: Any, pictures: dict[str, Drawing]) -> None:
        from tmodes.report.write_motion import write_arm_report

        write_arm_report(result, self.report_file, pictures, live=self.live)
