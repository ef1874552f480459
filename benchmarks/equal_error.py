"""The seed's run at equal error: each method at the largest tolerance that keeps the tip within 1e-6 m all along."""

from __future__ import annotations

import statistics
import time
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np

from tmodes.integrate.settings import Integration
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

from .peers import example

__all__ = ["ENOUGH", "Equal", "at_equal_error", "tell"]

ENOUGH = 1e-6
"""Distance of the tip from the exact one [m], at any of the samples."""

_TOLERANCES = (1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6, 3e-7, 1e-7, 3e-8, 1e-8)
_OUTPUT = np.linspace(0.0, 2.0, 201)

Run = Callable[[], tuple[float, np.ndarray]]
"""Gives the time that it took [s] and the tip at the samples, (n, 3) [m]."""


class Equal(NamedTuple):
    """One contender: median time of a run [s], largest distance of its tip from the exact one [m]."""

    name: str
    seconds: float
    tip_error: float


def at_equal_error(seed: Any, rounds: int) -> list[Equal]:
    """Our methods, SciPy's RK45 and DOP853 on SymPy's equations, and our RK4 at the paper's step; in turns."""
    from .peers import sympy_scipy as peer

    numbers = example.parameters()
    rhs = peer.derive("consistent", False)(numbers)
    start = peer.equilibrium(rhs)
    exact = peer.tip(peer.simulate(rhs, start, 1e-13, 1e-15, "DOP853", _OUTPUT).states, numbers)

    def theirs(method: Any, rtol: float) -> Run:
        def run() -> tuple[float, np.ndarray]:
            done = peer.simulate(rhs, start, rtol, rtol * 1e-3, method, _OUTPUT)
            return done.seconds, peer.tip(done.states, numbers)

        return run

    def ours(settings: Integration) -> Run:
        def run() -> tuple[float, np.ndarray]:
            began = time.perf_counter()
            done = solve(problem_of(seed.model, seed.parameters, seed.schedule, seed.start, settings))
            return time.perf_counter() - began, seed.tips(done.states)

        return run

    def adaptive(method: str, rtol: float) -> Run:
        settings = Integration(method=method, output_step=0.01, relative_tolerance=rtol)
        return ours(settings.model_copy(update={"absolute_tolerance": rtol * 1e-3}))

    makers: dict[str, Callable[[float], Run]] = {}
    for method in ("dormand_prince", "dop853"):
        makers[f"tmodes, {method}"] = lambda rtol, method=method: adaptive(method, rtol)
    for name in ("RK45", "DOP853"):
        makers[f"SymPy + SciPy {name}"] = lambda rtol, name=name: theirs(name, rtol)
    runs = {"tmodes, RK4 37,500 steps": ours(Integration(method="rk4", step=2 / 37_500, output_step=0.01))}
    for name, make in makers.items():
        rtol = _just_enough(make, exact)
        runs[f"{name} rtol {rtol:.0e}"] = make(rtol)
    return _in_turns(runs, rounds, exact)


def _distance(tips: np.ndarray, exact: np.ndarray) -> float:
    return float(np.linalg.norm(tips - exact, axis=1).max())


def _just_enough(make: Callable[[float], Run], exact: np.ndarray) -> float:
    """The largest tolerance that is good enough, and all smaller ones too."""
    chosen = _TOLERANCES[-1]
    for rtol in reversed(_TOLERANCES):
        if not _distance(make(rtol)()[1], exact) <= ENOUGH:
            break
        chosen = rtol
    return chosen


def _in_turns(runs: dict[str, Run], rounds: int, exact: np.ndarray) -> list[Equal]:
    times: dict[str, list[float]] = {name: [] for name in runs}
    errors: dict[str, float] = {}
    for _ in range(rounds):
        for name, run in runs.items():
            seconds, tips = run()
            times[name].append(seconds)
            errors[name] = _distance(tips, exact)
    return [Equal(name, statistics.median(times[name]), errors[name]) for name in runs]


def tell(rows: list[Equal]) -> None:
    """Print the table, and how many times faster our default is than SciPy's RK45 and than our own RK4."""
    print(f"\n{f'tip within {ENOUGH:.0e} m all along':<42}{'median [ms]':>12}{'tip error [m]':>15}")
    for row in rows:
        print(f"{row.name:<42}{row.seconds * 1e3:>12.3f}{row.tip_error:>15.1e}")
    default = next(row for row in rows if "dormand_prince" in row.name)
    for row in rows:
        if "RK4" in row.name:
            print(f"dormand_prince is {row.seconds / default.seconds:.0f} times faster than {row.name}")
