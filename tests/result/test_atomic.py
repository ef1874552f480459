"""Files whole or absent, one writer per folder, trouble reported before a run."""

from __future__ import annotations

import errno
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from patience import LONG
from tmodes.errors import ResultFileError
from tmodes.io import atomic
from tmodes.io.atomic import LOCK_NAME, FolderLock, atomic_write, check_writable

POSIX = pytest.mark.skipif(sys.platform == "win32", reason="needs fork and signals")
TESTS = Path(__file__).parents[1]


def python(code: str, *arguments: object, timeout: float = LONG) -> subprocess.CompletedProcess[str]:
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path])}
    command = [sys.executable, "-W", "error", "-c", code, *map(str, arguments)]
    return subprocess.run(command, env=environment, capture_output=True, text=True, timeout=timeout, check=False)


def test_the_new_file_replaces_the_old_one(tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_text("old")
    with atomic_write(path) as temporary:
        temporary.write_text("new")
        assert path.read_text() == "old"
        assert temporary.parent == tmp_path
    assert path.read_text() == "new"
    assert list(tmp_path.iterdir()) == [path]


def half_written(path: Path, error: BaseException) -> None:
    with atomic_write(path) as temporary:
        temporary.write_text("half")
        raise error


@pytest.mark.parametrize("kind", [RuntimeError, KeyboardInterrupt, SystemExit])
def test_a_failure_leaves_the_old_file(kind: type[BaseException], tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_text("old")
    with pytest.raises(kind):
        half_written(path, kind())
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_a_disk_that_fills_while_writing_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "x"
    path.write_text("old")
    with pytest.raises(ResultFileError, match=r"No space left.*untouched"):
        half_written(path, OSError(errno.ENOSPC, os.strerror(errno.ENOSPC)))
    assert path.read_text() == "old"
    assert list(tmp_path.iterdir()) == [path]


def test_without_overwrite_a_file_made_meanwhile_is_kept(tmp_path: Path) -> None:
    path = tmp_path / "x"
    writer = atomic_write(path, overwrite=False)
    writer.__enter__().write_text("mine")
    path.write_text("theirs")
    with pytest.raises(ResultFileError, match="exists"):
        writer.__exit__(None, None, None)
    assert path.read_text() == "theirs"
    assert list(tmp_path.iterdir()) == [path]


def test_a_link_is_followed(tmp_path: Path) -> None:
    (tmp_path / "real").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "real" / "x")
    with atomic_write(tmp_path / "link") as temporary:
        temporary.write_text("new")
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real" / "x").read_text() == "new"


def test_the_usual_permissions_are_kept(tmp_path: Path) -> None:
    with atomic_write(tmp_path / "x") as temporary:
        temporary.write_text("new")
    (tmp_path / "y").write_text("plain")
    assert (tmp_path / "x").stat().st_mode == (tmp_path / "y").stat().st_mode


def test_an_error_of_another_kind_is_not_called_trouble_with_the_file(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="of another kind"):
        half_written(tmp_path / "x", ValueError("of another kind"))


def test_a_file_system_without_hard_links(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError(errno.EPERM, os.strerror(errno.EPERM))

    monkeypatch.setattr(Path, "hardlink_to", refuse)
    for path in (tmp_path / "x", tmp_path / "y"):
        with atomic_write(path, overwrite=False) as temporary:
            temporary.write_text("new")
        assert path.read_text() == "new"
    writer = atomic_write(tmp_path / "x", overwrite=False)
    writer.__enter__().write_text("newer")
    with pytest.raises(ResultFileError, match="exists"):
        writer.__exit__(None, None, None)
    assert (tmp_path / "x").read_text() == "new"
    with FolderLock(tmp_path), pytest.raises(ResultFileError, match="held by process"), FolderLock(tmp_path):
        pass


def test_places_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "folder").mkdir()
    places = [tmp_path / "file" / "x", tmp_path / "no" / "x", tmp_path / ("x" * 300), tmp_path / "folder", "a\0b"]
    for place in places:
        with pytest.raises(ResultFileError, match=r"expected|must be"), atomic_write(place) as temporary:
            temporary.write_text("x")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "folder"]


