"""What control at samples costs: two seconds of six-axis arms under LQG at 1 kHz, over the same arms without control.

    python -m benchmarks.sampled [--rounds 5] [--json FILE]

The Manutec r3 (rigid links, three elastic gears; no dry friction, about which a linear law knows nothing; a fifth of
its move), and the UR5 with six elastic gears and two flexible links where its URDF is installed (extra `robots`). LQG
from encoders of the motors alone, with noise, resolution and a limit of torque. Next to it, in turns: motors that
follow the move exactly, arms that fall without torque, and PD in continuous time and at samples.

Processor time of the actual robot's integration and of all of `Robot.run()` on a robot that ran before (with
equilibrium, spectrum, nominal run where there are setpoints, and results), the least of the rounds; both over that of
motors that follow exactly; largest error of a coordinate against the same run at a thousandth of its tolerances, as
far down as its method goes. With a resolution, an error that moves an encoder by one step is an error of a step.
"""

from __future__ import annotations

import argparse
import copy
import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple
from unittest import mock

import numpy as np

from tmodes.errors import InputError
from tmodes.integrate.registry import integrator
from tmodes.io.sheet_check import sheet_data
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation import initial_state
from tmodes.simulation.simulate import simulate_motion

PERIOD = 1e-3
ROBOTS = {"manutec_r3": (2000.0, 1e8, 0.2), "ur5_elastic": (300.0, 1e6, 1.0)}
"""Limit of torque [N m], weight on a drive's angle, share of the move."""


class Row(NamedTuple):
    """Least processor times [s], steps, evaluations, largest error of a coordinate [rad, m]."""

    robot: str
    control: str
    integration: float
    whole: float
    steps: int
    evaluations: int
    error: float


def plain(name: str, share: float) -> dict[str, Any]:
    """A robot's sheet for two seconds, without dry friction."""
    data: dict[str, Any] = {**sheet_data(load(name)), "integration": {"duration": 2.0, "output_step": 0.002}}
    data.pop("initial", None)
    for joint in data["joints"]:
        for one in (joint, joint.get("motor") or {}):
            if one.get("friction"):
                one["friction"] = {key: value for key, value in one["friction"].items() if key == "viscous"}
    for drive in data["drives"]:
        signal = drive["signal"]
        signal["end"] = signal["start"] + share * (signal["end"] - signal["start"])
    return data


def controlled(name: str) -> Iterator[tuple[str, Robot]]:
    """The robot without control, and with."""
    torque, weight, share = ROBOTS[name]
    data = plain(name, share)
    joints, names = [drive["joint"] for drive in data["drives"]], Robot.from_data(data).chain().coordinates
    bare = [{key: one[key] for key in ("joint", "command", "signal")} for one in data["drives"]]
    still = {"type": "constant", "value": 0.0}

    def of(drives: list[dict[str, Any]], **more: Any) -> Robot:
        return Robot.from_data(copy.deepcopy(data | {"drives": drives} | more))

    yield "motors follow exactly", of([one | {"command": "prescribed"} for one in bare])
    yield "no torque, it falls", of([one | {"command": "torque", "signal": still} for one in bare])
    yield "PD in continuous time", of(data["drives"])
    yield "PD at 1 kHz", of([one | {"sample_time": PERIOD} for one in data["drives"]])
    own = [f"{joint}.motor" if f"{joint}.motor" in names else joint for joint in joints]
    sensor = {"type": "encoder", "sample_time": PERIOD, "noise": 1e-5, "resolution": 1e-5}
    block = {
        "type": "lqg", "sample_time": PERIOD, "load_noise": 1e-2, "measured": [f"encoder{k}" for k in range(len(own))],
        "state_weights": dict.fromkeys(own, weight) | {f"{each}'": 1e-3 * weight for each in own},
        "process_noise": {f"{each}'": 1e-4 for each in names}, "measurement_noise": [1e-9],
    }  # fmt: skip
    yield (
        "LQG at 1 kHz, noise, limits",
        of(
            [one | {"saturation": {"torque": torque}} for one in bare],
            sensors=[sensor | {"name": f"encoder{k}", "joint": joint, "seed": k} for k, joint in enumerate(joints)],
            control=[{"name": "law", "drives": joints, "block": block}],
        ),
    )


def timed(robot: Robot) -> tuple[float, float, Any]:
    """Processor time of the last integration, which is that of the actual robot, and of all; the run."""
    spent: list[float] = []

    def solved(*given: Any, **more: Any) -> Any:
        began = time.process_time()
        done = solve(*given, **more)
        spent.append(time.process_time() - began)
        return done

    solve = initial_state.solve
    with mock.patch.object(initial_state, "solve", solved):
        began = time.process_time()
        run = simulate_motion(robot)
        return spent[-1], time.process_time() - began, run


def rows(name: str, rounds: int) -> Iterator[Row]:
    """All kinds of control of a robot, in turns."""
    robots = dict(controlled(name))
    times: dict[str, list[tuple[float, float]]] = {control: [] for control in robots}
    runs = {control: simulate_motion(robot) for control, robot in robots.items()}
    for _ in range(rounds):
        for control, robot in robots.items():
            times[control].append(timed(robot)[:2])
    for control, robot in robots.items():
        done, used = runs[control], robot.integration.chosen(runs[control].statistics["method"])
        relative = max(1e-3 * used.relative_tolerance, integrator(used.method).least_tolerance)
        finer = {"method": used.method, "relative_tolerance": relative, "absolute_tolerance": 1e-2 * relative}
        integration = robot.integration.model_copy(update=finer | {"max_steps": 10**7})
        exact = simulate_motion(robot.model_copy(update={"integration": integration}))
        integrating, whole = (float(least) for least in np.min(times[control], axis=0))
        steps, evaluations = (int(done.statistics[count]) for count in ("steps", "evaluations"))
        yield Row(name, control, integrating, whole, steps, evaluations, float(np.abs(done.q - exact.q).max()))


def main() -> None:
    """Measure and print the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--json", type=Path, help="also write the figures to this file")
    chosen = options.parse_args()
    found: list[Row] = []
    print(f"{'2 s':<40}{'integration':>20}{'whole run':>20}{'steps':>8}{'evaluations':>13}{'error':>10}")
    for name in ROBOTS:
        try:
            own = list(rows(name, chosen.rounds))
        except InputError as missing:
            print(f"left out: {missing}")
            continue
        for row in own:
            both = [(row.integration, own[0].integration), (row.whole, own[0].whole)]
            cells = "".join(f"{1e3 * value:>11.1f} ms{value / base:>6.2f}" for value, base in both)
            print(f"{row.robot:<12}{row.control:<28}{cells}{row.steps:>8}{row.evaluations:>13}{row.error:>10.0e}")
        found += own
    if chosen.json:
        chosen.json.write_text(json.dumps([row._asdict() for row in found], indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
