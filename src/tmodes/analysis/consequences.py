"""What the numbers of a data sheet lead to, where that is odd: sag, first frequencies, damping, factors, an idle robot.

The joints are taken one at a time in a general position, all else rigid; nothing is compiled. Each sentence names the
likely cause: these are warnings of a wrong unit or a slipped decimal point, never errors.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from tmodes.analysis.describe.links import link_rows
from tmodes.analysis.headline_point import headline_point
from tmodes.chain.chain import Chain
from tmodes.chain.mass import Carried, carried_by_joints
from tmodes.sheet import Robot
from tmodes.sheet.topology import loose_links

__all__ = ["consequences"]

SAG = 0.25
"""Deflection of a gear under the weight that it carries beyond which a number is likely wrong [rad], or [m].

Springs of elastic actuators and leaf springs deflect by 0.1 to 0.2 rad.
"""

BENDING = 0.1
"""Deflection of a link under a weight at its end, over its length."""

APART, SLOW = 15.0, 0.5
"""How many times slower than the middle one of the others a joint on its gear may be [-], and down to where [Hz]."""

DAMPING = 1.0
"""Damping ratio of a gear, or of a link's first bending, beyond which it does not oscillate [-]."""

VISCOUS = 100.0
"""Viscous friction of a joint over the critical damping of its gear, or of the weight that it carries [-]."""

HELD = 3.0
"""Weight that a joint carries over its limit of effort; below, a spring or a counterweight may hold it [-]."""

FACTORS = (0.01, 100.0)
"""Usual range of a factor of the actual robot on the nominal one [-]."""

_INSTANTS, _CLOSE = 17, 1e-6
"""Instants of a piece of a setpoint; share of a limit within which it keeps it."""


@dataclass(frozen=True)
class _GearRow:
    """A gear by itself: its path, stiffness and damping, and what its joint carries."""

    path: str
    stiffness: float
    damping: float
    unit: str
    carried: Carried

    @property
    def sag(self) -> float:
        """Deflection under the weight that it carries [``length``]."""
        return self.carried.weight / self.stiffness

    @property
    def length(self) -> str:
        """Unit of a deflection."""
        return self.unit.partition("/")[2]

    @property
    def rate(self) -> float:
        """Natural angular frequency of what the joint carries on the gear [rad/s]."""
        return math.sqrt(self.stiffness / self.carried.inertia)


def consequences(robot: Robot) -> list[str]:
    """Sentences on what follows from the numbers of a robot, where that is odd."""
    chain = robot.chain()
    gears = _gears(robot, chain)
    checks = (_sagging(gears), _slow(gears), _damped(gears), _viscous(robot, chain), _links(robot, chain),
              _efforts(robot, chain), _factors(robot), _signals(robot))  # fmt: skip
    blind = headline_point(robot, chain)
    return [*(sentence for check in checks for sentence in check), *([blind.reason] if blind else [])]


def _gears(robot: Robot, chain: Chain) -> list[_GearRow]:
    carried = carried_by_joints(chain)
    found = []
    for joint in robot.joints:
        if joint.gear is None or not joint.is_elastic or joint.name not in carried:
            continue
        stiffness = min(joint.gear.stiffness)
        if math.isfinite(stiffness) and carried[joint.name].inertia > 0:
            unit = joint.kind.coordinates[0].stiffness_unit
            path = f"joints.{joint.name}.gear"
            found.append(_GearRow(path, stiffness, joint.gear.damping, unit, carried[joint.name]))
    return found


def _sagging(gears: list[_GearRow]) -> Iterator[str]:
    """Gears that give too much: a mass is wrong where all that carry it do, a stiffness where one of them does."""
    sagging = [gear for gear in gears if gear.sag > SAG]
    if len(sagging) > 1:
        each = ", ".join(f"{gear.path} {gear.sag:.3g} {gear.length}" for gear in sagging)
        yield (
            f"several gears deflect far under the {max(gear.carried.mass for gear in sagging):.4g} kg that they "
            f"carry: {each}; is a mass in g, or are their stiffnesses in kN*m/rad or per degree?"
        )
    for gear in sagging if len(sagging) == 1 else ():
        yield (
            f"{gear.path}.stiffness = {gear.stiffness:g} {gear.unit}: the {gear.carried.mass:.4g} kg that it "
            f"carries deflect it by about {gear.sag:.3g} {gear.length} under their weight; is a mass in g, or the "
            "stiffness in kN*m/rad or per degree?"
        )


