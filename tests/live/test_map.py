"""What a page computes from its sliders is what the data sheet gives for the same numbers."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import tmodes.live.map as map_module
from tmodes import load
from tmodes.live.map import LiveMap, _onward, live_map
from tmodes.live.numbers import run_numbers, whole_moves
from tmodes.live.sliders import MOST
from tmodes.simulation.loop import whole
from tmodes.simulation.plan import Follow

from .chain import chain

SHEETS = ("filipovic2010", "spong1987", "quanser_2dsfl", "flexarm1990")
REACH = 2.5


def drawn(live: LiveMap, generator: np.random.Generator) -> list[float]:
    return [float(generator.uniform(slider.low, slider.high)) for slider in live.sliders]


@pytest.mark.parametrize("name", SHEETS)
def test_numbers_are_those_of_the_changed_sheet(name: str) -> None:
    """Parameters and signals of every run, at random values of all sliders."""
    sheet = load(name)
    live = live_map(sheet.pair())
    generator = np.random.default_rng(3)
    for _ in range(3):
        values = drawn(live, generator)
        pair = sheet.with_(live.changes(values)).pair()
        for run in live.forms:
            of = pair.nominal if run == "reference" else pair.real
            true = run_numbers(of, Follow.SHEET if run == "real" else Follow.WANTED, whole_moves(sheet, REACH))
            found = live.numbers(values, run)
            assert list(found) == list(true)
            size = np.abs(whole(true)[0]).max()
            for block, numbers in true.items():
                assert found[block] == pytest.approx(numbers, rel=1e-12, abs=1e-15 * size), (run, block)


@pytest.mark.parametrize("name", SHEETS)
def test_sliders_stay_within_the_checks_of_the_sheet(name: str) -> None:
    """All at their least, and all at their largest value; a label, a unit and a group each."""
    sheet = load(name)
    live = live_map(sheet.pair())
    assert 5 <= len(live.sliders) <= MOST
    for ends in zip(*((slider.low, slider.high) for slider in live.sliders), strict=True):
        sheet.with_(live.changes(list(ends))).pair()
    for slider in live.sliders:
        assert slider.low < slider.high
        assert slider.low <= slider.value <= slider.high
        assert slider.label
        assert slider.unit
        assert slider.group


def test_sliders_of_the_2010_robot_are_what_one_wants_to_change() -> None:
    """Payload, gear and link, nominal and actual, speed of the move, gains, environment."""
    paths = {slider.path for slider in live_map(load("filipovic2010").pair()).sliders}
    assert {"links.link.bodies.payload.mass", "links.link.beam.modes.1.bending_stiffness", "drives.0.signal.duration",
            "drives.0.controller.position_gain", "contact.stiffness"} <= paths  # fmt: skip
    assert any(path.startswith("real:joints.joint.gear.stiffness") for path in paths)


@pytest.mark.parametrize("count", [2, 3])
def test_a_real_robot_without_a_damping_has_a_map(count: int) -> None:
    """Factor 0 on what has a slider of its own (2 joints), and on what moves in proportion (3)."""
    sheet = chain(count).with_({f"real.joints.j{k}.gear.damping": 0.0 for k in range(count)})
    live = live_map(sheet.pair())
    assert any(slider.path.endswith("gear.damping") for slider in live.sliders)
    values = drawn(live, np.random.default_rng(3))
    true = run_numbers(sheet.with_(live.changes(values)).pair().real, Follow.SHEET, whole_moves(sheet, REACH))
    for block, numbers in live.numbers(values, "real").items():
        assert numbers == pytest.approx(true[block], rel=1e-12, abs=1e-12), block


def test_a_map_is_found_once(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """The same sheet, kinds and program: its forms are read again, to the bit; another sheet has its own."""
    (tmp_path / "cache").mkdir(mode=0o700)
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
    sheet = load("spong1987")
    first = live_map(sheet.pair())
    fitted, asked = map_module.fitted, []
    monkeypatch.setattr(map_module, "fitted", lambda *given: asked.append(given) or fitted(*given))
    again = live_map(sheet.pair())
    assert not asked
    assert (again.sliders, again.knobs, again.left_out, again.places) == (
        first.sliders, first.knobs, first.left_out, first.places
    )  # fmt: skip
    values = drawn(first, np.random.default_rng(5))
    for run in first.forms:
        assert np.array_equal(whole(first.numbers(values, run))[0], whole(again.numbers(values, run))[0])
    live_map(sheet.with_({"gravity": 9.7}).pair())
    assert asked
    asked.clear()
    monkeypatch.setattr(map_module, "outside_digest", lambda: "another kind")
    live_map(sheet.pair())
    assert asked


def test_progress_never_falls() -> None:
    """Forms are fitted anew without numbers that have none."""
    said: list[float] = []
    forward = _onward(lambda stage, share: said.append(share))
    for share in (0.0, 0.5, 0.2, 0.9):
        forward("report", share)
    assert said == [0.0, 0.5, 0.5, 0.9]
