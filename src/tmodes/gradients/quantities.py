"""What is observed of a run at instants, and numbers that are measured on it, each with its derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.errors import InputError, TmodesError, error_words
from tmodes.gradients.lowering import Lowered
from tmodes.io.arguments import checked_arguments, numbers_of, refuse_fields
from tmodes.io.words import shown
from tmodes.kinds.kernel.schedule import Slot
from tmodes.model.derivatives import Blocks, differentiated
from tmodes.model.passes import ChainPasses
from tmodes.simulation.recording import Recording

__all__ = ["Functional", "Quantities", "Weights", "measured_by", "tracking_error"]

Array = NDArray[np.float64]

_OBSERVED = ("q", "v", "a", "drives", "gear", "contact", "base", "powers")
_MOVED = ("q", "v", "base")
"""What the motion of points follows from."""

_POINT, _PARTS = 24, {"": slice(9, 12), "_velocity": slice(15, 18)}
"""Numbers that are reported of a point, and where they have its position and its velocity."""

_FROM = ("state", "row", "parameters")


class Weights(NamedTuple):
    """Derivatives of a number: by the states at the samples, (n, size), the parameters, the rows (segments, row)."""

    states: Array
    parameters: Array
    rows: Array


class Quantities:
    """Quantities at the samples of a run, by their names.

    ``state`` (n, size); what :meth:`tmodes.simulation.loop.LoopModel.observe` gives; and ``tip``, ``tip_velocity``,
    ``points.NAME`` and ``points.NAME_velocity`` (n, 3) [m, m/s] of the named points, in the world. Raises
    :class:`tmodes.errors.InputError` for other names.
    """

    def __init__(self, here: Lowered, done: Recording, names: Sequence[str]) -> None:
        self.done, self.names, self.parameters = done, tuple(dict.fromkeys(names)), here.parameters
        self._pieces = np.clip(np.searchsorted(done.rows[:, 0], done.times, side="right") - 1, 0, len(done.rows) - 1)
        time = done.times[:, None]
        self._instants = {
            "time": time, "state": done.samples, "row": done.rows[self._pieces], "step": np.zeros_like(time)
        }  # fmt: skip
        loop = here.model.loop
        points = ["tip", *(f"points.{point.name}" for point in loop.parts.points)]  # the first point is the tip
        places = {f"{name}{kind}": (max(k - 1, 0), kind) for k, name in enumerate(points) for kind in _PARTS}
        own = [name for name in self.names if name != "state"]
        _refuse_unknown(own, (*_OBSERVED, *places))
        self._places = {name: places[name] for name in own if name in places}
        self._plain = tuple(name for name in own if name not in places)
        shown = tuple(dict.fromkeys((*self._plain, *(_MOVED if self._places else ()))))
        self._of = differentiated(loop.observe, shown) if shown else None
        self._points = (
            differentiated(ChainPasses(loop.mechanics).schedule("inertia"), ["points"]) if self._places else None
        )

    @cached_property
    def _seen(self) -> Blocks:
        return self._of.values(self.parameters, self._instants) if self._of else {}

    @cached_property
    def _moved(self) -> Blocks:
        return {name: self._seen[name] for name in _MOVED} | {"a": np.zeros_like(self._seen["q"])}

    def info(self) -> Blocks:
        """Their values at the samples."""
        points = self._parted(self._points.values(self.parameters, self._moved)) if self._points else {}
        return self._named(self.done.samples, self._seen, points)

    def back(self, weights: Mapping[str, Array]) -> Weights:
        """Derivatives of the sum of ``weights`` times the quantities, each in its shape."""
        done, given = self.done, dict(weights)
        states, rows, own = np.zeros_like(done.samples), np.zeros_like(done.rows), np.zeros(len(self.parameters))
        states += given.pop("state", 0.0)
        if not given or self._of is None:
            return Weights(states, own, rows)
        mine = {name: weight for name, weight in given.items() if name not in self._places}
        if self._points:
            found = self._points.back(self.parameters, self._moved, self._joined(given), (*_MOVED, "parameters"))
            own = found.pop("parameters")
            mine |= {name: value + mine.get(name, 0.0) for name, value in found.items()}
        info = self._of.back(self.parameters, self._instants, mine, _FROM)
        np.add.at(rows, self._pieces, info["row"])
        return Weights(states + info["state"], info["parameters"] + own, rows)

    def along(self, states: Array, parameters: Array, rows: Array) -> Blocks:
        """Their slopes, by names, where the states have slopes (n, size), and parameters and rows change."""
        slopes = {"state": states, "row": rows[self._pieces]}
        moved = self._of.along(self.parameters, self._instants, slopes, change=parameters) if self._of else {}
        points: Blocks = {}
        if self._points:
            ways = {name: moved[name] for name in _MOVED}
            points = self._parted(self._points.along(self.parameters, self._moved, ways, change=parameters))
        return self._named(states, moved, points)

    def _named(self, states: Array, plain: Blocks, points: Blocks) -> Blocks:
        known = {"state": states, **{name: plain[name] for name in self._plain}, **points}
        return {name: known[name] for name in self.names}

    def _parted(self, info: Blocks) -> Blocks:
        """Positions and velocities from what is reported of all points."""
        points = info["points"].reshape(len(info["points"]), -1, _POINT)
        return {name: points[:, k, _PARTS[kind]] for name, (k, kind) in self._places.items()}

    def _joined(self, weights: Blocks) -> Blocks:
        """Weights of positions and velocities as those of all that is reported of points."""
        count, size = len(self._instants["time"]), sum(slot.size for slot in self._points_of())
        points = np.zeros((count, size // _POINT, _POINT))
        for name, (k, kind) in self._places.items():
            points[:, k, _PARTS[kind]] += weights.get(name, 0.0)
        return {"points": points.reshape(count, size)}

    def _points_of(self) -> Sequence[Slot]:
        assert self._points is not None  # noqa: S101
        return self._points.outputs["points"]


def _refuse_unknown(names: Sequence[str], known: Sequence[str]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a name that is not known."""
    for name in names:
        if name not in known:
            raise InputError("quantities", repr(name), f"names among state, {', '.join(known)}", "correct the name")


