"""The modes of a robot as its data sheet states it: about its rest, for each thing that its motors may do."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import asdict
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.describe.describe import NOTHING_MOVES, link_states
from tmodes.analysis.describe.links import pose_notices
from tmodes.analysis.modes.closed_loop import feedback_of, is_network
from tmodes.analysis.modes.modes import (
    LinearServo,
    MotorState,
    VibrationMode,
    closed_loop_poles,
    modes_about,
    moving_coordinates,
)
from tmodes.analysis.modes.shapes import assigned
from tmodes.analysis.quasistatic import loose_gears
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.analysis.statics.path import Progress
from tmodes.chain.chain import Motor
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet

__all__ = ["frequencies_about", "servos_of", "sheet_frequencies", "vibrations"]

Array = NDArray[np.float64]

CONVERGED = 0.01
"""Share by which a frequency may change with more functions."""

MOST_CHECKED = 60
"""Coordinates up to which a robot is compared with a finer one."""

MOST_WORK = 20_000
"""Work of compiling that one, as :attr:`tmodes.kinds.links.contract.LinkStructure.work`, up to which it is done."""

ALIKE = 0.3
"""Likeness (modal assurance) from which two modes are the same motion."""

_FREQUENCY = (
    "frequency_Hz", "damped_frequency_Hz", "undamped_frequency_Hz", "damping_ratio", "time_constant_s", "pole",
    "element", "share", "stable",
)  # fmt: skip
"""What is kept of a mode where its shape does not matter."""


class Vibrations(NamedTuple):
    """``states``: modes for each state of the motors; ``links``: whether the model of each holds; ``warnings``.

    ``poles``: all eigenvalues under control [1/s], real and imaginary part, those of the controllers among them.
    """

    states: dict[str, list[dict[str, Any]]]
    links: list[dict[str, Any]]
    warnings: list[str]
    poles: list[tuple[float, float]]
    motors: bool
    """Whether there are motors that could turn; without any there is only the state ``locked``."""


def frequencies_about(robot: Robot, rest: Equilibrium, *only: str) -> dict[str, list[dict[str, Any]]]:
    """Natural frequencies and damping about a known rest, for each state of the motors, or ``only`` some of them.

    Shapes are left out.
    """
    states = _states(robot, rest, lambda stage, share: None, only)
    return {
        state: [{key: getattr(mode, key) for key in _FREQUENCY} for mode in modes] for state, modes in states.items()
    }


def sheet_frequencies(robot: Robot, *, contact: bool = True) -> dict[str, list[dict[str, Any]]]:
    """The same about the rest or the steady motion of a data sheet; ``contact``: in contact where it has one.

    Errors as of :func:`tmodes.analysis.statics.at_rest.robot_rest`.
    """
    return frequencies_about(robot, robot_rest(robot, contact=contact, moving=True))


def vibrations(
    robot: Robot,
    *,
    contact: bool = False,
    held: Mapping[str, float | str] | None = None,
    progress: Progress = lambda stage, share: None,
) -> Vibrations:
    """Modes for each state of the motors about the rest under its loads, and whether the links' models hold there.

    About the steady motion of drives at constant speed, else about rest; driven coordinates at ``held`` [rad, m], else
    at their first command.

    ``controlled`` is there only where a drive has a controller. Errors as of
    :func:`tmodes.analysis.statics.at_rest.robot_rest`.

    ``frequency_error`` of a mode: by which share its undamped frequency is higher than with four more functions a
    direction, None where that is not known (more than 60 coordinates, many bodies inside a beam, segments, modes
    without a partner);
    ``converged``: within 1 %.
    """
    how = {"contact": contact, "held": held, "moving": True, "progress": progress}
    rest = robot_rest(robot, **how)
    states = _states(robot, rest, progress)
    info = {state: [_plain(mode, rest) for mode in modes] for state, modes in states.items()}
    fine_robot = finer(robot)
    large = fine_robot is not None and (rest.model.nq > MOST_CHECKED or _work(fine_robot) > MOST_WORK)
    fine_robot = None if large else fine_robot
    fine = robot_rest(fine_robot, **how) if fine_robot else None
    others = _states(_without_full_feedback(robot), fine, progress) if fine else {}
    for state, modes in states.items():
        errors = frequency_errors(rest, modes, fine, others[state]) if fine and state in others else [None] * len(modes)
        for row, error in zip(info[state], errors, strict=True):
            row |= {"frequency_error": error, "converged": None if error is None else abs(error) <= CONVERGED}
    return Vibrations(info, link_states(rest), _notices(robot, rest, info, large), _poles(robot, rest), len(info) > 1)


def _without_full_feedback(robot: Robot) -> Robot:
    """Without controllers that may see the whole state: one may be made for just the coordinates that it has."""
    if is_network(robot) or any(drive.controller and drive.controller.sees_all for drive in robot.drives):
        return robot.model_copy(update={"drives": ()})
    return robot


def _poles(robot: Robot, rest: Equilibrium) -> list[tuple[float, float]]:
    servos = servos_of(robot, rest.model)
    found = closed_loop_poles(rest, servos, feedback_of(robot, rest)) if servos else ()
    return [(float(value.real), float(value.imag)) for value in found]


def _states(
    robot: Robot, rest: Equilibrium, progress: Progress, only: Sequence[str] = ()
) -> dict[str, list[VibrationMode]]:
    servos, feedback = servos_of(robot, rest.model), feedback_of(robot, rest)
    locked, free = (moving_coordinates(rest, state, {}) for state in (MotorState.LOCKED, MotorState.FREE))
    turns = len(free) > len(locked)  # else a motor that is free has nothing to turn
    states = [MotorState.LOCKED, *([MotorState.FREE] * turns), *([MotorState.CONTROLLED] if servos else [])]
    states = [state for state in states if not only or str(state) in only]
    found = {}
    for k, state in enumerate(states):
        progress("modes", k / len(states))
        found[str(state)] = modes_about(rest, state, servos, feedback)
    return found


def _work(robot: Robot) -> int:
    """What the code of its different links is in length."""
    links = (node.link for node in robot.chain().nodes if node.link.bends)
    return sum(structure.work for structure in {one.numbers(one.stations()).structure for one in links})


def _notices(robot: Robot, rest: Equilibrium, info: dict[str, list[dict[str, Any]]], large: bool) -> list[str]:
    found = [] if rest.model.nq else [f"no modes: {NOTHING_MOVES}"]
    found += [*pose_notices(robot, rest)]
    found += [
        f"the gear of {name} is within its play of {play:.3g} either side here: neither spring nor damper acts; for "
        "modes with its teeth pressed together give a load or a pose that presses them"
        for name, play in loose_gears(rest.model, rest.q).items()
    ]
    if large:
        found.append(
            "whether the modes are converged was not checked: the robot with four more functions a direction is too "
            "large for that; compare with more `functions` where it matters"
        )
    if any(row["converged"] is False for modes in info.values() for row in modes):
        found.append(
            f"modes marked `!` are not converged: with four more functions a direction their frequencies change by "
            f"more than {CONVERGED:.0%}; take more functions where they matter"
        )
    return found


def servos_of(robot: Robot, model: Model) -> dict[str, LinearServo]:
    """The controllers of a data sheet as springs and dampers of the coordinates that they keep.

    Where more than these controls it, all coordinates that drives move, of some without spring and damper.
    Volts become torque by CM/R, and the back electromotive force damps: Eq. (41) of Filipovic & Djuric 2010.
    """
    motors = {axis.name: axis.joint.motor for axis in model.chain.axes}
    found, every = {}, is_network(robot)
    for drive in robot.drives:
        names = [name for name in (f"{drive.joint}.motor", drive.joint) if name in model.coordinates]
        if drive.controller and names:
            gains = drive.controller.local_gains()
            found[names[0]] = _servo(motors.get(drive.joint), *gains)
        elif every and names and (drive.command.is_controlled or not drive.command.is_motion):
            found[names[0]] = LinearServo(0.0, 0.0)
    return found


def _servo(motor: Motor | None, position_gain: float, velocity_gain: float) -> LinearServo:
    if motor is None or motor.resistance is None:
        return LinearServo(position_gain, velocity_gain)
    per_volt = motor.torque_constant / motor.resistance
    return LinearServo(per_volt * position_gain, per_volt * (velocity_gain + motor.back_emf))


def _plain(mode: VibrationMode, rest: Equilibrium) -> dict[str, Any]:
    info = asdict(mode)
    del info["motion"]
    info["shape"] = dict(zip(rest.model.coordinates, mode.shape.tolist(), strict=True))
    return info


def finer(robot: Robot) -> Robot | None:
    """The robot with more functions; None where no link has any to which more could be added."""

    def refined(link: LinkSheet) -> LinkSheet:
        return link.model_copy(update={"beam": link.beam.finer()}) if link.beam else link

    links = tuple(refined(link) for link in robot.links)
    return None if links == robot.links else robot.model_copy(update={"links": links})


def frequency_errors(
    rest: Equilibrium, modes: Sequence[VibrationMode], fine: Equilibrium, fine_modes: Sequence[VibrationMode]
) -> list[float | None]:
    """By which share each frequency is higher than that of the finer robot's mode most like it; None where none is."""
    if not modes:
        return []
    ours, theirs = (np.array([mode.shape for mode in some]).T for some in (modes, fine_modes))
    ours = _embedding(rest.model, fine.model) @ ours
    alike = _likeness(ours, theirs, fine.matrices[0])
    found: list[float | None] = [None] * len(modes)
    for k, other in enumerate(assigned(alike).tolist()):
        own, exact = modes[k].undamped_frequency_Hz, fine_modes[other].undamped_frequency_Hz
        if other >= 0 and alike[k, other] > ALIKE and exact and own:
            found[k] = float(own / exact - 1)
    return found


def _embedding(model: Model, fine: Model) -> Array:
    """(fine.nq, nq): the motion of the finer robot in each coordinate of the robot."""
    found = np.array([[float(name == own) for own in model.coordinates] for name in fine.coordinates])
    for own, theirs in zip(model.parts.nodes, fine.parts.nodes, strict=True):
        if own.link and theirs.link:
            found[theirs.link.own, own.link.own] = own.node.link.embedding(theirs.node.link)
    return found


def _likeness(ours: Array, theirs: Array, mass: Array) -> Array:
    """Modal assurance by the mass matrix: 1 for the same motion."""
    sizes = [np.einsum("ik,ij,jk->k", x, mass, x) for x in (ours, theirs)]
    return (ours.T @ mass @ theirs) ** 2 / np.outer(*sizes)
