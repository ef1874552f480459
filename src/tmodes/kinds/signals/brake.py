"""The largest torque of a brake that is released and engaged at given times."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Literal

import numpy as np
from pydantic import Field

from tmodes.kinds.noted.functions import array
from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.signals.contract import SIGNALS, Signal, signal_time, signal_value
from tmodes.kinds.signals.schedule import SignalPieces

__all__ = ["Brake"]


@SIGNALS.register
class Brake(Signal):
    """``torque`` while the brake is engaged, else 0: released once, engaged once, each after its own delay.

    Without both times it is engaged throughout; with ``engage_at`` alone it is released before.
    """

    type: Literal["brake"] = Field(description="kind of signal")
    torque: float = signal_value("T_b", "largest torque of the engaged brake", at_least=0)
    engaged_until: float | None = signal_time("t_r", "when it is to release; none: see `engage_at`", default=None)
    engage_at: float | None = signal_time("t_e", "when it is to engage; none: never again", default=None)
    release_delay: float = signal_time("t_dr", "from the command until it releases", default=0.0)
    engage_delay: float = signal_time("t_de", "from the command until it engages", default=0.0)

    def _issues(self) -> Iterator[Issue]:
        if self.engaged_until is not None and self.engage_at is not None and self.engage_at <= self.engaged_until:
            expected = f"a time after `engaged_until`, {self.engaged_until:g} s"
            yield Issue("engage_at", f"{self.engage_at:g} s", expected, "exchange the two, or leave one out")

    def pieces(self, until: float) -> SignalPieces:
        """A piece for each time in which it is engaged or released; without one that its delay leaves no time for."""
        engaged = self.engaged_until is not None or self.engage_at is None
        times, levels = [0.0], [self.torque if engaged else 0.0]
        changes: list[tuple[Any, Any]] = []
        if self.engaged_until is not None:
            changes.append((self.engaged_until + self.release_delay, 0.0))
        if self.engage_at is not None:
            changes.append((self.engage_at + self.engage_delay, self.torque))
        if len(changes) > 1 and not changes[0][0] < changes[1][0]:
            changes = []  # it is to engage before it has released
        for time, level in changes:
            if time <= 0:
                levels = [level]
            elif time < until:
                times.append(time)
                levels.append(level)
        return SignalPieces(array([*times, until]), array(np.array(levels)[:, None]))
