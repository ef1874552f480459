"""From two trajectories to a Result: every quantity named, with its unit, and the provenance of the run."""

from __future__ import annotations

import json
import math
import platform
from importlib.metadata import version
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import balance
from tmodes.analysis.stability import StepVerdict, step_times_eigenvalue
from tmodes.analysis.validity import (
    deflection_warnings,
    energy_warnings,
    first_energy_error,
    held_warnings,
    jam_warnings,
    start_warnings,
)
from tmodes.equations.lagrange.coordinates import deformations
from tmodes.equations.lagrange.layout import COORDINATES, DEFORMATIONS, ENERGIES, LINE, WORKS
from tmodes.paper.mechanism import Parameters
from tmodes.paper.regime import PaperRun
from tmodes.paper.sheet import PaperPair
from tmodes.result.record import RESULT_FORMAT, PaperResult
from tmodes.simulation.trajectory import STOPPED

__all__ = ["assemble", "series_of"]

_COORDINATES: dict[str, Any] = {
    "coordinate": list(COORDINATES),
    "axis": ["x", "y", "z"],
    "deformation_kind": list(DEFORMATIONS),
    "mode": ["mode1", "mode2"],
    "plane": ["horizontal", "vertical"],
    "energy_kind": list(ENERGIES),
    "work_kind": list(WORKS),
}

_LINE_UNITS = {
    "line": ("m", "position of the elastic line"),
    "deflection": ("m", "deflection of the elastic line from the root's tangent"),
    "slope": ("rad", "slope of the elastic line against the root's tangent"),
    "bending_moment": ("N m", "bending moment of all loads outboard, from the dynamics"),
    "flexibility_moment": ("N m", "flexibility moment of the curvature and its damping"),
    "shear_force": ("N", "shear force of all loads outboard"),
}

Variables = dict[str, tuple[tuple[str, ...], NDArray[np.float64], str, str]]
"""Dimensions, values, unit and long name of each variable."""

Observed = dict[str, NDArray[np.float64]]
"""What a model gives at each sample, by the names of ``OBSERVED``."""


def assemble(
    pair: PaperPair,
    reference: PaperRun,
    real: PaperRun,
    info: dict[str, Any],
    verdict: StepVerdict,
) -> PaperResult:
    """Gather all that a result shows; the time axis is the real robot's, as far as both regimes came.

    ``reported``: what analyses found (frequencies, settling, warnings), plain data that is kept as JSON.
    """
    import xarray as xr

    count = min(len(reference.trajectory.times), len(real.trajectory.times))
    seen, held, found = _held(real, count)
    variables = _tracking(real, reference, seen, held) | _line(real, seen, count)
    data = xr.Dataset(
        {
            name: (dims, values, {"units": unit, "long_name": text})
            for name, (dims, values, unit, text) in variables.items()
        },
        coords={
            "time": ("time", real.trajectory.times[:count], {"units": "s", "long_name": "time"}),
            "s": ("s", _stations(real), {"units": "1", "long_name": "place along the mode, 0 root, 1 tip"}),
            **{name: (name, values, {"long_name": name.replace("_", " ")}) for name, values in _COORDINATES.items()},
        },
    )
    status, message = _ending(reference, real, verdict)
    settings = pair.real.integration
    if settings.energy_stop and (bad := first_energy_error(data, settings.energy_tolerance)) is not None:
        status, message = "stopped", f"the energy balance was lost at t = {float(data['time'][bad]):.4g} s"
        data = data.isel(time=slice(0, max(bad, 1)))
    notices = [*jam_warnings(real.trajectory.times, seen["contact_fold"]), *held_warnings(real.trajectory.times, found)]
    info = info | {"warnings": [*info["warnings"], *_warnings(pair, data, verdict), *notices]}
    data.attrs = _provenance(pair, real, reference, verdict) | {"status": status, "message": message}
    data.attrs |= {name: json.dumps(value) for name, value in info.items()}
    return PaperResult(data)


def series_of(real: PaperRun, reference: PaperRun, count: int) -> Variables:
    """The series of the first ``count`` samples of a run and its reference."""
    seen, held, _ = _held(real, count)
    return _tracking(real, reference, seen, held) | _line(real, seen, count)


def _held(real: PaperRun, count: int) -> tuple[Observed, NDArray[np.float64], NDArray[np.bool_]]:
    """What is observed; the deformations that its loads would hold statically; and where these were found."""
    seen, states = real.observed(count), real.trajectory.states[:count]
    return seen, *real.model.quasistatic(_gross(states, seen), _angles(states), real.parameters)


