"""Blocks with ports: sensors, filters, observers and laws of several drives, in every way to run.

Numbers of the reference are "reference values computed with" exact discrete systems and SciPy's DOP853 (1e-12).
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm
from scipy.signal import bilinear, lfilter, tf2ss

import tmodes
from lane_runs import simulate_lanes
from simulation.sheets import arm
from tmodes.errors import InputErrors, TmodesError
from tmodes.simulation.initial_state import run_setup
from tmodes.simulation.simulate import simulate_motion
from wasm.node import page_states

Sheet = dict[str, Any]
LINK = {"I": 0.83, "J": 0.21, "m": 2.4, "l": 0.42, "g": 9.81, "k": 185.0, "d": 0.35, "b": 0.12}
STATES = ("joint", "joint.motor", "joint'", "joint.motor'")
NOTCH = {"type": "notch", "input": "raw", "frequency": 5.0, "damping": 0.3, "depth": 0.2}
LQR = {"type": "lqr", "state_weights": dict(zip(STATES, (400.0, 100.0, 5.0, 1.0), strict=True))}
PD = {"type": "pd", "position_gain": 60.0, "velocity_gain": 9.0}
IMPEDANCE = {"type": "impedance", "stiffness": [900.0, 0.0, 900.0], "damping": [90.0, 0.0, 90.0],
             "joint_damping": 2.0}  # fmt: skip
OBSERVER = PD | {"type": "disturbance_observer", "bandwidth": 9.0}
PID = PD | {"type": "sampled_pid", "integral_gain": 70.0, "sample_time": 1e-3, "filter_time": 0.004, "limit": 14.0}
STEPS = {"type": "sum", "signals": [{"type": "constant", "value": 1.2},
                                    {"type": "step", "start": 0.0, "end": -0.9, "time": 1.5}]}  # fmt: skip


def constant(value: float) -> Sheet:
    return {"type": "constant", "value": value}


def spong(signal: Sheet, until: float, step: float, p: Sheet | None = None, **more: Any) -> Any:
    """One link on an elastic joint, hanging at 0, at rest there whatever its setpoint."""
    p, drive = LINK | (p or {}), {"joint": "joint", "command": "position", "signal": signal} | more.pop("drive", {})
    own = p["I"] - p["m"] * p["l"] ** 2
    body = {"name": "bob", "mass": p["m"], "center": [0, 0, -p["l"]],
            "inertia": {"yy": own, "xx": own, "zz": 1e-9}}  # fmt: skip
    motor = {"inertia": p["J"], "side": "joint", "friction": {"viscous": p["b"]}}
    joint = {"name": "joint", "type": "revolute", "child": "link", "axis": [0, 1, 0], "motor": motor,
             "gear": {"stiffness": p["k"], "damping": p["d"]}}  # fmt: skip
    start = {"state": "zero", "coordinates": {"joint.motor": 0.0, "joint": 0.0}}
    return arm(gravity=p["g"], joints=[joint], links=[{"name": "link", "bodies": [body]}],
               tip={"link": "link", "position": [0, 0, -p["l"]]}, drives=[drive],
               integration={"duration": until, "output_step": step} | more.pop("integration", {}),
               **{"initial": start} | more)  # fmt: skip


def law(block: Sheet, **more: Any) -> list[Sheet]:
    return [{"name": "law", "drives": ["joint"], "block": block} | more]


def angles(robot: Any, times: Any) -> NDArray[np.float64]:
    """Angles (times, 2) of link and motor."""
    run = simulate_motion(robot)
    found = np.searchsorted(run.times, np.asarray(times) - 1e-9)
    assert run.times[found] == pytest.approx(times, abs=1e-9)
    return run.q[found][:, [1, 0]]


LQG = LQR | {
    "type": "lqg", "sample_time": 0.01, "measured": ["joint.motor.position"], "measurement_noise": [1e-5],
    "process_noise": dict(zip(STATES, (1e-8, 1e-8, 1e-4, 1e-4), strict=True)),
    "estimate": {"joint": -0.85, "joint.motor": -0.9218697971854767},
}  # fmt: skip
SHAPED: Sheet = {"type": "loop_shaping", "measured": ["joint.motor.position"], "gains": {"joint": 40.0},
                 "integral_frequency": 0.3, "lead_frequency": 2.0, "lead_ratio": 5.0}  # fmt: skip
SHARE = "(min(t, 1.2)/1.2)"
NINTH = f"0.1 + 1.2*(126*{SHARE}**5 - 420*{SHARE}**6 + 540*{SHARE}**7 - 315*{SHARE}**8 + 70*{SHARE}**9)"
REFERENCE: dict[str, tuple[Any, list[float], list[list[float]]]] = {
    "pid": (spong(STEPS, 3.0, 0.15, drive={"controller": PID | {"anti_windup": "none"}}), [0.3, 1.65, 2.85], [
        [0.5407948062682089, 0.6407818726414414], [0.9939077914074919, 0.964906868011785],
        [0.28805668255661615, 0.314360678410921]]),
    "clamped": (spong(STEPS, 3.0, 0.15, drive={"controller": PID}), [0.3, 1.65, 2.85], [
        [0.5383275766821861, 0.6201752122382347], [0.9321728308512413, 0.9027464274014748],
        [0.27333782839087656, 0.2957726751265605]]),
    "lqr": (spong(constant(0.9418697971854767), 2.0, 0.1, control=law(LQR | {"sample_time": 0.01})), [0.2, 1.1, 1.9], [
        [0.2880858606421824, 0.2551562688394538], [0.9394644146721819, 0.9803020843786169],
        [0.8968149830003505, 0.9379280913379331]]),
    "lqg": (spong(constant(0.9418697971854767), 2.5, 0.25, control=law(LQG)), [0.5, 1.5, 2.25], [
        [0.8650299219204926, 0.8948459821727348], [0.8971174534789403, 0.9392742525133198],
        [0.8997745678666609, 0.9414511742923266]]),
    "linearised": (spong({"type": "expression", "formula": NINTH}, 2.0, 0.1, {"d": 0.0}, control=law(
        {"type": "feedback_linearisation", "pole": 14.0})), [0.2, 1.1, 1.9], [
        [0.04154633066251028, 0.06199200411622489], [1.2995286784681708, 1.3475167453328214],
        [1.2999999990135134, 1.3515033812609554]]),
    "gravity": (spong(constant(1.2), 3.0, 0.15, drive={"controller": {
        "type": "gravity_pd", "position_gain": 70.0, "velocity_gain": 6.0}}), [0.3, 1.65, 2.85], [
        [1.4869561145966144, 1.386153462367721], [1.1511337438882638, 1.2145652040567267],
        [1.2038790119688534, 1.252423800414083]]),
}  # fmt: skip


@pytest.mark.parametrize("name", REFERENCE)
def test_reference_values(name: str) -> None:
    """Angles of link and motor at whole samples."""
    robot, times, truth = REFERENCE[name]
    assert angles(robot, times) == pytest.approx(np.array(truth), abs=1e-6)


def two_links() -> Any:
    """A rigid arm with a payload, in the vertical plane, moved by computed torque at 100 Hz."""
    ends = ((-0.5, 0.8), (0.4, -0.7))
    sizes = ((4.2, 0.22, 0.085, 0.3), (2.6, 0.18, 0.041, 0.15))
    moved = [
        {"joint": f"j{k}", "command": "position", "signal": {"type": "quintic", "start": a, "end": b, "duration": 1.0}}
        for k, (a, b) in enumerate(ends)
    ]
    bodies = [[{"name": "own", "mass": m, "center": [c, 0, 0], "inertia": {"xx": 1e-6, "yy": i, "zz": i}}]
              for m, c, i, _ in sizes]  # fmt: skip
    bodies[1].append({"name": "payload", "mass": 0.8, "center": [0.41, 0, 0]})
    joints = [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1],
               "motor": {"inertia": 0.0, "side": "joint", "friction": {"viscous": sizes[k][3]}},
               **({"parent": "l0", "origin": {"position": [0.48, 0, 0]}} if k else {})} for k in range(2)]  # fmt: skip
    block = {"type": "computed_torque", "position_gain": 400.0, "velocity_gain": 40.0, "sample_time": 0.01}
    return arm(gravity=[0, -9.81, 0], joints=joints, drives=moved, tip={"link": "l1", "position": [0.41, 0, 0]},
               links=[{"name": f"l{k}", "bodies": one} for k, one in enumerate(bodies)],
               control=[{"name": "law", "drives": ["j0", "j1"], "block": block}],
               initial={"state": "zero", "coordinates": {"j0": -0.5, "j1": 0.4}},
               integration={"duration": 1.5, "output_step": 0.05})  # fmt: skip


def test_computed_torque_of_two_joints() -> None:
    run = simulate_motion(two_links())
    truth = {0.3: (-0.28826346850571183, 0.2211484551987438), 1.35: (0.7999961077265639, -0.6999983732181175)}
    for time, angle in truth.items():
        assert run.q[np.searchsorted(run.times, time - 1e-9)] == pytest.approx(angle, abs=1e-6)


@pytest.mark.parametrize("own", [PD, PID, PID | {"anti_windup": "back_calculation", "tracking_time": 0.2}])
def test_a_block_commands_as_the_same_law_at_the_drive(own: Sheet) -> None:
    """To the bit."""
    at_drive = simulate_motion(spong(STEPS, 2.0, 0.02, drive={"controller": own}))
    as_block = simulate_motion(spong(STEPS, 2.0, 0.02, control=law(own)))
    assert np.array_equal(at_drive.q, as_block.q)


def test_efforts_of_a_block_and_of_the_drive_are_the_same() -> None:
    """Added to an LQR of two drives, whose commands it takes over, and at the drives: to the bit; in any order."""
    robot = tmodes.load("two_link_arm", {"integration.duration": 0.2})
    names = [drive.joint for drive in robot.drives]
    block: Sheet = {"type": "lqr", "state_weights": {f"{name}.motor": 1e4 for name in names}}
    control: list[Sheet] = [{"name": "law", "drives": names, "block": block}]
    signals = [{"type": "quintic", "start": 0.0, "end": 0.3 + k, "duration": 0.1} for k in range(2)]
    bare = {"control": control, **{f"drives.{k}.controller": None for k in range(2)}}
    at_drives = tmodes.run(robot.with_(bare | {f"drives.{k}.feed_forward": signals[k] for k in range(2)}))
    last = {"name": "sum", "drives": names, "block": {
        "type": "feed_forward", "inputs": [f"law.{name}" for name in names], "signals": signals}}  # fmt: skip
    for chain in ([*control, last], [last, *control]):
        found = tmodes.run(robot.with_(bare | {"control": chain}))
        assert np.array_equal(found.data["q"].values, at_drives.data["q"].values)
    with pytest.raises(InputErrors, match=r"a drive with one law"):
        robot.with_(bare | {"control": [*control, last, {**last, "name": "another"}]})
    other = {"name": "aside", "block": {**last["block"], "signals": signals[::-1]}}
    with pytest.raises(InputErrors, match=r"on top of the same command"):
        robot.with_(bare | {"control": [*control, last, other]})


EVERYWHERE = {
    "gravity_pd": {"drive": {"controller": {"type": "gravity_pd", "position_gain": 70.0, "velocity_gain": 6.0}}},
    "online": {"drive": {"controller": {"type": "gravity_pd", "position_gain": 70.0, "velocity_gain": 6.0,
                                        "online": True}}},
    "feedback_linearisation": {"control": law({"type": "feedback_linearisation", "pole": 14.0})},
    "passivity_based": {"control": law({"type": "passivity_based", "damping": 5.0, "position_gain": 200.0,
                                        "velocity_gain": 20.0})},
    "singular_perturbation": {"control": law({"type": "singular_perturbation", "position_gain": 25.0,
                                              "velocity_gain": 10.0})},
    "impedance": {"control": law(IMPEDANCE)},
    "force": {"control": law(IMPEDANCE | {"type": "force", "direction": [1, 0, 0], "force": 4.0, "integral_gain": 3.0,
                                          "input": "tip.x", "sample_time": 0.01})},
    "disturbance_observer": {"drive": {"controller": OBSERVER}},
    "sampled observer": {"control": [{"name": "raw", "of": "joint", "block": PD},
                                     *law({"type": "disturbance_observer", "bandwidth": 9.0, "sample_time": 0.01,
                                           "input": "raw"}, delay=0.01)]},
    "lqr": {"control": law(LQR | {"integral": True})},
    "pole_placement": {"control": law({"type": "pole_placement", "poles": [[2.0, 0.7], [4.0, 0.7]]})},
    "lqg": {"control": law(LQG | {"measured": ["teeth"]}, delay=0.013),
            "sensors": [{"type": "encoder", "name": "teeth", "joint": "joint", "resolution": 1e-3,
                         "sample_time": 0.01, "noise": 1e-4, "delay": 0.004}]},
    "lqg, fed": {"control": law(LQG), "drive": {"feed_forward": {
        "type": "quintic", "start": 0.0, "end": 6.0, "duration": 0.5}}},
    "lqg, reference": {"control": law(LQG | {"reference": {"joint": {
        "type": "quintic", "start": 0.0, "end": 0.8, "duration": 0.6}}})},
    "loop_shaping": {"control": law(SHAPED | {"measured": ["teeth"], "sample_time": 0.01}, delay=0.013),
                     "sensors": [{"type": "encoder", "name": "teeth", "joint": "joint", "resolution": 1e-3}]},
    "loop_shaping, continuous": {"control": law(SHAPED)},
    "feed_forward": {"control": [*law(LQR), {"name": "sum", "drives": ["joint"], "block": {
        "type": "feed_forward", "inputs": ["law"], "signals": [
            {"type": "quintic", "start": 0.0, "end": 6.0, "duration": 0.5}]}}]},
    "timed": {"drive": {"controller": PD, "sample_time": 0.01, "delay": 0.025, "saturation": {"torque": 12.0}}},
    "filters": {"control": [{"name": "raw", "of": "joint", "block": PD},
                            {"name": "lead", "block": {"type": "lead_lag", "input": "raw", "frequency": 8.0,
                                                       "ratio": 2.0}},
                            {"name": "low", "block": {"type": "low_pass", "input": "lead", "frequency": 60.0}},
                            {"name": "low2", "block": {"type": "low_pass", "input": "low", "frequency": 60.0,
                                                       "damping": 0.7, "sample_time": 1e-3}},
                            {"name": "law", "drives": ["joint"], "block": NOTCH | {"input": "low2"}}]},
}  # fmt: skip


@pytest.mark.nightly("loop_shaping,", "lqg,", "sampled", "timed", "online")
@pytest.mark.parametrize("name", EVERYWHERE)
def test_a_law_runs_everywhere_alike(name: str, tmp_path: Path) -> None:
    """By explicit and implicit methods, side by side with other numbers, in the page; and energy is kept."""
    move = {"type": "quintic", "start": 0.0, "end": 0.9, "duration": 0.5}
    exact = {"relative_tolerance": 1e-9, "absolute_tolerance": 1e-10, "method": "dormand_prince"}
    robot = spong(move, 1.0, 0.01, integration=exact, initial={"state": "rest"}, **EVERYWHERE[name])
    run, setup = simulate_motion(robot), run_setup(robot)
    assert run.status == "finished"
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    for method in ("extrapolation", "rosenbrock"):
        other = simulate_motion(robot.with_({"integration.method": method}))
        assert np.abs(other.q - run.q).max() < 2e-6, method
    settings = robot.integration
    numbers = np.array([setup.model.numbers, setup.model.numbers * 1.001])
    lanes = simulate_lanes(setup.model, numbers, setup.planned.schedule, setup.start, settings)
    size = len(setup.model.coordinates)
    assert np.abs(lanes.states[0][:, :size] - run.q).max() < 1e-7
    assert np.abs(page_states(setup, tmp_path)[:, :size] - run.q).max() < 1e-9


def matrices(p: Sheet) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """x' = a x + b u of angles and rates of link and motor, without weight."""
    a, b, mass = np.zeros((4, 4)), np.zeros((4, 1)), np.array([p["I"], p["J"]])
    a[:2, 2:] = np.eye(2)
    spring, damper = np.array([[-p["k"], p["k"]], [p["k"], -p["k"]]]), np.array([[-p["d"], p["d"]], [p["d"], -p["d"]]])
    damper[1, 1] -= p["b"]
    a[2:, :2], a[2:, 2:], b[3, 0] = spring / mass[:, None], damper / mass[:, None], 1 / p["J"]
    return a, b


