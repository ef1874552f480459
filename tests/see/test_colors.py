"""The colours of the figures: legible on white and in the dark."""

from __future__ import annotations

import re
from importlib.resources import files

import numpy as np

from tmodes.plot import style


def turned_colors() -> dict[str, str]:
    """Every colour of the house style, as it is on white and as the page turns it in the dark."""
    used = {style.INK, style.QUIET, style.GRID, style.PAPER, style.BAND}
    used |= {look["color"] for look in (style.REAL, style.REFERENCE, *style.COMPONENTS, *style.INSTANTS)}
    css = files("tmodes.report").joinpath("page.css").read_text(encoding="utf-8")
    dark = dict(re.findall(r"--c([0-9a-f]{6}): (#[0-9a-f]{6});", css))
    return {color: dark[color.removeprefix("#")] for color in used}


def luminance(color: str) -> float:
    """Relative luminance of WCAG 2."""
    parts = np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    linear = np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)
    return float(linear @ [0.2126, 0.7152, 0.0722])


def contrast(one: str, other: str) -> float:
    """Contrast of WCAG 2, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_figures_are_legible_on_white_and_in_the_dark() -> None:
    found = turned_colors()
    for background in (0, 1):
        paper = [style.PAPER, found[style.PAPER]][background]
        turned = {color: (color, dark)[background] for color, dark in found.items()}
        assert contrast(turned[style.INK], paper) > 10
        assert contrast(turned[style.QUIET], paper) > 4.5
        curves = [value for color, value in turned.items() if color not in {style.PAPER, style.GRID, style.BAND}]
        assert min(contrast(curve, paper) for curve in curves) > 3.5
