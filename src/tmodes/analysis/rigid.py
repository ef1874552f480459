"""The robot as known with rigid gears and links, as control laws compute with it."""

from __future__ import annotations

from tmodes.equations.loop.rigid_terms import RigidModel
from tmodes.errors import InputError
from tmodes.kinds.noted.functions import array, isinf
from tmodes.sheet import Robot
from tmodes.sheet.robot import RECURSION

__all__ = ["driven_joints", "nominal_of", "rigid_model"]


def driven_joints(robot: Robot) -> tuple[str, ...]:
    """The joints of a plan's drives, in their order."""
    return tuple(axis.name for axis in robot.undriven.chain().axes if axis.drive.is_driven)


def rigid_model(robot: Robot, drives: tuple[str, ...]) -> RigidModel:
    """The robot as known, with rigid gears and links, as laws compute with it; ``drives``: joints in their order.

    Raises :class:`tmodes.errors.InputError` for a joint that moves and has no drive.
    """
    known = nominal_of(robot)
    for index, drive in enumerate(known.drives):
        if not drive.command.is_motion:
            expected = "`position`, or `prescribed`: a law computes with the setpoints of all joints"
            raise InputError(f"drives.{index}.command", f"`{drive.command}`", expected, "give this joint a motion")
    links = tuple(
        link.model_copy(update={"beam": link.beam.variant("rigid", None)}) if link.beam else link
        for link in known.links
    )
    joints = tuple(joint.model_copy(update={"gear": None}) for joint in known.joints)
    stiff = known.model_copy(update={"links": links, "joints": joints, "drives": (), "equations": RECURSION})
    chain, axes = stiff.chain(), {axis.name: axis for axis in known.undriven.chain().axes}
    if left := [axis.name for axis in chain.axes if axis.name not in drives and axis.drive.takes_effort]:
        expected = "a drive for each joint that moves, because a law computes with the rigid robot"
        raise InputError("drives", f"no drive for {', '.join(left)}", expected, "add drives, or lock these joints")
    rows = []
    for name in drives:
        motor, gear = axes[name].joint.motor, axes[name].joint.gear
        stiffness = gear.stiffness[0] if gear and not isinf(gear.stiffness[0]) else 0.0
        rows.append((motor.inertia if motor else 0.0, motor.friction.viscous if motor else 0.0, stiffness))
    return RigidModel.of(chain, drives, array(rows))


def nominal_of(robot: Robot) -> Robot:
    """The robot as it is known, of one as it really is; itself where it is known so."""
    return vars(robot).get("nominal") or robot
