"""A study on workers of Dask: real processes on loopback, killed and added while it runs; the trust boundary."""

from __future__ import annotations

import subprocess
from typing import Any

import pytest

from command import tmodes
from study.store.processes import cluster, command, ended, reached
from study.store.test_killed import sheet, table, whole  # noqa: F401 - fixtures
from tmodes.errors import InputError, SimulationError
from tmodes.study.places import How, place_of
from tmodes.study.places.dask import work_through

pytestmark = pytest.mark.nightly

pytest.importorskip("distributed")


def address(found) -> str:
    return "dask://" + found.address.partition("://")[2]


def test_workers_are_killed_and_added_and_the_table_is_the_same(sheet, whole, tmp_path):  # noqa: F811
    """Two workers; one is killed, started again and killed again, and another comes in the middle."""
    out = tmp_path / "study"
    with cluster(tmp_path, 2) as found:
        process = command("study", sheet, "--on", address(found), "--out", out, "--no-page")
        first = found.processes[1]
        reached(process, out, 30)
        first.kill()
        reached(process, out, 90)
        again = found.worker()
        reached(process, out, 150)
        found.worker()
        reached(process, out, 220)
        again.kill()
        code, _, errors = ended(process)
        assert code == 0, errors
    assert table(out) == whole


def certificates(folder):
    """An authority and a key that it has signed, for this machine."""
    key, ca, cert = (folder / name for name in ("key.pem", "ca.pem", "cert.pem"))
    line = ["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost"]
    subprocess.run([*line, "-keyout", key, "-out", ca], check=True, capture_output=True)
    cert.write_bytes(ca.read_bytes())
    return folder


def test_through_tls_a_scheduler_that_goes_ends_the_study_which_resumes(sheet, whole, tmp_path):  # noqa: F811
    """The first cases are computed by a worker that is reached through TLS alone."""
    try:
        keys = certificates(tmp_path)
    except OSError:
        pytest.skip("needs openssl to make certificates")
    options = "--tls-ca-file", "ca.pem", "--tls-cert", "cert.pem", "--tls-key", "key.pem"
    out = tmp_path / "study"
    with cluster(tmp_path, 1, *options) as found:
        where = "dask+tls://" + found.address.partition("://")[2]
        process = command("study", sheet, "--on", where, "--tls", keys, "--out", out, "--no-page")
        reached(process, out, 20)
        found.end()
        code, _, errors = ended(process)
    assert code == 3
    assert "connection to the scheduler is lost; the same command computes the rest" in errors
    tmodes("study", sheet, "--out", out, "--no-page")
    assert table(out) == whole


def test_other_machines_are_not_reached_without_certificates(tmp_path):
    with pytest.raises(InputError, match=r"TLS to other machines.*--insecure"):
        place_of("dask://192.0.2.1:8786", How())
    with pytest.raises(InputError, match=r"without ca\.pem"):
        place_of("dask://192.0.2.1:8786", How(tls=tmp_path))
    assert place_of("dask://192.0.2.1:8786", How(insecure=True)).address == "tcp://192.0.2.1:8786"  # pyright: ignore[reportAttributeAccessIssue]
    for loopback in ("127.0.0.1", "localhost", "[::1]"):
        assert place_of(f"dask://{loopback}:1", How()).address == f"tcp://{loopback}:1"  # pyright: ignore[reportAttributeAccessIssue]


NO_JOB: Any = None


class Refusing:
    """A client that has not heard yet that its scheduler is gone."""

    status = "running"

    def __init__(self, error: OSError) -> None:
        self.error = error

    def scheduler_info(self, n_workers: int) -> dict:
        raise self.error

    def cancel(self, futures: list, *, force: bool) -> None:
        raise self.error


@pytest.mark.parametrize("error", [ConnectionRefusedError(111, "refused"), OSError("Timed out trying to connect")])
def test_a_connection_that_the_client_still_believes_in_is_lost_all_the_same(error):
    with pytest.raises(SimulationError, match="connection to the scheduler is lost"):
        work_through(Refusing(error), NO_JOB)


def test_a_full_disk_is_no_lost_connection():
    with pytest.raises(OSError, match="No space"):
        work_through(Refusing(OSError(28, "No space left on device")), NO_JOB)
