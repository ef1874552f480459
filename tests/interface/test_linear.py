"""Linear models: exact matrices, poles, zeros, responses; sampled with delays; closed loops; fewer states.

Numbers are "reference values computed with" closed forms and python-control, and those of the beam with the roots of
its partial differential equation.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from numpy.typing import ArrayLike
from scipy.io import loadmat
from scipy.linalg import block_diag, expm, solve_continuous_lyapunov

import tmodes
from command import tmodes as command
from contracts.test_blocks import LQR, PD, constant, law, spong
from random_sheets import random_sheet
from tmodes.analysis.margins import loop_margins, response, step_duration, step_values
from tmodes.errors import InputError
from tmodes.interface import linear_words
from tmodes.io.printed import Table
from tmodes.io.sheet_check import sheet_data
from tmodes.kinds.controllers.discrete import zero_order_hold
from tmodes.plot.commands import bode_curves

SAGGED = 1.5707963267949
STATES = ("joint", "joint.motor", "joint'", "joint.motor'")
FREE = {"drive": {"command": "torque"}}


def robot(of: Any) -> Any:
    return tmodes.Robot.from_data(of.model_dump(mode="json", by_alias=True, exclude_none=True))


def joint(**more: Any) -> Any:
    return robot(spong(constant(0.0), 1.0, 0.1, initial={}, **(more or FREE)))


def near(found: ArrayLike, wanted: ArrayLike, share: float = 1e-8) -> bool:
    """Whether each that is wanted is among those found."""
    values = np.asarray(found, dtype=complex)
    return all(np.abs(values - one).min() <= share * abs(one) for one in np.asarray(wanted, dtype=complex))


def order(linear: Any) -> list[int]:
    return [linear.states.index(name) for name in STATES]


def sagged(**more: Any) -> Any:
    return joint().linearize(
        at={"joint.motor": SAGGED}, inputs="joint.torque", outputs="joint.position,joint.motor.position", **more
    )


def test_an_elastic_joint_that_sags() -> None:
    """Motor at a right angle: the link sags through its gear, and all is exact."""
    linear, at = sagged(), order(sagged())
    truth = np.array([[0, 0, 1, 0], [0, 0, 0, 1],
                      [-223.52716657826952, 222.89156626506025, -0.42168674698795183, 0.42168674698795183],
                      [880.952380952381, -880.952380952381, 1.6666666666666667, -2.238095238095238]])  # fmt: skip
    assert linear.A[np.ix_(at, at)] == pytest.approx(truth, rel=1e-10, abs=1e-9)
    assert linear.system.u0 == pytest.approx([9.8743976800516], rel=1e-10)
    assert near(linear.poles, [-0.057748155666241 + 0.70985097507682j, -1.2721428368754 + 33.200919943912j])
    assert near(linear.zeros("joint.position"), [-528.57142857143])
    assert near(linear.zeros("joint.motor.position"), [-0.21084337349398 + 14.949338167629j])
    response = linear.frequency_response(np.array([0.5, 20.0]) / (2 * np.pi)).values[:, :, 0]
    assert near(response[0], [3.5591714845209 - 0.79982803825783j, 3.5653275033038 - 0.80121755650216j])
    assert near(response[1], [-0.0037656235529364 + 0.00010758190141381j, 0.0029644769359669 - 0.0003398296664068j])
    assert len(linear.zeros("joint.position")) == 1


def test_a_motor_with_an_inductance() -> None:
    data = json.loads(joint().model_dump_json(by_alias=True, exclude_none=True))
    data["joints"][0]["motor"] |= {"resistance": 0.62, "inductance": 0.0011, "torque_constant": 0.052 * 80,
                                   "back_emf_constant": 0.052 * 80}  # fmt: skip
    data["drives"][0]["command"] = "voltage"
    linear = tmodes.Robot.from_data(data).linearize(inputs="joint.voltage", outputs="joint.position,joint.current")
    poles = [-0.33855676813509, -3.4202978472272 + 15.058452419497j, -209.72623612544, -349.39075703342]
    assert near(linear.poles, poles)
    assert near(
        linear.zeros("joint.current"), [-0.05871821864875 + 3.0796669898621j, -1.2711727738928 + 33.235470533391j]
    )


def slewing(functions: int = 8) -> Any:
    """A hub with a beam: no gravity, no damping."""
    beam = {"model": "strain", "functions": {"bend_z": functions}, "length": 0.9, "damping_time": 0.0,
            "section": {"bending_stiffness": 5.2, "mass_per_length": 0.31}}  # fmt: skip
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "hub", "gravity": [0, 0, 0],
        "joints": [{"name": "hub", "type": "revolute", "child": "arm", "axis": [0, 0, 1],
                    "motor": {"inertia": 0.04, "side": "joint"}}],
        "links": [{"name": "arm", "beam": beam,
                   "bodies": [{"name": "tip", "mass": 0.11, "center": [0, 0, 0], "at": 1.0}]}],
        "tip": {"link": "arm"}, "drives": [{"joint": "hub", "command": "torque", "signal": constant(0.0)}],
        "integration": {"duration": 1.0, "output_step": 0.01},
    })  # fmt: skip


def test_a_slewing_beam_against_its_differential_equation() -> None:
    """Poles, zeros at the hub, and the real pairs at the tip: it is not minimum phase."""
    linear = slewing().linearize(inputs="hub.torque", outputs="hub.position,tip.y,arm.moment.z@0")
    assert near(linear.poles, 1j * np.array([23.84558610005, 90.23974850604, 264.4664987427]), 1e-5)
    assert near(linear.zeros("hub.position"), 1j * np.array([11.01144152098, 86.94457713576]), 1e-5)
    assert near(linear.zeros("tip.y"), [56.56340874302, -56.56340874302, 305.6640018541], 1e-3)
    low = linear.frequency_response([1e-3]).sel(output="arm.moment.z@0").values[0, 0]
    assert abs(low) == pytest.approx(0.80433400185883, rel=1e-6)
    assert any("non-minimum" in str(part) for part in linear.tables())


@pytest.mark.parametrize(("delay", "late"), [(0.0, 0), (1e-3, 1), (2.5e-3, 2.5)])
def test_a_hold_with_delay(delay: float, late: float) -> None:
    """The response to a pulse of the sampled system is that of the exact one, sample by sample."""
    linear, exact, period = sagged(period=1e-3, delay=delay), sagged(), 1e-3
    n = len(exact.A)
    half = expm(np.block([[exact.A, exact.B], [np.zeros((1, n + 1))]]) * period / 2)
    x, y = np.zeros(n), np.zeros(len(linear.A))
    for k in range(12):
        assert linear.C @ y == pytest.approx(exact.C @ x, abs=1e-16)
        y = linear.A @ y + linear.B[:, 0] * (k == 0)
        for part in (0.0, 0.5):
            push = float(late <= k + part < late + 1)
            x = (half @ np.append(x, push))[:n]
    if delay == 1e-3:
        K = np.zeros((1, len(linear.A)))
        K[0, order(linear)] = [0.0, 60.0, 0.0, 6.0]
        wanted = [0.029307726756689, 0.9855751880709 + 0.032569824940595j, 0.9978912168421 + 0.0069126807294334j]
        assert near(np.linalg.eigvals(linear.A - linear.B @ K), wanted)


def test_a_sampled_loop_that_takes_differences() -> None:
    law_of = PD | {"type": "sampled_pid", "velocity_gain": 6.0, "sample_time": 1e-3, "filter_time": 0.0}
    at = constant(SAGGED + 9.8743976800516 / 60)
    linear = robot(spong(at, 1.0, 0.1, initial={}, drive={"controller": law_of})).linearize(
        closed=True, inputs="joint.setpoint", outputs="joint.position"
    )
    wanted = [0.014720748676817, 0.98568131989532 + 0.032337191421252j, 0.99787019603495 + 0.0069043119189425j]
    assert near(linear.poles, wanted)
    assert linear.period == pytest.approx(1e-3)


@pytest.mark.parametrize("more", [{}, {"sample_time": 0.01}])
def test_setpoints_that_stand_have_rates_too(more: dict[str, float]) -> None:
    """As those of a move do."""
    signals = constant(0.0), {"type": "quintic", "start": 0.0, "end": 1.0, "duration": 0.5}
    still, moving = (
        robot(spong(one, 1.0, 0.1, initial={}, drive={"controller": PD, **more})).linearize(
            closed=True, inputs="joint.setpoint,joint.setpoint_rate", outputs="joint.position"
        )
        for one in signals
    )
    assert pytest.approx(moving.A, rel=1e-12) == still.A
    assert pytest.approx(moving.B, rel=1e-12) == still.B
    assert still.B[:, 1].any()


@pytest.mark.parametrize("filter_time", [0.0, 2e-3])
def test_a_sampled_loop_that_takes_differences_about_a_start_in_balance(filter_time: float) -> None:
    """Where nothing was measured yet. Ahead of each sample: states, u before it, z, r and the position before it."""
    T, K, R, gains = 1e-3, 60.0, 6.0, {"type": "sampled_pid", "sample_time": 1e-3, "integral_gain": 20.0}
    law_of = PD | gains | {"position_gain": K, "velocity_gain": R, "filter_time": filter_time}
    made = robot(spong(constant(0.0), 1.0, 0.1, initial={}, drive={"controller": law_of}))
    linear = made.linearize(closed=True, inputs="joint.setpoint", outputs="joint.position")
    free = joint().linearize(inputs="joint.torque", outputs="joint.motor.position")
    whole = expm(np.vstack([np.hstack([free.A, free.B]), np.zeros((1, 5))]) * T)
    A, B, C, share = whole[:4, :4], whole[:4, 4:], free.C, filter_time + T
    rate = np.hstack([C / share, np.array([[0.0, filter_time, -1.0]]) / share])  # of x, z, r, last
    command = np.hstack([-K * C, np.array([[20.0, 0.0, 0.0]])]) - R * rate
    none = np.zeros((1, 3))
    loop = np.vstack([np.hstack([A, np.zeros((4, 3))]) + B @ command,
                      np.hstack([-T * C, [[1.0, 0.0, 0.0]]]), rate, np.hstack([C, none])])  # fmt: skip
    wanted = np.linalg.eigvals(loop)
    assert near(linear.poles, wanted[np.abs(wanted) > 1e-6])
    assert linear.is_stable
    assert not any("unstable" in text for text in made.run().warnings)


@pytest.mark.parametrize("more", [{}, {"delay": 0.013}])
def test_a_closed_loop_under_a_sampled_law(more: dict[str, Any]) -> None:
    """A small step of the setpoint, sample by sample, against the run of the robot itself."""
    push, period = 1e-5, 0.01
    control = law(LQR | {"sample_time": period}, **more)
    made = robot(spong(constant(0.4), 0.5, period, initial={}, control=control))
    linear = made.linearize(closed=True, inputs="joint.setpoint", outputs="joint.position,joint.velocity")
    assert linear.is_stable
    start = dict(zip(linear.states, linear.system.x0, strict=True))
    runs = []
    for size in (0.0, push):  # the law is designed where its setpoint ends: both runs have the same end
        steps = [{"type": "constant", "value": 0.4}, {"type": "step", "start": size, "end": 0.0, "time": 0.4}]
        data = json.loads(made.model_dump_json(by_alias=True, exclude_none=True))
        data["drives"][0]["signal"] = {"type": "sum", "signals": steps}
        data["initial"] = {"state": "zero", "coordinates": {one: start[one] for one in ("joint", "joint.motor")}}
        runs.append(np.asarray(tmodes.Robot.from_data(data).run().output("joint.position")))
    x, found = np.zeros(len(linear.A)), []
    for _ in range(40):
        found.append((linear.C @ x)[0])
        x = linear.A @ x + linear.B[:, 0] * push
    assert (runs[1] - runs[0])[:40] == pytest.approx(found, abs=2e-3 * push)


@pytest.mark.parametrize("seed", range(12))
def test_both_statements_of_a_random_robot_agree(seed: int) -> None:
    """A of the right-hand side of a run is that of M, D, K."""
    made = tmodes.Robot.from_data(random_sheet(seed, seed))
    if any(drive.command == "prescribed" for drive in made.drives):
        pytest.skip("M, D, K are about a motion at constant speed, A about rest")
    try:
        linear = made.linearize(contact=False)
        A = linear.A
    except tmodes.TmodesError:
        pytest.skip("no rest of this robot")
    n = len(linear.coordinates)
    if linear.states[2 * n :]:
        pytest.skip("currents")
    free = np.flatnonzero(A[np.arange(n), n + np.arange(n)])  # joints without a drive are held, as in a run
    inner = np.ix_(free, free)
    pull = np.linalg.solve(linear.mass[inner], np.hstack([linear.stiffness[inner], linear.damping[inner]]))
    own = A[np.ix_(n + free, np.append(free, n + free))]
    assert np.abs(own + pull).max() < 1e-8 * np.abs(pull).max()


def test_fewer_states() -> None:
    """The bound of balanced truncation holds; modal truncation keeps the slowest poles and the static gain."""
    damped = json.loads(slewing(4).model_dump_json(by_alias=True, exclude_none=True))
    damped["links"][0]["beam"]["damping_time"] = 1e-3
    damped["drives"][0] = {"joint": "hub", "command": "position", "signal": constant(0.0), "controller": PD}
    linear = tmodes.Robot.from_data(damped).linearize(closed=True, inputs="hub.setpoint", outputs="hub.position,tip.y")
    reach = solve_continuous_lyapunov(linear.A, -linear.B @ linear.B.T)
    see = solve_continuous_lyapunov(linear.A.T, -linear.C.T @ linear.C)
    sizes = np.sqrt(np.sort(np.abs(np.linalg.eigvals(reach @ see)))[::-1])
    at = linear.frequencies()
    full = linear.frequency_response(at).values
    small = linear.reduce(4)
    error = np.linalg.norm(small.frequency_response(at).values - full, axis=(1, 2)).max()
    assert len(small.A) == 4
    assert small.error is not None
    assert 0 < error <= small.error <= 2 * sizes[4:].sum() * (1 + 1e-6)
    slow = linear.reduce(4, "modal")
    assert near(slow.poles, linear.poles[: len(slow.A)])
    static = [one.frequency_response([0.0]).values for one in (slow, linear)]
    assert static[0] == pytest.approx(static[1], rel=1e-8)


@pytest.mark.parametrize("seed", range(20))
def test_an_error_that_is_printed_holds(seed: int) -> None:
    """Random stable models of three inputs and two outputs, sampled and not, against sweeps and optimization."""
    dice, period = np.random.default_rng(seed), 0.1 if seed % 2 else None
    n = int(dice.integers(4, 12))
    A = dice.standard_normal((n, n)) * np.exp(dice.uniform(-3, 3, n))
    poles = np.linalg.eigvals(A)
    A = A - (poles.real.max() + 10 ** dice.uniform(-3, 0)) * np.eye(n)
    A = expm(A * period) if period else A
    B, C, D = dice.standard_normal((n, 3)), dice.standard_normal((2, n)), dice.standard_normal((2, 3))
    names = {"states": tuple(f"x{k}" for k in range(n)), "inputs": ("a", "b", "c"), "outputs": ("y", "z")}
    zero = {key: np.zeros(size) for key, size in (("x0", n), ("rate", n), ("u0", 3), ("y0", 2))}
    system = replace(sagged().system, A=A, B=B, C=C, D=D, period=period, **names, **zero)
    linear = replace(sagged(), made=lambda: system)
    at = np.unique(np.append(linear.frequencies(), np.geomspace(1e-6, 5.0 if period else 1e4, 3000)))
    full = linear.frequency_response(at).values
    for method in ("modal", "balanced"):
        small = linear.reduce(n // 2, method)
        error = np.linalg.norm(small.frequency_response(at).values - full, 2, axis=(1, 2)).max()
        assert small.error is not None
        assert error <= small.error * (1 + 1e-9), method
        assert error > 0.98 * small.error, method
        assert f"differ by {small.error:.3g} at most" in str([*small.tables()][1])


@pytest.mark.parametrize("seed", range(8))
def test_a_minimal_model_is_the_part_that_takes_part(seed: int) -> None:
    """Mixed up with what no input reaches and no output shows; integrators in a row and unstable poles on all sides."""
    dice = np.random.default_rng(seed)
    jordan = np.array([[0.0, 1.0], [0.0, 0.0]])
    own: Any = block_diag(jordan, 3.0 * dice.standard_normal((4, 4)))
    lost: list[Any] = [block_diag(jordan, dice.standard_normal((2, 2))) for _ in range(3)]
    A: Any = block_diag(own, *lost)
    B, C = dice.standard_normal((len(A), 2)), dice.standard_normal((1, len(A)))
    A[:6, 6:10], A[10:14, :6] = dice.standard_normal((6, 4)), dice.standard_normal((4, 6))
    B[6:10], C[:, 10:14] = 0.0, 0.0  # drives what takes part, is driven by it
    B[14:], C[:, 14:] = 0.0, 0.0
    mix = dice.standard_normal((len(A), len(A)))
    system = replace(
        sagged().system, A=mix @ A @ np.linalg.inv(mix), B=mix @ B, C=C @ np.linalg.inv(mix), D=np.zeros((1, 2)),
        states=tuple(f"x{k}" for k in range(len(A))), inputs=("a", "b"), outputs=("y",),
    )  # fmt: skip
    linear = replace(sagged(), made=lambda: system)
    small = linear.reduce(method="minimal")
    assert len(small.A) == 6
    plain = replace(system, A=own, B=B[:6], C=C[:, :6])
    at = np.geomspace(0.01, 100, 50)
    wanted = replace(linear, made=lambda: plain).frequency_response(at).values
    assert small.frequency_response(at).values == pytest.approx(wanted, rel=1e-5)


def test_a_motor_without_a_spring_and_a_bending_that_nothing_reaches() -> None:
    """Free motors are integrators; the arm that bends in its plane is that part of one that bends on all sides."""
    spatial = tmodes.load("two_link_arm").with_(
        {"gravity": 0.0, "planar": False, "links.forearm.beam.functions": {"bend_y": 2, "bend_z": 1}}
    )
    linear = spatial.linearize(inputs="elbow.torque", outputs="tip.z")
    small, at = linear.reduce(method="minimal"), [0.1, 1.0, 10.0, 100.0]
    assert len(small.A) == len(linear.A) - 3  # bending out of the plane, and what torque between two arms can not move
    assert small.frequency_response(at).values == pytest.approx(linear.frequency_response(at).values, rel=1e-6)
    assert small.error is None
    said = command("linear", "spong1987", "--reduce", 2, "--method", "modal").stdout.replace("\u00a0", " ")
    assert "Reduced from 4 to 2 states, modal: responses differ by" in said
    data = json.loads(command("linear", "spong1987", "--method", "minimal", "--json").stdout)
    assert data["error"] is None
    assert len(data["states"]) == 4
    with pytest.raises(InputError, match="minimal"):
        linear.reduce(3, "minimal")


def test_a_response_is_exact_where_it_is_small() -> None:
    """Of a chain of masses from one end to the other: the product of its springs over a determinant by recursion."""
    masses = np.array([2.0, 1e-3, 5.0, 0.3])
    springs, dampers = np.array([5e3, 20.0, 8e4, 0.0]), np.array([1.0, 0.2, 3.0, 0.0])
    apart = np.eye(4) - np.eye(4, k=-1)
    stiff, damp = (apart.T @ np.diag(one[::-1]) @ apart for one in (springs, dampers))
    A = np.block([[np.zeros((4, 4)), np.eye(4)], [-stiff / masses[:, None], -damp / masses[:, None]]])
    B, C = np.eye(8)[:, 7:] / masses[3], np.eye(8)[:1]
    at = (1j * np.geomspace(1e2, 1e5, 30)).astype(np.complex128)
    found = response(A, B, C, np.zeros((1, 1)))(at)[:, 0, 0]
    link = springs[::-1, None] + dampers[::-1, None] * at
    diagonal = masses[:, None] * at**2 + link + np.vstack([link[1:], 0 * link[:1]])
    before, whole = np.ones_like(at), diagonal[0]
    for k in range(1, 4):
        before, whole = whole, diagonal[k] * whole - link[k] ** 2 * before
    assert np.abs(found / (link[1:].prod(axis=0) / whole) - 1).max() < 1e-11


def test_a_response_at_a_pole_is_large() -> None:
    found = response(np.zeros((1, 1)), np.eye(1), np.eye(1), np.zeros((1, 1)))(np.array([0, 2j]))[:, 0, 0]
    assert abs(found[0]) > 1e15
    assert found[1] == pytest.approx(-0.5j)


def test_margins_of_a_double_integrator_with_lead() -> None:
    """k (s + 1)/s^2: phase margin in closed form, no gain margin; a delay that eats the phase."""
    double = np.array([[0.0, 1.0], [0.0, 0.0]]), np.array([[0.0], [1.0]]), np.array([[2.0, 2.0]]), np.zeros((1, 1))
    found = loop_margins(*double, None)
    crossing = np.sqrt(2 + np.sqrt(8))
    assert 2 * np.pi * found.phase_frequency == pytest.approx(crossing, rel=1e-8)
    assert found.phase == pytest.approx(np.arctan(crossing), rel=1e-8)
    assert found.delay == pytest.approx(np.arctan(crossing) / crossing, rel=1e-8)
    assert np.isinf(found.gain)
    assert 0 < found.disk < 2


def test_other_tools_read_it(tmp_path: Path) -> None:
    linear = sagged()
    plain = linear.to_scipy()
    assert np.array_equal(plain.A, linear.A)
    linear.save(tmp_path / "a.mat")
    assert np.array_equal(loadmat(tmp_path / "a.mat")["A"], linear.A)
    linear.save(tmp_path / "a.json")
    assert json.loads((tmp_path / "a.json").read_text())["A"] == linear.A.tolist()
    with pytest.raises(InputError):
        linear.save(tmp_path / "a.txt")
    control = pytest.importorskip("control")
    assert control.poles(linear.to_control()) == pytest.approx(np.linalg.eigvals(linear.A))


@pytest.mark.parametrize(
    ("how", "which"),
    [
        ({"inputs": "elbow.torque"}, "inputs"), ({"outputs": "tip.q"}, "outputs"),
        ({"inputs": "joint.setpoint"}, "inputs"), ({"period": -1.0}, "period"), ({"delay": 0.1}, "period"),
        ({"period": 1e-3, "delay": 0.6}, "delay"), ({"inputs": "joint.torque,joint.torque"}, "inputs"),
        ({"outputs": ["tip.x", "tip.x"]}, "outputs"),
        ({"closed": True, "at": {"joint": 0.1}}, "at"), ({"at": {"joint": 0.1, "joint.motor": 0.2}}, "--at"),
        ({"at": "joint=0.1,joint=0.2"}, "--at"),
    ],
)  # fmt: skip
def test_what_there_is_not(how: dict[str, Any], which: str) -> None:
    with pytest.raises(InputError) as caught:
        joint().linearize(**how)
    assert caught.value.which == which


def test_a_picture() -> None:
    gain, phase = sagged().plot()
    assert gain.get_ylabel() == "gain [dB]"
    assert phase.get_xscale() == "log"
    assert len(gain.lines) == 2


def test_the_page_on_linear_models() -> None:
    """Its program runs as it stands, and tells what the page says."""
    page = (Path(__file__).resolve().parents[2] / "docs" / "linear-models.md").read_text(encoding="utf-8")
    space: dict[str, Any] = {}
    exec(compile(page.split("```python")[1].split("```")[0], "docs/linear-models.md", "exec"), space)  # noqa: S102
    assert space["loop"].is_stable
    assert abs(space["loop"].poles[0]) == pytest.approx(0.986, abs=1e-3)
    assert space["result"].verdict["largest_m"] == pytest.approx(0.025, abs=1e-3)
    assert space["result"].verdict["settling"]["time_s"] is not None  # its samples go on behind the run
    assert not any("unstable" in text for text in space["result"].warnings)
    robot_before = space["robot"].run().verdict["largest_m"]
    assert robot_before == pytest.approx(0.006, abs=1e-3)
    wild = json.loads(json.dumps(space["sheet"]))
    wild["control"][0]["block"]["state_weights"] = {f"{one}.motor": 1e7 for one in space["joints"]}
    wild["control"][0]["block"]["process_noise"] = {f"{one}.motor'": 1e-3 for one in space["joints"]}
    unstable = tmodes.Robot.from_data(wild)
    assert abs(unstable.linearize(closed=True).poles[0]) == pytest.approx(1.0008, abs=2e-4)
    assert any("unstable under its sampled controllers" in text for text in unstable.run().warnings)


def test_the_sheet_on_the_page_on_controllers() -> None:
    """Its sections are taken as they stand, units included, and keep the arm near its path."""
    page = (Path(__file__).resolve().parents[2] / "docs" / "controllers.md").read_text(encoding="utf-8")
    given = yaml.safe_load(page.split("```yaml")[1].split("```")[0].replace("signal: {...}", "signal: 0"))
    data = tmodes.load("two_link_arm").model_dump(mode="json", by_alias=True, exclude_none=True)
    for drive in data["drives"]:
        drive.pop("controller")
    data["drives"][1]["saturation"] = given["drives"][0]["saturation"]
    result = tmodes.Robot.from_data(data | {"sensors": given["sensors"], "control": given["control"]}).run()
    assert result.verdict["largest_m"] < 0.05
    felt = [np.asarray(result.output(f"wrist.{axis}"))[-1] for axis in "xyz"]
    assert np.linalg.norm(felt) == pytest.approx(9.81, abs=0.2)


@pytest.mark.parametrize("closed", [False, True])
def test_about_an_instant_of_a_run(closed: bool) -> None:
    """It changes there as the run does: by closed-form derivatives of Spong's joint where it is then."""
    spongs = tmodes.load("spong1987")
    run = spongs.run()
    linear = spongs.linearize(time=0.5, outputs="joint.position,joint.motor.position,tip.x", closed=closed)
    at = int(np.searchsorted(run.data.time.values, 0.5 - 1e-9))
    n, angle = 2, float(run.output("joint.position")[at])
    assert linear.system.y0 == pytest.approx([float(run.output(name)[at]) for name in linear.outputs], abs=1e-9)
    assert linear.system.rate[:n] == pytest.approx(run.data["v"].values[at], abs=1e-8)
    assert linear.system.rate[n : 2 * n] == pytest.approx(run.data["a"].values[at], abs=1e-6)
    row = linear.A[linear.states.index("joint'"), [linear.states.index("joint"), linear.states.index("joint.motor")]]
    assert row == pytest.approx([-100.0 - 9.8 * np.cos(angle), 100.0], rel=1e-9)
    assert linear.B.shape == (4, 1)


