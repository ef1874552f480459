"""The numbers that matter of a run of the 2010 paper's robot."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmodes.plot.paper.facts import move_duration
from tmodes.report.facts import Fact, energy_facts, frequency_facts, tracking_facts
from tmodes.report.numbers import PLACES

__all__ = ["robot_facts"]


def robot_facts(data: Any, summary: dict[str, Any]) -> Iterator[Fact]:
    """From a result's dataset and its summary."""
    yield from tracking_facts(summary, data, move_duration(data))
    yield _moment(summary["largest_bending_moment"])
    yield _angle(summary["deformations"])
    yield from _contact(summary["contact_force_radial"])
    torque = summary["gear_torque"]
    yield Fact("gear_torque.max", "Largest gear torque", torque["max_Nm"], "N m", f"at {torque['time_s']:.3g} s")
    yield _voltage(data)
    yield from frequency_facts(summary["first_frequency_Hz"])
    yield from energy_facts(summary["energy"])


def _moment(info: dict[str, Any]) -> Fact:
    place = "at the root" if info["s"] == 0 else f"at {100 * info['s']:.3g}\u00a0% of its length"
    where = f"mode {str(info['mode'])[-1]}, {place}, {info['plane']} plane, at {info['time_s']:.3g}\u00a0s"
    return Fact("moment.max", "Largest bending moment", abs(info["value_Nm"]), "N m", where)


def _angle(info: dict[str, dict[str, float | None]]) -> Fact:
    sizes = {name: values["max_rad"] or 0.0 for name, values in info.items()}
    name = max(sizes, key=lambda name: sizes[name])
    return Fact("deformation.max", "Largest elastic angle", sizes[name], "rad", PLACES.get(name, (name,))[0])


def _contact(info: dict[str, float] | None) -> Iterator[Fact]:
    if info is not None:
        note = f"from {info['min_N']:.4g} to {info['max_N']:.4g} N"
        yield Fact("contact.mean", "Radial contact force, mean", info["mean_N"], "N", note)


def _voltage(data: Any) -> Fact:
    size = np.abs(data["voltage"].values)
    worst = int(np.argmax(size))
    note = f"at {float(data['time'][worst]):.3g} s"
    return Fact("voltage.max", "Largest motor voltage", float(size[worst]), "V", note)
