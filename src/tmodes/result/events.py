"""The events of a run in its record: series along the dimension ``event``, one number or word for each event."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from tmodes.simulation.event import KINDS, Event

if TYPE_CHECKING:
    from tmodes.result.series import Variables

__all__ = ["counted", "event_labels", "event_series", "read_events"]

_NUMBERS = {
    "event_time": ("s", "time of each event"),
    "event_speed": ("by event_unit", "speed at each event; 0 where there is none"),
    "event_direction": ("1", "of slip, of the teeth's side, of the limit: 1 or -1, or 0 where there is none"),
}
_WORDS = {
    "event_kind": f"what happened: {', '.join(KINDS)}",
    "event_place": "the contact, coordinate, gear, or stop condition",
    "event_unit": "unit of the speed; empty where there is none",
}


def event_series(events: Sequence[Event]) -> Variables:
    """The numbers of events; nothing where nothing happened."""
    values = {"event_time": [event.time for event in events], "event_speed": [event.speed or 0.0 for event in events],
              "event_direction": [float(event.direction) for event in events]}  # fmt: skip
    found = {name: (("event",), np.array(values[name]), unit, text) for name, (unit, text) in _NUMBERS.items()}
    return found if events else {}


def event_labels(events: Sequence[Event]) -> dict[str, Any]:
    """Their words, as labels along the dimension; nothing where nothing happened."""
    fields = {name: [getattr(event, name.removeprefix("event_")) for event in events] for name in _WORDS}
    return {name: ("event", fields[name], {"long_name": text}) for name, text in _WORDS.items() if events}


def read_events(record: Any) -> tuple[Event, ...]:
    """The events of a record; none of one that an earlier version wrote."""
    if "event_time" not in record:
        return ()
    names = ("time", "kind", "place", "speed", "unit", "direction")
    rows = zip(*(record[f"event_{name}"].values.tolist() for name in names), strict=True)
    return tuple(
        Event(time, kind, place, speed if unit else None, unit, int(way))
        for time, kind, place, speed, unit, way in rows
    )


def counted(events: Iterable[Event]) -> str:
    """How many there are of each kind, in words."""
    found = Counter(event.kind for event in events)
    return ", ".join(f"{found[kind]:,} {kind}" for kind in KINDS if found[kind])
