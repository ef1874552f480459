"""The figures of a benchmark as tables of words: what the command prints and the page of the docs shows."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

__all__ = ["Table", "exponents", "left_out", "tables"]

Table = tuple[str, tuple[str, ...], list[list[str]]]
"""Title, columns, rows."""


def tables(info: dict[str, Any]) -> Iterator[Table]:
    """Forward dynamics, then runs, of what :func:`benchmarks.engines.measure.measured` returned."""
    sizes = info["sizes"]
    title = f"Forward dynamics of rigid chains [µs], relative error; medians of {info['rounds']} rounds"
    columns = ("", *(f"{size['n']} joints" for size in sizes))
    yield title, columns, [*_times(sizes), *_limits(sizes), *_starts(sizes)]
    if info["scaling"]:
        sizes_info = ", ".join(str(size["n"]) for size in sizes)
        powers = [[name, f"{power:.2f}"] for name, power in info["scaling"].items()]
        yield f"Cost grows with the joints to the power of ({sizes_info} joints)", ("", "power"), powers
    for name, runs in _runs(info):
        what = f"{name}: {runs['duration']:g} s to {runs['error']:g} {runs['unit']}, at equal error"
        yield what, ("", "setting", "ms per simulated second", f"error [{runs['unit']}]"), _races(runs)


def left_out(info: dict[str, Any]) -> list[str]:
    """Who did not take part, where, and why."""
    reasons: dict[tuple[str, str], list[str]] = {}
    for size in info["sizes"]:
        for name, why in size["left_out"].items():
            reasons.setdefault((name, why), []).append(str(size["n"]))
    return [f"{name}, {', '.join(where)} joints: {why}" for (name, why), where in reasons.items()]


def _times(sizes: list[dict[str, Any]]) -> Iterator[list[str]]:
    known = [{one["name"]: one for one in size["contenders"]} for size in sizes]
    for name in dict.fromkeys(name for one in known for name in one):
        yield [name, *(_time(one[name]) if name in one else "-" for one in known)]


def _time(one: dict[str, Any]) -> str:
    return f"{one['seconds']['median'] * 1e6:.3g}  {one['error']:.0e}"


def _limits(sizes: list[dict[str, Any]]) -> Iterator[list[str]]:
    for name, key, scale, info in (
        ("limit, by throughput", "throughput", 1e6, "{:.3g}"),
        ("limit, by the critical path", "critical_path", 1e6, "{:.3g}"),
        ("operations of a new state", "changing", 1, "{:,}"),
    ):
        yield [name, *(info.format(size["limit"][key] * scale) if size["limit"] else "-" for size in sizes)]


def _starts(sizes: list[dict[str, Any]]) -> Iterator[list[str]]:
    starts = [size["start"] for size in sizes]
    yield ["compile, equations and emission included [s]", *(f"{_compiling(one):.3g}" for one in starts)]
    for way in dict.fromkeys(one["name"] for size in sizes for one in size["contenders"] if one["compile"]):
        yield [f"compile by {way.split(',')[0]} [s]", *(_by_compiler(size, way) for size in sizes)]
    for words, key, scale, digits in (
        ("native code from the cache [ms]", "reload", 1e3, ".3g"), ("first call [ms]", "first_call", 1e3, ".3g"),
        ("peak memory of a process [MB]", "memory", 1e-6, ".0f"),
        ("of which before the chain [MB]", "memory_before", 1e-6, ".0f"),
    ):  # fmt: skip
        yield [words, *(f"{one[key] * scale:{digits}}" for one in starts)]


def _compiling(start: dict[str, float]) -> float:
    return start["equations"] + start["compile"]


def _by_compiler(size: dict[str, Any], way: str) -> str:
    return next((f"{one['compile']:.3g}" for one in size["contenders"] if one["name"] == way), "-")


def _runs(info: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    for size in info["sizes"]:
        if "runs" in size:
            yield f"A chain of {size['n']} joints falls", size["runs"]
    if "seed" in info:
        yield "The closed loop of the 2010 robot", info["seed"]


def _races(runs: dict[str, Any]) -> list[list[str]]:
    return [
        [race["name"], race["setting"] + ("" if race["reached"] else " (not reached)"),
         f"{race['time']['median'] * 1e3:.3g}", f"{race['error']:.0e}"] for race in runs["races"]
    ]  # fmt: skip


def exponents(sizes: list[dict[str, Any]]) -> dict[str, float]:
    """Slope of log cost over log joints by least squares, by what it is the cost of; empty below three sizes.

    Memory is what the process needed beyond what it had before the chain.
    """
    if len(sizes) < 3:
        return {}
    joints = [size["n"] for size in sizes]
    found = {one["name"]: _contender(sizes, one["name"]) for one in sizes[0]["contenders"]}
    costs = {name: values for name, values in found.items() if len(values) == len(sizes)}
    starts = [size["start"] for size in sizes]
    costs["compile"] = [_compiling(one) for one in starts]
    costs["memory"] = [one["memory"] - one["memory_before"] for one in starts]
    return {name: _slope(joints, values) for name, values in costs.items() if min(values) > 0}


def _contender(sizes: list[dict[str, Any]], name: str) -> list[float]:
    known = [{one["name"]: one["seconds"]["median"] for one in size["contenders"]} for size in sizes]
    return [one[name] for one in known if name in one]


def _slope(joints: list[int], costs: list[float]) -> float:
    return float(np.polyfit(np.log(joints), np.log(costs), 1)[0])
