"""What a run warns of: joints that nothing drives, jumps, contact at the start, lost energy, limits."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import energy_sentence
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.signals.registry import MergedSchedule
from tmodes.sheet.robot import RECURSION
from tmodes.simulation.departure import departure
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.plan import WAYS

__all__ = ["departures", "jam_warnings", "jumps", "no_motion", "run_warnings", "start_warnings"]

Array = NDArray[np.float64]

_SAME = 1e-6
"""A difference smaller than this share of the largest value is rounding."""


def start_warnings(setup: RunSetup) -> list[str]:
    """What is odd before anything moves."""
    info = [f"joint {name} has no drive: it is held where it starts" for name in setup.planned.undriven]
    info += [f"joint {name} has no drive: it moves freely with its initial rate" for name in setup.planned.loose]
    info += _left_out(setup)
    info += _begun(setup)
    if setup.robot.contact:
        info += _touching(setup, setup.robot.contact)
    return info


def _begun(setup: RunSetup) -> Iterator[str]:
    """Motions that begin at once: their first rates are no rest."""
    plan, names = setup.planned.plan, setup.model.coordinates
    powers, rates, jolts = setup.planned.signals.coefficients[0], setup.start[setup.model.layout.v], dict(plan.jolts)
    for driver in setup.model.loop.drivers:
        joint, signal, rate = driver.plan.joint, driver.plan.signal, rates[driver.coordinate]
        unit = setup.model.outputs[f"{joint}.velocity"].unit
        if signal in jolts and (jump := powers[jolts[signal], 1]):
            what = f"joint {joint} begins with {jump:.4g} {unit} at t = 0, and gives what it carries an impulse"
            yield f"{what}; to begin otherwise, name the rates after it in `initial.rates`"
        elif driver.plan.servo is None and driver.part.motor >= 0 and rate and not rates[names.index(joint)]:
            what = f"the motor of joint {joint} begins with {rate:.4g} {unit} at t = 0, its load stands still"
            yield f"{what}; to let it move along, write `initial: {{rates: {{{joint}: {rate:.4g}}}}}`"


def departures(setup: RunSetup, row: Array) -> Iterator[str]:
    """That a start is no equilibrium at the signals of ``row`` (row,): what moves off, and how far the tip has to go.

    Of a drive that does not hold its joint, its effort and the one that would.
    """
    off, moved = setup.off if not setup.callback else None, departure(setup, row)
    if off is None and moved is None:
        return
    words, distance = [], off.distance if off else None
    if moved:
        distance = moved.distance if distance is None else distance
        what = f"link {moved.name} bends, the tip" if moved.bends else f"joint {moved.name}"
        words.append(f"{what} moves off with {moved.acceleration:.4g} {moved.unit}")
    if off:
        words.append(f"the drive of joint {off.joint} gives {off.given:.4g} {off.unit} where {off.needed:.4g} hold it")
    if distance is not None:
        words.append(f"the tip starts {distance * 1e3:.4g} mm from its equilibrium")
    if moved and moved.at_once:
        words.append("what is given to move begins at once: a smooth beginning (`type: quintic`) starts at rest")
    asked = " (initial.state: held)" if off and off.wanted else ""
    yield f"the start is no equilibrium{asked}: {'; '.join(words)}"


def _left_out(setup: RunSetup) -> Iterator[str]:
    """Initial values that the run does not have, because a drive gives the motion."""
    names, initial, layout = setup.model.coordinates, setup.robot.initial, setup.model.layout
    prescribed = {names[driver.coordinate] for driver in setup.model.loop.drivers if driver.plan.servo is None}
    for group, given, block in (("coordinates", initial.coordinates, layout.q), ("rates", initial.rates, layout.v)):
        for name, value in given.items():
            taken = float(setup.start[block][names.index(name)])
            if name in prescribed and abs(taken - value) > _SAME * max(abs(value), abs(taken)):
                yield f"initial.{group}.{name}: {value:g} is left out: its drive prescribes {taken:g} at t = 0"


def _touching(setup: RunSetup, sheet: Contact) -> Iterator[str]:
    seen = setup.model.observe(np.zeros(1), setup.start, setup.first_row)["contact"][0]
    moved = setup.start[setup.model.layout.surface][:1].sum()  # of a surface with mass
    yield from sheet.start_notices(float(seen[3]), float(seen[4] + moved))


def jumps(setup: RunSetup) -> str:
    """The first jump of a position or its rate that a rigid drive or the base would have to make; empty without any."""
    plan, signals = setup.planned.plan, setup.planned.signals
    rigid = [d for d in setup.model.loop.drivers if d.plan.servo is None and d.part.motor < 0]
    exact = {driver.plan.signal: f"the motion of joint {driver.plan.joint}" for driver in rigid}
    exact |= {k: f"the base's {name}" for k, name in zip(plan.base, WAYS, strict=False)}
    own = MergedSchedule(signals.knots, signals.coefficients[:, list(exact)])
    for derivative, name in ((0, "position"), (1, "rate")):
        for what, far in zip(exact.values(), own.gaps(derivative)[1].T, strict=True):
            if far.any():
                return f"{what} jumps in {name} at t = {signals.knots[1:][far.argmax()]:.6g} s"
    return ""


_NO_MOTION, _LEAST_ENERGY = 0.1, 1e-4
"""Share of the energy moved, and energy [J], by which the balance is off where a motion is none of the robot's."""


