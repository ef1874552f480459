"""Settings of a run by the names of the command line, as changes of a sheet."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError

if TYPE_CHECKING:
    from tmodes.sheet import Robot

__all__ = ["integration_changes", "prepared", "run_changes"]


def integration_changes(**options: Any) -> dict[str, Any]:
    """Options by their names under ``integration`` as changes by path, without those that are not given."""
    return {f"integration.{name}": value for name, value in options.items() if not (value is None or value is False)}


def run_changes(
    *,
    integrator: str | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    check_error: bool = False,
    error_estimate: bool = True,
    model_error: bool = True,
    duration: float | None = None,
    stop: str | Sequence[str] | None = None,
    stop_at_limits: bool = False,
    settling_band: str | float | None = None,
) -> dict[str, Any]:
    """The options of a run as changes by path."""
    conditions = [stop] if isinstance(stop, str) else list(stop or ())
    changes = integration_changes(
        method=integrator, relative_tolerance=rtol, absolute_tolerance=atol, duration=duration,
        check_error=check_error, stop=conditions or None, stop_at_limits=stop_at_limits, settling_band=settling_band,
    )  # fmt: skip
    left_out = {"error_estimate": error_estimate, "model_error": model_error}
    return changes | {f"integration.{name}": False for name, wanted in left_out.items() if not wanted}


def prepared(
    robot: Robot,
    reading: str | None = None,
    contact: bool | None = None,
    changes: Mapping[str, Any] | None = None,
    *,
    stop_at_limits: bool = False,
) -> Robot:
    """The robot with changes by path, its reading of the 2010 paper's equations, and in contact or not.

    Raises :class:`tmodes.errors.InputError` for what the robot does not have.
    """
    limited = any(joint.limits for joint in robot.joints)
    refusals: tuple[tuple[Any, ...], ...] = (
        (
            reading is not None and not robot.imported, "--reading", reading or "",
            "left out: only sheets of the 2010 robot have a reading",
            "remove it; `equations` chooses those of another robot",
        ),
        (
            contact and not (robot.contact or robot.contact_off), "--contact", "a robot that touches nothing",
            "given for a robot with a contact", "add it to the sheet",
        ),
        (
            stop_at_limits and not limited, "--stop-at-limits",
            f"the robot {robot.name}, which has none", "given for a robot whose joints have limits",
            "leave it out; --stop ends a run at a value of your choice",
        ),
    )  # fmt: skip
    for wrong, *words in refusals:
        if wrong:
            raise InputError(*words)
    own: dict[str, Any] = {"reading": reading, "contact": contact}
    own = {**(changes or {}), **{name: value for name, value in own.items() if value is not None}}
    return robot.with_(own) if own else robot