def test_loads_and_drives_of_an_instant_are_those_of_then() -> None:
    """50 N on the tool and a torque on the motor, both stepped on before: the commands hold nothing else."""
    axis = tmodes.load("moberg2009")
    run, linear = axis.run(), axis.linearize(time=1.5, outputs="tip.z")
    at = int(np.searchsorted(run.data.time.values, 1.5 - 1e-9))
    n = len(linear.coordinates)
    assert linear.system.rate[n : 2 * n] == pytest.approx(run.data["a"].values[at], abs=1e-6)


def test_a_time_outside_of_the_run() -> None:
    with pytest.raises(InputError) as caught:
        tmodes.load("spong1987").linearize(time=5.0)
    assert caught.value.which == "time"


def test_the_response_to_a_step() -> None:
    """Of x'' + 0.4 x' + 4 x = u in closed form; the sampled loop alike at its samples; what grows ends in time."""
    w, d = 2.0, 0.1
    A, B, C = np.array([[0.0, 1.0], [-(w**2), -2 * d * w]]), np.array([[0.0], [1.0]]), np.array([[1.0, 0.0]])
    t, ring = np.arange(40) * 0.1, w * np.sqrt(1 - d**2)
    truth = (1 - np.exp(-d * w * t) * (np.cos(ring * t) + d * w / ring * np.sin(ring * t))) / w**2
    assert step_values(A, B, C, np.zeros((1, 1)), 40, 0.1, None)[:, 0, 0] == pytest.approx(truth, abs=1e-12)
    Ad, Bd = zero_order_hold(A, B, 0.05)
    assert step_values(Ad, Bd, C, np.zeros((1, 1)), 40, 0.1, 0.05)[:, 0, 0] == pytest.approx(truth, abs=1e-12)
    assert step_duration(np.array([3.0, -1.0], dtype=complex), None) == pytest.approx(np.log(20) / 3)
    assert step_duration(np.array([-0.5, -9.0], dtype=complex), None) == pytest.approx(2 * np.log(100))
    assert joint().linearize().step_response(1.0).dims == ("time", "output", "input")


