"""The contact laws and surfaces that tmodes brings; ``@CONTACTS.register`` and ``@SURFACES.register`` add more."""

from __future__ import annotations

from tmodes.kinds.contacts import ball, dynamic_environment, plane, spring_damper
from tmodes.kinds.contacts.contract import CONTACTS, SURFACES, Contact, Meeting, Surface

__all__ = ["BUILT_IN", "CONTACTS", "SURFACES", "Contact", "Meeting", "Surface"]

BUILT_IN = (plane, ball, spring_damper, dynamic_environment)
"""The modules whose members are registered."""
