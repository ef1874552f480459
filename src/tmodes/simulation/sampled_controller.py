"""A Python controller that is called once a sample; between samples its commands are held and the native loop runs.

The input of the loop has a knot at each sample, so that steps of every method end there; the commands of a sample are
written into the piece that begins with it.
"""

from __future__ import annotations

import time as clock
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from math import isfinite
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, Status
from tmodes.errors import InputError, SimulationError, error_words
from tmodes.io.words import meant
from tmodes.kinds.signals.registry import Clock, merge
from tmodes.kinds.signals.schedule import SignalPieces
from tmodes.simulation.event_detection import WatchedRun
from tmodes.simulation.initial_state import RunSetup
from tmodes.simulation.native_run import NativeRun
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.python_controller import controller_error
from tmodes.simulation.stops import Stops

__all__ = ["Measurement", "SampledController", "refuse_period", "run_with_samples"]

Array = NDArray[np.float64]

_RUNNING, _FINISHED = float(Status.RUNNING), float(Status.FINISHED)

_PIECE, _LOOKED_AFTER = 100_000, 64
"""Steps of one call of the native loop, and samples between two looks at the clock."""


@dataclass(frozen=True, eq=False, slots=True)
class Measurement:
    """What is measured at a sample, at the time ``t`` [s].

    ``q`` and ``v`` (nq,): all coordinates [rad, m] and their rates, in the order of the model's ``coordinates``;
    ``currents`` (m,) [A]: of the motors whose current is a state; ``setpoints`` (drives, 2): signals of the drives and
    their derivatives. Each also by name, see the methods.

    >>> def controller(m):
    ...     return {"joint": 5 * (m.setpoint("joint") - m.position("joint.motor")) - m.velocity("joint.motor")}
    >>> robot.run(controller=controller, period=1e-3).status
    'finished'
    """

    t: float
    q: Array
    v: Array
    currents: Array
    setpoints: Array
    names: _Names

    def position(self, name: str) -> float:
        """A coordinate [rad, m]: ``shoulder``, of its motor ``shoulder.motor``, of a link ``upper.bend_y1``.

        >>> robot.run(controller=lambda m: -m.position("joint"), period=0.01).status
        'finished'
        """
        return float(self.q[self.names.place("coordinate", name)])

    def velocity(self, name: str) -> float:
        """The rate of a coordinate [rad/s, m/s].

        >>> robot.run(controller=lambda m: -m.velocity("joint.motor"), period=0.01).status
        'finished'
        """
        return float(self.v[self.names.place("coordinate", name)])

    def current(self, joint: str) -> float:
        """The current of a joint's motor [A], where it is a state: the motor has an inductance.

        >>> robot.run(controller=lambda m: m.current("joint"), period=0.01)
        Traceback (most recent call last):
        tmodes.errors.SimulationError: ...
        """
        return float(self.currents[self.names.place("current", joint)])

    def setpoint(self, joint: str) -> float:
        """The value of the signal of a joint's drive, in the unit of its command.

        >>> robot.run(controller=lambda m: m.setpoint("joint"), period=0.01).status
        'finished'
        """
        return float(self.setpoints[self.names.place("drive", joint), 0])

    def setpoint_rate(self, joint: str) -> float:
        """The derivative of that signal [per s].

        >>> robot.run(controller=lambda m: m.setpoint_rate("joint"), period=0.01).status
        'finished'
        """
        return float(self.setpoints[self.names.place("drive", joint), 1])


@dataclass(frozen=True, eq=False)
class _Names:
    """Places of coordinates, currents and drives by their names."""

    places: dict[str, dict[str, int]]

    def place(self, kind: str, name: str) -> int:
        known = self.places[kind]
        if name not in known:
            hint = meant(str(name), known, "check the spelling")
            raise InputError(kind, f"the unknown name {name!r}", f"one of {', '.join(known) or 'none'}", hint)
        return known[name]