def test_a_family_of_uncertain_robots() -> None:
    """Its resonance moves with the stiffness of the gear; the same seed gives the same robots."""
    low, high = 0.8, 1.2
    k = {"k": {"path": "joints.0.gear.stiffness", "relative": True,
               "distribution": {"type": "uniform", "low": low, "high": high}}}  # fmt: skip
    ask = {"inputs": "joint.torque", "outputs": "joint.motor.position", "uncertain": k}
    linear = tmodes.load("spong1987").linearize(**ask, cases=5, seed=3)
    stiff = [-one.A[one.states.index("joint'"), one.states.index("joint")] - 9.8 for one in linear.family]
    assert len(set(stiff)) == 5
    assert 100 * low <= min(stiff) < max(stiff) <= 100 * high
    again = tmodes.load("spong1987").linearize(**ask, cases=5, seed=3)
    assert np.array_equal(linear.family_response([1.0]), again.family_response([1.0]))
    other = tmodes.load("spong1987", {"real": {"joints.0.gear.stiffness": 0.5}}).linearize(**ask, cases=5, seed=3)
    assert np.array_equal(linear.family_response([1.0]), other.family_response([1.0]))  # what is drawn takes its place
    gain, _ = linear.plot()
    (band,) = gain.collections
    assert band in gain.get_legend_handles_labels()[0]


