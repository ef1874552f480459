"""How a run is integrated: settings, each with a sound default (numerics may have defaults, physics never)."""

from __future__ import annotations

from collections.abc import Iterator
from difflib import get_close_matches
from functools import partial
from typing import Annotated, Any, Self

from pydantic import (
    BeforeValidator,
    Field,
    SerializerFunctionWrapHandler,
    field_validator,
    model_serializer,
    model_validator,
)

from tmodes.errors import InputError
from tmodes.integrate.conditions import BAND, MOST, Band, Condition
from tmodes.integrate.method import Integrator
from tmodes.integrate.registry import AUTO, integrator, integrators
from tmodes.kinds.schema.quantity import DataSheet, Issue, positive, refuse

__all__ = ["LEAST_TOLERANCE", "MOST_BYTES", "Integration", "RobotIntegration", "refuse_stops", "refuse_too_large"]

MOST_BYTES = 1_800_000_000
"""Size of the largest result on disk [bytes]; gathering it takes about three times that in memory."""

LEAST_TOLERANCE = 1e-14
"""A relative tolerance below this is lost in the rounding of a step."""

_ROOM = 5.0
"""A relative tolerance over the least one, from which on a run with smaller tolerances is a more exact one."""


class Integration(DataSheet):
    """Which integrator, how exact, how long, how often the result is sampled.

    The integrator is chosen by the stiffness unless one is named.

    Slip (p. 70): T/dt with dt = 0.000053335 s is 37 498.8, no integer; the step here is 2/37500 s
    {test_slip_step_divides_the_move}
    """

    method: str = Field(
        default=AUTO,
        description="integrator; auto: chosen by the stiffness",
        json_schema_extra={"enum": [*integrators(), AUTO]},
    )
    duration: float = positive("s", "t_end", "simulated time", default=2.0, at_most=1e6, span=True)
    output_step: float = positive("s", "dt_out", "time between samples of the result", default=1e-3, span=True)
    line_points: int = positive(
        "-", "s", "points of each mode at which the elastic line is kept, its ends included", default=21, at_most=1001,
        smallest=2.0, span=True,
    )  # fmt: skip
    relative_tolerance: float = positive(
        "-", "rtol", "error allowed per step, relative (adaptive methods)", default=1e-9, at_most=1e-2, smallest=1e-13,
        span=True,
    )  # fmt: skip
    absolute_tolerance: float = positive(
        "rad", "atol", "error allowed per step, absolute (adaptive methods)", default=1e-12, at_most=1e-2,
        smallest=1e-18, span=True,
    )  # fmt: skip
    check_error: bool = Field(
        default=False,
        description="true: errors by a run with a hundredth of the tolerances (fixed step: a quarter), else a tenth",
    )
    error_estimate: bool = Field(
        default=True, description="true: run again with finer steps, for the error of the integration"
    )
    model_error: bool = Field(
        default=True, description="true: run again with links of another stiffness, for the error of their models"
    )
    settling_band: Annotated[str, BeforeValidator(str)] = Field(
        default=Band(BAND).words.removesuffix(" of the move"),
        description="how near to its rest the tip counts as settled: a share of its move, `0.1 %`, or `0.1 mm`",
    )
    step: float = positive("s", "dt", "fixed step (rk4, midpoint)", default=2 / 37500, span=True)
    energy_tolerance: float = positive(
        "-", "etol", "residual of the energy balance over the energy moved that is warned of", default=1e-6, span=True,
    )  # fmt: skip
    stop: tuple[str, ...] = Field(
        default=(), strict=False, max_length=MOST,
        description="stop conditions, such as `[tip.z < 0 m]`: the run ends where the first of them triggers",
    )  # fmt: skip
    energy_stop: bool = Field(default=False, description="true: end the run where that residual is first exceeded")
    max_steps: int = positive(
        "-", "steps", "steps after which a run gives up", default=200_000_000, at_most=10**12, span=True
    )
    max_wall_time: float = positive(
        "s", "wall", "seconds of computing after which a run gives up", default=3600.0, span=True
    )

    @field_validator("stop", mode="before")
    @classmethod
    def _one_is_a_list_of_one(cls, value: Any) -> Any:
        return (value,) if isinstance(value, str) else value

    @model_serializer(mode="wrap")
    def _as_given(self, write: SerializerFunctionWrapHandler) -> dict[str, Any]:
        """Tolerances that were left out are left out again: the method that is chosen has its own."""
        left_out = {"relative_tolerance", "absolute_tolerance"} - self.model_fields_set
        return {name: value for name, value in write(self).items() if name not in left_out}

    @model_validator(mode="after")
    def _fits_together(self) -> Self:
        refuse([*self._method_issues(), *self._sampling_issues(), *self._stepping_issues(), *self._stop_issues()])
        return self

    def _method_issues(self) -> Iterator[Issue]:
        known = [*integrators(), AUTO]
        if self.method not in known:
            close = get_close_matches(self.method, known, 1)
            hint = f"did you mean `{close[0]}`?" if close else "correct the name"
            yield Issue("method", repr(self.method), f"one of {', '.join(known)}", hint)

    @property
    def integrator(self) -> Integrator | None:
        """The method; None while the stiffness is to choose it."""
        return integrators().get(self.method)

    def _stop_issues(self) -> Iterator[Issue]:
        checks = [partial(Condition.parsed, text, f"stop.{place}") for place, text in enumerate(self.stop)]
        for check in (*checks, partial(Band.parsed, self.settling_band, "settling_band")):
            try:
                check()
            except InputError as error:
                yield Issue(error.which, error.got, error.expected, error.hint)

    def _sampling_issues(self) -> Iterator[Issue]:
        samples, most_samples = self.duration / self.output_step, MOST_BYTES / self.bytes_per_sample
        if self.line_points < 2:
            yield Issue("line_points", str(self.line_points), "at least 2, the ends", "21 shows every bend")
        if self.output_step > self.duration:
            most = f"at most integration.duration, {self.duration!r} [s]"
            yield Issue("output_step", repr(self.output_step), most, "lengthen the duration or sample more often")
        elif samples > most_samples:
            got = f"{self.output_step!r}, that is {self._size(samples)}"
            least = f"{1.005 * self.duration / most_samples:.3g} s"
            hint = f"write at least {least}, a shorter duration, or fewer line_points"
            yield Issue("output_step", got, f"long enough for at most {self._size(most_samples)}", hint)

    def _stepping_issues(self) -> Iterator[Issue]:
        one = self.integrator
        if one is None:
            return
        if one.adaptive and self.relative_tolerance < one.least_tolerance:
            least = f"at least {one.least_tolerance:g} for {one.name}, whose rounding is larger than that of others"
            yield Issue("relative_tolerance", repr(self.relative_tolerance), least, "take dop853, or rosenbrock")
        if one.adaptive:
            return
        steps = self.duration / self.step
        if self.step > self.duration:
            most = f"at most integration.duration, {self.duration!r} [s]"
            yield Issue("step", repr(self.step), most, "write a shorter step")
        elif steps > self.max_steps:
            got, most = (
                f"{self.step!r}, that is {steps:.3g} steps",
                f"long enough for at most max_steps, {self.max_steps} steps",
            )
            hint = f"write at least {self.duration / self.max_steps:.3g} s, or raise max_steps"
            yield Issue("step", got, most, hint)

    def refined(self) -> tuple[Self, float]:
        """The settings of a second run that checks this one, and the error of this one over the difference of both.

        A tenth of the tolerances, whose error is a tenth as large, or half the step, whose error is 1/2^order of it; by
        ``check_error`` a hundredth and a quarter. Where rounding leaves no tenth of the relative tolerance, the second
        run is the coarser one, at the tenfold.
        """
        times, one = 2 if self.check_error else 1, self.integrator
        least = one.least_tolerance if one else LEAST_TOLERANCE
        factor = 10.0**-times if self.relative_tolerance >= _ROOM * least else 10.0
        less = 2.0 ** (-times * one.order) if one and not one.adaptive else factor
        changed = self.model_copy(update={
            "relative_tolerance": max(self.relative_tolerance * factor, least), "step": self.step / 2**times,
            "absolute_tolerance": self.absolute_tolerance * factor, "max_steps": 4**times * self.max_steps,
        })  # fmt: skip
        return changed, 1.0 / (1.0 - less) if less < 1 else 1.0

    def quick(self) -> Self:
        """The settings of a run that is compared with this one, to a hundredth of a larger difference."""
        loose = {name: 100 * getattr(self, name) for name in ("relative_tolerance", "absolute_tolerance")}
        return self.model_copy(update={name: min(value, 1e-5) for name, value in loose.items()})

    def chosen(self, method: str) -> Self:
        """The settings with the integrator that is taken, and with its own tolerances where none are given."""
        one = integrator(method)
        own = {name: value for name, value in one.tolerances.items() if name not in self.model_fields_set}
        return self.model_copy(update={"method": method, **own})

    @property
    def bytes_per_sample(self) -> int:
        """Size of one sample of a result [bytes]: its series, and thirteen numbers at each point of both lines."""
        return 600 + 2 * 13 * 8 * self.line_points

    def _size(self, samples: float) -> str:
        return f"{samples:.3g} samples, about {samples * self.bytes_per_sample / 1e9:.3g} GB"


