"""The page of a study in a real browser: charts that follow what is chosen, and cases that are simulated again."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.dom import minidom

import numpy as np
import pytest

from see.conftest import NASTY
from see.looking import SIZES, Window, look
from see.test_page import AXE
from tmodes import load, run
from tmodes.study.page import write_page
from tmodes.study.page.data import ColumnInfo, page_data, shown_rows
from tmodes.study.page.document import study_document
from tmodes.study.read import study_from_data
from tmodes.study.rows import Rows
from tmodes.study.runner import run_study
from tmodes.study.table import TableColumns

OVERFLOW = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
LOST = (3, 17)


def made_rows(count: int = 400) -> Rows:
    """Cases of two parameters; two did not finish."""
    draw = np.random.default_rng(3)
    gear, payload = draw.uniform(0.8, 1.2, count), draw.normal(0.5, 0.02, count)
    peak, end = 12 - 6 * (gear - 1) + 40 * (payload - 0.5), np.abs(gear - 1)
    status, reason = ["finished"] * count, [""] * count
    for k in LOST:
        peak[k], end[k], status[k], reason[k] = np.nan, np.nan, "diverged", NASTY
    return Rows(
        np.arange(count), {"gear": gear, "payload": payload}, {"peak": peak, "end": end}, {"peak": "mm", "end": "-"},
        status, reason, ["dormand_prince"] * count, np.full(count, 1e-3),
    )  # fmt: skip


DESIGNS = {
    "x": "peak", "y": "end", "front": [0, 1], "best": 0, "start": {"peak": 12.0, "end": 0.1},
    "limits": [{"text": "peak ≤ 15 mm", "column": "peak", "bound": 15.0, "sign": 1},
               {"text": "end ≥ 0.05", "column": "end", "bound": 0.05, "sign": -1}],
}  # fmt: skip
INFO = {
    "gear": ColumnInfo(NASTY),
    "payload": ColumnInfo("payload", "kg"),
    "peak": ColumnInfo("largest deviation", "mm"),
}


def written(path: Path, rows: Rows, **more: Any) -> Path:
    data = page_data("made", rows, INFO, **more)
    path.write_text(study_document(NASTY, NASTY, rows, INFO, data, [["robot", NASTY]], NASTY), encoding="utf-8")
    return path


def opened(browser: Any, path: Path, *args: Any, **more: Any) -> Window:
    """Open a study's page; return when its charts, which wait for their layout, are drawn."""
    window = look(browser, path, *args, **more)
    window.page.wait_for_selector(".study-area > svg:empty", state="detached")
    return window


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Path:
    rows = made_rows()
    best = [int(np.nanargmin(values)) for values in rows.quantities.values()]
    indices = {
        "quantity": "end", "how": "Sobol' indices", "names": ["gear", "payload"],
        "first": [[0.9, 0.85, 0.95], [0.0, -0.02, 0.02]], "total": [[0.95, 0.9, 1.0], [0.05, 0.0, 0.1]],
    }  # fmt: skip
    times = np.linspace(0, 2, 50)
    band = {"title": "Tip", "label": "Δ of the tip", "unit": "mm",
            "times": times, "shares": [5, 50, 95], "nominal": None, "cases": 99,
            "values": np.array([times - 1, times, times + 1], dtype=np.float32)}  # fmt: skip
    folder = tmp_path_factory.mktemp("a study & more")
    more = {"indices": [indices], "bands": [band], "answers": {"end": f"the end {NASTY}"}}
    written(folder / "designs.html", rows, designs=DESIGNS | {"front": best, "best": best[0]}, drawn=False)
    return written(folder / "study.html", rows, **more)


@pytest.fixture
def designs(browser: Any, made: Path) -> Any:
    """The same cases, as designs."""
    shown = opened(browser, made.with_name("designs.html"))
    yield shown
    assert shown.said == []
    shown.page.context.close()


@pytest.fixture
def window(browser: Any, made: Path) -> Any:
    shown = opened(browser, made)
    yield shown
    assert shown.said == []
    shown.page.context.close()


@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES)
def test_it_is_silent_alone_and_within_its_window(browser: Any, made: Path, size: Any, scheme: str) -> None:
    window = opened(browser, made, size, scheme)
    assert window.said == []
    assert [url for url in window.asked if not url.startswith("blob:")] == [made.as_uri()]
    assert window.page.evaluate(OVERFLOW) == 0
    titles = window.page.locator(".chart h3").all_inner_texts()
    assert titles[:3] == ["Distribution", "What matters", "All cases"]
    assert {"Tip", "Response to payload"} <= set(titles)
    window.page.context.close()


