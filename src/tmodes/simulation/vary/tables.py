"""What the tips of cases are compared with: the nominal tip, the tip of the sheet's own run, the commanded path."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import straight
from tmodes.analysis.quasistatic import sprung
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION
from tmodes.errors import InputError
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command
from tmodes.simulation.batch.executor import PROCESSOR, Executor
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.output_request import OutputRequest
from tmodes.simulation.plan import Follow
from tmodes.simulation.problem import Problem
from tmodes.simulation.solve import solve
from tmodes.simulation.vary.case_group import CaseGroup
from tmodes.simulation.vary.simulate import Prepared, prepared, run_prepared
from tmodes.simulation.vary.values import RobotVariant, Whole
from tmodes.simulation.warnings import jumps

__all__ = [
    "GivenTable",
    "Nominal",
    "at_setpoints",
    "commanded_signals",
    "commanded_states",
    "follows_nominal",
    "nominal_variant",
    "own_tip",
    "setpoints",
]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_REAL = "real"
"""Numbers below this path are those of the actual robot alone."""


class GivenTable(NamedTuple):
    """What is given for each sample: ``numbers`` (1 or k, n, 3 for each of the names).

    ``lost``: why the nominal run of a case did not come to its end; ``seconds`` (1 or k,) that the runs took.
    """

    numbers: Array
    lost: dict[int, str]
    seconds: Array
    interrupted: bool = False


def nominal_variant(sheet: Robot, paths: Collection[str], names: Collection[str]) -> RobotVariant:
    """Which robot plans the motion in runs of this sheet with numbers of some ``paths`` varied, and how it runs.

    Raises :class:`tmodes.errors.InputError` where it does not run, and one of the ``names`` needs that.
    """
    nominal, why = sheet.pair().nominal, ""
    if any(drive.command is Command.POSITION for drive in nominal.drives):
        why = jumps(run_setup(nominal, Follow.WANTED))
    elif not sheet.real and not any(path.startswith(f"{_REAL}.") for path in paths):
        why = "nominal and actual robot are the same"
    else:
        return RobotVariant.NOMINAL
    if why and DEVIATION in names:
        expected, hint = (
            "another series: there is no nominal run",
            f"`{COMMANDED}` is the distance to the commanded path",
        )
        raise InputError("reductions", f"`{DEVIATION}`, but {why}", expected, hint)
    return RobotVariant.ACTUAL if why else RobotVariant.PLANNED


def own_tip(sheet: Robot, threads: int) -> Array:
    """The tip of the sheet's own run, (1, n, 3) [m]; not-a-number where it does not finish."""
    own = run_prepared(prepared(sheet, None), tips=True, threads=threads)
    assert own.tips is not None  # noqa: S101
    return own.tips


def commanded_signals(setup: RunSetup) -> dict[int, int]:
    """The signal of each coordinate that a drive keeps, or moves, where it should be; empty without a motion."""
    motion = {drive.joint for drive in setup.robot.drives if drive.command.is_motion}
    return {
        driver.coordinate: driver.plan.wanted
        for driver in setup.model.loop.drivers
        if driver.plan.servo is None or driver.plan.joint in motion
    } if motion else {}  # fmt: skip


def setpoints(setup: RunSetup) -> dict[int, int] | None:
    """Those of :func:`commanded_signals`; None where some joint has none.

    Then the commanded path depends on how the other joints move.
    """
    known = commanded_signals(setup)
    moved = {axis.angle: axis.motor for axis in setup.mechanics.parts.axes}
    apart = [place for place, motor in moved.items() if (motor if motor >= 0 else place) not in known]
    return None if apart or not known else known


def follows_nominal(setup: RunSetup) -> bool:
    """Whether the commanded tip is the nominal one: joints without a setpoint move in it, and nothing else bends."""
    mechanics = setup.mechanics
    return bool(commanded_signals(setup)) and not (sprung(mechanics) or len(mechanics.deformations))