def test_a_delay_of_parts_of_a_period() -> None:
    """Torque from 2.5 samples before, by the exponential of the matrices."""
    p, period, n = LINK | {"g": 0.0}, 0.01, 80
    robot = spong(constant(0.4), period * n, period, p, drive={"controller": PD, "sample_time": period,
                                                               "delay": 2.5 * period})  # fmt: skip
    half: Any = expm(np.block([[*matrices(p)], [np.zeros((1, 5))]]) * period / 2)
    x, commands, found = np.zeros(4), [0.0, 0.0, 0.0], [np.zeros(2)]
    for _ in range(n):
        commands.append(PD["position_gain"] * (0.4 - x[1]) - PD["velocity_gain"] * x[3])
        for push in (commands[-4], commands[-3]):
            x = (half @ np.append(x, push))[:4]
        found.append(x[:2])
    times = period * np.arange(n + 1)
    assert angles(robot, times) == pytest.approx(np.array(found), abs=1e-8)


RATE = 2 * np.pi * 5.0
FILTERS: dict[str, tuple[Sheet, list[float], list[float]]] = {
    "notch": (NOTCH, [1.0, 0.12 * RATE, RATE**2], [1.0, 0.6 * RATE, RATE**2]),
    "low": ({"type": "low_pass", "frequency": 5.0}, [RATE], [1.0, RATE]),
    "low2": ({"type": "low_pass", "frequency": 5.0, "damping": 0.7}, [RATE**2], [1.0, 1.4 * RATE, RATE**2]),
    "lead": ({"type": "lead_lag", "frequency": 5.0, "ratio": 4.0}, [2 / RATE, 1.0], [0.5 / RATE, 1.0]),
    "lag": ({"type": "lead_lag", "frequency": 5.0, "ratio": 0.25}, [0.5 / RATE, 1.0], [2 / RATE, 1.0]),
}