@pytest.mark.parametrize(("chart", "label"), [("nyquist", "imaginary part"), ("step", "after a step of 1")])
def test_further_charts(chart: str, label: str) -> None:
    (panel,) = sagged().plot(chart=chart)
    assert panel.get_ylabel() == label
    with pytest.raises(InputError) as caught:
        sagged().plot(chart="nichols")
    assert caught.value.which == "chart"


def test_a_nyquist_diagram_has_no_corners() -> None:
    """Parts of the curve that are seen are short; its mirror image is in the legend."""
    linear = joint().linearize(at={"joint.motor": SAGGED}, inputs="joint.torque", outputs="joint.motor.position")
    (panel,) = linear.plot(chart="nyquist")
    curve, mirror = (np.asarray(one.get_xydata()) for one in panel.lines[:2])
    reach = panel.get_xlim()[1]
    seen = (np.abs(curve) < reach).all(axis=1)
    assert np.hypot(*np.diff(curve, axis=0).T)[seen[1:] | seen[:-1]].max() < 0.021 * reach
    assert mirror == pytest.approx(curve * [1, -1])
    assert panel.lines[1] in panel.get_legend_handles_labels()[0]


def test_the_phase_of_a_family_has_no_jumps_of_whole_turns() -> None:
    """Phases of uncertain robots are sums of the angles of their zeros and poles, which never wrap."""
    soft = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.5, "high": 2.0}}
    own = tmodes.load("spong1987").with_({"gear.damping": 0.05})
    linear = own.linearize(inputs="joint.torque", outputs="joint.motor.position", uncertain={"k": soft}, cases=12)
    at = linear.frequencies()
    (_, _, (_, phase), (_, ends)), = bode_curves(linear.frequency_response(), linear.family_response())  # fmt: skip
    points = 2j * np.pi * at[:, None]

    def truth(one: Any) -> Any:
        found = replace(linear, made=lambda: one)
        angles = [np.angle(points - some).sum(axis=1) for some in (found.zeros(), found.poles)]
        return np.degrees(angles[0] - angles[1])

    every = np.array([truth(one) for one in linear.family])
    shift = phase[0] - truth(linear.system)[0]  # by the sign of the gain, and the angle at which it begins
    assert phase == pytest.approx(truth(linear.system) + shift, abs=1e-6)
    assert ends[0] == pytest.approx(every.min(axis=0) + shift, abs=1e-6)
    assert ends[1] == pytest.approx(every.max(axis=0) + shift, abs=1e-6)
    assert np.ptp(ends, axis=0).max() < 180.0 + 1e-9


