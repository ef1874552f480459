"""Feed-forward: efforts over time on top of what another law commands."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any, Literal

from pydantic import Field

from tmodes.kinds.controllers.contract import CONTROLLERS, Controller, Measured, Port
from tmodes.kinds.schema.quantity import Issue
from tmodes.kinds.signals.registry import Signal

__all__ = ["FeedForward"]


@CONTROLLERS.register
class FeedForward(Controller):
    """u_k = the signal ``inputs[k]`` + ``signals[k]``, in the unit of that command, for each drive in their order."""

    type: Literal["feed_forward"] = Field(description="kind of controller")
    inputs: tuple[str, ...] = Field(
        strict=False, min_length=1, description="commands that it adds to, such as `law.elbow`, or `law` of one drive"
    )
    signals: tuple[Signal, ...] = Field(strict=False, description="what is added to each over time [N*m or N, or V]")

    def _issues(self) -> Iterator[Issue]:
        if len(self.signals) != len(self.inputs):
            expected = f"{len(self.inputs)}, one for each of `inputs`"
            yield Issue("signals", f"{len(self.signals)} signals", expected, "write one for each, in the same order")

    @property
    def ports(self) -> tuple[Port, ...]:  # pyright: ignore[reportIncompatibleVariableOverride]
        """One for each command, named as its joint."""
        several = len(self.inputs) > 1
        return tuple(Port(name.rpartition(".")[2] if several else "") for name in self.inputs)

    @property
    def given(self) -> Mapping[str, Any]:
        """What is added to each command."""
        return {f"{name}.feed_forward": signal for name, signal in zip(self.inputs, self.signals, strict=True)}

    @property
    def reads(self) -> tuple[str, ...]:
        """The commands, and what is added."""
        return (*self.inputs, *self.given)

    def numbers(self) -> tuple[float, ...]:
        """None."""
        return ()

    def command(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        """The sums."""
        del p, x
        return [m.signals[name] + m.signals[f"{name}.feed_forward"] for name in self.inputs]

    @property
    def structure(self) -> str:
        """What it reads is part of the code."""
        return f"{super().structure} {self.inputs}"
