"""The job of one run: what is missing of a study, handed out in blocks, and taken back verified."""

from __future__ import annotations

from collections.abc import Callable
from threading import Event

from tmodes.io.atomic import file_error
from tmodes.simulation.batch.executor import PROCESSOR, Executor, thread_count
from tmodes.study.blocks import Cover, Gap, Part, pack, unpack
from tmodes.study.derived import derivable, derived, from_motions, in_motions, is_formula
from tmodes.study.store import Folder, kept_cases, motion_bytes
from tmodes.study.table import rows_of
from tmodes.study.tasks import Pace, Task, compute, order

__all__ = ["StudyJob"]

Progress = Callable[[str, float], None]


class StudyJob:
    """Tasks of what is missing: new cases, quantities that stored cases lack, motions that were not kept."""

    def __init__(
        self, folder: Folder, cover: Cover, tasks: list[Task], threads: int | None, progress: Progress,
        notice: Callable[[str], None],
    ) -> None:  # fmt: skip
        self.folder, self.cover, self.study, self.threads = folder, cover, folder.study, threads
        self._tasks, self._gaps, self._progress = tasks, list(cover.gaps), progress
        self._total = len(folder.values) + sum(len(task.values) for task in tasks)
        self._left = sum(len(task.values) for task in tasks) + sum(gap.end - gap.first for gap in cover.gaps)
        every = self.study.sheet.keep.every
        heavy = motion_bytes(self.study) // every if every else 0
        self._own_threads, self.notice = 1, notice
        self._reached: dict[int, float] = {}
        self._ending = Event()
        self._pace = Pace(self.study.sheet.block, heavy)

    @staticmethod
    def _from_motions(folder: Folder) -> None:
        """Store quantities that follow from motions that were kept of all cases that ended well."""
        keepers = folder.keepers()
        for part in folder.cover().parts:
            if not part.missing or part.first not in keepers:
                continue
            rows = rows_of(folder, part)
            cases = rows.case[rows.good].tolist()
            if not cases or not set(cases) <= keepers.keys():
                continue
            labels = {keepers[case].name: keepers[case] for case in cases}
            kept = {case: one for label in labels.values() for case, one in folder.block(label).rows.kept.items()}
            names = in_motions(folder.study, part.missing, kept[cases[0]]) if set(cases) <= kept.keys() else []
            if names:
                folder.store(from_motions(folder.study, rows, kept, names))

    @classmethod
    def of(cls, folder: Folder, threads: int | None, progress: Progress, notice: Callable[[str], None]) -> StudyJob:
        """What is missing in a folder, once what follows from kept motions was added."""
        cls._from_motions(folder)
        cover = folder.cover()
        tasks = [_task(folder, part.first, part.end, asked) for part in cover.parts if (asked := _asked(folder, part))]
        known = folder.keepers()
        for part in cover.parts:
            wanted = kept_cases(folder.study, part.first, part.end)
            tasks += [_task(folder, case, case + 1, tuple(folder.keys)) for case in wanted if case not in known]
        return cls(folder, cover, tasks, threads, progress, notice)

    def derive(self) -> None:
        """Compute the formulas that follow from what is stored."""
        folder = self.folder
        for part in folder.cover().parts:
            if names := derivable(self.study, part.missing):
                folder.store(derived(self.study, rows_of(folder, part), names))

    @property
    def finished(self) -> bool:
        """Whether nothing is left to compute."""
        return not self._left

    def next(self, workers: int = 1) -> Task | None:
        """The next task: what stored cases lack first, then new cases in order."""
        if self._tasks:
            return self._tasks.pop(0)
        if not self._gaps:
            return None
        gap = self._gaps.pop(0)
        end = gap.first + self._pace.size(gap.end - gap.first, workers)
        if end < gap.end:
            self._gaps.insert(0, Gap(end, gap.end))
        return _task(self.folder, gap.first, end, tuple(self.folder.keys))

    def again(self, task: Task) -> None:
        """Put back a task that was lost."""
        self._tasks.insert(0, task)

    def order(self, task: Task, threads: int | None = None) -> bytes:
        """The task as plain data."""
        return order(self.study, task, threads)

    def compute(self, task: Task, executor: Executor = PROCESSOR) -> bytes:
        """Compute a task in this process, its cases by an executor. Threads may compute several tasks at once."""
        self._own_threads = thread_count(self.threads)
        return pack(compute(self.study, task, self.threads, self._share(task), executor))

    def end(self) -> None:
        """Interrupt what is being computed, by a KeyboardInterrupt in its thread."""
        self._ending.set()

    def done(self, task: Task, block: bytes) -> None:
        """Verify a block as if it were a file of anybody's, and store it."""
        which = f"the block of cases {task.first} to {task.first + len(task.values) - 1}"
        found = unpack(block, which)
        label, folder = found.label, self.folder
        expected = folder.address(task.first, task.first + len(task.values)), folder.base, folder.engine, task.first
        if (label.address, label.base, label.engine, label.first) != expected or not set(task.quantities) <= set(
            label.keys
        ):
            hint = "install the same tmodes on all machines"
            raise file_error(which, "a block of something else", "what was asked for", hint)
        folder.write(found)
        work = float(found.rows.seconds.sum())
        self._pace.took(label.count, label.wall, work, self._own_threads, len(block) // label.count)
        self._left -= label.count
        self._reached.pop(task.first, None)
        self.report()

    def report(self) -> None:
        """Progress: the share of all cases that are done, with those of the blocks that are being computed."""
        done = self._total - self._left + sum(list(self._reached.values()))
        self._progress("cases", min(1.0, done / max(self._total, 1)))

    def _share(self, task: Task) -> Progress:
        """Progress of a block as a part of the whole: that of its cases; preparing them is heard, not counted."""
        reached, cases = self._reached, len(task.values)
        reached[task.first] = 0.0

        def tell(stage: str, share: float) -> None:
            if self._ending.is_set():
                raise KeyboardInterrupt
            if stage in _COUNTED:
                reached[task.first] = max(reached[task.first], cases * share)
            self.report()

        return tell


_COUNTED = ("running", "results", "statics")
"""Stages of :meth:`Study.evaluate` that go through the cases."""


def _asked(folder: Folder, part: Part) -> tuple[str, ...]:
    """What is to be computed of stored cases; formulas follow from it, and are derived."""
    quantities = folder.study.sheet.quantities
    left = [name for name in part.missing if name not in derivable(folder.study, part.missing)]
    return tuple(name for name in left if not is_formula(quantities[name]))


def _task(folder: Folder, first: int, end: int, quantities: tuple[str, ...]) -> Task:
    return Task(first, folder.values[first:end], quantities, kept_cases(folder.study, first, end))
