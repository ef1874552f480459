"""A studio's page in a real browser: one tab, and everything that went wrong in it."""

from __future__ import annotations

import re
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from browsing import OPTIONS, never_idle
from command import started
from patience import LONG, WAIT
from tmodes.report import pack

__all__ = ["Tab", "address", "browser", "drag", "opened", "tab"]

BUILT = Path(pack.__file__).parent / "web" / "studio.js"


@pytest.fixture(scope="package")
def address(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A studio as its command starts it, which must end by itself when it is asked to."""
    folder = tmp_path_factory.mktemp("studies")
    command = [
        sys.executable,
        "-m",
        "tmodes.cli.entry",
        "studio",
        "filipovic2010",
        "--no-open",
        "--folder",
        str(folder),
    ]
    with started(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE) as running:
        assert running.stdout is not None
        yield running.stdout.readline().split()[1]
        running.send_signal(signal.SIGTERM)
        running.wait(LONG)
        assert running.returncode == 0


@pytest.fixture(scope="module")
def browser(chromium: str) -> Iterator[Any]:
    sync_api = pytest.importorskip("playwright.sync_api", reason="needs the package playwright")
    if not BUILT.exists():
        pytest.skip("needs the built page: python tools/web.py")
    with sync_api.sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=chromium, args=list(OPTIONS))
        yield found
        found.close()


class Tab:
    """One tab, and everything that went wrong in it."""

    def __init__(self, page: Any) -> None:
        self.page, self.wrong = page, []
        page.set_default_timeout(WAIT)
        page.on("pageerror", lambda error: self.wrong.append(str(error)))
        page.on("console", self._hear)
        page.on("dialog", lambda dialog: (self.wrong.append(dialog.message), dialog.dismiss()))
        page.on("request", lambda one: self._look(one.url))

    def _hear(self, info: Any) -> None:
        if info.type == "error" and "status of 4" not in info.text:  # wrong input, which the page explains itself
            self.wrong.append(info.text)

    def _look(self, url: str) -> None:
        if not url.startswith(("http://127.0.0.1", "data:", "blob:")) and not url.endswith("/open.html"):
            self.wrong.append(url)

    def line(self) -> str:
        return self.page.inner_text(".line")

    def info(self, start: str) -> None:
        """Wait until the line of the studio says something that starts so."""
        self.page.locator(".line", has_text=re.compile(f"^{start}")).wait_for()

    def fresh(self, act: Any) -> str:
        """Do something and wait for new curves; what is reported of them."""
        self.page.evaluate("document.querySelector('.line').textContent = ''")
        act()
        self.info("New curves")
        return self.line()

    def fact(self, name: str) -> str:
        return self.page.inner_text(f"[data-fact='{name}'] strong")

    def type(self, label: str, value: str, *, inside: str = ".sheet") -> None:
        field = self.page.locator(inside).get_by_label(label).first
        field.fill(value)
        field.press("Enter")


def opened(browser: Any, address: str) -> Iterator[Tab]:
    page = browser.new_page(viewport={"width": 1280, "height": 800})
    never_idle(page)
    tab = Tab(page)
    page.goto(address)
    page.wait_for_selector(".chart canvas")
    yield tab
    page.close()
    assert tab.wrong == []


@pytest.fixture
def tab(browser: Any, address: str) -> Iterator[Tab]:
    yield from opened(browser, address)


def drag(tab: Tab, slider: str, share: float) -> None:
    tab.page.locator(f"[data-slider='{slider}'] input[type=range]").evaluate(
        "(range, value) => { range.value = value; range.dispatchEvent(new Event('input', { bubbles: true })); }",
        round(1000 * share),
    )
