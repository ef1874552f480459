"""A page of charts in a real browser: silent, within its window, accessible; its legend, its pointer, its files."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from see.conftest import NASTY
from see.looking import SIZES, Window, look
from see.test_page import AXE
from see.test_study_page import OVERFLOW, TOUCHING
from tmodes.io.printed import Table
from tmodes.report.plots import Axis, Curve, Page, Plot, write_plots

RISING = np.geomspace(0.1, 1e3, 30)
MARKS = ("circle", "square", "triangle", "ring", "cross")
SOFT = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.7, "high": 1.1}}


def made(folder: Path) -> Path:
    """A chart of each kind of axis and curve; texts are nasty."""
    band = Curve("line", np.append(RISING, RISING[::-1]), np.append(RISING / 2, 2 * RISING[::-1]), "band")
    log = Plot(NASTY, Axis("frequency [Hz]", "log"), Axis("gain [dB]"), [Curve("line", RISING, RISING), band])
    marks = [Curve(kind, [-(10.0**k), 0, 1], [k, np.nan, -k], kind, "red") for k, kind in enumerate(MARKS)]
    both = Plot("Both sides", Axis("real", "asinh", 0.1), Axis("imaginary"), marks, "a note")
    rows = Plot("Rows", Axis("error [mm]"), Axis("", names=[NASTY, "short"]),
                [Curve("cases", [1.0, 2.0, 3.0], [0.0, 0.1, 1.0], "dots")])  # fmt: skip
    round_ = Plot("Round", Axis("re"), Axis("im"), [Curve("turn", np.cos(RISING), np.sin(RISING))], equal=True)
    parts = ["a sentence", Table(NASTY, ["name", "number"], [["one", "1.5"], [NASTY, "-2"]])]
    page = Page(NASTY, NASTY, NASTY, [log, both, rows, round_], parts, "warning", [NASTY], ["note"],
                {"one": "1-one/report.html"}, {"all.json": json.dumps({"a": NASTY})}, [["robot", NASTY]])  # fmt: skip
    return write_plots(page, folder / "made.html")


def league(folder: Path) -> Path:
    robot = tmodes.load("spong1987").with_({"integration.duration": 0.5})
    laws = {"own": {}, "stiff": {"drives.0.controller.position_gain": 160.0}}
    return robot.compare(laws, uncertain={"k": SOFT}, runs=12, tolerance="70 mm").page(folder / "league.html")


def linear(folder: Path) -> Path:
    robot = tmodes.load("spong1987").with_({"gear.damping": 0.5})
    out = "joint.position,joint.motor.position"
    found = robot.linearize(inputs="joint.torque", outputs=out, uncertain={"k": SOFT}, cases=4)
    return found.page(folder / "linear.html")


PAGES = {"made": made, "league": league, "linear": linear}


@pytest.fixture(scope="module")
def pages(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    folder = tmp_path_factory.mktemp("charts & more")
    return {name: page(folder) for name, page in PAGES.items()}


def opened(browser: Any, path: Path, *args: Any) -> Window:
    window = look(browser, path, *args)
    window.page.wait_for_selector(".study-area > svg:empty", state="detached")
    return window


@pytest.mark.nightly("size1", "dark")
@pytest.mark.parametrize("name", PAGES)
@pytest.mark.parametrize("scheme", ["light", "dark"])
@pytest.mark.parametrize("size", SIZES)
def test_it_is_silent_alone_and_accessible(browser: Any, pages: Any, name: str, size: Any, scheme: str) -> None:
    window = opened(browser, pages[name], size, scheme)
    assert window.page.evaluate(OVERFLOW) == 0
    assert window.page.evaluate(TOUCHING) == []
    if AXE.is_file():
        window.page.evaluate(AXE.read_text(encoding="utf-8"))
        found = window.page.evaluate("axe.run(document, {resultTypes: ['violations']})")
        assert [(one["id"], one["nodes"][0]["html"][:120]) for one in found["violations"]] == []
    assert window.said == []
    assert window.asked == [pages[name].as_uri()]
    window.page.context.close()


def test_a_legend_hides_and_a_pointer_reads(browser: Any, pages: Any) -> None:
    page = opened(browser, pages["made"]).page
    chart = page.locator(".chart", has=page.get_by_role("heading", name="Both sides"))
    assert chart.locator(".curve.cross").count() == 2  # the curve, and its key
    entry = chart.get_by_role("button", name="cross")
    entry.click()
    assert entry.get_attribute("aria-pressed") == "false"
    assert chart.locator(".curve.cross").count() == 1
    entry.click()
    rows = page.locator(".chart", has=page.get_by_role("heading", name="Rows"))
    box = rows.locator("path.dots").bounding_box()
    page.mouse.move(box["x"] + box["width"], box["y"] + box["height"])
    assert rows.locator(".hover").inner_text().split("\n") == ["cases", "short", "error [mm]: 3"]
    page.context.close()


def test_an_axis_of_decades_is_one(browser: Any, pages: Any) -> None:
    """Ticks of a logarithmic axis are powers of ten at even distances."""
    page = opened(browser, pages["made"]).page
    words = page.locator(".chart").first.locator(".axes text[text-anchor=middle]")
    ticks = words.evaluate_all("(all) => all.map((one) => [one.textContent, Number(one.getAttribute('x'))])")
    places = {float(text): x for text, x in ticks if text.replace(".", "").isdigit()}
    assert set(places) == {0.1, 1, 10, 100, 1000}
    assert np.ptp(np.diff([places[key] for key in sorted(places)])) < 1e-6
    page.context.close()


def test_numbers_and_files_without_a_program(browser: Any, pages: Any) -> None:
    window = look(browser, pages["made"], java_script_enabled=False)
    page = window.page
    assert "The charts need JavaScript" in page.locator("main").inner_text()
    assert page.get_by_role("link", name="one", exact=True).get_attribute("href") == "1-one/report.html"
    with page.expect_download() as download:
        page.get_by_role("link", name="all.json").click()
    assert json.loads(Path(download.value.path()).read_text(encoding="utf-8")) == {"a": NASTY}
    page.context.close()


def test_a_linear_model_shows_its_poles_and_the_range_of_its_family(browser: Any, pages: Any) -> None:
    page = opened(browser, pages["linear"]).page
    count = "(one) => (one.getAttribute('d').match(/M/g) ?? []).length"
    first = page.locator(".chart").first
    assert first.locator("g path.cross").evaluate(count) == 2 * 4  # two strokes for each pole
    assert first.locator("g path.dots").count() == 4
    assert page.locator(".chart", has=page.get_by_role("heading", name="Phase")).locator("g path.band").count() == 2
    names = ["Poles and zeros", "Gain", "Phase", "Nyquist", "Step", "Singular values"]
    assert page.locator(".chart h3").all_inner_texts() == names
    assert page.get_by_role("link", name="spong1987.json").count() == 1
    page.context.close()


def test_the_league_shows_each_case(browser: Any, pages: Any) -> None:
    page = opened(browser, pages["league"]).page
    count = "(one) => (one.getAttribute('d').match(/M/g) ?? []).length"
    first = page.locator(".chart").first
    assert first.locator("g path.dots").evaluate(count) == 24
    assert first.locator("g path.square").evaluate(count) == 2
    assert page.locator("p.status").inner_text().startswith("Best: stiff: largest error ")
    assert page.locator(".chart h3").all_inner_texts() == [
        "Errors of all variants", "Share of the cases within an error", "Tip error over time, as known"
    ]  # fmt: skip
    page.context.close()


SPOILT = """() => [...document.querySelectorAll('.study-area > svg')].map((svg) => {
  const words = [...svg.querySelectorAll('.axes text:not(.name)')].map((one) => [one.textContent,
    one.getBoundingClientRect()]);
  const edge = svg.getBoundingClientRect().right;
  const over = words.flatMap(([text, a], k) => words.slice(k + 1).filter(([, b]) => a.left < b.right &&
    b.left < a.right && a.top < b.bottom && b.top < a.bottom).map(([other]) => `${text} over ${other}`));
  return [words.map(([text]) => text), over.concat(words.filter(([, a]) => a.right > edge).map(([text]) => text))];
})"""


def test_words_of_axes_are_whole_and_apart(browser: Any, tmp_path: Path) -> None:
    """Logarithmic to both sides an axis has its 0, and no words over others; the last ones are not cut."""
    sizes = np.array([-7e4, -2.0, 0.0, 1.3, 9e3])
    both = [Axis(name, "asinh", 0.7) for name in ("real", "imaginary")]
    wide = Curve("", np.array([0.02, 1.1e5]), np.array([0.0, 1.0]))
    plots = [Plot("Poles", both[0], both[1], [Curve("poles", sizes, sizes[::-1] / 20, "cross")], "", 380),
             Plot("Gain", Axis("frequency [Hz]", "log", range=(0.02, 1.1e5)), Axis("gain"), [wide])]  # fmt: skip
    page = opened(browser, write_plots(Page("t", "", "s", plots, []), tmp_path / "axes.html")).page
    (texts, over), (last, cut) = page.evaluate(SPOILT)
    assert texts.count("0") == 2
    assert "100000" in last
    assert (over, cut) == ([], [])
    page.context.close()
