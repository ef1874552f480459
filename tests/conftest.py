"""What all tests share: no display, a cache of compiled code of their own, a browser when there is one."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest
from hypothesis import settings

os.environ["MPLBACKEND"] = "Agg"

settings.register_profile("tmodes", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("tmodes")


@pytest.fixture(scope="session", autouse=True)
def private_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compiled code goes to a folder of this session, also from programs that tests start."""
    os.environ["TMODES_CACHE"] = str(tmp_path_factory.mktemp("compiled"))


TO_PORT = Path(__file__).with_name("to_port.txt")
"""Files and folders of tests that were not seen to pass as a whole since the two programs became one."""


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Tests of the list may fail until they are ported; a file of which all pass is to be taken from it."""
    known = tuple(TO_PORT.read_text(encoding="utf-8").splitlines()) if TO_PORT.exists() else ()
    for item in items:
        if known and item.nodeid.startswith(known):
            item.add_marker(
                pytest.mark.xfail(reason="to be ported to the one architecture", strict=False), append=False
            )


BROWSERS = ("chromium", "chromium-browser", "google-chrome")


@pytest.fixture(scope="session")
def chromium() -> str:
    """Path of a browser; the test is skipped where there is none."""
    found = next(filter(None, map(shutil.which, BROWSERS)), None)
    if found is None:
        pytest.skip(f"needs a browser to look at the page: none of {', '.join(BROWSERS)} is installed")
    return found


@pytest.fixture(scope="session")
def working_gcc() -> None:
    """The test is skipped where there is no gcc that compiles: some machines have only its name."""
    text = "int main(void) { return 0; }"
    command = ["gcc", "-x", "c", "-o", os.devnull, "-"]
    tried = shutil.which("gcc") and subprocess.run(command, input=text, text=True, capture_output=True, check=False)
    if not tried or tried.returncode:
        pytest.skip("needs a gcc that works")