class RobotIntegration(Integration):
    """The same settings for a robot, whose joints may have limits."""

    stop_at_limits: bool = Field(
        default=False,
        description="true: end the run where a joint first passes one of its limits; else it is warned of",
    )


def refuse_too_large(settings: Integration, samples: float, each: int, others: str) -> None:
    """Refuse ``samples`` of ``each`` bytes that are more than memory is meant for.

    ``others`` names what helps besides a longer output step. Raises :class:`tmodes.errors.InputError`.
    """
    if samples * each <= MOST_BYTES:
        return
    least = 1.005 * settings.duration * each / MOST_BYTES
    raise InputError(
        "integration.output_step",
        f"{settings.output_step!r}, that is {samples:.3g} samples, about {samples * each / 1e9:.3g} GB",
        f"long enough for at most {MOST_BYTES / each:.3g} samples of {each} bytes, {MOST_BYTES / 1e9:.3g} GB",
        f"write at least {least:.3g} s, {others}",
    )


def refuse_stops(settings: Integration, what: str) -> None:
    """Refuse stop conditions where runs must reach their end: ``what`` does, in words.

    Raises :class:`tmodes.errors.InputError`.
    """
    asked = {"stop": list(settings.stop), "stop_at_limits": getattr(settings, "stop_at_limits", False)}
    for name, value in asked.items():
        if value:
            hint = f"leave `{name}` out, or run by itself: tmodes run"
            raise InputError(f"integration.{name}", repr(value), f"left out: {what} to the end of integration", hint)
