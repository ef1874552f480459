"""The rungs of the ladder: one robot with each model of its links."""

from __future__ import annotations

from collections.abc import Iterator

from tmodes.chain.chain import Axis, Chain
from tmodes.errors import InputError
from tmodes.sheet import Robot
from tmodes.sheet.parts import LinkSheet
from tmodes.sheet.robot import RECURSION

__all__ = ["SEGMENTS", "driven", "rungs", "whole_chain"]

SEGMENTS = (1, 2, 3)
"""Numbers of segments, and of modes, that are tried."""


def rungs(robot: Robot, finest: int) -> Iterator[tuple[str, Robot]]:
    """Name and robot of every rung, from rigid to ``strain(finest)``; directions that do not bend stay so.

    ``modes`` are there where every beam is straight and bends alike in both planes.

    Raises :class:`tmodes.errors.InputError` for a robot without a beam, or with one that has no other model.
    """
    if not any(link.beam for link in robot.links):
        hint = "give a link a `beam`; without one there is only one model"
        raise InputError("links", "no link with a beam", "at least one link that can bend", hint)
    yield "rigid", _with_beams(robot, "rigid", None)
    for count in SEGMENTS:
        yield f"segments({count})", _with_beams(robot, "segments", count)
    for count in SEGMENTS:
        if all(link.beam is None or link.beam.variant("modes", count) for link in robot.links):
            yield f"modes({count})", _with_beams(robot, "modes", count)
    for count in range(1, finest + 1):
        yield f"strain({count})", _with_beams(robot, "strain", count)


def _with_beams(robot: Robot, model: str, count: int | None) -> Robot:
    """The robot with another model of every beam, by the recursion: a system's energies are those of its own links."""

    def changed(link: LinkSheet) -> LinkSheet:
        if link.beam is None:
            return link
        beam = link.beam.variant(model, count)
        if beam is None:
            expected, hint = f"a link that can also be modelled as `{model}`", "describe it as one beam"
            raise InputError(f"links.{link.name}.beam", link.beam.description, expected, hint)
        return link.model_copy(update={"beam": beam})

    return robot.model_copy(update={"links": tuple(map(changed, robot.links)), "equations": RECURSION})


def whole_chain(robot: Robot) -> Chain:
    """The chain of a robot with all its motors, whatever its drives prescribe."""
    return robot.model_copy(update={"drives": ()}).chain()


def driven(chain: Chain) -> list[Axis]:
    """Coordinates that a motor or an effort moves, in the order of the chain."""
    return [axis for axis in chain.axes if axis.drive.takes_effort]