TOUCHING = """[...document.querySelectorAll('.study-area .axes')].flatMap((one) => {
  const words = [...one.querySelectorAll('text')].map((text) => [text.textContent, text.getBoundingClientRect()])
    .filter(([words]) => words);
  return words.flatMap(([a, p], k) => words.slice(k + 1).filter(([, q]) =>
    p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom).map(([b]) => [a, b]));
})"""


@pytest.mark.parametrize("size", [1e-3, 1.0, 1e5])
def test_no_words_of_axes_touch(browser: Any, tmp_path: Path, size: float) -> None:
    """However long the numbers are."""
    rows = made_rows()
    rows.quantities["peak"][:] = size * (2 + 1e-2 * rows.quantities["peak"])
    page = opened(browser, written(tmp_path / "study.html", rows, designs=DESIGNS)).page
    assert page.locator(".axes").count() >= 4
    assert page.evaluate(TOUCHING) == []
    page.context.close()


@pytest.mark.nightly("dark")
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("what", ["window", "designs"])
def test_axe_finds_nothing(request: pytest.FixtureRequest, what: str, scheme: str) -> None:
    if not AXE.is_file():
        pytest.skip("needs axe-core: npm ci in web/")
    window = request.getfixturevalue(what)
    window.page.emulate_media(color_scheme=scheme)
    window.page.evaluate(AXE.read_text(encoding="utf-8"))
    found = window.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
    assert [(one["id"], one["nodes"][0]["html"][:120]) for one in found["violations"]] == []


def test_what_is_chosen_is_shown_everywhere(window: Window) -> None:
    page = window.page
    assert page.locator(".answer").inner_text() == ""
    bars = "[...document.querySelectorAll('.swing, .index')].map((one) => one.getAttribute('class'))"
    page.wait_for_selector(".swing")
    assert page.evaluate(bars) == ["swing low", "swing high"] * 2
    page.get_by_label("Quantity").select_option("end")
    page.wait_for_selector(".index")
    assert page.locator(".answer").inner_text() == f"the end {NASTY}"
    assert page.evaluate(bars) == ["index first", "index total"] * 2
    assert page.locator(".axes .name", has_text="end").count() >= 3


def test_a_case_is_picked_by_its_rank(window: Window) -> None:
    rows, page = made_rows(), window.page
    for name, case in (
        ("largest", np.nanargmax(rows.quantities["peak"])),
        ("least", np.nanargmin(rows.quantities["peak"])),
    ):
        page.get_by_role("button", name=name, exact=True).click()
        assert page.get_by_role("heading", name=f"Case {case}: finished").count() == 1
        assert f"{rows.parameters['payload'][case]:.4g}" in page.locator(".case-panel").inner_text()
    assert page.get_by_role("button", name="Open live report").is_disabled()


def test_a_dragged_range_keeps_the_cases_in_it(window: Window) -> None:
    rows, page = made_rows(), window.page
    figure = page.locator(".chart", has=page.get_by_role("heading", name="All cases"))
    box = figure.locator("svg").bounding_box()
    top, bottom, left = box["y"] + 40, box["y"] + 320 - 16, box["x"] + 60
    page.mouse.move(left, (top + bottom) / 2)
    page.mouse.down()
    page.mouse.move(left, top + 1, steps=4)
    page.mouse.up()
    gear = rows.parameters["gear"]
    low, high = gear.min() - 0.03 * np.ptp(gear), gear.max() + 0.03 * np.ptp(gear)
    kept = int((gear >= (low + high) / 2).sum())
    assert abs(int(figure.locator(".readout").inner_text().split()[0]) - kept) <= 3
    page.get_by_role("button", name="all cases", exact=True).click()
    assert figure.locator(".readout").inner_text() == ""


SPOTS = """(kind) => (document.querySelector(kind).getAttribute('d').match(/M/g) ?? []).length"""


def test_all_designs_are_points_with_the_limits_and_the_best_one(designs: Window) -> None:
    """What is beyond a limit is another mark; a pointer shows which limit; a click picks the design."""
    page, rows = designs.page, made_rows()
    chart = page.locator(".chart", has=page.get_by_role("heading", name="Designs", exact=True))
    assert page.evaluate(SPOTS, ".points.kept") == int(rows.good.sum())
    assert [one.text_content() for one in chart.locator(".limit + text").all()] == ["peak ≤ 15 mm", "end ≥ 0.05"]
    best = int(np.nanargmin(rows.quantities["peak"]))
    assert chart.locator("text.name.best").text_content() == f"Design {best}: best largest deviation"
    assert chart.locator("text.name.start").text_content() == "start"
    place = chart.locator("circle").first.bounding_box()
    page.mouse.move(place["x"] + 4, place["y"] + 4)
    front = sorted((int(np.nanargmin(one)) for one in rows.quantities.values()), key=rows.quantities["peak"].item)
    assert chart.locator(".hover").inner_text().startswith(f"Design {front[0]}\nlargest deviation")
    page.mouse.click(place["x"] + 4, place["y"] + 4)
    assert page.get_by_role("heading", name=f"Design {front[0]}: finished").count() == 1
    page.get_by_label("Across").select_option("payload")
    assert chart.locator(".limit").count() == 1


