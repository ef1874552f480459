"""What a person writes in a sheet of the 2010 robot: motor, gear, link of two modes, payload, environment, control."""

from __future__ import annotations

from enum import StrEnum
from functools import partial
from typing import Annotated, Literal

from pydantic import Field, model_validator

from tmodes.integrate.settings import RobotIntegration
from tmodes.io.filipovic2010.reading import Reading
from tmodes.kinds.links.registry import Mode
from tmodes.kinds.schema.quantity import DataSheet, any_sign, dissipation, not_negative, plain_texts, positive, refuse
from tmodes.sheet.parts import by_name
from tmodes.sheet.task import accepted_error

__all__ = ["FORMAT", "PLANT", "Format2010", "PaperFrictionLaw"]

FORMAT = 1
"""Version of the data sheet's format."""

PLANT = ("gravity", "motor", "gear", "link", "payload", "environment", "controller")
"""The groups of which a number may differ in the actual robot."""

TURN = 6.3
"""A full turn [rad], a little rounded up."""

_angle = partial(any_sign, "rad", at_least=-1e3, at_most=1e3, plausible=(-TURN, TURN))
_FACTOR = not_negative("-", "-", "factor of the actual robot on the known value", at_most=1e6)


class PaperFrictionLaw(StrEnum):
    """How the normal force enters friction: ``signed`` mu Fc, as the formula stands, or ``magnitude`` mu |Fc|."""

    SIGNED = "signed"
    MAGNITUDE = "magnitude"


class PaperMotor(DataSheet):
    """A DC motor with its reducer, every quantity referred to the output side of the reducer (S = 1)."""

    resistance: float = positive("ohm", "R", "armature resistance", plausible=(1e-3, 1e3))
    back_emf_constant: float = positive("V*s/rad", "CE", "back electromotive force constant, after the reducer")
    torque_constant: float = positive("N*m/A", "CM", "torque constant, after the reducer")
    inertia: float = positive("kg*m^2", "I", "rotor inertia, reflected after the reducer", plausible=(1e-6, 1e4))
    friction: float = dissipation("N*m*s/rad", "Bm", "viscous friction of the motor, after the reducer")


class PaperGear(DataSheet):
    """An elastic gear after the reducer. ``stiffness: .inf`` makes it rigid."""

    stiffness: float = positive(
        "N*m/rad", "Cxi", "torsional stiffness of the gear, after the reducer", rigid=True, plausible=(1.0, 1e9)
    )
    damping: float = dissipation("N*m*s/rad", "Bxi", "torsional damping of the gear, after the reducer")


class FlexibleLink(DataSheet):
    """The flexible link: its modes from root to tip. The equations of this paper hold for two."""

    modes: tuple[Mode, Mode] = Field(strict=False, description="the modes from root to tip")


class Payload(DataSheet):
    """Mass and rotary inertia at the tip; zero is a bare tip."""

    mass: float = not_negative("kg", "m", "mass at the tip", plausible=(0.0, 1e4))
    inertia: float = not_negative("kg*m^2", "Jzz", "rotary inertia at the tip, both planes", plausible=(0.0, 1e3))


class Environment(DataSheet):
    """Mass, damping, preload and stiffness along the radius from the base point, and friction across it."""

    mass: float = not_negative("kg", "me", "mass of the environment that moves with the tip's radius")
    damping: float = dissipation("N*s/m", "be", "damping along the radius")
    preload: float = any_sign("N", "Fc_o", "force at zero radial deviation; positive presses outwards")
    stiffness: float = positive("N/m", "ka1", "stiffness along the radius")
    friction: float = not_negative("-", "mu", "friction coefficient, along the tip's velocity", at_most=10.0)
    friction_velocity: float = positive("m/s", "veps", "speed below which friction is smoothed", plausible=(1e-6, 0.1))
    friction_law: PaperFrictionLaw = Field(
        default=PaperFrictionLaw.SIGNED, strict=False, description="how the normal force enters friction"
    )


class PaperController(DataSheet):
    """Proportional-derivative control of the motor angle."""

    position_gain: float = not_negative("V/rad", "Klp", "position gain")
    velocity_gain: float = not_negative("V*s/rad", "Klv", "velocity gain")


class PaperNoise(DataSheet):
    """Noise on the reference as the controller receives it; none by default.

    To the controller, an error of the sensor is the same with the other sign.
    """

    deviation: float = not_negative("rad", "sigma", "standard deviation of the values", default=0.0, at_most=1e3)
    frequency: float = positive("Hz", "f", "highest frequency", default=100.0, plausible=(1e-3, 1e4))
    seed: int = not_negative("-", "seed", "same seed, same noise", default=0, at_most=2**53)


class PaperReference(DataSheet):
    """The motor's reference angle: rest to rest with constant acceleration, speed and deceleration."""

    start: float = _angle(symbol="theta_o(0)", meaning="motor angle at the start")
    end: float = _angle(symbol="theta_o(T)", meaning="motor angle at the end")
    duration: float = positive("s", "T", "duration of the move", at_most=1e5, smallest=1e-6)
    ramp_fraction: float = positive(
        "-", "ramp", "share of the duration that each ramp takes", at_most=0.5, smallest=1e-6
    )
    noise: PaperNoise = Field(default_factory=PaperNoise)


class PaperTask(DataSheet):
    """What the motion must keep to: by it the verdict on a run is good or bad."""

    tolerance: float = accepted_error()


class Format2010(DataSheet):
    """A robot's data sheet: motor, elastic gear, flexible link, payload, environment, control and reference motion."""

    format: Literal[1] = Field(description="version of this format [-]")
    name: str = Field(min_length=1, max_length=100, description="name of the robot")
    title: str = Field(default="", max_length=300, description="what it is, in one line")
    citation: str = Field(default="", max_length=1000, description="where its numbers come from")
    reading: Reading = Field(
        default=Reading.CONSISTENT, strict=False, description="which reading of the paper's equations"
    )
    contact: bool = Field(description="true: the tip presses on the environment; false: free space")
    gravity: float = not_negative("m/s^2", "g", "gravity, along -z", default=9.81, plausible=(0.0, 30.0))
    motor: PaperMotor
    gear: PaperGear
    link: FlexibleLink
    payload: Payload
    environment: Environment
    controller: PaperController
    reference: PaperReference
    real: dict[str, Annotated[float, _FACTOR]] = by_name(
        "-", "-", "the actual robot where it differs from the known one: path of a number -> factor on it [-]"
    )
    task: PaperTask | None = Field(
        default=None, description="what the motion must keep to; none: errors are not judged"
    )
    integration: RobotIntegration = Field(default_factory=RobotIntegration)

    @model_validator(mode="after")
    def _plain_text(self) -> Format2010:
        """Texts go to terminals and pages: letters that steer those are refused."""
        refuse(plain_texts({name: getattr(self, name) for name in ("name", "title", "citation")}))
        return self
