"""The series of a run by name, each with its dimensions, unit and meaning: motion, drives, points, energies."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.error_parts import without_elasticity
from tmodes.analysis.quasistatic import deflections, elastic_names
from tmodes.chain.chain import line_before
from tmodes.io.labelled import Record
from tmodes.io.units import udunits
from tmodes.result.paths import error_parts
from tmodes.simulation.motion_run import RunData

__all__ = [
    "MIXED", "Series", "Variables", "coordinates_of", "error_series", "motion_series", "over_time",
    "record_of", "run_wrenches", "straight_shape",
]  # fmt: skip

Array = NDArray[np.float64]

Variables = dict[str, tuple[tuple[str, ...], Array, str, str]]
"""Dimensions, values, unit and long name of each variable."""

Series = dict[str, tuple[str, Array | None, str, str]]
"""The same over time: the names of the further dimensions, values (None: there are none), unit and long name."""

MIXED = "rad, m along prismatic joints, 1 of stretch"

_EFFORT = "N m, N along prismatic joints"

AXES = ("x", "y", "z")


def over_time(series: Series, count: int) -> Variables:
    """The variables of the first ``count`` samples; what is empty is left out."""
    return {
        name: (("time", *dims.split()), values[:count], unit, text)
        for name, (dims, values, unit, text) in series.items()
        if values is not None and values.size
    }


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
    links = names.get("link", [])
    further = {
        "link_parent": ("link", [line_before(run.chain, name, links) or "base" for name in links],
                        "link on which each link stands"),  # the nearest that is drawn
        "coordinate_unit": ("coordinate", [udunits(unit) for unit in run.chain.units(run.coordinates).values()],
                            "unit of each coordinate"),
        "controller_state_unit": ("controller_state", list(run.planned.plan.control_units),
                                  "unit of each state of a controller"),
    } | {name: (name, values, name.replace("_", " ")) for name, values in labels.items()}  # fmt: skip
    return {
        "time": ("time", run.times[:count], {"units": "s", "long_name": "time"}),
        "s": ("s", stations, info),
        **{name: (dim, values, {"long_name": text}) for name, (dim, values, text) in further.items() if values},
    }


def record_of(variables: Variables, coordinates: dict[str, Any]) -> Record:
    """The variables as a record with the labels of :func:`coordinates_of`."""
    series = {
        name: (dims, values, {"units": unit, "long_name": text})
        for name, (dims, values, unit, text) in variables.items()
    }
    labels = {name: ((dim,), np.asarray(values), info) for name, (dim, values, info) in coordinates.items()}
    return Record(series | labels, labels)


def motion_series(run: RunData, count: int) -> Variables:
    """Motion, drives, points, contact and energies of the first ``count`` samples, and those of the nominal run."""
    points = run.points
    electric = any(node.joint.motor and node.joint.motor.resistance is not None for node in run.chain.nodes)
    energy, work = (np.column_stack([*kinds.values()]) for kinds in (run.energies, run.works))
    moved = (None, None) if run.surface is None else run.surface.T
    series: Series = {
        "q": ("coordinate", run.q, MIXED, "coordinates"),
        "v": ("coordinate", run.v, f"({MIXED}) s-1", "rates of the coordinates"),
        "a": ("coordinate", run.a, f"({MIXED}) s-2", "accelerations of the coordinates"),
        "deformation": ("deformation_kind", deflections(run.model, run.q[:count]), MIXED,
                        "elastic coordinates: gear output less input, and those of the links"),
        "wanted": ("drive", run.wanted, "rad, m, V, N m or N, by its command", "value of the drive's signal"),
        "effort": ("drive", run.effort, _EFFORT, "effort of the motor after the reducer"),
        "gear_torque": ("drive", run.gear_torque, _EFFORT, "gear torque on the joint"),
        "controller_states": ("controller_state", run.controls, "by controller_state_unit",
                              "own states of the controllers"),
        "voltage": ("drive", run.voltage if electric else None, "V", "motor voltage"),
        "current": ("drive", run.current if electric else None, "A", "motor current"),
        "position": ("point axis", points.position, "m", "position of the named points"),
        "velocity": ("point axis", points.velocity, "m s-1", "velocity of the named points"),
        "acceleration": ("point axis", points.acceleration, "m s-2", "acceleration of the named points"),
        "rotation": ("point axis direction", points.rotation, "1",
                     "axes of the named points (the directions, as columns) in the world"),
        "tip": ("axis", points.position[:, 0], "m", "tip position"),
        "tip_velocity": ("axis", points.velocity[:, 0], "m s-1", "tip velocity"),
        "contact_force": ("axis", run.contact_force, "N", "force by the point on the surface"),
        "contact_force_normal": ("", run.contact_normal, "N", "its part into the surface"),
        "penetration": ("", run.penetration, "m", "how far the point is inside of the surface, where that is"),
        "surface_displacement": ("", moved[0], "m", "displacement of a surface with mass, along the push on it"),
        "surface_velocity": ("", moved[1], "m s-1", "velocity of a surface with mass, along the push on it"),
        "energy": ("energy_kind", energy, "J", "energy"),
        "work": ("work_kind", work, "J", "work since the start: of motor, loads and base comes in, the others go out"),
        "energy_balance": ("", run.energy_balance, "J", "energy less its start less work in plus work out"),
    }  # fmt: skip
    return over_time(series, count) | (_reference(run, run.reference, count) if run.reference else {})


def error_series(run: RunData, count: int) -> Variables:
    """The commanded path of the tip, and its error by cause; nothing where no drive has a setpoint."""
    parts = error_parts(run, count)
    if parts is None:
        return {}
    text = "parts of the error of the tip, which add up to it: actual less"
    series: Series = {
        "tip_commanded": ("axis", parts.commanded, "m", "tip of the undeformed nominal robot at the setpoints"),
        "tip_error": ("error_part axis", parts.to_commanded, "m", f"{text} commanded"),
        "tip_error_nominal": ("error_part axis", parts.to_nominal, "m", f"{text} nominal"),
    }
    return over_time(series, count)


def _reference(run: RunData, planned: RunData, count: int) -> Variables:
    order = [planned.coordinates.index(name) for name in run.coordinates]
    tip, wanted = (one.points.position[:count, 0] for one in (run, planned))
    series: Series = {
        "q_nominal": ("coordinate", planned.q[:, order], MIXED, "coordinates of the nominal run"),
        "v_nominal": ("coordinate", planned.v[:, order], f"({MIXED}) s-1", "rates of the nominal run"),
        "deformation_nominal": ("deformation_kind", deflections(planned.model, planned.q[:count]), MIXED,
                                  "elastic coordinates of the nominal run"),
        "gear_torque_nominal": ("drive", planned.gear_torque, _EFFORT, "gear torque of the nominal run"),
        "tip_nominal": ("axis", wanted, "m", "nominal tip position"),
        "deviation": ("", np.linalg.norm(tip - wanted, axis=1), "m", "distance of the actual tip from the nominal one"),
        "contact_force_normal_nominal": ("", planned.contact_normal, "N", "normal contact force of the nominal run"),
    }  # fmt: skip
    return over_time(series, count)


def run_wrenches(run: RunData) -> Array:
    """Force and moment by the surroundings on each named point at each sample, world axes, (n, points, 6)."""
    plan = run.planned
    wrenches = np.zeros((len(run.times), len(run.model.parts.points), 6))
    for load in plan.plan.loads:
        factor = np.ones(len(run.times)) if load.signal < 0 else plan.signals.at(run.times)[:, load.signal]
        wrench = np.broadcast_to(np.reshape(load.wrench, (2, 3)), (len(run.times), 2, 3))
        if load.follower:
            wrench = np.einsum("nij,nkj->nki", run.points.rotation[:, load.point], wrench)
        wrenches[:, load.point] += factor[:, None] * wrench.reshape(-1, 6)
    if plan.plan.touch and run.contact_force is not None:
        wrenches[:, plan.plan.touch.point, :3] -= run.contact_force
    return wrenches


def straight_shape(run: RunData) -> Array:
    """Coordinates (n, nq) of a run's robot without any elasticity, its motors where they are."""
    return without_elasticity(run.model, run.q)
