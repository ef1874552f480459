"""Any output of the robot as a measurement: tip position, current, gear torque, contact force."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.sensors.contract import SENSORS, Sensor

__all__ = ["OutputSensor"]


@SENSORS.register
class OutputSensor(Sensor):
    """An output by its name, as ``tmodes outputs`` lists it: ``tip.x``, ``shoulder.current``, ``contact.force.z``."""

    type: Literal["output"] = Field(description="kind of sensor")
    output: str = Field(min_length=1, max_length=200, description="name of the output, see tmodes outputs")

    @property
    def sources(self) -> tuple[str, ...]:
        """The output."""
        return (self.output,)

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """Its value."""
        return [seen[self.output]]
