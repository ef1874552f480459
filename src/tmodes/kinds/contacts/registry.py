"""The contact laws and surfaces that tmodes brings; ``@CONTACTS.register`` and ``@SURFACES.register`` add more."""

from __future__ import annotations

from tmodes.kinds.contacts.contract import CONTACTS, SURFACES, Contact, Meeting, Surface

__all__ = ["CONTACTS", "SURFACES", "Contact", "Meeting", "Surface"]

SURFACES.bring("tmodes.kinds.contacts", {"ball": "ball", "plane": "plane", "wall": "plane"})
CONTACTS.bring(
    "tmodes.kinds.contacts",
    {
        "dynamic_environment": "dynamic_environment", "bilateral": "spring_damper", "unilateral": "spring_damper",
    },
)  # fmt: skip
