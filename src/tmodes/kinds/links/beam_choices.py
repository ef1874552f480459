"""What may be chosen of a link that bends: its model, its functions, and which inertia counts."""

from __future__ import annotations

from enum import StrEnum

__all__ = ["Basis", "BeamModel", "RotaryInertia"]


class BeamModel(StrEnum):
    """The ladder of models of one link."""

    STRAIN = "strain"
    SEGMENTS = "segments"
    RIGID = "rigid"


class Basis(StrEnum):
    """The bending functions of a strain link; ``auto`` is ``legendre``.

    ``tip_weighted``: for a free end on which forces act, but no moment.
    """

    AUTO = "auto"
    LEGENDRE = "legendre"
    TIP_WEIGHTED = "tip_weighted"


class RotaryInertia(StrEnum):
    """Which rotary inertia of the sections counts: none, about the line (``twist``), or about all axes (Rayleigh).

    ``auto``: about all axes of a link with functions of shear (Timoshenko), about the line of any other.
    """

    AUTO = "auto"
    NONE = "none"
    TWIST = "twist"
    FULL = "full"
