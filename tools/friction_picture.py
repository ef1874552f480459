"""Draws the picture of docs/friction.md: ``python tools/friction_picture.py``."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import tmodes
from tmodes import plot
from tmodes.plot.style import new_figure

__all__ = ["draw", "exact", "oscillator"]

TARGET = Path(__file__).parents[1] / "docs/images/stick-slip.png"
BELT, SPRING, LOAD, STATIC, KINETIC = 0.05, 100.0, 20.0, 0.6, 0.4


def oscillator() -> tmodes.Robot:
    """A block of 1 kg on a belt, a spring along x to the ground."""
    plane = {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]}
    joints: list[dict[str, Any]] = [
        {"name": "x", "type": "prismatic", "parent": "base", "child": "sled", "axis": [1, 0, 0], "state": "locked",
         "gear": {"stiffness": SPRING, "damping": 0.0}},
        {"name": "z", "type": "prismatic", "parent": "sled", "child": "block", "axis": [0, 0, 1]},
    ]  # fmt: skip
    body = {"name": "mass", "mass": 1.0, "center": [0, 0, 0]}
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "stick-slip", "gravity": LOAD, "joints": joints,
        "links": [{"name": "sled", "bodies": []}, {"name": "block", "bodies": [body]}],
        "tip": {"link": "block", "position": [0, 0, 0]},
        "drives": [{"joint": "z", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        "contact": {"law": "unilateral", "point": "tip", "shape": plane, "stiffness": 1e6, "damping": 2e3,
                    "friction": KINETIC, "static_friction": STATIC, "velocity": [BELT, 0, 0]},
        "initial": {"state": "zero", "coordinates": {"z": -LOAD / 1e6}, "rates": {"x": BELT}},
        "integration": {"duration": 10.0, "output_step": 0.01},
    })  # fmt: skip


def exact(times: NDArray[np.float64]) -> NDArray[np.float64]:
    """The same in closed form, phase by phase."""
    rate, middle, x, start, place = np.sqrt(SPRING), KINETIC * LOAD / SPRING, np.zeros_like(times), 0.0, 0.0
    while start < times[-1]:
        onset = start + (STATIC * LOAD / SPRING - place) / BELT
        sticks = (times >= start) & (times <= onset)
        x[sticks] = place + BELT * (times[sticks] - start)
        far = STATIC * LOAD / SPRING - middle
        turn = 2 * (np.pi - np.arctan2(far * rate, BELT))
        end = onset + turn / rate
        slips = (times > onset) & (times <= end)
        phase = rate * (times[slips] - onset)
        x[slips] = middle + far * np.cos(phase) + BELT / rate * np.sin(phase)
        start, place = end, middle + far * np.cos(turn) + BELT / rate * np.sin(turn)
    return x


def draw(target: Path = TARGET) -> None:
    """Run at the default settings and draw motion and error."""
    data = tmodes.run(oscillator()).data
    time, x = data["time"].values, data["q"].sel(coordinate="x").values
    with plot.house_style():
        figure = new_figure(3.6)
        above, below = figure.subplots(2, 1, height_ratios=(1.6, 1), sharex=True)
        above.plot(time, x * 1e3, color="#0072b2", label="run")
        above.plot(time, exact(time) * 1e3, color="#d55e00", linestyle="--", label="closed form")
        above.set_ylabel("x [mm]")
        above.legend()
        below.semilogy(time, np.maximum(np.abs(x - exact(time)), 1e-18), color="#1a1c20")
        below.set_ylabel("difference [m]")
        below.set_xlabel("time [s]")
        figure.savefig(target, dpi=170, metadata={"Software": None})


if __name__ == "__main__":
    draw()
