"""What is observed of a run at instants, and numbers that are measured on it, each with its derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.outputs import Outputs, output_schedule
from tmodes.errors import InputError, TmodesError, error_words
from tmodes.gradients.lowering import Lowered, pieces_at
from tmodes.io.arguments import checked_arguments, numbers_of, refuse_fields
from tmodes.io.words import shown
from tmodes.model.derivatives import Blocks, differentiated
from tmodes.simulation.recording import Recording
from tmodes.simulation.reductions import SMOOTH, Reduction, with_slope

__all__ = ["Functional", "Quantities", "Weights", "measured_by", "reduced_output", "tracking_error"]

Array = NDArray[np.float64]

_FROM = ("state", "row", "parameters")


class Weights(NamedTuple):
    """Derivatives of a number: by the states at the samples, (n, size), the parameters, the rows (segments, row).

    ``given``: by what distances are from, (n, 3) by their names.
    """

    states: Array
    parameters: Array
    rows: Array
    given: dict[str, Array]


class Quantities:
    """Outputs at the samples of a run by their names, or groups of them, each (n, numbers).

    Names as of :class:`tmodes.equations.loop.outputs.Outputs`; groups are ``state``, ``q``, ``v``, ``a``, ``drives``
    (effort, voltage, current and setpoint of each), ``gear``, ``contact``, ``base``, ``powers``, and ``tip``,
    ``tip_velocity``, ``points.NAME``, ``points.NAME_velocity`` (n, 3) of the named points, in the world. ``given``: by
    the names of distances what the tip's is from, (n, 3). Raises :class:`tmodes.errors.InputError` for other names.
    """

    def __init__(
        self, here: Lowered, done: Recording, names: Sequence[str], given: Mapping[str, Array] | None = None
    ) -> None:
        self.done, self.names, self.given = done, tuple(dict.fromkeys(names)), tuple(given or {})
        self._pieces = pieces_at(done.rows, done.times)
        time = done.times[:, None]
        self._instants = {
            "time": time, "state": np.hstack([done.samples, *(given or {}).values()]), "row": done.rows[self._pieces],
            "step": np.zeros_like(time),
        }  # fmt: skip
        outputs = Outputs(here.model.loop, self.given)
        groups = {name: outputs.group(name, "quantities") for name in self.names}
        self.outputs = [output for group in groups.values() for output in group]
        wanted = output_schedule(
            here.model.loop, groups, 3 * len(self.given), after=here.model.plan.is_sampled, often=False
        )
        self.parameters = np.concatenate([here.parameters, wanted.further])
        self._of = differentiated(wanted.schedule, self.names) if self.names else None

    def info(self) -> Blocks:
        """Their values at the samples."""
        return self._of.values(self.parameters, self._instants) if self._of else {}

    def back(self, weights: Mapping[str, Array]) -> Weights:
        """Derivatives of the sum of ``weights`` times the quantities, each in its shape."""
        rows = np.zeros_like(self.done.rows)
        if self._of is None or not weights:
            return Weights(np.zeros_like(self.done.samples), np.zeros(len(self.parameters)), rows, {})
        found = self._of.back(self.parameters, self._instants, dict(weights), _FROM)
        np.add.at(rows, self._pieces, found["row"])
        size = self.done.samples.shape[1]
        given = {name: found["state"][:, size + 3 * k :][:, :3] for k, name in enumerate(self.given)}
        return Weights(found["state"][:, :size], found["parameters"], rows, given)

    def along(self, states: Array, parameters: Array, rows: Array, given: Sequence[Array] = ()) -> Blocks:
        """Their slopes, by names, where the states have slopes (n, size), and parameters and rows change.

        ``given``: slopes (n, 3) of what distances are from, in their order.
        """
        slopes = {"state": np.hstack([states, *given]), "row": rows[self._pieces]}
        return self._of.along(self.parameters, self._instants, slopes, change=parameters) if self._of else {}


@dataclass(frozen=True, repr=False)
class Functional:
    """One number of a run: ``measure(times (n,), quantities)`` -> its value and its derivatives.

    ``quantities``: names of what is looked at, as :class:`tmodes.gradients.quantities.Quantities` knows them;
    ``quantities`` holds each as an array (n, numbers), derivatives by the same names in the same shapes; a name that
    is left out has none.

    >>> def end(times, quantities):  # height of the tip at the end [m], and its derivatives
    ...     slope = np.zeros_like(quantities["tip"])
    ...     slope[-1, 2] = 1.0
    ...     return quantities["tip"][-1, 2], {"tip": slope}
    >>> round(robot.gradient(tmodes.Functional(("tip",), end), ["gear.stiffness"]).value, 3)
    -1.0
    """

    quantities: tuple[str, ...]
    measure: Callable[[Array, Mapping[str, Array]], tuple[float, Mapping[str, ArrayLike]]]

    def __post_init__(self) -> None:
        refuse_fields(self)

    def __repr__(self) -> str:
        return f"a number of {', '.join(self.quantities)} over a run"


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

    >>> tmodes.adjoint_gradient(robot, tmodes.tracking_error("tip", [0, 0, -1])).value > 0
    True
    """

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        is_ = info[quantity]
        given = reference(times) if callable(reference) else reference
        apart = is_ - numbers_of(given, "reference", (is_.shape, is_.shape[1:]), "one at each sample or one for all")
        shares = _trapezoids(times)[:, None]
        return float((shares * apart**2).sum()), {quantity: 2 * shares * apart}

    return Functional((quantity,), measure)


@checked_arguments
def reduced_output(output: str, how: str) -> Functional:
    """One number of an output over the run, in its unit: ``reduced_output("energy.total", "rms")``.

    ``how``: a rule that has a derivative, ``mean``, ``rms`` or ``end``, as of
    :class:`tmodes.simulation.reductions.Reduction`. Raises :class:`tmodes.errors.InputError` for another one.

    >>> tmodes.reduced_output("tip.speed", "rms").quantities
    ('tip.speed',)
    """
    if how not in SMOOTH:
        hint = "a largest or least value has no slope everywhere; take rms"
        raise InputError("how", shown(how), f"one of {', '.join(SMOOTH)} for gradients", hint)

    def measure(times: Array, info: Mapping[str, Array]) -> tuple[float, Mapping[str, ArrayLike]]:
        value, slopes = with_slope(Reduction(output, how), info[output][:, 0], times)
        return value, {output: slopes[:, None]}

    return Functional((output,), measure)


def _trapezoids(times: Array) -> Array:
    """Weights of samples in an integral over time."""
    steps = np.diff(times)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
