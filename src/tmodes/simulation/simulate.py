"""RUN, of a general arm: the arm as it is known plans the motion, the arm as it really is runs under control.

pair -> reference run (nominal arm, its motors exactly where they should be) -> run (real arm) -> ArmRun
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from tmodes.analysis.spectrum import Spectrum, spectrum_of
from tmodes.analysis.stability import StepVerdict, growth_warnings, step_size_verdict, step_times_eigenvalue
from tmodes.errors import InputError
from tmodes.integrate.choice import chosen_method, explained, otherwise
from tmodes.integrate.settings import Integration, refuse_too_large
from tmodes.sheet import Robot, RobotPair
from tmodes.sheet.parts import Command
from tmodes.simulation.callback import Controller, driven_by, run_with_controller
from tmodes.simulation.motion_run import RunData, bytes_per_sample, gathered
from tmodes.simulation.plan import Follow
from tmodes.simulation.quantities import arm_stops
from tmodes.simulation.start import RunSetup, run_setup, run_trajectory
from tmodes.simulation.stops import Instants
from tmodes.simulation.trajectory import STOPPED, Journal
from tmodes.simulation.warnings import jumps, run_warnings, start_warnings

__all__ = ["closed_loop_spectrum", "simulate_motion"]

Progress = Callable[[str, float], None]

_CAUSES = "an equilibrium above the horizontal that tips over, buckling, a loose joint that falls, or the controller"
"""What makes a start unstable."""


def simulate_motion(
    arm: Robot | RobotPair,
    *,
    progress: Progress = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
    controller: Controller | None = None,
    stop: Sequence[str] = (),
) -> RunData:
    """Plan with the known arm, run the real one, and gather what a run shows.

    Give an :class:`Robot` (its ``real`` factors make the real one) or a pair of your own. ``journals`` gives where the
    stages ``reference`` and ``real`` keep their progress. ``controller``: a Python function that tells the efforts of
    the real arm (:data:`tmodes.simulation.callback.Controller`); slow, with an explicit method, and kept in no journal.
    ``stop``: conditions beside those of ``integration.stop``; the real arm's run ends where the first of all sets in.

    A run that cannot go on keeps what it had: look at ``status`` (one of :data:`tmodes.result.record.STATUSES`) and
    ``message``. Raises :class:`tmodes.errors.InputError` for what cannot be run or is too large, and
    :class:`tmodes.errors.SimulationError` where it cannot start.
    """
    pair = arm if isinstance(arm, RobotPair) else arm.pair()
    real = run_setup(pair.real)
    stops = arm_stops(real, tuple(stop))
    samples = real.arm.integration.duration / real.arm.integration.output_step
    refuse_too_large(real.arm.integration, samples, 2 * bytes_per_sample(real.model), "or a shorter duration")
    if not real.model.coordinates:
        expected, hint = "a joint that moves or a link that bends", "unlock a joint, or give a beam functions"
        raise InputError("joints", "an arm in which nothing moves or bends", expected, hint)
    spectrum = closed_loop_spectrum(real)
    given = real.arm.integration
    real, pair, why = _with_method(real, pair, spectrum)
    verdict = step_size_verdict(real.arm.integration, spectrum)
    warnings = [*([verdict.sentence] if verdict.sentence else []), *growth_warnings(spectrum, "real arm", _CAUSES)]
    warnings += start_warnings(real)
    later = otherwise(given, real.arm.integration.method)
    if controller is None:
        stops.refuse_at_start(Instants(np.zeros(1), real.start[None, :], real.first_row[None, :]))
    reference, until = _reference(pair, later, progress, journals, warnings)
    real = replace(real, otherwise=later)
    rows = None
    if controller is None:
        trajectory = run_trajectory(real, lambda share: progress("real arm", share), journals("real"), until, stops)
    else:
        real = driven_by(real)
        own = arm_stops(real, tuple(stop))  # states of a run without the sheet's control are shorter
        trajectory, rows = run_with_controller(real, controller, lambda share: progress("real arm", share), own)
    if reference and trajectory.status == STOPPED:
        reference = _until(reference, float(trajectory.times[-1]))
    if trajectory.status == "diverged":
        trajectory.message += f"; likely cause: {_cause(verdict, warnings)}"
    elif trajectory.status in ("finished", STOPPED):
        trajectory.message = explained(trajectory.message, why)
    run = gathered(real, trajectory, rows)
    dt_omega = step_times_eigenvalue(verdict, run.statistics)
    statistics = run.statistics | {"highest_eigenvalue": verdict.highest, "dt_omega": dt_omega}
    return replace(run, warnings=(*warnings, *run_warnings(run)), reference=reference, statistics=statistics)


def _reference(
    pair: RobotPair,
    later: Integration | None,
    progress: Progress,
    journals: Callable[[str], Journal | None],
    warnings: list[str],
) -> tuple[RunData | None, float | None]:
    """The reference run, and the time [s] at which the real one must end to be compared with it (None: its own end)."""
    if any(drive.command is Command.POSITION for drive in pair.nominal.drives):
        nominal = run_setup(pair.nominal, Follow.WANTED)
        jumping = jumps(nominal)
        if jumping:
            warnings.append(f"no reference run: {jumping}, which no motor can follow exactly")
            return None, None
    elif pair.nominal.real:
        nominal = run_setup(pair.nominal)
    else:
        return None, None
    nominal = replace(nominal, otherwise=later)
    done = run_trajectory(nominal, lambda share: progress("reference", share), journals("reference"))
    run = gathered(nominal, done)
    run = replace(run, warnings=tuple(run_warnings(run)))
    if done.status == "finished":
        return run, None
    warnings.append(f"the reference run ended early: {done.message}")
    return run, 0.0 if done.status == "interrupted" else float(done.times[-1])


def _until(reference: RunData, end: float) -> RunData:
    """The reference run to an earlier end [s], so that it has a sample there."""
    assert reference.regime is not None  # noqa: S101
    run = gathered(reference.regime, run_trajectory(reference.regime, until=end))
    return replace(run, warnings=tuple(run_warnings(run)))


def closed_loop_spectrum(setup: RunSetup) -> Spectrum:
    """Eigenvalues of the robot under its drives at its start, by exact derivatives, and their dominant coordinates."""
    model = setup.model
    matrix = model.jacobian(0.0, setup.start, setup.first_row)
    return spectrum_of(matrix, model.coordinates, [f"{name}.current" for name in model.plan.currents])


def _with_method(regime: RunSetup, pair: RobotPair, spectrum: Spectrum) -> tuple[RunSetup, RobotPair, str]:
    """The same with an integrator chosen, and why it was."""
    settings = regime.arm.integration
    method, why = chosen_method(settings, spectrum.highest)

    def by(arm: Robot) -> Robot:
        return arm.model_copy(update={"integration": arm.integration.chosen(method)})

    return replace(regime, arm=by(regime.arm)), RobotPair(by(pair.nominal), by(pair.real)), why


def _cause(verdict: StepVerdict, warnings: list[str]) -> str:
    if not verdict.stable:
        return verdict.sentence
    growing = next((warning for warning in warnings if "unstable at its start" in warning), "")
    return growing or "what drives the arm runs away: a signal, gains of the wrong size, or a singular motion"