SampledController = Callable[[Measurement], ArrayLike | Mapping[str, float]]
"""What is measured -> command of each drive that follows no signal, by joint or in their order: V where its motor has a
resistance and it is no commanded effort, else N*m or N. It may have states of its own; a method ``reset`` is called
before a run."""


def refuse_period(controller: Any, period: float, duration: float) -> None:
    """Raise :class:`tmodes.errors.InputError` for a period that is none, or is longer than the run [s]."""
    if controller is None:
        raise InputError("period", f"{period:g} s", "left out without a controller", "add controller=FUNCTION")
    if not 0 < period <= duration:
        expected = f"a time above 0 and at most the duration of {duration:g} s"
        raise InputError("period", f"{period:g} s", expected, "write period=1e-3 for 1 kHz")


class _Samples:
    """The controller at its samples: it sees the state, and its commands become part of the input."""

    def __init__(self, setup: RunSetup, controller: SampledController, run: NativeRun) -> None:
        plan, layout, model = setup.planned.plan, setup.model.layout, setup.model
        self.controller, self.run, self.layout = controller, run, layout
        servos = [drive for drive in plan.drives if drive.servo]
        self.joints = tuple(drive.joint for drive in servos)
        width = plan.degree + 1
        self.places = np.array([1 + drive.signal * width for drive in servos], dtype=int)
        self.wanted = run.rows[:, self.places[:, None] + np.arange(min(2, width))]
        for k in range(1, width):
            run.rows[:, self.places + k] = 0.0
        coordinates = {name: k for k, name in enumerate(model.coordinates)}
        motors = {f"{driver.plan.joint}.motor": driver.coordinate for driver in model.loop.drivers}
        drives = {joint: k for k, joint in enumerate(self.joints)}
        currents = {joint: k for k, joint in enumerate(plan.currents)}
        self.names = _Names({"coordinate": motors | coordinates, "drive": drives, "current": currents})

    def command(self, k: int, time: float) -> None:
        """Ask for the commands at the start of piece ``k``; raises :class:`tmodes.errors.SimulationError`."""
        state, wanted = self.run.state.copy(), self.wanted[k]
        state.flags.writeable = wanted.flags.writeable = False
        q, v, currents = (state[part] for part in (self.layout.q, self.layout.v, self.layout.currents))
        try:
            answer = self.controller(Measurement(time, q, v, currents, wanted, self.names))
            if isinstance(answer, Mapping):
                answer = self._by_joint(answer, time)
            command = np.asarray(answer, dtype=float).reshape(-1)
        except SimulationError:
            raise
        except Exception as error:
            raise controller_error(self.controller, time, error_words(error), "an answer") from error
        if command.shape != self.places.shape:
            expected = f"{len(self.joints)} numbers, the commands of {', '.join(self.joints)}"
            raise controller_error(self.controller, time, f"an array of shape {np.shape(answer)}", expected)
        if not all(map(isfinite, command.tolist())):
            bad = int(np.flatnonzero(~np.isfinite(command))[0])
            got = f"{command[bad]} for joint {self.joints[bad]}"
            raise controller_error(self.controller, time, got, "finite numbers")
        self.run.rows[k, self.places] = command

    def _by_joint(self, answer: Mapping[str, float], time: float) -> list[float]:
        if set(answer) != set(self.joints):
            got, expected = ", ".join(map(str, answer)) or "nothing", ", ".join(self.joints)
            raise controller_error(self.controller, time, f"commands of {got}", f"a command for each of {expected}")
        return [answer[joint] for joint in self.joints]

    def hold(self, k: int) -> None:
        """Hold the commands over a piece that begins between samples."""
        self.run.rows[k, self.places] = self.run.rows[k - 1, self.places]


