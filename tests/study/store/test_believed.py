"""R21, R23: what lies in a study folder is believed only as far as it was written for these cases, and lies there."""

from __future__ import annotations

import numpy as np
import pytest

from command import tmodes
from study.core.studies import short, study
from study.store.fake import data, fake
from tmodes.errors import ResultFileError
from tmodes.study.result import load_study
from tmodes.study.runner import run_study
from tmodes.study.store import MOTIONS, PAGE, STUDY_FILE, TABLE
from tmodes.study.table import TableColumns
from tmodes.study.tasks import BYTES, LEAST, Pace


def drawn(seed=0, formula="2*x"):
    plan = {"type": "monte_carlo", "runs": 40, "seed": seed}
    return study(quantities={"y": {"expression": formula}}, plan=plan, block=10)


def stopped(asked, folder, blocks=2):
    """Run a study until it has stored so many blocks."""
    left = [blocks]

    def interrupt(stage, share):
        if stage == "cases" and share:
            left[0] -= 1
            if left[0] < 0:
                raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_study(asked, folder, threads=1, progress=interrupt)


@pytest.mark.parametrize("other", [{"seed": 1}, {"formula": "3*x"}])
def test_a_table_of_the_cases_before_is_not_that_of_those_now(other, tmp_path):
    """The study was changed, run again and interrupted: its old table is still there, of as many cases."""
    run_study(drawn(), tmp_path)
    stopped(drawn(**other), tmp_path)
    assert (tmp_path / TABLE).exists()
    found = load_study(tmp_path)
    shown = found.shown_rows
    assert not found.complete
    assert len(shown) < len(found.design.values)
    assert shown.quantities["y"] == pytest.approx(
        float(other.get("formula", "2*x")[0]) * found.design.values[shown.case, 0]
    )
    done = tmodes("figures", tmp_path, "--out", tmp_path / "figures")
    assert f"these are {len(shown)} of 40 cases" in done.stderr


def test_a_damaged_table_is_read_from_the_blocks(tmp_path):
    whole = run_study(drawn(), tmp_path).rows.quantities["y"]
    file = tmp_path / TABLE
    content = file.read_bytes()
    assert load_study(tmp_path).shown_rows.quantities["y"].tolist() == whole.tolist()
    for place in np.linspace(0, len(content) - 1, 25).astype(int).tolist():
        broken = bytearray(content)
        broken[place] ^= 1 << place % 8
        file.write_bytes(broken)
        assert load_study(tmp_path).shown_rows.quantities["y"].tolist() == whole.tolist()
    file.unlink()
    assert load_study(tmp_path).shown_rows.quantities["y"].tolist() == whole.tolist()


def test_a_table_that_cannot_be_read_is_an_error_of_the_file(tmp_path):
    run_study(drawn(), tmp_path)
    file = tmp_path / TABLE
    file.write_bytes(file.read_bytes()[:-20])
    with pytest.raises(ResultFileError, match=r"no table .*run the study again"):
        TableColumns(file).numbers("y")


@pytest.mark.parametrize("name", [TABLE, PAGE, MOTIONS])
def test_no_link_in_the_folder_is_followed(name, tmp_path):
    """What it names is not written, and not removed by --overwrite."""
    target = tmp_path / "mine"
    target.mkdir() if name == MOTIONS else target.write_text("mine")
    mine = target / "case_000000.nc" if name == MOTIONS else target
    mine.write_text("mine")
    folder = tmp_path / "study"
    run_study(fake(data(20)), folder)
    (folder / name).unlink(missing_ok=True)
    (folder / name).symlink_to(target)
    for overwrite in (False, True):
        with pytest.raises(ResultFileError, match="got a link"):
            run_study(fake(data(20)), folder, overwrite=overwrite)
    assert mine.read_text() == "mine"


@pytest.mark.parametrize("name", [TABLE, PAGE])
def test_a_file_of_something_else_is_not_replaced(name, tmp_path):
    (tmp_path / name).write_text("mine")
    with pytest.raises(ResultFileError, match=f"there is no {STUDY_FILE}; name another folder"):
        run_study(fake(data(20)), tmp_path)
    assert (tmp_path / name).read_text() == "mine"
    assert run_study(fake(data(20)), tmp_path, overwrite=True).complete


def test_motions_that_no_disk_has_room_for_are_refused_with_their_size(tmp_path):
    """R15: before anything runs."""
    plan = {"type": "monte_carlo", "runs": 2_000_000}
    settings = {"integration.duration": 100.0, "integration.output_step": 0.001}
    asked = short({"peak": {"series": "tip.speed", "reduce": "max"}}, plan=plan, keep={"every": 1}, set=settings)
    with pytest.raises(ResultFileError, match=r"at least [\d,]{18,} bytes"):
        run_study(asked, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_what_is_stored_needs_no_more_room(tmp_path):
    """A study that is complete wants room for its table alone."""
    asked = fake(data(40_000))
    found = run_study(asked, tmp_path).stored
    assert found.room() < 0.8 * type(found).of(tmp_path / "new", asked, found.values).room()


def test_blocks_with_motions_are_bounded_in_memory():
    """From the first one, by what is known before; then by what they had."""
    assert Pace(heavy=BYTES // 10).size(1000) == 10
    assert Pace(heavy=10 * BYTES).size(1000) == 1
    pace = Pace()
    assert pace.size(10**6) == LEAST
    pace.took(LEAST, 0.01, 0.01, heavy=BYTES // 100)
    assert pace.size(10**6) == 100
