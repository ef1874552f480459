"""Accelerometer and gyro at a point, along the axes of its section."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.sensors.contract import SENSORS, Port, Sensor

__all__ = ["Accelerometer", "Gyro"]

_AXES = ("x", "y", "z")


class _Inertial(Sensor):
    """At a point, along its axes."""

    point: str = Field(default="tip", min_length=1, max_length=100, description="point that it is on")

    _of: ClassVar[str] = ""

    @property
    def sources(self) -> tuple[str, ...]:
        """What it measures, along the axes of the point."""
        return tuple(f"{self.point}.{self._of}.{axis}" for axis in _AXES)

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """The same."""
        return [seen[name] for name in self.sources]


@SENSORS.register
class Accelerometer(_Inertial):
    """Acceleration less gravity, as an accelerometer feels it: at rest 9.81 m/s^2 upwards."""

    ports: ClassVar[tuple[Port, ...]] = tuple(Port(axis, "m/s^2") for axis in _AXES)
    _of: ClassVar[str] = "proper_acceleration"

    type: Literal["accelerometer"] = Field(description="kind of sensor")


@SENSORS.register
class Gyro(_Inertial):
    """Angular velocity."""

    ports: ClassVar[tuple[Port, ...]] = tuple(Port(axis, "rad/s") for axis in _AXES)
    _of: ClassVar[str] = "body_rate"

    type: Literal["gyro"] = Field(description="kind of sensor")
