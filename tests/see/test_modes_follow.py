"""The modes of a live report follow its sliders: table, the mode that swings, marks; those of an arm a little later."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from typing import Any

import pytest

from live.chain import chain
from see.looking import look
from see.scenes import short_report, short_robot
from tmodes import load, run
from tmodes.report.data import live_page, modes_of
from tmodes.report.parts import viewer_document
from tmodes.result import assemble_result
from tmodes.simulation.simulate import simulate_motion

pytestmark = pytest.mark.nightly

STATUS = ".sliders-panel [role=status]"
PANEL = ".lower section[aria-label='Modes of vibration']"
GAIN = "drives.0.controller.position_gain"


def of_robot(changes: dict[str, float]) -> Any:
    return run(short_robot().with_(changes))


def of_arm(changes: dict[str, float]) -> Any:
    arm = chain(2).with_(changes)
    return assemble_result(simulate_motion(arm), arm)


def of_pids(changes: dict[str, float]) -> Any:
    return run(load("two_link_arm").with_({"integration.duration": 0.5, **changes}))


KINDS = {
    "robot": (of_robot, "links.link.bodies.payload.mass", 0.9, {"payload.mass": 0.9}),
    "arm": (of_arm, "joints.j0.gear.stiffness.0", 250.0, {"joints.j0.gear.stiffness.0": 250.0}),
    "pids": (of_pids, GAIN, 30.0, {GAIN: 30000.0}),  # the page shows kN·m/rad
}


@cache
def report_of(kind: str) -> str:
    """The page of a kind of robot, made once."""
    return short_report() if kind == "robot" else viewer_document(live_page(KINDS[kind][0]({})))


@pytest.fixture(scope="module", params=[*KINDS])
def opened(request: Any, browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[tuple[Any, ...]]:
    """A report, its slider with a new value, and the native result of that value."""
    make, slider, value, changes = KINDS[request.param]
    path = tmp_path_factory.mktemp("modes") / "report.html"
    path.write_text(report_of(request.param), encoding="utf-8")
    window = look(browser, path, (1280, 1000), unfolded=True)
    window.page.wait_for_selector(f"{STATUS}:text('Move a slider')")
    yield window, slider, value, make(changes)
    assert window.said == []
    window.page.context.close()


def give(window: Any, slider: str, value: float) -> None:
    window.page.locator(f'[data-path="{slider}"] input.number').fill(str(value))
    window.page.wait_for_selector(f"{PANEL} .note:text('under each number')")


def info(window: Any) -> list[float]:
    """The frequencies in the table, without those that were."""
    cells = window.page.locator(f"{PANEL} tbody tr td:first-child").all()
    return [float(cell.inner_text().split("\n")[0]) for cell in cells]


def test_the_table_reports_the_modes_of_the_changed_robot(opened: tuple[Any, ...]) -> None:
    window, slider, value, result = opened
    give(window, slider, value)
    wanted = [mode["frequency"] for mode in modes_of(result) if mode["case"] == "controlled"]
    assert info(window) == pytest.approx(wanted, rel=1e-3)
    assert "was" in window.page.locator(f"{PANEL} tbody").inner_text()
    fact = window.page.locator("[data-fact='frequency.first']").inner_text()
    assert "was" in fact
    assert "original" not in fact
    for tab in window.page.locator("[data-group=spectrum]").all():  # the robot's run is too short for one
        tab.click()
        window.page.wait_for_selector("[data-chart=spectrum_tip] canvas")
        assert window.page.get_by_text("The marked frequencies are of the run as it was").first.is_hidden()


def test_the_mode_that_swings_goes_on_as_it_is_now_and_the_way_back(opened: tuple[Any, ...]) -> None:
    window, slider, value, _ = opened
    give(window, slider, value)
    window.page.get_by_role("button", name="reset all").click()
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    before = info(window)
    window.page.locator(f"{PANEL} tbody button").first.click()
    give(window, slider, value)
    assert window.page.locator(f"{PANEL} tbody button").first.inner_text() == "stop"
    window.page.get_by_role("button", name="back to the motion").click()
    window.page.get_by_role("button", name="reset all").click()
    window.page.wait_for_selector(f"{STATUS}:text('as it was.')")
    assert info(window) == before
    assert "was" not in window.page.locator(f"{PANEL} tbody").inner_text()
    assert window.page.locator(f"{PANEL} .note").is_hidden()
