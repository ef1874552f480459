"""A cluster under Slurm: jobs that are Dask workers, asked for through dask-jobqueue; the scheduler runs here."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Self

from tmodes.errors import InputError
from tmodes.io.words import meant
from tmodes.study.extra import needed
from tmodes.study.places.contract import PLACES, How, Job, Place
from tmodes.study.places.dask import security, work_through

__all__ = ["Slurm", "cluster_of"]

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

    def run(self, job: Job) -> None:
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