def _slow(gears: list[_GearRow]) -> Iterator[str]:
    """Gears that are much softer than the others, for what they carry."""
    for gear in gears:
        others = sorted(other.rate for other in gears if other is not gear and other.unit == gear.unit)
        if not others:
            continue
        usual = others[(len(others) - 1) // 2]  # the lower one of two: a single gear that is too stiff accuses no other
        if gear.rate * APART < usual and gear.rate < 2 * math.pi * SLOW:
            yield (
                f"{gear.path}.stiffness = {gear.stiffness:g} {gear.unit}: its joint alone has a frequency of "
                f"{gear.rate / (2 * math.pi):.3g} Hz, those on the other gears about {usual / (2 * math.pi):.3g} Hz; "
                "was it meant in kN*m/rad (factor 1000)?"
            )


def _damped(gears: list[_GearRow]) -> Iterator[str]:
    for gear in gears:
        ratio = gear.damping / (2 * gear.stiffness) * gear.rate
        if ratio > DAMPING:
            yield (
                f"{gear.path}.damping = {gear.damping:g}: a damping ratio of {ratio:.3g} for what its joint carries, "
                "which then does not oscillate; is the unit right?"
            )


def _viscous(robot: Robot, chain: Chain) -> Iterator[str]:
    """Friction of joints that is huge against their gears and what they carry."""
    carried = carried_by_joints(chain)
    for joint in robot.joints:
        if joint.name not in carried or joint.is_locked:
            continue
        _, inertia, weight = carried[joint.name]
        motor = joint.motor.at_joint() if joint.motor else None
        stiffness = max([weight, *(k for k in (joint.gear.stiffness if joint.gear else ()) if math.isfinite(k))])
        places = {"friction": joint.friction and joint.friction.viscous, "motor.friction": motor and motor.viscous}
        critical = 2 * math.sqrt(stiffness * (inertia + (motor.inertia if motor else 0.0)))
        for path, viscous in places.items():
            if viscous and critical and viscous > VISCOUS * critical:
                yield (
                    f"joints.{joint.name}.{path}.viscous: {viscous:g} at the joint is {viscous / critical:.3g} times "
                    "the critical damping of what the joint carries, which hardly moves then; is the unit right?"
                )


def _links(robot: Robot, chain: Chain) -> Iterator[str]:
    """Links by themselves, clamped: their damping, and how far a weight at their end bends them."""
    pull, loose = math.hypot(*robot.gravity), loose_links(robot.joints)
    for row in link_rows(robot, chain):
        name, first = row["name"], [row[f"bare_bend_{axis}_Hz"] for axis in "yz" if row.get(f"bare_bend_{axis}_Hz")]
        time = row.get("damping_time_s") or 0.0
        if first and (ratio := math.pi * min(first) * time) > DAMPING:
            yield (
                f"links.{name}.beam.damping_time = {time:g} s: a damping ratio of {ratio:.3g} of its first bending by "
                f"itself ({min(first):.3g} Hz), which then does not oscillate; was it meant in ms (factor 0.001)?"
            )
        stiff = [row[f"tip_stiffness_{axis}_N_per_m"] for axis in "yz" if row.get(f"tip_stiffness_{axis}_N_per_m")]
        load = sum(body.mass * body.station**2 for body in robot.link(name).bodies)
        if stiff and pull and name not in loose and load * pull / max(stiff) > BENDING * row["length_m"]:
            yield (
                f"links.{name}.bodies: {load:.4g} kg at its end bend it by {load * pull / max(stiff):.3g} m under "
                f"their weight, more than a tenth of its length, {row['length_m']:.3g} m; is a mass in g?"
            )


def _efforts(robot: Robot, chain: Chain) -> Iterator[str]:
    """Joints whose own limit of effort does not carry the weight on them."""
    carried = carried_by_joints(chain)
    for joint in robot.joints:
        limit = joint.limits.effort if joint.limits else None
        if limit and joint.name in carried and carried[joint.name].weight > HELD * limit:
            got = carried[joint.name]
            yield (
                f"joints.{joint.name}.limits.effort = {limit:g}: the {got.mass:.4g} kg that the joint carries ask for "
                f"about {got.weight:.3g} to be held against their weight; is a mass in g?"
            )


def _signals(robot: Robot) -> Iterator[str]:
    """Setpoints beyond the limits of their joint, as far as the run goes; of pieces of polynomials at many instants."""
    bounds = {joint.name: joint.limits for joint in robot.joints}
    for k, drive in enumerate(robot.drives):
        limits = bounds[drive.joint]
        if limits is None or not drive.command.is_motion:
            continue
        pieces = drive.signal.schedule(robot.integration.duration)
        times = np.unique(np.concatenate([np.linspace(a, b, _INSTANTS)[:-1] for a, b in pairwise(pieces.knots)]))
        way, *rates = pieces.at(times), *(np.abs(pieces.at(times, order)).max() for order in (1, 2, 3))
        names = "speed", "acceleration", "jerk"
        found = (
            ("lower", way.min(), -1),
            ("upper", way.max(), 1),
            *((*one, 1) for one in zip(names, rates, strict=True)),
        )
        for name, value, sign in found:
            limit = getattr(limits, name)
            if limit is not None and sign * (value - limit) > _CLOSE * max(abs(limit), 1e-3):
                slower = "; a longer `duration` is slower" if name in names else ""
                asked = f"drives.{k}.signal asks {drive.joint} for {value:.4g}"
                yield f"{asked}, beyond joints.{drive.joint}.limits.{name} = {limit:g}{slower}"


def _factors(robot: Robot) -> Iterator[str]:
    low, high = FACTORS
    for path, factor in robot.real.items():
        if factor and not low <= factor <= high:
            yield (
                f"real.{path} = {factor:g} is a factor on the nominal value, usual are {low:g} to {high:g}; "
                "was it meant as the value itself? Then write that value over the nominal one"
            )
