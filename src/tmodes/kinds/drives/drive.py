"""What drives a joint: friction, motor with its reducer, elastic gear. Motor-side quantities are reflected here."""

from __future__ import annotations

from collections.abc import Iterator
from enum import StrEnum
from itertools import pairwise
from typing import Annotated, Any, NamedTuple

from pydantic import Field, field_validator

from tmodes.kinds.noted.functions import isinf
from tmodes.kinds.schema.frames import list_of_numbers
from tmodes.kinds.schema.quantity import (
    LARGEST,
    SMALLEST,
    DataSheet,
    Issue,
    any_sign,
    dissipation,
    not_negative,
    positive,
)

__all__ = ["FrictionSheet", "GearSheet", "MotorNumbers", "MotorSheet", "ReducerSide", "SpringSheet"]

_Stiffness = Annotated[float, Field(gt=0.0, allow_inf_nan=True)]
_Limit = Annotated[float, Field(gt=0.0, le=LARGEST)]

MOST_RANGES = 5
"""Largest number of stiffnesses of one gear; harmonic drives are given with three."""


class FrictionSheet(DataSheet):
    """Friction at a rate v: viscous v + (coulomb + static_extra/(1 + (v/stribeck_rate)^2)) sgn v.

    At rest dry friction is what keeps at rest, up to coulomb + static_extra; onset and end of slip are located. Without
    ``stribeck_rate`` it drops to ``coulomb`` at once where slip begins. With ``smoothing`` sgn is a smooth function.

    On a joint that slides dry friction may be given by ``normal_force`` and coefficients instead: coefficient times
    force.
    """

    viscous: float = dissipation("N*m*s/rad|N*s/m", "Bv", "viscous friction")
    coulomb: float = not_negative("N*m|N", "Tc", "dry friction in motion", default=0.0)
    static_extra: float = not_negative("N*m|N", "Ts - Tc", "dry friction at rest beyond that in motion", default=0.0)
    normal_force: float | None = not_negative(
        "N", "N", "constant force that presses the two sides of a slide together", default=None
    )
    coefficient: float | None = not_negative(
        "-", "mu", "dry friction in motion over `normal_force`", default=None, at_most=10.0
    )
    static_coefficient: float | None = not_negative(
        "-", "mu_s", "dry friction at rest over `normal_force`; none: as in motion", default=None, at_most=10.0
    )
    stribeck_rate: float | None = positive(
        "rad/s|m/s", "vs", "rate at which half of `static_extra` is gone", default=None
    )
    smoothing: float | None = positive(
        "rad/s|m/s", "veps", "rate below which dry friction is smoothed; none: true stick and slip", default=None
    )

    @property
    def dry(self) -> tuple[float, float]:
        """Dry friction in motion, and by how much it is larger at rest [N*m or N]."""
        if self.normal_force is None or self.coefficient is None:
            return self.coulomb, self.static_extra
        static = self.coefficient if self.static_coefficient is None else self.static_coefficient
        return self.coefficient * self.normal_force, (static - self.coefficient) * self.normal_force

    def _issues(self) -> Iterator[Issue]:
        if self.dry[1] > 0 and self.smoothing and self.stribeck_rate is None:
            hint = "add `stribeck_rate`, or remove `smoothing`"
            given = "static_extra" if self.static_extra > 0 else "static_coefficient"
            yield Issue("stribeck_rate", "nothing", f"a rate, because `{given}` and `smoothing` are given", hint)
        yield from self._normal_issues()

    def _normal_issues(self) -> Iterator[Issue]:
        """What is missing or too much where friction is given by a normal force."""
        given = {name: getattr(self, name) for name in ("normal_force", "coefficient", "static_coefficient")}
        if not any(value is not None for value in given.values()):
            return
        for name, what in (
            ("normal_force", "the force on the slide in N"),
            ("coefficient", "the friction coefficient"),
        ):
            if given[name] is None:
                others = " and ".join(f"`{other}`" for other, value in given.items() if value is not None)
                yield Issue(name, "nothing", f"{what}, because {others} is given", f"add the line `{name}: ...`")
        for name in ("coulomb", "static_extra"):
            if getattr(self, name):
                hint = f"remove `{name}`, or give friction by `coulomb` and `static_extra` alone"
                yield Issue(name, f"{getattr(self, name):g}", "left out next to `normal_force`", hint)
        if None not in (self.static_coefficient, self.coefficient) and self.dry[1] < 0:
            got, expected = f"{self.static_coefficient:g}", f"at least `coefficient`, {self.coefficient:g}"
            yield Issue("static_coefficient", got, expected, "exchange the two")


class ReducerSide(StrEnum):
    """Of which side of the reducer a motor's quantities are."""

    JOINT = "joint"
    MOTOR = "motor"


class MotorNumbers(NamedTuple):
    """A motor's numbers on the joint side: SI, ``friction`` of the same keys as its sheet."""

    inertia: float
    viscous: float
    coulomb: float
    static_extra: float
    stribeck_rate: float
    smoothing: float
    resistance: float | None
    back_emf: float
    torque_constant: float
    inductance: float


