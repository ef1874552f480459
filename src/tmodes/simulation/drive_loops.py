"""The loops of a robot's controllers: each opened at the command of its drive, while the others stay closed.

Something is added to the command: all of it is then that over 1 + L, of which the inverse gives L with the states of
the open loop. In continuous time it is an effort at the drive, of a sampled law it is added to what the states hold.
Source: S. Skogestad, I. Postlethwaite, Multivariable Feedback Control, 2nd ed. (2005), 2.3 and 9.2.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import degrees
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.margins import Margins, frequencies, loop_margins, points
from tmodes.errors import SimulationError
from tmodes.kinds.controllers.discrete import zero_order_hold
from tmodes.kinds.signals.registry import constant_signal
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.linear import Instant, StateSpace, growth, row_at, samples_of, start_of
from tmodes.simulation.plan import planned

if TYPE_CHECKING:
    from tmodes.equations.loop.plan import Driver
    from tmodes.sheet import Robot

__all__ = ["drive_loops", "loop_warnings", "sampled_loops", "sampled_margins", "start_loops"]

Array = NDArray[np.float64]

_LITTLE = 0.2
"""Disk margin below which a loop is named: 11 degrees of phase, or a fifth of its gain."""

_FEW, _MAYBE = 60, 2.0
"""Frequencies at which little margins are looked for; factor on the margin for which they are computed."""

_MOST = 300
"""States up to which the start of a run looks at loops: the time that this takes grows with their third power."""

_FREE = 0.5
"""Share of a torque that is added to a command which passes: less of it where the drive is at a limit."""


def drive_loops(robot: Robot, time: float | None = None) -> dict[str, StateSpace]:
    """L of each controlled drive that its controllers close by negative feedback, about the start or a ``time`` [s].

    By joint; input and output are its command. Left out are drives at a limit, those under a law of continuous time
    among sampled ones, and laws that sample more than once in the common period of all.
    """
    setup = run_setup(robot)
    state, row = start_of(setup, time)
    if setup.planned.plan.is_sampled:
        return {
            joint: _opened(closed, k) for closed in [_held(setup, state, row)] for k, joint in enumerate(closed.inputs)
        }
    volts = {one.joint: bool(one.servo and one.servo.driven) for one in setup.planned.plan.drives}
    joints = [one.joint for one in robot.drives if one.command.is_controlled and one.joint in volts]
    drives = (
        one if one.feed_forward or one.joint not in joints
        else one.model_copy(update={"feed_forward": constant_signal(0.0)})
        for one in robot.drives
    )  # fmt: skip
    fed = planned(robot.model_copy(update={"drives": tuple(drives)}))
    width = fed.plan.degree + 1
    feeds = [(one.joint, 1 + one.feed * width) for one in fed.plan.drives if one.joint in joints]
    at = Instant(fed, state, fed.first_row.copy() if time is None else row_at(fed, time), feeds)
    found = at.found([f"{joint}.{'voltage' if volts[joint] else 'effort'}" for joint, _ in feeds])
    most = np.abs(np.diag(found.D)).max(initial=0.0)
    return {joint: _opened(found, k) for k, joint in enumerate(found.inputs) if abs(found.D[k, k]) > _FREE * most}


def sampled_loops(setup: RunSetup) -> StateSpace | None:
    """From what is added to commands of sampled drives to all of these, about the start of a run; None: no sample."""
    if not setup.planned.plan.is_sampled or setup.callback:
        return None
    return _held(setup, *start_of(setup, None))


def start_loops(setup: RunSetup, *, margins: bool) -> tuple[dict[str, Margins], list[str]]:
    """Margins of the sampled loops about the start of a run, where asked for, and what is to be warned of."""
    try:
        closed = sampled_loops(setup)
    except SimulationError as error:  # a run needs no common period
        return {}, [f"whether the sampled controllers are stable is not looked at before the run: {error}"]
    found = sampled_margins(closed) if closed and margins else None
    return found or {}, [*(loop_warnings(closed, found) if closed else ())]


def sampled_margins(closed: StateSpace) -> dict[str, Margins]:
    """Margins of the loop of each sampled drive, by its joint; none of more states than a run looks at."""
    loops = {joint: _opened(closed, k) for k, joint in enumerate(closed.inputs) if len(closed.A) <= _MOST}
    return {joint: loop_margins(one.A, one.B, one.C, one.D, one.period) for joint, one in loops.items()}


def loop_warnings(closed: StateSpace, found: Mapping[str, Margins] | None = None) -> Iterator[str]:
    """Of sampled controllers about the start of a run: that a motion grows, or how little more makes one grow.

    ``found``: the margins; without them they are computed of the loops alone in which the response that modes sum up to
    says that they may be little. Of more than 300 states that is left to `tmodes linear --closed`.
    """
    if len(closed.A) > _MOST:
        yield (
            "whether the sampled controllers are stable is not looked at before the run: with the values that wait for "
            f"delays the loop has {len(closed.A)} states; `tmodes linear --closed` computes it"
        )
        return
    poles, vectors = np.linalg.eig(closed.A)
    if rate := growth(closed, poles):
        yield (
            "the actual robot is unstable under its sampled controllers about its start: a motion grows at "
            f"{rate:.4g} 1/s; lower the gains, sample more often, or shorten the delay"
        )
        return
    if found is None:
        into, grid = np.linalg.lstsq(vectors, closed.B, rcond=None)[0], frequencies(poles, closed.period, _FEW)
        shares = closed.C @ vectors * into.T
        sums = 1 + shares @ (1 / (points(grid, closed.period) - poles[:, None]))
        near = [k for k, one in enumerate(np.abs(sums - 0.5).max(axis=1)) if one * _MAYBE * _LITTLE > 1]
        joints = tuple(closed.inputs[k] for k in near)
        found = sampled_margins(
            replace(closed, inputs=joints, B=closed.B[:, near], C=closed.C[near], D=closed.D[np.ix_(near, near)])
        )
    for joint, own in found.items():
        if own.stable and own.disk < _LITTLE:
            yield (
                f"the loop of drive {joint} has a disk margin of {own.disk:.2g} (0.5 is usual): a delay of "
                f"{1e3 * own.delay:.2g} ms more, or {degrees(abs(own.phase)):.2g} deg of phase, makes it ring up; "
                "see `tmodes linear --closed`"
            )


def _held(setup: RunSetup, state: Array, row: Array) -> StateSpace:
    """Sampled laws with something added to the newest command of each, at the place where the states hold it."""
    at = Instant(setup.planned, state, row, (), setup.model)
    bare, (whole, samples) = at.found(()), samples_of(at)
    clocks = [signal for signal, _ in at.plan.clocks]
    places = {one.plan.joint: _newest(setup, one) for one in setup.model.loop.drivers if one.plan.servo}
    once = {joint: place for joint, (place, clock) in places.items()
            if place >= 0 and sum(clocks.index(clock) in due for _, due, *_ in samples) == 1}  # fmt: skip
    n, m = len(bare.A), len(once)
    moved, added, computed = np.eye(n), np.zeros((n, m)), np.zeros((m, n + m))
    for length, due, by_state, _ in samples:
        moved, added = by_state @ moved, by_state @ added
        for k, (joint, place) in enumerate(once.items()):
            if clocks.index(places[joint][1]) in due:
                added[place, k] += 1.0
                computed[k] = [*moved[place], *added[place]]
        on, _ = zero_order_hold(bare.A, bare.B, length)
        moved, added = on @ moved, on @ added
    names, seen = tuple(once), setup.model.outputs
    volts = {one.joint: "voltage" for one in setup.planned.plan.drives if one.servo and one.servo.driven}
    units = {name: seen.find(f"{name}.{volts.get(name, 'effort')}", "loop").unit for name in names}
    return replace(bare, inputs=names, outputs=names, A=moved, B=added, C=computed[:, :n], D=computed[:, n:],
                   y0=bare.x0[[*once.values()]], units=units, period=whole)  # fmt: skip


def _opened(closed: StateSpace, k: int) -> StateSpace:
    """L where all of a command is what is added over 1 + L: its inverse, with the states of the open loop."""
    name, there, passed = (f"{closed.inputs[k]}.command",), closed.y0[[k]], closed.D[k, k]
    B, C = closed.B[:, [k]] / passed, closed.C[[k]]
    return replace(closed, inputs=name, outputs=name, units={name[0]: closed.units[closed.outputs[k]]},
                   A=closed.A - B @ C, B=B, C=-C, D=np.zeros((1, 1)), u0=there, y0=there)  # fmt: skip


def _newest(setup: RunSetup, driver: Driver) -> tuple[int, int]:
    """Where a state holds the last command that a sampled law computed for a joint, and its clock; -1: there is none.

    Behind a filter of continuous time that of the law before it.
    """
    loop, first = setup.model.loop, setup.model.layout.controls.start
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
