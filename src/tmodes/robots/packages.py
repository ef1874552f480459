"""Robots that other packages hold: where the installed package of models is, for the sheets published here."""

from __future__ import annotations

from importlib import metadata
from pathlib import Path

__all__ = ["MODELS", "installed_models"]

MODELS = "example-robot-data"
"""The package of models that published elasticity files stand on (the extra ``robots``)."""


def installed_models() -> tuple[Path, ...]:
    """The folder of the models of :data:`MODELS`, or nothing where it is not installed."""
    try:
        place = Path(str(metadata.distribution(MODELS).locate_file(f"cmeel.prefix/share/{MODELS}")))
    except metadata.PackageNotFoundError:
        return ()
    return (place,) if place.is_dir() else ()
