"""R23: a study folder that is tampered with, foreign, cut, or newer is refused before it is touched."""

from __future__ import annotations

import hashlib
import json
import os
import struct
import tracemalloc
from dataclasses import replace

import numpy as np
import pytest

from study.store.fake import data, fake
from tmodes.errors import InputError, ResultFileError
from tmodes.io.atomic import LOCK_NAME
from tmodes.result.record import STATUSES
from tmodes.simulation.case_results import CaseResults
from tmodes.study.blocks import PREFIX, canonical, pack, unpack
from tmodes.study.places import dask
from tmodes.study.runner import run_study
from tmodes.study.store import BLOCKS, STUDY_FILE, TABLE, Folder, description

SHEET = data(100, ("peak", "sag"), block=50, keep={"cases": [3]})


@pytest.fixture
def folder(tmp_path):
    run_study(fake(SHEET), tmp_path)
    return tmp_path


@pytest.fixture
def block(folder):
    return min((folder / BLOCKS).iterdir())


def refused(folder, info, study=None):
    study = study or fake(SHEET)
    before = {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}
    with pytest.raises(ResultFileError, match=info):
        run_study(study, folder)
    assert not study.calls
    assert {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()} == before


def test_every_flipped_bit_is_found(block):
    """Somewhere in the start, in the header, in the payload."""
    whole = block.read_bytes()
    for place in [*range(0, PREFIX.size, 3), *np.linspace(PREFIX.size, len(whole) - 1, 200).astype(int).tolist()]:
        broken = bytearray(whole)
        broken[place] ^= 1 << place % 8
        with pytest.raises(ResultFileError):
            unpack(bytes(broken), "block")


def test_every_ending_of_a_run_is_stored(block):
    found = unpack(block.read_bytes(), block)
    words = [*STATUSES, "refused"]
    for word in words:
        rows = replace(found.rows, status=(word,) * len(found.rows))
        assert list(unpack(pack(replace(found, rows=rows)), "block").rows.status) == [word] * len(rows)
    results = CaseResults.of_all(len(words))
    results.status[:] = words
    results.add(CaseResults.of_all(len(words), "finished"))
    assert results.status.tolist() == words


