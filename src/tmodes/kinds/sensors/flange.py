"""A force and torque sensor in a flexible link: what one side of a section does to the other."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.schema.quantity import quantity
from tmodes.kinds.sensors.contract import SENSORS, Port, Sensor

__all__ = ["Flange"]

_PARTS = {
    "force.x": ("axial", "N"), "force.y": ("shear.y", "N"), "force.z": ("shear.z", "N"),
    "moment.x": ("torsion", "N*m"), "moment.y": ("moment.y", "N*m"), "moment.z": ("moment.z", "N*m"),
}  # fmt: skip


@SENSORS.register
class Flange(Sensor):
    """Force and moment in a section of a link, along the axes of the section."""

    ports: ClassVar[tuple[Port, ...]] = tuple(Port(name, unit) for name, (_, unit) in _PARTS.items())

    type: Literal["flange"] = Field(description="kind of sensor")
    link: str = Field(min_length=1, max_length=100, description="which flexible link")
    at: float = quantity("-", "s", "station: 0 root, 1 tip", at_least=0.0, at_most=1.0, default=1.0)

    @property
    def sources(self) -> tuple[str, ...]:
        """The inner forces there."""
        return tuple(f"{self.link}.{output}@{self.at:.15g}" for output, _ in _PARTS.values())

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """Their values."""
        return [seen[name] for name in self.sources]
