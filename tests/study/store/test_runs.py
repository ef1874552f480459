"""A study in its folder: computed once, resumed, extended, asked for more."""

from __future__ import annotations

from pathlib import Path
from threading import Event
from typing import Any

import numpy as np
import pytest

from patience import until
from study.store.fake import FakeStudy, data, fake
from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock
from tmodes.study.quantities import Needs
from tmodes.study.rows import Rows
from tmodes.study.runner import run_study
from tmodes.study.store import BLOCKS


def table(result):
    return result.table().drop_columns("seconds").to_pydict()


def computed(study):
    return sum(count for _, count, _ in study.calls)


def test_a_study_is_computed_once(tmp_path):
    study = fake(data(1000, ("peak", "sag"), block=100))
    first = run_study(study, tmp_path)
    assert first.complete
    assert computed(study) == 1000
    assert first.rows.case.tolist() == list(range(1000))
    assert first.rows.quantities["peak"] == pytest.approx(
        study.design().values[:, 0] ** 2 + study.design().values[:, 1]
    )
    again = run_study(study, tmp_path)
    assert computed(study) == 1000
    assert table(first) == table(again)


def test_a_longer_study_computes_the_new_cases_only(tmp_path):
    short, long = fake(data(250, block=100)), fake(data(1000, block=100))
    run_study(short, tmp_path)
    result = run_study(long, tmp_path)
    assert computed(long) == 750
    assert table(result) == table(run_study(fake(data(1000)), tmp_path / "whole"))


def test_another_quantity_computes_that_quantity_only(tmp_path):
    run_study(fake(data(300, ("peak",), block=100)), tmp_path)
    more = fake(data(300, ("peak", "sag"), block=100))
    result = run_study(more, tmp_path)
    assert {names for _, _, names in more.calls} == {("sag",)}
    assert table(result) == table(run_study(fake(data(300, ("peak", "sag"))), tmp_path / "whole"))
    fewer = fake(data(300, ("sag",), block=100))
    assert list(run_study(fewer, tmp_path).rows.quantities) == ["sag"]
    assert not fewer.calls


def test_a_case_that_failed_by_a_quantity_is_not_kept_without_it(tmp_path):
    """Rows that failed by a quantity that is no longer asked for are computed again; the others are not."""
    run_study(fake(data(300, ("peak", "bad"), block=10)), tmp_path)
    fewer = fake(data(300, ("peak",), block=10))
    result = run_study(fewer, tmp_path)
    assert result.counts == {"finished": 300}
    assert 0 < computed(fewer) < 300
    assert table(result) == table(run_study(fake(data(300, ("peak",))), tmp_path / "whole"))


def test_failed_cases_are_rows_with_their_reason(tmp_path):
    result = run_study(fake(data(300, ("peak", "bad"))), tmp_path)
    bad = result.design.values[:, 0] > 0.9
    assert result.counts == {"finished": int((~bad).sum()), "failed": int(bad.sum())}
    assert [reason == "no number" for reason in result.rows.reason] == bad.tolist()
    assert np.isnan(result.rows.quantities["bad"]).tolist() == bad.tolist()
    assert result.table()["bad"].null_count == bad.sum()


def test_interrupted_between_blocks_it_resumes(tmp_path):
    whole = table(run_study(fake(data(500, block=50)), tmp_path / "whole"))

    def interrupts(first):
        if first == 200:
            raise KeyboardInterrupt

    study = fake(data(500, block=50), before=interrupts)
    with pytest.raises(KeyboardInterrupt):
        run_study(study, tmp_path / "cut")
    resumed = fake(data(500, block=50))
    result = run_study(resumed, tmp_path / "cut")
    assert computed(resumed) == 300
    assert table(result) == whole


LOOPS = Needs(reductions=(("deviation", "max"),))


def test_a_block_is_prepared_while_another_one_runs(tmp_path):
    """Each of the second and third block ends only once the other has begun."""
    begun = {first: Event() for first in range(0, 500, 50)}

    def meets(first):
        begun[first].set()
        if first in (50, 100):
            until(begun[150 - first].is_set)

    result = run_study(fake(data(500, block=50), before=meets, needs=LOOPS), tmp_path, threads=2)
    assert result.complete
    assert table(result) == table(run_study(fake(data(500)), tmp_path / "whole"))