def _angles(states: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.stack(deformations(states[:, :6].T), axis=1)


def _tracking(real: PaperRun, reference: PaperRun, seen: Observed, held: NDArray[np.float64]) -> Variables:
    """Everything but the line: motion, tracking, forces, deformations, energies.

    ``seen`` of the real robot; ``held`` are the deformations that its loads would hold statically.
    """
    count = len(held)
    states, wanted = real.trajectory.states[:count], reference.trajectory.states[:count]
    planned, angles = reference.observed(count), _angles(states)
    works = states[:, 12:]
    t = ("time",)
    series: Variables = {
        "q": ((*t, "coordinate"), states[:, :6], "rad", "generalized coordinates"),
        "v": ((*t, "coordinate"), states[:, 6:12], "rad s-1", "rates of the coordinates"),
        "q_reference": ((*t, "coordinate"), wanted[:, :6], "rad", "generalized coordinates of the reference"),
        "v_reference": ((*t, "coordinate"), wanted[:, 6:12], "rad s-1", "rates of the reference"),
        "theta_wanted": (t, seen["wanted"], "rad", "wanted motor angle theta_o"),
        "voltage": (t, seen["voltage"], "V", "motor voltage"),
        "current": (t, seen["current"], "A", "motor current"),
        "tip": ((*t, "axis"), seen["tip"], "m", "tip position"),
        "tip_velocity": ((*t, "axis"), seen["tip_velocity"], "m s-1", "tip velocity"),
        "tip_reference": ((*t, "axis"), planned["tip"], "m", "tip position of the reference"),
        "deviation": (t, np.linalg.norm(seen["tip"] - planned["tip"], axis=1), "m", "tip deviation from the reference"),
        "deformation": ((*t, "deformation_kind"), angles, "rad", "elastic angles"),
        "deformation_reference": ((*t, "deformation_kind"), _angles(wanted), "rad", "elastic angles of the reference"),
        "deformation_stationary": ((*t, "deformation_kind"), held, "rad", "stationary part T_st of the elastic angles"),
        "deformation_oscillatory": ((*t, "deformation_kind"), angles - held, "rad", "oscillatory part T_to"),
        "gear_torque": (t, seen["gear_torque"], "N m", "gear torque"),
        "gear_torque_reference": (t, planned["gear_torque"], "N m", "gear torque of the reference"),
        "energy": ((*t, "energy_kind"), seen["energy"], "J", "energy"),
        "work": ((*t, "work_kind"), works, "J", "work since the start: the motor's comes in, the others go out"),
        "energy_balance": (t, balance(seen["energy"], works), "J", "energy less its start less work in plus work out"),
    }
    if real.model.mechanism.contact:
        series |= {
            "contact_force": ((*t, "axis"), seen["contact_force"], "N", "force by the tip on the environment"),
            "contact_force_radial": (t, seen["radial_force"], "N", "radial contact force Fc"),
            "contact_force_radial_reference": (t, planned["radial_force"], "N", "radial contact force, reference"),
        }
    return series


def _gross(states: NDArray[np.float64], seen: Observed) -> NDArray[np.float64]:
    """Motor motion and contact force: what moves and loads the arm if its elastic motion stands still."""
    motor = [states[:, 5], states[:, 11], seen["acceleration"][:, 5]]
    return np.column_stack([*motor, seen["contact_force"]])


def _stations(real: PaperRun) -> NDArray[np.float64]:
    """Points s of each mode at which the elastic line is kept."""
    return np.linspace(0.0, 1.0, real.robot.integration.line_points)


def _line(real: PaperRun, seen: Observed, count: int) -> Variables:
    """The elastic line of both modes at the stations."""
    motion = np.column_stack([real.trajectory.states[:count, :12], seen["acceleration"], seen["contact_force"]])
    line = real.model.line(motion, _stations(real), real.parameters)
    series: Variables = {}
    for name in LINE:
        unit, text = _LINE_UNITS[name]
        if name == "line":
            series[name] = (("time", "mode", "s", "axis"), line[name], unit, text)
        else:
            series[name] = (("time", "mode", "plane", "s"), np.swapaxes(line[name], 2, 3), unit, text)
    return series


def _ending(reference: PaperRun, real: PaperRun, verdict: StepVerdict) -> tuple[str, str]:
    """Status and sentence of the whole run; a run at an unstable step is never called finished."""
    for name, regime in (("reference", reference), ("real robot", real)):
        if regime.trajectory.status == STOPPED and verdict.stable:
            return STOPPED, regime.trajectory.message
        if regime.trajectory.status != "finished":
            cause = f"; likely cause: {verdict.sentence}" if verdict.sentence else ""
            return regime.trajectory.status, f"{name}: {regime.trajectory.message}{cause}"
    if not verdict.stable:
        return "diverged", f"the end was reached, but not by the robot's motion: {verdict.sentence}"
    return "finished", real.trajectory.message


def _warnings(pair: PaperPair, data: Any, verdict: StepVerdict) -> list[str]:
    info = [verdict.sentence] if verdict.sentence else []
    return [*info, *start_warnings(data, pair.real), *deflection_warnings(data),
            *energy_warnings(data, pair.real.integration.energy_tolerance)]  # fmt: skip


def _provenance(pair: PaperPair, real: PaperRun, reference: PaperRun, verdict: StepVerdict) -> dict[str, Any]:
    packages = ("tmodes", "numpy", "casadi", "llvmlite", "xarray")
    counts = {name: regime.trajectory.statistics for name, regime in (("reference", reference), ("real", real))}
    dt_omega = step_times_eigenvalue(verdict, counts["real"])
    statistics = counts | {"highest_eigenvalue": verdict.highest, "dt_omega": dt_omega}
    return {
        "tmodes_format": RESULT_FORMAT,
        "title": pair.nominal.title or pair.nominal.name,
        "robot": pair.nominal.model_dump_json(),
        "robot_real": pair.real.model_dump_json(),
        "mechanism": real.model.mechanism.key,
        "reading": real.model.mechanism.reading.value,
        "parameters": _numbers(real.parameters),
        "parameters_nominal": _numbers(reference.parameters),
        "versions": json.dumps({name: version(name) for name in packages} | {"python": platform.python_version()}),
        "statistics": json.dumps(statistics),
    }


def _numbers(parameters: Parameters) -> str:
    """Parameters as JSON, which has no number for an infinite stiffness (rigid by wish): it is the word "Infinity"."""
    return json.dumps({name: value if math.isfinite(value) else "Infinity" for name, value in parameters.items()})
