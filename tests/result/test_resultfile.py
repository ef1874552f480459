"""The sealed file: whole and the same on the way back, readable by others, and not believed when a bit is wrong."""

from __future__ import annotations

import os
import struct
import subprocess
import sys
import zlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray as xr

from result.synthetic import synthetic_result
from tmodes.errors import ResultFileError
from tmodes.io import resultfile
from tmodes.io.resultfile import SEAL_BYTES, read_sealed, write_sealed

TESTS = Path(__file__).parents[1]
SAVE = "import sys; from result.synthetic import synthetic_result; synthetic_result(samples=301).save(sys.argv[1])"


@pytest.fixture(scope="module")
def data() -> xr.Dataset:
    return synthetic_result(samples=301).data


@pytest.fixture(scope="module")
def good(data: xr.Dataset, tmp_path_factory: pytest.TempPathFactory) -> bytes:
    path = tmp_path_factory.mktemp("good") / "run.nc"
    write_sealed(data, path)
    return path.read_bytes()


def test_it_comes_back_whole(data: xr.Dataset, good: bytes, tmp_path: Path) -> None:
    path = tmp_path / "run.nc"
    path.write_bytes(good)
    back = read_sealed(path)
    assert back.identical(data)
    assert list(back.variables) == list(data.variables)
    assert {name: variable.dtype for name, variable in back.variables.items()} == {
        name: variable.dtype for name, variable in data.variables.items()
    }
    assert back.attrs == data.attrs
    assert [type(value) for value in back.attrs.values()] == [type(value) for value in data.attrs.values()]


def test_it_is_in_memory_and_the_file_is_free(data: xr.Dataset, tmp_path: Path) -> None:
    path = tmp_path / "run.nc"
    write_sealed(data, path)
    back = read_sealed(path)
    path.unlink()
    assert float(back["tip"].sum()) == float(data["tip"].sum())


def test_words_and_kinds_of_numbers_come_back(tmp_path: Path) -> None:
    odd = xr.Dataset(
        {
            "text": ("n", np.array(["é", "", "∑ x"])),
            "small": ("n", np.array([0, 1, 65535], dtype=np.uint16)),
            "single": ("n", np.array([0.1, -0.0, 1e30], dtype=np.float32)),
            "scalar": ((), 2.5),
        },
        attrs={"long": "ü" * 100_000, "empty": "", "lines": "a\nb\tc", "whole": -(2**62), "number": 0.1},
    )
    write_sealed(odd, tmp_path / "odd.nc")
    back = read_sealed(tmp_path / "odd.nc")
    assert back.identical(odd)
    assert back.attrs == odd.attrs
    assert all(back[name].dtype == odd[name].dtype for name in odd.variables)
    assert np.signbit(back["single"].values[1])


@pytest.mark.parametrize("engine", ["h5netcdf", "netcdf4"])
def test_xarray_reads_it(engine: str, data: xr.Dataset, good: bytes, tmp_path: Path) -> None:
    pytest.importorskip("netCDF4" if engine == "netcdf4" else "h5netcdf")
    path = tmp_path / "run.nc"
    path.write_bytes(good)
    with xr.open_dataset(path, engine=engine) as there:
        np.testing.assert_array_equal(there["moment"].values, data["moment"].values)
        assert list(there["axis"].values) == ["x", "y", "z"]


