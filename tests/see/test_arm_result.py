"""An arm's result: its numbers against closed forms and against the equations, and its file."""

from __future__ import annotations

import json

import numpy as np
import pytest

from see.runs import FORCE, LENGTH, OUTER, SHEETS, THICK, YOUNG, pendulum, result_of, run_of, sheet, tube
from tmodes.errors import InputError, ResultFileError
from tmodes.result import Result, assemble_result
from tmodes.result.run import ready_to_run, result_bytes
from tmodes.result.series import run_wrenches, straight_shape
from tmodes.result.settling import move_end
from tmodes.sheet import Robot
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion

AREA_MOMENT = np.pi / 64 * (OUTER**4 - (OUTER - 2 * THICK) ** 4)


def test_cantilever_against_closed_forms():
    """F L^3/3EI at the tip, F (L - x) along the rod, F everywhere, F L r/I at the root."""
    data = result_of("cantilever").data.isel(time=-1)
    rod, s = data.sel(bending_link="rod", stressed_link="rod"), data["s"].values
    bent = FORCE * LENGTH**3 / (3 * YOUNG * AREA_MOMENT)
    assert float(rod["deflection"].sel(plane="z").isel(s=-1)) == pytest.approx(bent, rel=1e-4)
    assert rod["moment"].sel(moment_kind="y").values == pytest.approx(-FORCE * LENGTH * (1 - s), rel=1e-3, abs=1e-4)
    assert rod["shear_force"].sel(plane="z").values == pytest.approx(FORCE, rel=1e-3)
    worst = FORCE * LENGTH * OUTER / 2 / AREA_MOMENT
    assert float(rod["stress"].isel(s=0)) == pytest.approx(worst, rel=1e-3)
    info = result_of("cantilever").summary()["links"]["rod"]
    assert info["stress"]["max_Pa"] == pytest.approx(worst, rel=1e-3)
    assert info["stress"]["s"] == 0.0
    assert info["deflection"]["max_m"] == pytest.approx(bent, rel=1e-4)


@pytest.mark.parametrize("name", SHEETS)
def test_what_is_shown_is_in_balance(name):
    """Springs and inertia of the links answer exactly the forces that are given: loads, contact and weight."""
    run = run_of(name)[1]
    forces = run.model.inverse_dynamics(run.q, run.v, run.a, wrenches=run_wrenches(run), base=run.base)
    size = np.abs(run.effort).max(initial=1.0)
    assert np.abs(forces[:, run.model.deformations]).max(initial=0.0) < 1e-8 * size


def test_series_agree_with_each_other():
    data = result_of("swinging").data
    assert data["tip"].values == pytest.approx(data["position"].sel(point="tip").values)
    assert data["line"].sel(link="rod").isel(s=10).values == pytest.approx(data["position"].sel(point="middle").values)
    gap = (data["q"].sel(coordinate="shoulder") - data["q"].sel(coordinate="shoulder.motor")).values
    gear = data["deformation"].sel(deformation_kind="shoulder.gear").values
    assert gear == pytest.approx(gap)
    parts = data["deformation_stationary"] + data["deformation_oscillatory"]
    assert parts.values == pytest.approx(data["deformation"].values)
    apart = np.linalg.norm(data["tip"].values - data["tip_nominal"].values, axis=1)
    assert data["deviation"].values == pytest.approx(apart)
    assert np.abs(data["contact_force_normal"].values).max() > 0
    assert data["link_parent"].sel(link="hand") == "rod"


def test_the_line_without_elasticity():
    """Straight, and at the motor's angle."""
    _, run = run_of("swinging")
    data = result_of("swinging").data
    theta = data["q"].sel(coordinate="shoulder.motor").values
    expected = LENGTH * np.stack([np.cos(theta), np.sin(theta), np.zeros_like(theta)], axis=1)
    assert data["line_rigid"].sel(link="rod").isel(s=-1).values == pytest.approx(expected, abs=1e-12)
    assert not straight_shape(run)[:, run.model.deformations].any()


def test_every_variable_has_unit_and_meaning():
    for name in SHEETS:
        data = result_of(name).data
        for key, variable in data.data_vars.items():
            assert variable.attrs["units"], key
            assert len(variable.attrs["long_name"]) > 2, key
            assert np.isfinite(variable.values).all(), key


def test_a_pendulum_keeps_its_energy_and_its_period():
    """Known: T = 2 pi sqrt(l/g) (1 + a^2/16 + 11 a^4/3072)."""
    data = result_of("pendulum").data
    assert "deviation" not in data
    angle = data["q"].sel(coordinate="joint").values
    crossings = np.flatnonzero(np.diff(np.sign(angle)))
    time = [np.interp(0, [-angle[k], -angle[k + 1]], data["time"].values[[k, k + 1]])
            if angle[k] > 0 else np.interp(0, angle[[k, k + 1]], data["time"].values[[k, k + 1]])
            for k in crossings]  # fmt: skip
    period = 2 * np.pi / np.sqrt(9.81) * (1 + 0.4**2 / 16 + 11 * 0.4**4 / 3072)
    assert time[1] - time[0] == pytest.approx(period / 2, rel=1e-4)
    assert data["energy"].sel(energy_kind="kinetic").max() == pytest.approx(9.81 * (1 - np.cos(0.4)), rel=1e-3)


