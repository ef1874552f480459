"""What every controller keeps, those of a user's script among them: one of them, an LQR, is defined here."""

from __future__ import annotations

from typing import Any, ClassVar, Literal

import numpy as np
import pytest
from pydantic import Field
from scipy.linalg import solve_continuous_are

from lane_runs import simulate_lanes
from simulation.sheets import ZERO, arm, beam, pendulum
from tmodes import simulate_batch
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.controllers.registry import CONTROLLERS, Controller, Measured
from tmodes.kinds.kernel import vectors
from tmodes.model.model import Model
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.problem import problem_of
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.solve import solve


@CONTROLLERS.register
class LQR(Controller):
    """Feedback of the whole state, and of the integral of the own error."""

    sees_all: ClassVar[bool] = True

    type: Literal["own_lqr"] = Field(description="kind of controller")
    row: tuple[float, ...] = Field(strict=False, description="row of K, of (q, v, integral)")

    def numbers(self) -> tuple[float, ...]:
        return self.row

    def initial(self) -> tuple[float, ...]:
        return (0.0,)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        reference = [m.setpoints[0][0]] * 2 + [0.0] * (len(m.q) - 2)
        error = [s - r for s, r in zip([*m.q, *m.v, *x], [*reference, *[0.0] * len(m.v), 0.0], strict=True)]
        return -vectors.total([p[k] * e for k, e in enumerate(error)])

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        return [m.position - m.wanted]


def robot(controller, **more):
    """An elastic joint that carries a beam with a load: four coordinates."""
    joint = {"name": "hub", "type": "revolute", "parent": "base", "child": "beam", "axis": [0, 0, 1],
             "motor": {"inertia": 0.2, "side": "joint"}, "gear": {"stiffness": 300.0, "damping": 0.5}}  # fmt: skip
    link = {"name": "beam", "beam": beam({"bend_z": 2}, 1.0, 40.0, 0.5, damping_time=1e-4),
            "bodies": [{"name": "load", "mass": 0.3, "center": [0, 0, 0], "at": 1.0}]}  # fmt: skip
    signal = {"type": "step", "start": 0.0, "end": 0.3, "time": 0.1}
    drive = {"joint": "hub", "command": "position", "signal": signal, "controller": controller} | more.pop("drive", {})
    settings = {"duration": 0.6, "output_step": 0.01, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-10}
    return arm(gravity=0.0, joints=[joint], links=[link], drives=[drive],
               integration=settings | more.pop("integration", {}), **more)  # fmt: skip


def gains(sheet: Any = None) -> list[float]:
    """The gains of least cost: a Riccati equation of the linearised robot, whose first coordinate is driven."""
    model = Model((sheet or robot({"type": "pd", "position_gain": 0.0, "velocity_gain": 0.0})).chain())
    n = model.nq
    mass, damping, stiffness = model.linearize(np.zeros(n))
    a, b = np.zeros((2 * n + 1, 2 * n + 1)), np.zeros((2 * n + 1, 1))
    a[:n, n : 2 * n], a[2 * n, 0] = np.eye(n), 1.0
    a[n : 2 * n, :n], a[n : 2 * n, n : 2 * n] = -np.linalg.solve(mass, stiffness), -np.linalg.solve(mass, damping)
    b[n : 2 * n, 0] = np.linalg.solve(mass, np.eye(n)[:, 0])
    weight = np.diag([100.0] * n + [1.0] * n + [200.0])
    return (b.T @ solve_continuous_are(a, b, weight, np.eye(1)))[0].tolist()


@pytest.fixture(scope="module")
def lqr():
    return {"type": "own_lqr", "row": gains()}


AT_THE_ROBOT = {"gravity_pd", "computed_torque", "feedback_linearisation", "lqr", "lqg", "pole_placement",
                "loop_shaping", "notch", "low_pass", "lead_lag", "disturbance_observer",
                "passivity_based", "singular_perturbation", "impedance", "force",
                "feed_forward"}  # fmt: skip
"""Members that compute with the robot: see test_blocks.py."""
PD = {"type": "pd", "position_gain": 80.0, "velocity_gain": 9.0}


