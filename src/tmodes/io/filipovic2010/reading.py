"""The readings of the paper's equations by name; apart from the format, so that a command line knows them at once."""

from __future__ import annotations

from enum import StrEnum

__all__ = ["Reading"]


class Reading(StrEnum):
    """Which reading of the paper's equations. ``docs/readings.md`` compares them with numbers."""

    PRINTED = "printed"
    CONSISTENT = "consistent"
