"""What happened at an instant of a run, in plain terms."""

from __future__ import annotations

from dataclasses import dataclass

__all__ = ["KINDS", "Event"]

KINDS = ("touch", "release", "stick", "slip", "engage", "disengage", "limit", "stop")
"""Kinds of events: of a contact, of dry friction, of the teeth of a gear with play, of a joint, of the run."""


@dataclass(frozen=True)
class Event:
    """Something that happened at a ``time`` [s].

    ``place``: the contact, a coordinate, a gear (``elbow.gear``), or the stop condition. ``speed`` in ``unit``, a
    magnitude: of a touch that of approach, of a release that of the point along the normal; of what sticks or slips
    that of sliding; of teeth and of a limit that of the gear's deflection and of the joint. None at a stop.
    ``direction``: of a coordinate that begins to slip 1 or -1; of teeth 1 where the motor is ahead, else -1; of a limit
    1 for the upper one, -1 for the lower; 0 of anything else.
    """

    time: float
    kind: str
    place: str
    speed: float | None = None
    unit: str = ""
    direction: int = 0
