"""What looks wrong with an arm, or is beyond what its models tell: sentences, never errors."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmodes.analysis.range import link_ranges
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.chain.chain import Chain
from tmodes.sheet import Robot

__all__ = ["notices", "rest_notices"]

FIRST_FREQUENCY = (0.05, 5e3)
"""Usual range of the first frequency of a bare link [Hz]."""

GEAR_OVER_LINK = (1e-2, 1e4)
"""Usual range of a gear's stiffness over EI/L of its link."""

THICK = 10.0
"""Length over the distance of the outer fibre below which shear, which is left out, would count."""


def notices(arm: Robot, chain: Chain, info: dict[str, Any], rest: Equilibrium | None) -> list[str]:
    """Sentences on what is reported of an arm, and on its rest where it has one."""
    found = [*_frequencies(info["links"]), *_gears(info["gears"]), *_thick(chain)]
    return [*found, *(rest_notices(arm, rest) if rest else ())]


def _frequencies(links: list[dict[str, Any]]) -> Iterator[str]:
    low, high = FIRST_FREQUENCY
    for link in links:
        for axis in ("y", "z"):
            value = link.get(f"bare_bend_{axis}_Hz")
            if value is not None and not low <= value <= high:
                yield (
                    f"link {link['name']}: its first frequency by itself is {value:.3g} Hz, usual are {low:g} to "
                    f"{high:g} Hz; is a unit of its stiffness, mass or length wrong (GPa, mm, g)?"
                )


def _gears(gears: list[dict[str, Any]]) -> Iterator[str]:
    low, high = GEAR_OVER_LINK
    for gear in gears:
        ratio = gear["stiffness_over_EI_per_L"]
        if ratio is not None and not low <= ratio <= high:
            yield (
                f"joint {gear['joint']}: its gear has {ratio:.3g} times the stiffness EI/L of link {gear['link']}, "
                f"usual are {low:g} to {high:g}; is it in {gear['unit']}, at the joint?"
            )


def _thick(chain: Chain) -> Iterator[str]:
    for node in chain.nodes:
        outer = node.link.outer_distance
        if outer and node.link.length / outer < THICK:
            yield (
                f"link {node.name}: {node.link.length:.3g} m long and {2 * outer:.3g} m thick: shear, which is left "
                "out, makes so short a beam softer"
            )


def rest_notices(arm: Robot, rest: Equilibrium) -> list[str]:
    """What is uncertain about a robot at rest: unstable, bent beyond its models, past a joint's limits."""
    return [*_stability(rest), *_ranges(rest), *_limits(arm, rest)]


def _stability(rest: Equilibrium) -> Iterator[str]:
    if rest.lost_stability_at is not None:
        yield f"the arm buckles: it lost its stability at {rest.lost_stability_at:.4g} of its weight and loads"
    if not rest.stable:
        where = f", first in {rest.unstable_modes[0].coordinate}" if rest.unstable_modes else ""
        yield f"this equilibrium is not stable: the arm does not stay there{where}"


def _ranges(rest: Equilibrium) -> Iterator[str]:
    for link in link_ranges(rest.model, rest.q):
        if link.verdict != "good":
            yield (
                f"link {link.link} bends by {link.deflection_over_length:.1%} of its length: {link.verdict} for its "
                f"model ({link.model}, angle {link.angle_rad:.3g} rad); {link.cure}"
            )


def _limits(arm: Robot, rest: Equilibrium) -> Iterator[str]:
    pose = rest.named
    for joint, name in ((each, own) for each in arm.joints for own in each.coordinates):
        if joint.limits is None or name not in pose:
            continue
        value = pose[name]
        low = -np.inf if joint.limits.lower is None else joint.limits.lower
        high = np.inf if joint.limits.upper is None else joint.limits.upper
        if not low <= value <= high:
            yield f"joint {name} stands at {value:.4g}, beyond its limits {low:g} to {high:g}"
