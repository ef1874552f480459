"""What is computed of a run after it, each number by itself: one that fails takes neither the run nor another along."""

from __future__ import annotations

import json
import os
import traceback
from collections.abc import Callable
from functools import cached_property
from typing import TYPE_CHECKING, Any, TypeVar

from tmodes.errors import TmodesError

if TYPE_CHECKING:
    from tmodes.io.labelled import Record

__all__ = ["INTERRUPTED", "NOT_YET", "Derives", "derived", "failed_in", "is_unfinished", "sentences"]

T = TypeVar("T")

INTERRUPTED = "interrupted before it was computed; the same command again computes it"
NOT_YET = "the program ended before it was computed; the same command again computes it"

_WORDS = {
    "lines": "elastic lines of the links", "paths": "tip error by cause", "frequencies": "frequencies",
    "end_frequencies": "modes at the end", "settling": "settling", "vibration": "residual vibration",
    "vibration.nominal": "residual vibration of the nominal run", "errors": "error of the integration",
    "vibration.elements": "elements of the residual vibration",
    "vibration.nominal.elements": "elements of the residual vibration of the nominal run",
    "model_errors": "error of the link models", "elements": "tip error by element", "checks": "checks of the models",
    "move_end": "end of the move", "events": "list of events",
    "headline": "errors of the point that stands for the tip",
}  # fmt: skip
"""The numbers in words."""


class Derives:
    """Base of what computes numbers of a run.

    ``failed``: why those that could not be computed are not there, by their names; ``stopped``: why no further one is
    computed.
    """

    stopped = ""

    @cached_property
    def failed(self) -> dict[str, str]:
        """Reasons by the names of what could not be computed."""
        return {}

    def attempt(self, name: str, compute: Callable[[], T], without: Callable[[str], T]) -> T:
        """What ``compute`` gives; where it fails, what ``without`` has in its place, for a reason in words."""
        if not self.stopped:
            try:
                return compute()
            except Exception as error:
                self.failed[name] = _reason(error)
        else:
            self.failed[name] = self.stopped
        return without(self.failed[name])


def derived(name: str, without: Callable[[Any, str], Any]) -> Callable[[Callable[[Any], T]], cached_property[T]]:
    """A cached property that may fail: it is then what ``without(self, reason)`` gives."""

    def wrapped(compute: Callable[[Any], T]) -> cached_property[T]:
        def guarded(self: Any) -> T:
            return self.attempt(name, lambda: compute(self), lambda reason: without(self, reason))

        guarded.__doc__ = compute.__doc__
        return cached_property(guarded)

    return wrapped


def _reason(error: Exception) -> str:
    if os.environ.get("TMODES_DEBUG"):
        traceback.print_exception(error)
    if isinstance(error, TmodesError):
        return str(error)
    if isinstance(error, MemoryError):
        return "memory does not suffice"
    return f"a fault of tmodes itself, please report it: {type(error).__name__}: {error}"


def failed_in(data: Record) -> dict[str, str]:
    """What could not be computed of a stored run, and why."""
    return json.loads(data.attrs.get("not_computed", "{}"))


def is_unfinished(data: Record) -> bool:
    """Whether the same command again would compute more of a stored run."""
    return bool({INTERRUPTED, NOT_YET} & {*failed_in(data).values()})


def sentences(failed: dict[str, str]) -> list[str]:
    """What could not be computed, as warnings; what failed for the same reason together."""
    together: dict[str, list[str]] = {}
    for name, reason in failed.items():
        together.setdefault(reason, []).append(_WORDS.get(name, name))
    return [f"not computed: {', '.join(names)}: {reason}" for reason, names in together.items()]
