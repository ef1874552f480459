"""The numbers a reader asks first of a robot's run, from the dataset of its result."""

from __future__ import annotations

import json
from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.energy import largest_flow, stands
from tmodes.analysis.worst import worst_place
from tmodes.chain.chain import joint_of_element
from tmodes.frame import along
from tmodes.integrate.conditions import Band
from tmodes.io.words import element_words
from tmodes.result.derived import Derives, failed_in
from tmodes.result.settling import USUAL, not_settled, plain_vibration, settling, vibration

if TYPE_CHECKING:
    from tmodes.io.labelled import Record

__all__ = [
    "TIP", "largest_deviation", "largest_elements", "mean_over_time", "settling_words",
    "summarise_result", "tip_errors", "vibration_words", "vibrations",
]  # fmt: skip

Array = NDArray[np.float64]

MOST_ENTRIES = 40
"""Deformations that are reported, the largest ones."""


def summarise_result(
    data: Record, band: Band | None = None, settled: Callable[[Band], dict[str, Any]] | None = None
) -> dict[str, Any]:
    """A plain dictionary of floats and words, ready for JSON; units are in the keys. What is missing is None.

    ``band``: within which the tip counts as settled, None: the robot's own, for which the run itself was continued
    (:mod:`tmodes.result.settling`); for any other ``settled`` continues it, else its samples are looked at.
    ``point``: whose errors, settling and vibration these are, the tip's unless it cannot show the motion, and why.
    A group that cannot be computed is empty, and stands in ``not_computed`` with the reason.
    """
    time, groups = np.asarray(data["time"].values, dtype=float), Derives()
    found: dict[str, Any] = {"status": data.attrs["status"]}
    for name, (compute, without) in _GROUPS.items():
        found[name] = groups.attempt(name, partial(compute, data, time), without)
    found["settling"] = groups.attempt(
        "settling", partial(_settling, data, time, band, settled), lambda reason: not_settled(reason, band or USUAL)
    )
    if other := json.loads(data.attrs.get("headline", "null")):
        found |= {key: other[key] for key in ("tip_error", "deviation")}
        found |= {key: _of_others(found[key]) for key in ("error", "model_error")}
    point = {key: other[key] for key in ("name", "reason")} if other else {"name": TIP, "reason": ""}
    return found | {"point": point, "not_computed": failed_in(data) | groups.failed}


TIP = "tip"
"""The point by which a run is judged, unless it cannot show the motion."""


def _of_others(errors: dict[str, Any] | None) -> dict[str, Any] | None:
    """Errors of numbers, without those of the tip."""
    if not errors:
        return errors
    kept = {name: one for name, one in errors["figures"].items() if not name.startswith(("deviation.", "tip_error."))}
    return errors | {"figures": kept}


def _settling(
    data: Record, time: Array, band: Band | None, settled: Callable[[Band], dict[str, Any]] | None
) -> dict[str, Any]:
    known = json.loads(data.attrs.get("settling", "null"))
    own = known and "move_m" in known  # an earlier version had another rule
    if own and (band is None or band.words == known.get("within", Band(known["band"]).words)):
        return known
    if settled and band:
        return settled(band)
    if data.attrs.get("headline", "null") != "null":
        return not_settled("another band takes the run itself: tmodes run --settling-band", band or USUAL)
    end, rates = json.loads(data.attrs["move_end"]), _path(data, "tip_velocity") if "tip_velocity" in data else None
    return settling(time, _path(data, "tip"), rates, end, float(time[-1]), band or USUAL)


def _path(data: Record, name: str) -> Array:
    return data[name].transpose("time", "axis").values


def vibrations(data: Record) -> dict[str, Any]:
    """Residual vibration of the ``actual`` and ``nominal`` tip; of a file of an earlier version, from its samples."""
    if "vibration" in data.attrs:
        return json.loads(data.attrs["vibration"])
    end, time = json.loads(data.attrs["move_end"]), np.asarray(data["time"].values, dtype=float)
    paths = {"actual": "tip", "nominal": "tip_nominal"}
    return {
        which: plain_vibration(vibration(time, _path(data, name), end)) for which, name in paths.items() if name in data
    }


