"""Linear feedback of the whole state, as an LQR gives it."""

from __future__ import annotations

from typing import Annotated, Any, ClassVar, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured
from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.schema.quantity import LARGEST

__all__ = ["StateFeedback"]

_Gain = Annotated[float, Field(ge=-LARGEST, le=LARGEST)]


def _gains(unit: str, symbol: str, meaning: str) -> Any:
    extra = {"unit": unit, "symbol": symbol, "smallest": 0.0, "plausible": None}
    return Field(default_factory=dict, description=f"{meaning} [{unit}]", json_schema_extra=extra)


@CONTROLLERS.register
class StateFeedback(Controller):
    """u = u0 + sum of Kq (reference - q) + Kv (reference' - v) over coordinates by name.

    The reference of a drive's own coordinates (of its joint, too, behind an elastic gear) is its signal; that of all
    other coordinates is ``rest`` (0 where none is given).
    """

    sees_all: ClassVar[bool] = True
    tuned: ClassVar[tuple[str, ...]] = ("position_gains", "velocity_gains")

    type: Literal["state_feedback"] = Field(description="kind of controller")
    position_gains: dict[str, _Gain] = _gains("gain", "Kq", "gain on the position of a coordinate, by its name")
    velocity_gains: dict[str, _Gain] = _gains("gain*s", "Kv", "gain on the rate of a coordinate, by its name")
    rest: dict[str, _Gain] = _gains("coordinate", "q_r", "value of a coordinate at rest, by its name")
    feedforward: _Gain = Field(
        default=0.0,
        description="constant command [command]",
        json_schema_extra={"unit": "command", "symbol": "u_0", "smallest": 0.0, "plausible": None},
    )

    @property
    def _coordinates(self) -> tuple[str, ...]:
        return tuple(dict.fromkeys([*self.position_gains, *self.velocity_gains]))

    def numbers(self) -> tuple[float, ...]:
        """u0, and (Kq, Kv, rest) of each coordinate."""
        of = self._coordinates
        terms = ((self.position_gains.get(n, 0.0), self.velocity_gains.get(n, 0.0), self.rest.get(n, 0.0)) for n in of)
        return (self.feedforward, *(number for term in terms for number in term))

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        """As above."""
        del x
        setpoints = dict(zip(m.drives, m.setpoints, strict=True))
        terms = [p[0]]
        for k, name in enumerate(self._coordinates):
            position, velocity = m.coordinate(name)
            wanted = setpoints.get(name.removesuffix(".motor"), [p[3 + 3 * k], 0.0, 0.0])
            terms += [p[1 + 3 * k] * (wanted[0] - position), p[2 + 3 * k] * (wanted[1] - velocity)]
        return v.total(terms)

    def unknown(self, coordinates: tuple[str, ...]) -> list[str]:
        """Names that are no coordinates of the robot."""
        return [name for name in (*self._coordinates, *self.rest) if name not in coordinates]

    @property
    def structure(self) -> str:
        """Which coordinates are fed back is part of the code."""
        return f"{super().structure} of {', '.join(self._coordinates)}"
