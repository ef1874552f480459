"""Search by Optuna: tree-structured Parzen estimators for one objective, NSGA-II for several."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.study.optimize.trials import Trials

__all__ = ["search"]

Array = NDArray[np.float64]

BATCH = 16
"""Designs that are asked for, and computed, together."""

STARTS = 2 * BATCH
"""Most evenly spread designs at the start; not more for more trials, so that a search can be continued."""


def search(trials: Trials, method: str, count: int, seed: int, progress: Callable[[str, float], None]) -> None:
    """Try ``count`` designs: first evenly spread ones, then those that the sampler asks for, 16 together.

    The same seed asks for the same designs. ``tpe``: S. Watanabe, arXiv:2304.11127, with limits; ``nsga2``: K. Deb et
    al., IEEE Trans. Evol. Comput. 6 (2002). Raises :class:`tmodes.errors.InputError` where Optuna is not installed.
    """
    optuna = _library()
    with _quiet(optuna):
        study = optuna.create_study(
            sampler=_sampler(optuna, method, seed, count),
            directions=["minimize"] * len(trials.goals.aims),
        )
        for start in _even(trials, _starts(count), seed):
            study.enqueue_trial(start)
        done = 0
        while done < count:
            done += _batch(optuna, study, trials, min(BATCH, count - done))
            progress("designs", done / count)


def _starts(count: int) -> int:
    """Evenly spread designs at the start of a search of so many; of a short one fewer, so that it searches at all."""
    return min(count, STARTS if count > STARTS + BATCH // 2 else BATCH)


def _sampler(optuna: Any, method: str, seed: int, count: int) -> Any:
    samplers, seed = optuna.samplers, seed % 2**32  # of more it hears nothing
    if method == "nsga2":
        size = max(BATCH, BATCH * round(count / 20 / BATCH))
        return samplers.NSGAIISampler(population_size=size, seed=seed)
    return samplers.TPESampler(seed=seed, n_startup_trials=0, multivariate=True, constant_liar=True)


def _batch(optuna: Any, study: Any, trials: Trials, count: int) -> int:
    """Ask for designs, compute them together, and say what they gave."""
    asked = [study.ask() for _ in range(count)]
    designs = np.array([_suggested(trials, trial) for trial in asked])
    judged = trials.judged(trials.at(designs))
    signed = judged.objectives * trials.goals.signs
    for trial, values, excess in zip(asked, signed, judged.excess, strict=True):
        if np.isfinite(values).all() and np.isfinite(excess).all():
            for limit, over in enumerate(excess.tolist()):
                trial.set_constraint(str(limit), over)
            study.tell(trial, values.tolist())
        else:
            study.tell(trial, state=optuna.trial.TrialState.FAIL)
    return count


def _suggested(trials: Trials, trial: Any) -> list[float]:
    space = trials.space
    ranges = zip(space.names, space.levels, space.low, space.high, strict=True)
    return [
        float(trial.suggest_categorical(name, list(range(levels))) if levels else trial.suggest_float(name, low, high))
        for name, levels, low, high in ranges
    ]


def _even(trials: Trials, count: int, seed: int) -> Iterator[dict[str, Any]]:
    """The first points of a Sobol' sequence."""
    from scipy.stats import qmc

    space = trials.space
    points = qmc.Sobol(len(space.names), scramble=True, rng=np.random.default_rng(seed))
    shares = points.random_base2(int(np.ceil(np.log2(count))))[:count]
    for design in space.at(shares).tolist():
        yield {
            name: int(value) if levels else value
            for name, value, levels in zip(space.names, design, space.levels, strict=True)
        }


def _library() -> Any:
    try:
        import optuna
    except ImportError:
        hint = "pip install 'tmodes[study]', or take --method grid or gradient"
        raise InputError("--method", "no Optuna", "the library Optuna for tpe and nsga2", hint) from None
    return optuna


@contextmanager
def _quiet(optuna: Any) -> Iterator[None]:
    """Neither its log nor its notices that a setting is experimental."""
    before = optuna.logging.get_verbosity()
    optuna.logging.set_verbosity(optuna.logging.ERROR)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", optuna.exceptions.ExperimentalWarning)
            yield
    finally:
        optuna.logging.set_verbosity(before)
