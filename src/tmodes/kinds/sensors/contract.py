"""Sensors: blocks that read outputs of the robot and give what is measured of them.

A sensor of a user's own is a class with the fields ``type`` and ``name``, and says what it reads and gives::

    @SENSORS.register
    class Tachometer(Sensor):
        ports: ClassVar[tuple[Port, ...]] = (Port("", "rad/s"),)
        type: Literal["tachometer"] = Field(description="kind of sensor")
        joint: str = Field(description="which joint")

        @property
        def sources(self):
            return (f"{self.joint}.velocity",)

        def value(self, seen):
            return [seen[f"{self.joint}.velocity"]]

Names of what it may read are those of ``tmodes outputs``. With a ``period`` it samples at the multiples of that period
and holds its value; without one it gives its value at every instant, or at the samples of what reads it. Outputs that
follow from accelerations and efforts (those of an accelerometer) are taken with the commands before the sample.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, ClassVar

from pydantic import Field

from tmodes.kinds.controllers.block import Block, Measured, Port
from tmodes.kinds.schema.quantity import Issue, any_sign, not_negative, positive, too_late

__all__ = ["NOISE", "SENSORS", "Port", "Sensor", "rounded"]

NOISE = "noise"
"""The signal with the noise of a port: ``NAME.noise1``."""

_UNIT_SPACING = 1.5 * 2.0**52
"""Doubles of this size are one apart: adding and taking it away rounds to a whole number."""


def rounded(x: Any, up: Any, down: Any) -> Any:
    """The nearest whole number, of two numbers that both are 1.5 * 2^52; its slope is 1, as that of what it rounds."""
    return (x + up) - down


class Sensor(Block, family="sensor", key="type"):
    """What measures an output of the robot."""

    ports: ClassVar[tuple[Port, ...]] = (Port(),)

    name: str = Field(min_length=1, max_length=100, description="name of the sensor, by which blocks read it")
    sample_time: float | None = positive(
        "s", "T", "time between its samples; none: it measures when it is read", default=None, plausible=(1e-5, 1.0)
    )
    delay: float = not_negative("s", "t_d", "from a sample to its value", default=0.0, at_most=10.0)
    resolution: float | None = positive("output", "Delta", "step of its value; none: exact", default=None)
    noise: float = not_negative("output", "sigma", "standard deviation of the noise of a sample", default=0.0)
    seed: int = not_negative("-", "seed", "same seed, same noise", default=0, at_most=2**53)
    bias: float = any_sign("output", "b", "constant error", default=0.0)

    @property
    def sources(self) -> tuple[str, ...]:
        """Names of the outputs that it reads."""
        raise NotImplementedError

    def value(self, seen: Mapping[str, Any]) -> list[Any]:
        """What an exact sensor gives, one for each port, of what it reads by name."""
        raise NotImplementedError

    def _issues(self) -> Iterator[Issue]:
        for name in ("delay", "noise"):
            if getattr(self, name) and self.sample_time is None:
                hint = "add `sample_time: 0.001`"
                yield Issue("sample_time", "nothing", f"a sample time, because `{name}` is given", hint)
        yield from too_late(self.delay, self.sample_time)

    @property
    def noises(self) -> tuple[str, ...]:
        """The signals with the noise of each port; none without noise."""
        return tuple(f"{self.name}.{NOISE}{k + 1}" for k in range(len(self.ports))) if self.noise else ()

    def noise_of(self, name: str) -> tuple[int, float]:
        """Seed and standard deviation of the noise of a port."""
        return self.seed + self.noises.index(name), self.noise

    @property
    def reads(self) -> tuple[str, ...]:
        """Outputs, and signals of noise."""
        return (*self.sources, *self.noises)

    @property
    def period(self) -> float | None:
        """Time between its samples [s]."""
        return self.sample_time

    @property
    def lag(self) -> float:
        """The delay [s]."""
        return self.delay

    def numbers(self) -> tuple[float, ...]:
        """The bias; with a resolution that, and what rounds."""
        steps = () if self.resolution is None else (self.resolution, _UNIT_SPACING, _UNIT_SPACING)
        return (self.bias, *steps)

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """What it measures: value, bias and noise, in steps."""
        del x
        found = []
        for k, exact in enumerate(self.value(m.signals)):
            value = exact + p[0]
            if self.noise and not m.at_rest:
                value = value + m.signals[self.noises[k]]
            stepped = self.resolution is not None and not m.at_rest
            found.append(p[1] * rounded(value / p[1], p[2], p[3]) if stepped else value)
        return found

    @property
    def structure(self) -> str:
        """What it reads is part of the code."""
        return f"{super().structure}{' stepped' * (self.resolution is not None)} {self.reads}"


SENSORS = Sensor.registry
"""Those of tmodes, and what a user registers: ``@SENSORS.register``."""
