"""The cache of compiled code: private, bounded, cheap to keep so, and open about itself."""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path

import pytest
from typer.testing import CliRunner

from tmodes.cli.main import app
from tmodes.compile import cache

TRIM = cache.trim


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    folder = tmp_path / "cache"
    monkeypatch.setenv("TMODES_CACHE", str(folder))
    return folder


def cli(*arguments: str) -> str:
    done = CliRunner().invoke(app, ["cache", *arguments], catch_exceptions=False)
    assert done.exit_code == 0
    return done.stdout


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs owners of files")
def test_folder_of_another_user_is_refused(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Code of somebody else is neither read nor written, and the reason is given."""
    cache.save("key", b"theirs")
    monkeypatch.setattr(os, "getuid", lambda: place.stat().st_uid + 1)
    assert cache.folder() is None
    assert cache.load("key") is None
    cache.save("other", b"ours")
    assert len(list(place.iterdir())) == 1
    assert "another user" in cli()


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs permissions of files")
def test_folder_that_we_make_is_private(place: Path) -> None:
    cache.save("key", b"code")
    assert place.stat().st_mode & 0o777 == 0o700


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs permissions of files")
@pytest.mark.parametrize("mode", [0o720, 0o702])
def test_folder_that_others_may_write_into_is_refused(place: Path, mode: int) -> None:
    cache.save("key", b"code")
    place.chmod(mode)
    assert cache.folder() is None
    assert cache.load("key") is None
    assert "chmod go-w" in cache.judged()[1]


def test_folder_that_cannot_be_made_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").touch()
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "file" / "cache"))
    assert cache.folder() is None
    cache.save("key", b"code")
    assert cache.load("key") is None
    assert "cannot be made" in cli()


def test_entry_of_another_layout_is_made_again(place: Path) -> None:
    """What an older version wrote, sealed in its own way, is no entry of ours."""
    cache.save("key", b"code")
    (entry,) = place.iterdir()
    sealed = hashlib.sha256(b"key\0code").hexdigest().encode()
    entry.write_bytes(sealed + b"code")
    assert cache.load("key") is None
    cache.save("key", b"code")
    assert cache.load("key") == b"code"


def test_files_of_others_are_never_touched(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A folder that holds other things too keeps them, when trimmed and when cleared."""
    place.mkdir(mode=0o700)
    others = {place / "main.o", place / "notes.txt", place / ("f" * 63 + ".o")}
    for file in others:
        file.write_bytes(bytes(9000))
    monkeypatch.setattr(cache, "MAX_BYTES", 5000)
    for number in range(12):
        cache.save(f"key {number}", bytes(1000))
    cli("clear")
    assert set(place.iterdir()) == others


def test_what_was_used_last_stays(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading an entry counts as use; sizes add up to the limit at most."""
    for number in range(8):
        cache.save(f"key {number}", bytes(1000))
        os.utime(cache._entry(f"key {number}"), (number, number))  # type: ignore[arg-type]
    assert cache.load("key 0") is not None
    assert cache.trim(place, 5000) <= 5000
    left = [number for number in range(8) if cache.load(f"key {number}") is not None]
    assert left in ([0, 6, 7], [0, 5, 6, 7])


def test_folder_is_not_listed_at_each_save(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Once by a process, then whenever it has written a sixteenth of the limit: the bound holds to that part."""
    listed, saves, size, limit = 0, 64, 10_000, 320_000

    def counting(place: Path, limit: int) -> int:
        nonlocal listed
        listed += 1
        return TRIM(place, limit)

    monkeypatch.setattr(cache, "trim", counting)
    monkeypatch.setattr(cache, "MAX_BYTES", limit)
    for number in range(saves):
        cache.save(f"key {number}", bytes(size))
        assert sum(entry.size for entry in cache.entries(place)) <= limit * 17 / 16 + 2 * size
    assert 1 < listed <= 1 + saves * (size + 200) * 16 / limit


def test_command_reports_folder_size_and_limit(place: Path) -> None:
    cache.save("one", bytes(1000))
    cache.save("two", bytes(2000))
    info = json.loads(cli("--json"))
    size = sum(file.stat().st_size for file in place.iterdir())
    assert info == {
        "folder": str(place), "used": True, "entries": 2, "bytes": size, "limit": cache.MAX_BYTES, "why_not": "",
    }  # fmt: skip
    shown = cli()
    for word in (str(place), "TMODES_CACHE", "tmodes cache clear", "2, 0.0 MB of at most 268 MB"):
        assert word in shown


def test_command_clears(place: Path) -> None:
    cache.save("one", bytes(1000))
    assert json.loads(cli("clear", "--json"))["removed"] == 1
    assert cache.load("one") is None
    assert "removed 0 entries" in cli("clear")


def test_command_without_a_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """An empty variable means none: shown as such, and nothing to clear."""
    monkeypatch.setenv("TMODES_CACHE", "")
    assert "TMODES_CACHE is empty" in cli()
    info = json.loads(cli("--json"))
    assert (info["folder"], info["used"]) == (None, False)
    done = CliRunner().invoke(app, ["cache", "clear"])
    assert "no cache is used" in str(done.exception)
    assert "name a folder of your own: TMODES_CACHE=FOLDER" in str(done.exception)