class MotorSheet(DataSheet):
    """A motor with its reducer. ``side: joint``: quantities as felt at the joint; ``motor``: as on its shaft."""

    inertia: float = not_negative("kg*m^2|kg", "I", "rotor inertia", plausible=(0.0, 1e4))
    side: ReducerSide = Field(
        strict=False,
        description="of which side of the reducer the quantities are: joint (after it) or motor (before it)",
    )
    ratio: float | None = any_sign(
        "-|rad/m", "N", "motor angle over joint angle (over joint travel)", default=None, plausible=(-1e5, 1e5)
    )
    friction: FrictionSheet | None = Field(default=None, description="friction of the motor; none: no friction")
    resistance: float | None = positive("ohm", "R", "armature resistance", default=None, plausible=(1e-3, 1e3))
    back_emf_constant: float | None = positive("V*s/rad|V*s/m", "CE", "back electromotive force constant", default=None)
    torque_constant: float | None = positive("N*m/A|N/A", "CM", "torque constant", default=None)
    inductance: float = not_negative("H", "La", "armature inductance", default=0.0, plausible=(0.0, 10.0))

    def _issues(self) -> Iterator[Issue]:
        if self.ratio is None and self.side is ReducerSide.MOTOR:
            hint = "add the line `ratio: ...`, or give all quantities joint side"
            yield Issue("ratio", "nothing", "the reducer's ratio, because `side` is motor", hint)
        if self.ratio is not None and abs(self.ratio) < SMALLEST:
            yield Issue("ratio", repr(self.ratio), "a ratio that is not zero", "write motor speed over joint speed")
        if self.friction and self.friction.normal_force is not None:
            got, hint = f"{self.friction.normal_force:g} N", "give `coulomb` and `static_extra`"
            yield Issue("friction.normal_force", got, "left out: a motor has no slide", hint)
        names = ("resistance", "back_emf_constant", "torque_constant")
        missing = [name for name in names if getattr(self, name) is None]
        if len(missing) in {1, 2}:
            hint = f"add {' and '.join(missing)}, or remove the others"
            for name in missing:
                yield Issue(name, "nothing", "all three of the electric side, or none", hint)
        if len(missing) == 3 and self.inductance:
            hint = f"add {', '.join(names)}"
            yield Issue("inductance", repr(self.inductance), "0 without the rest of the electric side", hint)

    def at_joint(self) -> MotorNumbers:
        """Its numbers on the joint side: inertia and viscous friction with ratio^2, torques with |ratio|."""
        ratio = self.ratio if self.side is ReducerSide.MOTOR and self.ratio else 1.0
        friction, turns = self.friction or FrictionSheet(viscous=0.0), abs(ratio)
        coulomb, extra = friction.dry
        return MotorNumbers(
            inertia=self.inertia * ratio**2,
            viscous=friction.viscous * ratio**2,
            coulomb=coulomb * turns,
            static_extra=extra * turns,
            stribeck_rate=(friction.stribeck_rate or 0.0) / turns,
            smoothing=(friction.smoothing or 0.0) / turns,
            resistance=self.resistance,
            back_emf=(self.back_emf_constant or 0.0) * ratio,
            torque_constant=(self.torque_constant or 1.0) * ratio,
            inductance=self.inductance,
        )


class SpringSheet(DataSheet):
    """A linear spring and damper between the links of a joint, beside its motor and gear.

    On the coordinate q of the joint: -stiffness (q - rest) - damping q'.
    """

    stiffness: float = not_negative("N*m/rad|N/m", "k", "stiffness of the spring beside the motor")
    rest: float = any_sign(
        "rad|m", "q_k", "position of the joint at which the spring is relaxed", default=0.0, plausible=(-13.0, 13.0)
    )
    damping: float = dissipation("N*m*s/rad|N*s/m", "d", "damping beside the motor", default=0.0)


class GearSheet(DataSheet):
    """An elastic gear, all quantities at the joint. Several stiffnesses: one for each range of the torque."""

    stiffness: tuple[_Stiffness, ...] = list_of_numbers(
        "N*m/rad|N/m",
        "Cxi",
        "stiffness of the gear; a list: of each range of the torque",
        rigid_when_infinite=True,
        plausible=[1.0, 1e9],
    )
    torque_limits: tuple[_Limit, ...] = list_of_numbers(
        "N*m|N", "T1, T2", "torques at which one stiffness gives way to the next, rising", default=()
    )
    damping: float = dissipation("N*m*s/rad|N*s/m", "Bxi", "damping of the gear")
    backlash: float = not_negative("rad|m", "b", "half-width of the play", default=0.0, plausible=(0.0, 0.1))

    @field_validator("stiffness", mode="before")
    @classmethod
    def _one_number_is_a_list(cls, value: Any) -> Any:
        return (value,) if isinstance(value, (int, float)) and not isinstance(value, bool) else value

    def _issues(self) -> Iterator[Issue]:
        count = len(self.stiffness)
        if not 1 <= count <= MOST_RANGES:
            most = f"1 to {MOST_RANGES} stiffnesses"
            yield Issue("stiffness", f"a list of {count}", most, "write one for each range of the torque")
        for value in self.stiffness:
            if not (SMALLEST <= value <= LARGEST or (isinf(value) and count == 1)):
                bounds = f"a magnitude from {SMALLEST:g} to {LARGEST:g}"
                hint = "correct the exponent or the unit" + ("; one .inf alone makes it rigid" if count > 1 else "")
                yield Issue("stiffness", f"{value:g}", bounds, hint)
        wanted, limits = count - 1, self.torque_limits
        if len(limits) != wanted:
            expected = f"a list of {wanted}, one less than there are stiffnesses"
            hint = "write the torque between each stiffness and the next"
            yield Issue("torque_limits", f"a list of {len(limits)}", expected, hint)
        if any(later <= earlier for earlier, later in pairwise(limits)):
            yield Issue("torque_limits", str(list(limits)), "limits that rise", "put them in rising order")

    @property
    def is_rigid(self) -> bool:
        """True when it does not give: rigid on purpose."""
        return isinf(self.stiffness[0])