def filtered(block: Sheet, period: float | None = None) -> list[Sheet]:
    more = {} if period is None else {"sample_time": period}
    raw = {"name": "raw", "of": "joint", "block": {**PD, "position_gain": 12.0}} | more
    return [raw, {"name": "law", "drives": ["joint"], "block": block | {"input": "raw"} | more}]


@pytest.mark.parametrize("name", FILTERS)
def test_filters_in_the_loop(name: str) -> None:
    """Sampled ones as SciPy's bilinear transform with prewarping, those in continuous time as its matrices."""
    block, above, below = FILTERS[name]
    p, period, n, (kp, kv) = LINK | {"g": 0.0}, 0.01, 80, (12.0, PD["velocity_gain"])
    (a, b), times = matrices(p), period * np.arange(n + 1)
    whole = expm(np.block([[a, b], [np.zeros((1, 5))]]) * period)
    digital: Any = bilinear(above, below, RATE / (2 * np.tan(RATE * period / 2)))
    numerator, denominator = digital
    x, kept, found = np.zeros(4), np.zeros(len(denominator) - 1), [np.zeros(2)]
    for _ in range(n):
        push, kept = lfilter(numerator, denominator, [kp * (0.4 - x[1]) - kv * x[3]], zi=kept)
        x = (whole @ np.append(x, push))[:4]
        found.append(x[:2])
    sampled = spong(constant(0.4), period * n, period, p, control=filtered(block, period))
    assert angles(sampled, times) == pytest.approx(np.array(found), abs=1e-8)

    A, B, C, D = tf2ss(above, below)
    row = np.array([[0.0, -kp, 0.0, -kv]])
    loop = np.block([[a + b @ D @ row, b @ C, b @ D], [B @ row, A, B], [np.zeros((1, 5 + len(A)))]])
    start = np.append(np.zeros(4 + len(A)), kp * 0.4)
    truth = np.array([(expm(loop * t) @ start)[:2] for t in times])
    exact = {"relative_tolerance": 1e-10, "absolute_tolerance": 1e-11, "method": "dormand_prince"}
    smooth = spong(constant(0.4), period * n, period, p, control=filtered(block), integration=exact)
    assert angles(smooth, times) == pytest.approx(truth, abs=1e-7)


