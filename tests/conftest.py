"""What all tests share: no display, a cache of compiled code of their own, a browser when there is one."""

from __future__ import annotations

import gc
import os
import shutil
import subprocess
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import pytest
from hypothesis import settings

import tmodes
from tmodes.kinds.outside import USED

if TYPE_CHECKING:
    from tmodes.sheet import Robot

os.environ["MPLBACKEND"] = "Agg"
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # as the command does; read when NumPy is loaded, by all workers

settings.register_profile("tmodes", deadline=None, derandomize=True, print_blob=True)
settings.load_profile("tmodes")


NIGHTLY = "TMODES_NIGHTLY"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """What is marked ``nightly`` runs where asked for: the suite of each change must end in a quarter of an hour.

    ``nightly("lqr", "pid")``: of the cases of a test alone those whose names have one of these in them.
    """
    if not os.environ.get(NIGHTLY):
        left_out = pytest.mark.skip(reason=f"nightly: runs with {NIGHTLY}=1")
        for item in items:
            marks = item.iter_markers("nightly")
            if any(not mark.args or any(part in item.name.partition("[")[2] for part in mark.args) for mark in marks):
                item.add_marker(left_out)


def pytest_collection_finish() -> None:
    """What was collected stays to the end: the garbage collector need not look at it again and again."""
    gc.collect()
    gc.freeze()


@pytest.hookimpl(optionalhook=True)
def pytest_xdist_make_scheduler(config: pytest.Config, log: Any) -> Any:
    """All tests of a file go to one worker, so that what they share is made once: runs, compiled robots, browsers."""
    from xdist.scheduler import LoadFileScheduling

    return LoadFileScheduling(config, log) if config.getoption("dist") == "load" else None


@pytest.fixture(scope="session", autouse=True)
def private_cache(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Compiled code goes to a folder of this session, also from programs that tests start; all workers share it."""
    own = tmp_path_factory.getbasetemp()
    place = (own.parent if "PYTEST_XDIST_WORKER" in os.environ else own) / "compiled"
    place.mkdir(mode=0o700, exist_ok=True)
    os.environ["TMODES_CACHE"] = str(place)


@pytest.fixture(scope="session")
def robot() -> Robot:
    """The robot of the 2010 paper as shipped."""
    return tmodes.load("filipovic2010")


@pytest.fixture(autouse=True)
def kinds_of_this_test() -> Iterator[None]:
    """What a test loads on request is not handed to the workers of a later one's studio."""
    before = [*USED]
    yield
    USED[:] = before


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
