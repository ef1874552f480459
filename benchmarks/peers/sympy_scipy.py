"""SymPy's equations run by SciPy's solve_ivp: the usual way in Python, made as fast as it goes.

``python -m benchmarks.peers.sympy_scipy`` prints derivation time, run time and error of each method.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from benchmarks.engines.contender import PeerMissing
from numpy.typing import ArrayLike, NDArray

from . import example

try:
    from scipy.integrate import solve_ivp

    from .sympy_robot import Derived, Reading, Rhs, derive
except ImportError as error:
    raise PeerMissing(f"SymPy and SciPy are needed for this peer: {error}") from error

Method = Literal["RK45", "DOP853", "LSODA", "Radau", "BDF"]
Row = Sequence[float]
FloatArray = NDArray[np.float64]

__all__ = ["Run", "derive", "equilibrium", "reference_solution", "simulate", "tip", "tip_error"]


@dataclass(frozen=True)
class Run:
    """One run: wall time [s], evaluations of the right-hand side, times [s] (n,) and states (n, 12)."""

    seconds: float
    evaluations: int
    times: FloatArray
    states: FloatArray


def equilibrium(rhs: Rhs, row: Row = (0.0, 0.0, 0.0, 0.0)) -> FloatArray:
    """State of rest, shape (12,): Newton on phi'' = 0 from the straight arm, theta = 0, no voltage.

    In contact the environment's static force takes part, so that the state is one of rest.
    """
    phi = np.zeros(6)

    def accelerations(bent: FloatArray) -> FloatArray:
        return np.array(rhs(0.0, [*bent, 0.0, *[0.0] * 6], row)[6:11])

    for _ in range(30):
        residual = accelerations(phi[:5])
        nudges = 1e-5 * np.eye(5)
        columns = [(accelerations(phi[:5] + d) - accelerations(phi[:5] - d)) / 2e-5 for d in nudges]
        change = np.linalg.solve(np.transpose(columns), residual)
        phi[:5] -= change
        if np.max(np.abs(change)) < 1e-15:
            break
    return np.concatenate([phi, np.zeros(6)])


def simulate(
    rhs: Rhs,
    start: ArrayLike,
    rtol: float,
    atol: float,
    method: Method,
    output: ArrayLike | None = None,
    pieces: tuple[list[float], list[list[float]]] | None = None,
) -> Run:
    """Run over the reference's pieces, a fresh start at every knot: no step crosses a ramp's end.

    ``output``: times [s] of the states, else only start and end. Raises ArithmeticError when SciPy gives up.
    """
    knots, rows = pieces or example.reference()
    wanted = np.array([knots[0], knots[-1]]) if output is None else np.asarray(output, dtype=float)
    state, evaluations, states = np.asarray(start, dtype=float), 0, np.empty((len(wanted), 12))
    states[wanted <= knots[0]] = state
    began = time.perf_counter()
    for left, right, row in zip(knots[:-1], knots[1:], rows, strict=True):
        inside = (wanted > left) & (wanted <= right)
        at = np.union1d(wanted[inside], [right])
        done = solve_ivp(rhs, (left, right), state, method, at, rtol=rtol, atol=atol, args=(row,))
        if not done.success:
            raise ArithmeticError(f"{method} stopped at t = {done.t[-1]:.6g} s: {done.message}")
        states[inside], state, evaluations = done.y.T[: inside.sum()], done.y[:, -1], evaluations + done.nfev
    return Run(time.perf_counter() - began, evaluations, wanted, states)


def reference_solution(rhs: Rhs, start: ArrayLike, output: ArrayLike | None = None) -> Run:
    """The solution to compare with: DOP853 at rtol 1e-13, atol 1e-15, over the example's reference."""
    return simulate(rhs, start, 1e-13, 1e-15, "DOP853", output)


def tip(states: FloatArray, parameters: Mapping[str, float]) -> FloatArray:
    """Tip positions [m], shape (n, 3), of states (n, 12), Eq. (42)."""
    q, delta, _, vt, e = states.T[:5]
    lm, le = parameters["l1"] * np.cos(vt), parameters["l2"] * np.cos(vt + e)
    z = parameters["l1"] * np.sin(vt) + parameters["l2"] * np.sin(vt + e)
    return np.stack([lm * np.cos(q) + le * np.cos(q + delta), lm * np.sin(q) + le * np.sin(q + delta), z], axis=1)


def tip_error(run: Run, exact: Run, parameters: Mapping[str, float]) -> float:
    """Largest distance of the tips at equal times [m]."""
    apart = tip(run.states, parameters) - tip(exact.states, parameters)
    return float(np.max(np.linalg.norm(apart, axis=1)))


def _table(reading: Reading, contact: bool) -> None:
    """Print the derivation, and each method's time and error."""
    parameters, output = example.parameters(), np.linspace(0.0, example.DURATION, 201)
    derived: Derived = derive(reading, contact)
    began = time.perf_counter()
    rhs = derived(parameters)
    code = time.perf_counter() - began
    start = equilibrium(rhs)
    exact = reference_solution(rhs, start, output)
    place = "in contact" if contact else "free"
    print(f"{reading}, {place}: derived in {derived.seconds:.2f} s, made a function in {code:.2f} s")
    print(f"  reference DOP853 1e-13: {exact.seconds:.2f} s, {exact.evaluations} evaluations")
    for method in ("RK45", "DOP853", "LSODA"):
        for rtol in (1e-6, 1e-9):
            run = simulate(rhs, start, rtol, rtol * 1e-3, method, output)
            error = tip_error(run, exact, parameters)
            print(
                f"  {method:6s} rtol {rtol:.0e}: {run.seconds:.3f} s, {run.evaluations} evaluations, tip {error:.1e} m"
            )


if __name__ == "__main__":
    for each in (False, True) if "contact" in sys.argv else (False,):
        _table("consistent", each)
        _table("printed", each)