def test_what_sensors_say() -> None:
    """Exact ones are the outputs; steps, bias and delay are as given; noise has its deviation, alike each time."""
    sensors = [
        {"type": "accelerometer", "name": "felt"}, {"type": "gyro", "name": "turns"},
        {"type": "encoder", "name": "teeth", "joint": "joint", "side": "joint", "resolution": 0.01},
        {"type": "output", "name": "late", "output": "tip.x", "sample_time": 0.01, "delay": 0.02},
        {"type": "output", "name": "rough", "output": "tip.z", "sample_time": 1e-3, "noise": 0.02, "seed": 5,
         "bias": 0.3},
    ]  # fmt: skip
    robot = tmodes.Robot.from_data(
        spong(STEPS, 1.0, 1e-3, drive={"controller": PD}, sensors=sensors).model_dump(
            mode="json", by_alias=True, exclude_none=True
        )
    )
    run, again = robot.run(), robot.run()

    def out(name: str, of: Any = run) -> NDArray[np.float64]:
        return np.asarray(of.output(name))

    angle, rate = out("joint.position"), out("joint.velocity")
    world = np.stack([out("tip.acceleration.x"), np.zeros_like(angle), out("tip.acceleration.z") + 9.81])
    c, s = np.cos(angle), np.sin(angle)
    assert out("felt.x") == pytest.approx(c * world[0] - s * world[2], abs=1e-8)
    assert out("felt.z") == pytest.approx(s * world[0] + c * world[2], abs=1e-8)
    assert out("felt.z")[0] == pytest.approx(9.81, abs=1e-9)
    assert out("turns.y") == pytest.approx(rate, abs=1e-12)
    assert out("teeth") == pytest.approx(0.01 * np.round(angle / 0.01), abs=1e-12)
    kept = out("tip.x")[:-21:10]
    assert out("late")[20:-1:10][: len(kept)] == pytest.approx(kept[: len(out("late")[20:-1:10])], abs=1e-12)
    error = (out("rough") - out("tip.z"))[:-1] - 0.3
    assert np.std(error) == pytest.approx(0.02, rel=0.1)
    assert abs(error.mean()) < 4 * 0.02 / np.sqrt(len(error))
    assert np.array_equal(out("rough"), out("rough", again))


