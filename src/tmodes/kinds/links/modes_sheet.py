"""A mode of a flexible link, in the sense of the 2010 paper: a cantilever with the shape of a tip load (LMA)."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.schema.quantity import DataSheet, dissipation, positive

__all__ = ["Mode", "eased", "shape_angle", "shape_deflection", "shape_slope"]


def shape_deflection(s: Any) -> Any:
    """Deflection at s = x/l over the tip's deflection: a cantilever under a tip force, (3 s^2 - s^3)/2; 1 at the tip.

    Eq. (2) [stated]: y(x, t) = X(x) T(t); this is X, the one static shape of a mode. {test_mode_shape}
    """
    return s**2 * (3 - s) / 2


def shape_angle(s: Any) -> Any:
    """Angle of the chord from the root to the point s over the tip's chord angle: shape_deflection(s)/s."""
    return s * (3 - s) / 2


def shape_slope(s: Any) -> Any:
    """Slope of the line at s over the tip's chord angle: the derivative of shape_deflection; 3/2 at the tip."""
    return 3 * s * (2 - s) / 2


def eased(lever: Any) -> Any:
    """Stiffness of a cantilever under a force ``lever`` lengths beyond its tip, over that of the one shape [-].

    Its compliance under a tip force F and a moment F lever l is (1/3 + lever + lever^2) l^3/EI; of the one shape of a
    tip force, which cannot follow the moment by itself, (1/3 + lever + 3/4 lever^2) l^3/EI.
    """
    return (1 / 3 + lever + 0.75 * lever**2) / (1 / 3 + lever + lever**2)


class Mode(DataSheet):
    """One elastic segment, bending in the horizontal and in the vertical plane with the same stiffness.

    Its bending angle ``th`` is the angle of the chord from root to tip against the root's tangent; the tip's tangent
    turns by ``omega = th/2`` more.

    Eq. (6) [stated]: omega_q = th_q/2, horizontal plane: tip slope 3/2 r/l less the chord r/l. {test_mode_shape}
    Eq. (7) [stated]: omega_m = th_m/2, vertical plane: the same. {test_mode_shape}
    """

    length: float = positive("m", "l", "length of the mode", plausible=(1e-3, 50.0))
    bending_stiffness: float = positive(
        "N*m^2", "EI", "bending stiffness EI of the section, both planes", rigid=True, plausible=(1e-6, 1e10)
    )
    mass_per_length: float = positive("kg/m", "w", "mass per length", plausible=(1e-5, 1e4))
    damping_time: float = dissipation("s", "eta", "Kelvin-Voigt damping over stiffness: Bs = eta Cs", most=0.1)

    @property
    def mass(self) -> Any:
        """Mass of its piece of the beam [kg]."""
        return self.mass_per_length * self.length

    @property
    def tip_stiffness(self) -> Any:
        """Cs = 3 EI/l^3 [N/m]: tip force over tip deflection of the cantilever."""
        return 3 * self.bending_stiffness / self.length**3

    @property
    def tip_damping(self) -> Any:
        """Bs = eta Cs [N*s/m]."""
        return self.damping_time * self.tip_stiffness

    @property
    def tip_mass(self) -> Any:
        """Equivalent mass at the tip [kg].

        Eq. (13) [stated]: mel = 33/140 w l, Jel = mel (l/2)^2, kept as printed. {test_slip_13_mass}
        Slip (13): 33/140 already holds the rotation of the static shape, so Jel counts it twice; and gravity's
        equivalent mass would be 3/8 w l {test_slip_13_mass}
        """
        return 33 / 140 * self.mass

    @property
    def tip_inertia(self) -> Any:
        """Equivalent rotary inertia at the tip Jel = mel (l/2)^2 [kg*m^2], Eq. (13)."""
        return self.tip_mass * (self.length / 2) ** 2