def test_what_is_finished_when_another_block_fails_is_kept(tmp_path):
    begun = Event()

    def fails(first):
        if first == 50:
            begun.set()
        if first == 100:
            until(begun.is_set)
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(fake(data(500, block=50), before=fails, needs=LOOPS), tmp_path, threads=2)
    resumed = fake(data(500, block=50))
    assert run_study(resumed, tmp_path).complete
    assert {first for first, _, _ in resumed.calls}.isdisjoint({0, 50})


def test_a_full_disk_is_a_sentence_and_what_is_there_stays(tmp_path, monkeypatch):
    """The write of the fifth block fails as a full disk does."""
    written = []
    write = Path.write_bytes

    def full(self, content):
        if content.startswith(b"TMBLOCK"):
            written.append(self)
            if len(written) == 5:
                write(self, content[: len(content) // 2])
                raise OSError(28, "No space left on device")
        return write(self, content)

    monkeypatch.setattr(Path, "write_bytes", full)
    with pytest.raises(ResultFileError, match=r"No space left on device.*free some space"):
        run_study(fake(data(500, block=50)), tmp_path)
    monkeypatch.undo()
    assert len([*(tmp_path / BLOCKS).iterdir()]) == 4
    resumed = fake(data(500, block=50))
    assert run_study(resumed, tmp_path).complete
    assert computed(resumed) == 300


def test_a_second_process_is_refused(tmp_path):
    """R22: before it computes anything."""
    study = fake(data(100))
    with FolderLock(tmp_path), pytest.raises(ResultFileError, match="held by process"):
        run_study(study, tmp_path)
    assert not study.calls
    assert run_study(study, tmp_path).complete


def test_another_engine_is_refused_or_recomputed_with_a_notice(tmp_path, monkeypatch):
    run_study(fake(data(300, block=100)), tmp_path)
    old = {file.name for file in (tmp_path / BLOCKS).iterdir()}
    for module in ("store", "tasks"):
        monkeypatch.setattr(f"tmodes.study.{module}.engine_of_blocks", lambda: "9.9-other")
    study = fake(data(400, block=100))
    with pytest.raises(ResultFileError, match=r"300 cases of another version of the engine.*--recompute"):
        run_study(study, tmp_path)
    assert not study.calls
    notices = []
    result = run_study(study, tmp_path, recompute=True, notice=notices.append)
    assert computed(study) == 400
    assert "300 cases" in notices[0]
    assert result.complete
    assert old < {file.name for file in (tmp_path / BLOCKS).iterdir()}


def test_motions_are_kept_and_one_more_costs_one_case(tmp_path):
    study = fake(data(300, block=100, keep={"cases": [0, 12]}))
    result = run_study(study, tmp_path)
    assert result.kept_cases == (0, 12)
    assert result.kept(12).states[0, 0] == 12.0
    more = fake(data(300, block=100, keep={"cases": [0, 12, 250]}))
    result = run_study(more, tmp_path)
    assert more.calls == [(250, 1, ("peak",))]
    assert result.kept(250).states[0, 0] == 250.0
    assert {file.name for file in (tmp_path / "trajectories").iterdir()} == {
        f"case_{case:06d}.nc" for case in (0, 12, 250)
    }


def test_blocks_grow_until_they_take_seconds(tmp_path):
    """Without `block` in the sheet: no fewer than 64 cases, and never one block for each few of many."""
    study = fake(data(100_000))
    run_study(study, tmp_path)
    sizes = [count for _, count, _ in study.calls]
    assert sizes[0] == 64
    assert len(sizes) < 12


def test_rows_of_an_interrupted_block_are_not_stored(tmp_path):
    class Interrupted(FakeStudy):
        def evaluate(self, first, values, progress=None, **more) -> Rows:
            rows = super().evaluate(first, values)
            rows.status[-1] = "interrupted"  # pyright: ignore[reportIndexIssue]
            return rows

    study: Any = Interrupted(data(100))
    with pytest.raises(KeyboardInterrupt):
        run_study(study, tmp_path)
    assert not [*(tmp_path / BLOCKS).iterdir()]
