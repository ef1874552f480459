"""Slurm: the script of a job as it would be submitted; without Slurm a sentence."""

from __future__ import annotations

import pytest

from tmodes.errors import InputError
from tmodes.study.places import How, place_of

pytest.importorskip("dask_jobqueue")


def test_without_slurm_it_says_so(monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(InputError, match=r"no sbatch.*submits jobs"):
        place_of("slurm", How())


@pytest.mark.parametrize(
    ("given", "info"),
    [
        ({"core": "4"}, "did you mean `cores`|Did you mean `cores`"),
        ({"cores": "many"}, "a whole number"),
    ],
)
def test_wrong_resources_are_refused(given, info):
    with pytest.raises(InputError, match=info):
        place_of("slurm", How(resources=given))


def test_the_script_of_a_job_asks_for_what_was_given():
    from tmodes.study.places.dask import cluster_of

    asked = {"cores": "8", "memory": "16GB", "queue": "short", "walltime": "02:00:00", "account": "robots", "jobs": "5"}
    how = How(insecure=True, resources=asked | {"interface": "lo"})
    with cluster_of(how) as cluster:
        script = cluster.job_script()
    for line in (
        "#SBATCH -p short",
        "#SBATCH -A robots",
        "#SBATCH --cpus-per-task=8",
        "#SBATCH -t 02:00:00",
        "--mem=15G",
    ):
        assert line in script
    assert "distributed.cli.dask_worker tcp://127.0.0.1:" in script
    assert "--nthreads 8" in script
