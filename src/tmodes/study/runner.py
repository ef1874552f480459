"""Run a study into its folder: what is stored is not computed again, whatever has interrupted it."""

from __future__ import annotations

import logging
import os
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.io.arguments import checked_arguments
from tmodes.io.atomic import file_error
from tmodes.study.extra import needed
from tmodes.study.job import StudyJob
from tmodes.study.places.contract import How, place_of
from tmodes.study.read import as_study
from tmodes.study.result import StudyResult
from tmodes.study.store import BLOCKS, STUDY_FILE, Folder, kept_cases, locked, write_motions
from tmodes.study.study import Study
from tmodes.study.table import refuse_names, write_table

__all__ = ["run_study"]

Progress = Callable[[str, float], None]

_LOG = logging.getLogger("tmodes")


@checked_arguments
def run_study(
    study: Study | str | os.PathLike[str],
    folder: str | os.PathLike[str],
    on: str = "local",
    *,
    threads: int | None = None,
    recompute: bool = False,
    overwrite: bool = False,
    insecure: bool = False,
    tls: Path | None = None,
    resources: Mapping[str, str] | None = None,
    progress: Progress = lambda stage, share: None,
    notice: Callable[[str], None] = _LOG.warning,
) -> StudyResult:
    """Compute what is missing of a study in its folder, and write the table and the motions that it keeps.

    ``study``: as :func:`tmodes.read_study` gives it, or the path of its file.
    ``on``: where: ``local``, ``dask://HOST:PORT``, ``dask+tls://HOST:PORT``, ``slurm`` or ``gpu``. ``recompute``: cases
    that another version of the engine has computed are computed again; its blocks stay. ``overwrite``: what another
    study left in the folder is removed. ``insecure``, ``tls``, ``resources``: see :class:`tmodes.study.places.How`.
    ``notice`` is given sentences about what is done otherwise than asked; by default they are warnings of the log.

    Killed at any moment, the same call computes only what is missing. Raises :class:`tmodes.errors.ResultFileError`
    for a folder that is damaged, foreign, in use, or without room; :class:`tmodes.errors.InputError` for a wrong place.

    >>> tmodes.run_study("study.yaml", "done").counts
    {'finished': 4}
    """
    needed("pyarrow", "study")
    study = as_study(study).fixed()
    refuse_names(study)
    for name, one in (study.identified or {}).items():
        if one.unknown:
            notice(f"the function `{name}` is called again for every case, whatever the folder has: {one.unknown}")
    place = place_of(on, How(threads, insecure, tls, dict(resources or {})))
    progress("planning", 0.0)
    design = study.design()
    place.refuse()
    with (
        _nothing_left(Path(folder)),
        locked(Folder.of(Path(folder), study, design.values), overwrite=overwrite) as here,
    ):
        _refuse_older(here, recompute, notice)
        with _disk(here.path):
            here.begin()
            job = StudyJob.of(here, threads, progress, notice)
            place.run(job)
            if not job.finished:
                raise SimulationError(f"`{on}` has ended before all cases were computed; run the same command again")
            job.derive()
            write_motions(here, set(kept_cases(study, 0, len(design.values))), progress)
            write_table(here, here.cover(), design.labels, progress)
            here.end()
    return StudyResult(study, Path(folder), design, here)


@contextmanager
def _nothing_left(path: Path) -> Iterator[None]:
    """A study that is refused before anything of it was computed leaves no folder that was not there."""
    made = [place for place in (path.absolute(), *path.absolute().parents) if not os.path.lexists(place)]
    try:
        yield
    except (InputError, InputErrors):
        if made and not any((path / BLOCKS).glob("*")):
            (path / STUDY_FILE).unlink(missing_ok=True)
            with suppress(OSError):
                for place in [path / BLOCKS, *made]:
                    place.rmdir()
        raise


def _refuse_older(folder: Folder, recompute: bool, notice: Callable[[str], None]) -> None:
    """Blocks of another engine are never mixed with those of this one, and never replaced without a word."""
    older = folder.cover().older
    if not older:
        return
    got = f"{older:,} cases of another version of the engine"
    if not recompute:
        hint = "add --overwrite (`tmodes study --recompute` keeps the old blocks, too), or name another folder"
        raise file_error(f"folder {folder.path}", got, f"those of {folder.engine}", hint)
    notice(f"{got} are computed again; the old blocks stay in {folder.blocks}")


@contextmanager
def _disk(path: Path) -> Iterator[None]:
    """What the system refuses while files are written becomes a sentence: what is there stays valid."""
    try:
        yield
    except OSError as error:
        hint = "free some space; the same command computes what is missing"
        got = f"“{error.strerror or error}” when writing"
        raise file_error(f"folder {path}", got, "a place that can be written", hint) from error