def settling_words(known: dict[str, Any], length: Callable[[float], str]) -> str:
    """The band of a settling, or why none is seen: by what was looked at, and what ended that; ``length`` in words."""
    if known["time_s"] is None:
        cut = known.get("cut", "")
        return f"not seen: {'; '.join(filter(None, [known['reason'], cut * (cut not in known['reason'])]))}"
    band = known.get("within") or Band(known["band"]).words  # an earlier version had shares alone
    return known["reason"] or f"within {length(known['limit_m'])} of its rest, {band}"


def vibration_words(one: dict[str, Any], length: Callable[[float], str]) -> str:
    """A residual vibration besides its amplitude: what is seen of it, its strongest modes; ``length`` in words."""
    said = [one["reason"]]
    if one.get("largest_m"):
        axes = ", ".join(f"{axis} {length(size)}" for axis, size in one["along_m"].items() if size)
        said.append(f"farthest from its mean {length(one['largest_m'])} ({axes})")
    if modes := [mode for mode in one["modes"] if mode["amplitude_m"] > _WEAK * one["amplitude_m"]][:_MOST_MODES]:
        said.append(", ".join(_mode_words(mode, length) for mode in modes))
        further = sum(mode.get("share", 0.0) for mode in one["modes"] if mode not in modes)
        said.append(f"{100 * further:.0f} % in weaker modes, {100 * one.get('unexplained', 0.0):.0f} % in no mode")
    return "; ".join(filter(None, [*said, one.get("cut", "")]))


def _mode_words(mode: dict[str, Any], length: Callable[[float], str]) -> str:
    named = [element_words(mode.get("element", ""))]
    if drift := mode.get("drift_Hz"):
        named.append(f"{drift[0]:.3g} to {drift[1]:.3g} Hz as it decays")
    if mode.get("share", 0.0) >= _SAID:
        named.append(f"{100 * mode['share']:.0f} %")
    more = ", ".join(filter(None, named))
    return f"{length(mode['amplitude_m'])} at {mode['frequency_Hz']:.3g} Hz{more and f' ({more})'}"


_SAID = 0.005
"""Share of the energy of a vibration from which on it is said."""

_MOST_MODES, _WEAK = 3, 0.01
"""Modes of a vibration that are named, and share of it below which a mode is not."""


def _joints(data: Record, time: Array) -> dict[str, dict[str, Any]]:
    """Per driven joint: its unit, range, fastest rate, largest effort and when, largest torque of its gear."""
    if "drive" not in data.dims:
        return {}
    info = {}
    for name in map(str, data["drive"].values):
        q, v = (data[key].sel(coordinate=name).values for key in ("q", "v"))
        effort = data["effort"].sel(drive=name).values
        (worst,) = worst_place(effort)
        info[name] = {
            "unit": str(data["coordinate_unit"].sel(coordinate=name).values),
            "least": float(q.min()),
            "largest": float(q.max()),
            "fastest": float(np.abs(v).max()),
            "largest_effort": float(effort[worst]),
            "time_of_largest_effort_s": float(time[worst]),
            "largest_gear_torque": float(np.abs(data["gear_torque"].sel(drive=name).values).max()),
        }
    return info


def _deformations(data: Record, time: Array) -> dict[str, dict[str, Any]]:
    """Per elastic coordinate, the largest ones: largest size, of T_st and T_to (where known), of the nominal run."""
    if "deformation" not in data:
        return {}
    names = [str(name) for name in data["deformation_kind"].values]
    sizes = {key: np.abs(data[key].values).max(axis=0) for key in _PARTS if key in data}
    largest = np.argsort(-sizes["deformation"], kind="stable")[:MOST_ENTRIES]
    when = [time[worst_place(values)] for values in data["deformation"].values.T]
    units = _deformation_units(data, names)
    found = {}
    for k in sorted(largest):
        known = {_PARTS[key]: float(size[k]) for key, size in sizes.items()}
        if known.get("max_stationary", 0.0) > _CANCEL * known["max"]:
            known = {key: value for key, value in known.items() if key not in ("max_stationary", "max_oscillatory")}
        found[names[k]] = {"unit": units[k], "time_of_max_s": float(when[k])} | known
    return found


