"""The table opens where people look at tables, with its units, streams when it is long, and holds every case."""

from __future__ import annotations

import numpy as np
import pyarrow.parquet as pq
import pytest

from study.store.fake import data, fake
from tmodes.study import table
from tmodes.study.runner import run_study

COLUMNS = ["case", "gear", "payload", "peak", "bad", "status", "reason", "method", "seconds", "errors"]


@pytest.fixture
def result(tmp_path):
    return run_study(fake(data(500, ("peak", "bad"), block=64)), tmp_path)


def test_pandas_polars_and_duckdb_read_it(result):
    bad = int((result.design.values[:, 0] > 0.9).sum())
    sums = result.rows.quantities["peak"].sum()
    pandas = pytest.importorskip("pandas")
    frame = pandas.read_parquet(result.parquet)
    assert list(frame.columns) == COLUMNS
    assert (frame["peak"].sum(), frame["bad"].isna().sum()) == (pytest.approx(sums), bad)
    polars = pytest.importorskip("polars")
    frame = polars.read_parquet(result.parquet)
    assert (frame["peak"].sum(), frame["bad"].null_count()) == (pytest.approx(sums), bad)
    duckdb = pytest.importorskip("duckdb")
    found = duckdb.read_parquet(str(result.parquet)).aggregate("sum(peak), count(*) - count(bad)").fetchall()[0]
    assert found == (pytest.approx(sums), bad)


def test_units_and_origin_are_in_the_metadata(result):
    schema = pq.read_schema(result.parquet)
    assert schema.field("peak").metadata == {b"unit": b"m", b"title": b"a number", b"role": b"quantity"}
    assert schema.field("gear").metadata == {b"unit": b"-", b"path": b"x", b"role": b"parameter"}
    assert schema.metadata[b"tmodes.study"] == b"fake"
    assert b"tmodes.engine" in schema.metadata


def test_it_is_written_some_rows_at_a_time(tmp_path, monkeypatch):
    """Never more than a group of rows and one block at once, whatever the number of cases."""
    monkeypatch.setattr(table, "ROW_GROUP", 200)
    seen = []
    whole = table.table_of
    monkeypatch.setattr(
        table, "table_of", lambda study, rows, *more: seen.append(len(rows)) or whole(study, rows, *more)
    )
    result = run_study(fake(data(1000, block=64)), tmp_path)
    assert max(seen) < 200 + 64
    assert sum(seen) == 1000
    assert pq.ParquetFile(result.parquet).num_row_groups == len(seen)
    assert pq.read_table(result.parquet)["case"].to_pylist() == list(range(1000))


def test_motions_open_as_netcdf(tmp_path):
    xarray = pytest.importorskip("xarray")
    run_study(fake(data(100, block=50, keep={"every": 40})), tmp_path)
    files = sorted((tmp_path / "trajectories").iterdir())
    assert [file.name for file in files] == ["case_000000.nc", "case_000040.nc", "case_000080.nc"]
    with xarray.open_dataset(files[1], engine="h5netcdf") as motion:
        assert motion.attrs["case"] == 40
        assert np.all(motion["states"].values == 40.0)
        assert motion["time"].attrs["units"] == "s"


def test_a_damaged_motion_is_an_error_to_its_reader_and_written_again(tmp_path):
    """One bit in the numbers; a study that is run again reads them."""
    xarray = pytest.importorskip("xarray")
    study = fake(data(100, block=50, keep={"every": 40}))
    run_study(study, tmp_path)
    file = tmp_path / "trajectories" / "case_000040.nc"
    whole = file.read_bytes()
    place = whole.index(np.full(4, 40.0).tobytes())
    file.write_bytes(whole[:place] + bytes([whole[place] ^ 1]) + whole[place + 1 :])
    with xarray.open_dataset(file, engine="h5netcdf") as motion, pytest.raises(OSError, match="filter"):
        motion["states"].load()
    untouched = tmp_path / "trajectories" / "case_000080.nc"
    before = untouched.stat().st_mtime_ns
    run_study(study, tmp_path)
    with xarray.open_dataset(file, engine="h5netcdf") as motion:
        assert np.all(motion["states"].values == 40.0)
    assert untouched.stat().st_mtime_ns == before
