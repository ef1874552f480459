"""Workers on other machines, through Dask distributed: ``dask://HOST:PORT``, ``dask+tls://HOST:PORT``.

Trust: a scheduler and its workers unpickle what they receive, so that whoever may connect to them may run any code
there, and they may send anything to us. Therefore other machines are reached through TLS with certificates of both
sides, unless ``--insecure`` is given. What we send is plain data and the name of one function of tmodes; what comes
back is bytes, which are verified as a file of anybody's.
"""

from __future__ import annotations

import ipaddress
import shutil
from asyncio import CancelledError
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from tmodes.errors import InputError, SimulationError, TmodesError
from tmodes.io.words import meant
from tmodes.study.extra import needed
from tmodes.study.places.contract import PLACES, How, Place, PlaceJob, Task
from tmodes.study.tasks import compute_block

__all__ = ["Dask", "Slurm", "cluster_of", "security", "work_through"]

CERTIFICATES = ("ca.pem", "cert.pem", "key.pem")
LOST = 20
"""How often a block may be lost with its worker before the study ends: then it is the block that ends workers."""

CONNECT = "30s"

GLANCE = 0.5
"""Seconds after which progress is reported, and Ctrl-C heard."""


@PLACES.register
@dataclass(frozen=True)
class Dask(Place):
    """A scheduler that runs already. The unit of work is a block; a worker that is lost costs the blocks it had."""

    address: str
    security: Any = field(default=None, repr=False)

    name = "dask"
    also = ("dask+tls", "tcp", "tls")

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """The scheduler at HOST:PORT: off loopback with TLS, or refused."""
        needed("distributed", "cluster")
        host, _, port = address.rpartition(":")
        if not (host and port.isdecimal() and 0 < int(port) < 65536):
            hint = "write --on dask://HOST:PORT, as the scheduler prints it"
            raise InputError("--on", f"dask://{address}"[:80], "dask://HOST:PORT", hint)
        if (how.insecure or _loopback(host)) and how.tls is None:
            return cls(f"tcp://{address}")
        return cls(f"tls://{address}", security(how.tls))

    def refuse(self) -> None:
        """A scheduler that does not answer."""
        self._connected().close()

    def run(self, job: PlaceJob) -> None:
        """Connect, and have all blocks computed."""
        from dask import config

        config.set({"distributed.admin.large-graph-warning-threshold": "1GB"})
        with self._connected() as client:
            work_through(client, job)

    def _connected(self) -> Any:
        from distributed import Client

        try:
            return Client(self.address, security=self.security, timeout=CONNECT)
        except (OSError, TimeoutError) as error:
            hint = "start it with `dask scheduler`, and check address and certificates"
            raise InputError("--on", f"no answer of {self.address}", "a scheduler that runs", hint) from error


def _loopback(host: str) -> bool:
    """Whether a host is this machine, reached by nobody else."""
    try:
        return host == "localhost" or ipaddress.ip_address(host.strip("[]")).is_loopback
    except ValueError:
        return False


def security(folder: Path | None) -> Any:
    """Certificates of a folder, else those of Dask's own configuration; InputError where there are none."""
    from distributed.security import Security

    if folder is not None:
        files = [folder / name for name in CERTIFICATES]
        if absent := [file.name for file in files if not file.is_file()]:
            raise InputError("--tls", f"a folder without {absent[0]}", f"a folder with {', '.join(CERTIFICATES)}", "")
        ca, cert, key = map(str, files)
        return Security(tls_ca_file=ca, tls_client_cert=cert, tls_client_key=key, require_encryption=True)
    found = Security(require_encryption=True)
    if not (found.tls_ca_file and found.tls_client_cert):
        hint = "give --tls FOLDER with ca.pem, cert.pem and key.pem, or --insecure in a network that you trust"
        raise InputError("--on", "another machine without certificates", "TLS to other machines", hint)
    return found


def work_through(client: Any, job: PlaceJob) -> None:
    """Keep every worker busy with two blocks, and take back what is done; a block that was lost is given out again."""
    pending: dict[Any, Task] = {}
    try:
        _work(client, job, pending)
    except TmodesError:
        raise
    except (Exception, CancelledError) as error:
        if client.status == "running" and not _of_connection(error):
            raise
        lost = "the connection to the scheduler is lost; the same command computes the rest"
        raise SimulationError(lost) from error
    finally:
        if client.status == "running":
            with suppress(OSError, RuntimeError):
                client.cancel(list(pending), force=True)


def _of_connection(error: BaseException) -> bool:
    """Whether an error is that of a connection, of which the client itself may hear later; Dask's have no number."""
    return isinstance(error, (ConnectionError, TimeoutError)) or (isinstance(error, OSError) and error.errno is None)