def test_h5py_and_netcdf4_read_it(data: xr.Dataset, good: bytes, tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    path = tmp_path / "run.nc"
    path.write_bytes(good)
    with h5py.File(path) as file:
        np.testing.assert_array_equal(file["tip"][:], data["tip"].values)
        assert file.attrs["status"] == "finished"
    netCDF4 = pytest.importorskip("netCDF4")
    with netCDF4.Dataset(path) as file:
        np.testing.assert_array_equal(file["tip"][:], data["tip"].values)
        assert file["tip"].units == "m"


@pytest.mark.nightly
def test_the_same_bytes_in_other_surroundings(good: bytes, tmp_path: Path) -> None:
    surroundings = (
        {"PYTHONHASHSEED": "1", "TZ": "Asia/Kathmandu", "LC_ALL": "C", "OPENBLAS_NUM_THREADS": "1"},
        {"PYTHONHASHSEED": "4242", "TZ": "America/St_Johns", "LC_ALL": "C.UTF-8", "OPENBLAS_NUM_THREADS": "2"},
    )
    for number, more in enumerate(surroundings):
        folder = tmp_path / f"ein Ordner {number} – 結果"
        folder.mkdir()
        environment = os.environ | more | {"PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path])}
        path = folder / "run.nc"
        subprocess.run([sys.executable, "-c", SAVE, str(path)], env=environment, cwd=folder, check=True)
        assert path.read_bytes() == good


def test_the_same_bytes_after_a_round_trip(good: bytes, tmp_path: Path) -> None:
    (tmp_path / "one.nc").write_bytes(good)
    write_sealed(read_sealed(tmp_path / "one.nc"), tmp_path / "two.nc")
    assert (tmp_path / "two.nc").read_bytes() == good


def test_the_same_bytes_from_a_dataset_that_others_read(good: bytes, tmp_path: Path) -> None:
    """How a dataset was stored before is no part of it."""
    (tmp_path / "one.nc").write_bytes(good)
    data = read_sealed(tmp_path / "one.nc")
    for variable in data.variables.values():
        variable.encoding = {"complevel": 9, "zlib": True} | ({"dtype": "f4"} if variable.dtype.kind == "f" else {})
    data.encoding = {"unlimited_dims": {"time"}}
    write_sealed(data, tmp_path / "two.nc")
    assert (tmp_path / "two.nc").read_bytes() == good


def test_every_flipped_bit_is_refused(good: bytes, tmp_path: Path) -> None:
    path = tmp_path / "flipped.nc"
    random = np.random.default_rng(20)
    places = [*random.integers(0, 8 * len(good), 200), *range(8 * (len(good) - SEAL_BYTES), 8 * len(good))]
    for place in map(int, places):
        bad = bytearray(good)
        bad[place // 8] ^= 1 << place % 8
        path.write_bytes(bad)
        with pytest.raises(ResultFileError, match=r"seal|damaged"):
            read_sealed(path)


def test_every_cut_is_refused(good: bytes, tmp_path: Path) -> None:
    path = tmp_path / "cut.nc"
    lengths = {*range(130), *range(len(good) - 130, len(good)), *range(0, len(good), len(good) // 50)}
    for length in sorted(lengths):
        path.write_bytes(good[:length])
        with pytest.raises(ResultFileError, match="empty" if length == 0 else "without the seal"):
            read_sealed(path)


def resealed(body: bytes, version: int = resultfile.FORMAT_VERSION, length: int | None = None) -> bytes:
    """A body under a seal that matches its own checksum."""
    start = bytearray(resultfile._seal(memoryview(body))[: resultfile.SEAL.size])
    struct.pack_into("<I", start, 8, version)
    struct.pack_into("<Q", start, 16, len(body) if length is None else length)
    return bytes(body) + bytes(start) + struct.pack("<I", zlib.crc32(start))


def foreign_hdf5(path: Path) -> None:
    import h5py

    with h5py.File(path, "w") as file:
        file["x"] = np.arange(100.0)


BAD: dict[str, tuple[Callable[[bytes], bytes], str]] = {
    "lengthened at the end": (lambda good: good + b"\0" * 8, "cut short, lengthened, or foreign"),
    "lengthened inside": (lambda good: good[:-SEAL_BYTES] + b"\0" + good[-SEAL_BYTES:], "as its seal says"),
    "shortened inside": (lambda good: good[: -SEAL_BYTES - 1] + good[-SEAL_BYTES:], "as its seal says"),
    "only a seal": (lambda good: good[-SEAL_BYTES:], "without the seal"),
    "a length of 2^63": (lambda good: resealed(good[:-SEAL_BYTES], length=2**63), "as its seal says"),
    "newer": (lambda good: resealed(good[:-SEAL_BYTES], version=2), "format version 2.*or newer"),
    "version zero": (lambda good: resealed(good[:-SEAL_BYTES], version=0), "format version 0"),
    "text": (lambda good: b"time,tip\n" * 50, "foreign"),
    "no netCDF below a good seal": (lambda good: resealed(b"rubbish" * 100), "cannot be decoded"),
    "half a netCDF below a good seal": (lambda good: resealed(good[: len(good) // 2]), "cannot be decoded"),
}


@pytest.mark.parametrize("case", BAD)
def test_what_is_no_result_is_refused_with_the_reason(case: str, good: bytes, tmp_path: Path) -> None:
    make, reason = BAD[case]
    path = tmp_path / "bad.nc"
    path.write_bytes(make(good))
    with pytest.raises(ResultFileError, match=reason) as caught:
        read_sealed(path)
    assert all(word in str(caught.value) for word in ("bad.nc", "got", "must be"))


def test_a_foreign_hdf5_file_is_refused(tmp_path: Path) -> None:
    foreign_hdf5(tmp_path / "foreign.h5")
    with pytest.raises(ResultFileError, match="without the seal"):
        read_sealed(tmp_path / "foreign.h5")


def test_places_that_are_no_file_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ResultFileError, match="No such file"):
        read_sealed(tmp_path / "missing.nc")
    with pytest.raises(ResultFileError, match="a directory"):
        read_sealed(tmp_path)
    with pytest.raises(ResultFileError, match="too long"):
        read_sealed(tmp_path / ("x" * 5000))
    with pytest.raises(ResultFileError, match="null"):
        read_sealed(f"{tmp_path}/a\0b")
    if sys.platform != "win32":
        os.mkfifo(tmp_path / "pipe")
        with pytest.raises(ResultFileError, match="pipe or socket"):
            read_sealed(tmp_path / "pipe")


def test_a_huge_file_is_refused_unread(tmp_path: Path) -> None:
    with (tmp_path / "huge.nc").open("wb") as file:
        file.truncate(2**40)
    with pytest.raises(ResultFileError, match="1,099,511,627,776 bytes"):
        read_sealed(tmp_path / "huge.nc")


def sealed_hdf5(path: Path, fill: Callable[[Any], object]) -> Path:
    """A made-up file under a good seal."""
    import h5py

    with h5py.File(path, "w") as file:
        fill(file)
    path.write_bytes(resealed(path.read_bytes()))
    return path


def test_a_small_file_that_unpacks_to_a_huge_one_is_refused(tmp_path: Path) -> None:
    path = sealed_hdf5(tmp_path / "bomb.nc", lambda f: f.create_dataset("x", (10**7, 10**5), "f8", chunks=(100, 100)))
    assert path.stat().st_size < 10_000
    with pytest.raises(ResultFileError, match="8,000,000,000,000 bytes when unpacked"):
        read_sealed(path)


def test_a_file_that_leads_to_other_files_is_refused(tmp_path: Path) -> None:
    h5py = pytest.importorskip("h5py")
    secret = tmp_path / "secret"
    secret.write_bytes(b"secret! " * 8)
    foreign_hdf5(tmp_path / "other.h5")
    layout = h5py.VirtualLayout((100,), "f8")
    layout[:] = h5py.VirtualSource(str(tmp_path / "other.h5"), "x", (100,))
    external = [(str(secret), 0, 64)]
    made_up: list[Callable[[Any], object]] = [
        lambda f: f.create_dataset("x", (8,), "f8", external=external),
        lambda f: f.__setitem__("x", h5py.ExternalLink(str(tmp_path / "other.h5"), "x")),
        lambda f: f.__setitem__("x", h5py.SoftLink("/y")),
        lambda f: f.create_virtual_dataset("x", layout),
        lambda f: f.create_group("x"),
    ]
    for number, fill in enumerate(made_up):
        with pytest.raises(ResultFileError, match="no plain variable"):
            read_sealed(sealed_hdf5(tmp_path / f"leads{number}.nc", fill))


@pytest.mark.parametrize(
    ("change", "named"),
    [
        ({"x": ("n", np.array([{}, None], dtype=object))}, "variable x"),
        ({"x": ("n", np.array([1j, 2]))}, "variable x"),
        ({"x": ("n", np.array(["2020-01-01"], dtype="M8[ns]"))}, "variable x"),
        ({"x": ("n", np.zeros(0))}, "variable x"),
        ({"x": ("n", np.zeros(2), {"list": [1, 2]})}, "attribute list of variable x"),
        ({"x": ("n", np.zeros(2), {"flag": True})}, "attribute flag of variable x"),
        ({"x": ("n", np.zeros(2), {"cut": "a\0b"})}, "attribute cut of variable x"),
        ({"x": ("n", np.zeros(2), {"half": "\ud800"})}, "attribute half of variable x"),
    ],
)
def test_what_would_not_come_back_is_not_written(change: dict[str, Any], named: str, tmp_path: Path) -> None:
    with pytest.raises(ResultFileError, match=named):
        write_sealed(xr.Dataset(change), tmp_path / "x.nc")
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_is_reported_in_bytes(data: xr.Dataset, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "run.nc"
    path.write_bytes(b"old")
    monkeypatch.setattr("shutil.disk_usage", lambda _: type("Usage", (), {"free": 1234})())
    with pytest.raises(ResultFileError, match=r"at least [\d,]+ bytes, got a disk with 1,234 bytes free"):
        write_sealed(data, path)
    assert path.read_bytes() == b"old"
