"""The speed of studies: many cases reduced while they run, against the ways to run them one by one.

    python -m benchmarks.study_runs [--rounds 5] [--cases 4096] [--threads 2] [--json FILE]

The robot of 2010 (2 s, gear, payload and both stiffnesses of the link varied), reduced to its deviation from the
nominal tip, the gear's deflection and the effort, at two tolerances; and an arm of 22 coordinates whose two links are
beams, by the method for stiff motion and by the explicit one. Next to them, in turns: our native loops called one by
one, their time in native code alone (nothing is reduced there); SciPy's solve_ivp on the equations that SymPy derived,
made a function by lambdify, a pool of processes, some cases only; and SciPy's Radau on our compiled rate for the beam
arm.

Medians of processor time for a case are printed, the preparation of all cases included; how many times as long one
alone takes, by processor time and by the clock of all threads, which says something on a quiet machine only; and the
distance of the tip at the end from an exact one.
"""

from __future__ import annotations

import argparse
import json
import os
import statistics
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from tmodes.compile.native import processor
from tmodes.robots.load import load
from tmodes.sheet import Robot
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.motion_run import tip_motion
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.vary.reduce import Reduction, reduced

from .stiff_arm import two_beams

REDUCTIONS = [
    Reduction("deviation", "max"), Reduction("deviation", "rms"), Reduction("deviation", "end"),
    Reduction("deformation.joint.gear", "max_abs"), Reduction("joint.effort", "max_abs"),
]  # fmt: skip
RANGES = {
    "real.gear.stiffness": (0.16, 0.24), "real.payload.mass": (0.9, 1.1),
    "real.link.modes.0.bending_stiffness": (0.95, 1.05), "real.link.modes.1.bending_stiffness": (0.95, 1.05),
}  # fmt: skip

_ALONE = 4
"""Cases that are run one by one in each round."""


class Spent(NamedTuple):
    """Time by the clock and of all processors [s] for one case."""

    clock: float
    processor: float


def measured(work: Callable[[], Any], cases: int) -> tuple[Spent, Any]:
    """Time of some work for each of its cases; and what it gave."""
    clock, spent = time.perf_counter(), time.process_time()
    found = work()
    return Spent((time.perf_counter() - clock) / cases, (time.process_time() - spent) / cases), found


class Study:
    """A robot, and cases of it."""

    def __init__(
        self,
        name: str,
        robot: Robot,
        ranges: dict[str, tuple[float, float]],
        reductions: list[Reduction],
        cases: int,
    ) -> None:
        self.name, self.robot, self.ranges, self.reductions, self.cases = name, robot, ranges, reductions, cases

    def values(self, cases: int) -> dict[str, np.ndarray]:
        """Numbers of the cases."""
        generator = np.random.default_rng(1)
        return {path: generator.uniform(low, high, cases) for path, (low, high) in self.ranges.items()}

    def setup(self, index: int) -> RunSetup:
        """A case by itself."""
        changes = {path: float(numbers[index]) for path, numbers in self.values(_ALONE).items()}
        return run_setup(self.robot.with_(changes).pair().real).chosen()

    def batch(self, cases: int, threads: int) -> CaseResults:
        """All cases at once."""
        return reduced(self.robot, self.values(cases), self.reductions, threads=threads)

    def exact(self, index: int) -> np.ndarray:
        """The tip [m] at the samples: by dop853 at 1e-12, where that takes too long by extrapolation at 1e-10."""
        stiff = self.setup(index).robot.integration.method == "extrapolation"
        name, relative = ("extrapolation", 1e-10) if stiff else ("dop853", 1e-12)
        exact = {"method": name, "relative_tolerance": relative, "absolute_tolerance": 1e-2 * relative}
        robot = self.setup(index).robot
        settings = robot.integration.model_copy(update=exact)
        setup = run_setup(robot.model_copy(update={"integration": settings}))
        run = run_trajectory(setup)
        return tip_motion(setup, run.times, run.states)[0]


