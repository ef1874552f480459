"""The right-hand side as C, in a plain RK4 loop of C, by gcc: what a compiler on the user's machine would give."""

from __future__ import annotations

import ctypes
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from benchmarks.engines import gcc
from numpy.typing import ArrayLike, NDArray

FLAGS = gcc.FLAGS
LOOP = Path(__file__).with_name("c_loop.c")


@dataclass(frozen=True)
class CRun:
    """One run: wall time of the loop alone [s] (best of the repeats) and the final state, shape (n,)."""

    seconds: float
    state: NDArray[np.float64]


@dataclass(frozen=True)
class CLoop:
    """A compiled loop over ``n`` states; ``compile_seconds`` is gcc's wall time [s]."""

    library: ctypes.CDLL
    n: int
    compile_seconds: float

    def run(
        self,
        start: ArrayLike,
        *,
        parameters: ArrayLike,
        knots: ArrayLike,
        rows: ArrayLike,
        steps: int,
        step: float,
        repeats: int = 3,
    ) -> CRun:
        """``steps`` RK4 steps of ``step`` [s] from ``start``, shape (n,).

        ``knots`` [s], shape (pieces + 1,), and ``rows``, shape (pieces, any), one ``[t_start, coefficients...]`` per
        piece; a step belongs to the piece its midpoint is in, so knots should lie on steps.
        """
        p, k, r = (np.ascontiguousarray(a, dtype=np.float64) for a in (parameters, knots, rows))
        best, state = np.inf, np.empty(self.n)
        for _ in range(repeats):
            state = np.array(start, dtype=np.float64)
            if state.shape != (self.n,) or r.ndim != 2 or len(k) != len(r) + 1:
                raise ValueError(f"start {state.shape}, knots {k.shape}, rows {r.shape}: expected n = {self.n} states")
            sizes = ctypes.c_longlong(len(r)), ctypes.c_longlong(r.shape[1])
            began = time.perf_counter()
            failed = self.library.peer_loop(
                ctypes.c_longlong(steps), ctypes.c_double(step), _at(state), sizes[0], _at(k), _at(r), sizes[1], _at(p)
            )
            best = min(best, time.perf_counter() - began)
            if failed:
                raise ArithmeticError("the right-hand side reported a failure")
        return CRun(best, state)


def _at(array: NDArray[np.float64]) -> ctypes.c_void_p:
    return ctypes.c_void_p(array.ctypes.data)


def build(c_source: str, function: str, n: int, flags: Sequence[str] = FLAGS["gcc -O3"]) -> CLoop:
    """Compile ``function`` of ``c_source`` together with the loop, and load it.

    ``c_source`` defines ``int function(const double** arg, double** res, long long* iw, double* w, int mem)`` with
    arguments (t, y, row, parameters), dense, and, as CasADi prints it, ``function_work`` with the sizes of its work
    arrays; without it no work array is given. Raises PeerMissing when there is no gcc, RuntimeError when it refuses
    the text.
    """
    work = f"{function}_work" if f"{function}_work(" in c_source else "(void)sizeof"
    head = f"\n#define FUNCTION {function}\n#define WORK {work}\n#define N {n}\n"
    library, seconds = gcc.build(c_source + head + LOOP.read_text(encoding="utf-8"), flags, patience=600.0)
    return CLoop(library, n, seconds)