_CANCEL = 2.0
"""T_st over the deflection above which T_st and T_to cancel (motors that jerk, loads that nothing holds): not given."""

_PARTS = {
    "deformation": "max",
    "deformation_stationary": "max_stationary",
    "deformation_oscillatory": "max_oscillatory",
    "deformation_nominal": "max_nominal",
}


def _deformation_units(data: Record, names: list[str]) -> list[str]:
    units = dict(zip(map(str, data["coordinate"].values), map(str, data["coordinate_unit"].values), strict=True))
    return [units.get(name, units.get(joint_of_element(name), "rad")) for name in names]


def _links(data: Record, time: Array) -> dict[str, dict[str, Any]]:
    """Per link that bends: largest deflection of its end, moment (bending) and stress, with when and where."""
    if "deflection" not in data:
        return {}
    stressed = list(map(str, data["stressed_link"].values)) if "stressed_link" in data.dims else []
    info = {}
    for name in map(str, data["bending_link"].values):
        tip = np.linalg.norm(data["deflection"].sel(bending_link=name).isel(s=-1).values, axis=-1)
        bending = data["moment"].sel(bending_link=name, moment_kind=["y", "z"]).transpose("time", "s", "moment_kind")
        info[name] = {
            "deflection": _worst(tip[:, None], time, np.ones(1), "max_m"),
            "bending_moment": _worst(np.linalg.norm(bending.values, axis=-1), time, data["s"].values, "max_Nm"),
            "stress": None,
        }
        if name in stressed:
            values = data["stress"].sel(stressed_link=name).transpose("time", "s").values
            info[name]["stress"] = _worst(values, time, data["s"].values, "max_Pa")
    return info


def _worst(values: Array, time: Array, s: Array, key: str) -> dict[str, float]:
    k, place = worst_place(values)
    return {key: float(values[k, place]), "time_s": float(time[k]), "s": float(s[place])}


def _contact(data: Record, time: Array) -> dict[str, float] | None:
    """Least, largest and mean force into the surface [N], share of the time in touch; None in free space."""
    if "contact_force_normal" not in data:
        return None
    force, depth = data["contact_force_normal"].values, data["penetration"].values
    if "surface_displacement" in data:  # of a surface with mass: from its rest
        depth = depth + data["surface_displacement"].values
    return {
        "min_N": float(force.min()),
        "max_N": float(force.max()),
        "mean_N": mean_over_time(time, force),
        "deepest_m": float(depth.max()),
    }


def _first_frequencies(data: Record) -> dict[str, float | None]:
    """The natural frequency [Hz] of the lowest mode that rings, with the motor locked and controlled."""
    info = json.loads(data.attrs["frequencies"])
    ringing = {case: [line for line in info.get(case, []) if line["damped_frequency_Hz"]] for case in _CASES}
    return {case: min((line["frequency_Hz"] for line in lines), default=None) for case, lines in ringing.items()}


_CASES = ("locked", "controlled")


def _deviation(data: Record, time: Array) -> dict[str, float] | None:
    """The largest distance of the actual tip from the nominal one [m], when it is reached [s], and that at the end."""
    if "deviation" not in data:
        return None
    return largest_deviation(data["deviation"].values, time)


def largest_deviation(deviation: Array, time: Array) -> dict[str, float]:
    """The largest of distances (n,) [m], when, and the last."""
    (worst,) = worst_place(deviation)
    return {"max_m": float(deviation[worst]), "time_of_max_s": float(time[worst]), "end_m": float(deviation[-1])}


