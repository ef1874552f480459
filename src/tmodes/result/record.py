"""Result: the frozen, self-describing record of one run.

Every series is a labelled variable with its unit; the attributes tell the robot, the settings and how the run ended.
What results of all kinds of robots share is a :class:`RunRecord`; the attribute ``kind`` says what ran.
"""

from __future__ import annotations

import json
import os
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, ClassVar, Self

from tmodes import upward
from tmodes.io.atomic import file_error
from tmodes.io.words import shown

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.paper.sheet import PaperRobot

__all__ = ["RESULT_FORMAT", "STATUSES", "PaperResult", "RunRecord", "kind_of", "read_record"]

RESULT_FORMAT = 1
"""Version of the names and meanings in a result (of the file's bytes: ``io.resultfile.FORMAT_VERSION``)."""

_NEEDED = ("robot", "status", "message", "frequencies", "statistics", "warnings", "versions")
_SERIES = ("time", "q", "v", "tip", "energy", "work", "energy_balance")
"""What every result of a run holds."""

KINDS = {"robot": "the robot of the 2010 paper (PaperResult.load)", "arm": "a robot (Result.load)"}
"""The kinds of results, and who reads them; a result that does not tell its kind is of the first."""

STATUSES = (
    "finished", "stopped_by_condition", "diverged", "step_too_small", "not_converged", "chattering", "stopped",
    "interrupted",
)  # fmt: skip
"""How a run ends: at its end, by a stop condition that was asked for, or without having come to either."""


class RunRecord:
    """What a run gave, as an xarray Dataset, whatever ran.

    ``timing``: seconds of computing for each simulated second, by the name of each run that was made just now. It is no
    part of the record and never stored: the same run gives the same bytes, on a slow machine too.
    """

    def __init__(self, data: Dataset | None = None, timing: dict[str, float] | None = None) -> None:
        if data is not None:
            self.__dict__["data"] = data
        self.timing = timing or {}

    @cached_property
    def data(self) -> Dataset:
        """The whole record: all series with their units, and as attributes where they come from and what they show."""
        raise AttributeError("data")

    kind: ClassVar[str] = ""
    needed: ClassVar[tuple[str, ...]] = _NEEDED
    series: ClassVar[tuple[str, ...]] = _SERIES

    @property
    def status(self) -> str:
        """How the run ended: one of :data:`STATUSES`."""
        return self._attribute("status")

    @property
    def success(self) -> bool:
        """True when the run reached its end, or a stop condition that it was asked for."""
        return self.status in STATUSES[:2]

    @property
    def message(self) -> str:
        """How the run ended, in a sentence."""
        return self._attribute("message")

    @property
    def warnings(self) -> tuple[str, ...]:
        """What the run has to say about itself, as sentences."""
        return tuple(self._json("warnings"))

    @property
    def frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Natural frequencies [Hz] and damping ratios [-] with the motor ``locked``, ``free`` and ``controlled``.

        Of the real robot in free space, about its rest under gravity, also where the run was in contact.
        """
        return self._json("frequencies")

    @property
    def statistics(self) -> dict[str, Any]:
        """What the integration took: steps, rejected steps, evaluations, dt times the highest frequency."""
        return self._json("statistics")

    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Store the result as one sealed NetCDF-4 file; the same result gives the same bytes.

        Whatever happens meanwhile, the path holds the old file or the new one, whole.
        Raises :class:`tmodes.errors.ResultFileError` when the file exists, cannot be written, or a number is not
        finite.
        """
        from tmodes.io.resultfile import write_sealed

        path = Path(path)
        if os.path.lexists(path) and not overwrite:
            raise file_error(path, "a file that exists", "a new name", "choose another name, or overwrite=True")
        self._check_finite()
        write_sealed(self.data, path, overwrite=overwrite)
        return path

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a result back, whole and checked.

        Raises :class:`tmodes.errors.ResultFileError` when the file is damaged, foreign, of another version, or of
        another kind of robot.
        """
        return cls.of(read_record(path), path)

    @classmethod
    def of(cls, data: Dataset, path: object) -> Self:
        """The result that a dataset holds; ``path`` names it in errors, which are those of :meth:`load`."""
        if (kind := kind_of(data)) != cls.kind:
            got, expected = (f"a result of {KINDS.get(name, shown(name))}" for name in (kind, cls.kind))
            raise file_error(path, got, expected, "read it with the other, or with tmodes.result.load_result")
        missing = [name for name in cls.needed if name not in data.attrs]
        missing += [name for name in cls.series if name not in data]
        if missing:
            raise file_error(f"{path}, {missing[0]}", "nothing", "a result of a run", "run the robot again")
        if data.attrs["status"] not in STATUSES:
            got, expected = repr(data.attrs["status"]), f"one of {STATUSES}"
            raise file_error(f"{path}, status", got, expected, "run the robot again")
        return cls(data)

    def show(self, height: int = 760) -> Any:
        """The viewer of this run for a notebook: the robot in 3D, linked charts, numbers; ``height`` in pixels."""
        return upward("Result.show")(self, height=height)

    def _repr_html_(self) -> str:
        return self.data._repr_html_()

    def _attribute(self, name: str) -> str:
        if name not in self.data.attrs:
            raise file_error(f"result, attribute {name}", "nothing", "text", "run the robot again")
        return str(self.data.attrs[name])

    def _json(self, name: str) -> Any:
        try:
            return json.loads(self._attribute(name))
        except (ValueError, RecursionError) as error:
            raise file_error(f"result, attribute {name}", "no JSON text", "JSON text", "run the robot again") from error

    def _check_finite(self) -> None:
        import numpy as np

        for name, variable in self.data.variables.items():
            if np.issubdtype(variable.dtype, np.floating) and not np.isfinite(variable.values).all():
                hint = "keep only what is before it: result.data.isel(time=slice(None, n))"
                raise file_error(f"variable {name}", "a number that is not finite", "finite numbers", hint)


class PaperResult(RunRecord):
    """What a run of the 2010 paper's robot gave: ``result.data["tip"].sel(axis="z")``."""

    kind: ClassVar[str] = "robot"
    needed: ClassVar[tuple[str, ...]] = (*_NEEDED, "parameters", "reading")
    series: ClassVar[tuple[str, ...]] = (*_SERIES, "deviation", "deformation", "bending_moment", "line")

    @property
    def robot(self) -> PaperRobot:
        """The robot that ran, rebuilt from its data sheet and checked again."""
        from tmodes.paper.sheet import PaperRobot

        return PaperRobot.from_data(self._json("robot"))

    def summary(self, band: float = 0.05) -> dict[str, Any]:
        """The numbers a reader asks first; see :func:`tmodes.analysis.summary.summarise`.

        Raises :class:`tmodes.errors.InputError` for a ``band`` that is not between 0 and 1.
        """
        from tmodes.analysis.summary import summarise

        return summarise(self.data, band)


def kind_of(data: Dataset) -> str:
    """What ran: one of ``robot`` (the 2010 paper's) and ``arm``."""
    return str(data.attrs.get("kind", "robot"))


def read_record(path: str | os.PathLike[str]) -> Dataset:
    """The dataset of a result file of any kind, whole, of the version that is known here.

    Raises :class:`tmodes.errors.ResultFileError` as :meth:`RunRecord.load`.
    """
    from tmodes.io.resultfile import read_sealed

    data = read_sealed(path)
    version = data.attrs.get("tmodes_format")
    if version != RESULT_FORMAT:
        hint = "read it with the tmodes that wrote it, or run the robot again"
        raise file_error(f"{path}, tmodes_format", repr(version), str(RESULT_FORMAT), hint)
    return data
