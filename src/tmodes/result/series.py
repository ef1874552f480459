"""The series of an arm's run by name, each with its dimensions, unit and meaning: motion, drives, points, energies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.quasistatic import deflections, elastic_names
from tmodes.chain.chain import line_before
from tmodes.simulation.motion_run import RunData

__all__ = ["Variables", "coordinate_units", "coordinates_of", "motion_series"]

Array = NDArray[np.float64]

Variables = dict[str, tuple[tuple[str, ...], Array, str, str]]
"""Dimensions, values, unit and long name of each variable."""

_MIXED = "rad, m along prismatic joints, 1 of stretch"

AXES = ("x", "y", "z")


def coordinates_of(run: RunData, count: int, names: dict[str, list[str]], stations: Array) -> dict[str, Any]:
    """The labels along each dimension; ``names`` are those of the links' dimensions."""
    info = {"units": "1", "long_name": "place along the link, 0 root, 1 tip"}
    labels = {
        "coordinate": list(run.coordinates),
        "deformation_kind": list(elastic_names(run.model)),
        "drive": list(run.drives),
        "controller_state": list(run.planned.plan.control_names),
        "point": [point.name for point in run.model.parts.points],
        "axis": list(AXES),
        "plane": ["y", "z"],
        "moment_kind": ["torsion", "y", "z"],
        "energy_kind": list(run.energies),
        "work_kind": list(run.works),
        **names,
    }
    return {
        "time": ("time", run.times[:count], {"units": "s", "long_name": "time"}),
        "s": ("s", stations, info),
        **_parents(run, names.get("link", [])),
        "coordinate_unit": ("coordinate", coordinate_units(run), {"long_name": "unit of each coordinate"}),
        **_control_units(run),
        **{
            name: (name, values, {"long_name": name.replace("_", " ")}) for name, values in labels.items() if values
        },
    }  # fmt: skip


def _parents(run: RunData, links: list[str]) -> dict[str, Any]:
    """The link on which each drawn link stands, the nearest that is drawn; "base" for those on the base."""
    found = [line_before(run.chain, name, links) or "base" for name in links]
    return {"link_parent": ("link", found, {"long_name": "link on which each link stands"})} if links else {}


def _control_units(run: RunData) -> dict[str, Any]:
    units = run.planned.plan.control_units
    info = {"long_name": "unit of each state of a controller"}
    return {"controller_state_unit": ("controller_state", list(units), info)} if units else {}


def coordinate_units(run: RunData) -> list[str]:
    """The unit of each coordinate: rad, m along prismatic joints, 1 of stretch."""
    sliding = run.chain.sliding
    joints = len(run.model.motors) + len(run.model.joints)
    return [
        ("m" if name in sliding else "rad")
        if k < joints
        else ("1" if name.rpartition(".")[2].startswith("stretch") else "rad")
        for k, name in enumerate(run.coordinates)
    ]


def motion_series(run: RunData, count: int) -> Variables:
    """Motion, drives, points, contact and energies of the first ``count`` samples, and those of the reference."""
    return {
        name: info
        for part in (_motion(run, count), _drives(run, count), _points(run, count), _contact(run, count),
                     _energies(run, count), _reference(run, count))
        for name, info in part.items()
        if info[1].size
    }  # fmt: skip


def _motion(run: RunData, count: int) -> Variables:
    dims, part = ("time", "coordinate"), slice(count)
    return {
        "q": (dims, run.q[part], _MIXED, "coordinates"),
        "v": (dims, run.v[part], f"({_MIXED}) s-1", "rates of the coordinates"),
        "a": (dims, run.a[part], f"({_MIXED}) s-2", "accelerations of the coordinates"),
        "deformation": (("time", "deformation_kind"), deflections(run.model, run.q[part]), _MIXED,
                        "elastic coordinates: gear output less input, and those of the links"),
    }  # fmt: skip


