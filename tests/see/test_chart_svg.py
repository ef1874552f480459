"""Charts as vector graphics: axes with units, every curve where its data are, in the colours of the page."""

from __future__ import annotations

from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import pytest

from see.looking import look
from see.scenes import short_report

SVG = "{http://www.w3.org/2000/svg}"


@pytest.mark.nightly("dark")
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_all_charts_of_a_tab_as_one_graphic(browser: Any, tmp_path: Path, scheme: str) -> None:
    """Those that were never looked at too; each has its title, its axes, its curves, and its legend."""
    path = tmp_path / "report.html"
    path.write_text(short_report(), encoding="utf-8")
    window = look(browser, path, scheme=scheme)
    titles = window.page.locator("#tm-charts .chart h4").all_text_contents()
    with window.page.expect_download() as given:
        window.page.get_by_role("button", name="Save all of these (SVG)").click()
    root = ET.parse(given.value.path()).getroot()  # noqa: S314
    charts = root.findall(f"{SVG}g")
    words = [[one.text or "" for one in chart.iter(f"{SVG}text")] for chart in charts]
    assert [each[0].split(" [")[0] for each in words] == [title.split(" [")[0] for title in titles]
    assert len(titles) > 4
    for chart, each in zip(charts, words, strict=True):
        assert {"time [s]", "frequency [Hz]"} & set(each)
        numbers = [word for word in each[1:] if word.replace(".", "").replace("-", "").isdigit()]
        assert len(numbers) > 5 or "frequency [Hz]" in each
        drawn = [one.get("d", "") for one in chart.iterfind(f"{SVG}svg//{SVG}path")]
        assert drawn
        assert all("NaN" not in one for one in drawn)
        assert max(one.count("L") for one in drawn) > 30
    fill = window.page.evaluate("getComputedStyle(document.documentElement).getPropertyValue('--paper').trim()")
    assert [one.get("fill") for one in root.iterfind(f"{SVG}rect")] == [fill]
    assert window.said == []
