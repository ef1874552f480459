"""How the browser learns the studio's address: from a page that others cannot read, never from its command line."""

from __future__ import annotations

import html
import json
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote, urlsplit

import pytest

from command import started
from patience import LONG, until
from tmodes.studio.folders import door

ADDRESS = "http://127.0.0.1:4242/?token=a-b_c&x=1"


@pytest.fixture
def session(tmp_path, monkeypatch) -> Path:
    """A folder of the user's session."""
    (folder := tmp_path / "session").mkdir()
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(folder))
    return folder


def test_a_page_that_leads_there_and_goes(session):
    with door(ADDRESS) as page:
        assert page is not None
        assert page.is_relative_to(session)
        text = page.read_text(encoding="utf-8")
        assert html.unescape(re.findall(r'content="0;url=([^"]*)"', text)[0]) == ADDRESS
        assert "<script" not in text
    assert list(session.iterdir()) == []


@pytest.mark.skipif(os.name == "nt", reason="modes of files are those of POSIX")
def test_nobody_else_may_read_it(session):
    before = os.umask(0)  # the most careless one
    try:
        with door(ADDRESS) as page:
            assert page is not None
            assert page.stat().st_mode & 0o777 == 0o600
            assert page.parent.stat().st_mode & 0o777 == 0o700
    finally:
        os.umask(before)


def test_without_a_session_it_is_in_the_cache(tmp_path, monkeypatch):
    for absent in ("", "relative", str(tmp_path / "none")):
        monkeypatch.setenv("XDG_RUNTIME_DIR", absent)
        monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
        with door(ADDRESS) as page:
            assert page is not None
            assert page.is_relative_to(tmp_path / "cache")


def test_where_nothing_can_be_written(session, monkeypatch):
    def full(*given: object, **more: object) -> str:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("tempfile.mkdtemp", full)
    with door(ADDRESS) as page:
        assert page is None


@pytest.mark.skipif(os.name == "nt", reason="names a program of its own as the browser, and sends SIGTERM")
def test_the_browsers_command_line_holds_no_token(session, tmp_path):
    """The command with a browser that notes what it was called with; at its end nothing of it is left."""
    browser = tmp_path / "browser"
    noted = tmp_path / "noted.json"
    browser.write_text(f"#!{sys.executable}\nimport json, sys\njson.dump(sys.argv, open({str(noted)!r} + 'x', 'w'))\n"
                       f"import os\nos.rename({str(noted)!r} + 'x', {str(noted)!r})\n", encoding="utf-8")  # fmt: skip
    browser.chmod(0o700)
    command = [sys.executable, "-m", "tmodes.cli.entry", "studio", "--folder", str(tmp_path)]
    with started(command, stdout=subprocess.PIPE, env=os.environ | {"BROWSER": str(browser)}) as run:
        assert run.stdout is not None
        address = run.stdout.readline().split()[1]
        until(noted.exists)
        called = json.loads(noted.read_text(encoding="utf-8"))[1]
        page = Path(unquote(urlsplit(called).path))
        assert html.escape(address) in page.read_text(encoding="utf-8")
        assert address.partition("token=")[2] not in called
        run.send_signal(signal.SIGTERM)
        assert run.wait(LONG) == 0
    assert list(session.iterdir()) == []
