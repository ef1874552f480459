"""What speed is aimed at, and what a benchmark's figures say of it: ratios of one run, reached or not."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

__all__ = ["Aim", "aims"]


@dataclass(frozen=True)
class Aim:
    """A figure and its bound: at least so much, or at most."""

    words: str
    got: float
    bound: float
    at_least: bool
    unit: str = ""

    @property
    def reached(self) -> bool:
        """Whether the figure keeps the bound."""
        return self.got >= self.bound if self.at_least else self.got <= self.bound


def aims(info: dict[str, Any]) -> Iterator[Aim]:
    """All aims for which there are figures."""
    for size in info["sizes"]:
        yield from _compared_with_others(size)
        yield from _batches(size)
        yield from _start(size)
    for name, power in info["scaling"].items():
        if name.startswith("tmodes, 1 lane") or name in ("compile", "memory"):
            yield Aim(f"growth of {name} with the joints, as a power", power, 1.15, at_least=False)
    yield from _seed(info)


def _time(size: dict[str, Any], start: str) -> float | None:
    return next((one["seconds"]["median"] for one in size["contenders"] if one["name"].startswith(start)), None)


def _compared_with_others(size: dict[str, Any]) -> Iterator[Aim]:
    n, ours = size["n"], _time(size, "tmodes, 1 lane")
    compiled = _time(size, "gcc -O3,")
    if ours and compiled and n in (6, 12, 36, 102):
        bound = 1.0 if n < 36 else 1.1
        yield Aim(f"{n} joints: time over gcc -O3's", ours / compiled, bound, at_least=False)
    faster = {"Pinocchio": ((36, 102), 4), "MuJoCo": ((36, 102), 4), "Exudyn": ((36,), 25)}
    for name, (joints, bound) in faster.items():
        theirs = _time(size, name)
        if ours and theirs and n in joints:
            yield Aim(f"{n} joints: faster than {name}", theirs / ours, bound, at_least=True, unit=" times")


def _batches(size: dict[str, Any]) -> Iterator[Aim]:
    one = _time(size, "tmodes, 1 lane")
    lanes = [found for found in size["contenders"] if "lanes" in found["name"]]
    if one and size["n"] in (6, 12, 36):
        gain = one / lanes[0]["seconds"]["median"]
        yield Aim(f"{size['n']} joints: a lane of many cheaper than one", gain, 3.3, at_least=True, unit=" times")
        if lanes[-1]["cores"] == 2:
            gain = lanes[0]["seconds"]["median"] / lanes[-1]["seconds"]["median"]
            yield Aim(f"{size['n']} joints: two cores over one", gain, 1.8, at_least=True, unit=" times")


def _start(size: dict[str, Any]) -> Iterator[Aim]:
    n, start = size["n"], size["start"]
    bound = {6: 0.15, 36: 1.0, 102: 4.0, 200: 8.0}.get(n)
    if bound:
        compiled = start["equations"] + start["compile"]
        yield Aim(f"{n} joints: compile, equations included", compiled, bound, at_least=False, unit=" s")
    yield Aim(f"{n} joints: code from the cache", start["reload"] * 1e3, 10.0, at_least=False, unit=" ms")


def _seed(info: dict[str, Any]) -> Iterator[Aim]:
    races = {race["name"]: race for race in info.get("seed", {}).get("races", [])}
    default = races.get("tmodes, dormand_prince")
    paper = races.get("tmodes, rk4, the paper's step")
    if default and paper:
        gain = paper["time"]["median"] / default["time"]["median"]
        yield Aim("the 2010 robot: default over RK4 at the paper's step", gain, 5, at_least=True, unit=" times")
