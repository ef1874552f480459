"""A studio to talk to over a real connection: its application with workers of its own, and its working folder."""

from __future__ import annotations

import copy
import socket
import threading
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import httpx
import pytest
import uvicorn

from patience import LONG, until
from studio.tabs import address, browser, tab
from tmodes import load
from tmodes.studio.folders import WorkingFolder
from tmodes.studio.serve import configured
from tmodes.studio.server import application
from tmodes.studio.sheets import plain_sheet

__all__ = ["address", "browser", "tab"]

TOKEN = "of-tests"  # noqa: S105


@dataclass
class Studio:
    """A browser tab, so to speak."""

    client: httpx.Client
    folder: Path
    host: str

    @property
    def cookie(self) -> str:
        return f"tmodes-studio-{self.host.rpartition(':')[2]}"

    def get(self, address: str, code: int = 200, **more: Any) -> Any:
        return self._info(self.client.get(address, **more), code)

    def post(self, address: str, code: int = 200, **more: Any) -> Any:
        return self._info(self.client.post(address, **more), code)

    def put(self, address: str, code: int = 200, **more: Any) -> Any:
        return self._info(self.client.put(address, **more), code)

    @staticmethod
    def _info(answer: Any, code: int) -> Any:
        assert answer.status_code == code, answer.text
        return answer.json()

    def begin(self, sheet: Any, product: str = "data", client: str = "tab") -> str:
        return self.post("/api/jobs", json={"product": product, "sheet": sheet, "client": client})["job"]

    def looked(self, job: str, *states: str) -> Any:
        """The job once it is in one of the states."""
        return until(lambda: (info := self.get(f"/api/jobs/{job}?wait=1"))["state"] in states and info, f"{states}")

    def ended(self, job: str) -> Any:
        return self.looked(job, "done", "error", "cancelled")


@pytest.fixture(scope="session")
def studio(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Studio]:
    folder = tmp_path_factory.mktemp("working folder ü")
    with socket.socket() as listening:
        listening.bind(("127.0.0.1", 0))
        host = f"127.0.0.1:{listening.getsockname()[1]}"
        app = application(WorkingFolder(folder), TOKEN, frozenset({host}), tmp_path_factory.mktemp("own"), workers=2)
        server = uvicorn.Server(configured(app))
        serving = threading.Thread(target=server.run, kwargs={"sockets": [listening]})
        serving.start()
        with httpx.Client(base_url=f"http://{host}", timeout=LONG, trust_env=False) as client:
            until(lambda: server.started)
            assert client.get(f"/?token={TOKEN}").status_code == 200
            yield Studio(client, folder, host)
        server.should_exit = True
        serving.join(LONG)
        assert not serving.is_alive()


PLAIN = plain_sheet(load("filipovic2010"))


def payload(sheet: dict[str, Any]) -> dict[str, Any]:
    """The body at the tip of that robot."""
    return sheet["links"][0]["bodies"][0]


@pytest.fixture
def sheet() -> dict[str, Any]:
    """The plain data of the robot of the 2010 paper, to be changed."""
    return copy.deepcopy(PLAIN)


@pytest.fixture
def long_sheet() -> dict[str, Any]:
    """A run of minutes."""
    sheet = copy.deepcopy(PLAIN)
    sheet["integration"] |= {"duration": 30000.0, "output_step": 1.0, "relative_tolerance": 1e-12}
    sheet["drives"][0]["signal"]["duration"] = 30000.0
    return sheet
