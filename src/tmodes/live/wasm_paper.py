"""The 2010 robot as a WebAssembly module: planned as it is known, run as it really is, and all that is told of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from typing import Any

from tmodes.compile.wasm.wasm_parts import program_loop, sample_part, schedule_loop
from tmodes.equations.lagrange.layout import COORDINATES, LINE, OBSERVED, STATE_SIZE
from tmodes.integrate.method import JACOBIAN
from tmodes.integrate.registry import integrator
from tmodes.live.modes_paper import add_modes
from tmodes.live.module import Functions, LiveModule
from tmodes.paper.mechanism import Drive, Mechanism
from tmodes.paper.model_loops import rate_of
from tmodes.paper.model_schedules import implicit_schedule, rate_schedule
from tmodes.paper.sheet import PaperPair

__all__ = ["robot_module"]

_PAIRS = len(COORDINATES)
_ROOT = {"residual": 5, "slope": 25}
"""Residual of a static equation, and its derivative by the deformations, column by column."""


def robot_module(pair: PaperPair, methods: Sequence[str]) -> LiveModule:
    """All functions of ``reference`` (the known robot, its motor as wanted) and ``real`` (the real one, controlled).

    Loops: ``reference.METHOD``, ``real.METHOD``. Samples, of both by the same names before the dot: ``observe`` and
    ``rate`` as of the model, ``rest`` and ``quasistatic`` (residual and its derivative by the
    deformations), ``linear`` (M, D, K about ``phi``, row by row), ``line1``, ``line2`` (inputs: a station s and the
    motion, 21 numbers), ``places`` (both lines at a station s); and those of :func:`tmodes.live.modes_paper.add_modes`.
    """
    regimes = {"reference": pair.nominal.split(Drive.PRESCRIBED), "real": pair.real.split(Drive.CONTROLLED)}
    made = Functions()
    for name, (mechanism, parameters) in regimes.items():
        count = len(parameters)
        for method in methods:
            sizes = {"size": STATE_SIZE, "row": mechanism.reference_degree + 2, "parameters": count}
            made.loop(f"{name}.{method}", _loop(f"{name}.{method}", mechanism, method), **sizes)
        _observing(made, name, mechanism, count)
        _resting(made, name, mechanism, count)
    _, parameters = regimes["real"]
    add_modes(made, pair.real, len(parameters))
    info = {"kind": "robot", "coordinates": [*COORDINATES], "parameters": [*parameters.names]}
    return made.module("robot", **info)


def _loop(symbol: str, mechanism: Mechanism, method: str) -> Any:
    guarded = 2 * _PAIRS
    if integrator(method).is_explicit:
        return [program_loop(symbol, mechanism.key, partial(rate_of, mechanism), guarded, method)]
    if integrator(method).asks == JACOBIAN:
        return schedule_loop(symbol, rate_schedule(mechanism), guarded, method, pairs=_PAIRS, columns=guarded)
    return schedule_loop(symbol, implicit_schedule(mechanism), guarded, method, pairs=_PAIRS)


def _observing(made: Functions, name: str, mechanism: Mechanism, parameters: int) -> None:
    labels = {f"{name}.{label}": 3 for label in ("observe", "rate")}

    def make() -> Mapping[str, Any]:
        from tmodes.equations.lagrange.closed_loop import closed_loop, observe_function

        functions = observe_function(closed_loop(mechanism)), rate_of(mechanism)
        return dict(zip(labels, functions, strict=True))

    made.parts.append(sample_part(mechanism.key, make, labels))
    instant = {"time": 1, "state": STATE_SIZE, "row": mechanism.reference_degree + 2}
    for label, outputs in zip(labels, (OBSERVED, {"rate": STATE_SIZE}), strict=True):
        made.program(label, label, instant, outputs, parameters)


def _resting(made: Functions, name: str, mechanism: Mechanism, parameters: int) -> None:
    """What does not depend on the drive: once where both robots are made alike."""
    inputs = {
        "rest": {"angles": 5, "theta": 1}, "quasistatic": {"angles": 5, "gross": 6}, "linear": {"phi": 6},
        "line1": {"station": 1, "motion": 21}, "line2": {"station": 1, "motion": 21},
        "places": {"station": 1, "phi": 6},
    }  # fmt: skip
    exports = {label: f"{label} {mechanism.arm_key}" for label in inputs}

    def make() -> Mapping[str, Any]:
        from tmodes.equations.lagrange.beam import line_function, places_function
        from tmodes.equations.lagrange.linear import linear_function
        from tmodes.equations.lagrange.statics import quasistatic_function, rest_function

        lines = (line_function(mode, mechanism) for mode in (1, 2))
        static = (rest_function(mechanism), quasistatic_function(mechanism), linear_function(mechanism))
        functions = (*static, *lines, places_function())
        return dict(zip(exports.values(), functions, strict=True))

    counts = {name: 1 if label == "linear" else 2 for label, name in exports.items()}
    made.parts.append(sample_part(mechanism.arm_key, make, counts))
    info = (_ROOT, _ROOT, {"linear": 108}, LINE, LINE, {"line": 6})
    for (label, sizes), outputs in zip(inputs.items(), info, strict=True):
        made.program(f"{name}.{label}", exports[label], sizes, outputs, parameters)
