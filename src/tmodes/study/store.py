"""A study folder: study.json, blocks/, the table and motions; whole at every moment, refused where it is not ours."""

from __future__ import annotations

import hashlib
import io
import os
import re
import sys
from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import ResultFileError
from tmodes.io.atomic import FolderLock, atomic_write, check_writable, file_error, remove_orphans
from tmodes.io.plain_file import parsed_json, regular_file, whole_file
from tmodes.study.blocks import (
    Block,
    Cover,
    Label,
    base_of,
    canonical,
    cases_address,
    covered,
    engine_of_blocks,
    in_order,
    label_of,
    pack,
    refused,
    unpack_from,
)
from tmodes.study.rows import Rows
from tmodes.study.study import Study

if TYPE_CHECKING:
    from tmodes.study.rows import Kept

__all__ = [
    "BLOCKS",
    "MOTIONS",
    "NAME",
    "PAGE",
    "STUDY_FILE",
    "TABLE",
    "Folder",
    "description",
    "kept_cases",
    "kept_count",
    "locked",
    "motion_bytes",
    "motion_file",
    "write_motions",
]


def kept_cases(study: Study, first: int, end: int) -> tuple[int, ...]:
    """The cases from ``first`` to before ``end`` whose motion is kept."""
    keep = study.sheet.keep
    found = {case for case in keep.cases if first <= case < end}
    if keep.every:
        found |= set(range(-(-first // keep.every) * keep.every, end, keep.every))
    return tuple(sorted(found))


def kept_count(study: Study, cases: int) -> int:
    """How many of so many cases keep their motion, at most."""
    keep = study.sheet.keep
    return len(keep.cases) + (-(-cases // keep.every) if keep.every else 0)


def motion_bytes(study: Study) -> int:
    """Bytes of the motion of one case, at least: time, tip, and an angle and a rate of each joint, at each sample."""
    if study.robot is None:
        return 0
    settings = study.robot.integration
    samples = int(settings.duration / settings.output_step) + 1
    return 8 * samples * (4 + 2 * len(study.robot.joints))


FOLDER_FORMAT = 1
STUDY_FILE, BLOCKS, TABLE, MOTIONS = "study.json", "blocks", "table.parquet", "trajectories"
PAGE = "study.html"
MOST_DESCRIPTION = 1 << 28
MOST_BLOCK_FILE = 1 << 35
_DESCRIPTION = {"engine": str, "base": str, "cases": int, "data": dict, "table": str}
"""What study.json holds besides its format, kind and digest."""

NAME = re.compile(r"[0-9a-f]{40}\.block")


@dataclass(eq=False)
class Folder:
    """The folder of a study with all its ``values`` (k, d); ``keys``: a digest of each quantity.

    ``table``: digest of the table of all cases, as it was written; empty while there is none.
    """

    path: Path
    study: Study
    values: NDArray[np.float64]
    base: str
    engine: str
    keys: Mapping[str, str]
    asked: dict[str, tuple[int, ...]] = field(default_factory=dict)
    known: dict[str, Label] | None = None
    table: str = ""

    @classmethod
    def of(cls, path: Path, study: Study, values: NDArray[np.float64]) -> Folder:
        """The folder for a study, whether it is there or not."""
        return cls(path, study, values, base_of(study), engine_of_blocks(), study.quantity_identities)

    @property
    def blocks(self) -> Path:
        """Where the blocks are."""
        return self.path / BLOCKS

    def address(self, first: int, end: int) -> str:
        """The address of consecutive cases."""
        return cases_address(self.base, self.study.names, self.values[first:end])

    def labels(self) -> list[Label]:
        """Labels of all blocks, each read and verified whole, once; raises ResultFileError for one that is not ours."""
        if self.known is None:
            self.known = {}
            for file in self._files():
                self.known[file.name] = self.read(file).label
        return list(self.known.values())

    def _files(self) -> list[Path]:
        if not os.path.lexists(self.blocks):
            return []
        if self.blocks.is_symlink() or not self.blocks.is_dir():
            raise file_error(self.blocks, "a link or a file", "a folder", "name another folder for the study")
        return sorted(file for file in self.blocks.iterdir() if not file.name.startswith(".tmodes-"))

    def read(self, file: Path) -> Block:
        """A block from its file, verified; its name is that of its content."""
        if not NAME.fullmatch(file.name):
            raise refused(file, "a file that is no block")
        try:
            with regular_file(file, MOST_BLOCK_FILE, links=False) as (opened, size):
                block = unpack_from(opened, size, file)
        except OSError as error:
            raise refused(file, f"“{error.strerror}” when reading", "a file that can be read") from error
        if block.label.name != file.name:
            raise refused(file, "a block under the name of another")
        if block.label.base != self.base:
            raise refused(file, "a block of another robot, or of other parameters")
        self.asked[file.name] = block.asked
        return block

    def block(self, label: Label) -> Block:
        """The block of a label."""
        return self.read(self.blocks / label.name)

    def write(self, block: Block) -> None:
        """Store a block; when this returns, it is on the disk."""
        with atomic_write(self.blocks / block.label.name) as path:
            path.write_bytes(pack(block))
        self.asked[block.label.name] = block.asked
        if self.known is not None:
            self.known[block.label.name] = block.label

    def store(self, rows: Rows) -> None:
        """Store rows of some quantities that were made here, of cases that are there."""
        keys = {name: self.keys[name] for name in rows.quantities}
        self.write(Block(label_of(self.base, self.engine, keys, rows), rows))

    def cover(self) -> Cover:
        """Which cases are stored, and where."""
        return covered(self.labels(), len(self.values), self.engine, self.keys, self.address)

    def keepers(self) -> dict[int, Label]:
        """The block that was to keep the motion of a case, by its number."""
        found: dict[int, Label] = {}
        for label in self.labels():
            here = label.engine == self.engine and label.end <= len(self.values) and self.asked.get(label.name)
            if here and label.address == self.address(label.first, label.end):
                found |= dict.fromkeys(self.asked[label.name], label)
        return found

    def begin(self) -> None:
        """Write study.json, all that is needed to read the folder, and make room for the blocks."""
        self._describe()
        self.blocks.mkdir(exist_ok=True)

    def end(self) -> None:
        """Write into study.json which table is that of its cases: one that is older, or damaged, is not believed."""
        self.table = _file_digest(self.path / TABLE)
        self._describe(table=self.table)

    @property
    def has_table(self) -> bool:
        """Whether the table there is the one that was written for these cases, to the last bit."""
        file = self.path / TABLE
        return bool(self.table) and file.is_file() and _file_digest(file) == self.table

    def _describe(self, **more: str) -> None:
        info = {
            "format": FOLDER_FORMAT, "kind": "study folder", "engine": self.engine, "base": self.base,
            "cases": len(self.values), "data": dict(self.study.data), **more,
        }  # fmt: skip
        with atomic_write(self.path / STUDY_FILE) as path:
            path.write_bytes(in_order(info | {"digest": _digest(info)}) + b"\n")

    def room(self) -> int:
        """Bytes that are still to be written at most: blocks that are missing, the table, motions that are kept."""
        columns = len(self.study.names) + 2 * len(self.keys) + 4
        table = 8 * columns * len(self.values)
        missing = table + 2 * kept_count(self.study, len(self.values)) * motion_bytes(self.study)
        stored = sum(file.stat().st_size for file in self.blocks.glob("*.block"))
        return table + max(0, missing - stored) + 1_000_000


def _digest(info: Mapping[str, Any]) -> str:
    return hashlib.sha256(canonical(dict(info))).hexdigest()


def _file_digest(file: Path) -> str:
    with regular_file(file, sys.maxsize) as (opened, _):
        return hashlib.file_digest(opened, "sha256").hexdigest()


def description(path: Path) -> dict[str, Any]:
    """What study.json of a folder holds, verified. Raises ResultFileError for what is damaged, foreign or newer."""
    file = path / STUDY_FILE
    if not os.path.lexists(file):
        raise file_error(f"folder {path}", f"no {STUDY_FILE} in it", "the folder of a study", "run a study into it")
    hint = "name another folder, or run the study with --overwrite"
    try:
        info = parsed_json(whole_file(file, MOST_DESCRIPTION, links=False))
    except OSError as error:
        raise file_error(file, f"“{error.strerror}” when reading", "a file that can be read", hint) from error
    except ValueError as error:
        raise file_error(file, "no JSON of a study folder", "the description of a study", hint) from error
    if not isinstance(info, dict) or info.get("kind") != "study folder":
        raise file_error(file, "a file of another kind", "the description of a study", hint)
    if info.get("format") != FOLDER_FORMAT:
        raise file_error(file, f"format {info.get('format')!r}", f"format {FOLDER_FORMAT}", "upgrade tmodes")
    digest = info.pop("digest", None)
    if digest != _digest(info):
        raise file_error(file, "a content that does not match its digest", "the description of a study", hint)
    if wrong := [name for name, kind in _DESCRIPTION.items() if not isinstance(info.get(name, kind()), kind)]:
        raise file_error(file, f"another kind of value under {wrong[0]}", "the description of a study", hint)
    return {name: kind() for name, kind in _DESCRIPTION.items()} | info


@contextmanager
def locked(folder: Folder, *, overwrite: bool = False) -> Iterator[Folder]:
    """The folder, locked for one writer, and checked; what does not belong to it is refused.

    ``overwrite``: what an earlier study has left there is removed, once nothing refuses the next one.
    Raises :class:`tmodes.errors.ResultFileError`.
    """
    path = folder.path
    check_writable(path, folder.room())
    with FolderLock(path):
        _refuse_links(path)
        if overwrite:
            _remove_study(path)
        elif os.path.lexists(path / STUDY_FILE):
            if description(path)["base"] != folder.base:
                hint = "name another folder (--out), or replace what is there (--overwrite)"
                raise file_error(
                    f"folder {path}", "a study of another robot or of other parameters", "a folder of this study", hint
                )
        else:
            _refuse_foreign(path)
        if folder.blocks.is_dir():
            remove_orphans(folder.blocks)
        yield folder


def _refuse_links(path: Path) -> None:
    """What is written or removed in the folder lies there: no link leads elsewhere."""
    for name in (BLOCKS, MOTIONS, TABLE, PAGE):
        if (path / name).is_symlink():
            raise file_error(path / name, "a link", "no link in the folder of a study", "name another folder")


def _refuse_foreign(path: Path) -> None:
    """A folder without a description holds nothing that a study would write over."""
    blocks = path / BLOCKS
    if os.path.lexists(blocks) and (not blocks.is_dir() or any(blocks.iterdir())):
        raise file_error(f"folder {path}", f"blocks without {STUDY_FILE}", "the folder of a study", "name another")
    for name in (TABLE, PAGE):
        if os.path.lexists(path / name):
            hint = "name another folder (--out), or replace it (--overwrite)"
            raise file_error(path / name, f"a file of something else: there is no {STUDY_FILE}", "a new name", hint)


def _remove_study(path: Path) -> None:
    """Remove the files of a study, and nothing else; its description last: what is left halfway is still known.

    Nothing is removed where something would be in the way of the next one.
    """
    blocks = path / BLOCKS
    found = [path / TABLE, path / PAGE, *(path / MOTIONS).glob("case_*.nc"), *_blocks_in(blocks), path / STUDY_FILE]
    if folder := next((file for file in found if file.is_dir() and not file.is_symlink()), None):
        raise file_error(folder, "a folder", "a file of a study", "move it, or name another folder")
    try:
        for file in found:
            file.unlink(missing_ok=True)
    except OSError as error:
        hint = "remove it by hand, or name another folder"
        raise ResultFileError(f"{path} cannot be emptied: {error.strerror}; {hint}") from error


def _blocks_in(folder: Path) -> list[Path]:
    """The files of the folder of blocks, all of which are blocks; what killed writers left there is not counted."""
    if not os.path.lexists(folder):
        return []
    if not folder.is_dir():
        raise file_error(folder, "a file", "the folder of blocks", "move it, or name another folder")
    found = [file for file in folder.iterdir() if not file.name.startswith(".tmodes-")]
    if foreign := next((file for file in found if not NAME.fullmatch(file.name)), None):
        raise file_error(foreign, "a file that is no block", "a block of a study", "move it, or name another folder")
    return found


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
