"""All numbers that a page shows of a run, beside those of a native run of the same sheet."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from tmodes import Result
from tmodes.report.data import page_data

__all__ = ["EQUAL", "different", "near"]

EQUAL = 1e-6

MOST_RESIDUAL = 1e-8
"""Of a balance of energies, whose tenth digit and beyond is rounding."""

NOTHING = 1e-12
"""A length [m] or share of rounding."""


def different(own: dict[str, Any], result: Result) -> list[str]:
    """What the page has otherwise: facts, fields of the verdict, least and largest values of curves, modes."""
    native = page_data([result])["runs"][0]
    found = [] if own["status"] == native["status"] else [f"status {own['status']} for {native['status']}"]
    for fact in native["facts"]:
        key, ours = fact["id"], own["facts"].get(fact["id"], {"value": "absent"})["value"]
        if key == "energy.residual":
            if ours > max(MOST_RESIDUAL, 2 * fact["value"]):
                found.append(f"{key} {ours} for {fact['value']}")
        elif not near(ours, fact["value"]):
            found.append(f"{key} {ours} for {fact['value']}")
    ours, true = dict(leaves(own["verdict"])), dict(leaves(result.verdict))
    largest = result.verdict["largest_m"] or 0.0
    found += [f"verdict {'.'.join(key)} {ours.get(key)} for {true.get(key)}" for key in ours.keys() | true.keys()
              if not near(ours.get(key), true.get(key), largest if key[0] == "culprits" else 0.0)]  # fmt: skip
    return [*found, *_curves(own, native), *_modes(own, native)]


def near(own: Any, true: Any, scale: float = 0.0) -> bool:
    """Numbers to six digits, of themselves or of a scale; all else the same."""
    if isinstance(true, float | int) and isinstance(own, float | int):
        return bool(abs(own - true) <= EQUAL * max(abs(true), scale) + NOTHING)
    return own == true


def leaves(found: Any, at: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], Any]]:
    """All values within, by where they are."""
    items = found.items() if isinstance(found, dict) else enumerate(found) if isinstance(found, list) else None
    if items is None:
        yield at, found
        return
    for key, value in items:
        yield from leaves(value, (*at, str(key)))


def _curves(own: dict[str, Any], native: dict[str, Any]) -> Iterator[str]:
    """Least and largest value of each curve that the page draws again, over the largest of its chart; spectra's marks.

    Of a small curve the integration itself has no more digits.
    """
    for chart in native["charts"]:
        size = max(float(np.abs(np.asarray(curve["values"], dtype=float)).max()) for curve in chart["curves"])
        for curve in chart["curves"]:
            source = curve["source"]
            if not source or chart["abscissa"] != "time" or source["along"] or source.get("less"):
                continue
            series = own["series"].get(source["variable"])
            if series is None or chart["id"] == "energy_balance":
                continue
            values = series.reshape(len(series), -1)[:, source["index"]] * source["factor"]
            true = np.asarray(curve["values"], dtype=float)
            far = max(abs(values.max() - true.max()), abs(values.min() - true.min()))
            if far > 2 * EQUAL * max(size, 1e-9):
                yield f"curve {curve['label']} of {chart['id']}: {far} of {size} apart"
        marked = {mode["case"] for mode in native["modes"]} <= _cases(own)  # else they are of modes that it has not
        if marked and chart["abscissa"] == "frequency" and chart["id"] != "spectrum_tip_nominal":  # whose are said old
            # Marks go to the end of the chart's range, its values to the last frequency before that.
            last = (1 + EQUAL) * max(float(np.asarray(chart["at"])[-1]), *(mark["at"] for mark in chart["marks"]), 0.0)
            ours = [mark for mark in own["vibration"]["marks"] if mark["at"] <= last]
            labels = [[mark["label"] for mark in marks] for marks in (ours, chart["marks"])]
            pairs = zip(ours, chart["marks"], strict=False)
            if labels[0] != labels[1] or not all(near(one["at"], two["at"]) for one, two in pairs):
                yield f"marks {ours} for {chart['marks']}"


def _modes(own: dict[str, Any], native: dict[str, Any]) -> Iterator[str]:
    """Of the cases whose modes the page computes: frequency, damping and element of each."""
    known = _cases(own)
    ours = own["vibration"]["modes"] if known else []
    for one, true in zip(ours, [mode for mode in native["modes"] if mode["case"] in known], strict=False):
        same = all(near(one[key], true[key], 1.0 if key == "damping" else 0.0) for key in ("frequency", "damping"))
        if not same or any(one[key] != true[key] for key in ("case", "element")):
            yield f"mode {[one[key] for key in MODE]} for {[true[key] for key in MODE]}"


def _cases(own: dict[str, Any]) -> set[str]:
    """Those of modes that the page computes."""
    return {mode["case"] for mode in own["vibration"]["modes"]} if isinstance(own.get("vibration"), dict) else set()


MODE = ("case", "frequency", "damping", "element")
