"""A strain gauge on the surface of a flexible link."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.block import Measured
from tmodes.kinds.schema.quantity import Issue, any_sign, quantity
from tmodes.kinds.sensors.contract import SENSORS, Port, Sensor

__all__ = ["StrainGauge"]


@SENSORS.register
class StrainGauge(Sensor):
    """Strain along the link at a station, at the place (y, z) of the section: kappa_y z - kappa_z y."""

    ports: ClassVar[tuple[Port, ...]] = (Port("", "1"),)

    type: Literal["strain_gauge"] = Field(description="kind of sensor")
    link: str = Field(min_length=1, max_length=100, description="which flexible link")
    at: float = quantity("-", "s", "station: 0 root, 1 tip", at_least=0.0, at_most=1.0)
    y: float = any_sign("m", "y", "place of the gauge across the section", default=0.0)
    z: float = any_sign("m", "z", "place of the gauge across the section", default=0.0)

    def _issues(self) -> Iterator[Issue]:
        yield from super()._issues()
        if self.y == 0 and self.z == 0:
            hint = "give half the thickness of the section, such as `y: 0.002`"
            yield Issue(
                "y", "0, with z 0", "a place off the middle of the section, which bending does not strain", hint
            )

    @property
    def _axes(self) -> dict[str, float]:
        """Curvature -> its factor."""
        found = {"y": self.z, "z": -self.y}
        return {f"{self.link}.curvature.{axis}@{self.at:.15g}": value for axis, value in found.items() if value}

    @property
    def sources(self) -> tuple[str, ...]:
        """The curvatures there."""
        return tuple(self._axes)

    def numbers(self) -> tuple[float, ...]:
        """Those of every sensor, then the factors."""
        return (*super().numbers(), *self._axes.values())

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Curvatures times places."""
        first = len(super().numbers())
        seen = {name: p[first + k] * m.signals[name] for k, name in enumerate(self._axes)}
        return super().command(p, replace(m, signals={**m.signals, **seen}), x)

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """Their sum."""
        first, *rest = (seen[name] for name in self._axes)
        return [first + rest[0] if rest else first]