def test_its_answer_in_a_sentence() -> None:
    """Stable or not and by which mode, margins, what is non-minimum phase."""
    linear = sagged(period=None)
    slow, fast = "0.113 Hz (damping 8.1 %, mostly joint)", "5.29 Hz (damping 3.8 %, mostly joint.motor)"
    assert linear.sentence == f"In open loop stable; it rings at {slow}, {fast}."
    assert "non-minimum" not in linear.sentence
    one = joint().linearize(at={"joint.motor": SAGGED}, inputs="joint.torque", outputs="joint.motor.position")
    known = one.margins()
    assert f"phase {np.degrees(known.phase):.3g}° at {known.phase_frequency:.3g} Hz" in one.sentence
    beam = slewing(3).linearize(inputs="hub.torque", outputs="tip.y").sentence
    assert "neither stable nor unstable; it rings at 3.8 Hz (undamped, mostly" in beam
    assert beam.endswith("non-minimum phase: hub.torque to tip.y.")
    up = joint().linearize(at={"joint.motor": np.pi}, inputs="joint.torque").sentence
    assert "unstable, it grows at " in up


def test_what_is_damped_well_does_not_ring() -> None:
    """A pair of poles at a damping of 0.75, and one at 0.65."""
    linear = sagged(period=None)
    damped = [np.array([[0.0, 1.0], [-100.0, -20.0 * share]]) for share in (0.75, 0.65)]
    A = np.block([[damped[0], np.zeros((2, 2))], [np.zeros((2, 2)), damped[1]]])
    said = replace(linear, made=lambda: replace(linear.system, A=A)).sentence
    assert said.count(" Hz (damping") == 1
    assert "damping 65 %" in said
    alone = replace(linear.system, A=np.kron(np.eye(2), damped[0]))
    assert "nothing rings" in replace(linear, made=lambda: alone).sentence


