"""Saint-Venant torsion constants J [m^4] of sections that are not round.

Warping is free: a restrained end makes an open section stiffer than GJ says.
"""

from __future__ import annotations

import math

__all__ = ["i_beam_torsion", "rectangle_torsion", "thin_box_torsion"]

_ODD_FIFTHS = 31 / 32 * 1.0369277551433699
"""Sum of n^-5 over odd n: 31/32 zeta(5)."""


def rectangle_torsion(width: float, height: float) -> float:
    """J of a solid rectangle, the series of Saint-Venant.

    J = a b^3/3 (1 - 192 b/(pi^5 a) sum over odd n of tanh(n pi a/(2 b))/n^5), a >= b.
    S. P. Timoshenko, J. N. Goodier, Theory of Elasticity, 3rd ed. 1970, art. 109. Summed as the limit of long
    rectangles, tanh = 1, less what the ends take away: six terms of that are exact to rounding.
    """
    long, short = max(width, height), min(width, height)
    ratio = long / short
    decays = ((n, math.exp(-n * math.pi * ratio)) for n in range(1, 12, 2))
    series = _ODD_FIFTHS - math.fsum(2 * decay / (1 + decay) / n**5 for n, decay in decays)
    return long * short**3 / 3 * (1 - 192 / (math.pi**5 * ratio) * series)


def thin_box_torsion(width: float, height: float, thickness: float) -> float:
    """J of a closed box of one wall thickness by Bredt: 4 (enclosed area)^2 t/(perimeter), both of the middle line.

    R. Bredt, Kritische Bemerkungen zur Drehungselastizitaet, Z. VDI 40 (1896). For thin walls: of a square box it is
    2.4 % too soft where the wall is a twentieth of the side, 5.4 % at a tenth, 13 % at a fifth.
    """
    across, up = width - thickness, height - thickness
    return 2 * thickness * (across * up) ** 2 / (across + up)


def i_beam_torsion(width: float, height: float, flange_thickness: float, web_thickness: float) -> float:
    """J of an I as its three strips: sum of b t^3/3.

    Left out: what the junctions add, and what the strips' ends take away; for rolled shapes a few per cent together.
    """
    web = height - 2 * flange_thickness
    return (2 * width * flange_thickness**3 + web * web_thickness**3) / 3