def run_with_samples(
    setup: RunSetup,
    controller: SampledController,
    period: float,
    progress: Callable[[float], None] = lambda share: None,
    stops: Stops | None = None,
) -> tuple[Trajectory, RunSetup, Array]:
    """Integrate with a controller that is called at the multiples of ``period`` [s].

    Gives the trajectory, the setup with the commands in its input, and the rows (n, row) of that at the samples.
    ``setup`` is one of :func:`tmodes.simulation.python_controller.driven_by`. Raises
    :class:`tmodes.errors.SimulationError` for a controller that raises or whose answer is wrong at its first call;
    later the run stops and keeps what it has.
    """
    settings, own = setup.robot.integration, setup.planned
    times = Clock(period, settings.output_step).schedule(settings.duration).knots
    signals = [SignalPieces(own.signals.knots, part) for part in own.signals.coefficients.swapaxes(0, 1)]
    clocked = SignalPieces(times, np.zeros((len(times) - 1, 1)))
    merged = merge([*(one.until(settings.duration) for one in signals), clocked])
    schedule = SignalPieces(merged.knots, merged.coefficients[:, :-1].reshape(len(merged.knots) - 1, -1))
    run = NativeRun(setup.problem(settings, schedule))
    run.keep_changes()
    samples = _Samples(setup, controller, run)
    if callable(reset := getattr(controller, "reset", None)):
        reset()
    samples.command(0, 0.0)
    begun = clock.monotonic()
    going = WatchedRun(run, stops) if stops else run
    at_sample = np.isin(run.knots[:-1], times)
    done = _advanced(run, going, samples, at_sample, progress, begun)
    done = replace(done, seconds=(clock.monotonic() - begun) / max(run.cell("t"), 1e-300))
    held = SignalPieces(run.knots, run.rows[:, 1:].copy())
    used = replace(setup, planned=replace(own, schedule=held))
    return done, used, held.rows_at(done.times)


def _advanced(
    run: NativeRun,
    going: NativeRun | WatchedRun,
    samples: _Samples,
    at_sample: NDArray[np.bool_],
    progress: Callable[[float], None],
    began: float,
) -> Trajectory:
    """Advance piece by piece of the input, with a command at each sample."""
    end, piece, across = float(run.knots[-1]), 0, _Across(run, going)
    try:
        for piece in range(len(run.rows)):
            if piece and at_sample[piece]:
                samples.command(piece, float(run.knots[piece]))
            elif piece:
                samples.hold(piece)
            if not across.piece(piece):
                break
            if piece % _LOOKED_AFTER == 0:
                progress(float(run.knots[piece]) / end)
                if reason := run.exhausted(clock.monotonic() - began):
                    return run.trajectory("stopped", reason)
    except KeyboardInterrupt:
        return run.trajectory("interrupted", f"interrupted at t = {run.cell('t'):.6g} s; what was done is kept")
    except SimulationError as error:
        return run.trajectory("stopped", str(error))
    return going.end()


class _Across:
    """Lets the native loop go to the end of one piece of the input after the other."""

    def __init__(self, run: NativeRun, going: NativeRun | WatchedRun) -> None:
        self.run, self.going, self.call = run, going, []
        self.status, self.met = CELLS.index("status"), CELLS.index("met")

    def piece(self, k: int) -> bool:
        """Go to the end of piece ``k``; whether the run continues there."""
        run, memory = self.run, self.run.memory
        run.segments, memory[self.status] = k + 1, _RUNNING
        if self.going is run:
            self._quickly(k + 1)
        while memory[self.status] == _RUNNING:
            self.call = []
            self.going.advance(_PIECE)
        return memory[self.status] == _FINISHED

    def _quickly(self, segments: int) -> None:
        """The same loop, without making its arguments again: most pieces are a step or two."""
        run = self.run
        if not self.call:
            self.loop, self.arguments = run.loop, run.arguments(_PIECE)
            self.call = [one if isinstance(one, int) else one.ctypes.data for one in self.arguments.values()]
        self.call[ARGUMENTS.index("segments")] = segments
        self.loop(*self.call)
        if run.memory[self.status] != _FINISHED or run.memory[self.met]:
            run.settle()
