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
    assert len(list(place.glob("*.o"))) == 1
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


def planted(place: Path, content: bytes = b"", name: str = "key") -> Path:
    """An entry as the last version wrote it, sealed with nothing that is not public."""
    content = content or cache._HEAD + hashlib.sha256(b"key\0evil").hexdigest().encode() + b"evil"
    entry = cache._entry(place, name)
    entry.write_bytes(content)
    entry.chmod(0o600)
    return entry


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs permissions of files")
def test_what_others_could_leave_is_not_trusted_when_the_folder_is_closed_again(place: Path) -> None:
    """Neither a seal that anybody can compute, nor what was sealed before others could write."""
    place.mkdir(mode=0o700)
    planted(place)
    assert cache.load("key") is None
    cache.save("other", b"ours")
    assert cache.load("other") == b"ours"
    place.chmod(0o777)
    assert cache.folder() is None
    place.chmod(0o755)
    assert cache.folder() == place
    assert cache.load("other") is None
    cache.save("other", b"ours")
    assert cache.load("other") == b"ours"


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs links and permissions of files")
@pytest.mark.parametrize("kind", ["symbolic link", "hard link", "pipe", "folder", "open to others", "too large"])
def test_an_entry_that_is_not_the_users_own_file_is_not_read(
    place: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, kind: str
) -> None:
    """Its content would be right; it is made again, and what a link names is left alone."""
    cache.save("key", b"code")
    entry = cache._entry(place, "key")
    content, elsewhere = entry.read_bytes(), tmp_path / "elsewhere"
    elsewhere.write_bytes(content)
    elsewhere.chmod(0o600)
    if kind == "open to others":
        entry.chmod(0o620)
    elif kind == "too large":
        monkeypatch.setattr(cache, "_MAX_ENTRY", 3)
    else:
        entry.unlink()
        make = {"symbolic link": lambda: entry.symlink_to(elsewhere), "hard link": lambda: entry.hardlink_to(elsewhere),
                "pipe": lambda: os.mkfifo(entry, 0o600), "folder": entry.mkdir}  # fmt: skip
        make[kind]()
    assert cache.load("key") is None
    cache.save("key", b"code")
    assert (cache.load("key") == b"code") == (kind not in ("folder", "too large"))
    assert elsewhere.read_bytes() == content


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs permissions of files")
@pytest.mark.parametrize("damage", ["open to others", "short", "link"])
def test_a_secret_that_others_may_know_is_replaced(place: Path, tmp_path: Path, damage: str) -> None:
    cache.save("key", b"code")
    secret = place / "secret"
    before = secret.read_bytes()
    assert (len(before), secret.stat().st_mode & 0o777) == (32, 0o600)
    if damage == "open to others":
        secret.chmod(0o644)
    elif damage == "short":
        secret.write_bytes(b"short")
    else:
        (tmp_path / "known").write_bytes(before)
        secret.unlink()
        secret.symlink_to(tmp_path / "known")
    os.utime(secret, (1, 1), follow_symlinks=False)
    assert cache.load("key") is None
    cache.save("key", b"code")
    assert cache.load("key") == b"code"
    assert secret.read_bytes() != before
    assert not secret.is_symlink()


@pytest.mark.skipif(not hasattr(os, "getuid"), reason="needs permissions of files")
@pytest.mark.parametrize(("mode", "used"), [(0o755, True), (0o1777, True), (0o777, False), (0o775, False)])
def test_folders_on_the_way_are_judged_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, mode: int, used: bool
) -> None:
    """Who may write into a folder above may put another folder there, unless that folder is sticky."""
    above = tmp_path / "above"
    (above / "between").mkdir(parents=True)
    above.chmod(mode)
    monkeypatch.setenv("TMODES_CACHE", str(above / "between" / "cache"))
    assert (cache.folder() is not None) == used
    assert used or f"it is in {above}, into which others may write" in cli()
    link = tmp_path / "link"
    link.symlink_to(above / "between")
    monkeypatch.setenv("TMODES_CACHE", str(link / "cache"))
    assert (cache.folder() is not None) == used


@pytest.mark.skipif(os.name == "nt", reason="needs the XDG folders")
def test_relative_folders_are_ignored(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As the XDG base directory specification says; the next rule decides."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "own"))
    monkeypatch.setenv("TMODES_CACHE", "here")
    assert cache.folder() == tmp_path / "own" / "tmodes"
    monkeypatch.setenv("XDG_CACHE_HOME", "there")
    monkeypatch.setenv("HOME", str(tmp_path / "home"))
    assert cache.folder() == tmp_path / "home" / ".cache" / "tmodes"
    monkeypatch.setenv("HOME", "somewhere")
    place = cache.judged()[0]
    assert place is None or place.is_absolute()
    assert {entry.name for entry in tmp_path.iterdir()} == {"own", "home"}


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
    (entry,) = place.glob("*.o")
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
    assert set(place.iterdir()) == others | {place / "secret"}


def test_what_was_used_last_stays(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Reading an entry counts as use; sizes add up to the limit at most."""
    for number in range(8):
        cache.save(f"key {number}", bytes(1000))
        os.utime(cache._entry(place, f"key {number}"), (number, number))
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
    size = sum(file.stat().st_size for file in place.glob("*.o"))
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
