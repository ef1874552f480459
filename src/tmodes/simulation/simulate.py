"""Simulation: the nominal robot plans the motion, the actual robot runs under control.

pair -> nominal run (nominal robot, its motors exactly where they should be) -> run (actual robot) -> RunData
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, NamedTuple, cast

import numpy as np

from tmodes.analysis.spectrum import StepVerdict, growth_warnings, step_size_verdict, step_times_eigenvalue
from tmodes.equations.loop.outputs import COMMANDED, DEVIATION, DISTANCES
from tmodes.errors import InputError
from tmodes.integrate.choice import chosen_method, explained, otherwise
from tmodes.integrate.registry import AUTO
from tmodes.integrate.settings import refuse_too_large
from tmodes.io.words import several
from tmodes.sheet import Robot, RobotPair
from tmodes.sheet.parts import Command
from tmodes.simulation.initial_state import RunSetup, run_setup, run_trajectory
from tmodes.simulation.loop import refuse_switches
from tmodes.simulation.motion_run import RunData, bytes_per_sample, gathered
from tmodes.simulation.outputs import run_stops
from tmodes.simulation.parts import Journal, Trajectory
from tmodes.simulation.plan import Follow, refuse_path
from tmodes.simulation.python_controller import Controller, driven_by, fixed_steps, run_with_controller
from tmodes.simulation.sampled_controller import SampledController, refuse_period, run_with_samples
from tmodes.simulation.stops import STOPPED, Instants, Places, Stops
from tmodes.simulation.warnings import departures, jumps, no_motion, run_warnings, start_warnings

__all__ = ["simulate_motion"]

Progress = Callable[[str, float], None]
Journals = Callable[[str], Journal | None]

_WITHOUT_NOMINAL = (
    "errors are those from the commanded path alone, there is no nominal run: {}, which no motor can follow exactly"
)

_CAUSES = (
    "an equilibrium above the horizontal that tips over, buckling, a loose joint that falls, friction of a contact "
    "that pulls, or the controller"
)
"""What makes a start unstable."""


class _Setups(NamedTuple):
    """The actual robot, the nominal one as its nominal run moves it (None without one), and why not."""

    real: RunSetup
    nominal: RunSetup | None
    warnings: list[str]

    def by_method(self) -> tuple[_Setups, StepVerdict, str]:
        """The same with the integrator chosen for both, the verdict on its step, and why it was chosen."""
        given, spectra = self.real.robot.integration, [one.spectrum for one in (self.nominal, self.real) if one]
        implicit = self.real.implicit
        method, why = chosen_method(given, max(spectrum.highest for spectrum in spectra), implicit)
        later = otherwise(given, method, implicit)
        real, nominal = (one and one.by(method, later) for one in (self.real, self.nominal))
        assert real is not None  # noqa: S101
        verdicts = [step_size_verdict(real.robot.integration, spectrum) for spectrum in spectra]
        verdict = max(verdicts, key=lambda verdict: (not verdict.stable, verdict.highest))
        return _Setups(real, nominal, self.warnings), verdict, why


def simulate_motion(
    robot: Robot | RobotPair,
    *,
    progress: Progress = lambda stage, share: None,
    journals: Journals = lambda stage: None,
    controller: Controller | SampledController | None = None,
    period: float | None = None,
    stop: str | Sequence[str] = (),
) -> RunData:
    """The trajectories of the nominal and the actual robot; arguments and errors as of :func:`tmodes.run`.

    A ``controller`` (:data:`tmodes.simulation.python_controller.Controller`) without a ``period`` is slow, integrated
    by an explicit method (at fixed steps where ``auto`` chooses: its answers need not be smooth). None is kept in a
    journal.
    """
    pair = robot if isinstance(robot, RobotPair) else robot.commanded(progress).pair()
    refuse_path(pair.real)
    real = run_setup(pair.real)
    if period is not None:
        refuse_period(controller, period, pair.real.integration.duration)
        real = driven_by(real, volts=True)
    further = several("stop", stop)
    stops = run_stops(real, further)
    _refuse(real)
    if controller is not None and period is None:
        refuse_switches(real.model, "a Python controller", "take a controller of the sheet")
    else:
        stops.refuse_at_start(Instants(np.zeros(1), real.start[None, :], real.first_row[None, :]))
    setups, verdict, why = _prepared(pair, real).by_method()
    if controller and period is None and pair.real.integration.method == AUTO:
        real, why = fixed_steps(setups.real, verdict.highest)
        setups = setups._replace(real=real)
    warnings = [
        *([verdict.sentence] if verdict.sentence else []),
        *_growing(setups),
        *start_warnings(setups.real),
    ]
    warnings += setups.warnings
    reference, until = _reference(setups.nominal, progress, journals, warnings)
    if reference and reference.status == "diverged":
        reference = replace(reference, message=f"{reference.message}; likely cause: {_cause(verdict, warnings)}")
    stops = replace(stops, places=_places(stops, setups, reference))
    if controller and period is not None:
        trajectory, used, rows = run_with_samples(
            setups.real, cast("SampledController", controller), period, _of_actual(progress), stops
        )
    else:
        trajectory, used, rows = _run(setups.real, until, stops, progress, journals, controller, further)
    warnings += departures(used, used.first_row if rows is None else rows[0])
    if reference and trajectory.status == STOPPED:
        cut = run_trajectory(reference.setup, until=float(trajectory.times[-1]))  # so that it has a sample there
        reference = _warned(gathered(reference.setup, cut))
    if trajectory.status == "diverged":
        trajectory = replace(trajectory, message=f"{trajectory.message}; likely cause: {_cause(verdict, warnings)}")
    elif trajectory.status in ("finished", STOPPED):
        trajectory = replace(trajectory, message=explained(trajectory.message, why))
    run = _warned(gathered(used, trajectory, rows), *warnings)
    if run.status in ("finished", STOPPED) and (why := no_motion(run)):
        message = f"{run.message}, but {why}; likely cause: {_cause(verdict, warnings)}"
        run = replace(run, status="diverged", message=message)
    dt_omega = step_times_eigenvalue(verdict, run.statistics)
    statistics = run.statistics | {"highest_eigenvalue": verdict.highest, "dt_omega": dt_omega}
    return replace(run, reference=reference, statistics=statistics)


def _refuse(real: RunSetup) -> None:
    """Refuse a run that is too large for memory, and a robot in which nothing moves."""
    settings = real.robot.integration
    samples = settings.duration / settings.output_step
    refuse_too_large(settings, samples, 2 * bytes_per_sample(real.model), "or a shorter duration")
    if not real.model.coordinates:
        expected, hint = "a joint that moves or a link that bends", "unlock a joint, or give a beam functions"
        raise InputError("joints", "an arm in which nothing moves or bends", expected, hint)


def _prepared(pair: RobotPair, real: RunSetup) -> _Setups:
    """Both robots ready to run, chain and rest of one taken for the other where they are the same."""
    if any(drive.command is Command.POSITION for drive in pair.nominal.drives):
        nominal = run_setup(pair.nominal, Follow.WANTED, like=real)
        jumping = jumps(nominal)
        if jumping:
            return _Setups(real, None, [_WITHOUT_NOMINAL.format(jumping)])
        return _Setups(real, nominal, [])
    return _Setups(real, run_setup(pair.nominal, like=real) if pair.nominal.real else None, [])


def _growing(setups: _Setups) -> list[str]:
    """What grows at the start of both robots; of sampled controllers the spectrum has the held command alone."""
    named = (("nominal robot", setups.nominal), ("actual robot", setups.real))
    known = [(name, setup) for name, setup in named if setup and not (setup.planned.plan.is_sampled or setup.callback)]
    found = [warning for name, setup in known for warning in growth_warnings(setup.spectrum, name, _CAUSES)]
    for block in setups.real.planned.plan.blocks:
        found += [f"control block `{block.name}`: {remark}" for remark in block.law.block.remarks()]
    from tmodes.simulation.drive_loops import start_loops

    return [*found, *start_loops(setups.real, margins=False)[1]]


def _run(
    real: RunSetup,
    until: float | None,
    stops: Stops,
    progress: Progress,
    journals: Journals,
    controller: Any,
    stop: tuple[str, ...],
) -> tuple[Trajectory, RunSetup, np.ndarray | None]:
    """The trajectory of the actual robot, the setup that moved, and its rows where they are not the schedule's."""
    if controller is None:
        done = run_trajectory(real, _of_actual(progress), journals("real"), until, stops)
        return done, real, None
    real = driven_by(real)
    own = replace(run_stops(real, stop), places=stops.places)  # states without the sheet's control are shorter
    done, rows = run_with_controller(real, controller, _of_actual(progress), own)
    return done, real, rows


