"""Result: the record of a run as labelled series with units, and what is asked of it.

    RunData  --assemble_result-->  Result  ->  file, figures, report

Dimensions: ``time``, ``coordinate``, ``deformation_kind`` (``joint.gear`` and the links' coordinates), ``drive``,
``point``, ``axis`` (x, y, z), ``link`` (all that are drawn), ``bending_link``, ``stressed_link``, ``plane`` and
``moment_kind`` (in section axes), ``s`` (0 root, 1 tip), ``energy_kind``, ``work_kind``, ``event``.
"""

from __future__ import annotations

import copy
import os
from collections.abc import Callable
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, cast

from tmodes.errors import TmodesError
from tmodes.integrate.conditions import Band
from tmodes.io.arguments import checked_arguments
from tmodes.io.labelled import Record
from tmodes.result import record
from tmodes.result.derived import failed_in, sentences
from tmodes.result.events import read_events
from tmodes.result.record import absent_kinds
from tmodes.result.summary import summarise_result, vibrations

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

    from tmodes.kinds.registry import UnknownKindError
    from tmodes.result.assemble import ResultAssembly
    from tmodes.sheet import Robot
    from tmodes.simulation.event import Event
    from tmodes.simulation.motion_run import RunData

__all__ = ["Result", "assemble_result"]