def _drives(run: RunData, count: int) -> Variables:
    dims, part = ("time", "drive"), slice(count)
    electric = any(node.joint.motor and node.joint.motor.resistance is not None for node in run.chain.nodes)
    found: Variables = {
        "wanted": (dims, run.wanted[part], "rad, m, V, N m or N, by its command", "value of the drive's signal"),
        "effort": (dims, run.effort[part], "N m, N along prismatic joints", "effort of the motor after the reducer"),
        "gear_torque": (dims, run.gear_torque[part], "N m, N along prismatic joints", "gear torque on the joint"),
    }
    found["controller_states"] = (
        ("time", "controller_state"), run.controls[part], "by controller_state_unit", "own states of the controllers",
    )  # fmt: skip
    if electric:
        found |= {
            "voltage": (dims, run.voltage[part], "V", "motor voltage"),
            "current": (dims, run.current[part], "A", "motor current"),
        }
    return found


def _points(run: RunData, count: int) -> Variables:
    dims, part, points = ("time", "point", "axis"), slice(count), run.points
    return {
        "position": (dims, points.position[part], "m", "position of the named points"),
        "velocity": (dims, points.velocity[part], "m s-1", "velocity of the named points"),
        "acceleration": (dims, points.acceleration[part], "m s-2", "acceleration of the named points"),
        "rotation": (("time", "point", "axis", "direction"), points.rotation[part], "1",
                     "axes of the named points (the directions, as columns) in the world"),
        "tip": (("time", "axis"), points.position[part, 0], "m", "tip position"),
        "tip_velocity": (("time", "axis"), points.velocity[part, 0], "m s-1", "tip velocity"),
    }  # fmt: skip


def _contact(run: RunData, count: int) -> Variables:
    if run.contact_force is None or run.contact_normal is None or run.penetration is None:
        return {}
    part = slice(count)
    return {
        "contact_force": (("time", "axis"), run.contact_force[part], "N", "force by the point on the surface"),
        "contact_force_normal": (("time",), run.contact_normal[part], "N", "its part into the surface"),
        "penetration": (("time",), run.penetration[part], "m", "how far the point is inside of the surface"),
    }


def _energies(run: RunData, count: int) -> Variables:
    energy, work = (np.column_stack([*kinds.values()])[:count] for kinds in (run.energies, run.works))
    work_text = "work since the start: of motor, loads and base comes in, the others go out"
    balance = run.energy_balance[:count]
    return {
        "energy": (("time", "energy_kind"), energy, "J", "energy"),
        "work": (("time", "work_kind"), work, "J", work_text),
        "energy_balance": (("time",), balance, "J", "energy less its start less work in plus work out"),
    }


def _reference(run: RunData, count: int) -> Variables:
    planned = run.reference
    if planned is None:
        return {}
    order = [planned.coordinates.index(name) for name in run.coordinates]
    part, dims = slice(count), ("time", "coordinate")
    tip, wanted = run.points.position[part, 0], planned.points.position[part, 0]
    found: Variables = {
        "q_reference": (dims, planned.q[part][:, order], _MIXED, "coordinates of the reference"),
        "v_reference": (dims, planned.v[part][:, order], f"({_MIXED}) s-1", "rates of the reference"),
        "deformation_reference": (("time", "deformation_kind"), deflections(planned.model, planned.q[part]), _MIXED,
                                  "elastic coordinates of the reference"),
        "gear_torque_reference": (("time", "drive"), planned.gear_torque[part], "N m, N along prismatic joints",
                                  "gear torque of the reference"),
        "tip_reference": (("time", "axis"), wanted, "m", "tip position of the reference"),
        "deviation": (("time",), np.linalg.norm(tip - wanted, axis=1), "m", "tip deviation from the reference"),
    }  # fmt: skip
    if planned.contact_normal is not None:
        text = "normal contact force of the reference"
        found["contact_force_normal_reference"] = (("time",), planned.contact_normal[part], "N", text)
    return found