def _of_actual(progress: Progress) -> Callable[[float], None]:
    return lambda share: progress("actual robot", share)


def _reference(
    nominal: RunSetup | None, progress: Progress, journals: Journals, warnings: list[str]
) -> tuple[RunData | None, float | None]:
    """The nominal run, and the time [s] at which the real one must end to be compared with it (None: its own end)."""
    if nominal is None:
        return None, None
    done = run_trajectory(nominal, lambda share: progress("nominal robot", share), journals("reference"))
    run = _warned(gathered(nominal, done))
    if done.status == "finished":
        return run, None
    warnings.append(f"the nominal run ended early: {done.message}")
    return run, 0.0 if done.status == "interrupted" else float(done.times[-1])


def _places(stops: Stops, setups: _Setups, reference: RunData | None) -> Places | None:
    """Where the tip should be at any times, for conditions on its distance from there: (n, 3) each of ``FROM``.

    The nominal tip between samples is the polynomial of fifth degree by its positions, velocities and accelerations.
    Raises :class:`tmodes.errors.InputError` where there is no such place.
    """
    if not stops.distances:
        return None
    from scipy.interpolate import BPoly

    from tmodes.simulation.vary.tables import commanded_states, setpoints

    planned = setups.nominal or setups.real
    known, tip, model = setpoints(planned), None, planned.model
    if reference and len(reference.times) > 1:
        points = reference.points
        tip = BPoly.from_derivatives(
            reference.times,
            np.stack([part[:, 0] for part in (points.position, points.velocity, points.acceleration)], 1),
        )
    for name, there in ((DEVIATION, tip), (COMMANDED, known)):
        if name in stops.distances and there is None:
            got = f"`{name}`, but there is no {DISTANCES[name]}"
            raise InputError("stop", got, "a condition on what the run has", "stop on another output")

    def places(times: np.ndarray) -> np.ndarray:
        found = np.full((len(times), 6), np.nan)
        if tip is not None:
            found[:, :3] = tip(times)
        if known is not None:
            rows = planned.planned.schedule.rows_at(times)
            states = commanded_states(planned, known, rows, times)
            found[:, 3:] = model.seen(model.outputs.groups["tip"], times, states, rows)
        return found

    return places


def _warned(run: RunData, *before: str) -> RunData:
    """The run with its warnings, after those that came before it."""
    return replace(run, warnings=(*before, *run_warnings(run)))


def _cause(verdict: StepVerdict, warnings: list[str]) -> str:
    if not verdict.stable:
        return verdict.sentence
    growing = next((warning for warning in warnings if "unstable at its start" in warning), "")
    return growing or "what drives the arm runs away: a signal, gains of the wrong size, or a singular motion"
