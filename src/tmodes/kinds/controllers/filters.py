"""Filters of one signal: notch, low pass, lead and lag, in continuous time or sampled."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, ClassVar, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, OwnState, Port
from tmodes.kinds.kernel import vectors
from tmodes.kinds.noted import functions as noted
from tmodes.kinds.schema.quantity import Issue, positive, quantity

__all__ = ["LeadLag", "LowPass", "Notch"]

_TURN = 6.283185307179586


class _Filter(Controller):
    """y = H(s) u, H = (b0 s^n + ... + bn)/(s^n + a1 s^(n-1) + ... + an), s in units of the filter's own rate w0.

    Sampled: s = (z - 1)/((z + 1) tan(w0 T/2)), Tustin's rule that keeps H at w0 (K. J. Astrom, B. Wittenmark,
    Computer-Controlled Systems, 3rd ed., section 8.3); states are those of the transposed direct form.
    """

    ports: ClassVar[tuple[Port, ...]] = (Port(),)

    input: str = Field(min_length=1, max_length=200, description="signal that it filters: a block, a sensor, an output")
    frequency: float = positive("Hz", "f0", "its own frequency, w0/(2 pi)", plausible=(1e-3, 1e5))
    sample_time: float | None = positive(
        "s", "T", "time between samples; none: at every instant", default=None, plausible=(1e-5, 1.0)
    )

    def _issues(self) -> Iterator[Issue]:
        if self.sample_time is not None and self.frequency * self.sample_time >= 0.5:
            got, hint = f"{self.frequency:g} Hz", "sample faster, or take a lower frequency"
            yield Issue("frequency", got, f"below half of the {1 / self.sample_time:g} samples a second", hint)

    def _transfer(self) -> tuple[list[Any], list[Any]]:
        """Numerator b0 ... bn and denominator 1, a1 ... an, of s/w0."""
        raise NotImplementedError

    @property
    def _order(self) -> int:
        return 2

    def system(self) -> tuple[Any, Any, Any, Any]:
        """A, B, C, D of H in continuous time: its controllable form."""
        (b0, *above), (_, *below) = self._transfer()
        n, rate = self._order, _TURN * self.frequency
        A = np.vstack([-np.array(below)[None], np.eye(n - 1, n)])
        return rate * A, rate * np.eye(n, 1), np.array([above]) - b0 * np.array([below]), np.array([[b0]])

    @property
    def reads(self) -> tuple[str, ...]:
        """The signal."""
        return (self.input,)

    @property
    def period(self) -> float | None:
        """T [s]."""
        return self.sample_time

    def numbers(self) -> tuple[Any, ...]:
        """Numerator and denominator without its 1, of s (then w0) or of z."""
        above, below = self._transfer()
        if self.sample_time is None:
            return (*above, *below[1:], _TURN * self.frequency)
        turned = _TURN / 2 * self.frequency * self.sample_time
        half = noted.sin(turned) / noted.cos(turned)
        above, below = (_tustin(one, half) for one in (above, below))
        return (*(b / below[0] for b in above), *(a / below[0] for a in below[1:]))

    def initial(self) -> tuple[float, ...]:
        """Nothing has come in."""
        return (0.0,) * self._order

    @property
    def states(self) -> tuple[OwnState, ...]:
        """Those of its canonical form."""
        return tuple(OwnState(f"filter{k + 1}") for k in range(self._order))

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The signal, filtered."""
        n, u = self._order, m.signals[self.input]
        if self.sample_time is not None:
            return [p[0] * u + x[0]]
        return [vectors.total([p[0] * u, *((p[k + 1] - p[0] * p[n + k + 1]) * x[k] for k in range(n))])]

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """w0 times those of the controllable form: the highest derivative first."""
        n, w0 = self._order, p[2 * self._order + 1]
        fed = vectors.total([p[n + k + 1] * x[k] for k in range(n)])
        return [w0 * (m.signals[self.input] - fed), *(w0 * x[k] for k in range(n - 1))]

    def updates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """Those of the transposed form."""
        n, u, y = self._order, m.signals[self.input], self.command(p, m, x)[0]
        return [p[k + 1] * u - p[n + k + 1] * y + (x[k + 1] if k + 1 < n else 0.0) for k in range(n)]

    @property
    def structure(self) -> str:
        """Its order, and what it reads, are part of the code."""
        return f"{super().structure} {self._order} {self.input}"


def _tustin(of: list[Any], half: Any) -> list[Any]:
    """A polynomial in s/w0, times (z + 1)^n half^n, in powers of z: s/w0 = (z - 1)/(half (z + 1))."""
    if len(of) == 2:
        c0, c1 = of[0], half * of[1]
        return [c0 + c1, c1 - c0]
    c0, c1, c2 = of[0], half * of[1], half * half * of[2]
    return [c0 + c1 + c2, 2.0 * (c2 - c0), c0 - c1 + c2]


@CONTROLLERS.register
class Notch(_Filter):
    """H = (s^2 + 2 d D s w0 + w0^2)/(s^2 + 2 D s w0 + w0^2): takes out f0, all of it at depth d = 0."""

    type: Literal["notch"] = Field(description="kind of controller")
    damping: float = positive("1", "D", "its damping ratio: half its width over f0", default=0.5, at_most=10.0)
    depth: float = quantity("1", "d", "what is left at f0", default=0.0, at_least=0.0, at_most=1.0)

    def _transfer(self) -> tuple[list[Any], list[Any]]:
        return [1.0, 2 * self.depth * self.damping, 1.0], [1.0, 2 * self.damping, 1.0]


@CONTROLLERS.register
class LowPass(_Filter):
    """H = w0/(s + w0), or w0^2/(s^2 + 2 D s w0 + w0^2) with a damping ratio D; 0.7071: Butterworth."""

    type: Literal["low_pass"] = Field(description="kind of controller")
    damping: float | None = positive("1", "D", "damping ratio; none: of first order", default=None, at_most=10.0)

    @property
    def _order(self) -> int:
        return 1 if self.damping is None else 2

    def _transfer(self) -> tuple[list[Any], list[Any]]:
        if self.damping is None:
            return [0.0, 1.0], [1.0, 1.0]
        return [0.0, 0.0, 1.0], [1.0, 2 * self.damping, 1.0]


@CONTROLLERS.register
class LeadLag(_Filter):
    """H = (1 + s sqrt(r)/w0)/(1 + s/(sqrt(r) w0)): leads most at f0 with r > 1, lags with r < 1; H(0) = 1."""

    type: Literal["lead_lag"] = Field(description="kind of controller")
    ratio: float = positive("1", "r", "pole over zero: above 1 leads, below 1 lags", at_most=1e6)

    @property
    def _order(self) -> int:
        return 1

    def _transfer(self) -> tuple[list[Any], list[Any]]:
        root = noted.sqrt(self.ratio)
        return [self.ratio, root], [1.0, root]