WRONG: dict[str, tuple[Sheet, str]] = {
    "a name twice": ({"sensors": [{"type": "gyro", "name": "a"}, {"type": "gyro", "name": "a"}]}, "sensors.a.name"),
    "the name of a joint": ({"sensors": [{"type": "gyro", "name": "joint"}]}, "sensors.joint.name"),
    "two laws": ({"drive": {"controller": PD}, "control": law(PD)}, "control.law.drives.0"),
    "no law": ({}, "drives.0.controller"),
    "an unknown drive": ({"drive": {"controller": PD}, "control": [
        {"name": "a", "drives": ["elbow"], "block": PD}]}, "control.a.drives.0"),
    "a delay without samples": ({"drive": {"controller": PD, "delay": 0.01}}, "drives.0.sample_time"),
    "a delay of too many samples": ({"drive": {"controller": PD, "delay": 0.6, "sample_time": 1e-3}}, "drives.0.delay"),
    "a design of too many": ({"control": law(LQG | {"delay_in_design": True}, delay=5.1)}, "control.law.delay"),
    "a sensor of too many": ({"drive": {"controller": PD}, "sensors": [
        {"type": "gyro", "name": "a", "sample_time": 1e-3, "delay": 0.6}]}, "sensors.a.delay"),
    "a drive twice": ({"control": [{"name": "a", "drives": ["joint", "joint"], "block": LQR}]}, "control.a.drives.1"),
    "two sample times": ({"drive": {"controller": PID, "sample_time": 0.01}}, "drives.0.sample_time"),
    "noise without samples": ({"drive": {"controller": PD}, "sensors": [
        {"type": "gyro", "name": "a", "noise": 0.1}]}, "sensors.a.sample_time"),
    "a filter above half the sample rate": ({"control": filtered(NOTCH, 0.1)}, "control.law.block.frequency"),
    "a filter of two drives": ({"control": [{"name": "a", "drives": ["joint", "joint"], "block": NOTCH}]},
                               "control.a.drives"),
    "filters in a ring": ({"control": [
        {"name": "a", "drives": ["joint"], "block": NOTCH | {"input": "b"}},
        {"name": "b", "block": NOTCH | {"input": "a"}}]}, "control"),
    "a designed law at a drive": ({"drive": {"controller": LQR}}, "drives.0.controller.type"),
}  # fmt: skip


