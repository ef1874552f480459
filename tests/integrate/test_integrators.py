"""Orders, energy, jumps and interruptions of the native time loops."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import RK45, solve_ivp

from tmodes.integrate.dormand_prince import B_ERROR, DENSE, A, C
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.parts import sample_times
from tmodes.simulation.plan import Follow
from tmodes.simulation.problem import problem_of
from tmodes.simulation.solve import solve

LOSSLESS = {
    "motor.friction": 0.0, "gear.damping": 0.0, "link.modes.0.damping_time": 0.0, "link.modes.1.damping_time": 0.0,
}  # fmt: skip
STILL = {"reference.end": 0.0, "reference.duration": 200.0}
"""A motor that stands, where it follows its reference."""


def setting(robot, **changes):
    return robot.integration.model_copy(update=changes)


def prepared(robot, follow=Follow.SHEET, *, reading="consistent", contact=False) -> RunSetup:
    return run_setup(robot.with_({"reading": reading, "contact": contact}), follow)


def plucked(setup):
    """The state of the locked arm well away from rest: joint, then bending angles."""
    state = setup.start.copy()
    state[setup.model.layout.q] += [0.0, 0.008, 0.002, 0.029, 0.004, -0.032]
    return state


def integrated(setup, state=None, **changes):
    settings = setting(setup.robot, **changes)
    state = setup.start if state is None else state
    return solve(problem_of(setup.model, setup.model.numbers, setup.planned.schedule, state, settings))


def run(robot, *, contact=False, reading="consistent", **changes):
    return integrated(prepared(robot, reading=reading, contact=contact), **changes)


def energies(setup, done):
    """All energy of a robot at the samples of its run [J]."""
    layout = setup.model.layout
    found = setup.mechanics.energies(done.states[:, layout.q], done.states[:, layout.v])
    return np.sum([*found.values()], axis=0)


def slope(steps, errors):
    return np.polyfit(np.log(steps), np.log(errors), 1)[0]


def test_order_of_rk4(robot):
    """The error falls with the fourth power of the step, over the jumps of the reference too."""
    exact = run(robot, duration=0.6, relative_tolerance=1e-13, absolute_tolerance=1e-15).states[-1, :12]
    steps = np.array([8e-4, 4e-4, 2e-4])
    errors = [np.abs(run(robot, method="rk4", step=h, duration=0.6).states[-1, :12] - exact).max() for h in steps]
    assert slope(steps, errors) == pytest.approx(4.0, abs=0.25)


def test_order_of_dormand_prince(robot):
    """The error falls with the fifth power of the number of steps."""
    exact = run(robot, duration=0.6, relative_tolerance=1e-13, absolute_tolerance=1e-15).states[-1, :12]
    counts, errors = [], []
    for tolerance in (1e-6, 1e-7, 1e-8, 1e-9):
        one = run(robot, duration=0.6, relative_tolerance=tolerance, absolute_tolerance=tolerance * 1e-3)
        counts.append(one.statistics["steps"])
        errors.append(np.abs(one.states[-1, :12] - exact).max())
    assert slope(counts, errors) == pytest.approx(-5.0, abs=0.9)


def test_dormand_prince_tableau():
    """Row sums, the order conditions of the weights, and SciPy's copy of the published coefficients."""
    for c, row in zip(C, A, strict=True):
        assert sum(row) == pytest.approx(c, abs=1e-14)
    weights = np.array(A[6])
    for power in range(5):
        assert weights @ np.array(C[:6]) ** power == pytest.approx(1 / (power + 1), abs=1e-14)
    assert np.allclose(np.array(B_ERROR), -RK45.E, atol=1e-15)
    assert np.allclose(np.array(DENSE), RK45.P, atol=1e-15)


@pytest.mark.parametrize("reading", ["printed", "consistent"])
@pytest.mark.parametrize(("method", "order"), [("rk4", 4), ("dormand_prince", 4), ("dop853", 5)])
def test_energy_without_losses(robot, reading, method, order):
    """Locked motor, no loss: energy drifts only by the integrator, and the drift falls at least at its order."""
    setup = prepared(robot.with_(LOSSLESS | STILL), Follow.WANTED, reading=reading)
    drifts, counts = [], []
    for level in (1, 2, 4):
        change: dict = {
            "step": 1.6e-4 / level,
            "relative_tolerance": 1e-5 / level**5,
            "absolute_tolerance": 1e-9 / level**5,
        }
        one = integrated(setup, plucked(setup), method=method, duration=1.0, **change)
        energy = energies(setup, one)
        drifts.append(np.abs(energy - energy[0]).max() / abs(energy[0]))
        counts.append(one.statistics["steps"])
    assert slope(counts, drifts) < -order + 0.3
    assert drifts[-1] < 1e-5


