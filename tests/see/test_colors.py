"""The colours of figures and pages are legible, and those of causes are told apart by everybody."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from tmodes.plot import style
from tmodes.report.parts import styles

EYES = {
    "all": np.eye(3),
    "no red": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
    "no green": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
}
"""Linear red, green and blue as seen by people (Machado, Oliveira and Fernandes, 2009)."""

XYZ = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])


def linear(color: str) -> np.ndarray:
    """Linear red, green and blue of a colour in hexadecimal digits."""
    parts = np.array([int(color[k : k + 2], 16) for k in (1, 3, 5)]) / 255
    return np.where(parts <= 0.04045, parts / 12.92, ((parts + 0.055) / 1.055) ** 2.4)


def luminance(color: str) -> float:
    """Relative luminance of WCAG 2."""
    return float(linear(color) @ [0.2126, 0.7152, 0.0722])


def seen(color: str, eyes: str) -> np.ndarray:
    """The colour in CIE 1976 L*a*b* (white of the page) as these eyes see it."""
    white = XYZ @ np.ones(3)
    ratio = XYZ @ np.clip(np.asarray(EYES[eyes]) @ linear(color), 0, 1) / white
    f = np.where(ratio > 0.008856, np.cbrt(ratio), 7.787 * ratio + 16 / 116)
    return np.array([116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])])


def contrast(one: str, other: str) -> float:
    """Contrast of WCAG 2, 1 to 21."""
    low, high = sorted((luminance(one), luminance(other)))
    return (high + 0.05) / (low + 0.05)


def test_figures_are_legible() -> None:
    assert contrast(style.INK, style.PAPER) > 10
    assert contrast(style.QUIET, style.PAPER) > 4.5
    curves = {look["color"] for look in (style.REAL, style.REFERENCE, *style.COMPONENTS, *style.INSTANTS)}
    assert min(contrast(color, style.PAPER) for color in curves) > 3.5


def test_causes_are_told_apart_in_light_and_dark_by_all_eyes() -> None:
    for which, paper in enumerate((style.PAPER, "#1c2228")):
        every = [both[which] for both in style.CAUSES.values()]
        assert min(contrast(color, paper) for color in every) > 3
        differ = [
            np.linalg.norm(seen(one, eyes) - seen(other, eyes))
            for one, other in combinations(every, 2)
            for eyes in EYES
        ]
        assert min(differ) > 19


def test_the_page_has_the_colours_of_the_figures() -> None:
    light, dark = styles().split("prefers-color-scheme:dark")[:2]
    for name, both in style.CAUSES.items():
        assert f"--of-{name.replace(' ', '-')}:{both[0]};" in light
        assert f"--of-{name.replace(' ', '-')}:{both[1]};" in dark
        assert style.colours()[name] == {"light": both[0], "dark": both[1]}
