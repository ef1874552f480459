"""Laws of a drive as expressions: the gear's spring, linear, in ranges or with a dead zone, and friction."""

from __future__ import annotations

from typing import Any

from tmodes.kinds.kernel.functions import fabs, sqrt

__all__ = ["FRICTION", "DriveLaw"]

FRICTION = 5
"""Numbers of a friction law."""


class DriveLaw:
    """The parameters of a drive by name, and the laws that they are in."""

    def __init__(self, p: Any, *, ranges: int, dead_zone: bool, dry_motor: bool, dry_joint: bool, own: int = 0) -> None:
        """``own``: how many numbers of the kind itself there are, the last of ``p``."""
        self._dead_zone, self._dry_motor, self._dry_joint = dead_zone, dry_motor, dry_joint
        self.inertia, self.rest = p[0], p[1]
        self._motor, self._joint = [p[2 + i] for i in range(5)], [p[7 + i] for i in range(5)]
        r = ranges
        self.stiffness, self.ends, self.damping, self.backlash, self.rounding = [0.0], [], 0.0, 0.0, 1.0
        if r:
            self.stiffness = [p[12 + i] for i in range(r)]
            self.ends = [p[12 + r + i] for i in range(r - 1)]
            self.damping, self.backlash, self.rounding = p[11 + 2 * r], p[12 + 2 * r], p[13 + 2 * r]
        first = 14 + 2 * r if r else 12
        self.own = [p[first + k] for k in range(own)]

    def motor_friction(self, rate: Any) -> tuple[Any, Any]:
        """Torque and its derivative by the rate."""
        return _friction(self._motor, rate, dry=self._dry_motor)

    def joint_friction(self, rate: Any) -> tuple[Any, Any]:
        """Effort and its derivative by the rate."""
        return _friction(self._joint, rate, dry=self._dry_joint)

    def spring(self, deflection: Any) -> tuple[Any, Any]:
        """Torque of the spring and its stiffness at a deflection (the rounding of a dead zone's edges aside)."""
        x, slope = self._free(deflection)
        torque, stiffness = self.stiffness[0] * x, self.stiffness[0]
        side = (x > 0) - (x < 0) if self.ends else 0.0
        for end, step in self._steps():
            over = side * x - end
            beyond = over > 0
            torque = torque + side * beyond * step * over
            stiffness = stiffness + beyond * step
        return torque * slope, stiffness * slope * slope

    def stored(self, deflection: Any) -> Any:
        """Energy of the spring.

        Eq. (24) [stated]: Epel_xi = 1/2 Cxi xi^2, with xi = gamma - theta. {test_elastic_energy_terms}
        """
        x, _ = self._free(deflection)
        energy = self.stiffness[0] * x * x / 2
        for end, step in self._steps():
            over = fabs(x) - end
            energy = energy + (over > 0) * step * over * over / 2
        return energy

    def _steps(self) -> list[tuple[Any, Any]]:
        """Deflection at which each further range begins, and by how much the stiffness changes there."""
        return [(end, self.stiffness[i + 1] - self.stiffness[i]) for i, end in enumerate(self.ends)]

    def _free(self, deflection: Any) -> tuple[Any, Any]:
        """What is left of a deflection outside the dead zone, smooth, and its slope."""
        if not self._dead_zone:
            return deflection, 1.0
        ahead, behind = deflection - self.backlash, deflection + self.backlash
        near, far = sqrt(ahead**2 + self.rounding**2), sqrt(behind**2 + self.rounding**2)
        return deflection + (near - far) / 2, 1 + (ahead / near - behind / far) / 2


def _friction(p: list[Any], rate: Any, *, dry: bool) -> tuple[Any, Any]:
    """Viscous, Coulomb and Stribeck friction, smooth at rest; and its derivative."""
    viscous, coulomb, extra, stribeck, smoothing = p
    if not dry:
        return viscous * rate, viscous
    root = sqrt(rate * rate + smoothing * smoothing)
    side = rate / root
    ratio = rate / stribeck
    fall = 1 / (1 + ratio * ratio)
    level = coulomb + extra * fall
    slope = level * smoothing * smoothing / (root * root * root) - 2 * extra * fall * fall * ratio / stribeck * side
    return viscous * rate + level * side, viscous + slope