@pytest.mark.parametrize("method", ["rk4", "dormand_prince", "dop853"])
def test_chunks_change_no_bit(robot, monkeypatch, method):
    """However the loop is cut into calls, the samples are the same bytes."""
    whole = run(robot, duration=0.7, method=method)
    monkeypatch.setattr("tmodes.simulation.native_run._FIRST_PIECE", 7)
    monkeypatch.setattr("tmodes.simulation.native_run._PIECE_SECONDS", 1e-5)
    assert run(robot, duration=0.7, method=method).states.tobytes() == whole.states.tobytes()


@pytest.mark.parametrize("method", ["rk4", "dormand_prince", "dop853"])
def test_agrees_with_scipy(robot, method):
    """The same right-hand side through SciPy's DOP853, restarted at the jumps, at tight tolerance."""
    setup = prepared(robot, contact=True)
    schedule, state = setup.planned.schedule, setup.start
    for start, end in zip(schedule.knots[:-1], schedule.knots[1:], strict=True):
        row = schedule.rows_at(np.array([start]))[0]

        def rate(t, y, row=row):
            return setup.model.rate([t], y, row)[0]

        state = solve_ivp(rate, (start, end), state, method="DOP853", rtol=1e-10, atol=1e-13).y[:, -1]
    ours = run(robot, contact=True, method=method, step=2 / 75000)
    assert np.abs(ours.states[-1, :6] - state[:6]).max() < 2e-9


def test_samples_between_steps(robot):
    """Dense output: samples do not depend on how densely they are asked for."""
    fine, coarse = run(robot, duration=0.5, output_step=1e-4), run(robot, duration=0.5, output_step=1e-2)
    assert np.allclose(fine.states[::100], coarse.states, rtol=0, atol=1e-13)
    rk4 = [run(robot, method="rk4", duration=0.5, step=1e-4, output_step=h) for h in (1e-4, 3e-5)]
    assert np.allclose(rk4[0].states[::3], rk4[1].states[::10], atol=1e-8)


@pytest.mark.parametrize(
    ("duration", "step", "last"), [(2.0, 1e-3, 2001), (1.0, 0.3, 5), (0.5, 0.5, 2), (0.1, 1e-3, 101)]
)
def test_sample_times(robot, duration, step, last):
    """Every output step, and the end exactly, also where it is no multiple."""
    times = sample_times(setting(robot, duration=duration, output_step=step))
    assert len(times) == last
    assert times[0] == 0
    assert times[-1] == duration
    assert (np.diff(times) > 0).all()


def test_divergence_is_reported(robot):
    """A run that blows up stops with time, coordinate and reason, and keeps what it had."""
    stiff = robot.with_({"gear.stiffness": 4.7e9})
    lost = run(stiff, method="rk4", step=1e-3, output_step=1e-3)
    assert lost.status == "diverged"
    assert "at t = " in lost.message
    assert "coordinate" in lost.message
    assert 1 <= len(lost.times) < 2001
    assert np.isfinite(lost.states).all()


def test_limits_stop_a_run(robot):
    """Steps and wall time are bounded; what was done is kept and marked."""
    short = run(robot, max_steps=600)
    assert short.status == "stopped"
    assert "max_steps" in short.message
    assert 1 < len(short.times) < 2001
    late = run(robot, max_wall_time=1e-9)
    assert late.status == "stopped"
    assert "max_wall_time" in late.message


def test_interruption_keeps_what_was_done(robot):
    """Ctrl-C ends a run with its samples so far."""
    setup = prepared(robot)

    def press(share):
        if share > 0.2:
            raise KeyboardInterrupt

    numbers, settings = setup.model.numbers, robot.integration
    one = solve(problem_of(setup.model, numbers, setup.planned.schedule, setup.start, settings), progress=press)
    assert one.status == "interrupted"
    assert 400 < len(one.times) < 2001
    assert np.array_equal(one.states, run(robot).states[: len(one.times)])


def test_a_killed_run_continues_with_the_same_bytes(robot, tmp_path):
    """A journal of a run that died, at any piece, gives the bytes of a run that did not."""
    from tmodes.io.checkpoint import RunJournal

    whole = run(robot, duration=1.0)
    setup, settings, one = prepared(robot), setting(robot, duration=1.0), None
    for _ in range(40):
        journal = RunJournal(tmp_path / "log", "this run", seconds=0.0)
        pieces = iter(range(2))

        def die(share, pieces=pieces):
            if next(pieces, None) is None:
                raise MemoryError

        try:
            one = solve(setup.problem(settings), progress=die, journal=journal)
        except MemoryError:
            continue
        finally:
            journal.close()
        break
    assert one is not None
    assert one.states.tobytes() == whole.states.tobytes()
    assert one.statistics == whole.statistics
