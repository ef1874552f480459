"""Whether modes that a page found are the native ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

__all__ = ["SHAPE", "assert_same_modes"]

SHAPE = 2e-6
"""Bound of the displacements, whose largest is 1: both are kept in single precision, found by differences."""


def assert_same_modes(
    ours: Sequence[dict[str, Any]], native: Sequence[dict[str, Any]], equal: float, shape: float
) -> None:
    """Frequencies relative, damping of 1, shapes up to their phase."""
    assert [(one["case"], one["element"]) for one in ours] == [(one["case"], one["element"]) for one in native]
    info = {
        name: np.array([[one[name] for one in modes] for modes in (ours, native)]) for name in ("frequency", "damping")
    }
    worst = [
        np.abs(info["frequency"][0] / info["frequency"][1] - 1).max(),
        np.abs(np.diff(info["damping"], axis=0)).max(),
    ]
    assert max(worst) < equal
    every = native[0]["rest"].shape[1] // (ours[0]["rest"].shape[1] - 1)
    native = [{**mode, **{name: mode[name][:, ::every] for name in ("rest", "real", "imaginary")}} for mode in native]
    for own, true in zip(ours, native, strict=True):
        assert np.abs(own["rest"] - true["rest"]).max() < shape
        assert alike(own, true) > 1 - shape


def alike(own: dict[str, Any], true: dict[str, Any]) -> float:
    a, b = (np.ravel(mode["real"]) + 1j * np.ravel(mode["imaginary"]) for mode in (own, true))
    return float(np.abs(np.vdot(a, b)) / (np.linalg.norm(a) * np.linalg.norm(b)))
