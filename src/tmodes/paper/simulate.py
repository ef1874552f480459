"""RUN: the robot as it is known plans the motion, the robot as it really is runs under control.

pair -> reference regime (nominal robot, motor follows theta_o exactly) -> controlled run (real robot) -> Result
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from tmodes.analysis.spectrum import Spectrum
from tmodes.analysis.stability import StepVerdict, growth_warnings, step_size_verdict
from tmodes.integrate.choice import chosen_method, explained, otherwise
from tmodes.paper.mechanism import Drive
from tmodes.paper.modes import all_modes, closed_loop_spectrum
from tmodes.paper.quantities import robot_stops
from tmodes.paper.regime import PaperRun, run_paper
from tmodes.paper.settling import settling
from tmodes.paper.sheet import PaperPair, PaperRobot
from tmodes.simulation.trajectory import STOPPED, Journal

if TYPE_CHECKING:
    from tmodes.result.record import PaperResult

__all__ = ["simulate"]

Progress = Callable[[str, float], None]

_CAUSES = "buckling under environment.preload, friction that feeds power in where Fc < 0, or the controller"
"""What makes a start unstable."""


def simulate(
    robot: PaperRobot | PaperPair,
    *,
    progress: Progress = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
    stop: Sequence[str] = (),
) -> PaperResult:
    """Plan with the known robot, run with the real one, and gather everything into a Result.

    Give a :class:`Robot` (its ``real`` factors make the real one) or a pair of your own. ``stop``: conditions besides
    those of ``integration.stop``; the real robot's run ends where the first of all triggers. A run that cannot go on
    keeps what it had: look at ``result.status`` and ``result.message``.

    Raises :class:`tmodes.errors.SimulationError` when it cannot start (no equilibrium, singular mass matrix, too stiff
    for the steps allowed, a condition that holds already), and :class:`tmodes.errors.InputError` for a condition that
    names no quantity or has another unit.
    """
    from tmodes.paper.assemble import assemble
    from tmodes.paper.headline_errors import with_headline_errors

    pair = robot if isinstance(robot, PaperPair) else robot.pair()
    stops = robot_stops(pair.real, stop)
    spectra = _spectra(pair)
    by, why = _with_method(pair, spectra)
    verdict, growth = _verdict(by, spectra)
    later = otherwise(pair.real.integration, by.real.integration.method)
    reference = run_paper(
        by.nominal, Drive.PRESCRIBED, lambda share: progress("reference", share), journals, otherwise=later
    )
    real = run_paper(
        by.real, Drive.CONTROLLED, lambda share: progress("real robot", share), journals, _as_far_as(reference),
        stops, later,
    )  # fmt: skip
    if real.trajectory.status == STOPPED:  # the reference with a sample at that time, to be compared
        until = float(real.trajectory.times[-1])
        reference = run_paper(by.nominal, Drive.PRESCRIBED, until=until, otherwise=later)
    if real.trajectory.status in ("finished", STOPPED):
        real.trajectory.message = explained(real.trajectory.message, why)
    progress("gathering", 0.0)
    finished = reference.trajectory.status == real.trajectory.status == "finished"
    info: dict[str, Any] = {"frequencies": all_modes(pair.real, contact=False), "settling": None, "warnings": growth}
    if finished:
        try:
            info["settling"] = settling(reference, real)
        except KeyboardInterrupt:
            real.trajectory.status = "interrupted"
            real.trajectory.message = "interrupted after its end, before it was told how the tip settles"
    result = with_headline_errors(assemble(pair, reference, real, info, verdict), reference, real)
    progress("gathering", 1.0)
    runs = {"reference": reference, "real": real}
    result.timing = {name: regime.trajectory.seconds for name, regime in runs.items()}
    return result


def _as_far_as(reference: PaperRun) -> float | None:
    """End of the real run [s]: its own where the reference is whole, else that of the reference, to be compared.

    After Ctrl-C nothing more is computed: the same command continues later.
    """
    planned = reference.trajectory
    if planned.status == "finished":
        return None
    return 0.0 if planned.status == "interrupted" else float(planned.times[-1])


def _spectra(pair: PaperPair) -> dict[str, Spectrum]:
    """Eigenvalues at the start of both regimes, by what they are of."""
    known = closed_loop_spectrum(pair.nominal, drive=Drive.PRESCRIBED)
    return {"robot as known": known, "real robot": closed_loop_spectrum(pair.real, drive=Drive.CONTROLLED)}


def _with_method(pair: PaperPair, spectra: Mapping[str, Spectrum]) -> tuple[PaperPair, str]:
    """The pair with an integrator chosen for both, and why it was."""
    settings = pair.real.integration
    method, why = chosen_method(settings, max(spectrum.highest for spectrum in spectra.values()))
    chosen = {"integration": settings.chosen(method)}
    return PaperPair(pair.nominal.model_copy(update=chosen), pair.real.model_copy(update=chosen)), why


def _verdict(pair: PaperPair, spectra: Mapping[str, Spectrum]) -> tuple[StepVerdict, list[str]]:
    """The worse of the two regimes' verdicts on the step, and what grows at the start."""
    verdicts = [step_size_verdict(pair.real.integration, spectrum) for spectrum in spectra.values()]
    growth = [info for whose, spectrum in spectra.items() for info in growth_warnings(spectrum, whose, _CAUSES)]
    return max(verdicts, key=lambda verdict: (not verdict.stable, verdict.highest)), growth
