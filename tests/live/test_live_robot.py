"""The 2010 robot's run in the page equals the native one, unchanged and wherever its sliders stand."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.equations.lagrange.coordinates import basis
from tmodes.io.yaml_file import parse_yaml
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.live.map import LiveMap, live_map
from tmodes.paper.sheet import PaperRobot
from tmodes.paper.simulate import simulate
from tmodes.report.pack import pack
from tmodes.report.scene_paper import line_at
from tmodes.report.spectra import robot_spectra
from tmodes.result.record import PaperResult
from tmodes.robots.load import load

from .node import live_in_node, worst_difference

SETTINGS = 10
EQUAL = 1e-9
FINE = {"integration.relative_tolerance": 1e-12, "integration.absolute_tolerance": 1e-14}
"""Tolerances at which the integration's own error is below what is compared: at larger ones rounding decides whether a
step is taken or tried again, and either way is right within the tolerance."""

LAST_DIGITS = (1 + 4e-16, 1 - 3e-16)
"""Factors that change the last digit of a number."""

TIMES = 4.0
"""How many times as far as native runs go apart by one last digit the page may be from them: of what rounding does
two runs are a small sample. Measured: 1.7 at most, at twenty settings."""


@pytest.fixture(scope="module")
def seed() -> PaperRobot:
    sheet = load("filipovic2010")
    assert isinstance(sheet, PaperRobot)
    return sheet


@pytest.fixture(scope="module")
def live(seed: PaperRobot) -> LiveMap:
    return live_map(seed.pair())


def drawn(live: LiveMap, count: int) -> list[list[float]]:
    """Random values of all sliders within their ranges."""
    generator = np.random.default_rng(5)
    settings = []
    for _ in range(count):
        shares = generator.uniform(size=len(live.sliders))
        settings.append([
            s.low * (s.high / s.low) ** share if s.log else s.low + (s.high - s.low) * share
            for s, share in zip(live.sliders, shares.tolist(), strict=True)
        ])  # fmt: skip
    return settings


def in_page(robot: PaperRobot, live: LiveMap, folder: Path) -> list[dict[str, Any]]:
    """The unchanged run, then those at random settings."""
    bundle = live_bundle(simulate(robot))
    assert bundle is not None
    return live_in_node(bundle, [[slider.value for slider in live.sliders], *drawn(live, SETTINGS)], folder)


@pytest.fixture(scope="module")
def runs(seed: PaperRobot, live: LiveMap, tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    return in_page(seed, live, tmp_path_factory.mktemp("live"))


def scales(data: Any) -> dict[str, float]:
    """Sizes of what is a small difference of large numbers: by these, and by nothing smaller, it is rounded."""
    energy = data["energy"].values
    moved = max(float(np.abs(energy - energy[0]).max()), float(np.abs(data["work"].values).max()))
    bent = float(np.abs(data["deformation"].values).max())
    return {"energy_balance": moved, "deformation_oscillatory": bent, "deformation_stationary": bent}


def own_difference(result: PaperResult, names: Iterable[str]) -> float:
    """The largest difference of any series of the native run from that of a robot whose gear is stiffer by a digit."""
    robot = result.robot
    others = [simulate(robot.with_({"gear.stiffness": robot.gear.stiffness * factor})).data for factor in LAST_DIGITS]
    size = scales(result.data)
    return max(worst_difference({name: other[name].values for name in names}, result.data, size)[0] for other in others)


def native_runs(robot: PaperRobot, live: LiveMap) -> Iterator[PaperResult]:
    """By the method that the unchanged run took, as the page does."""
    yield simulate(robot)
    for values in drawn(live, SETTINGS):
        yield simulate(robot.with_(live.changes(values) | {"integration.method": "dormand_prince"}))


def test_page_equals_native_run_unchanged_and_at_ten_random_settings(
    seed: PaperRobot, live: LiveMap, tmp_path: Path
) -> None:
    """Every series along time, as `tmodes run --set PATH=VALUE` of each changed number gives it."""
    fine = seed.with_(FINE)
    for run, result in zip(in_page(fine, live, tmp_path), native_runs(fine, live), strict=True):
        assert run["status"] == result.status == "finished"
        info = {name for name, one in result.data.items() if "time" in one.dims and "s" not in one.dims}
        assert set(run["series"]) == info
        difference, name = worst_difference(run["series"], result.data, scales(result.data))
        assert difference < EQUAL, name


def test_page_equals_native_run_at_its_own_tolerance(
    seed: PaperRobot, live: LiveMap, runs: list[dict[str, Any]]
) -> None:
    """The tip's path to 1e-9, as unchanged all series; else as near as native runs are by which a last digit differs.

    The run is limited by stability there, and rounding decides which steps are rejected.
    """
    for k, (run, result) in enumerate(zip(runs, native_runs(seed, live), strict=True)):
        difference, name = worst_difference(run["series"], result.data, scales(result.data))
        assert difference < (TIMES * own_difference(result, run["series"]) if k else EQUAL), name
        tips = {name: run["series"][name] for name in ("tip", "tip_reference", "deviation", "q", "q_reference")}
        assert worst_difference(tips, result.data, {})[0] < EQUAL


def test_picture_is_that_of_the_result(seed: PaperRobot, runs: list[dict[str, Any]]) -> None:
    """The elastic line at the display frames, and its bending moment and deflection along each mode."""
    data, bundle = simulate(seed).data, live_bundle(simulate(seed))
    assert bundle is not None
    at = data.isel(time=bundle["frames"])
    line = at["line"].transpose("time", "mode", "s", "axis").values
    assert np.abs(runs[0]["scene"]["line"] - line).max() < EQUAL * np.abs(line).max()
    for quantity in runs[0]["line"]["quantities"]:
        true = at[quantity["id"]].transpose("time", "mode", "s", "plane").values
        assert np.abs(quantity["values"] - true).max() < EQUAL * np.abs(true).max(), quantity["id"]
    assert np.abs(np.linalg.norm(runs[0]["scene"]["roots"], axis=-1) - 1).max() < 1e-14


def test_headline_numbers_are_those_of_the_summary(seed: PaperRobot, runs: list[dict[str, Any]]) -> None:
    summary, facts = simulate(seed).summary(), runs[0]["facts"]
    expected = {
        "deviation.max": summary["deviation"]["max_m"],
        "moment.max": abs(summary["largest_bending_moment"]["value_Nm"]),
        "gear_torque.max": summary["gear_torque"]["max_Nm"],
        "contact.mean": summary["contact_force_radial"]["mean_N"],
    }
    assert {name: facts[name]["value"] for name in expected} == pytest.approx(expected, rel=EQUAL)


def test_saved_sheet_is_that_of_the_settings(seed: PaperRobot, live: LiveMap, runs: list[dict[str, Any]]) -> None:
    """The YAML of the page loads to the robot that the same changes give."""
    for values, run in zip([[s.value for s in live.sliders], *drawn(live, SETTINGS)], runs, strict=True):
        data, _ = parse_yaml(run["sheet"], "page")
        assert PaperRobot.from_data(data) == seed.with_(live.changes(values))


def test_bundle_of_a_saved_result_is_the_same(seed: PaperRobot, tmp_path: Path) -> None:
    """A report that is made later, from the file."""
    result = simulate(seed)
    first, again = live_bundle(result), live_bundle(PaperResult.load(result.save(tmp_path / "result.nc")))
    assert first is not None
    assert again is not None
    assert pack(again) == pack(first)


def test_what_cannot_start_is_reported(seed: PaperRobot, live: LiveMap, tmp_path: Path) -> None:
    """A payload that the link does not carry, as the native run tells it."""
    bundle = live_bundle(simulate(seed))
    assert bundle is not None
    values = [1e3 if slider.path == "payload.mass" else slider.value for slider in live.sliders]
    (run,) = live_in_node(bundle, [values], tmp_path)
    assert "no static equilibrium" in run["error"]


def test_runs_that_a_page_cannot_make_say_why(seed: PaperRobot) -> None:
    stopped = simulate(seed.with_({"integration.stop": ["theta.position > 0.3 rad"]}))
    assert live_bundle(stopped) is None
    assert "did not reach its end" in why_not_live(stopped)
    free = simulate(seed.with_({"integration.stop": ["theta.position > 3 rad"]}))
    assert "condition" in why_not_live(free)


def test_ghost_and_spectra_are_those_of_the_changed_run(
    seed: PaperRobot, live: LiveMap, runs: list[dict[str, Any]]
) -> None:
    """The reference without elasticity; the time of which the report's spectra are, unchanged and of another move."""
    for run, result in list(zip(runs, native_runs(seed, live), strict=True))[:3]:
        spans = [draft.span for draft in robot_spectra(result.data)]
        start, end = run["span"]
        within = [time for time in run["times"] if start - 1e-9 <= time <= end + 1e-9]
        assert spans[0] == pytest.approx((within[0], within[-1]), abs=1e-12)
    data = simulate(seed).data.sel(time=runs[0]["scene"]["times"], method="nearest")
    straight = line_at(seed.pair().real, data["q_reference"].values[:, 5:] * basis()[:, 0], data["s"].values)
    assert np.abs(runs[0]["scene"]["referenceRigid"] - straight).max() < EQUAL


def test_what_needs_the_end_is_not_reported_without_it(seed: PaperRobot, live: LiveMap, tmp_path: Path) -> None:
    """A run that breaks off."""
    bundle = live_bundle(simulate(seed))
    assert bundle is not None
    first = [slider.value for slider in live.sliders]
    (broken,) = live_in_node({**bundle, "settings": bundle["settings"] | {"maxSteps": 60}}, [first], tmp_path)
    assert broken["status"] != "finished"
    assert broken["scene"]["times"][-1] == broken["times"][-1] < bundle["times"][-1]
    facts = broken["facts"]
    assert {facts[name]["note"] for name in ("settling", "vibration.residual")} == {"the run broke off"}
    assert facts["deviation.max"]["note"].startswith("until it broke off: at ")
