"""BatchRun: what a batch of runs gave, lane by lane; in memory, or in a folder whose files are whole or absent."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.integrate.settings import MOST_BYTES
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import FolderLock, atomic_write, check_writable, file_error
from tmodes.io.plain_file import parsed_json, regular_file, whole_file
from tmodes.io.printed import shortened
from tmodes.simulation.case_results import COUNTS, CaseResults
from tmodes.simulation.parts import Trajectory

__all__ = [
    "BATCH_FORMAT", "BatchRun", "check_room", "load_batch", "room_for", "stored",
]  # fmt: skip

Array = NDArray[np.float64]

BATCH_FORMAT = 1
"""Version of the files of a batch."""

_STATES, _TIMES, _TIPS, _SUMMARY = "states.npy", "times.npy", "tips.npy", "batch.json"


@dataclass(frozen=True, eq=False, repr=False)
class BatchRun:
    """k runs of one structure, sampled at the same times.

    ``times`` (n,) [s]; ``states`` (k, n, nx): coordinates, their rates, and what else is integrated, not-a-number where
    a lane has no sample; a motor whose gear is rigid in a lane moves as its joint. ``counts`` (k,): samples of each
    lane. ``status``: finished, diverged, stopped (a limit of the settings), interrupted, or failed (it could not
    start), and ``message`` what happened, for each lane. ``statistics``: steps, rejected, evaluations (k,). ``values``:
    numbers that differ between the lanes, (k,) each, by path of the data sheet. ``tips`` (k, n, 3): position of the tip
    in the world [m], or None. ``folder``: where the batch lies on disk, or None. ``figures`` (k,): numbers asked for in
    place of the samples, by name; ``states`` is then (k, 0, nx).
    """

    coordinates: tuple[str, ...]
    times: Array
    states: Array
    counts: NDArray[np.int64]
    status: tuple[str, ...]
    message: tuple[str, ...]
    statistics: dict[str, NDArray[np.int64]]
    values: dict[str, Array] = field(default_factory=dict)
    tips: Array | None = None
    folder: Path | None = None
    figures: dict[str, Array] = field(default_factory=dict)

    @classmethod
    def of(cls, coordinates: tuple[str, ...], times: Array, states: Array, results: CaseResults) -> BatchRun:
        """The batch of runs whose samples are in ``states`` already."""
        words = tuple(results.status.tolist()), tuple(results.message.tolist())
        return cls(coordinates, times, states, results.samples, *words, results.statistics)

    def __repr__(self) -> str:
        seen = f"{len(self.times)} samples of {', '.join(self.coordinates)}"
        return shortened([f"{self.size} runs, {int(self.finished.sum())} of them finished: {seen}"], "see .coordinates")

    @property
    def size(self) -> int:
        """Number of lanes."""
        return len(self.status)

    @property
    def finished(self) -> NDArray[np.bool_]:
        """Which lanes reached their end, (k,)."""
        return np.array([status == "finished" for status in self.status])

    def lane(self, index: int) -> Trajectory:
        """One lane as a run by itself."""
        count = int(self.counts[index])
        info = {name: float(values[index]) for name, values in self.statistics.items()}
        states = self.states[index, :count]
        return Trajectory(self.times[:count], states, self.status[index], self.message[index], info)


@contextmanager
def room_for(shape: tuple[int, int, int], folder: Path | None) -> Iterator[Array]:
    """An array for the samples: in memory, or a file of the folder, there under its name when the block ends well.

    Raises :class:`tmodes.errors.InputError` for more than memory is meant for, and
    :class:`tmodes.errors.ResultFileError` where the disk has no room, or a batch is there already.
    """
    check_room(shape, folder)
    if folder is None:
        yield np.empty(shape)
        return
    folder.mkdir(parents=True, exist_ok=True)
    with FolderLock(folder):
        _refuse_batch(folder)
        with atomic_write(folder / _STATES) as path:
            states = np.lib.format.open_memmap(path, mode="w+", dtype=np.float64, shape=shape)
            _reserve(path)
            yield states
            states.flush()
            del states


def _reserve(path: Path) -> None:
    """Take the disk's room for a file: to write into a map of a file whose disk is full ends the process."""
    if hasattr(os, "posix_fallocate"):
        with path.open("r+b") as file:
            os.posix_fallocate(file.fileno(), 0, path.stat().st_size)


