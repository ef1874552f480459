"""Result: the record of a run as labelled series with units, and what is asked of it.

    RunData  --assemble_result-->  Result  ->  file, figures, report

Dimensions: ``time``, ``coordinate``, ``deformation_kind`` (``joint.gear`` and the links' coordinates), ``drive``,
``point``, ``axis`` (x, y, z), ``link`` (all that are drawn), ``bending_link``, ``stressed_link``, ``plane`` and
``moment_kind`` (in section axes), ``s`` (0 root, 1 tip), ``energy_kind``, ``work_kind``.
"""

from __future__ import annotations

import json
import os
from functools import cached_property
from typing import TYPE_CHECKING, Any, ClassVar, Self

from tmodes import upward
from tmodes.result.assemble import Assembly, frequencies_of_sheet
from tmodes.result.earlier import assembly_2010
from tmodes.result.record import PaperResult, RunRecord, kind_of
from tmodes.result.summary import summarise_result
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["Result", "assemble_result", "load_result"]


_EARLIER = "robot"
"""The kind of the records of the 2010 robot that earlier versions wrote."""


class Result(RunRecord):
    """What a run gave: ``result.data["tip"].sel(axis="z")``, ``result.data["q"].sel(coordinate="elbow")``.

    What is computed from the trajectories (elastic lines, frequencies, settling, warnings, errors) is computed when it
    is first asked for, and once. A result that was read from a file has it all already.
    """

    kind: ClassVar[str] = "arm"
    series: ClassVar[tuple[str, ...]] = (*RunRecord.series, "a", "position")

    def __init__(
        self,
        data: Dataset | None = None,
        timing: dict[str, float] | None = None,
        assembly: Assembly | None = None,
    ) -> None:
        super().__init__(data, timing)
        self._assembly = assembly

    @cached_property
    def data(self) -> Dataset:
        """The whole record: all series with their units, and as attributes where they come from and what they show."""
        assert self._assembly is not None  # noqa: S101
        return self._assembly.whole()

    @property
    def motion(self) -> Dataset:
        """The series of motion, drives, points, contact and energies; elastic lines are not computed for it."""
        return live.motion if (live := self._live) else self.data

    @property
    def status(self) -> str:
        """How the run ended: one of :data:`tmodes.result.record.STATUSES`."""
        return live.ending[0] if (live := self._live) else self._attribute("status")

    @property
    def message(self) -> str:
        """How the run ended, in a sentence."""
        return live.ending[1] if (live := self._live) else self._attribute("message")

    @property
    def robot(self) -> Robot:
        """The robot that ran, as it is known; from a file, rebuilt from its data sheet and checked again."""
        return live.known if (live := self._live) else self._sheet("robot")

    @property
    def arm(self) -> Robot:
        """The same as ``robot``."""
        return self.robot

    @property
    def frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Natural frequencies [Hz] and damping ratios [-] with the motors ``locked``, ``free`` and ``controlled``.

        Of the actual robot about its rest, in contact where it is.
        """
        if live := self._live:
            return live.frequencies
        if "frequencies" in self.data.attrs:
            return self._json("frequencies")
        return self._frequencies_again

    @cached_property
    def _frequencies_again(self) -> dict[str, list[dict[str, Any]]]:
        return frequencies_of_sheet(self._sheet("robot_real"))

    @property
    def settling(self) -> dict[str, Any] | None:
        """When the tip stays within 5 % of its largest deviation, by continuing the run; None without a reference.

        Of a file of an earlier version None too: then the summary looks at its samples alone.
        """
        return live.settling if (live := self._live) else json.loads(self.data.attrs.get("settling", "null"))

    @property
    def warnings(self) -> tuple[str, ...]:
        """What the run has to say about itself, as sentences."""
        return tuple(live.warnings) if (live := self._live) else super().warnings

    @property
    def move_end(self) -> float | None:
        """When the last signal stops changing [s]; None where one never does."""
        return live.move_end if (live := self._live) else self._json("move_end")

    def summary(self, band: float = 0.05) -> dict[str, Any]:
        """The numbers a reader asks first; see :func:`tmodes.result.summary.summarise_result`.

        Raises :class:`tmodes.errors.InputError` for a ``band`` that is not between 0 and 1.
        """
        return summarise_result(self.data, band)

    @classmethod
    def of(cls, data: Dataset, path: object) -> Self:
        """The result that a dataset holds; ``path`` names it in errors, which are those of :meth:`load`."""
        if kind_of(data) == _EARLIER:
            PaperResult.of(data, path)  # refuses what is no whole record
            return cls(assembly=assembly_2010(data))
        return super().of(data, path)

    def figures(self) -> dict[str, Any]:
        """The figures that this result can fill: name -> function that draws it, ``figures()["tip_tracking"]()``."""
        return upward("Result.figures")(self)

    @property
    def _live(self) -> Assembly | None:
        """The run that was made just now, until its whole record was put together."""
        return None if "data" in self.__dict__ else self._assembly

    def _sheet(self, name: str) -> Robot:
        from tmodes.io.sheet_check import sheet_from_data

        return sheet_from_data(self._json(name))


def load_result(path: str | os.PathLike[str]) -> Result:
    """Read a result back; the same as :meth:`Result.load`."""
    return Result.load(path)


def assemble_result(run: RunData, known: Robot | None = None) -> Result:
    """The result of a run; ``known``: the robot by whose sheet it was planned, None: the one of the run."""
    timing = {"real": run.seconds} | ({"reference": run.reference.seconds} if run.reference else {})
    return Result(timing=timing, assembly=Assembly(run, known or run.arm))
