"""Motions of chosen cases next to the table: ``trajectories/case_000012.nc``, NetCDF as the project's results."""

from __future__ import annotations

import io
from collections.abc import Callable, Collection
from pathlib import Path
from typing import TYPE_CHECKING

from tmodes.io.atomic import atomic_write, remove_orphans
from tmodes.study.store import MOTIONS, Folder

if TYPE_CHECKING:
    from tmodes.study.rows import Kept

__all__ = ["motion_file", "write_motions"]

Progress = Callable[[str, float], None]


def motion_file(folder: Path, case: int) -> Path:
    """Where the motion of a case is."""
    return folder / MOTIONS / f"case_{case:06d}.nc"


def write_motions(folder: Folder, wanted: Collection[int], progress: Progress) -> None:
    """Write the motions of the ``wanted`` cases that the blocks have kept, those that are not there yet."""
    by_block: dict[str, list[int]] = {}
    for case, label in folder.keepers().items():
        if case in wanted and _block_of(motion_file(folder.path, case)) != label.name:
            by_block.setdefault(label.name, []).append(case)
    if not by_block:
        return
    place = folder.path / MOTIONS
    place.mkdir(exist_ok=True)
    remove_orphans(place)
    for done, (name, cases) in enumerate(by_block.items()):
        progress("trajectories", done / len(by_block))
        kept = folder.read(folder.blocks / name).rows.kept
        for case in cases:
            if case in kept:
                with atomic_write(motion_file(folder.path, case), durable=False) as path:
                    path.write_bytes(_netcdf(folder.study.sheet.name, case, kept[case], name))


_NUMBERS = ("states", "tip", "time")
"""Variables with a checksum, which whoever reads them compares: a damaged file is an error and no motion."""


def _block_of(file: Path) -> str | None:
    """The block of which a motion that is there comes; None where there is none, or one that cannot be read whole."""
    import h5py

    try:
        with h5py.File(file) as opened:
            for name in _NUMBERS:
                opened[name][()]  # pyright: ignore[reportIndexIssue]
            return str(opened.attrs["block"])
    except (OSError, KeyError):
        return None


def _states(motion: Kept) -> list[str]:
    """Names of all states: coordinates, their velocities, and what else is integrated by its number."""
    names = [*motion.names, *(f"{name}.velocity" for name in motion.names)]
    return [*names, *(f"state.{k}" for k in range(len(names), motion.states.shape[1]))][: motion.states.shape[1]]


def _netcdf(study: str, case: int, motion: Kept, block: str) -> bytes:
    import xarray as xr

    data = xr.Dataset(
        {
            "states": (("time", "state"), motion.states, {"long_name": "coordinates and rates"}),
            "tip": (("time", "axis"), motion.tip, {"long_name": "position of the tip", "units": "m"}),
        },
        {"time": ("time", motion.times, {"units": "s"}), "state": _states(motion), "axis": ["x", "y", "z"]},
        {"study": study, "case": case, "block": block},
    )
    buffer = io.BytesIO()
    checked = {name: {"fletcher32": True, "chunksizes": data[name].shape} for name in _NUMBERS}
    data.to_netcdf(buffer, engine="h5netcdf", encoding=checked)
    return buffer.getvalue()
