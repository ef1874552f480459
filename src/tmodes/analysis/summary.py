"""The numbers a reader asks first, from the dataset of a result."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import largest_flow
from tmodes.errors import InputError

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = [
    "first_frequencies",
    "info_deviation",
    "info_energy",
    "info_errors",
    "info_settling",
    "mean_over_time",
    "summarise",
]

Array = NDArray[np.float64]


def summarise(data: Dataset, band: float = 0.05) -> dict[str, Any]:
    """A plain dictionary of floats and words, ready for JSON; the unit is in the key. What is missing is None.

    ``band`` [-] is the share of the largest deviation within which the tip counts as settled, between 0 and 1;
    for the usual one the run itself was continued until it settled (:mod:`tmodes.result.settling`), for any other
    only the samples of the result are looked at. Raises :class:`tmodes.errors.InputError` for a band out of range.
    """
    if not 0 < band < 1:
        raise InputError("band", str(band), "a number between 0 and 1", "0.05 is the usual one")
    time = np.asarray(data["time"].values, dtype=float)
    return {
        "status": data.attrs["status"],
        "first_frequency_Hz": first_frequencies(data),
        "deviation": info_deviation(data, time),
        "settling": _settling(data, time, band),
        "deformations": _deformations(data, time),
        "largest_bending_moment": _largest_moment(data, time),
        "gear_torque": _largest_torque(data, time),
        "contact_force_radial": _contact(data, time),
        "energy": info_energy(data),
        "error": info_errors(data),
    }


def first_frequencies(data: Dataset) -> dict[str, float | None]:
    """The lowest frequency [Hz] with the motor locked, and the lowest that rings under control."""
    info = json.loads(data.attrs["frequencies"])
    return {
        case: min((line[key] for line in info.get(case, []) if line[key]), default=None)
        for case, key in (("locked", "frequency_Hz"), ("controlled", "damped_frequency_Hz"))
    }


def info_deviation(data: Dataset, time: Array) -> dict[str, float]:
    """The largest distance of the tip from its reference [m], when it is reached [s], and that at the end."""
    deviation = data["deviation"].values
    worst = int(np.argmax(deviation))
    return {"max_m": float(deviation[worst]), "time_of_max_s": float(time[worst]), "end_m": float(deviation[-1])}


def _settling(data: Dataset, time: Array, band: float) -> dict[str, Any]:
    """Time from the end of the reference move to the last instant at which the deviation is out of the band [s]."""
    known = json.loads(data.attrs.get("settling", "null"))
    if known and known["band"] == band:
        return known
    move_end = float(json.loads(data.attrs["robot"])["reference"]["duration"])
    return info_settling(data["deviation"].values, time, move_end, band)


def info_settling(deviation: Array, time: Array, move_end: float | None, band: float) -> dict[str, Any]:
    """Time from the end of the move to the last sample at which the deviation is out of the band [s].

    ``move_end`` [s] is None where what moves the tip changes up to the end of the run.
    """
    limit = band * float(deviation.max())
    info: dict[str, Any] = {"time_s": None, "band": band, "limit_m": limit, "reason": ""}
    if move_end is None:
        return info | {"reason": "what moves the arm changes up to the end of the run"}
    outside = time[(deviation > limit) & (time > move_end)]
    if time[-1] <= move_end * (1 + 1e-9):
        info["reason"] = f"the run ends at {time[-1]:g} s, the move at {move_end:g} s: simulate longer to see it settle"
    elif outside.size and outside[-1] == time[-1]:
        info["reason"] = f"the deviation is still {deviation[-1]:.3g} m when the run ends at {time[-1]:g} s"
    else:
        info["time_s"] = float(outside[-1] - move_end) if outside.size else 0.0
    return info


def _deformations(data: Dataset, time: Array) -> dict[str, dict[str, float | None]]:
    """Per deformation: largest size, of the real robot and of the reference, and rms deviation over rms reference."""
    real, reference = data["deformation"].values, data["deformation_reference"].values
    names = [str(name) for name in data["deformation_kind"].values]
    info: dict[str, dict[str, float | None]] = {}
    for name, is_, should in zip(names, real.T, reference.T, strict=True):
        size = np.sqrt(mean_over_time(time, should**2))
        info[name] = {
            "max_rad": float(np.abs(is_).max()),
            "max_reference_rad": float(np.abs(should).max()),
            "rms_deviation_over_rms_reference": float(np.sqrt(mean_over_time(time, (is_ - should) ** 2)) / size)
            if size
            else None,
        }
    return info


def _largest_moment(data: Dataset, time: Array) -> dict[str, Any]:
    """The bending moment of the largest size: its value with its sign, when and where."""
    moment = data["bending_moment"].values
    k, mode, plane, s = np.unravel_index(np.argmax(np.abs(moment)), moment.shape)
    return {
        "value_Nm": float(moment[k, mode, plane, s]),
        "time_s": float(time[k]),
        "mode": str(data["mode"].values[mode]),
        "plane": str(data["plane"].values[plane]),
        "s": float(data["s"].values[s]),
    }


def _largest_torque(data: Dataset, time: Array) -> dict[str, float]:
    torque = data["gear_torque"].values
    worst = int(np.argmax(np.abs(torque)))
    return {"max_Nm": float(abs(torque[worst])), "time_s": float(time[worst])}


def _contact(data: Dataset, time: Array) -> dict[str, float] | None:
    """Least, largest and mean radial force [N]; None in free space."""
    if "contact_force_radial" not in data:
        return None
    force = data["contact_force_radial"].values
    return {"min_N": float(force.min()), "max_N": float(force.max()), "mean_N": mean_over_time(time, force)}


def info_energy(data: Dataset) -> dict[str, float | None]:
    """Energy moved (the largest change of one energy, or one work), and the worst residual of the balance over it."""
    moved = largest_flow(data["energy"].values, data["work"].values)
    worst = float(np.abs(data["energy_balance"].values).max())
    return {"moved_J": moved, "worst_residual_J": worst, "worst_residual_over_moved": worst / moved if moved else None}


def info_errors(data: Dataset) -> dict[str, Any] | None:
    """How the error of the integration was estimated, and that of each figure by its path; None where it is unknown."""
    return json.loads(data.attrs.get("errors", "null")) or None


def mean_over_time(time: Array, values: Array) -> float:
    """Mean over time; the last sample may follow a shorter step."""
    return float(np.trapezoid(values, time) / (time[-1] - time[0])) if len(time) > 1 else float(values[0])
