"""A run and its folder: checked before, locked during, whole after; an interrupted run resumes."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from importlib.metadata import version
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

from tmodes.compile.cache import source_digest
from tmodes.compile.native import host
from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock, check_writable, remove_orphans
from tmodes.io.checkpoint import RunJournal, run_identity
from tmodes.io.sheet_check import sheet_data
from tmodes.report.meshes import with_shapes
from tmodes.report.page import write_report
from tmodes.result import Result
from tmodes.result.derived import is_unfinished
from tmodes.result.run import ready_to_run, result_bytes, run
from tmodes.sheet import Robot

if TYPE_CHECKING:
    from tmodes.io.urdf_shapes import LinkShape

__all__ = ["RunFolder"]

_ROOM_FOR_FIGURES = 20_000_000

Progress = Callable[[str, float], None]


class RunFolder:
    """The folder of one run: ``result.nc``, ``report.html``, ``figures/``.

    ``shapes``: the surfaces of its links; ``live``: whether the report holds the robot's equations;
    ``spent``: wall and processor time [s] by stage, for its provenance; ``resumes``: an earlier result of the same
    sheet is of this run. Used as a context.
    Raises :class:`tmodes.errors.InputError` for a robot that nothing moves, or a result too large for memory, before
    anything is made; and :class:`tmodes.errors.ResultFileError` on entry where the run could not be stored: no
    permission, no room, another writer, a result that is there already.
    """

    def __init__(
        self, path: Path, robot: Robot, overwrite: bool = False, shapes: Sequence[LinkShape] = (), *, live: bool = True,
        spent: Mapping[str, Sequence[float]] | None = None, resumes: bool = True,
    ) -> None:  # fmt: skip
        self.path, self.robot, self.overwrite, self.live = path, ready_to_run(robot), overwrite, live
        self.spent, self.resumes = spent, resumes
        self._size, self._shapes = result_bytes(self.robot), shapes
        self.result_file, self.report_file, self.figures = path / "result.nc", path / "report.html", path / "figures"
        self.continues = False
        self._done: Any = None
        self._lock = FolderLock(path)
        self._journals: dict[str, RunJournal] = {}

    def __enter__(self) -> Self:
        check_writable(self.path, self._size + _ROOM_FOR_FIGURES)
        self._check_kinds()
        self._lock.__enter__()
        remove_orphans(self.figures)
        try:
            self._look_at_what_is_there()
        except BaseException:
            self._lock.__exit__(None, None, None)
            raise
        return self

    def _check_kinds(self) -> None:
        """A folder in place of a file, or a file in place of the figures' folder, is an error before the run."""
        for place, wanted in ((self.result_file, False), (self.report_file, False), (self.figures, True)):
            if place.exists() and place.is_dir() != wanted:
                got, expected = ("a file", "a folder") if wanted else ("a folder", "a file")
                hint = "remove it, or name another --out"
                raise ResultFileError(f"{place} must be {expected} or not exist, got {got}; {hint}")

    def _look_at_what_is_there(self) -> None:
        """Start, resume an earlier start of this very run, or refuse: a result is replaced only where that is asked."""
        if self.overwrite:
            self._drop_checkpoints()
            return
        self.continues = any(self.path.glob(".checkpoint-*"))
        if not self.result_file.exists():
            return
        earlier = self._earlier() if self.resumes else None
        if earlier and self.is_unfinished(earlier):
            self.continues = self.overwrite = True
        elif earlier and earlier.success and not self.report_file.exists():
            self.continues, self._done = True, earlier
        else:
            hint = "--overwrite replaces it, --out names another folder"
            raise ResultFileError(f"{self.result_file} exists already; {hint}")

    def _earlier(self) -> Any:
        """The result that is there, when it is whole and of the same data sheet."""
        try:
            earlier = Result.load(self.result_file)
        except ResultFileError:
            return None
        same_sheet = earlier.data.attrs.get("robot") == self._sheet()
        same_program = json.loads(earlier.data.attrs.get("versions", "{}")).get("tmodes") == version("tmodes")
        return earlier if same_sheet and same_program else None

    def __exit__(
        self, kind: type[BaseException] | None, value: BaseException | None, trace: TracebackType | None
    ) -> None:
        for journal in self._journals.values():
            journal.close()
        self._lock.__exit__(kind, value, trace)

    def simulate(self, progress: Progress, **how: Any) -> Result:
        """Run, store the motion, then what is computed of it too, and drop the checkpoints that this replaces.

        ``how``: as of :func:`tmodes.result.run.run`.

        Ctrl-C after the motion leaves it stored, and the checkpoints, so that the same command computes the rest.
        """
        if self._done:
            self._drop_checkpoints()
            return self._done
        progress("preparing", 0.0)
        result = run(self.robot, progress=progress, journals=self._journal, **how)
        self._save(result.begun())
        result, heard = result.complete(progress), False
        try:
            progress("saving", 0.0)
        except KeyboardInterrupt:
            heard = True
        result = self._save(result)
        if not self.is_unfinished(result):
            self._drop_checkpoints()
        if heard:
            raise KeyboardInterrupt
        return result

    def _drop_checkpoints(self) -> None:
        """Remove them, also those that a process left which was killed after it had stored the result."""
        for journal in self._journals.values():
            journal.close()
        for left in self.path.glob(".checkpoint-*"):
            left.unlink()

    def _save(self, result: Result) -> Result:
        result = with_shapes(result, self._shapes)
        result.save(self.result_file, overwrite=self.overwrite)
        self.overwrite = True
        return result

    def products(self, result: Result, progress: Progress, *, report: bool, figures: bool) -> Exception | None:
        """Write the report and the figures of a result that is complete; why not all of them could be made."""
        faults = []
        for make in [] if self.is_unfinished(result) else [self.report] * report + [self.draw] * figures:
            try:
                make(result, progress)
            except Exception as error:  # the others are made, and the numbers are said, all the same
                faults.append(error)
        return next(iter(faults), None)

    @staticmethod
    def is_unfinished(result: Result) -> bool:
        """Whether Ctrl-C ended the run, or what is computed of it."""
        return result.status == "interrupted" or is_unfinished(result.record)

    def report(self, result: Any, progress: Progress) -> None:
        """Write the report."""
        progress("report", 0.0)
        write_report(result, self.report_file, live=self.live, spent=self.spent, progress=progress)

    def draw(self, result: Any, progress: Progress) -> None:
        """Draw the figures for print."""
        from tmodes.plot import save_figures

        self.figures.mkdir(exist_ok=True)
        made = self.result_file if self.result_file.exists() else None
        save_figures(result, self.figures, progress=lambda k, n, _: progress("figures", k / n), stored=made)

    def _sheet(self) -> str:
        """The data sheet as JSON: what makes two runs the same."""
        return json.dumps(sheet_data(self.robot))

    def written(self) -> dict[str, str]:
        """The files that are there, by what they are."""
        files = {"result": self.result_file, "report": self.report_file, "figures": self.figures}
        return {name: str(path) for name, path in files.items() if path.exists()}

    def _journal(self, stage: str) -> RunJournal:
        identity = run_identity(self._sheet(), stage, source_digest((".",)), host())
        self._journals[stage] = RunJournal(self.path / f".checkpoint-{stage}", identity)
        return self._journals[stage]
