"""The speed of the seed's run, side by side in one go, the error next to every time.

    python -m benchmarks.seed [--rounds 7] [--json FILE]

Two seconds of the closed loop (the robot of Filipovic & Djuric 2010, real characteristics, `consistent` reading), in
free space, and in contact against gcc alone. Contenders take turns, so that a noisy machine troubles all alike; medians
are printed, with the distance of the final tip from an exact one: in free space by SciPy's DOP853 at 1e-13 of equations
that SymPy derived independently, in contact by our own adaptive integrator at 1e-13.
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.engines.contender import PeerMissing

from tmodes.compile.ir.unroll import c_text, unrolled
from tmodes.integrate.settings import Integration
from tmodes.robots.load import load
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

from .equal_error import at_equal_error, tell
from .peers import example

STEPS = 37_500
Contender = Callable[[], tuple[float, np.ndarray]]


@dataclass
class Row:
    """One contender: median time of a run [s], distance of its final tip from the exact one [m]."""

    name: str
    seconds: float
    tip_error: float


class Seed:
    """The package's own side of the comparison."""

    def __init__(self, contact: bool = False) -> None:
        setup = run_setup(load("filipovic2010", {"contact": contact}).pair().real)
        self.model, self.mechanics, self.start = setup.model, setup.mechanics, setup.start
        self.parameters, self.schedule = self.model.numbers, setup.planned.schedule

    def run(self, settings: Integration) -> tuple[float, np.ndarray]:
        """Time of a run from Python and back, and the final tip [m]."""
        began = time.perf_counter()
        run = solve(problem_of(self.model, self.parameters, self.schedule, self.start, settings))
        return time.perf_counter() - began, self.tips(run.states[-1:])[0]

    def tips(self, states: np.ndarray) -> np.ndarray:
        """Positions of the tip [m] in states of the closed loop, (n, 3)."""
        return self.mechanics.points(states[:, self.model.layout.q]).position[:, 0]

    def rk4(self) -> Contender:
        """The paper's way: 37,500 equal steps."""
        settings = Integration(method="rk4", step=2 / STEPS, output_step=2.0)
        return lambda: self.run(settings)

    def adaptive(self, rtol: float, method: str = "dormand_prince") -> Contender:
        """An adaptive method at a tolerance."""
        settings = Integration(method=method, relative_tolerance=rtol, absolute_tolerance=rtol * 1e-3, output_step=2.0)
        return lambda: self.run(settings)

    def gcc(self, flags: str) -> tuple[Contender, float]:
        """The same right-hand side, printed as C, in a loop of C; and gcc's own time."""
        from .peers import c_loop

        loop = c_loop.build(_c_of(self.model.loop.rate), "closed", len(self.start), c_loop.FLAGS[flags])
        rows = self.schedule.rows_at(self.schedule.knots[:-1])

        def run() -> tuple[float, np.ndarray]:
            done = loop.run(
                self.start, parameters=self.parameters, knots=self.schedule.knots, rows=rows, steps=STEPS,
                step=2 / STEPS, repeats=1,
            )  # fmt: skip
            return done.seconds, self.tips(done.state[None, :])[0]

        return run, loop.compile_seconds


_CLOSED = """
#include <string.h>
static int closed(const double **arg, double **res, long long *iw, double *w, int mem)
{
    static double s[WORKSPACE];
    static const double *known;
    if (known != arg[3]) {
        memcpy(s, arg[3], PARAMETERS * sizeof(double));
        rate_prepare(s);
        known = arg[3];
    }
    COPIES
    rate(s);
    RESULTS
    return 0;
}
"""


def _c_of(schedule: Any) -> str:
    """The rate as C, called as the loop calls it; what follows from the parameters alone is computed once."""
    inputs = [(schedule.offset(schedule.inputs[name]), schedule.inputs[name].size) for name in ("time", "state", "row")]
    copies = [f"memcpy(s + {at}, arg[{k}], {size} * sizeof(double));" for k, (at, size) in enumerate(inputs)]
    given = [schedule.offset(slot) + k for slot in schedule.outputs["rate"] for k in range(slot.size)]
    results = [f"res[0][{k}] = s[{place}];" for k, place in enumerate(given)]
    text = _CLOSED.replace("WORKSPACE", str(schedule.workspace)).replace("PARAMETERS", str(schedule.parameters))
    text = text.replace("COPIES", "\n    ".join(copies)).replace("RESULTS", "\n    ".join(results))
    return c_text(unrolled(schedule), "rate") + text


def in_turns(contenders: dict[str, Contender], rounds: int, exact: np.ndarray) -> list[Row]:
    """Every contender once a round; the median of each, with the error of its last run."""
    times: dict[str, list[float]] = {name: [] for name in contenders}
    errors: dict[str, float] = {}
    for contender in contenders.values():
        contender()
    for number in range(rounds):
        for name, contender in contenders.items():
            print(f"\rround {number + 1} of {rounds}: {name:<40}", end="", file=sys.stderr)
            seconds, tip = contender()
            times[name].append(seconds)
            errors[name] = float(np.linalg.norm(tip - exact))
    print(file=sys.stderr)
    return [Row(name, statistics.median(times[name]), errors[name]) for name in contenders]