def _work(client: Any, job: PlaceJob, pending: dict[Any, Task]) -> None:
    from distributed import wait

    lost: dict[int, int] = {}
    while True:
        workers = max(1, len(client.scheduler_info(n_workers=-1)["workers"]))
        while len(pending) < 2 * workers and (task := job.next(workers)):
            pending[client.submit(compute_block, job.order(task, job.threads), pure=False)] = task
        if not pending:
            return
        with suppress(TimeoutError):
            wait(list(pending), timeout=GLANCE, return_when="FIRST_COMPLETED")
        job.report()
        if client.status != "running":
            raise ConnectionError
        for future in [each for each in pending if each.status != "pending"]:
            _take(future, pending.pop(future), job, lost)


def _take(future: Any, task: Task, job: PlaceJob, lost: dict[int, int]) -> None:
    """Store the block of a future, or put its task back where its worker was lost."""
    if future.status == "finished":
        job.done(task, future.result())
        return
    error = future.exception() if future.status == "error" else None
    if error is not None and type(error).__name__ != "KilledWorker":
        if type(error).__module__ == TmodesError.__module__:
            raise error
        raise SimulationError(f"a worker failed at the cases from {task.first} on: {type(error).__name__}: {error}")
    lost[task.first] = lost.get(task.first, 0) + 1
    if lost[task.first] > LOST:
        raise SimulationError(f"the block of the cases from {task.first} on has ended {LOST} workers")
    job.again(task)


RESOURCES: Mapping[str, Callable[[str], Any]] = {
    "jobs": int, "cores": int, "memory": str, "processes": int, "queue": str, "account": str, "walltime": str,
    "interface": str, "local_directory": str, "log_directory": str, "shared_temp_directory": str,
}  # fmt: skip
"""What --resource may set, by the names of dask-jobqueue; ``jobs``: how many Slurm jobs at most."""

JOBS, CORES, MEMORY = 4, 4, "8GB"


@PLACES.register
@dataclass(frozen=True)
class Slurm(Place):
    """Started from a machine that may submit jobs (``sbatch``)."""

    how: How

    name = "slurm"

    @classmethod
    def at(cls, address: str, how: How) -> Self:
        """Refused where dask-jobqueue or Slurm is not installed, or a resource has no meaning."""
        if address:
            hint = "write --on slurm, and --resource queue=NAME for a queue"
            raise InputError("--on", f"slurm://{address}"[:80], "slurm without an address", hint)
        needed("dask_jobqueue", "cluster")
        resources_of(how)
        if shutil.which("sbatch") is None:
            hint = "run it on a machine of the cluster that submits jobs, or use --on dask://HOST:PORT"
            raise InputError("--on slurm", "a machine without Slurm (no sbatch)", "one that submits jobs", hint)
        return cls(how)

    def run(self, job: PlaceJob) -> None:
        """Ask for the jobs, and have the blocks computed as they start; all end with the study."""
        from distributed import Client

        with cluster_of(self.how) as cluster:
            cluster.adapt(minimum_jobs=1, maximum_jobs=resources_of(self.how).get("jobs", JOBS))
            with Client(cluster) as client:
                work_through(client, job)


def resources_of(how: How) -> dict[str, Any]:
    """What the queue is asked for, as numbers and words; raises InputError for a name or a number that is none."""
    found: dict[str, Any] = {}
    for name, text in how.resources.items():
        if name not in RESOURCES:
            hint = meant(name, RESOURCES, f"the names are {', '.join(RESOURCES)}")
            raise InputError("--resource", f"the unknown name {name!r}", "a name of dask-jobqueue", hint)
        try:
            found[name] = RESOURCES[name](text)
        except ValueError as error:
            raise InputError(f"--resource {name}", repr(text), "a whole number", "write --resource cores=8") from error
    return found


def cluster_of(how: How) -> Any:
    """The cluster of dask-jobqueue, which has started nothing but a scheduler; with TLS unless that is not wanted.

    Certificates are those of ``how.tls``, else temporary ones (library cryptography), which the jobs find in
    ``shared_temp_directory``.
    """
    asked = {"cores": CORES, "memory": MEMORY, "processes": 1} | resources_of(how)
    asked.pop("jobs", None)
    if how.tls is not None:
        asked["security"] = security(how.tls)
    elif not how.insecure:
        needed("cryptography", "cluster")
        asked["security"] = True
    cluster = needed("dask_jobqueue.slurm", "cluster").SLURMCluster
    return cluster(**asked, scheduler_options={"dashboard_address": ":0"})  # whatever else has the usual port