def test_every_cut_is_found(block):
    whole = block.read_bytes()
    for length in [0, 1, PREFIX.size - 1, PREFIX.size, PREFIX.size + 10, len(whole) // 2, len(whole) - 1]:
        with pytest.raises(ResultFileError):
            unpack(whole[:length], "block")
    with pytest.raises(ResultFileError, match="its start says"):
        unpack(whole + b"\0", "block")


def test_a_flipped_bit_in_the_folder_is_refused(folder, block):
    content = bytearray(block.read_bytes())
    content[-1] ^= 1
    block.write_bytes(content)
    refused(folder, "does not match its checksum; delete this file to compute its cases again")
    block.unlink()
    study = fake(SHEET)
    assert run_study(study, folder).complete
    assert len(study.calls) == 1


def test_a_truncated_block_is_refused(folder, block):
    block.write_bytes(block.read_bytes()[:-8])
    refused(folder, "bytes, where its start says")


def test_sizes_that_promise_too_much_take_no_memory(block):
    """A header of 4 GB, a payload of 2^60 bytes: the file is shorter."""
    for at, kind, size in ((12, "<I", 2**32 - 1), (16, "<Q", 2**60)):
        broken = bytearray(block.read_bytes())
        struct.pack_into(kind, broken, at, size)
        with pytest.raises(ResultFileError, match="where its start says"):
            unpack(bytes(broken), "block")


def test_a_newer_block_is_refused(folder, block):
    content = bytearray(block.read_bytes())
    struct.pack_into("<I", content, 8, 2)
    block.write_bytes(content)
    refused(folder, "format version 2; upgrade|version 1, got format version 2; upgrade tmodes")


def test_a_block_with_other_numbers_and_new_checksums_is_refused(block):
    """Cases that are not those of its address: whoever has written it, they are not the cases of this study."""
    found = unpack(block.read_bytes(), block)
    values = dict(found.rows.parameters)
    values["gear"] = values["gear"] + 1e-9
    forged = pack(replace(found, rows=replace(found.rows, parameters=values)))
    with pytest.raises(ResultFileError, match="another address"):
        unpack(forged, "block")


def test_a_linked_block_is_refused(folder, block, tmp_path_factory):
    moved = tmp_path_factory.mktemp("elsewhere") / block.name
    block.rename(moved)
    block.symlink_to(moved)
    refused(folder, "link")


def test_linked_blocks_folder_is_refused(folder, tmp_path_factory):
    moved = tmp_path_factory.mktemp("elsewhere") / "blocks"
    (folder / BLOCKS).rename(moved)
    (folder / BLOCKS).symlink_to(moved)
    refused(folder, "got a link")
    with pytest.raises(ResultFileError, match="got a link"):
        run_study(fake(SHEET), folder, overwrite=True)
    assert [*moved.iterdir()]


def test_a_block_under_another_name_and_a_foreign_file_are_refused(folder, block):
    renamed = block.with_name("0" * 40 + ".block")
    block.rename(renamed)
    refused(folder, "under the name of another")
    renamed.rename(block)
    (folder / BLOCKS / "notes.txt").write_text("mine")
    refused(folder, "no block")


def test_blocks_of_another_robot_are_refused(folder, tmp_path):
    other = fake(SHEET | {"robot": "another"})
    refused(folder, "another robot or of other parameters.*--overwrite", other)
    run_study(other, tmp_path / "other")
    foreign = min((tmp_path / "other" / BLOCKS).iterdir())
    (folder / BLOCKS / foreign.name).write_bytes(foreign.read_bytes())
    refused(folder, "a block of another robot")


def test_overwrite_replaces_a_study_and_nothing_else(folder):
    (folder / "notes.txt").write_text("mine")
    other = fake(data(80, robot="another"))
    assert run_study(other, folder, overwrite=True).complete
    assert (folder / "notes.txt").read_text() == "mine"
    assert not [*(folder / "trajectories").glob("*.nc")]


def test_overwrite_removes_nothing_where_something_is_in_the_way(folder):
    """A file of another's among the blocks, a folder in place of the table: refused each time, and all is there."""
    for place, made in ((folder / BLOCKS / "notes.txt", False), (folder / "study.html", True)):
        place.mkdir() if made else place.write_text("mine")
        before = {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}
        for _ in range(2):
            with pytest.raises(ResultFileError, match=place.name):
                run_study(fake(data(80, robot="another")), folder, overwrite=True)
        assert {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()} == before
        place.rmdir() if made else place.unlink()
    assert run_study(fake(data(80, robot="another")), folder, overwrite=True).complete


def test_overwrite_removes_nothing_where_no_scheduler_answers(folder, monkeypatch):
    monkeypatch.setattr(dask, "CONNECT", "0.2s")
    before = [*folder.rglob("*")]
    with pytest.raises(InputError, match="no answer"):
        run_study(fake(data(80, robot="another")), folder, "dask://127.0.0.1:9", overwrite=True)
    assert [*folder.rglob("*")] == before


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="this system has no named pipes")
@pytest.mark.parametrize("which", ["block", "description", "lock", "table"])
def test_a_pipe_is_refused_and_does_not_block(which, folder, block):
    names = {"block": block, "description": folder / STUDY_FILE, "lock": folder / LOCK_NAME, "table": folder / TABLE}
    names[which].unlink(missing_ok=True)
    os.mkfifo(names[which])
    if which == "table":
        stored = Folder.of(folder, fake(SHEET), fake(SHEET).design().values)
        stored.table = "0" * 64
        assert not stored.has_table
        return
    with pytest.raises(ResultFileError, match="pipe"):
        run_study(fake(SHEET), folder)


