"""A run and its folder: checked before, locked during, whole after; a killed run goes on where it was."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from tmodes.compile.cache import source_digest
from tmodes.compile.native import host
from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock, check_writable
from tmodes.io.checkpoint import run_identity
from tmodes.io.journal import RunJournal
from tmodes.result import Result
from tmodes.robot import Robot
from tmodes.trajectory import sample_times

__all__ = ["RunFolder"]

_ROOM_FOR_FIGURES = 20_000_000

Progress = Callable[[str, float], None]


class RunFolder:
    """The folder of one run: ``result.nc``, ``report.html``, ``figures/``.

    Used as a context; raises :class:`tmodes.errors.ResultFileError` on entry where the run could not be stored: no
    permission, no room, another writer, a result that is there already.
    """

    def __init__(self, path: Path, robot: Robot, overwrite: bool = False) -> None:
        self.path, self.robot, self.overwrite = path, robot, overwrite
        self.result_file, self.report_file, self.figures = path / "result.nc", path / "report.html", path / "figures"
        self.continues = False
        self._lock = FolderLock(path)
        self._journals: dict[str, RunJournal] = {}

    def __enter__(self) -> Self:
        samples = len(sample_times(self.robot.integration))
        check_writable(self.path, samples * self.robot.integration.bytes_per_sample + _ROOM_FOR_FIGURES)
        self._lock.__enter__()
        self.continues = any(self.path.glob(".checkpoint-*"))
        self.overwrite = self.overwrite or self.continues  # what is there is the beginning of this run
        if self.result_file.exists() and not self.overwrite:
            self._lock.__exit__(None, None, None)
            raise ResultFileError(
                f"{self.result_file}: got a result that exists; expected a folder without one. Mend: --overwrite "
                "replaces it, --out names another folder"
            )
        return self

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        for journal in self._journals.values():
            journal.close()
        self._lock.__exit__(kind, value, trace)

    def simulate(self, progress: Progress) -> Result:
        """Run, store the result, and drop the checkpoints that it replaces."""
        from tmodes.simulate import simulate

        result = simulate(self.robot, progress=progress, journals=self._journal)
        result.save(self.result_file, overwrite=self.overwrite)
        if result.status != "interrupted":
            for journal in self._journals.values():
                journal.remove()
        return result

    def illustrate(self, result: Result, progress: Progress) -> None:
        """Draw the figures and write the report."""
        from tmodes.plot import drawings, save_figures
        from tmodes.report import write_report

        pictures = drawings(result)
        self.figures.mkdir(exist_ok=True)
        save_figures(
            result, self.figures, progress=lambda done, total, name: progress("figures", done / total), figures=pictures
        )
        write_report(result, self.report_file, pictures)

    def summary(self, result: Result) -> dict[str, Any]:
        """What the run gave, for machines."""
        files = {"result": self.result_file, "report": self.report_file, "figures": self.figures}
        return {
            "status": result.status,
            "message": result.message,
            "warnings": list(result.warnings),
            "files": {name: str(path) for name, path in files.items() if path.exists()},
            "summary": result.summary(),
            "frequencies": result.frequencies,
            "statistics": result.statistics,
        }

    def _journal(self, stage: str) -> RunJournal:
        identity = run_identity(self.robot.model_dump_json(), stage, source_digest(), host())
        self._journals[stage] = RunJournal(self.path / f".checkpoint-{stage}", identity)
        return self._journals[stage]
