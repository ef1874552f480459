"""What all kernels of one contact have in common: the contact, by whose structure and numbers they are known."""

from __future__ import annotations

from dataclasses import dataclass

from tmodes.equations.loop.contact_kernels import Touch

__all__ = ["OfTouch"]


@dataclass(frozen=True)
class OfTouch:
    """Kernels of one contact."""

    touch: Touch

    @property
    def key(self) -> str:
        """The structure in words."""
        return self.touch.key

    @property
    def size(self) -> int:
        """How many numbers the contact has."""
        return self.touch.size
