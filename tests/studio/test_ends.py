"""Nothing of a studio stays when it ends, however it ends: no upload, no page with its token, no process, no file."""

from __future__ import annotations

import asyncio
import os
import signal
import socket
import subprocess
import sys
import threading
from collections.abc import Coroutine, Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest

import tmodes
from command import started
from patience import LONG, until
from studio.test_looks import ELASTICITY, URDF, sent, stl
from tmodes.errors import InputError
from tmodes.kinds.outside import USED
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.studio.folders import make_within, own_folder
from tmodes.studio.looks import MOST_KEPT, Shelf
from tmodes.studio.pool import Pool

pytestmark = [pytest.mark.skipif(os.name == "nt", reason="sends the signals of POSIX"), pytest.mark.nightly]

FILES: dict[str, bytes | str] = {
    "arm.stl": stl(0.25),
    "two.urdf": URDF.format(mesh="arm.stl"),
    "two.yaml": ELASTICITY.format(urdf="two.urdf"),
}


@dataclass
class Running:
    """A studio as a process, and where it may leave something."""

    process: subprocess.Popen[str]
    client: httpx.Client
    places: tuple[Path, Path]

    def post(self, address: str, code: int = 200, **more):
        answer = self.client.post(address, **more)
        assert answer.status_code == code, answer.text
        return answer.json()

    def left(self) -> list[Path]:
        return [path for place in self.places for path in place.iterdir()]

    def _hears_no_more(self) -> bool:
        try:
            socket.create_connection((self.client.base_url.host, self.client.base_url.port or 0)).close()
        except OSError:
            return True
        return False

    def end(self, *numbers: int) -> str:
        """Send signals; what was said on the standard error."""
        for number in numbers:
            self.process.send_signal(number)
            until(self._hears_no_more)
        said = self.process.communicate(timeout=LONG)[1]
        assert "Traceback" not in said
        assert "Unknown child" not in said
        return said


@contextmanager
def running(tmp_path: Path) -> Iterator[Running]:
    """A studio that opened a browser, with temporary folders of its own."""
    places = tmp_path / "temporary", tmp_path / "session"
    for place in places:
        place.mkdir(exist_ok=True)
    (browser := tmp_path / "browser").write_text("#!/bin/sh\nexit 0\n", encoding="utf-8")
    browser.chmod(0o700)
    more = {"TMPDIR": str(places[0]), "XDG_RUNTIME_DIR": str(places[1]), "BROWSER": str(browser)}
    command = [sys.executable, "-m", "tmodes.cli.entry", "studio", "--folder", str(tmp_path)]
    with started(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=os.environ | more) as process:
        try:
            assert process.stdout is not None
            base, _, token = process.stdout.readline().split()[1].partition("/?token=")
            headers = {"X-Tmodes-Token": token}
            with httpx.Client(base_url=base, headers=headers, timeout=LONG, trust_env=False) as client:
                yield Running(process, client, places)
        finally:
            process.kill()


def begin(studio: Running, sheet, product: str = "curves") -> str:
    return studio.post("/api/jobs", json={"product": product, "sheet": sheet, "client": "ends"})["job"]


@pytest.mark.parametrize(
    "numbers", [(signal.SIGHUP,), (signal.SIGTERM,), (signal.SIGINT,), (signal.SIGINT, signal.SIGINT)],
    ids=["terminal closed", "SIGTERM", "Ctrl-C", "Ctrl-C twice"],
)  # fmt: skip
def test_nothing_is_left(tmp_path, long_sheet, numbers):
    """While a run is in progress, and a page waits for it."""
    with running(tmp_path) as studio, ThreadPoolExecutor(1) as tab:
        sent(studio, FILES)
        job = begin(studio, long_sheet)
        until(lambda: studio.client.get(f"/api/jobs/{job}").json()["state"] == "running")
        tab.submit(studio.client.get, f"/api/jobs/{job}?wait=5")
        assert studio.left()
        assert "stopped" in studio.end(*numbers)
        assert studio.process.returncode == 0
        assert studio.left() == []


def test_what_a_killed_studio_left_goes_when_the_next_one_starts(tmp_path):
    with running(tmp_path) as studio:
        sent(studio, FILES)
        studio.process.kill()
        studio.process.wait()
        before = studio.left()
        assert len(before) == 2  # the uploads, and the page with the token
    with running(tmp_path) as studio:
        assert not any(path.exists() for path in before)
        studio.end(signal.SIGTERM)