@dataclass(frozen=True)
class Functional:
    """One number of a run: ``measure(times (n,), quantities)`` -> its value and its derivatives.

    ``quantities``: names of what is looked at, as :class:`tmodes.gradients.quantities.Quantities` knows them;
    ``quantities`` holds each as an array (n, numbers), derivatives by the same names in the same shapes; a name that
    is left out has none.
    """

    quantities: tuple[str, ...]
    measure: Callable[[Array, Mapping[str, Array]], tuple[float, Mapping[str, ArrayLike]]]

    def __post_init__(self) -> None:
        refuse_fields(self)


def measured_by(functional: Functional, times: Array, info: Mapping[str, Array]) -> tuple[float, dict[str, Array]]:
    """The value and the derivatives of a functional, which may be of one's own.

    Raises :class:`tmodes.errors.InputError` for anything but a finite number, and derivatives by names of its
    quantities in their shapes; and with what it raises.
    """
    try:
        answer = functional.measure(times, info)
    except TmodesError:
        raise
    except Exception as error:
        expected = "a function that gives a number and its derivatives"
        raise InputError("functional.measure", error_words(error), expected, "correct the function") from error
    if not isinstance(answer, tuple) or len(answer) != 2 or not isinstance(answer[1], Mapping):
        got, expected = shown(answer), "a pair: a number, and its derivatives by names of the quantities"
        raise InputError("what functional.measure returns", got, expected, "return value, {name: derivatives}")
    value = float(numbers_of(answer[0], "the value of functional.measure", ((),)))
    for name in answer[1]:
        if name not in functional.quantities:
            expected = f"names among its quantities {', '.join(functional.quantities)}"
            hint = "leave it out, or declare it in quantities"
            raise InputError("the derivatives of functional.measure", f"the name {shown(name)}", expected, hint)
    which = "the derivatives of functional.measure by {}"
    return value, {
        name: numbers_of(given, which.format(name), (info[name].shape,), "that of the quantity")
        for name, given in answer[1].items()
    }


@checked_arguments
def tracking_error(quantity: str, reference: ArrayLike | Callable[[Array], ArrayLike]) -> Functional:
    """The integral over the run of the squared distance of a quantity from its reference, by the trapezoidal rule.

    ``tracking_error("tip", path)`` [m^2 s] with ``path`` (n, 3) [m] at the samples, one position (3,) for all, or a
    function of the times (n,) [s]. The rule's error is that of the samples' distance squared; its derivative is exact.
    """

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        is_ = info[quantity]
        given = reference(times) if callable(reference) else reference
        apart = is_ - numbers_of(given, "reference", (is_.shape, is_.shape[1:]), "one at each sample or one for all")
        shares = _trapezoids(times)[:, None]
        return float((shares * apart**2).sum()), {quantity: 2 * shares * apart}

    return Functional((quantity,), measure)


def _trapezoids(times: Array) -> Array:
    """Weights of samples in an integral over time."""
    steps = np.diff(times)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