@pytest.mark.parametrize("content", ["[" * 60_000, "[]", '{"pid": "x"}', "1" * 6000])
def test_a_lock_of_nobody(content, folder):
    """Refused while it is young, as that of another version, or taken over."""
    lock = folder / LOCK_NAME
    lock.write_text(content)
    with pytest.raises(ResultFileError, match="a lock "):
        run_study(fake(SHEET), folder)
    os.utime(lock, (0, 0))
    if not content.startswith("{"):
        assert run_study(fake(SHEET), folder).complete


def test_a_block_that_is_longer_than_its_start_says_is_not_read(folder, block):
    """Three gigabytes, of which the disk has none."""
    os.truncate(block, 3 * 2**30)
    tracemalloc.start()
    with pytest.raises(ResultFileError, match="its start says"):
        Folder.of(folder, fake(SHEET), fake(SHEET).design().values).labels()
    assert tracemalloc.get_traced_memory()[1] < 1e6
    tracemalloc.stop()


@pytest.mark.parametrize("change", [
    {"wall": float("inf")}, {"wall": float("nan")}, {"first": float("inf")}, {"first": 10**400}, {"engine": 1.5},
    {"keys": {"peak": float("inf")}}, {"failed": "many"}, {"count": [1]},
], ids=str)  # fmt: skip
def test_a_sealed_header_with_other_values(change, block):
    """Whoever can write a file can also make its checksums."""
    content = block.read_bytes()
    magic, version, size, body, _, digest = PREFIX.unpack(content[: PREFIX.size])
    header = json.loads(content[PREFIX.size : PREFIX.size + size])
    header["label"] |= change
    text = json.dumps(header).encode()
    start = PREFIX.pack(magic, version, len(text), body, hashlib.sha256(text).digest(), digest)
    with pytest.raises(ResultFileError):
        unpack(start + text + content[PREFIX.size + size :], "block")


def test_a_sealed_number_whose_square_overflows(block):
    known = unpack(block.read_bytes(), "block")
    rows = replace(known.rows, quantities={name: np.full(50, 1e308) for name in known.rows.quantities})
    with pytest.raises(ResultFileError, match="beyond 1e\\+150"):
        unpack(pack(replace(known, rows=rows)), "block")


def sealed_again(info):
    info = {key: value for key, value in info.items() if key != "digest"}
    return json.dumps(info | {"digest": hashlib.sha256(canonical(info)).hexdigest()})


DAMAGED = {
    "no JSON": lambda info: "{",
    "another kind": lambda info: json.dumps(info | {"kind": "recipe"}),
    "a file of another kind": lambda info: "[]",
    "no JSON of a study": lambda info: json.dumps(info | {"cases": float("inf")}),
    "another kind of value under data": lambda info: sealed_again(info | {"data": []}),
    "format 2.*upgrade|got format 2; upgrade": lambda info: json.dumps(info | {"format": 2}),
    "does not match its digest": lambda info: json.dumps(info | {"cases": 99}),
    "no JSON of": lambda info: "[" * 100_000,
}


@pytest.mark.parametrize("info", list(DAMAGED))
def test_a_damaged_description_is_refused(info, folder):
    file = folder / STUDY_FILE
    file.write_text(DAMAGED[info](json.loads(file.read_text())))
    with pytest.raises(ResultFileError, match=info):
        description(folder)
    refused(folder, info)


def test_blocks_without_a_description_are_refused(folder):
    (folder / STUDY_FILE).unlink()
    refused(folder, "blocks without study.json")


def test_a_folder_in_which_nothing_can_be_written(tmp_path):
    (tmp_path / "file").write_text("")
    with pytest.raises(ResultFileError, match="which is a file"):
        run_study(fake(SHEET), tmp_path / "file" / "study")


def test_a_column_that_would_hide_another_is_refused_before_anything_runs(tmp_path):
    study = fake(data(100))
    study.data["study"]["parameters"]["status"] = study.data["study"]["parameters"].pop("payload")  # pyright: ignore[reportIndexIssue]
    with pytest.raises(InputError, match="a name that the table has already"):
        run_study(study, tmp_path)
    assert not study.calls
