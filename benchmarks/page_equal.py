"""The page's run against the native one, all series; next to it what the native run makes of a last digit.

At the sheet's tolerance the seed's explicit run is limited by stability: rounding then decides which steps are
rejected, and nobody can ask the page to agree better than the native run agrees with itself.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple, cast

import numpy as np

from tmodes.live.bundle import live_bundle
from tmodes.live.map import LiveMap, live_map
from tmodes.live.sliders import MOST
from tmodes.result.run import run
from tmodes.sheet import Robot

from .page_node import in_node

__all__ = ["FINE", "LAST_DIGITS", "Equality", "drawn", "equality", "sensitivity"]

LAST_DIGITS = (1 + 4e-16, 1 - 3e-16)
"""Factors that change the last digit of one stiffness, and nothing else."""

FINE = {"integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-14}
"""Tolerances at which the integration's own error is below what is compared."""


class Equality(NamedTuple):
    """Largest difference of any series over its largest value: of the page, and of the native run by a last digit."""

    page: float
    series: str
    native: float


def drawn(live: LiveMap, count: int, seed: int = 5) -> list[list[float]]:
    """Random values of the sliders that lead, and of all others a little, for which the program holds."""
    generator = np.random.default_rng(seed)
    settings: list[list[float]] = []
    for _ in range(count):
        drawn = generator.uniform(size=len(live.sliders)).tolist()
        ends = [
            s.low * (s.high / s.low) ** x if s.log else s.low + (s.high - s.low) * x
            for s, x in zip(live.sliders, drawn, strict=True)
        ]
        away = np.where(np.arange(len(ends)) < MOST, 1.0, 0.05) * (np.array(ends) - live.start)
        while not live.holds(given := (np.array(live.start) + away).tolist()):
            away *= 0.8
        settings.append(given)
    return settings


def equality(robot: Robot, folder: Path, count: int = 10) -> list[Equality]:
    """At the unchanged setting, and at so many random ones; natively as ``tmodes run --set`` runs them."""
    live, result = live_map(robot.pair()), run(robot)
    bundle, method = live_bundle(result), result.statistics["real"]["method"]
    assert bundle is not None, "the seed's run can be made again in a page"
    jobs = [[slider.value for slider in live.sliders], *drawn(live, count)]
    found = []
    for values, page in zip(jobs, in_node(bundle, jobs, folder, keep=True), strict=True):
        changed = robot.with_(live.changes(values) | {"integration.method": method})
        true = run(changed).data
        worst, name = _apart(page["series"], true)
        found.append(Equality(worst, name, sensitivity(changed, true)))
    return found


def sensitivity(robot: Robot, data: Any) -> float:
    """How far all series of a native run go apart where the last digit of one stiffness is another."""
    info = [name for name, one in data.items() if "time" in one.dims and "s" not in one.dims]
    stiffness: Any = cast("Any", robot.joints[0].gear).stiffness
    others = [run(robot.with_({"gear.stiffness": stiffness * factor})).data for factor in LAST_DIGITS]
    return max(_apart({name: other[name].values for name in info}, data)[0] for other in others)


def _apart(series: dict[str, Any], data: Any) -> tuple[float, str]:
    """What is a small difference of large numbers is compared by these: by nothing smaller it is rounded."""
    energy, bent = data["energy"].values, float(np.abs(data["deformation"].values).max())
    moved = max(float(np.abs(energy - energy[0]).max()), float(np.abs(data["work"].values).max()))
    scales = {"energy_balance": moved, "deformation_oscillatory": bent, "deformation_stationary": bent}
    sizes = {name: scales.get(name) or float(np.abs(data[name].values).max()) or 1.0 for name in series}
    return max((float(np.abs(values - data[name].values).max()) / sizes[name], name) for name, values in series.items())
