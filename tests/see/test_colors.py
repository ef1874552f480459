"""The colours of the figures are legible on white."""

from __future__ import annotations

import numpy as np

from tmodes.plot import style


def luminance(color: str) -> float:
    """Relative luminance of WCAG 2."""
    parts = np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


def contrast(one: str, other: str) -> float:
    """Contrast of WCAG 2, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_figures_are_legible() -> None:
    assert contrast(style.INK, style.PAPER) > 10
    assert contrast(style.QUIET, style.PAPER) > 4.5
    curves = {look["color"] for look in (style.REAL, style.REFERENCE, *style.COMPONENTS, *style.INSTANTS)}
    assert min(contrast(color, style.PAPER) for color in curves) > 3.5
