"""Stop conditions: located where closed forms say, in every integrator; which one, when, and what is refused."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.special import ellipk, ellipkinc

from simulation.sheets import arm
from tmodes.errors import InputError, SimulationError
from tmodes.sheet import Robot
from tmodes.simulation import native_run
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.outputs import run_stops
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.step_refinement import refined_run

METHODS = ("dormand_prince", "dop853", "rk4", "extrapolation", "midpoint", "rosenbrock")
G = 9.81


def mass(limits: dict[str, float] | None = None, rate: float = 0.0, **more: Any) -> Robot:
    """2 kg that fall along z from a height of 1 m."""
    integration = {"duration": 1.0, "output_step": 0.01, "step": 1e-3} | more.pop("integration", {})
    joint = {"name": "slide", "type": "prismatic", "parent": "base", "child": "body", "axis": [0, 0, 1]}
    return arm(
        gravity=[0, 0, -G], joints=[joint | ({"limits": limits} if limits else {})],
        links=[{"name": "body", "bodies": [{"name": "load", "mass": 2.0}]}], tip={"link": "body"},
        **{"drives": [{"joint": "slide", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
           "initial": {"state": "zero", "coordinates": {"slide": 1.0}, "rates": {"slide": rate}},
           "integration": integration, **more},
    )  # fmt: skip


def pendulum(**integration: Any) -> Robot:
    """1 kg at 1 m that hangs at angle 0, let go at 1 rad."""
    return arm(
        gravity=G, joints=[{"name": "hinge", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 1, 0]}],
        links=[{"name": "rod", "bodies": [{"name": "bob", "mass": 1.0, "center": [0, 0, -1]}]}],
        tip={"link": "rod", "position": [0, 0, -1]}, initial={"state": "zero", "coordinates": {"hinge": 1.0}},
        drives=[{"joint": "hinge", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        integration={"duration": 3.0, "output_step": 0.01, **integration},
    )  # fmt: skip


def passes(angle: float) -> float:
    """Time at which the pendulum first passes an angle on its way down: the incomplete elliptic integral."""
    k = np.sin(0.5)
    return float(np.sqrt(1.0 / G) * (ellipk(k**2) - ellipkinc(np.arcsin(np.sin(angle / 2) / k), k**2)))


@pytest.mark.parametrize("method", METHODS)
def test_falling_mass_passes_a_height(method: str) -> None:
    """z = 1 - g t^2/2 is exact in every method: the time is found to rounding, and is that of the last sample.

    Rows of extrapolation are summed up with weights of some thousands, and so is their rounding.
    """
    rounding = 1e-12 if method == "extrapolation" else 2e-14
    run = simulate_motion(mass(integration={"method": method}), stop=["tip.z < 250 mm"])
    assert run.status == "stopped_by_condition"
    assert run.times[-1] == pytest.approx(np.sqrt(1.5 / G), abs=rounding)
    assert run.points.position[-1, -1, 2] == pytest.approx(0.25, abs=rounding)
    assert len(run.times) == 41
    assert (np.diff(run.times) > 0).all()
    assert "`tip.z < 250 mm`, tip.z reaches 0.25 m" in run.message
    assert "t = 0.391030944 s" in run.message


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize("angle", [0.4, -0.7])
def test_pendulum_passes_an_angle(method: str, angle: float) -> None:
    """The time of the elliptic integral, within the error of the angle that a second run finds, over the rate."""
    tolerances = {"relative_tolerance": 1e-10, "absolute_tolerance": 1e-12}
    sheet = pendulum(method=method, step=1e-4, stop=[f"hinge.position < {angle} rad"], **tolerances)
    run = simulate_motion(sheet)
    assert run.status == "stopped_by_condition"
    second = refined_run(run.setup, run)
    assert second is not None
    off, info = run.times[-1] - passes(angle), np.abs((second.states - run.states)[-1, 0] / run.v[-1, 0])
    assert abs(off) < 3 * info + 1e-9
    assert abs(off) < 3e-8
    assert run.q[-1, 0] == pytest.approx(angle, abs=1e-12)


def test_time_is_found_with_the_order_of_the_method() -> None:
    """rk4 between its steps: the error of the time falls with the fourth power of the step."""
    steps, off = [4e-2, 2e-2, 1e-2], []
    for step in steps:
        run = run_trajectory(setup := run_setup(pendulum(method="rk4", step=step)),
                             stops=run_stops(setup, ("hinge.position < 0.4 rad",)))  # fmt: skip
        off.append(abs(run.times[-1] - passes(0.4)))
    assert np.polyfit(np.log(steps), np.log(off), 1)[0] == pytest.approx(4.0, abs=0.4)


@pytest.mark.parametrize("method", METHODS)
def test_a_condition_that_holds_for_a_moment_within_a_step(method: str) -> None:
    """Thrown up, the mass is above its height less 1e-7 m for 0.3 ms; steps are up to a hundred times longer.

    It passes that height at 1.4 mm/s: there the rounding of what is between steps of extrapolation, 1e-10 m, counts.
    """
    top, time = 1.0 + 4.0 / (2 * G), 2.0 / G
    sheet = mass(rate=2.0, integration={"method": method, "step": 0.03})
    run = simulate_motion(sheet, stop=[f"slide.position > {top - 1e-7!r}"])
    assert run.times[-1] == pytest.approx(time - np.sqrt(2e-7 / G), abs=1e-7 if method == "extrapolation" else 1e-11)
    assert simulate_motion(sheet, stop=[f"slide.position > {top + 1e-7!r}"]).status == "finished"


@pytest.mark.parametrize("method", METHODS)
def test_jump_of_the_input(method: str) -> None:
    """What jumps beyond a value does so at the knot, exactly, and both sides are reported."""
    signal = {"type": "step", "start": 0.0, "end": 30.0, "time": 0.3217}
    sheet = mass(drives=[{"joint": "slide", "command": "effort", "signal": signal}], integration={"method": method})
    run = simulate_motion(sheet, stop=["slide.effort > 20"])
    assert run.times[-1] == 0.3217
    assert "`slide.effort > 20`, slide.effort jumps from 0 N to 30 N" in run.message
    assert run.effort[-1, 0] == 30.0


def test_the_first_of_several() -> None:
    """Each is looked at; the first that triggers ends the run, whatever their order."""
    early, late = "abs(slide.velocity) > 2 m/s", "tip.z < 0.5"
    for stop in ([early, late], [late, early]):
        run = simulate_motion(mass(), stop=stop)
        assert run.times[-1] == pytest.approx(2.0 / G, abs=1e-13)
        assert early in run.message


@pytest.mark.parametrize(
    ("stop", "time"),
    [("tip.speed > 1", 1 / G), ("tip.velocity.z < -1", 1 / G), ("energy.kinetic > 4 J", 2 / G),
     ("energy.gravity < 10 J", np.sqrt(2 * (1 - 10 / (2 * G)) / G)), ("body.speed > 1", 1 / G)],
)  # fmt: skip
def test_what_can_be_named(stop: str, time: float) -> None:
    """Points, energies and coordinates, each against its closed form."""
    sheet = mass(points=[{"name": "body", "link": "body"}])
    assert simulate_motion(sheet, stop=[stop]).times[-1] == pytest.approx(time, abs=1e-13)


def test_every_name_gives_a_number() -> None:
    """All quantities that a message may offer have values at a state, one for each instant."""
    setup = run_setup(mass())
    outputs = setup.model.outputs
    rows = np.tile(setup.start, (3, 1)), np.tile(setup.first_row, (3, 1))
    values = setup.model.seen([*outputs.values()], np.zeros(3), *rows)
    assert values.shape == (3, len(outputs))
    assert np.isfinite(values).all()


@pytest.mark.parametrize(
    ("limits", "time"),
    [({"lower": 0.5}, np.sqrt(1 / G)), ({"speed": 2.0}, 2 / G), ({"lower": 0.9, "speed": 1.0}, 1 / G)],
)
def test_limits_end_a_run_where_asked(limits: dict[str, float], time: float) -> None:
    """Else they are warned of, as before."""
    run = simulate_motion(mass(limits, integration={"stop_at_limits": True, "method": "dormand_prince"}))
    assert run.status == "stopped_by_condition"
    assert run.times[-1] == pytest.approx(time, abs=2e-9)
    assert "limit of slide: " in run.message
    warned = simulate_motion(mass(limits))
    assert warned.status == "finished"
    assert any("passes its limit" in warning for warning in warned.warnings)


def test_resting_at_a_limit_passes_none() -> None:
    """A joint that is held at its limit and driven within it runs to the end."""
    drives = [{"joint": "slide", "command": "prescribed", "signal": {"type": "quintic", "start": 1.0, "end": 0.5,
               "duration": 0.8}}]  # fmt: skip
    sheet = mass({"upper": 1.0, "lower": 0.5}, drives=drives, initial={"state": "zero"},
                 integration={"stop_at_limits": True})  # fmt: skip
    assert simulate_motion(sheet).status == "finished"


def test_what_holds_at_the_start_is_reported_at_once() -> None:
    """No run, and the value at the start in the message."""
    with pytest.raises(SimulationError, match=r"`tip.z > 0.5 m`: it holds at the start already.* tip.z is 1 m"):
        simulate_motion(mass(), stop=["tip.z > 0.5 m"])
    moving = simulate_motion(mass(), stop=["tip.z < 1"])  # at its limit, and beyond it from the first moment on
    assert moving.times.tolist() == [0.0, moving.times[-1]]
    assert moving.times[-1] < 1e-7


@pytest.mark.parametrize(
    ("stop", "info"),
    [("tip.w < 1", "unknown name 'tip.w'.*Did you mean `tip"), ("slide.positon < 1", "Did you mean `slide.position`"),
     ("tip.z < 1 rad", "'rad' of '1 rad', which is of another dimension.* in m"), ("tip.z <= 1", "write > or <"),
     ("tip.z", "what is compared"), ("tip.z < 1 < 2", "one comparison"), ("tip.z < one", "got the text 'one'"),
     ("tip.z < inf", "infinite"), ("__import__('os').remove('x') < 1", "a name, > or <"), ("", "a name, > or <")],
)  # fmt: skip
def test_what_is_refused(stop: str, info: str) -> None:
    """Which, got, expected, hint; by a closed grammar."""
    with pytest.raises(InputError, match=info) as error:
        simulate_motion(mass(), stop=[stop])
    assert error.value.which == "stop.0"


@pytest.mark.parametrize("method", ["dormand_prince", "rk4", "extrapolation"])
def test_samples_up_to_the_end_are_those_of_the_run_by_itself(method: str) -> None:
    """Looking at a condition changes no bit of the motion."""
    whole = simulate_motion(pendulum(method=method, step=1e-3))
    run = simulate_motion(pendulum(method=method, step=1e-3), stop=["hinge.position < -0.9"])
    assert run.status == "stopped_by_condition"
    assert run.states[:-1].tobytes() == whole.states[: len(run.times) - 1].tobytes()
    never = simulate_motion(pendulum(method=method, step=1e-3), stop=["hinge.position > 1.1"])
    assert never.states.tobytes() == whole.states.tobytes()


class _Memory:
    """A journal in memory."""

    def __init__(self, record: Any = None) -> None:
        self.record, self.records = record, []

    def restore(self) -> Any:
        return self.record

    def keep(self, record: Any, **how: bool) -> None:
        self.records.append({name: value.copy() for name, value in record.items()})


def test_same_bytes_however_it_is_interrupted(monkeypatch: pytest.MonkeyPatch) -> None:
    """Cut into pieces of any length, and continued from any record, the last one included."""
    setup = run_setup(pendulum(method="rk4", step=1e-3))
    stops = run_stops(setup, ("abs(hinge.velocity) > 2.9 rad/s",))
    whole = run_trajectory(setup, stops=stops)
    assert whole.status == "stopped_by_condition"
    monkeypatch.setattr(native_run, "_FIRST_PIECE", 37)
    monkeypatch.setattr(native_run, "_PIECE_SECONDS", 1e-9)
    journal = _Memory()
    pieces = run_trajectory(setup, journal=journal, stops=stops)
    assert (pieces.states.tobytes(), pieces.message) == (whole.states.tobytes(), whole.message)
    for record in (journal.records[3], journal.records[-1]):
        again = run_trajectory(setup, journal=_Memory(record), stops=stops)
        assert again.states.tobytes() == whole.states.tobytes()
        assert again.times.tobytes() == whole.times.tobytes()
        assert again.message == whole.message


def test_reference_is_compared_at_the_same_times() -> None:
    """The reference of the nominal arm has a sample where the real one ended."""
    sheet = mass().with_({"real": {"links.body.bodies.load.mass": 1.5}})
    run = simulate_motion(sheet, stop=["tip.z < 0.25"])
    assert run.reference is not None
    assert run.reference.times.tobytes() == run.times.tobytes()
    assert run.reference.q[-1, 0] == pytest.approx(0.25, abs=1e-12)


STIFFNESS, SPEED = 5e4, 0.8


def meeting(**integration: Any) -> Robot:
    """2 kg that slide along x at 0.8 m/s, without gravity, and meet a springy wall at 0.1 m."""
    wall = {"type": "plane", "position": [0.1, 0, 0], "normal": [-1, 0, 0]}
    return arm(
        gravity=0.0, joints=[{"name": "slide", "type": "prismatic", "parent": "base", "child": "block",
                              "axis": [1, 0, 0]}],
        links=[{"name": "block", "bodies": [{"name": "load", "mass": 2.0}]}], tip={"link": "block"},
        drives=[{"joint": "slide", "command": "effort", "signal": {"type": "constant", "value": 0.0}}],
        initial={"state": "zero", "rates": {"slide": SPEED}},
        contact={"point": "tip", "shape": wall, "law": "unilateral", "stiffness": STIFFNESS, "damping": 0.0},
        integration={"duration": 0.2, "output_step": 0.01, "relative_tolerance": 1e-10, "absolute_tolerance": 1e-12,
                     **integration},
    )  # fmt: skip


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "extrapolation", "rosenbrock"])
def test_contact_is_made_and_broken_where_it_is(method: str) -> None:
    """The wall is met at 0.1 m over the speed, pushes as a sine, and is left half a swing later, at the same speed."""
    omega, met = np.sqrt(STIFFNESS / 2.0), 0.1 / SPEED
    sheet = meeting(method=method)
    made = simulate_motion(sheet, stop=["contact.penetration > 0"])
    assert made.times[-1] == pytest.approx(met, abs=1e-9)
    force = float(0.6 * STIFFNESS * SPEED / omega)
    pressed = simulate_motion(sheet, stop=[f"contact.force > {force!r} N"])
    assert pressed.times[-1] == pytest.approx(met + np.arcsin(0.6) / omega, abs=2e-9)
    run = simulate_motion(sheet)
    assert run.statistics["contact_changes"] == 2
    left = run.times[-1] - (0.1 - run.q[-1, 0]) / SPEED  # it flies back from the wall at its speed
    assert left == pytest.approx(met + np.pi / omega, abs=5e-9)


@pytest.mark.parametrize("method", ["dormand_prince", "dop853", "rk4"])
def test_next_to_a_controller_in_python(method: str) -> None:
    """The mass is pushed up by half its weight: z = 1 - g t^2/4 passes a height at a known time, its last sample."""
    sheet = mass(integration={"method": method})
    half = simulate_motion(sheet, controller=lambda time, q, v: [G], stop=["tip.z < 0.75 m"])
    assert half.status == "stopped_by_condition"
    assert half.times[-1] == pytest.approx(np.sqrt(1 / G), abs=1e-12)
    assert half.q[-1, 0] == pytest.approx(0.75, abs=1e-12)
    assert "`tip.z < 0.75 m`, tip.z reaches 0.75 m" in half.message
    assert len(half.times) == 33
    with pytest.raises(SimulationError, match="holds at the start already"):
        simulate_motion(sheet, controller=lambda time, q, v: [G], stop=["tip.z < 2 m"])
    pushed = simulate_motion(
        sheet, controller=lambda time, q, v: [G if time < 0.1 else 50.0], stop=["slide.effort > 20 N"]
    )
    assert pushed.times[-1] == pytest.approx(0.1, abs=1e-12)