def exact_tip() -> tuple[np.ndarray, Callable[[str, float], Contender]]:
    """Final tip by SymPy and SciPy at 1e-13, and their runs as contenders."""
    from .peers import sympy_scipy as peer

    parameters = example.parameters()
    rhs = peer.derive("consistent", False)(parameters)
    start = peer.equilibrium(rhs)

    def contender(method: Any, rtol: float) -> Contender:
        def run() -> tuple[float, np.ndarray]:
            done = peer.simulate(rhs, start, rtol, rtol * 1e-3, method)
            return done.seconds, peer.tip(done.states[-1:], parameters)[0]

        return run

    return peer.tip(peer.reference_solution(rhs, start).states[-1:], parameters)[0], contender


def chains() -> dict[str, Contender]:
    """The nearest equivalent chain in other engines, where they are installed."""
    found: dict[str, Contender] = {}
    try:
        from .peers import mujoco_chain

        found["MuJoCo, RK4 37,500 steps (rollout)"] = lambda: _chain(mujoco_chain.run_native(1))
    except PeerMissing as missing:
        print(f"left out: {missing}", file=sys.stderr)
    try:
        from .peers import exudyn_chain

        found["Exudyn, RK44 37,500 steps"] = lambda: _chain(exudyn_chain.run_explicit(1))
    except PeerMissing as missing:
        print(f"left out: {missing}", file=sys.stderr)
    return found


def _chain(run: Any) -> tuple[float, np.ndarray]:
    return run.seconds, np.asarray(run.tip)


_COLD = """
import time, casadi, llvmlite.binding, tmodes.compile.loops.explicit_loop
from tmodes.robots.load import load
from tmodes.simulation.loop import LoopModel
from tmodes.simulation.plan import planned
plan = planned(load("filipovic2010", {"contact": False})).plan
began = time.perf_counter(); LoopModel(plan).loops["dormand_prince"]; print(time.perf_counter() - began)
"""


def start_times() -> tuple[float, float]:
    """First-ever compile of the closed loop (equations, IR, native code), and a second process from the cache [s]."""
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"TMODES_CACHE": f"{folder}/cache"}
        info = [
            subprocess.run([sys.executable, "-c", _COLD], env=environment, capture_output=True, text=True, check=True)
            for _ in range(2)
        ]
    return float(info[0].stdout), float(info[1].stdout)


def main() -> None:
    """Measure and print the table."""
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--rounds", type=int, default=7)
    options.add_argument("--json", help="also write the figures to this file")
    chosen = options.parse_args()

    first, second = start_times()
    exact, scipy = exact_tip()
    seed = Seed()
    contenders: dict[str, Contender] = {"tmodes, RK4 37,500 steps": seed.rk4()}
    compile_times = {}
    for flags in ("gcc -O3", "gcc -O3 -march=native"):
        try:
            contender, compile_times[flags] = seed.gcc(flags)
            contenders[f"{flags}, the same in C"] = contender
        except PeerMissing as missing:
            print(f"left out: {missing}", file=sys.stderr)
    for method in ("dormand_prince", "dop853"):
        contenders |= {f"tmodes, {method} rtol {rtol:.0e}": seed.adaptive(rtol, method) for rtol in (1e-6, 1e-9)}
    for method in ("RK45", "DOP853", "LSODA"):
        contenders |= {f"SymPy + SciPy {method} rtol {rtol:.0e}": scipy(method, rtol) for rtol in (1e-6, 1e-9)}
    contenders |= chains()
    rows = in_turns(contenders, chosen.rounds, exact)
    touching = Seed(contact=True)
    in_contact = {"tmodes, RK4, in contact": touching.rk4()}
    for flags in compile_times:
        in_contact[f"{flags}, in contact"] = touching.gcc(flags)[0]
    contact_exact = touching.adaptive(1e-13)()[1]
    rows += in_turns(in_contact, chosen.rounds, contact_exact)

    equal = at_equal_error(seed, chosen.rounds)
    base = rows[0].seconds
    machine = platform.processor() or platform.machine()
    print(f"machine: {machine}, {os.cpu_count()} cores, Python {platform.python_version()}")
    print(f"{'2 s of the closed loop':<42}{'median [ms]':>12}{'over RK4 of tmodes':>20}{'tip error [m]':>15}")
    for row in rows:
        print(f"{row.name:<42}{row.seconds * 1e3:>12.2f}{row.seconds / base:>20.2f}{row.tip_error:>15.1e}")
    tell(equal)
    print(
        f"first-ever compile of the closed loop {first:.3f} s; a second process, from the cache {second * 1e3:.1f} ms"
    )
    for flags, seconds in compile_times.items():
        print(f"{flags} compiles it in {seconds:.2f} s")
    if chosen.json:
        tables = {"rows": [asdict(row) for row in rows], "at_equal_error": [row._asdict() for row in equal]}
        info = tables | {"first_compile_s": first, "from_cache_s": second}
        Path(chosen.json).write_text(json.dumps(info, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
