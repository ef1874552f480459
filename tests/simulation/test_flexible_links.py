"""Flexible links in large motion against reference values (geometrically exact beams, independent solvers)."""

from __future__ import annotations

import numpy as np
import pytest

from simulation.sheets import REFERENCE, ZERO, arm, at_times, beam
from tmodes.simulation.simulate import simulate_motion


def test_slewing_link():
    """A hub with a bare link, torque on and off: 4.7 % of its length is the largest deflection."""
    case = REFERENCE["d1"]
    p, pulse = case["params"], case["torque"]
    times = [0.0] + [pulse[name] for name in ("t_on", "t_switch", "t_off") for _ in range(2)] + [2.0]
    size = pulse["amp"]
    signal = {"type": "table", "times": times, "values": [0, 0, size, size, -size, -size, 0, 0],
              "interpolation": "linear"}  # fmt: skip
    hub = {"name": "hub", "mass": 1e-6, "center": [0, 0, 0], "at": 0.0,
           "inertia": {"xx": p["hub_J"], "yy": p["hub_J"], "zz": p["hub_J"]}}  # fmt: skip
    shape = beam({"bend_z": 5}, p["L"], p["EI"], p["rhoA"], basis="tip_weighted")
    link = {"name": "link", "bodies": [hub], "beam": shape}
    last = case["times"][-1]
    run = simulate_motion(arm(
        gravity=0.0,
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 0, 1]}],
        links=[link], drives=[{"joint": "hub", "command": "effort", "signal": signal}],
        integration={"duration": last, "output_step": case["times"][1], "relative_tolerance": 1e-8,
                     "absolute_tolerance": 1e-10},
    ))  # fmt: skip
    rows = at_times(run, case["times"])
    tip = run.points.position[rows, 0, :2]
    assert np.abs(tip - case["tip_xy"]).max() < 1e-3 * p["L"]
    assert np.abs(run.q[rows, 0] - case["hub_angle"]).max() < 2e-3
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def test_two_links_fall():
    """Two flexible links that fall from the horizontal on free joints."""
    case = REFERENCE["e1"]
    links, joints = [], []
    for k, name in enumerate(("link1", "link2")):
        p = case[name]
        bodies = []
        for station, mass, inertia in ((0.0, p.get("hub_m", 0.0), p["hub_J"]), (1.0, p["tip_m"], p["tip_J"])):
            if mass or inertia:
                turning = dict.fromkeys(("xx", "yy", "zz"), max(inertia, 1e-9))
                bodies.append({"name": f"b{station:g}", "mass": mass or 1e-6, "center": [0, 0, 0], "at": station,
                               "inertia": turning})  # fmt: skip
        functions = {"bend_z": 4}
        links.append({"name": name, "bodies": bodies, "beam": beam(functions, p["L"], p["EI"], p["rhoA"])})
        joints.append({"name": f"j{k}", "type": "revolute", "child": name, "axis": [0, 0, 1]})
    joints[0]["parent"] = "base"
    drives = [{"joint": joint["name"], "command": "effort", "signal": ZERO} for joint in joints]
    run = simulate_motion(arm(
        gravity=[0, -9.81, 0], joints=joints, links=links, drives=drives,
        points=[{"name": "elbow", "link": "link1"}], initial={"state": "zero"},
        integration={"duration": 1.2, "output_step": 0.05, "relative_tolerance": 1e-8, "absolute_tolerance": 1e-10},
    ))  # fmt: skip
    rows = at_times(run, case["times"])
    assert np.abs(run.points.position[rows, 0, :2] - case["tip2_xy"]).max() < 1.1e-3
    assert np.abs(run.points.position[rows, 1, :2] - case["tip1_xy"]).max() < 1.1e-3
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved


def test_spin_up():
    """A beam spun up to 6 rad/s stiffens: its tip lags most by 0.5737 m, at 6.76 s (Kane, Ryan, Banerjee 1987)."""
    formula = "6/15*(t**2/2 + (15/(2*pi))**2*(cos(2*pi*t/15)-1))"
    spun = {"type": "expression", "formula": formula}
    run = simulate_motion(arm(
        gravity=0.0,
        joints=[{"name": "hub", "type": "revolute", "parent": "base", "child": "beam", "axis": [0, 0, 1]}],
        links=[{"name": "beam", "beam": beam({"bend_z": 3}, 10.0, 1.4e4, 1.2, basis="legendre")}],
        drives=[{"joint": "hub", "command": "prescribed", "signal": spun}],
        integration={"duration": 8.0, "output_step": 0.01, "relative_tolerance": 1e-9, "absolute_tolerance": 1e-10},
    ))  # fmt: skip
    turn, tip = run.q[:, 0], run.points.position[:, 0]
    lag = -np.sin(turn) * tip[:, 0] + np.cos(turn) * tip[:, 1]
    k = int(np.argmin(lag))
    curve = np.polyfit(run.times[k - 1 : k + 2] - run.times[k], lag[k - 1 : k + 2], 2)
    deepest = -curve[1] / (2 * curve[0])
    assert np.polyval(curve, deepest) == pytest.approx(-0.5737, abs=2e-4)
    assert run.times[k] + deepest == pytest.approx(6.76, abs=0.01)
    assert np.abs(run.energy_balance).max() < 1e-7 * run.energy_moved