KILLED = """
import itertools, os, signal, sys
from pathlib import Path
from result.synthetic import synthetic_result
from tmodes.io import atomic, resultfile
from tmodes.result import Result
path = Path(sys.argv[1])
results = [synthetic_result(samples=100 + 50 * k) for k in (0, 1)]
for result in results:
    result.data.attrs["message"] = f"{result.data.sizes['time']} samples"
bodies = {result.data.sizes["time"]: bytes(resultfile._body(result.record)) for result in results}
resultfile._body = lambda data: memoryview(bodies[data.sizes["time"]])  # so that nearly all the time goes into writing
results[0].save(path)


def save_both(hook):
    # Calls and returns of what writes the file are heard.
    sys.setprofile(lambda frame, *_: frame.f_code.co_filename == atomic.__file__ and hook())
    for result in reversed(results):
        result.save(path, overwrite=True)
    sys.setprofile(None)


heard, orphans = [], 0
save_both(lambda: heard.append(1))
for last in range(0, len(heard), len(heard) // 12):
    if (child := os.fork()) == 0:
        calls = itertools.count()
        save_both(lambda: next(calls) == last and os.kill(os.getpid(), signal.SIGKILL))
    assert os.WIFSIGNALED(os.waitpid(child, 0)[1])
    back = Result.load(path)
    which = results[back.data.sizes["time"] != 100]
    assert back.data.identical(which.data), back
    orphans = len(list(path.parent.glob(".tmodes-*.tmp")))
assert orphans > 0, "no kill came while a file was being written: the test showed nothing"
print(orphans)
"""


@POSIX
def test_killed_while_it_saves_the_file_is_always_whole(tmp_path: Path) -> None:
    done = python(KILLED, tmp_path / "run.nc")
    assert done.returncode == 0, done.stderr
    assert len(list(tmp_path.glob(".tmodes-*.tmp"))) == int(done.stdout)
    with FolderLock(tmp_path):
        assert sorted(path.name for path in tmp_path.iterdir()) == [LOCK_NAME, "run.nc"], "orphans are cleared"


def test_the_second_writer_is_refused_and_touches_nothing(tmp_path: Path) -> None:
    (tmp_path / "result").write_text("first")
    second = "import sys; from tmodes.io.atomic import FolderLock\nwith FolderLock(sys.argv[1]): print('in')"
    with FolderLock(tmp_path) as lock:
        before = {path: path.read_bytes() for path in tmp_path.iterdir()}
        refused = python(second, tmp_path)
        assert refused.stdout == ""
        assert f"held by process {os.getpid()}" in refused.stderr
        assert str(lock.path) in refused.stderr
        assert {path: path.read_bytes() for path in tmp_path.iterdir()} == before
        with pytest.raises(ResultFileError, match="held by process"), FolderLock(tmp_path):
            pass
    assert not lock.path.exists()
    assert python(second, tmp_path).stdout == "in\n"


def left_lock(folder: Path, **changes: object) -> None:
    holder = atomic._Holder.here()._asdict() | changes
    (folder / LOCK_NAME).write_text(json.dumps(holder))


def dead_pid() -> int:
    child = subprocess.Popen([sys.executable, "-c", ""])
    child.wait()
    return child.pid


def test_the_lock_of_a_dead_process_is_taken_over(tmp_path: Path) -> None:
    left_lock(tmp_path, pid=dead_pid())
    with FolderLock(tmp_path) as lock:
        assert json.loads(lock.path.read_text())["pid"] == os.getpid()
    assert list(tmp_path.iterdir()) == []


@POSIX
def test_the_lock_of_a_killed_process_is_taken_over(tmp_path: Path) -> None:
    hold = (
        "import os, sys; from tmodes.io.atomic import FolderLock\nwith FolderLock(sys.argv[1]): os.kill(os.getpid(), 9)"
    )
    assert python(hold, tmp_path).returncode == -9
    assert (tmp_path / LOCK_NAME).exists()
    with FolderLock(tmp_path):
        pass


@pytest.mark.skipif(not Path("/proc/self/stat").exists(), reason="the system does not tell when a process started")
def test_a_reused_process_number_does_not_hold_a_lock(tmp_path: Path) -> None:
    left_lock(tmp_path, started="1")
    with FolderLock(tmp_path):
        pass