class Result:
    """What a run gave: ``result.data["tip"].sel(axis="z")``, ``result.data["q"].sel(coordinate="elbow")``.

    What is computed from the trajectories (elastic lines, frequencies, settling, warnings, errors) is computed when it
    is first asked for, and once. A result that was read from a file has it all already.

    ``timing``: seconds of computing for each simulated second, by the name of each run that was made just now. It is no
    part of the record and never stored: the same run gives the same bytes, on a slow machine too.
    """

    def __init__(
        self,
        data: Dataset | Record | None = None,
        timing: dict[str, float] | None = None,
        made: ResultAssembly | None = None,
    ) -> None:
        self._record = data if isinstance(data, Record) else None
        if data is not None and self._record is None:
            self.__dict__["data"] = data
        self.timing, self._assembly = timing or {}, made
        self._summaries: dict[Band | None, dict[str, Any]] = {}

    def __reduce__(self) -> tuple[Any, ...]:
        """A copy, and what was pickled, holds the whole record; nothing of the compiled code of the run."""
        return type(self), (self.data.copy(deep=True), self.timing)

    @cached_property
    def data(self) -> Dataset:
        """The whole record: all series with their units, and as attributes where they come from and what they show."""
        return self.record.dataset()

    @property
    def record(self) -> Record:
        """The same as this package reads it itself: of :attr:`data`, once that was asked for and may be changed."""
        if "data" in self.__dict__:
            return cast("Record", self.data)
        if self._record is None and self._assembly:
            self._record = self._assembly.whole()
        return cast("Record", self._record)

    def with_record(self, record: Record) -> Self:
        """The same run with another record.

        >>> result.with_record(result.record).status
        'finished'
        """
        return type(self)(record, self.timing, self._assembly)

    def begun(self) -> Self:
        """The motion alone, nothing computed of it: what is stored first. Of a result that is complete, itself.

        >>> result.begun().status
        'finished'
        """
        return type(self)(live.begun, self.timing) if (live := self.assembly) else self

    def complete(self, progress: Callable[[str, float], None]) -> Self:
        """Compute all that is stored of it, which :attr:`data` else does, and report the stages; returns itself.

        What fails is left out, see :attr:`not_computed`; Ctrl-C leaves out what is not computed by then.

        >>> result.complete(lambda stage, share: None) is result
        True
        """
        if live := self.assembly:
            self._record = live.whole(progress, keep=True)
        return self

    @property
    def motion(self) -> Dataset:
        """The series of motion, drives, points, contact and energies, without computing the elastic lines."""
        return live.motion.dataset() if (live := self.assembly) else self.data

    @property
    def status(self) -> str:
        """How the run ended: one of :data:`tmodes.result.record.STATUSES`."""
        return live.ending[0] if (live := self.assembly) else record.text_of(self.record, "status")

    @property
    def success(self) -> bool:
        """True when the run reached its end, or a stop condition that it was asked for."""
        return self.status in record.STATUSES[:2]

    @property
    def message(self) -> str:
        """How the run ended, in a sentence."""
        return live.ending[1] if (live := self.assembly) else record.text_of(self.record, "message")

    @property
    def name(self) -> str:
        """The name of the robot that ran."""
        live = self.assembly
        return live.known.name if live else str(record.from_json(self.record, "robot").get("name", ""))

    @cached_property
    def robot(self) -> Robot:
        """The robot that ran, as it is known; from a file, rebuilt from its data sheet and checked again.

        Raises :class:`tmodes.kinds.registry.UnknownKindError` where it names a kind that is not registered here.
        """
        return made.known if (made := self.made) else record.stored_robot(self.record, "robot")

    @cached_property
    def actual(self) -> Robot:
        """The robot as it really ran, its ``real`` factors taken; raises as :attr:`robot`."""
        return made.run.robot if (made := self.made) else record.stored_robot(self.record, "robot_real")

    @property
    def frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Natural frequencies [Hz] and damping ratios [-] with the motors ``locked``, ``free`` and ``controlled``.

        Of the actual robot about its rest, in contact where it is.
        """
        if live := self.assembly:
            return live.frequencies
        return record.from_json(self.record, name) if (name := "frequencies") in self.record.attrs else self._again

    @property
    def end_frequencies(self) -> dict[str, list[dict[str, Any]]]:
        """Modes about the pose at the end of the ``actual`` and ``nominal`` robot; empty where they are not known."""
        if live := self.assembly:
            return live.end_frequencies
        return record.from_json(self.record, name) if (name := "end_frequencies") in self.record.attrs else {}

    @cached_property
    def _again(self) -> dict[str, list[dict[str, Any]]]:
        from tmodes.analysis.modes.of_sheet import sheet_frequencies

        return sheet_frequencies(self.actual)

    @property
    def settling(self) -> dict[str, Any] | None:
        """When the actual tip stays near its own rest, see :func:`tmodes.result.settling.settling`.

        Of a file of an earlier version None: then the summary looks at its samples alone.
        """
        if live := self.assembly:
            return live.settling
        known = record.from_json(self.record, "settling") if "settling" in self.record.attrs else None
        return known if known and "move_m" in known else None

    @property
    def vibration(self) -> dict[str, Any]:
        """Residual vibration of the ``actual`` and the ``nominal`` tip at the end of the move, by mode [Hz, m]."""
        return live.vibration if (live := self.assembly) else vibrations(self.record)

    @property
    def events(self) -> tuple[Event, ...]:
        """What happened at instants: touch and release, stick and slip, teeth, limits, the end by a condition.

        Each has ``time`` [s], ``kind``, ``place``, and ``speed`` with its ``unit``. In the data they are the variables
        along the dimension ``event``; a file of an earlier version has none.
        """
        return live.events if (live := self.assembly) else read_events(self.record)

    @property
    def warnings(self) -> tuple[str, ...]:
        """What the run has to say about itself, as sentences; of a file also which of its kinds are absent here."""
        if live := self.assembly:
            return (*live.warnings, *sentences(live.failed))
        kept = self.record
        older = [] if "vibration" in kept.attrs else [record.OLDER]
        further = [*(record.NOTICE.format(one) for one in self._absent), *sentences(self.not_computed), *older]
        return (*record.from_json(kept, "warnings"), *further)

    @property
    def not_computed(self) -> dict[str, str]:
        """The numbers that could not be computed of the run, by name, and why; of a live one those asked for so far."""
        return dict(live.failed) if (live := self.assembly) else failed_in(self.record)

    @cached_property
    def _absent(self) -> list[UnknownKindError]:
        """Kinds that the robot names and that are not registered in this process."""
        kept = self.record
        return absent_kinds(record.from_json(kept, "robot_real" if "robot_real" in kept.attrs else "robot"))

    @property
    def statistics(self) -> dict[str, Any]:
        """What the integration took: steps, rejected steps, evaluations, dt times the highest frequency."""
        return record.from_json(self.record, "statistics")

    @checked_arguments
    def output(self, name: str) -> DataArray:
        """One output by its name, such as ``tip.x``, over the time [s] of the run; its unit is in the attributes.

        ``tmodes.outputs(result.robot)`` lists the names. What is not stored is computed by the equations of the run.
        Raises :class:`tmodes.errors.InputError` for an unknown name, with the nearest one, and where a run has it not.

        >>> result.output("tip.speed").attrs["units"]
        'm/s'
        """
        from xarray import DataArray

        from tmodes.result.outputs import output_values

        data, made = live.motion if (live := self.assembly) else self.record, self.made
        output, values = output_values(data, self.actual, made and made.run, name)
        info = {"units": output.unit, "long_name": output.meaning}
        return DataArray(values, {"time": ("time", data["time"].values, {"units": "s"})}, ("time",), name, info)

    @checked_arguments
    def reduce(self, name: str, how: str) -> float:
        """One number of an output over the run, in its unit or in s: ``result.reduce("tip.speed", "percentile:95")``.

        ``how``: as of :class:`tmodes.simulation.reductions.Reduction`, over the stored samples. Raises
        :class:`tmodes.errors.InputError` as :meth:`output`, and for a rule that is none.

        >>> result.reduce("tip.speed", "max") > result.reduce("tip.speed", "rms")
        True
        """
        from tmodes.simulation.reductions import Reduction, of_samples, refuse_unknown_rules

        refuse_unknown_rules([one := Reduction(name, how)])
        series = self.output(name)
        return float(of_samples(one, series.values[None], series["time"].values)[0])

    @property
    def move_end(self) -> float | None:
        """When the last signal stops changing [s]; None where one never does."""
        return live.move_end if (live := self.assembly) else record.from_json(self.record, "move_end")

    @checked_arguments
    def summary(self, band: float | str | None = None) -> dict[str, Any]:
        """The numbers a reader asks first; see :func:`tmodes.result.summary.summarise_result`.

        ``band``: another one than the robot's own within which the tip counts as settled: a share of the move, such as
        0.02 or "2 %", or a length, such as "0.1 mm". Raises :class:`tmodes.errors.InputError` for what is neither.

        >>> result.summary()["settling"]["time_s"] is None  # it is still moving
        True
        """
        known = {} if "data" in self.__dict__ else self._summaries  # the dataset may be changed by who asked for it
        asked = None if band is None else Band.parsed(band)
        if asked not in known:
            summary = summarise_result(self.record, asked, self._assembly and self._assembly.settled)
            known[asked] = summary | {"verdict": self._verdict(summary)}
        return copy.deepcopy(known[asked])

    @property
    def verdict(self) -> dict[str, Any]:
        """What the run comes to, as plain data; ``sentence`` has all of it in words.

        How far the ``point`` was off, ``against`` its commanded path, or the nominal one where nothing is commanded:
        ``largest_m`` [m] at ``time_s`` [s], ``final_m`` [m]; ``culprits``: components ``value_m`` [m] of each cause and
        element along the largest error, which add up to it. ``settling``: ``time_s`` [s] after the move, ``within_m``
        [m] of its own rest, or a ``reason``; ``residual``: ``amplitude_m`` [m] of its vibration then, and
        ``frequency_Hz``, ``damping`` [-] of the strongest mode of that. ``limits`` of the sheet, the most critical
        first; ``jump``: ``joint`` and ``time_s`` [s] of the first jump of a command; ``tolerance_m`` [m] of its task,
        and by that the ``level``: ``neutral``, ``good`` or ``bad``. What is not known is None.

        Source: :func:`tmodes.result.verdict.verdict`.

        >>> result.verdict["against"], len(result.verdict["culprits"])
        ('commanded', 2)
        """
        return self.summary()["verdict"]

    def _verdict(self, summary: dict[str, Any]) -> dict[str, Any]:
        from tmodes.result.verdict import jump_of, limits_of, verdict

        try:
            robot = self.robot
        except TmodesError:  # it names a kind that is not known here
            return verdict(summary, warnings=self.warnings, message=self.message)
        limits, task = limits_of(robot, self.record, summary["links"]), robot.task
        jump = jump_of(robot, float(self.record["time"].values[-1]))
        return verdict(summary, limits, task and task.tolerance, self.warnings, self.message, jump)

    @checked_arguments
    def save(self, path: str | os.PathLike[str], *, overwrite: bool = False) -> Path:
        """Store the result as one sealed NetCDF-4 file; the same result gives the same bytes.

        Whatever happens meanwhile, the path holds the old file or the new one, whole. Raises
        :class:`tmodes.errors.ResultFileError` when the file exists, cannot be written, or a number is not finite.

        >>> result.save("run.nc").name
        'run.nc'
        """
        return record.write_record(self.record, Path(path), overwrite=overwrite)

    @classmethod
    @checked_arguments
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a result back, whole and checked; a kind that is not registered here gives a warning that names it.

        Raises :class:`tmodes.errors.ResultFileError` when the file is damaged, foreign, or of another version.

        >>> _ = result.save("again.nc")
        >>> tmodes.Result.load("again.nc").status
        'finished'
        """
        return cls.of(record.read_record(path), path)

    @classmethod
    def of(cls, data: Record, path: object) -> Self:
        """The result that a record or a dataset holds; ``path`` names it in errors, which are those of :meth:`load`.

        >>> tmodes.Result.of(result.record, "a record").name
        'spong1987'
        """
        record.refuse_incomplete(data := record.with_present_names(data), path)
        if not record.is_earlier(data):
            return cls(data)
        from tmodes.result import earlier

        return cls(made=earlier.earlier_assembly(data, path))

    def _repr_html_(self) -> str:
        return self.data._repr_html_()

    @property
    def assembly(self) -> ResultAssembly | None:
        """The run that was made just now, until its whole record was put together."""
        return None if self._record is not None else self.made

    @property
    def made(self) -> ResultAssembly | None:
        """The run that was made just now, while its dataset cannot have been changed."""
        return None if "data" in self.__dict__ else self._assembly


def assemble_result(run: RunData, known: Robot | None = None) -> Result:
    """The result of a run; ``known``: the robot by whose sheet it was planned, None: the one of the run."""
    from tmodes.result.assemble import ResultAssembly

    timing = {"real": run.seconds} | ({"reference": run.reference.seconds} if run.reference else {})
    return Result(timing=timing, made=ResultAssembly(run, known or run.robot))
