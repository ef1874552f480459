"""The named outputs of a robot, and the stop conditions on them: of its sheet, and its limits."""

from __future__ import annotations

from collections.abc import Iterator

from tmodes.equations.loop.outputs import DISTANCES, Output, Outputs
from tmodes.io.arguments import checked_arguments
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned
from tmodes.simulation.stops import Stop, Stops, resolved

__all__ = ["refuse_wrong_stops", "robot_outputs", "run_stops"]


@checked_arguments
def robot_outputs(robot: Robot) -> Outputs:
    """All outputs of the actual robot in a run, :class:`tmodes.equations.loop.outputs.Output` by name.

    Each has a ``name``, a ``unit`` and a ``meaning``; ``rows`` lists them. Nothing is compiled.

    Raises :class:`tmodes.errors.InputError` for a robot that cannot run.

    >>> tmodes.outputs(tmodes.load("spong1987"))["tip.speed"].unit
    'm/s'
    """
    refuse_other(robot)
    return Outputs(LoopModel(planned(robot.pair().real).plan).loop, tuple(DISTANCES))


def run_stops(setup: RunSetup, more: tuple[str, ...] = ()) -> Stops:
    """The stop conditions of a robot's sheet, ``more`` of them, and its limits where they end a run.

    Raises :class:`tmodes.errors.InputError` as :func:`tmodes.simulation.stops.resolved`.
    """
    return _stops_of(setup.robot, setup.model, more)


def refuse_wrong_stops(robot: Robot) -> None:
    """Refuse what :func:`run_stops` refuses, without a state to start from; nothing is compiled for it.

    Raises :class:`tmodes.errors.InputError`.
    """
    if robot.integration.stop:
        _stops_of(robot, LoopModel(planned(robot).plan), ())


def _stops_of(robot: Robot, model: LoopModel, more: tuple[str, ...]) -> Stops:
    settings = robot.integration
    if not (settings.stop or more or settings.stop_at_limits):
        return Stops()
    limits = tuple(_limits(robot, model)) if settings.stop_at_limits else ()
    return Stops((*resolved(settings.stop, model), *resolved(more, model, "stop"), *limits), model)


def _limits(robot: Robot, model: LoopModel) -> Iterator[Stop]:
    """The limits of joints. One is passed where it is by more than the tolerance: a joint may rest at its limit."""
    settings = robot.integration
    for joint, own in ((each, name) for each in robot.joints for name in each.coordinates):
        limits = joint.limits
        if limits is None:
            continue
        kinds = (
            ("position", limits.lower, False, False), ("position", limits.upper, True, False),
            ("velocity", limits.speed, True, True), ("effort", limits.effort, True, True),
        )  # fmt: skip
        for kind, limit, above, size in kinds:
            output: Output | None = model.outputs.get(f"{own}.{kind}")
            if limit is None or output is None:
                continue
            margin = settings.absolute_tolerance + settings.relative_tolerance * max(1.0, abs(limit))
            name = f"abs({own}.{kind})" if size else f"{own}.{kind}"
            text = f"limit of {own}: {name} {'>' if above else '<'} {limit:.9g} {output.unit}"
            yield Stop(text, name, output, limit + margin if above else limit - margin, above, size)
