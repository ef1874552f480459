"""Shear coefficients of sections: the share kappa of G A with which a section resists a shear force.

All from G. R. Cowper, The Shear Coefficient in Timoshenko's Beam Theory, J. Appl. Mech. 33 (1966), 335-340, as
functions of the Poisson ratio nu, but for an I across its web, where the flanges alone count, as rectangles.
"""

from __future__ import annotations

__all__ = ["box_shear", "i_beam_shear", "rectangle_shear", "round_shear", "tube_shear"]


def round_shear(nu: float) -> float:
    """A solid circle."""
    return 6 * (1 + nu) / (7 + 6 * nu)


def tube_shear(nu: float, inner_over_outer: float) -> float:
    """A hollow circle of any wall."""
    square = inner_over_outer**2
    both = (1 + square) ** 2
    return 6 * (1 + nu) * both / ((7 + 6 * nu) * both + (20 + 12 * nu) * square)


def rectangle_shear(nu: float) -> float:
    """A solid rectangle of any sides."""
    return 10 * (1 + nu) / (12 + 11 * nu)


def _webs(nu: float, m: float) -> float:
    """What a thin box and an I have in common; m: area of both flanges over that of the web(s)."""
    return 12 + 72 * m + 150 * m**2 + 90 * m**3 + nu * (11 + 66 * m + 135 * m**2 + 90 * m**3)


def box_shear(nu: float, across: float, along: float) -> float:
    """A thin box of one wall thickness; sides of its middle line across and along the force."""
    m = n = across / along
    more = 10 * n**2 * ((3 + nu) * m + 3 * m**2)
    return 10 * (1 + nu) * (1 + 3 * m) ** 2 / (_webs(nu, m) + more)


def i_beam_shear(nu: float, width: float, height: float, flange: float, web: float) -> tuple[float, float]:
    """An I of thin walls, along its flanges and along its web; ``height`` between the middles of the flanges."""
    area = 2 * width * flange + height * web
    m, n = 2 * width * flange / (height * web), width / height
    more = 30 * n**2 * (m + m**2) + 5 * nu * n**2 * (8 * m + 9 * m**2)
    along_web = 10 * (1 + nu) * (1 + 3 * m) ** 2 / (_webs(nu, m) + more)
    return rectangle_shear(nu) * 2 * width * flange / area, along_web
