"""Sections by their dimensions: torsion constants, and what a shear force finds.

The share kappa of G A with which a section resists a shear force is from G. R. Cowper, The Shear Coefficient in
Timoshenko's Beam Theory, J. Appl. Mech. 33 (1966), 335-340, a function of the Poisson ratio nu; but for an I across its
web, where the flanges alone count, as rectangles.
"""

from __future__ import annotations

import math

from tmodes.kinds.noted.functions import exp, maximum, minimum, number, total

__all__ = [
    "box_peak", "box_shear", "i_beam_peaks", "i_beam_shear", "i_beam_torsion", "rectangle_shear", "rectangle_torsion",
    "round_shear", "thin_box_torsion", "tube_peak", "tube_shear",
]  # fmt: skip


def tube_peak(radius: float, inner: float) -> float:
    """Largest shear stress over the shear force [1/m^2] of a circle with a hole: S/(I b) at its diameter.

    This and those of other shapes: D. J. Jourawski, Annales des Ponts et Chaussees 12 (1856); at a middle line, where
    bending has no stress.
    """
    first, second = 2 / 3 * (radius**3 - inner**3), math.pi / 4 * (radius**4 - inner**4)
    return first / (second * 2 * (radius - inner))


def box_peak(across: float, along: float, walls: tuple[float, float] | None) -> float:
    """Largest shear stress over the force [1/m^2] of a box with sides across and along it, solid without walls.

    ``walls``: thickness of those that lie across the force, and of those along it.
    """
    inner_across, inner_along = (across - 2 * walls[1], along - 2 * walls[0]) if walls else (0.0, 0.0)
    first = (across * along**2 - inner_across * inner_along**2) / 8
    second = (across * along**3 - inner_across * inner_along**3) / 12
    return first / (second * (2 * walls[1] if walls else across))


def i_beam_peaks(width: float, height: float, flange: float, web: float) -> tuple[float, float]:
    """Of an I, along its flanges (both, as rectangles) and along its web."""
    inner = height - 2 * flange
    first = (width * height**2 - (width - web) * inner**2) / 8
    second = (width * height**3 - (width - web) * inner**3) / 12
    return 1.5 / (2 * width * flange), first / (second * web)


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


def box_shear(nu: float, across: float, along: float, ratio: float = 1.0) -> float:
    """A thin box; sides of its middle line across and along the force.

    ``ratio``: thickness of the walls across the force over that of those along it.
    """
    n = across / along
    m = n * ratio
    more = 10 * n**2 * ((3 + nu) * m + 3 * m**2)
    return 10 * (1 + nu) * (1 + 3 * m) ** 2 / (_webs(nu, m) + more)


def i_beam_shear(nu: float, width: float, height: float, flange: float, web: float) -> tuple[float, float]:
    """An I of thin walls, along its flanges and along its web; ``height`` between the middles of the flanges."""
    area = 2 * width * flange + height * web
    m, n = 2 * width * flange / (height * web), width / height
    more = 30 * n**2 * (m + m**2) + 5 * nu * n**2 * (8 * m + 9 * m**2)
    along_web = 10 * (1 + nu) * (1 + 3 * m) ** 2 / (_webs(nu, m) + more)
    return rectangle_shear(nu) * 2 * width * flange / area, along_web


_ODD_FIFTHS = 31 / 32 * 1.0369277551433699
"""Sum of n^-5 over odd n: 31/32 zeta(5)."""


def rectangle_torsion(width: float, height: float) -> float:
    """J of a solid rectangle, the series of Saint-Venant.

    J = a b^3/3 (1 - 192 b/(pi^5 a) sum over odd n of tanh(n pi a/(2 b))/n^5), a >= b.
    S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed. 1970, art. 109. Summed as the limit of long
    rectangles, tanh = 1, less what the ends take away: six terms of that are exact to rounding.
    """
    long, short = number(maximum(width, height)), number(minimum(width, height))
    ratio = long / short
    decays = ((n, exp(-n * math.pi * ratio)) for n in range(1, 12, 2))
    series = _ODD_FIFTHS - total(2 * decay / (1 + decay) / n**5 for n, decay in decays)
    return long * short**3 / 3 * (1 - 192 / (math.pi**5 * ratio) * series)


def thin_box_torsion(width: float, height: float, flange: float, web: float) -> float:
    """J of a closed box by Bredt: 4 (enclosed area)^2/(sum of side/thickness), all of the middle line.

    ``flange``: thickness of the walls along the width, ``web`` of those along the height.

    R. Bredt, Kritische Bemerkungen zur Drehungselastizitaet, Z. VDI 40 (1896). For thin walls: of a square box it is
    2.4 % too soft where the wall is a twentieth of the side, 5.4 % at a tenth, 13 % at a fifth.
    """
    across, up = width - web, height - flange
    return 2 * flange * (across * up) ** 2 / (across + up * (flange / web))


def i_beam_torsion(width: float, height: float, flange_thickness: float, web_thickness: float) -> float:
    """J of an I as its three strips: sum of b t^3/3.

    Left out: what the junctions add, and what the strips' ends take away; for rolled shapes a few per cent together.
    """
    web = height - 2 * flange_thickness
    return (2 * width * flange_thickness**3 + web * web_thickness**3) / 3