def test_a_process_whose_start_is_not_reported_holds_its_lock(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As on macOS, or where the administrator hides the processes of others."""
    left_lock(tmp_path)
    monkeypatch.setattr(atomic, "process_state", lambda _: (True, ""))
    with pytest.raises(ResultFileError, match="held by process"), FolderLock(tmp_path):
        pass


@pytest.mark.parametrize("changes", [{"place": "another computer or container"}, {"more": "of a later version"}])
def test_a_lock_that_cannot_be_judged_holds(changes: dict[str, str], tmp_path: Path) -> None:
    left_lock(tmp_path, pid=dead_pid(), **changes)
    os.utime(tmp_path / LOCK_NAME, (0, 0))
    with pytest.raises(ResultFileError, match=r"(held by process|another version).*delete"), FolderLock(tmp_path):
        pass


def test_a_lock_that_was_taken_again_while_it_was_judged_is_kept(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its holder was read alive, released it and ended before it was looked for; meanwhile another took it."""
    left_lock(tmp_path, since="the first")

    def taken_again(_: object) -> bool:
        left_lock(tmp_path, since="the second")
        return True

    monkeypatch.setattr(atomic._Holder, "gone", taken_again)
    with pytest.raises(ResultFileError, match="another is just taking"), FolderLock(tmp_path):
        pass
    assert "the second" in (tmp_path / LOCK_NAME).read_text()
    assert len(list(tmp_path.iterdir())) == 1


def test_a_lock_without_content_holds_only_while_it_is_young(tmp_path: Path) -> None:
    (tmp_path / LOCK_NAME).write_text("")
    with pytest.raises(ResultFileError, match="just being taken"), FolderLock(tmp_path):
        pass
    os.utime(tmp_path / LOCK_NAME, (0, 0))
    with FolderLock(tmp_path):
        pass


def test_a_take_over_that_was_itself_killed_is_reported(tmp_path: Path) -> None:
    left_lock(tmp_path, pid=dead_pid())
    (tmp_path / f"{LOCK_NAME}.bury").touch()
    with pytest.raises(ResultFileError, match=r"just taking.*delete .*\.tmodes\.lock\*"), FolderLock(tmp_path):
        pass


def test_a_lock_that_another_took_over_is_not_removed(tmp_path: Path) -> None:
    with FolderLock(tmp_path):
        left_lock(tmp_path, place="another computer")
    assert (tmp_path / LOCK_NAME).exists()


RACE = """
import os, sys
from pathlib import Path
from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock
folder, stale = Path(sys.argv[1]), Path(sys.argv[2]).read_text()
wins = 0
for _ in range(60):
    (folder / ".tmodes.lock").write_text(stale)
    children = []
    for _ in range(3):
        child = os.fork()
        if child == 0:
            try:
                with FolderLock(folder):
                    os.close(os.open(folder / "inside", os.O_CREAT | os.O_EXCL))
                    [os.sched_yield() for _ in range(1000)]
                    (folder / "inside").unlink()
                os._exit(0)
            except ResultFileError:
                os._exit(1)
            except BaseException:
                os._exit(2)
        children.append(child)
    codes = [os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) for child in children]
    assert 2 not in codes, "two were inside at once"
    assert 0 in codes, "nobody got in"
    wins += codes.count(0)
print(wins)
"""


@POSIX
def test_of_many_that_find_a_stale_lock_one_gets_in_at_a_time(tmp_path: Path) -> None:
    left_lock(tmp_path, pid=dead_pid())
    stale = tmp_path / "stale"
    (tmp_path / LOCK_NAME).rename(stale)
    (tmp_path / "folder").mkdir()
    done = python(RACE, tmp_path / "folder", stale)
    assert done.returncode == 0, done.stderr


def test_a_lock_in_a_place_that_cannot_be_written(tmp_path: Path) -> None:
    with pytest.raises(ResultFileError, match="No such file"), FolderLock(tmp_path / "missing"):
        pass


def test_a_good_folder_is_made_and_left_clean(tmp_path: Path) -> None:
    check_writable(tmp_path / "new" / "deep", 1000)
    assert list((tmp_path / "new" / "deep").iterdir()) == []


def test_a_folder_that_is_a_file(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("keep")
    for place in (tmp_path / "file", tmp_path / "file" / "below"):
        with pytest.raises(ResultFileError, match="which is a file"):
            check_writable(place, 1)
    assert (tmp_path / "file").read_text() == "keep"


def test_a_name_too_long(tmp_path: Path) -> None:
    with pytest.raises(ResultFileError, match="too long"):
        check_writable(tmp_path / ("x" * 300), 1)


def test_a_disk_too_small(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("shutil.disk_usage", lambda _: type("Usage", (), {"free": 10**6})())
    with pytest.raises(ResultFileError, match=r"at least 5,000,000 bytes, got a disk with 1,000,000 bytes free"):
        check_writable(tmp_path / "new", 5_000_000)
    assert not (tmp_path / "new").exists()


@POSIX
def test_a_read_only_folder(tmp_path: Path) -> None:
    folder = tmp_path / "read only"
    folder.mkdir(mode=0o555)
    if os.access(folder, os.W_OK):
        folder = Path("/proc/self")  # the administrator may write anywhere else
        if not folder.exists():
            pytest.skip("this user may write everywhere")
    with pytest.raises(ResultFileError, match="when writing"):
        check_writable(folder, 0)
    with pytest.raises(ResultFileError, match="when writing"), atomic_write(folder / "x"):
        pass
    with pytest.raises(ResultFileError, match="when writing"), FolderLock(folder):
        pass
