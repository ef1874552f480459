"""The log of a long run: whole records only, in the right order, of the same run."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest

from tmodes.errors import ResultFileError
from tmodes.io import checkpoint
from tmodes.io.checkpoint import CheckpointWriter, Record, read_checkpoint, run_identity

IDENTITY = run_identity("robot", "mechanism", "settings")


def record(number: int) -> Record:
    return {"time": np.array(number / 7), "state": np.sin(np.arange(12.0).reshape(2, 6) + number), "none": np.zeros(0)}


def same(records: tuple[Record, ...], count: int) -> bool:
    """Whether the records are the first ``count``, to the bit."""
    if len(records) != count:
        return False
    return all(
        list(is_) == list(should)
        and all(
            is_[name].shape == should[name].shape and is_[name].tobytes() == should[name].tobytes() for name in should
        )
        for is_, should in zip(records, map(record, range(count)), strict=True)
    )


def written(path: Path, count: int) -> list[int]:
    """A log of ``count`` records; the length of the file after each."""
    with CheckpointWriter(path, IDENTITY) as log:
        lengths = [path.stat().st_size]
        for number in range(count):
            log.append(record(number))
            lengths.append(path.stat().st_size)
    return lengths


def test_records_come_back_to_the_bit(tmp_path: Path) -> None:
    written(tmp_path / "log", 3)
    back = read_checkpoint(tmp_path / "log", IDENTITY)
    assert same(back.records, 3)
    assert back.ignored == ""
    back.records[0]["state"][0] = 1.0  # a record may be used as a state


def test_a_log_torn_at_any_byte_of_its_last_record(tmp_path: Path) -> None:
    path = tmp_path / "log"
    lengths = written(path, 3)
    content = path.read_bytes()
    for length in range(lengths[2] + 1, lengths[3]):
        path.write_bytes(content[:length])
        back = read_checkpoint(path, IDENTITY)
        assert same(back.records, 2)
        assert back.end == lengths[2]
        assert "record 3 is torn" in back.ignored


def test_a_torn_log_goes_on_as_if_nothing_had_been(tmp_path: Path) -> None:
    path = tmp_path / "log"
    lengths = written(path, 3)
    content = path.read_bytes()
    path.write_bytes(content[: lengths[3] - 5])
    with CheckpointWriter(path, IDENTITY) as log:
        log.append(record(2))
    assert path.read_bytes() == content


def test_rubbish_longer_than_a_record_is_cut_off(tmp_path: Path) -> None:
    path = tmp_path / "log"
    written(path, 3)
    content = path.read_bytes()
    written(tmp_path / "other", 2)
    path.write_bytes((tmp_path / "other").read_bytes() + b"rubbish" * 1000)
    with CheckpointWriter(path, IDENTITY) as log:
        log.append(record(2))
    assert path.read_bytes() == content


def test_a_flipped_bit_is_never_believed(tmp_path: Path) -> None:
    path = tmp_path / "log"
    lengths = written(path, 2)
    content = path.read_bytes()
    # All bits of the start of the file and of a record, and of what checksums cover one of each byte.
    starts = {*range(lengths[0]), *range(lengths[1], lengths[1] + checkpoint.RECORD.size)}
    places = {8 * byte + bit for byte in range(len(content)) for bit in (range(8) if byte in starts else [byte % 8])}
    for place in sorted(places):
        bad = bytearray(content)
        bad[place // 8] ^= 1 << place % 8
        path.write_bytes(bad)
        whole = sum(length <= place // 8 for length in lengths[1:])
        if place // 8 < lengths[0]:
            with pytest.raises(ResultFileError):
                read_checkpoint(path, IDENTITY)
        else:
            back = read_checkpoint(path, IDENTITY)
            assert same(back.records, whole)
            assert f"record {whole + 1} is torn or damaged" in back.ignored


def test_a_torn_header_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "log"
    content = path.read_bytes() if written(path, 0) else b""
    for length in range(len(content)):
        path.write_bytes(content[:length])
        with pytest.raises(ResultFileError, match="header"):
            read_checkpoint(path, IDENTITY)


def test_the_log_of_another_run_is_refused_and_kept(tmp_path: Path) -> None:
    path = tmp_path / "log"
    written(path, 1)
    content = path.read_bytes()
    with pytest.raises(ResultFileError, match="another run"):
        read_checkpoint(path, run_identity("robot", "mechanism", "other settings"))
    with pytest.raises(ResultFileError, match="another run"):
        CheckpointWriter(path, "other")
    assert path.read_bytes() == content


def test_identities_keep_their_parts_apart() -> None:
    assert run_identity("ab", "c") != run_identity("a", "bc")


def test_a_newer_log_and_a_foreign_file_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "log"
    written(path, 0)
    start = bytearray(path.read_bytes()[:-4])
    struct.pack_into("<I", start, 8, 2)
    path.write_bytes(bytes(start) + struct.pack("<I", zlib.crc32(start)))
    with pytest.raises(ResultFileError, match="format version 2"):
        read_checkpoint(path, IDENTITY)
    path.write_bytes(b"something else entirely")
    with pytest.raises(ResultFileError, match="another kind"):
        read_checkpoint(path, IDENTITY)
    with pytest.raises(ResultFileError, match="No such file"):
        read_checkpoint(tmp_path / "missing", IDENTITY)
    with pytest.raises(ResultFileError, match="directory"):
        read_checkpoint(tmp_path, IDENTITY)


def test_a_length_beyond_the_file_is_not_allocated(tmp_path: Path) -> None:
    path = tmp_path / "log"
    written(path, 1)
    with path.open("ab") as file:
        file.write(checkpoint.RECORD.pack(checkpoint.RECORD_MAGIC, 2**62, b"\0" * 32))
    back = read_checkpoint(path, IDENTITY)
    assert same(back.records, 1)
    assert "record 2" in back.ignored


@pytest.mark.parametrize("value", [np.nan, np.inf])
def test_a_number_that_is_not_finite_is_not_stored(value: float, tmp_path: Path) -> None:
    with CheckpointWriter(tmp_path / "log", IDENTITY) as log:
        log.append(record(0))
        with pytest.raises(ResultFileError, match="'state' must be finite numbers, got a number that is not finite"):
            log.append({"state": [0.0, value]})
    assert same(read_checkpoint(tmp_path / "log", IDENTITY).records, 1)


KILLED = """
import sys, numpy as np
from tmodes.io.checkpoint import CheckpointWriter
with CheckpointWriter(sys.argv[1], "id") as log:
    for number in range(10**6):
        log.append({"number": number, "state": np.full(20000, float(number))})
        print(number, flush=True)
"""


@pytest.mark.skipif(sys.platform == "win32", reason="needs signals")
def test_killed_while_it_appends_what_was_acknowledged_is_there(tmp_path: Path) -> None:
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", KILLED, str(tmp_path / "log")]
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment, text=True) as child:
        assert child.stdout is not None
        info = [child.stdout.readline() for _ in range(15)]
        child.kill()
        last = int([*info, *(line for line in child.stdout if line.endswith("\n"))][-1])
    records = read_checkpoint(tmp_path / "log", "id").records
    assert len(records) in (last + 1, last + 2)
    assert all((entry["state"] == number).all() for number, entry in enumerate(records))
