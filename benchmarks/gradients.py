"""What derivatives cost, side by side in one go, the error next to every ratio.

    python -m benchmarks.gradients [--rounds 7] [--joints 6 12 36] [--runs seed panda stiff] [--json FILE]

Of the forward dynamics of a rigid chain, over an evaluation: along a direction, in reverse by coordinates, rates,
efforts and all parameters, and all derivatives at once, these over Pinocchio's ``computeABADerivatives`` as called from
Python. Of runs of two seconds, over the run: 20 forward sensitivities, and the adjoint gradient of the tip's squared
distance from where it ends by 20 numbers, without and with what the numbers of the sheet take. Contenders take turns;
medians of the ratios of a round are printed. Errors: against each other where two ways give the same (``duality``), and
against differences of sixth order, whose own noise is reported as the change by twice their step.
"""

from __future__ import annotations

import argparse
import json
import statistics
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from benchmarks.engines.contender import PeerMissing
from benchmarks.engines.peers import pinocchio_model
from benchmarks.engines.rigid import RigidChain

from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.model.model import Model

from .gradient_runs import Case, cases

_STATES, _STEP = 512, 1e-3
Calls = dict[str, Callable[[], Any]]


def ratios(calls: Calls, rounds: int, base: str) -> dict[str, float]:
    """Median over rounds of each contender's time over that of ``base``, and under ``seconds`` that of ``base``."""
    times: dict[str, list[float]] = {name: [] for name in calls}
    for call in calls.values():
        call()
    for _ in range(rounds):
        for name, call in calls.items():
            count, began = 0, time.perf_counter()
            while count == 0 or time.perf_counter() - began < 0.02:
                call()
                count += 1
            times[name].append((time.perf_counter() - began) / count)
    info = {name: statistics.median(a / b for a, b in zip(times[name], times[base], strict=True)) for name in calls}
    return info | {"seconds": statistics.median(times[base])}


def evaluation(joints: int, rounds: int) -> dict[str, float]:
    """Ratios of the derivatives of forward dynamics, and their errors."""
    robot = RigidChain(joints)
    model, rng = Model(robot.chain()), np.random.default_rng(0)
    q, v, effort, way, weights = rng.normal(size=(5, _STATES, joints))
    one = q[0], v[0], effort[0]
    calls: Calls = {
        "evaluation": lambda: model.forward_dynamics(q, v, effort),
        "jvp": lambda: model.forward_dynamics_jvp(q, v, effort, directions={"q": way}),
        "vjp": lambda: model.forward_dynamics_vjp(q, v, effort, weights=weights),
    }
    whole: Calls = {"all": lambda: model.forward_dynamics_derivatives(*one)}
    try:
        pinocchio, peer = pinocchio_model(robot)
        data = peer.createData()
        whole["pinocchio"] = lambda: pinocchio.computeABADerivatives(peer, data, *one)
    except PeerMissing as missing:
        print(f"  without Pinocchio: {missing}")
    info = ratios(calls, rounds, "evaluation")
    paired = ratios(whole, rounds, "pinocchio" if "pinocchio" in whole else "all")
    slopes, back = calls["jvp"](), calls["vjp"]()
    duality = abs((weights * slopes).sum() - (back["q"] * way).sum()) / np.abs(weights * slopes).sum()

    def at(by: float) -> Any:
        return model.forward_dynamics(q + by * way, v, effort)

    ways = [(at(k * _STEP) - at(-k * _STEP)) / (2 * k * _STEP) for k in (1, 2, 3)]
    expected = (15 * ways[0] - 6 * ways[1] + ways[2]) / 10
    columns = model.forward_dynamics_derivatives(*one).q @ way[0]
    return {
        "joints": joints, "evaluation_us": info["seconds"] / _STATES * 1e6, "jvp": info["jvp"], "vjp": info["vjp"],
        "all_us": paired["seconds"] * paired["all"] * 1e6,
        "all_over_pinocchio": paired["all"] if "pinocchio" in whole else float("nan"),
        "jvp_error": float(np.abs(slopes - expected).max() / np.abs(expected).max()), "duality": float(duality),
        "all_error": float(np.abs(columns - slopes[0]).max() / np.abs(slopes[0]).max()),
    }  # fmt: skip