def test_inputs_have_units_and_loops_the_value_there() -> None:
    """The effort of a drive is its torque, which on a slide is a force; it holds 1 kg."""
    slide = tmodes.load("spong1987").with_({"joints.0.type": "prismatic", "joints.0.axis": [0, 0, 1]})
    linear = slide.linearize(inputs="joint.effort,tip.moment.x", outputs="joint.position")
    assert linear.system.units == {"joint.effort": "N", "tip.moment.x": "N*m", "joint.position": "m"}
    weight = linear.system.u0[0]
    assert linear.B[:, [0]] == pytest.approx(slide.linearize(inputs="joint.torque").B)
    closed = slide.linearize(closed=True, inputs="joint.setpoint,joint.setpoint_rate")
    assert [closed.system.units[name] for name in closed.inputs] == ["m", "m/s"]
    for changes in ({}, {"drives.0.sample_time": 0.002}):
        loop = slide.with_(changes).linearize(closed=True).loop("joint").system
        assert loop.units == {"joint.command": "N"}
        assert [*loop.u0, *loop.y0] == pytest.approx([weight, weight], rel=1e-9)
    assert {len(row) for table in linear.tables() if isinstance(table, Table) and table.title.endswith("puts")
            for row in table.rows} == {3}  # fmt: skip


