"""``tmodes studio`` as a process: its address, its end, and what it says where it cannot start."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import httpx
import pytest

from command import started as program
from command import tmodes
from patience import LONG

COMMAND = [sys.executable, "-m", "tmodes.cli.entry", "studio", "--no-open"]


@contextmanager
def started(*arguments: object, **more) -> Iterator[subprocess.Popen[str]]:
    """A studio as a process, which ends with the test, whatever that finds."""
    with program([*COMMAND, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, **more) as running:
        try:
            yield running
        finally:
            running.terminate()


def test_only_this_machine_can_reach_it(tmp_path, monkeypatch):
    with started("--folder", tmp_path) as running:
        assert running.stdout is not None
        address = running.stdout.readline().split()[1]
        port = int(address.partition("/?")[0].rpartition(":")[2])
        assert address.startswith("http://127.0.0.1:")
        own = {one[4][0] for one in socket.getaddrinfo(socket.gethostname(), None, socket.AF_INET)} - {"127.0.0.1"}
        for other in own:
            with pytest.raises(OSError, match="refused"):
                socket.create_connection((str(other), port), timeout=LONG)
        assert "free port" in refused(monkeypatch, "--port", port)
        running.terminate()


def test_localhost_is_this_machine_and_the_reader_of_its_output_goes_away(tmp_path):
    """As with `| head -1`: it serves on, and says nothing of it."""
    with started("--folder", tmp_path, "--host", "localhost") as running:
        assert running.stdout is not None
        assert running.stderr is not None
        address = running.stdout.readline().split()[1]
        assert address.startswith("http://127.0.0.1:")
        running.stdout.close()
        assert httpx.get(address, trust_env=False).status_code == 200
        running.terminate()
        assert "Traceback" not in running.stderr.read()


def refused(monkeypatch, *arguments: object) -> str:
    """What is said instead of serving."""
    monkeypatch.setattr("uvicorn.Server.run", lambda *_, **__: pytest.fail("it serves"))
    return tmodes("studio", "--no-open", *arguments, code=2).stderr


def test_what_cannot_be_started(tmp_path, monkeypatch):
    def said(*arguments: object) -> str:
        return refused(monkeypatch, *arguments)

    assert "a folder that exists" in said("--folder", tmp_path / "none")
    assert "no_such_robot" in said("no_such_robot")
    assert "address of this machine" in said("--host", "nowhere.example")
    (tmp_path / "wrong.yaml").write_text("format: 1\n", encoding="utf-8")
    assert "wrong.yaml" in said(tmp_path / "wrong.yaml", "--folder", tmp_path)
    (tmp_path / "result.nc").write_bytes(b"")
    assert f"tmodes view {tmp_path / 'result.nc'}" in said(tmp_path / "result.nc")
    assert f"tmodes view {tmp_path}" in said(tmp_path)
    (tmp_path / "result.nc").unlink()
    assert f"--folder {tmp_path}" in said(tmp_path)
    (tmp_path / "my.yaml").write_text(tmodes("robots", "filipovic2010").stdout, encoding="utf-8")
    (tmp_path / "in").mkdir()
    assert "--folder" in said(tmp_path / "my.yaml", "--folder", tmp_path / "in")


def test_a_program_in_the_working_folder_is_not_run(tmp_path):
    """Workers start in the folder of the user: nothing of it may take the place of a module."""
    (tmp_path / "json.py").write_text("raise SystemExit('mine')", encoding="utf-8")
    (tmp_path / "tmodes.py").write_text("raise SystemExit('mine')", encoding="utf-8")
    command = [sys.executable, "-P", "-m", "tmodes.cli.entry", "studio", "--no-open"]
    with program(command, cwd=tmp_path, stdout=subprocess.PIPE) as running:
        assert running.stdout is not None
        address = running.stdout.readline().split()[1]
        with httpx.Client(trust_env=False, timeout=LONG) as client:
            client.get(address)
            base = address.partition("/?")[0]
            sheet = client.get(f"{base}/api/robots/filipovic2010").json()["sheet"]
            sheet["integration"] = {"duration": 0.1}
            job = client.post(f"{base}/api/jobs", json={"product": "data", "sheet": sheet, "client": "x"}).json()
            while job["state"] in ("waiting", "running"):
                job = client.get(f"{base}/api/jobs/{job['job']}?wait=1").json()
        assert job["state"] == "done", job
        running.terminate()