def examples(lqr):
    """One of each member; a member without an example fails."""
    return {
        "pd": PD,
        "pid": {"type": "pid", "position_gain": 80.0, "integral_gain": 50.0, "velocity_gain": 9.0, "limit": 15.0},
        "state_feedback": {"type": "state_feedback", "position_gains": {"hub.motor": 80.0, "beam.bend_z1": 2.0},
                           "velocity_gains": {"hub.motor": 9.0, "hub": 1.0}},
        "sampled_pid": {"type": "sampled_pid", "position_gain": 80.0, "integral_gain": 50.0, "velocity_gain": 9.0,
                        "sample_time": 0.004},
        "own_lqr": lqr,
    }  # fmt: skip


OF_A_DRIVE = [name for name in sorted(CONTROLLERS) if name not in AT_THE_ROBOT]


@pytest.mark.parametrize("name", OF_A_DRIVE)
def test_member(name, lqr):
    """Runs natively as written, in a batch, by explicit and implicit methods; other numbers take the same code."""
    sheet = robot(examples(lqr)[name])
    setup = run_setup(sheet)
    model, law = setup.model, sheet.drives[0].controller
    assert law is not None
    rng = np.random.default_rng(4)
    state = 0.2 * rng.standard_normal(model.layout.size)
    row = setup.planned.schedule.rows_at([0.3])[0]
    q, v, x = (state[part] for part in (model.layout.q, model.layout.v, model.layout.controls))
    seen = Measured(0.3, 0.0, 0.0, q[0], v[0], 0.0, [*q], [*v], model.coordinates, [], [[0.3, 0.0, 0.0]], ("hub",))
    if law.period is None:
        wanted = float(law.command(law.numbers(), seen, [*x]))
        rates = law.rates(law.numbers(), seen, [*x])
    else:  # 0.3 s is a sample of it
        wanted, rates = float(law.command(law.numbers(), seen, [*x[1:]])), [0.0] * len(x)
    assert model.observe([0.3], state, row)["drives"][0, 0, 0] == pytest.approx(wanted, rel=1e-12)
    assert model.rate([0.3], state, row)[0][model.layout.controls] == pytest.approx(rates, rel=1e-12)
    assert len(model.plan.control_names) == len(model.plan.control_units) == len(x)
    run = simulate_motion(sheet)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    assert run.q[-1, 0] == pytest.approx(0.3, abs=0.15)
    for method in ("extrapolation", "rosenbrock"):
        other = simulate_motion(sheet.with_({"integration.method": method}))
        assert np.abs(other.q - run.q).max() < 1e-6, method
    numbers = np.array([model.numbers, model.numbers * 1.001])
    settings = sheet.integration.model_copy(update={"method": "dormand_prince"})
    batch = simulate_lanes(model, numbers, setup.planned.schedule, setup.start, settings)
    single = solve(problem_of(model, model.numbers, setup.planned.schedule, setup.start, settings))
    # A limit that is met a rounding earlier or later lets the step control take other steps.
    assert np.abs(batch.states[0] - single.states).max() < 1e-9 * np.abs(single.states).max()
    longer = type(law).of(law.model_dump() | {key: _more(value) for key, value in law.model_dump().items()})
    assert longer.structure == law.structure


def _more(value: Any) -> Any:
    if isinstance(value, float):
        return 1.1 * value
    return {key: 1.1 * item for key, item in value.items()} if isinstance(value, dict) else value


def test_lqr_settles_faster_than_pd(lqr):
    last = {
        name: simulate_motion(robot(law, integration={"duration": 2.0})) for name, law in (("lqr", lqr), ("pd", PD))
    }
    swing = {name: np.abs(run.q[-60:, 2]).max() for name, run in last.items()}
    assert swing["lqr"] < 0.3 * swing["pd"]
    assert last["lqr"].q[-1, 1] == pytest.approx(0.3, abs=0.03)