def of_run(case: Case, rounds: int) -> dict[str, Any]:
    """Ratios of the derivatives of a run, without what any run needs before it, and the error of its gradient."""
    times: dict[str, list[float]] = {name: [] for name in ("run", "sweep", "adjoint", "forward")}
    gained = adjoint_gradient(case.sheet, case.functional, case.paths)
    forward_sensitivities(case.sheet, case.paths)
    for _ in range(rounds):
        began = time.perf_counter()
        case.run()
        times["run"].append(time.perf_counter() - began)
        cost = adjoint_gradient(case.sheet, case.functional, case.paths).cost
        times["sweep"].append(cost.forward + cost.sweep + cost.measure)
        times["adjoint"].append(times["sweep"][-1] + cost.sheet)
        cost = forward_sensitivities(case.sheet, case.paths).cost
        times["forward"].append(cost.forward + cost.sweep + cost.measure + cost.sheet)
    info = {name: statistics.median(a / b for a, b in zip(times[name], times["run"], strict=True)) for name in times}
    scaled = np.array([gained.by[path] * case.values[path] for path in case.compared])
    near, noise = np.array([case.differences(path, _STEP) for path in case.compared]).T
    largest = np.abs(scaled).max()
    return {
        "name": case.name, "method": gained.cost.method, "steps": gained.cost.steps, "paths": len(case.paths),
        "run_ms": statistics.median(times["run"]) * 1e3, "adjoint": info["sweep"], "adjoint_all": info["adjoint"],
        "forward_all": info["forward"], "kept_kb": gained.cost.bytes / 1e3,
        "error": float(np.abs(scaled - near).max() / largest), "noise": float(noise.max() / largest),
        "worst": float(np.abs(scaled / near - 1).max()), "worst_noise": float(np.abs(noise / near).max()),
    }  # fmt: skip


_EVALUATION = (
    "{joints:.0f} joints: an evaluation takes {evaluation_us:.2f} us",
    "  along a direction   {jvp:.2f} x, error {jvp_error:.0e}",
    "  in reverse          {vjp:.2f} x, duality {duality:.0e}",
    "  all derivatives     {all_us:.1f} us, {all_over_pinocchio:.2f} x Pinocchio's, error {all_error:.0e}",
)
_RUN = (
    "{name} by {method}: {run_ms:.1f} ms, {steps} steps, {kept_kb:.0f} kB of states kept",
    "  adjoint of {paths} numbers  {adjoint:.2f} x the run, {adjoint_all:.2f} x with the numbers of the sheet",
    "  forward sensitivities  {forward_all:.2f} x, with the numbers of the sheet",
    "  error over the largest {error:.0e} (differences {noise:.0e}), worst single {worst:.0e} ({worst_noise:.0e})",
)


def _print(lines: tuple[str, ...], row: dict[str, Any]) -> None:
    for line in lines:
        print(line.format(**row), flush=True)


def main() -> None:
    """Measure and print."""
    options = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    options.add_argument("--rounds", type=int, default=7)
    options.add_argument("--joints", type=int, nargs="*", default=[6, 12, 36])
    options.add_argument("--runs", nargs="*", default=[*cases()], choices=[*cases()])
    options.add_argument("--json", type=Path)
    given = options.parse_args()
    evaluations, runs = [], []
    for joints in given.joints:
        evaluations.append(evaluation(joints, given.rounds))
        _print(_EVALUATION, evaluations[-1])
    for name in given.runs:
        runs.append(of_run(cases()[name](), given.rounds))
        _print(_RUN, runs[-1])
    if given.json:
        given.json.write_text(json.dumps({"evaluations": evaluations, "runs": runs}, indent=1), encoding="utf-8")


if __name__ == "__main__":
    main()