@pytest.mark.parametrize("name", WRONG)
def test_what_does_not_fit_is_refused_at_its_place(name: str) -> None:
    more, place = WRONG[name]
    with pytest.raises(InputErrors) as caught:
        spong(STEPS, 1.0, 0.1, **more)
    assert place in [error.which for error in caught.value.errors]


@pytest.mark.parametrize(
    ("more", "place"),
    [
        ({"sensors": [{"type": "output", "name": "a", "output": "tip.q"}]}, "sensors.a"),
        ({"sensors": [{"type": "encoder", "name": "a", "joint": "elbow"}]}, "sensors.a"),
        ({"control": law(LQG | {"measured": ["nothing"]})}, "control.law.block"),
        ({"control": law(LQR | {"state_weights": {"elbow": 1.0}})}, "control.law.block.state_weights"),
        ({"control": law({"type": "pole_placement", "poles": [[1.0, 0.7]]})}, "control.law.block.poles"),
    ],
)
def test_what_a_robot_has_not_is_refused_where_it_is_asked_for(more: Sheet, place: str) -> None:
    own = {} if "control" in more else {"drive": {"controller": PD}}
    with pytest.raises(TmodesError) as caught:
        simulate_motion(spong(STEPS, 1.0, 0.1, **more, **own))
    assert str(caught.value).startswith(place)


def test_a_pid_of_a_sensor_is_that_of_the_position_that_it_measures() -> None:
    """Of a perfect encoder the same run; of one with bias off by it at the end; without a filter it has no rate."""
    pid = {"type": "sampled_pid", "position_gain": 80.0, "velocity_gain": 12.0, "integral_gain": 40.0,
           "filter_time": 0.002, "sample_time": 0.01}  # fmt: skip
    robot = tmodes.load("spong1987").with_({"integration.duration": 4.0, "drives.0.controller": pid})

    def under(**more: float) -> Any:
        encoder = {"name": "encoder", "type": "encoder", "joint": "joint", "side": "motor"} | more
        changed = robot.with_({"sensors": [encoder], "drives.0.controller": pid | {"measured": "encoder"}})
        return changed.run(error_estimate=False).output("joint.motor.position").values

    own = robot.run(error_estimate=False).output("joint.motor.position").values
    assert np.allclose(under(), own, rtol=0, atol=1e-9)
    assert under(bias=0.01)[-1] - own[-1] == pytest.approx(-0.01, abs=1e-3)
    with pytest.raises(InputErrors, match="filter_time"):
        robot.with_({"drives.0.controller": {k: v for k, v in pid.items() if k != "filter_time"} | {"measured": "x"}})
