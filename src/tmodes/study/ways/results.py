"""Cases of which the whole result is asked: each is run by itself, in processes; slow."""

from __future__ import annotations

import multiprocessing
import os
import pickle
import time as clock
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError, InputErrors, SimulationError
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.code_identity import UnidentifiedError, code_digest
from tmodes.kinds.outside import USED, use
from tmodes.result.run import run
from tmodes.sheet import Robot
from tmodes.simulation.case_results import CaseResults
from tmodes.study.quantities import Needs, Quantity
from tmodes.study.quantities.function import function_of

__all__ = ["by_results"]

Array = NDArray[np.float64]
Functions = Mapping[str, Callable[[Any], float]]


@dataclass(frozen=True)
class _Task:
    """What a process needs once: the robot, the quantities by name, and which errors are estimated."""

    robot: dict[str, Any]
    quantities: dict[str, tuple[type[Quantity], dict[str, Any]]]
    errors: frozenset[str]

    @cached_property
    def sheet(self) -> Robot:
        """The robot as a sheet, checked once in each process."""
        return Robot.from_data(self.robot)


def by_results(
    robot: Robot, vary: Mapping[str, Array], quantities: Mapping[str, Quantity], functions: Functions, needs: Needs,
    threads: int | None, progress: Callable[[str, float], None],
) -> CaseResults:  # fmt: skip
    """Numbers of the results of the cases ``vary`` (m,) of one robot, by names of ``quantities``.

    They run in processes where there are several cases and several cores, and the ``functions`` can be sent there.
    Raises :class:`tmodes.errors.InputError` for a key that no summary has.
    """
    called = {name: one.function() for name, one in quantities.items()}
    own = {name: function_of(function, functions, name) for name, function in called.items() if function}
    kinds = {name: (type(one), one.model_dump()) for name, one in quantities.items()}
    task = _Task(sheet_data(robot), kinds, needs.errors)
    size = len(next(iter(vary.values())))
    changes = [{path: float(values[k]) for path, values in vary.items()} for k in range(size)]
    found = CaseResults.of_all(size, "finished")
    found.values = {name: np.full(size, np.nan) for name in quantities}
    with _mapped(task, own, min(size, threads or os.cpu_count() or 1)) as mapped:
        for k, case in enumerate(mapped(changes)):
            found.take([k], case)
            progress("results", (k + 1) / size)
    return found


@contextmanager
def _mapped(
    task: _Task, functions: Functions, workers: int
) -> Iterator[Callable[[Sequence[dict[str, float]]], Iterator[CaseResults]]]:
    """How cases are run: over processes where the functions are the same there, else one after the other here."""
    sent = _to_send(functions) if workers > 1 else None
    if sent is None:
        yield lambda changes: (_ran(task, functions, change) for change in changes)
        return
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(workers, context, _begin, (task, sent, tuple(USED))) as pool:
        try:
            if pool.submit(_digests_there).result() == _digests(functions):
                yield lambda changes: pool.map(_ran_there, changes)
            else:
                yield lambda changes: (_ran(task, functions, change) for change in changes)
        except BrokenProcessPool as error:
            asked = "".join(f"`{name}`, which may hang or end it, and at " for name in functions)
            raise SimulationError(
                f"a process that computes results has ended by itself: look at {asked}the memory; "
                'a script of your own needs `if __name__ == "__main__":` before it runs a study'
            ) from error
        except BaseException:
            pool.shutdown(wait=False, cancel_futures=True)
            raise


def _digests(functions: Functions) -> dict[str, str]:
    """What the functions depend on; raises UnidentifiedError where one has no digest."""
    return {name: code_digest(function) for name, function in functions.items()}


def _digests_there() -> dict[str, str]:
    try:
        return _digests(_HERE[0][1])
    except UnidentifiedError:
        return {}


def _to_send(functions: Functions) -> bytes | None:
    """The functions as bytes; None where another process could not find one, such as one within another function.

    None, too, where nobody can say whether one would be the same there.
    """
    try:
        _digests(functions)
        return pickle.dumps(dict(functions))
    except UnidentifiedError:
        return None
    except (pickle.PicklingError, AttributeError, TypeError):
        return None


_HERE: list[tuple[_Task, Functions]] = []
"""The task of this process, and its functions."""


def _begin(task: _Task, functions: bytes, used: Sequence[str]) -> None:
    """Files that a person named are loaded first: functions may be of them. What they print is no result of ours."""
    os.dup2(2, 1)
    if used:
        use(*used)
    _HERE[:] = [(task, pickle.loads(functions))]  # noqa: S301  # of the process that has started this one


def _ran_there(changes: dict[str, float]) -> CaseResults:
    return _ran(*_HERE[0], changes)


def _ran(task: _Task, functions: Functions, changes: Mapping[str, float]) -> CaseResults:
    """One case, run whole."""
    found, began = CaseResults.of_all(1), clock.process_time()
    estimates = {f"integration.{name}": key in task.errors for key, name in _ESTIMATES.items()}
    try:
        result = run(task.sheet.with_({**changes, **estimates}))
    except (InputError, InputErrors, SimulationError) as error:
        found.put({0: str(error)}, "failed" if isinstance(error, SimulationError) else "refused")
        found.seconds[:] = clock.process_time() - began
        return found
    found.put({0: "" if result.status == "finished" else result.message}, result.status)
    found.method[:] = result.actual.integration.method
    for name, (kind, data) in task.quantities.items() if result.success else ():
        value, found.units[name], why = kind.of(data).of_result(result, functions.get(name))
        found.value(name)[:] = value
        if why:
            found.reasons[name] = {0: why}
    found.seconds[:] = clock.process_time() - began
    return found


_ESTIMATES = {"error": "error_estimate", "model_error": "model_error"}
"""Settings by the first key of a summary for which they are made."""
