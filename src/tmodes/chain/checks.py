"""What must fit together in a robot once its chain is known: masses, and names of coordinates."""

from __future__ import annotations

from collections.abc import Iterator

from tmodes.chain.mass import massless_issues
from tmodes.kinds.controllers.contract import Controller
from tmodes.kinds.schema.quantity import Issue
from tmodes.sheet import Robot
from tmodes.sheet.checks import unknown_name

__all__ = ["chain_issues"]

_HINT = "take one of the coordinates that `tmodes describe --json` lists"


def chain_issues(robot: Robot) -> Iterator[Issue]:
    """Joints that move no mass, and coordinates that controllers and the initial state name and the robot has not."""
    if robot.equations == "recursion":
        yield from massless_issues(robot)
    if any(drive.controller and drive.controller.sees_all for drive in robot.drives) or robot.initial.names:
        yield from _names(robot, robot.chain().coordinates)


def _names(robot: Robot, known: tuple[str, ...]) -> Iterator[Issue]:
    for index, drive in enumerate(robot.drives):
        for name in dict.fromkeys(drive.controller.unknown(known) if drive.controller else ()):
            path = f"drives.{index}.controller{_inside(drive.controller, name)}"
            yield from unknown_name(path, name, known, _HINT, "coordinate")
    for group in ("coordinates", "rates"):
        for name in getattr(robot.initial, group):
            yield from unknown_name(f"initial.{group}.{name}", name, known, _HINT, "coordinate")


def _inside(controller: Controller | None, name: str) -> str:
    """Where in a controller's sheet a name stands; empty where it is no key of a group of it."""
    groups = ((key, getattr(controller, key)) for key in type(controller).model_fields) if controller else ()
    return next((f".{key}.{name}" for key, value in groups if isinstance(value, dict) and name in value), "")
