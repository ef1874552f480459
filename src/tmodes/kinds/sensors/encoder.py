"""An encoder: position of a motor or a joint in steps."""

from __future__ import annotations

from collections.abc import Mapping
from enum import StrEnum
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.sensors.contract import SENSORS, Port, Sensor

__all__ = ["Encoder", "Side"]


class Side(StrEnum):
    """Of which side of the gear; without an elastic gear there is only the joint's."""

    MOTOR = "motor"
    JOINT = "joint"


@SENSORS.register
class Encoder(Sensor):
    """Position of the motor (joint side of the reducer) or of the joint."""

    ports: ClassVar[tuple[Port, ...]] = (Port("", "rad|m"),)

    type: Literal["encoder"] = Field(description="kind of sensor")
    joint: str = Field(min_length=1, max_length=100, description="which joint")
    side: Side = Field(default=Side.MOTOR, strict=False, description="motor (before the elastic gear) or joint")

    @property
    def sources(self) -> tuple[str, ...]:
        """The coordinate; ``JOINT.motor`` stands for the joint itself where its gear is rigid."""
        return (f"{self.joint}.motor.position" if self.side is Side.MOTOR else f"{self.joint}.position",)

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """The position."""
        return [seen[self.sources[0]]]