def test_a_chart_is_saved_as_it_stands(window: Window) -> None:
    with window.page.expect_download() as download:
        window.page.get_by_role("button", name="Save Distribution as SVG").click()
    root = minidom.parseString(Path(download.value.path()).read_bytes())  # noqa: S318 - written by the page just now
    assert "rgb(0, 114, 178)" in {one.getAttribute("fill") for one in root.getElementsByTagName("rect")}
    assert any("mm" in one.toxml() for one in root.getElementsByTagName("text"))


def test_numbers_without_a_program(browser: Any, made: Path) -> None:
    window = look(browser, made, java_script_enabled=False)
    text = window.page.locator("main").inner_text()
    assert "largest deviation" in text
    assert "The charts need JavaScript" in text
    assert "alert(" in text  # the nasty text is text
    window.page.context.close()


def test_two_parameters_on_a_grid_are_a_surface(browser: Any, tmp_path: Path) -> None:
    x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, 6), np.linspace(2, 3, 5)))
    rows = Rows(np.arange(30), {"x": x, "y": y}, {"z": x * y}, {"z": "-"}, ["finished"] * 30, [""] * 30, [""] * 30,
                np.zeros(30))  # fmt: skip
    window = opened(browser, written(tmp_path / "grid.html", rows))
    assert window.page.locator(".cell").count() == 30
    window.page.locator(".cell").nth(29).click()
    assert window.page.get_by_role("heading", name="Case 29: finished").count() == 1
    window.page.context.close()


def test_a_part_of_very_many_cases_has_the_extremes_and_the_lost() -> None:
    rows = made_rows(5000)
    kept = shown_rows(rows, 500)
    assert len(kept) <= 500
    assert {*LOST, int(np.nanargmax(rows.quantities["peak"])), int(np.nanargmin(rows.quantities["end"]))} <= {
        *kept.tolist()
    }


STUDY = {
    "format": 1, "kind": "study", "name": "live", "robot": "spong1987",
    "parameters": {
        "gear": {"path": "joints.joint.gear.stiffness", "relative": True,
                 "distribution": {"type": "uniform", "low": 0.5, "high": 1.5}},
        "bob": {"path": "links.link.bodies.bob.mass", "distribution": {"type": "uniform", "low": 0.5, "high": 1.5}},
    },
    "plan": {"type": "monte_carlo", "runs": 24, "seed": 1},
    "quantities": {"peak": {"type": "series", "series": "tip_error", "reduce": "max", "unit": "mm"}},
}  # fmt: skip


@pytest.mark.nightly
def test_a_case_is_simulated_again_in_its_live_report(browser: Any, tmp_path: Path) -> None:
    done = run_study(study_from_data(STUDY), tmp_path / "live", threads=1)
    peak = TableColumns(done.parquet).numbers("peak")
    assert f"95 % of cases stay below {np.percentile(peak, 95):.4g} mm, 95 % above" in done.sentence
    assert f"half below {np.median(peak):.4g} mm. 24 of 24 cases finished." in done.sentence
    assert done.sentence == done.info()["sentence"] == next(iter(done.tables())) == repr(done).partition("\n")[0]
    window = opened(browser, write_page(done, tmp_path / "study.html"))
    page, rows = window.page, done.rows
    assert page.locator("p.status.neutral").inner_text().replace("\u00a0", " ") == done.sentence
    case = int(np.argmax(rows.quantities["peak"]))
    assert page.get_by_role("heading", name="Tip x less that of the sheet's own run").count() == 1
    page.get_by_role("button", name="largest", exact=True).click()
    with page.context.expect_page() as report_page:
        page.get_by_role("button", name="Open live report").click()
    report = report_page.value
    changes = {
        "joints.joint.gear.stiffness": 100.0 * rows.parameters["gear"][case],
        "links.link.bodies.bob.mass": rows.parameters["bob"][case],
    }
    wanted = run(load("spong1987").with_(changes)).summary()["tip_error"]["commanded"]["max_m"] * 1e3
    assert rows.quantities["peak"][case] == pytest.approx(wanted, rel=1e-4)
    row = report.locator(".facts > div", has_text="Error from commanded path").locator("strong")
    report.wait_for_selector(".facts .was")
    assert float(row.first.inner_text().split()[0]) == pytest.approx(wanted, rel=2e-3)
    assert window.said == []
    page.context.close()