def check_room(shape: tuple[int, int, int], folder: Path | None) -> None:
    """Refuse, with numbers, more samples (lanes, samples, size) than there is room for; and to write over a batch."""
    lanes, samples, size = shape
    needed = 8 * lanes * samples * size
    if folder is not None:
        _refuse_batch(folder)
        absent = [place for place in (folder, *folder.parents) if not place.exists()]
        check_writable(folder, needed)
        for place in absent:  # to ask leaves nothing behind
            place.rmdir()
    elif needed > MOST_BYTES:
        raise InputError(
            "simulate_batch",
            f"{lanes} lanes of {samples} samples of {size} numbers, {needed / 1e9:.3g} GB",
            f"at most {MOST_BYTES / 1e9:.3g} GB in memory",
            "give a folder (out=), a longer output_step, or fewer lanes",
        )


def _refuse_batch(folder: Path) -> None:
    if (folder / _SUMMARY).exists():
        raise file_error(folder / _SUMMARY, "a batch that is there", "a new folder", "choose another folder")
    if folder.is_dir() and (
        other := next((file for file in folder.iterdir() if not file.name.startswith(".tmodes")), None)
    ):
        raise file_error(f"folder {folder}", f"a folder with {other.name}", "an empty folder", "name another --out")


def _write(batch: BatchRun, folder: Path) -> None:
    """Write all but the samples, which are there; the description comes last, and only with it is a batch whole."""
    for name, values in ((_TIMES, batch.times), (_TIPS, batch.tips)):
        if values is not None:
            with atomic_write(folder / name) as path, path.open("wb") as file:
                np.save(file, values, allow_pickle=False)
    info = {
        "format": BATCH_FORMAT,
        "shape": list(batch.states.shape),
        "coordinates": list(batch.coordinates),
        "samples": batch.counts.tolist(),
        "status": list(batch.status),
        "message": list(batch.message),
        "statistics": {name: values.tolist() for name, values in batch.statistics.items()},
        "values": {
            path: [v if np.isfinite(v) else str(v) for v in values.tolist()] for path, values in batch.values.items()
        },
        "tips": batch.tips is not None,
    }
    with atomic_write(folder / _SUMMARY) as path:
        path.write_text(json.dumps(info, allow_nan=False), encoding="utf-8")


def stored(batch: BatchRun, folder: Path | None) -> BatchRun:
    """The batch as it is in its folder, written there first; without one as it is."""
    if folder is None:
        return batch
    _write(batch, folder)
    return load_batch(folder)


@checked_arguments
def load_batch(folder: str | os.PathLike[str]) -> BatchRun:
    """A batch from its folder; the samples stay on disk and are read when they are used.

    Raises :class:`tmodes.errors.ResultFileError` for what is not whole, is foreign, or does not fit together.
    """
    place = Path(folder)
    hint = "give the folder of a batch that came to its end"
    try:
        info = parsed_json(whole_file(place / _SUMMARY, MOST_BYTES))
        states, times = _mapped(place / _STATES), np.array(_mapped(place / _TIMES))
        if info["format"] != BATCH_FORMAT:
            raise file_error(place / _SUMMARY, f"format {info['format']!r}", f"format {BATCH_FORMAT}", "update tmodes")
        tips = _mapped(place / _TIPS) if info["tips"] else None
        batch = _batch(info, times, states, tips)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        got = getattr(error, "strerror", None) or str(error)
        raise file_error(f"folder {place}", f"no whole batch: {got}", "a batch", hint) from error
    return replace(batch, folder=place)


def _mapped(path: Path) -> Array:
    """The array of a file, which stays there."""
    with regular_file(path, sys.maxsize):
        return np.load(path, mmap_mode="r", allow_pickle=False)


def _batch(info: dict[str, Any], times: Array, states: Array, tips: Array | None) -> BatchRun:
    shape = tuple(info["shape"])
    lanes, samples = shape[:2]
    if states.shape != shape or states.dtype != np.float64 or times.shape != (samples,):
        raise ValueError(f"samples of shape {states.shape} at {times.shape} times, where {shape} are stated")
    if tips is not None and tips.shape != (lanes, samples, 3):
        raise ValueError(f"tips of shape {tips.shape}, where {(lanes, samples, 3)} are stated")
    statistics = {name: np.array(info["statistics"][name], dtype=np.int64) for name in COUNTS}
    values = {str(path): np.array(given, dtype=float) for path, given in info["values"].items()}
    counts = np.array(info["samples"], dtype=np.int64)
    columns = [info["status"], info["message"], counts, *statistics.values(), *values.values()]
    if any(len(column) != lanes for column in columns):
        raise ValueError(f"columns of {[len(column) for column in columns]} lanes, where {lanes} are stated")
    names, status, message = (tuple(map(str, info[name])) for name in ("coordinates", "status", "message"))
    return BatchRun(names, times, states, counts, status, message, statistics, values, tips)
