"""The Result: what it says, what it saves, what it gives back."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import tmodes
from result.synthetic import synthetic_result
from tmodes.analysis.energy import energy_lost, largest_flow
from tmodes.errors import InputError, ResultFileError
from tmodes.io.resultfile import write_sealed
from tmodes.result import Result


@pytest.fixture(scope="module")
def result() -> Result:
    return synthetic_result(False, samples=101)


def test_it_reports_how_the_run_went(result: Result) -> None:
    assert result.success
    assert result.status == "finished"
    assert result.message
    assert result.warnings == ()
    assert result.frequencies["locked"][0]["frequency_Hz"] == pytest.approx(4.9957, abs=5e-5)
    assert result.statistics["real"]["steps"] > 0
    assert "xarray" in result._repr_html_()
    assert not Result(result.data.assign_attrs(status="diverged")).success


def test_its_robot_is_the_one_that_ran(result: Result) -> None:
    known = tmodes.load("filipovic2010").with_({"contact": False})
    assert result.robot == known.model_copy(update={"integration": result.robot.integration})


@pytest.mark.parametrize("contact", [True, False])
def test_it_comes_back_whole(contact: bool, tmp_path: Path) -> None:
    result = synthetic_result(contact, samples=101)
    back = Result.load(result.save(tmp_path / "run.nc"))
    assert back.data.identical(result.data)
    assert ("contact_force" in back.data) == contact
    assert back.summary() == result.summary()


def test_an_existing_file_is_kept_unless_asked(tmp_path: Path) -> None:
    path = tmp_path / "run.nc"
    path.write_text("old")
    with pytest.raises(ResultFileError, match="overwrite=True"):
        synthetic_result(samples=11).save(path)
    assert path.read_text() == "old"
    synthetic_result(samples=11).save(path, overwrite=True)
    assert Result.load(path).data.sizes["time"] == 11


def test_a_number_that_is_not_finite_is_never_saved(tmp_path: Path) -> None:
    for value in (np.nan, np.inf):
        result = synthetic_result(samples=11)
        result.data["tip"][3, 1] = value
        with pytest.raises(ResultFileError, match="variable tip"):
            result.save(tmp_path / "run.nc")
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("attribute", "value"),
    [("tmodes_format", 2), ("tmodes_format", 0), ("tmodes_format", "1"), ("status", "fine"), ("kind", "ship")],
)
def test_another_version_kind_or_status_is_refused(attribute: str, value: int | str, tmp_path: Path) -> None:
    write_sealed(synthetic_result(samples=11).data.assign_attrs({attribute: value}), tmp_path / "run.nc")
    with pytest.raises(ResultFileError, match=str(value) if attribute == "kind" else attribute):
        Result.load(tmp_path / "run.nc")


def test_what_is_missing_is_named(tmp_path: Path) -> None:
    data = synthetic_result(samples=11).data
    write_sealed(data.drop_vars("energy"), tmp_path / "series.nc")
    with pytest.raises(ResultFileError, match=r"series.nc, energy"):
        Result.load(tmp_path / "series.nc")
    del data.attrs["statistics"]
    write_sealed(data, tmp_path / "attribute.nc")
    with pytest.raises(ResultFileError, match=r"attribute.nc, statistics"):
        Result.load(tmp_path / "attribute.nc")


def test_attributes_that_are_missing_or_rubbish_are_named(result: Result) -> None:
    for value in ("{", "[" * 100_000):
        with pytest.raises(ResultFileError, match="frequencies"):
            _ = Result(result.data.assign_attrs(frequencies=value)).frequencies
    bare = result.data.copy()
    del bare.attrs["warnings"]
    with pytest.raises(ResultFileError, match="attribute warnings"):
        _ = Result(bare).warnings


def test_the_summary_is_plain_json(result: Result) -> None:
    summary = result.summary()
    assert json.loads(json.dumps(summary, allow_nan=False)) == summary


def test_the_summary_finds_what_was_put_in() -> None:
    """Known numbers planted in the dataset come out."""
    result = synthetic_result(samples=201)
    data = result.data
    data["deviation"][:] = 1e-3
    data["deviation"][150] = 4e-3
    data["moment"][:] = 0.0
    data["moment"][40, 1, 2, 1] = -99.0
    data["gear_torque"][:, 0] = np.linspace(-3.0, 2.0, 201)
    data["effort"][:, 0] = np.linspace(-1.0, 5.0, 201)
    data["contact_force_normal"][:] = np.linspace(4.0, 6.0, 201)
    data["deformation"][:] = 2e-3
    data["deformation"][30, 0] = -4e-3
    data["deformation_nominal"][:] = 1e-3
    data["energy"][:] = 0.0
    data["work"][:] = 0.0
    data["work"][:, 0] = np.linspace(0.0, 8.0, 201)
    data["energy_balance"][:] = 0.0
    data["energy_balance"][77] = -4e-6
    summary = result.summary()
    assert summary["status"] == "finished"
    locked = [mode["frequency_Hz"] for mode in result.frequencies["locked"]]
    assert summary["first_frequency_Hz"]["locked"] == min(locked)
    assert summary["deviation"] == {"max_m": 4e-3, "time_of_max_s": 1.5, "end_m": 1e-3}
    assert summary["links"]["link.2"]["bending_moment"] == pytest.approx({"max_Nm": 99.0, "time_s": 0.4, "s": 0.5})
    joint = summary["joints"]["joint"]
    assert joint["largest_gear_torque"] == pytest.approx(3.0)
    assert (joint["largest_effort"], joint["time_of_largest_effort_s"]) == pytest.approx((5.0, 2.0))
    force = summary["contact_force"]
    assert [force[name] for name in ("min_N", "max_N", "mean_N")] == pytest.approx([4.0, 6.0, 5.0])
    gear = summary["deformations"]["joint.gear"]
    assert (gear["max"], gear["time_of_max_s"], gear["max_nominal"]) == pytest.approx((4e-3, 0.3, 1e-3))
    energy = {"moved_J": 8.0, "worst_residual_J": 4e-6, "worst_residual_over_moved": 5e-7}
    assert summary["energy"] == pytest.approx(energy)


def settling(deviation_after: list[float], duration: float = 4.0, band: float = 0.05) -> dict[str, float | str | None]:
    """Settling of a run of 401 samples at distances from rest after the move (2 s) as given, and of 1 m at 1 s."""
    result = synthetic_result(duration=duration, samples=401)
    result.data["tip"][:] = 0.3
    result.data["tip_velocity"][:] = 0.0
    result.data["tip"][100, 0] += 1.0
    for place, value in zip((250, 300, 400), deviation_after, strict=False):
        result.data["tip"][place, 0] += value
    return result.summary(band)["settling"]


def test_settling_is_the_last_time_out_of_the_band() -> None:
    share = 0.5 - np.sin(np.arcsin(1 - 2 / 6) / 3)  # of 0.06 (1 - 3 s^2 + 2 s^3) = 0.05
    assert 3 * share**2 - 2 * share**3 == pytest.approx(1 / 6)
    assert settling([0.06, 0.04, 0.0])["time_s"] == pytest.approx(0.5 + 0.01 * share, abs=1e-9)
    assert settling([0.06, 0.051, 0.0])["time_s"] == pytest.approx(1.0, abs=0.01)
    assert settling([0.06, 0.04, 0.0], band=0.02)["time_s"] == pytest.approx(1.0 + 0.01 / 2, abs=1e-9)
    assert settling([0.0, 0.0, 0.0])["time_s"] == 0.0


def test_settling_that_cannot_be_given_has_a_reason() -> None:
    still = settling([0.0, 0.0, 0.06])
    assert still["time_s"] is None
    assert "still moves by" in str(still["reason"])
    cut = settling([0.0], duration=2.0)
    assert cut["time_s"] is None
    assert "the run ends at 2 s, the move at 2 s" in str(cut["reason"])
    with pytest.raises(InputError, match="band"):
        settling([0.0], band=1.5)


def test_the_summary_of_a_run_that_stopped_at_once() -> None:
    summary = Result(synthetic_result(False).data.isel(time=slice(0, 1))).summary()
    assert summary["settling"]["time_s"] is None
    assert summary["contact_force"] is None
    assert json.dumps(summary, allow_nan=False)


def test_mean_force_counts_time_not_samples() -> None:
    """The last sample may follow a shorter step."""
    data = synthetic_result(samples=11).data.isel(time=[0, 5, 10]).assign_coords(time=[0.0, 1.0, 1.5])
    data["contact_force_normal"][:] = [0.0, 0.0, 3.0]
    assert Result(data).summary()["contact_force"]["mean_N"] == pytest.approx(0.5)


def test_rounding_of_a_steady_motion_is_no_lost_energy() -> None:
    """No energy changes and no work is done: what is off is measured by the kinetic energy."""
    residual = np.array([0.0, 8e-12])
    moved = largest_flow(np.array([[23.5, 1.0], [23.5 + 8e-12, 1.0]]), np.zeros((2, 3)))
    assert moved == pytest.approx(23.5)
    assert energy_lost(residual, moved, 23.5, 1e-6) is None
    assert energy_lost(residual * 1e7, moved, 23.5, 1e-6) == 1


def test_rounding_of_a_robot_at_rest_is_no_lost_energy() -> None:
    """A setpoint of a million rad, known to 1e-10 rad: all that moves is that, and nothing of the energy is lost."""
    held = {"drives.0.signal": {"type": "constant", "value": 1e6}, "integration.duration": 0.5}
    found = tmodes.run(tmodes.load("spong1987").with_(held))
    assert not any("energy" in warning for warning in found.warnings)
    assert found.summary()["energy"]["worst_residual_over_moved"] is None
    assert energy_lost(np.array([0.0, 6.6e-10]), 6.6e-10, 9.4, 1e-6) is None
    assert energy_lost(np.array([0.0, 6.6e-10]), 6.6e-10, 1e-2, 1e-6) == 1
