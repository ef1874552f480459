"""Accelerometer and gyro at a point, along the axes of its section."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.kernel import functions as f
from tmodes.kinds.sensors.contract import SENSORS, Port, Sensor

__all__ = ["Accelerometer", "Gyro"]

_AXES = ("x", "y", "z")


def _turned_back(seen: Mapping[str, Any], point: str, vector: list[Any]) -> list[Any]:
    """A vector of the world in the axes of a point: R^T v with R = Rz(yaw) Ry(pitch) Rx(roll)."""
    x, y, z = vector
    for angle, (a, b) in (("yaw", (0, 1)), ("pitch", (2, 0)), ("roll", (1, 2))):
        at = [x, y, z]
        c, s = f.cos(seen[f"{point}.{angle}"]), f.sin(seen[f"{point}.{angle}"])
        at[a], at[b] = c * at[a] + s * at[b], c * at[b] - s * at[a]
        x, y, z = at
    return [x, y, z]


class _Inertial(Sensor):
    """At a point, along its axes."""

    point: str = Field(default="tip", min_length=1, max_length=100, description="point that it is on")

    _of: ClassVar[str] = ""

    @property
    def _angles(self) -> tuple[str, ...]:
        return tuple(f"{self.point}.{angle}" for angle in ("roll", "pitch", "yaw"))

    @property
    def _vector(self) -> tuple[str, ...]:
        return tuple(f"{self.point}.{self._of}.{axis}" for axis in _AXES)


@SENSORS.register
class Accelerometer(_Inertial):
    """Acceleration less gravity, as an accelerometer feels it: at rest 9.81 m/s^2 upwards."""

    ports: ClassVar[tuple[Port, ...]] = tuple(Port(axis, "m/s^2") for axis in _AXES)
    _of: ClassVar[str] = "acceleration"

    type: Literal["accelerometer"] = Field(description="kind of sensor")

    @property
    def sources(self) -> tuple[str, ...]:
        """Acceleration and attitude of the point, and gravity."""
        return (*self._vector, *self._angles, *(f"gravity.{axis}" for axis in _AXES))

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """Along the axes of the point."""
        felt = [seen[name] - seen[f"gravity.{axis}"] for name, axis in zip(self._vector, _AXES, strict=True)]
        return _turned_back(seen, self.point, felt)


@SENSORS.register
class Gyro(_Inertial):
    """Angular velocity."""

    ports: ClassVar[tuple[Port, ...]] = tuple(Port(axis, "rad/s") for axis in _AXES)
    _of: ClassVar[str] = "angular_velocity"

    type: Literal["gyro"] = Field(description="kind of sensor")

    @property
    def sources(self) -> tuple[str, ...]:
        """Angular velocity and attitude of the point."""
        return (*self._vector, *self._angles)

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """About the axes of the point."""
        return _turned_back(seen, self.point, [seen[name] for name in self._vector])
