# pyright: reportAttributeAccessIssue=false
"""The ladder: its rungs are models with known errors, its move is followed exactly, its advice is the cheapest."""

from __future__ import annotations

import json
import subprocess
import sys
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from arm.analysis.sheets import clamped_sheet
from tmodes.analysis.hierarchy.hierarchy import Ladder, ladder
from tmodes.analysis.hierarchy.move import chosen_move, followed
from tmodes.analysis.hierarchy.variants import driven, input_mix, moved_chain, rungs, whole_chain
from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.errors import InputError
from tmodes.model.model import Model
from tmodes.sheet import Robot

LENGTH, EI, MASS = 0.7, 12.0, 1.1


def sheet(**changes: Any) -> dict[str, Any]:
    """A bare beam on a driven hinge about z, behind an elastic gear where asked."""
    beam = {"model": "strain", "functions": {"bend_z": 2}, "basis": "legendre", "length": LENGTH, "damping_time": 1e-3,
            "rotary_inertia": "none", "section": {"bending_stiffness": EI, "mass_per_length": MASS}}  # fmt: skip
    joint = {"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
             **changes.pop("joint", {})}  # fmt: skip
    rod = {"name": "rod", "beam": beam}
    return {
        "format": 1,
        "kind": "arm",
        "name": "slewing",
        "gravity": [0, 0, 0],
        "joints": [joint],
        "links": [rod],
        **changes,
    }