def _energy(data: Record) -> dict[str, float | None]:
    """Energy moved (see :func:`largest_flow`), and the worst residual of the balance over it; None of rounding."""
    moved, there = largest_flow(data["energy"].values, data["work"].values), np.abs(data["energy"].values).max()
    worst = float(np.abs(data["energy_balance"].values).max())
    share = None if stands(moved, float(there)) else worst / moved
    return {"moved_J": moved, "worst_residual_J": worst, "worst_residual_over_moved": share}


def _errors(data: Record, which: str) -> dict[str, Any] | None:
    """How the error of integration or model was estimated, and that of each figure by its path; None where unknown.

    ``approximate``: which of them are no bounds; of the integration all that an earlier version wrote.
    """
    info = json.loads(data.attrs.get(which, "null")) or None
    return info and {"approximate": list(info["figures"]) if which == "errors" else []} | info


def mean_over_time(time: Array, values: Array) -> float:
    """Mean over time; the last sample may follow a shorter step."""
    return float(np.trapezoid(values, time) / (time[-1] - time[0])) if len(time) > 1 else float(values[0])


def tip_errors(data: Record) -> dict[str, dict[str, Any]]:
    """Of the error against the ``commanded`` and the ``nominal`` path: the largest, when, at the end, and its parts.

    ``parts_m``: components along the largest error, which add up to it and may be negative; ``vectors_m`` [m].
    ``elements_m``: the same of each gear and link; ``environment_m``: what of gears and links is by the contact force,
    see :func:`tmodes.result.elements.element_errors`; both are not known of files of earlier versions.
    """
    found, details = {}, json.loads(data.attrs.get("tip_error_elements", "{}"))
    for which, series in (("commanded", "tip_error"), ("nominal", "tip_error_nominal")):
        if series not in data:
            continue
        parts = data[series].transpose("time", "error_part", "axis").values
        size = np.linalg.norm(parts.sum(axis=1), axis=1)
        (worst,), names = worst_place(size), [str(name) for name in data["error_part"].values]
        found[which] = {
            "max_m": float(size[worst]),
            "time_of_max_s": float(data["time"].values[worst]),
            "end_m": float(size[-1]),
            "parts_m": dict(zip(names, along(parts[worst]).tolist(), strict=True)),
            "vectors_m": dict(zip(names, parts[worst].tolist(), strict=True)),
            **{f"{key}_m": value for key, value in details.get(which, {}).items()},
        }
    return found


def largest_elements(one: dict[str, Any]) -> list[tuple[str, float]]:
    """Names and components [m] of the gears and links that have most of one of the :func:`tip_errors`, at most four."""
    named = [
        (f"{part.removesuffix('s')} {name}", value)
        for part, parts in one.get("elements_m", {}).items()
        for name, value in parts.items()
    ]
    return sorted((item for item in named if item[1]), key=lambda item: -abs(item[1]))[:_MOST_ELEMENTS]


_MOST_ELEMENTS = 4


_GROUPS: dict[str, tuple[Callable[[Any, Array], Any], Callable[[str], Any]]] = {
    "first_frequency_Hz": (lambda data, time: _first_frequencies(data), lambda reason: dict.fromkeys(_CASES)),
    "deviation": (_deviation, lambda reason: None),
    "tip_error": (lambda data, time: tip_errors(data), lambda reason: {}),
    "vibration": (lambda data, time: vibrations(data), lambda reason: {}),
    "joints": (_joints, lambda reason: {}),
    "deformations": (_deformations, lambda reason: {}),
    "links": (_links, lambda reason: {}),
    "contact_force": (_contact, lambda reason: None),
    "energy": (lambda data, time: _energy(data), lambda reason: None),
    "error": (lambda data, time: _errors(data, "errors"), lambda reason: None),
    "model_error": (lambda data, time: _errors(data, "model_errors"), lambda reason: None),
}
"""Groups of a summary: how each is computed, and what stands there where it cannot be."""
