"""The speed of batches: each lane against the same run by itself, and threads against one, side by side in one go.

    python -m benchmarks.batch [--rounds 5] [--lanes 1024] [--threads 2] [--json FILE]

The seed's robot under control, and rigid chains of 6, 12 and 36 coordinates that swing freely; the numbers of the lanes
differ by a millionth, so that all need about as many steps. A lane and a run by itself are compared by processor time,
threads by the clock, which says something on a quiet machine only, and by processor time: below 1 there, threads
disturb each other. Contenders take turns, and medians of the ratios of a round are printed. The error next to them is
the largest difference of a lane from its run by itself, over the largest state. ``python -m benchmarks.narrow
benchmarks.batch`` measures as on a processor with vectors of four.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tmodes.chain.chain import Chain, Joint, Node
from tmodes.compile.native import WIDTH, processor
from tmodes.equations.loop.plan import LoopPlan
from tmodes.frame import Placement
from tmodes.integrate.settings import Integration
from tmodes.kinds.joints.registry import joint_kind
from tmodes.kinds.links.contract import Body
from tmodes.kinds.links.rigid import RigidLink
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.robots.load import load
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

_DURATIONS = {6: 1.0, 12: 0.5, 36: 0.3}
_ALONE = 4
"""Runs by themselves in each round."""


@dataclass(frozen=True, eq=False)
class Case:
    """What is run: a model, its numbers, what moves it, its start, and the settings."""

    name: str
    model: Any
    numbers: np.ndarray
    schedule: SignalPieces
    start: np.ndarray
    settings: Integration

    def alone(self, numbers: np.ndarray) -> Any:
        """One run by itself."""
        return solve(problem_of(self.model, numbers, self.schedule, self.start, self.settings))

    def batch(self, numbers: np.ndarray, threads: int) -> Any:
        """Many at once."""
        problem = problem_of(self.model, numbers, self.schedule, self.start, self.settings)
        return problem, solve([problem], problem.size, threads=threads)


def seed() -> Case:
    """The robot of the paper, its whole move."""
    robot = load("filipovic2010", {"contact": False})
    setup, settings = run_setup(robot), robot.integration.model_copy(update={"output_step": 0.01})
    numbers, schedule = setup.model.numbers, setup.planned.schedule
    return Case("seed's robot, 2 s", setup.model, numbers, schedule, setup.start, settings)


def chain(joints: int) -> Case:
    """A rigid chain with joints about x, y and z in turn, let go."""
    rng, tilt, turn = np.random.default_rng(1), 0.2, 0.3
    about_z = np.array([[np.cos(turn), -np.sin(turn), 0], [np.sin(turn), np.cos(turn), 0], [0, 0, 1]])
    about_x = np.array([[1, 0, 0], [0, np.cos(tilt), -np.sin(tilt)], [0, np.sin(tilt), np.cos(tilt)]])
    body = Body(1.0, np.array([0.05, 0.01, 0.02]), np.diag([0.01, 0.02, 0.02]))
    nodes = []
    for k in range(joints):
        placed = Placement(about_z @ about_x, rng.uniform(-0.1, 0.1, 3))
        joint = Joint(f"j{k}", joint_kind("revolute"), placed, np.eye(3)[k % 3])
        nodes.append(Node(f"l{k}", k - 1, joint, RigidLink((body,))))
    model = LoopModel(LoopPlan(Chain("rigid", tuple(nodes), np.array([0.0, 0.0, -9.81])), (), 0, 0))
    duration, start = _DURATIONS[joints], np.zeros(model.layout.size)
    start[model.layout.q] = 0.1 * np.random.default_rng(0).normal(size=joints)
    settings = Integration(duration=duration, output_step=duration / 50)
    still = SignalPieces(np.array([0.0, duration]), np.zeros((1, 0)))
    return Case(f"rigid chain, {joints} coordinates", model, model.numbers, still, start, settings)


def measured(case: Case, lanes: int, threads: int, rounds: int) -> dict[str, Any]:
    """Figures of one case."""
    spread = np.random.default_rng(2).uniform(-1e-6, 1e-6, size=(lanes, len(case.numbers)))
    many = case.numbers * (1 + spread)
    problem, batch = case.batch(many[:9], 1)
    singles = [case.alone(numbers) for numbers in many[:9]]
    error = max(
        np.abs(problem.states[k] - run.states).max() / np.abs(run.states).max() for k, run in enumerate(singles)
    )
    times: dict[str, list[float]] = {"alone": [], "lane": [], "one": [], "threads": [], "busy": []}
    for _ in range(rounds):
        alone = _spent(lambda: [case.alone(k) for k in many[:_ALONE]])
        one, all_at_once = (_spent(lambda count=count: case.batch(many, count)) for count in (1, threads))
        times["alone"].append(alone.processor / _ALONE)
        times["lane"].append(one.processor / lanes)
        times["busy"].append(all_at_once.processor / lanes)
        times["one"].append(one.clock / lanes)
        times["threads"].append(all_at_once.clock / lanes)
    return {
        "case": case.name,
        "run_alone_s": statistics.median(times["alone"]),
        "lane_s": statistics.median(times["lane"]),
        "alone_over_lane": _ratio(times["alone"], times["lane"]),
        "one_thread_over_threads": _ratio(times["one"], times["threads"]),
        "one_thread_over_threads_processor": _ratio(times["lane"], times["busy"]),
        "difference": float(error),
        "steps": int(batch.statistics["steps"][0]),
    }


class Spent(NamedTuple):
    """Time of some work: by the clock, and of all processors [s]."""

    clock: float
    processor: float


def _spent(work: Callable[[], object]) -> Spent:
    clock, processor = time.perf_counter(), time.process_time()
    work()
    return Spent(time.perf_counter() - clock, time.process_time() - processor)


def _ratio(above: list[float], below: list[float]) -> float:
    return statistics.median(a / b for a, b in zip(above, below, strict=True))


def main() -> None:
    """Measure and print the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--lanes", type=int, default=1024)
    options.add_argument("--threads", type=int, default=2)
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()
    print(
        f"{processor()}, {chosen.lanes} lanes, {WIDTH} side by side, {chosen.threads} threads, {chosen.rounds} rounds"
    )
    print("| case | one run [ms] | one lane [ms] | run / lane | one thread / threads | by processor | difference |")
    print("|---|---|---|---|---|---|---|")
    figures = []
    for case in (seed(), *map(chain, _DURATIONS)):
        f = measured(case, chosen.lanes, chosen.threads, chosen.rounds)
        figures.append(f)
        numbers = f"{f['run_alone_s'] * 1e3:.3f} | {f['lane_s'] * 1e3:.3f} | {f['alone_over_lane']:.2f}"
        gains = f"{f['one_thread_over_threads']:.2f} | {f['one_thread_over_threads_processor']:.2f}"
        print(f"| {f['case']} | {numbers} | {gains} | {f['difference']:.1e} |", flush=True)
    if chosen.json:
        info = {"lanes": chosen.lanes, "threads": chosen.threads, "cases": figures}
        Path(chosen.json).write_text(json.dumps(info, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