ELASTIC = {"motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 300.0, "damping": 1.0}}


@pytest.fixture(scope="module")
def climbed() -> Ladder:
    return ladder(Robot.from_data(sheet()), 3e-2, finest=4)


def test_rungs_are_all_models(climbed: Ladder) -> None:
    names = ["rigid", "segments(1)", "segments(2)", "segments(3)", "strain(1)", "strain(2)", "strain(3)", "strain(4)"]
    assert [rung.model for rung in climbed.rungs] == names
    assert [rung.coordinates for rung in climbed.rungs] == [1, 2, 3, 4, 2, 3, 4, 5]


@pytest.mark.parametrize(("model", "percent"), [
    ("strain(1)", 27.193), ("strain(2)", 0.47543), ("strain(3)", 0.03017), ("segments(1)", -18.8), ("segments(2)", 31)
])  # fmt: skip
def test_first_frequency_is_off_by_what_is_known_of_each_model(climbed: Ladder, model: str, percent: float) -> None:
    """Errors of a clamped bare beam against 1.8751^2 sqrt(EI/rhoA L^4), in %."""
    exact = 1.875104068712**2 * np.sqrt(EI / (MASS * LENGTH**4)) / (2 * np.pi)
    found = next(rung for rung in climbed.rungs if rung.model == model)
    assert 100 * (found.frequencies_Hz[0] / exact - 1) == pytest.approx(percent, rel=0.03)
    assert found.frequency_error == pytest.approx(abs(percent) / 100, rel=0.05)


def test_errors_fall_and_the_fewest_coordinates_within_the_tolerance_are_advised(climbed: Ladder) -> None:
    strains = [rung.tip_error for rung in climbed.rungs[4:]]
    assert all(a is not None and b is not None and a > b for a, b in pairwise(strains))
    assert strains[-1] == 0.0
    assert climbed.rungs[0].tip_error == pytest.approx(1.0)
    good = [rung for rung in climbed.rungs if rung.within(climbed.tolerance)]
    assert climbed.recommended in {rung.model for rung in good}
    assert climbed.recommended == "strain(2)"
    assert climbed.converged
    assert all(rung.cost_us > 0 for rung in climbed.rungs)


def test_highest_eigenvalue_is_that_of_the_undamped_beam() -> None:
    """w_max of three functions, free tip: 118 sqrt(EI/rhoA L^4)."""
    data = sheet()
    data["links"][0]["beam"]["damping_time"] = 0.0
    found = ladder(Robot.from_data(data), 0.5, finest=3)
    assert found.rungs[-1].highest_eigenvalue == pytest.approx(118 * np.sqrt(EI / (MASS * LENGTH**4)), rel=0.01)


def test_the_move_is_that_of_the_model_with_its_motor_given() -> None:
    """An elastic gear, its motor prescribed: against SciPy on the arm itself, the motor's row left out."""
    arm = Robot.from_data(sheet(joint=ELASTIC))
    whole, model = Model(whole_chain(arm)), Model(moved_chain(whole_chain(arm)))
    assert whole.coordinates == ("hub.motor", "hub", "rod.bend_z1", "rod.bend_z2")
    assert model.coordinates == ("hub.input", "hub", "rod.bend_z1", "rod.bend_z2")
    move = chosen_move(arm, 3.0)
    assert move.times[-1] == pytest.approx(1.3)
    q, _ = followed(model, move, np.zeros(4), 1e-9)

    def rate(t: float, y: np.ndarray) -> np.ndarray:
        place, speed, gain = (float(move.at(t, k)[0]) for k in range(3))
        x, v = np.array([place, place + y[0], *y[1:3]]), np.array([speed, speed + y[3], *y[4:]])
        forces = whole.inverse_dynamics(x, v, np.array([gain, gain, 0, 0]))[1:]
        return np.concatenate([y[3:], -np.linalg.solve(whole.mass_matrix(x)[1:, 1:], forces)])

    run = solve_ivp(rate, (0, move.times[-1]), np.zeros(6), t_eval=move.times, rtol=1e-9, atol=1e-12, method="DOP853")
    assert np.abs(q[:, 1:] - run.y[:3].T).max() < 1e-5 * np.abs(run.y[:3]).max()
    assert np.abs(q[:, 0] - move.at(move.times)[:, 0]).max() == 0.0


def test_own_drives_are_the_move_where_they_are_smooth() -> None:
    signal = {"type": "trapezoid", "start": 0.1, "end": 0.4, "duration": 0.8, "ramp_fraction": 0.3}
    drive = {"joint": "hub", "command": "prescribed", "signal": signal}
    smooth = chosen_move(Robot.from_data(sheet(drives=[drive], integration={"duration": 1.0})), 3.0)
    assert "own drives" in smooth.words
    assert smooth.at(0.8)[0] == pytest.approx(0.4)
    assert np.isin(np.round([0.24, 0.56, 0.8], 12), np.round(smooth.times, 12)).all()
    jump = {**drive, "signal": {"type": "step", "start": 0.1, "end": 0.3, "time": 0.2}}
    stepped = chosen_move(Robot.from_data(sheet(drives=[jump])), 3.0)
    assert "quintic" in stepped.words
    assert stepped.at([0.0, 1.3])[:, 0] == pytest.approx([0.1, 0.3])


def test_couplings_mix_the_motors() -> None:
    second = {"name": "elbow", "type": "revolute", "parent": "rod", "child": "tool", "axis": [0, 0, 1], **ELASTIC}
    data = sheet(joint=ELASTIC, couplings={"elbow": {"hub": -0.5, "elbow": 1.0}})
    data["joints"].append(second)
    data["links"].append({"name": "tool", "bodies": [{"name": "b", "mass": 0.2, "center": [0.1, 0, 0]}]})
    arm = Robot.from_data(data)
    assert [joint.name for joint in driven(whole_chain(arm))] == ["hub", "elbow"]
    assert input_mix(whole_chain(arm)).tolist() == [[1.0, 0.0], [-0.5, 1.0]]
    moved = moved_chain(whole_chain(arm))
    assert [node.parent for node in moved.nodes] == [-1, 0, 1, 2]


def test_directions_that_do_not_bend_stay_so() -> None:
    for name, arm in rungs(Robot.from_data(sheet()), 3):
        beam = arm.link("rod").beam
        assert beam is not None
        assert beam.functions is not None
        assert (beam.functions.bend_y, beam.functions.twist) == (0, 0)
        if name.startswith("strain"):
            assert beam.functions.bend_z == int(name[7])


def test_an_arm_without_beams_and_a_foolish_tolerance_are_refused() -> None:
    data = sheet()
    data["links"] = [{"name": "rod", "bodies": [{"name": "b", "mass": 1.0, "center": [0.2, 0, 0]}]}]
    with pytest.raises(InputError, match="beam"):
        ladder(Robot.from_data(data))
    for tolerance in (0.0, -1.0, 1.0, float("nan")):
        with pytest.raises(InputError, match="tolerance"):
            ladder(Robot.from_data(sheet()), tolerance)


def test_command_reports_the_ladder(tmp_path: Any) -> None:
    file = tmp_path / "slewing.yaml"
    file.write_text(json.dumps(sheet()), encoding="utf-8")  # which is YAML too
    command = [sys.executable, "-m", "tmodes.cli.main", "ladder", str(file), "--finest", "3", "--tolerance", "0.05"]
    done = subprocess.run([*command, "--json"], capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stderr
    info = json.loads(done.stdout)
    assert info["recommended"] == "strain(2)"
    assert len(info["rungs"]) == 7
    assert set(info["units"]) <= {*info, *info["rungs"][0]}
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=300)
    assert "<- take this" in done.stdout
    assert "the cheapest is strain(2)" in done.stdout


def test_a_clamped_beam_has_a_rigid_rung_without_coordinates():
    """On the rigid rung nothing moves: it is off by the whole sag; the finest first frequency is 5.596 Hz."""
    found = ladder(Robot.from_data(clamped_sheet()), finest=3)
    assert (found.rungs[0].coordinates, found.rungs[0].frequencies_Hz) == (0, ())
    assert found.rungs[0].tip_error == pytest.approx(1.0, rel=1e-6)
    exact = 1.8751040687119611**2 * 10 / (2 * np.pi)
    assert found.rungs[-1].frequencies_Hz[0] == pytest.approx(exact, rel=1e-3)


def test_modes_are_rungs_of_a_straight_beam_that_bends_alike_in_both_planes() -> None:
    """One mode is one segment; two have their masses at other places. Modes of a modes link of as many are its own."""
    given = sheet()
    given["links"][0]["beam"]["functions"] = {"bend_y": 1, "bend_z": 1}
    found = dict(rungs(Robot.from_data(given), 1))
    assert [name for name in found if name.startswith("modes")] == ["modes(1)", "modes(2)", "modes(3)"]
    first = {
        name: sheet_frequencies(arm)["locked"][0]["frequency_Hz"] for name, arm in found.items() if name != "rigid"
    }
    assert first["modes(1)"] == pytest.approx(first["segments(1)"], rel=1e-9)
    assert found["modes(3)"].links[0].beam is not None
    assert found["modes(3)"].links[0].beam.coordinate_count == 6
    assert found["modes(3)"].links[0].beam.section_pieces()[1].start.bend_z == pytest.approx(EI)
    again = dict(rungs(found["modes(2)"], 1))
    assert again["modes(2)"].links == found["modes(2)"].links
    assert not any(name.startswith("modes") for name, _ in rungs(Robot.from_data(sheet()), 1))