def one_by_one(setups: list[RunSetup]) -> tuple[Spent, list[np.ndarray]]:
    """Our native loops, one case after the other: the time in native code."""
    spent, tips = 0.0, []
    for setup in setups:
        settings = setup.robot.integration
        run = NativeRun(setup.problem())
        loop, given = run.loop, run.arguments(settings.max_steps)
        numbers = [value if isinstance(value, int) else value.ctypes.data for value in given.values()]
        began = time.thread_time()
        loop(*numbers)
        spent += time.thread_time() - began
        tips.append(tip_motion(setup, run.times, run.samples)[0])
    return Spent(np.nan, spent / len(setups)), tips


def slopes(model: Any, time: float, state: np.ndarray, row: np.ndarray) -> np.ndarray:
    """Derivatives of the rate by forward differences, all states in one call of the compiled rate.

    SciPy's own differences make the step of a state that changes no rate (a counter of work) ten times as large at
    each Jacobian, overflow after some 300 of them, and never end.
    """
    steps, count = np.sqrt(np.finfo(float).eps) * np.maximum(np.abs(state), 1e-5), len(state) + 1
    rates = model.rate([time] * count, np.vstack([state, state + np.diag(steps)]), np.tile(row, (count, 1)))
    return (rates[1:] - rates[0]).T / steps


def radau(setup: RunSetup) -> tuple[Spent, np.ndarray]:
    """SciPy's Radau on our compiled rate and its differences, at the samples."""
    from scipy.integrate import solve_ivp

    model, schedule, settings = setup.model, setup.planned.schedule, setup.robot.integration
    knots, rows, states = schedule.until(settings.duration).knots, schedule.rows_at(schedule.knots[:-1]), [setup.start]
    times = np.arange(0.0, settings.duration * (1 + 1e-9), settings.output_step)

    def work() -> None:
        for begin, end in pairwise(knots):
            row = rows[np.searchsorted(schedule.knots, begin, side="right") - 1]
            inside = np.union1d(times[(times > begin) & (times <= end)], [end])
            done = solve_ivp(
                lambda t, y, row=row: model.rate([t], y, row)[0], (begin, end), states[-1], "Radau", inside,
                rtol=settings.relative_tolerance, atol=settings.absolute_tolerance,
                jac=lambda t, y, row=row: slopes(model, t, y, row),
            )  # fmt: skip
            states.extend(done.y.T)

    spent, _ = measured(work, 1)
    return spent, tip_motion(setup, times, np.array(states)[: len(times)])[0]


def _peer_case(factor: float) -> float:
    """One run of the robot, its gear softer by a factor, by SciPy on the lambdified model: its processor time [s]."""
    from .peers import example, sympy_scipy

    if not _derived:
        _derived.append(sympy_scipy.derive("consistent", True))
    rhs = _derived[0](example.parameters() | {"Cxi": 4700.0 * factor})
    start = sympy_scipy.equilibrium(rhs)
    began = time.process_time()
    sympy_scipy.simulate(rhs, start, 1e-7, 1e-10, "DOP853", np.linspace(0, example.DURATION, 2001))
    return time.process_time() - began


_derived: list[Any] = []
"""The model as this process derived it."""


def multiprocessing_over_scipy(cases: int, threads: int) -> float:
    """Median processor time of a case [s], the derivation and everything but the runs left out."""
    with ProcessPoolExecutor(threads) as pool:
        return statistics.median(pool.map(_peer_case, np.linspace(0.16, 0.24, cases)))