def test_folders_of_those_who_live_stay(tmp_path):
    with own_folder(tmp_path) as first, own_folder(tmp_path) as second:
        assert first.is_dir()
        assert second.stat().st_mode & 0o077 == 0
        (dead := tmp_path / first.name.replace(f"-{os.getpid()}-", "-999999999-")).mkdir()
        (other := tmp_path / "tmodes-studio-of-another-place").mkdir()
        with own_folder(tmp_path):
            assert not dead.exists()
            assert other.is_dir()
    assert list(tmp_path.iterdir()) == [other]


def test_what_is_still_read_at_the_end_is_not_written_again(tmp_path):
    with own_folder(tmp_path) as place:
        room = Shelf(place).room()
    with pytest.raises(FileNotFoundError):
        make_within(room, room / "upload" / "meshes")
    with pytest.raises(InputError, match="fit in the temporary folder"):
        Shelf(place).room()
    assert list(tmp_path.iterdir()) == []


def test_uploads_of_many_threads_at_once(tmp_path):
    shelf, barrier = Shelf(tmp_path), threading.Barrier(4)

    def upload(_: int) -> None:
        barrier.wait()
        for _ in range(20):
            shelf.keep(room := shelf.room(), room / "two.urdf", (room,))

    with ThreadPoolExecutor(4) as threads:
        list(threads.map(upload, range(4)))
    assert len(list(tmp_path.iterdir())) == MOST_KEPT


def run(program: Coroutine[Any, Any, None]) -> None:
    asyncio.run(asyncio.wait_for(program, 60))


def test_a_worker_that_died_idle_does_no_job_and_what_it_wrote_goes(tmp_path, sheet):
    order = {"product": "curves", "sheet": sheet | {"integration": {"duration": 0.1}}, "looks": None}

    async def program() -> None:
        pool = Pool(2, tmp_path)
        await pool.start()
        rooms = list(tmp_path.iterdir())
        assert len(rooms) == 2
        for room, worker in zip(rooms, pool._all, strict=True):
            (room / "half written").touch()
            os.kill(worker.process.pid, signal.SIGKILL)
            await worker.process.wait()
        for _ in rooms:
            assert (await pool.run(order, "tab", lambda *_: None, asyncio.Event()))[0]["kind"] == "done"
        await pool.stop()
        assert list(tmp_path.iterdir()) == []

    run(program())


def test_where_no_worker_can_be_started_the_next_job_tries_again(tmp_path, monkeypatch):
    order = {"product": "curves", "sheet": {}, "looks": None}

    async def program() -> None:
        pool = Pool(1, tmp_path)
        await pool.start()
        [worker] = pool._all
        os.kill(worker.process.pid, signal.SIGKILL)
        await worker.process.wait()
        monkeypatch.setattr("tmodes.studio.pool.COMMAND", ("/none",))
        for _ in range(2):
            with pytest.raises(FileNotFoundError):
                await pool.run(order, "tab", lambda *_: None, asyncio.Event())
        monkeypatch.undo()
        assert (await pool.run(order, "tab", lambda *_: None, asyncio.Event()))[0]["kind"] == "error"
        await pool.stop()

    run(program())


KINDS = '''
from typing import Literal
import numpy as np
from tmodes.kinds.signals.registry import SIGNALS, Signal
from tmodes.kinds.signals.schedule import SignalPieces

@SIGNALS.register
class Ramp(Signal):
    """Rises by 1/s."""
    type: Literal["studio_ramp"]
    def pieces(self, until):
        return SignalPieces(np.array([0.0, until]), np.array([[0.0, 1.0]]))
'''


def test_workers_know_the_kinds_that_were_asked_for(tmp_path):
    """A file that the server's process has loaded is loaded by its workers."""
    file, place = tmp_path / "studio_ramps.py", tmp_path / "place"
    file.write_text(KINDS, encoding="utf-8")
    place.mkdir()
    joint = {
        "name": "j",
        "type": "revolute",
        "child": "l",
        "axis": [0, 0, 1],
        "motor": {"inertia": 0.5, "side": "joint"},
    }
    drive = {"joint": "j", "command": "torque", "signal": {"type": "studio_ramp"}}
    moved = {"format": 1, "kind": "arm", "name": "ramp", "joints": [joint], "links": [{"name": "l"}],
             "drives": [drive], "integration": {"duration": 0.1}}  # fmt: skip
    order = {"product": "curves", "sheet": moved, "looks": None}

    async def program() -> None:
        pool = Pool(1, place)
        await pool.start()
        head, _ = await pool.run(order, "tab", lambda *_: None, asyncio.Event())
        await pool.stop()
        assert head["kind"] == "done", head

    try:
        tmodes.use(str(file))
        run(program())
    finally:
        SIGNALS.unregister("studio_ramp")
        USED.remove(str(file.resolve()))
        sys.modules.pop("studio_ramps", None)