def test_to_control_without_its_package(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "control", None)
    with pytest.raises(InputError) as caught:
        joint().linearize().to_control()
    assert caught.value.hint == "pip install control"
    assert "python-control" in caught.value.which


def test_modes_are_named_by_the_state_that_takes_part() -> None:
    linear = sagged()
    assert [one.pole for one in linear.modes] == pytest.approx([*linear.poles])
    assert [one.state for one in linear.modes] == ["joint"] * 2 + ["joint.motor"] * 2


def test_its_page(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    guide = (Path(__file__).resolve().parents[2] / "docs" / "linear-models.md").read_text(encoding="utf-8")
    line, fewer, closed = [one.strip() for one in guide.splitlines() if one.startswith("    tmodes ")]
    lost = guide.partition("*responses differ by ")[2].partition(" at most*")[0]
    assert f"responses differ by {lost} at most" in command(*fewer.split()[1:]).stdout.replace("\u00a0", " ")
    assert command(*line.split()[1:]).stdout.endswith("Page: arm.html\n")
    (row,) = [one.split() for one in guide.splitlines() if one.startswith("      motor ")]
    assert row in [one.split() for one in command(*closed.split()[1:]).stdout.splitlines()]
    said = command("linear", "spong1987", "--page", str(tmp_path / "linear.html")).stdout
    assert f"Page: {tmp_path / 'linear.html'}" in said
    text = (tmp_path / "linear.html").read_text(encoding="utf-8")
    assert tmodes.load("spong1987").linearize().sentence in text.replace("\u00a0", " ")
    for linear in (
        sagged(period=1e-3, delay=2.5e-3),
        joint().linearize(at={"joint.motor": np.pi}),
        slewing(3).linearize(),
    ):
        assert linear.page(tmp_path / "other.html").stat().st_size > len(linear.sentence)


def undriven() -> Any:
    sheet = sheet_data(tmodes.load("two_link_arm"))
    return tmodes.Robot.from_data({key: value for key, value in sheet.items() if key not in ("drives", "real", "task")})


def test_without_drives_inputs_are_the_torques_of_all_joints() -> None:
    """That of the same robot with drives at this pose; what is not named is held, and no state."""
    whole = tmodes.load("two_link_arm").linearize(at={"shoulder.motor": 0.0, "elbow.motor": 0.0})
    bare = undriven().linearize()
    assert (bare.inputs, bare.outputs) == (whole.inputs, whole.outputs)
    assert np.abs(bare.A - whole.A).max() < 1e-6 * np.abs(whole.A).max()
    one = undriven().linearize(inputs="elbow.torque", outputs="elbow.position")
    kept = [k for k, name in enumerate(whole.states) if not name.startswith("shoulder.motor")]
    assert one.states == tuple(whole.states[k] for k in kept)
    assert near(one.poles, np.linalg.eigvals(whole.A[np.ix_(kept, kept)]), 1e-6)
    held = undriven().linearize(inputs="tip.force.z", outputs="tip.z")
    assert held.is_stable
    assert not any(name.removesuffix("'").endswith(".motor") for name in held.states)


def test_without_joints_inputs_are_forces_at_the_tip() -> None:
    """Of a clamped beam: the first frequency is 1.8751^2 sqrt(EI/m)/l^2."""
    sheet = sheet_data(slewing())
    sheet["joints"][0] = {"name": "hub", "type": "fixed", "child": "arm"}
    sheet["links"][0].pop("bodies")
    sheet.pop("drives")
    linear = tmodes.Robot.from_data(sheet).linearize()
    assert linear.inputs == ("tip.force.x", "tip.force.y", "tip.force.z")
    assert near(linear.poles, [1j * 1.8751040687119611**2 * np.sqrt(5.2 / 0.31) / 0.9**2], 1e-6)
    with pytest.raises(InputError) as caught:
        undriven().linearize(inputs="foo")
    assert "shoulder.torque, elbow.torque, tip.force.x" in str(caught.value)
    with pytest.raises(InputError) as caught:
        undriven().linearize(closed=True)
    assert caught.value.which == "closed"


def test_of_a_model_without_inputs_no_mode_is_said_to_be_out_of_reach() -> None:
    """Of one without inputs all are, which its size says already."""
    linear = sagged()
    none = {"inputs": (), "B": np.zeros((4, 0)), "D": np.zeros((0, 0)), "u0": np.zeros(0)}
    none |= {"outputs": (), "C": np.zeros((0, 4)), "y0": np.zeros(0)}
    system = replace(linear.system, **none)
    said = "\n".join(str(part) for part in replace(linear, made=lambda: system).tables())
    assert "0 inputs, 0 outputs" in said
    assert "No input reaches" not in said
    assert "No output shows" not in said


def test_zeros_are_of_what_two_names_share() -> None:
    """Modes of the other way of bending cancel: the zeros are those of the same arm that bends in its plane alone."""
    flat = tmodes.load("two_link_arm").with_({"gravity": 0.0})
    spatial = flat.with_({"planar": False, "links.forearm.beam.functions": {"bend_y": 2, "bend_z": 1}})
    one, other = (each.linearize(inputs="elbow.torque", outputs="tip.z") for each in (flat, spatial))
    assert len(other.A) > len(one.A)
    assert near(np.sort_complex(other.zeros("tip.z", "elbow.torque")),
                np.sort_complex(one.zeros("tip.z", "elbow.torque")), 1e-6)  # fmt: skip
    across = spatial.linearize(inputs="elbow.torque", outputs="tip.z,tip.y")
    assert not across.acts("tip.y", "elbow.torque")
    assert across.acts("tip.z", "elbow.torque")


def test_what_no_gain_reads_is_no_state_of_the_loop() -> None:
    plain = {"type": "pd", "position_gain": 40.0, "velocity_gain": 3.0}
    with_none = {"type": "pid", "position_gain": 40.0, "velocity_gain": 3.0, "integral_gain": 0.0}
    one, other = (tmodes.load("spong1987").with_({"drives.0.controller": each}).linearize(closed=True)
                  for each in (plain, with_none))  # fmt: skip
    assert other.is_stable
    assert near(other.poles, one.poles)


def test_a_closed_loop_is_about_where_its_gains_leave_it() -> None:
    """A proportional gain gives way to the weight: q is that of the start of the run, and of the matrices."""
    soft = tmodes.load("two_link_arm").with_({"drives.0.controller": {"type": "pd", "position_gain": 2000.0,
                                                                      "velocity_gain": 60.0}})  # fmt: skip
    found = soft.linearize(closed=True)
    assert found.q == pytest.approx(found.system.x0[: len(found.q)], abs=1e-9)
    assert abs(found.q[0] + 0.4) > 1e-3


def test_integrators_are_named_in_a_column_of_numbers(tmp_path: Path) -> None:
    """Two of a free joint, which rounding parts; no damping ratio of -1 or -0. Numbers stand to the right."""
    free = tmodes.load("spong1987").with_({"gravity": 0.0})
    rows = linear_words.pole_rows(free.linearize())
    assert [row[:4] for row in rows[:2]] == [["0", "0", "0", "-"]] * 2
    assert all(row[4].endswith("an integrator") for row in rows[:2])
    assert rows[2][0] == "0"
    assert rows[2][3] == "0.0000"
    page = free.linearize().page(tmp_path / "linear.html").read_text(encoding="utf-8")
    assert 'scope="row" class="number">0<' in page


def test_zeros_are_printed_in_the_plane_in_which_they_are() -> None:
    """Of an acceleration two zeros at 0, whatever is rounded; of a sampled model no rates."""
    spong = tmodes.load("spong1987")
    accelerations = spong.linearize(inputs="joint.torque", outputs="joint.motor.acceleration")
    assert str(accelerations).count("0+0i") == 2
    assert "zeros [1/s]" in str(accelerations)
    sampled = spong.linearize(inputs="joint.torque", outputs="joint.motor.position", period=1e-3)
    assert "zeros, z plane" in str(sampled)
    assert "zeros [1/s]" not in str(sampled)