def test_derivative_by_a_number_under_full_feedback(lqr):
    """Of the final state by the load's mass: against central differences."""
    sheet, path = robot(lqr, integration={"duration": 0.3, "method": "dormand_prince"}), "links.beam.bodies.load.mass"
    slope = forward_sensitivities(sheet, [path]).by[path][-1]
    ends = [simulate_motion(sheet.with_({path: 0.3 + step})).q[-1] for step in (1e-4, -1e-4)]
    assert slope[:4] == pytest.approx((ends[0] - ends[1]) / 2e-4, rel=1e-5, abs=1e-7)


def test_noise_is_seen_by_the_controller_alone():
    """With the noise's own signal as command the effort is the same; the wanted value on show is without it."""
    noise = {"type": "noise", "deviation": 0.01, "frequency": 50.0, "seed": 2}
    quiet = {"type": "constant", "value": 0.0}
    run = simulate_motion(robot(PD, drive={"signal": quiet, "noise": noise}))
    same = simulate_motion(robot(PD, drive={"signal": noise}))
    assert np.abs(run.q - same.q).max() < 1e-12
    assert np.abs(run.q).max() > 1e-4
    assert np.abs(run.wanted).max() == 0.0


def test_unknown_coordinate_is_named():
    law = {"type": "state_feedback", "position_gains": {"hub.motr": 1.0}}
    with pytest.raises(Exception, match=r"hub\.motr"):
        simulate_motion(robot(law))


def test_no_controller_without_a_wanted_position():
    with pytest.raises(Exception, match="controller"):
        robot(PD, drive={"command": "torque", "signal": ZERO})


@pytest.mark.parametrize("method", ["dormand_prince", "extrapolation"])
@pytest.mark.parametrize("electric", [{}, {"resistance": 0.5, "back_emf_constant": 0.3, "torque_constant": 0.4}])
def test_an_offset_of_a_pd_is_one_of_its_setpoint(method: str, electric: dict) -> None:
    """Kp (w - th) + u0 = Kp (w + u0/Kp - th): the same motion, alone and in a batch; its slopes stay the gains."""
    gains, offset = {"type": "pd", "position_gain": 90.0, "velocity_gain": 7.0}, 12.5
    motor = {"inertia": 0.3, **electric}
    start = {"state": "zero", "coordinates": {"joint": 0.2, "joint.motor": 0.2}}

    def moved(controller: dict, value: float) -> Any:
        drive = {"command": "position", "controller": controller, "signal": {"type": "constant", "value": value}}
        return pendulum(motor, {"stiffness": 200.0, "damping": 1.0}, drive, initial=start,
                        integration={"duration": 0.5, "output_step": 0.1, "method": method})  # fmt: skip

    one, other = moved({**gains, "offset": offset}, 0.2), moved(gains, 0.2 + offset / 90.0)
    first, second = (run_trajectory(run_setup(robot)) for robot in (one, other))
    started = first.states[:, :4] - second.states[:, :4]
    assert np.abs(started).max() < 1e-7 * np.abs(first.states[:, :4]).max()
    if method == "dormand_prince":
        batch = simulate_batch(one, {"drives.0.controller.offset": [offset, 0.0]})
        np.testing.assert_allclose(batch.states[0], first.states, rtol=0, atol=1e-9)
        assert np.abs(batch.states[1] - first.states).max() > 1e-2
    assert one.drives[0].controller.local_gains() == pytest.approx((90.0, 7.0))


@pytest.mark.parametrize(
    ("error", "integral", "rate"), [(1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (-0.1, 1.0, -0.1), (0.1, 0.0, 0.1)]
)
def test_a_limited_pid_does_not_wind_up(error: float, integral: float, rate: float) -> None:
    """Beyond its limit the integral stops where it would drive the command further, and goes back where it helps."""
    sheet = {"type": "pid", "position_gain": 10.0, "integral_gain": 20.0, "velocity_gain": 0.0, "limit": 5.0}
    law = Controller.of(sheet)
    measured = Measured(position=0.0, velocity=0.0, wanted=error, wanted_rate=0.0, wanted_acceleration=0.0, current=0.0)
    found = law.rates(law.numbers(), measured, [integral])[0]
    assert float(found) == pytest.approx(rate)