def test_saved_and_loaded(tmp_path):
    result = result_of("swinging")
    result.save(tmp_path / "a.nc")
    back = Result.load(tmp_path / "a.nc")
    assert back.data.identical(result.data)
    assert isinstance(Result.load(tmp_path / "a.nc"), Result)
    assert back.robot == run_of("swinging")[0]
    result.save(tmp_path / "b.nc")
    assert (tmp_path / "a.nc").read_bytes() == (tmp_path / "b.nc").read_bytes()
    content = bytearray((tmp_path / "a.nc").read_bytes())
    content[len(content) // 2] ^= 1
    (tmp_path / "c.nc").write_bytes(content)
    with pytest.raises(ResultFileError, match="damaged"):
        Result.load(tmp_path / "c.nc")


def test_an_arm_without_drives_is_saved_and_loaded(tmp_path):
    """A clamped tube that is pulled at its tip: no joint moves, so there is no effort to tell."""
    joint = {"name": "wall", "type": "fixed", "parent": "base", "child": "rod"}
    pull = {"point": "tip", "force": [0, 0, FORCE], "frame": "world"}
    arm = ready_to_run(Robot.from_data(sheet(joints=[joint], links=[{"name": "rod", "beam": tube()}], loads=[pull])))
    result = assemble_result(simulate_motion(arm), arm)
    assert "effort" not in result.data
    result.save(tmp_path / "a.nc")
    assert Result.load(tmp_path / "a.nc").data.identical(result.data)
    back = Result.load(tmp_path / "a.nc")
    assert isinstance(back, Result)
    assert back.robot == arm
    assert back.summary()["joints"] == {}


@pytest.mark.parametrize(
    ("signal", "end"),
    [
        ({"type": "quintic", "start": 0.0, "end": 1.0, "duration": 0.3}, 0.3),
        ({"type": "step", "start": 0.0, "end": 1.0, "time": 0.2}, 0.2),
        ({"type": "constant", "value": 1.0}, 0.0),
        ({"type": "sine", "amplitude": 1.0, "frequency": 2.0}, None),
    ],
)
def test_when_the_move_ends(signal, end):
    arm = Robot.from_data(pendulum() | {"drives": [{"joint": "joint", "command": "effort", "signal": signal}]})
    assert move_end(planned(arm)) == (None if end is None else pytest.approx(end))


def test_an_arm_that_nothing_moves():
    data = {key: value for key, value in pendulum().items() if key != "initial"}
    with pytest.raises(InputError) as caught:
        ready_to_run(Robot.from_data(data))
    assert caught.value.which == "drives"
    assert "joint: joint" in caught.value.hint
    assert "initial" in caught.value.hint
    free = ready_to_run(Robot.from_data(pendulum()))
    assert [drive.command for drive in free.drives] == ["effort"]


def test_an_arm_that_cannot_move_needs_no_drives():
    joint = {"name": "wall", "type": "fixed", "parent": "base", "child": "rod"}
    arm = Robot.from_data(sheet(joints=[joint], links=[{"name": "rod", "bodies": [{"name": "m", "mass": 1.0}]}]))
    assert ready_to_run(arm) is arm


def test_too_large_is_reported_before():
    """Lines of three links at 501 places, 10 000 times, are 2.6 GB."""
    names = ["a", "b", "c"]
    joints = [{"name": f"j{k}", "type": "revolute", "child": name, "axis": [0, 0, 1]} for k, name in enumerate(names)]
    joints[0]["parent"] = "base"
    links = [{"name": name, "beam": tube()} for name in names]
    dense = {"duration": 10.0, "output_step": 1e-3, "line_points": 501}
    arm = Robot.from_data(sheet(joints=joints, links=links, integration=dense))
    with pytest.raises(InputError, match="line_points"):
        result_bytes(arm)
    assert result_bytes(arm.with_({"integration.line_points": 51})) < 1e9


def test_a_lost_energy_balance_ends_the_run_where_it_is_wished():
    """RK4 with steps that are too long loses energy; the sheet asks to stop there."""
    coarse = {"duration": 2.0, "output_step": 0.05, "method": "rk4", "step": 0.05, "energy_stop": True,
              "energy_tolerance": 1e-9}  # fmt: skip
    arm = ready_to_run(Robot.from_data(pendulum() | {"integration": coarse}))
    result = assemble_result(simulate_motion(arm), arm)
    assert result.status == "stopped"
    assert "energy balance" in result.message
    assert float(result.data["time"][-1]) < 2.0


def test_provenance():
    attributes = result_of("swinging").data.attrs
    assert attributes["kind"] == "arm"
    real = json.loads(attributes["robot_real"])
    assert real["joints"][0]["gear"]["stiffness"] == pytest.approx([720.0])
    assert json.loads(attributes["robot"])["joints"][0]["gear"]["stiffness"] == pytest.approx([900.0])
    assert {"real", "reference"} == set(json.loads(attributes["statistics"]))
    assert result_of("swinging").frequencies["locked"][0]["frequency_Hz"] > 0