def no_motion(run: RunData) -> str:
    """Why a run that reached its end cannot be right: energy from nowhere. Empty where it may be.

    Systems of other energies than their motion's are not judged, and no motion that is given.
    """
    given = run.planned.plan.base or any(driver.plan.servo is None for driver in run.setup.model.loop.drivers)
    off, moved = float(np.abs(run.energy_balance).max()), run.energy_moved
    if given or run.chain.equations != RECURSION or off < max(_NO_MOTION * moved, _LEAST_ENERGY):
        return ""
    return f"the energy balance is off by {off:.3g} J where {moved:.3g} J were moved: no motion of this robot"


def run_warnings(run: RunData) -> list[str]:
    """Limits passed, a contact that jams, energy that does not add up; with the first time and the worst value."""
    flow = run.energy_moved, run.energy_there, run.robot.integration.energy_tolerance
    energy = energy_sentence(run.times, run.energy_balance, *flow, _cause(run))
    jammed = [] if run.contact_fold is None else jam_warnings(run.times, run.contact_fold)
    return [*([energy] if energy else []), *jammed, *_limits(run)]


def _cause(run: RunData) -> str:
    """Why energy is missing: at least half of it at a jump of a motor's position, or the integration."""
    off, signals = run.energy_balance, run.planned.signals
    far = signals.gaps()[1]
    for driver in run.setup.model.loop.drivers:
        if driver.plan.servo is not None or driver.part.motor < 0:
            continue
        jumps = signals.knots[1:-1][far[:, driver.plan.signal]]
        after = np.unique(np.clip(np.searchsorted(run.times, jumps), 1, len(run.times) - 1))
        if len(run.times) > 1 and 2 * np.abs(off[after] - off[after - 1]).sum() > np.abs(off).max():
            return (
                f"the motor of joint {driver.plan.joint} jumps in position at t = {jumps[0]:.6g} s, and what that does "
                "to its gear's spring and damper is not counted; move it in a short time"
            )
    return "the integration is too coarse; lower integration.relative_tolerance or integration.step"


def jam_warnings(time: Array, fold: Array) -> list[str]:
    """Contact whose friction and mass are so large that the forces have no, or two, answers (``contact_fold``)."""
    jammed = np.flatnonzero(fold <= 0)
    if not len(jammed):
        return []
    return [
        f"do not trust the motion from t = {time[jammed[0]]:.4g} s on: the contact jams first at "
        f"t = {time[jammed[0]]:.4g} s, and at {len(jammed)} samples in all: friction and the environment's mass are so "
        "large that the force has no single answer; lower the contact's friction or mass"
    ]


def _limits(run: RunData) -> Iterator[str]:
    for joint, own in ((each, name) for each in run.robot.joints for name in each.coordinates):
        limits = joint.limits
        if limits is None or own not in run.coordinates:
            continue
        place, unit = run.coordinates.index(own), joint.unit
        kinds = [
            ("position", unit, run.q[:, place], limits.lower, limits.upper),
            ("speed", f"{unit}/s", np.abs(run.v[:, place]), None, limits.speed),
        ]
        if own in run.drives:
            effort = np.abs(run.effort[:, run.drives.index(own)])
            kinds.append(("effort", "N" if unit == "m" else "N*m", effort, None, limits.effort))
        for kind, unit_of, values, lower, upper in kinds:
            low, high = -np.inf if lower is None else lower, np.inf if upper is None else upper
            beyond = np.flatnonzero((values < low) | (values > high))
            if len(beyond):
                worst = beyond[np.argmax(np.maximum(low - values[beyond], values[beyond] - high))]
                bound = low if values[worst] < low else high
                yield (
                    f"joint {own} passes its limit of {kind}, {bound:.6g} {unit_of}, first at "
                    f"t = {run.times[beyond[0]]:.4g} s, and reaches {values[worst]:.6g} {unit_of} "
                    f"at t = {run.times[worst]:.4g} s"
                )
