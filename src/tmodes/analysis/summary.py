"""Numbers that a reader asks first: deviation, settling, energy, errors, from the dataset of a result."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import largest_flow

if TYPE_CHECKING:
    from xarray import Dataset

__all__ = ["first_frequencies", "info_deviation", "info_energy", "info_errors", "info_settling", "mean_over_time"]

Array = NDArray[np.float64]


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