def at_setpoints(setup: RunSetup, known: Mapping[int, int], rows: Array, times: Array) -> Array:
    """States (n, size) whose coordinates are where their signals are, ``known``, by rows (n, row) of the signals."""
    powers = rows[:, 1:].reshape(len(times), -1, setup.planned.plan.degree + 1)
    values = (powers * (times - rows[:, 0])[:, None, None] ** np.arange(powers.shape[2])).sum(axis=2)
    states = np.zeros((len(times), setup.model.layout.size))
    states[:, setup.model.layout.q.start + np.array([*known])] = values[:, [*known.values()]]
    return states


def commanded_states(setup: RunSetup, known: Mapping[int, int], rows: Array, times: Array) -> Array:
    """The same of the undeformed robot, with joints where the inputs of their gears are."""
    states, q = at_setpoints(setup, known, rows, times), setup.model.layout.q
    states[:, q] = straight(setup.mechanics, states[:, q])
    return states


@dataclass(frozen=True, eq=False)
class Nominal:
    """The nominal robots of cases: one for all, or one each; ``names``: of the distances for which they are needed."""

    lanes: Prepared
    names: tuple[str, ...]

    @classmethod
    def of(
        cls,
        sheet: Robot,
        values: Mapping[str, Array],
        variant: RobotVariant,
        names: Sequence[str],
        threads: int,
        progress: Progress,
        whole: Whole | None = None,
    ) -> Nominal:
        """Prepare them; numbers under ``real`` are none of the nominal robot."""
        own = {
            path: numbers
            for path, numbers in values.items()
            if variant is RobotVariant.ACTUAL or path.partition(".")[0] != _REAL
        }
        lanes = prepared(
            sheet, own or None, keep=False, progress=progress, variant=variant, threads=threads, whole=whole
        )
        return cls(lanes, tuple(names))

    @property
    def same(self) -> bool:
        """Whether one stands for all cases."""
        return not self.lanes.values

    def part(self, first: int, stop: int) -> Nominal:
        """Those of some cases."""
        return self if self.same else Nominal(self.lanes.part(first, stop), self.names)

    def table(
        self, room: Array, threads: int, progress: Callable[[float], None], executor: Executor = PROCESSOR
    ) -> GivenTable:
        """The tips (k, n, 3 for each name) in a room of their own; one that stands for all runs on the processor."""
        executor = PROCESSOR if self.same else executor
        lost, seconds, interrupted = dict(self.lanes.failed), np.zeros(self.lanes.size), False
        found = room[: self.lanes.size]
        found[list(lost)] = np.nan
        for k, name in enumerate(self.names):
            part = np.empty((*found.shape[:2], 3)) if len(self.names) > 1 else found
            if name == DEVIATION or setpoints(self.lanes.groups[0].like) is None:
                works = self._works(part)
                results = solve(works, self.lanes.size, executor=executor, threads=threads, progress=progress)
                seconds, interrupted = results.seconds, len(results.ended("interrupted")) > 0
                for place in np.flatnonzero(~np.isin(results.status, ("", "finished"))).tolist():
                    part[place, results.samples[place] :] = np.nan
                    lost[place] = results.message[place]
            else:
                for group in self.lanes.groups:
                    part[group.places] = _commanded(group, self.lanes.times)
            if part is not found:
                found[:, :, 3 * k : 3 * k + 3] = part
        return GivenTable(found, lost, seconds, interrupted)

    def _works(self, out: Array) -> list[Problem]:
        """Runs whose tips are written into ``out`` (k, n, 3)."""
        table, empty = np.zeros((1, out.shape[1], 0)), np.empty((self.lanes.size, 0, 0))
        tips = [group.like.model.outputs.groups["tip"] for group in self.lanes.groups]
        wanted = [OutputRequest(tip, table, self.lanes.times, out, folds=False) for tip in tips]
        return [group.work(empty, one) for group, one in zip(self.lanes.groups, wanted, strict=True)]


def _commanded(group: CaseGroup, times: Array) -> Array:
    """The tips (k, n, 3) [m] of undeformed robots whose drives are where they should be."""
    setup, every = group.like, np.arange(len(group.places))
    known, schedules = setpoints(setup), group.numbers(every).schedules
    assert known is not None  # noqa: S101
    shapes = [commanded_states(setup, known, schedule.rows_at(times), times) for schedule in schedules]
    return group.tips(every, times, [shapes[k % len(shapes)] for k in every])
