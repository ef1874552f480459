"""Checkpoints of a long run: an append-only log of named arrays, each record whole or not there.

    magic (8) | format version (4) | length of the identity (4) | identity, UTF-8 | CRC-32 of all before (4)
    then records:  magic (4) | length of the payload (8) | SHA-256 of the payload (32) | payload
    a payload:     length of the index (4) | index, JSON: [[name, shape], ...] | the numbers, little-endian float64

Killed while it appends a record, a run restarts from the record before.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import struct
import sys
import time as clock
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Self, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.io.atomic import atomic_write, file_error
from tmodes.io.plain_file import regular_file

__all__ = ["Checkpoint", "CheckpointWriter", "Record", "RunJournal", "read_checkpoint", "run_identity"]

Record: TypeAlias = dict[str, NDArray[np.float64]]

FORMAT_VERSION = 1
MAGIC = b"TMCHECK\n"
HEADER = struct.Struct("<8sII")
CHECK = struct.Struct("<I")
RECORD_MAGIC = b"RECD"
RECORD = struct.Struct("<4sQ32s")
INDEX = struct.Struct("<I")


def run_identity(*parts: str) -> str:
    """SHA-256 of what makes two runs the same (robot, mechanism, settings, versions), as hexadecimal text."""
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()


@dataclass(frozen=True)
class Checkpoint:
    """What a log holds: its whole ``records`` in order, and what was wrong with the rest.

    ``end`` is the place [bytes] where the last whole record ends; ``ignored`` is one sentence about what follows it,
    empty when nothing does.
    """

    records: tuple[Record, ...]
    end: int
    ignored: str


def read_checkpoint(path: str | os.PathLike[str], identity: str) -> Checkpoint:
    """The whole records of a log that the same run wrote; a torn record ends it, and is given in ``ignored``.

    Raises :class:`tmodes.errors.ResultFileError` when the file is no checkpoint, is damaged in its header, is newer
    than this program, or belongs to another run. Sizes are checked against the length of the file before use.
    """
    try:
        with regular_file(path, sys.maxsize) as (file, size):
            _read_header(path, file, size, identity)
            return _read_records(file, size)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        raise file_error(path, f"“{reason}”", "a checkpoint", "check the name, or restart the run") from error


class CheckpointWriter:
    """Appends records to a log; when ``append`` returns, the record is on the disk.

    A log that the same run began is continued: a torn record at its end is cut off. A log of another run is refused.
    The caller holds the folder's lock (:class:`tmodes.io.atomic.FolderLock`).
    """

    def __init__(self, path: str | os.PathLike[str], identity: str) -> None:
        self.path = Path(path)
        if not os.path.lexists(self.path):
            with atomic_write(self.path, overwrite=False) as temporary:
                start = HEADER.pack(MAGIC, FORMAT_VERSION, len(identity.encode())) + identity.encode()
                temporary.write_bytes(start + CHECK.pack(zlib.crc32(start)))
        self._end = read_checkpoint(self.path, identity).end
        try:
            self._file: BinaryIO = self.path.open("rb+")
            self._file.truncate(self._end)
        except OSError as error:
            raise self._cannot_write(error) from error

    def append(self, arrays: Mapping[str, ArrayLike]) -> None:
        """Store named arrays of finite numbers as the next record.

        Raises :class:`tmodes.errors.ResultFileError` when a number is not finite or the disk is full; the records
        before stay whole.
        """
        payload = _payload(self.path, arrays)
        try:
            self._file.seek(self._end)
            self._file.write(RECORD.pack(RECORD_MAGIC, len(payload), hashlib.sha256(payload).digest()) + payload)
            self._file.flush()
            os.fsync(self._file.fileno())
        except OSError as error:
            raise self._cannot_write(error) from error
        self._end += RECORD.size + len(payload)

    def close(self) -> None:
        """Close the file."""
        self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def _cannot_write(self, error: OSError) -> Exception:
        hint = "free some space or fix the permissions; the records before are whole"
        return file_error(self.path, f"“{error.strerror}” when writing", "a file that can be written", hint)


def _read_header(path: object, file: BinaryIO, size: int, identity: str) -> None:
    """Leave the file at its first record; refuse a foreign one."""
    restart = "delete the file to restart the run, or use another folder"
    start = file.read(HEADER.size)
    magic, version, length = HEADER.unpack(start) if len(start) == HEADER.size else (b"", 0, 0)
    if magic != MAGIC or length > size - HEADER.size - CHECK.size:
        raise file_error(path, "a file of another kind, or a damaged header", "a checkpoint of tmodes", restart)
    start += file.read(length)
    if zlib.crc32(start) != CHECK.unpack(file.read(CHECK.size))[0]:
        raise file_error(path, "a damaged header", "a header that matches its checksum", restart)
    if version != FORMAT_VERSION:
        raise file_error(
            path, f"format version {version}", f"version {FORMAT_VERSION}", "upgrade tmodes, or " + restart
        )
    if start[HEADER.size :] != identity.encode():
        raise file_error(path, "the checkpoint of another run", "the same robot, settings and versions", restart)


def _read_records(file: BinaryIO, size: int) -> Checkpoint:
    records: list[Record] = []
    end = file.tell()
    while end < size:
        record = _read_record(file, size - end)
        if record is None:
            word = f"record {len(records) + 1} is torn or damaged: its {size - end:,} bytes to the end are ignored"
            return Checkpoint(tuple(records), end, word)
        records.append(record)
        end = file.tell()
    return Checkpoint(tuple(records), end, "")


def _read_record(file: BinaryIO, left: int) -> Record | None:
    """The record that starts here, or None when it is not whole; ``left`` is the number of bytes to the end."""
    head = file.read(RECORD.size)
    if len(head) < RECORD.size:
        return None
    magic, length, digest = RECORD.unpack(head)
    if magic != RECORD_MAGIC or length > left - RECORD.size:
        return None
    payload = file.read(length)
    return _arrays(payload) if hashlib.sha256(payload).digest() == digest else None


def _payload(path: object, arrays: Mapping[str, ArrayLike]) -> bytes:
    values = {name: np.ascontiguousarray(value, dtype="<f8") for name, value in arrays.items()}
    for name, value in values.items():
        if not np.isfinite(value).all():
            raise file_error(f"{path}, array {name!r}", "a number that is not finite", "finite numbers", "stop the run")
    index = json.dumps([[name, np.shape(arrays[name])] for name in values]).encode()
    return INDEX.pack(len(index)) + index + b"".join(value.tobytes() for value in values.values())


def _arrays(payload: bytes) -> Record:
    start = INDEX.size + INDEX.unpack_from(payload)[0]
    record: Record = {}
    for name, shape in json.loads(payload[INDEX.size : start]):
        numbers = np.frombuffer(payload, dtype="<f8", count=math.prod(shape), offset=start)
        record[name] = numbers.astype(np.float64).reshape(shape)
        start += numbers.nbytes
    return record


class RunJournal:
    """Keeps memory, state and the samples since the last record, every ``seconds`` of computing."""

    def __init__(self, path: str | os.PathLike[str], identity: str, seconds: float = 2.0) -> None:
        self.path, self.identity, self.seconds = Path(path), identity, seconds
        self._writer: CheckpointWriter | None = None
        self._kept_samples = 0
        self._began = self._last = clock.monotonic()

    def restore(self) -> Record | None:
        """The run as far as it was kept, None when there is nothing yet; ResultFileError for a file of another run."""
        if not self.path.exists():
            return None
        records = read_checkpoint(self.path, self.identity).records
        if not records:
            return None
        samples = np.concatenate([record["samples"] for record in records])
        self._kept_samples = len(samples)
        return {**records[-1], "samples": samples}

    def keep(self, record: Record, *, last: bool = False, now: bool = False) -> None:
        """Keep the progress when the last record is old enough; the ``last`` one of any run that was not short.

        ``now``: whatever the age.
        """
        if not now and clock.monotonic() - (self._began if last else self._last) < self.seconds:
            return
        self._writer = self._writer or CheckpointWriter(self.path, self.identity)
        self._writer.append(record | {"samples": record["samples"][self._kept_samples :]})
        self._kept_samples = len(record["samples"])
        self._last = clock.monotonic()

    def close(self) -> None:
        """Close the file; it stays."""
        if self._writer:
            self._writer.close()
