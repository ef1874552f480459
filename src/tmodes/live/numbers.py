"""All numbers that a run of a sheet is given, in one vector with named blocks: parameters, signals, start."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import without_elasticity
from tmodes.analysis.quasistatic import deflections, gross_motion
from tmodes.equations.loop.closed_loop import ClosedLoop
from tmodes.kinds.noted.functions import array
from tmodes.live.places import line_lengths, load_places, vibration_numbers
from tmodes.model.model import Model
from tmodes.model.passes import ChainPasses
from tmodes.sheet import Robot
from tmodes.simulation.initial_state import held_at_start, placed_state, undeformed
from tmodes.simulation.loop import Blocks, LoopModel, loop_numbers
from tmodes.simulation.plan import Follow, planned

__all__ = ["follow_of", "has_reference", "run_numbers", "whole_moves"]

Array = NDArray[np.float64]


def follow_of(nominal: Robot, run: str) -> Follow:
    """How drives follow their signals; in the nominal run as :func:`tmodes.simulation.simulate.simulate_motion`."""
    return Follow.WANTED if run == "reference" and _commanded(nominal) else Follow.SHEET


def has_reference(nominal: Robot) -> bool:
    """Whether a run has a nominal run, jumps aside, as in :mod:`tmodes.simulation.simulate`."""
    return _commanded(nominal) or bool(nominal.real)


def _commanded(nominal: Robot) -> bool:
    return any(drive.command.is_controlled for drive in nominal.drives)


def run_numbers(robot: Robot, follow: Follow, until: float, stations: tuple[float, ...] = ()) -> Blocks:
    """``parameters``; those of its rest (``rest``, ``rest_row``), of its passes (``chain``), and its rotors' inertias.

    ``start``: its first state, with nothing bent; ``gravity``, and the rows of a base without it and with it (``base``,
    ``weight``); ``deflections``, and coordinates without elasticity (``straight``), by the coordinates, constants in
    the last column.

    ``knots.k`` and ``coefficients.k`` of each signal of the plan; moves with a duration of their own extend to
    ``until`` [s], beyond the end of the run, to be whole. With ``stations``: ``line``, of the lines of all links, with
    the ``lengths`` of those that bend, ``surface``, what is touched, the ``gross`` motion by the coordinates, and the
    blocks of :func:`tmodes.live.places.vibration_numbers`.
    """
    chain = robot.model_copy(update={"drives": ()}).chain()
    plan, rest = (planned(robot, each, like=chain, whole=until) for each in (follow, Follow.HELD))
    loop, model = ClosedLoop(plan.plan), Model(chain)
    held = held_at_start(robot, LoopModel(plan.plan))
    found = loop_numbers(loop, rest) | {
        "chain": model.parameters, "rotors": _rotors(loop), "gravity": array(chain.gravity),
        "base": model.at_rest(gravity=0.0), "weight": model.at_rest(), "deflections": _affine(deflections, model),
        "straight": _affine(without_elasticity, model),
        "start": placed_state(robot, plan, LoopModel(plan.plan), undeformed(tuple(loop.parts.names), held)),
    }  # fmt: skip
    if stations:
        found["gross"] = _affine(gross_motion, model)
        loaded = bool(plan.plan.loads or plan.plan.touch)
        lines = model.passes.lines(tuple(load_places(chain, robot.integration.line_points)), loaded=loaded)
        found |= {"line": lines.numbers, "lengths": line_lengths(lines)}
        found |= vibration_numbers(robot, plan.plan, model)
        if robot.contact:
            found["surface"] = array(robot.contact.shape.moving_numbers())
    for k, piece in enumerate(plan.pieces):
        found |= {f"knots.{k}": piece.knots, f"coefficients.{k}": piece.coefficients}
    return found


def _affine(function: Callable[[Model, Array], Array], model: Model) -> Array:
    """Matrix and constant (numbers, coordinates + 1) of an affine function of coordinates."""
    rows = function(model, np.concatenate([np.zeros((1, model.nq)), np.eye(model.nq)]))
    return np.concatenate([rows[1:] - rows[0], rows[:1]]).T


def _rotors(loop: ClosedLoop) -> Array:
    """Inertia of the rotors along each coordinate, those that follow their signals among them."""
    rotors = ChainPasses(loop.mechanics).rotor_inertias.copy()
    for driver in loop.drivers:
        motor = driver.part.node.joint.motor
        if driver.part.given >= 0 and motor:
            rotors[driver.part.angle] += motor.inertia
    return rotors


def whole_moves(robot: Robot, reach: float) -> float:
    """Time [s] at which every move is at its end, though its duration be ``reach`` times as long."""
    moves = [drive.signal for drive in robot.drives] + [load.signal for load in robot.loads if load.signal]
    ends = [end for move in moves if (end := move.move_ends(reach)) is not None]
    return 1.0 + max([robot.integration.duration, *ends])
