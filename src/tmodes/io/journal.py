"""The journal of a long run: its progress on disk every few seconds, so that a killed run continues where it was."""

from __future__ import annotations

import os
import time as clock
from pathlib import Path

import numpy as np

from tmodes.io.checkpoint import CheckpointWriter, Record, read_checkpoint

__all__ = ["RunJournal"]

_GROWING = ("samples", "errors_out")
"""Arrays of which each record holds what is new."""


class RunJournal:
    """Keeps memory, state and the samples since the last record, every ``seconds`` of computing."""

    def __init__(self, path: str | os.PathLike[str], identity: str, seconds: float = 2.0) -> None:
        self.path, self.identity, self.seconds = Path(path), identity, seconds
        self._writer: CheckpointWriter | None = None
        self._kept_samples = 0
        self._began = self._last = clock.monotonic()

    def restore(self) -> Record | None:
        """The run as far as it was kept, or None when there is nothing yet.

        Raises :class:`tmodes.errors.ResultFileError` when the file belongs to another run.
        """
        if not self.path.exists():
            return None
        records = read_checkpoint(self.path, self.identity).records
        if not records:
            return None
        whole = {name: np.concatenate([record[name] for record in records]) for name in _GROWING}
        self._kept_samples = len(whole["samples"])
        return {**records[-1], **whole}

    def keep(self, record: Record, *, last: bool = False, now: bool = False) -> None:
        """Keep the progress when the last record is old enough; the ``last`` one of any run that was not short.

        ``now``: whatever the age.
        """
        if not now and clock.monotonic() - (self._began if last else self._last) < self.seconds:
            return
        self._writer = self._writer or CheckpointWriter(self.path, self.identity)
        self._writer.append(record | {name: record[name][self._kept_samples :] for name in _GROWING})
        self._kept_samples = len(record["samples"])
        self._last = clock.monotonic()

    def close(self) -> None:
        """Close the file; it stays."""
        if self._writer:
            self._writer.close()

    def remove(self) -> None:
        """Close and remove: the run's result is safe elsewhere."""
        self.close()
        self.path.unlink(missing_ok=True)