def compared(study: Study, threads: int, rounds: int) -> dict[str, Any]:
    """Figures of one study."""
    setups = [study.setup(k) for k in range(_ALONE)]
    exact, cases = study.exact(0)[-1], study.cases
    study.batch(64, threads)
    times: dict[str, list[Spent]] = {"batch": [], "alone": []}
    tips: list[np.ndarray] = []
    for _ in range(rounds):
        alone, tips = one_by_one(setups)
        times["alone"].append(alone)
        times["batch"].append(measured(lambda: study.batch(cases, threads), cases)[0])
    ends = [Reduction(f"tip.{letter}", "end") for letter in "xyz"]
    found = reduced(study.robot, study.values(_ALONE), ends)
    end = np.array([found.values[one][0] for one in ends])
    pairs = [*zip(times["alone"], times["batch"], strict=True)]
    return {
        "study": study.name, "method": found.method[0], "cases": cases,
        "batch_processor_s": statistics.median(batch.processor for _, batch in pairs),
        "batch_clock_s": statistics.median(batch.clock for _, batch in pairs),
        "alone_processor_s": statistics.median(alone.processor for alone, _ in pairs),
        "alone_over_batch_processor": statistics.median(a.processor / b.processor for a, b in pairs),
        "alone_over_batch_clock": statistics.median(a.processor / b.clock for a, b in pairs),
        "batch_error_m": float(np.linalg.norm(end - exact)),
        "alone_error_m": float(np.linalg.norm(tips[0][-1] - exact)),
    }  # fmt: skip


def studies(cases: int) -> list[Study]:
    """All that are measured; the beam arm with a quarter of the cases, and an explicit method with a sixty-fourth."""
    found = []
    for tolerance in (1e-7, 1e-9):
        robot = load("filipovic2010").with_({"integration.relative_tolerance": tolerance, "real.payload.mass": 1.0})
        found.append(Study(f"robot of 2010, 2 s, {tolerance:.0e}", robot, RANGES, REDUCTIONS, cases))
    gears = {"joints.j0.gear.stiffness": (1.6e4, 2.4e4), "joints.j1.gear.stiffness": (1.6e4, 2.4e4)}
    asked = [Reduction("tip.speed", "max"), Reduction("j0.effort", "max_abs"), Reduction("tip.z", "min")]
    found.append(Study("beam arm, 0.5 s, 1e-06", two_beams(), gears, asked, cases // 4))
    explicit = two_beams(method="dormand_prince", duration=0.005, output_step=1e-3)
    return [*found, Study("beam arm, 5 ms, 1e-06", explicit, gears, asked, cases // 64)]


def main() -> None:
    """Measure and print the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=5)
    options.add_argument("--cases", type=int, default=4096)
    options.add_argument("--threads", type=int, default=2)
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()
    print(f"{processor()}, {os.cpu_count()} cores, {chosen.threads} threads, {chosen.rounds} rounds")
    print("| study | case [ms] | alone [ms] | by processor | by the clock | error at the end, case; alone [m] |")
    print("|---|---|---|---|---|---|")
    figures: list[dict[str, Any]] = []
    for study in studies(chosen.cases):
        f = compared(study, chosen.threads, chosen.rounds)
        figures.append(f)
        numbers = f"{f['batch_processor_s'] * 1e3:.3f} | {f['alone_processor_s'] * 1e3:.3f}"
        ratios = f"{f['alone_over_batch_processor']:.2f} | {f['alone_over_batch_clock']:.2f}"
        errors = f"{f['batch_error_m']:.0e}; {f['alone_error_m']:.0e}"
        print(f"| {f['study']} ({f['method']}) | {numbers} | {ratios} | {errors} |", flush=True)
    peer = multiprocessing_over_scipy(2 * chosen.threads, chosen.threads)
    ratio = peer / figures[0]["batch_processor_s"]
    print(
        f"SciPy on the lambdified model, {2 * chosen.threads} cases, 1e-7: {peer:.2f} s a case, {ratio:,.0f} times ours"
    )
    stiff = studies(chosen.cases)[2]
    spent, tip = radau(stiff.setup(0))
    error, ratio = np.linalg.norm(tip[-1] - stiff.exact(0)[-1]), spent.processor / figures[2]["batch_processor_s"]
    print(
        f"SciPy's Radau on our rate, beam arm: {spent.processor:.2f} s a case, {ratio:,.0f} times ours, {error:.0e} m"
    )
    if chosen.json:
        info = {"figures": figures, "scipy_s": peer, "radau_s": spent.processor}
        Path(chosen.json).write_text(json.dumps(info, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
