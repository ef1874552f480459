"""The loops of a robot's controllers: each opened at the command of its drive, while the others stay closed.

In continuous time a torque d is added to the command: all of it is d/(1 + L), of which the inverse gives L with the
states of the open loop. Of a sampled law the command that it computes is not the one that is held.
Source: S. Skogestad, I. Postlethwaite, Multivariable Feedback Control, 2nd ed. (2005), 2.3 and 9.2.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.margins import Margins, loop_margins
from tmodes.kinds.controllers.discrete import zero_order_hold
from tmodes.kinds.signals.registry import constant_signal
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.linear import Instant, StateSpace, growth, instants, row_at, sampled_slopes, start_of
from tmodes.simulation.plan import planned

if TYPE_CHECKING:
    from tmodes.equations.loop.plan import DrivePlan
    from tmodes.sheet import Robot

__all__ = ["drive_loops", "loop_warnings", "sampled_margins"]

Array = NDArray[np.float64]

_LITTLE = 0.2
"""Disk margin below which a loop is named: 11 degrees of phase, or a fifth of its gain."""

_FREE = 0.5
"""Share of a torque that is added to a command which passes: less of it where the drive is at a limit."""


def drive_loops(robot: Robot, time: float | None = None) -> dict[str, StateSpace]:
    """L of each controlled drive that its controllers close by negative feedback, about the start or a ``time`` [s].

    By joint; input and output are its command. Left out are drives at a limit, those under a law of continuous time
    among sampled ones, and laws that sample more than once in the common period of all.
    """
    setup = run_setup(robot)
    (state, row), volts = start_of(setup, time), {one.joint: _volts(one) for one in setup.planned.plan.drives}
    joints = [one.joint for one in robot.drives if one.command.is_controlled and one.joint in volts]
    if setup.planned.plan.is_sampled:
        return dict(_held(setup, (state, row), joints))
    drives = (
        one if one.feed_forward or one.joint not in joints
        else one.model_copy(update={"feed_forward": constant_signal(0.0)})
        for one in robot.drives
    )  # fmt: skip
    fed = planned(robot.model_copy(update={"drives": tuple(drives)}))
    width = fed.plan.degree + 1
    feeds = [(one.joint, 1 + one.feed * width) for one in fed.plan.drives if one.joint in joints]
    at = Instant(fed, state, fed.first_row.copy() if time is None else row_at(fed, time), feeds)
    return dict(_added(at.found([f"{joint}.{'voltage' if volts[joint] else 'effort'}" for joint, _ in feeds])))


def sampled_margins(setup: RunSetup) -> dict[str, Margins]:
    """Margins of the loops of sampled controllers about the start of a run, by the joint of their drive."""
    if not setup.planned.plan.is_sampled or setup.callback:
        return {}
    joints = [one.joint for one in setup.planned.plan.drives if one.servo and one.servo.is_controlled]
    found = _held(setup, start_of(setup, None), joints)
    return {joint: loop_margins(one.A, one.B, one.C, one.D, one.period) for joint, one in found}


def loop_warnings(setup: RunSetup, found: Mapping[str, Margins]) -> Iterator[str]:
    """Of sampled controllers about the start of a run: that a motion grows, or how little more makes one grow."""
    rate = growth(setup) if setup.planned.plan.is_sampled and not setup.callback else 0.0
    if rate:
        yield (
            "the actual robot is unstable under its sampled controllers about its start: a motion grows at "
            f"{rate:.4g} 1/s; lower the gains, sample more often, or shorten the delay"
        )
    for joint, own in found.items():
        if own.stable and own.disk < _LITTLE and not rate:
            yield (
                f"the loop of drive {joint} has a disk margin of {own.disk:.2g} (0.5 is usual): a delay of "
                f"{1e3 * own.delay:.2g} ms more, or {degrees(abs(own.phase)):.2g} deg of phase, makes it ring up; "
                "see `tmodes linear --closed`"
            )


def _volts(drive: DrivePlan) -> bool:
    return bool(drive.servo and drive.servo.driven)


def _added(found: StateSpace) -> Iterator[tuple[str, StateSpace]]:
    """Of laws of continuous time."""
    most = np.abs(np.diag(found.D)).max(initial=0.0)
    for k, joint in enumerate(found.inputs):
        passed = float(found.D[k, k])
        if abs(passed) > _FREE * most:
            B, C = found.B[:, [k]] / passed, found.C[[k]]
            yield joint, _loop(found, joint, found.A - B @ C, B, -C)


def _held(setup: RunSetup, about: tuple[Array, Array], joints: Sequence[str]) -> Iterator[tuple[str, StateSpace]]:
    """Of sampled laws: the place of their newest command among the states, which the loop leaves open."""
    at = Instant(setup.planned, *about, (), setup.model)
    found, (whole, each) = at.found(()), instants(at)
    samples = [(length, due, sampled_slopes(at, due)[0]) for length, due in each]
    clocks = [signal for signal, _ in at.plan.clocks]
    for joint in joints:
        place, clock = _newest(setup, joint)
        often = sum(clock in clocks and clocks.index(clock) in due for _, due, _ in samples)
        if place >= 0 and often == 1:
            state, held, computed = np.eye(len(found.A)), np.zeros((len(found.A), 1)), (found.A, found.A)
            for length, due, by_state in samples:
                moved = by_state @ state, by_state @ held
                if clocks.index(clock) in due:
                    computed = moved[0][[place]], moved[1][[place]]
                    moved[0][place], moved[1][place] = 0.0, 1.0
                on, _ = zero_order_hold(found.A, found.B[:, :0], length)
                state, held = on @ moved[0], on @ moved[1]
            opened = _loop(found, joint, state, held, -computed[0])
            yield joint, replace(opened, D=-computed[1], period=whole)


def _newest(setup: RunSetup, joint: str) -> tuple[int, int]:
    """Where a state holds the last command that a sampled law computed for a joint, and its clock; -1: there is none.

    Behind a filter of continuous time that of the law before it.
    """
    loop, first = setup.model.loop, setup.model.layout.controls.start
    driver = next(one for one in loop.drivers if one.plan.joint == joint)
    servo, wire = driver.plan.servo, driver.plan.command
    if servo and servo.is_sampled:
        return first + driver.controls + servo.held - 1, driver.plan.clock
    while wire:
        placed = next((one for one in loop.blocks if wire in one.plan.signals), None)
        law: Any = placed and placed.plan.law
        if placed and law.is_sampled:
            place = law.held - law.outputs + placed.plan.signals.index(wire)
            return first + placed.controls + place, placed.plan.clock
        wire = law.block.reads[0] if placed and len(law.block.reads) == 1 else ""
    return -1, -1


def _loop(found: StateSpace, joint: str, A: Array, B: Array, C: Array) -> StateSpace:
    """The states of a robot with the command of a drive as input and output."""
    name, none = (f"{joint}.command",), np.zeros(1)
    return replace(found, inputs=name, outputs=name, units={}, A=A, B=B, C=C, D=np.zeros((1, 1)), u0=none, y0=none)
