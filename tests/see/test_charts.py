"""The data of the charts: each curve is the series that it claims to be, in the unit that it states."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import to_hex
from matplotlib.figure import Figure

import tmodes
from random_sheets import random_sheet
from see.scenes import arm_result
from tmodes.errors import InputError
from tmodes.frame import along
from tmodes.plot.charts import in_units, word_of
from tmodes.plot.panels import draw_chart, plain
from tmodes.plot.spectra import amplitude_spectrum
from tmodes.plot.style import CAUSES, colour, house_style
from tmodes.report.charts import chart_data, charts_of, page_charts
from tmodes.report.data import facts_of, page_data
from tmodes.report.facts import run_facts
from tmodes.report.pack import Coarse, pack
from tmodes.result import Result
from tmodes.robots import published

COUNT = int(os.environ.get("TMODES_PROPERTIES", "2"))
"""How many random robots are run; with more than two, every published robot too."""

PREFIX = {"m": 1e3, "µ": 1e6, "n": 1e9, "k": 1e-3}


@pytest.fixture(scope="module")
def charts(good: Result) -> dict[str, dict[str, Any]]:
    """The charts of the good run by name."""
    return {chart["id"]: chart for chart in charts_of([good])[0]}


def column(data: Any, place: dict[str, Any]) -> Any:
    if place.get("along"):
        parts = data[place["variable"]].transpose("time", "error_part", "axis").values
        return (along(parts) if place["index"] >= 0 else np.linalg.norm(parts.sum(axis=1), axis=1)[:, None])[
            :, place["index"]
        ]
    return data[place["variable"]].values.reshape(data.sizes["time"], -1)[:, place["index"]]


def test_every_curve_over_time_is_its_source(good: Result, charts: dict[str, dict[str, Any]]) -> None:
    compared = 0
    for chart in charts.values():
        for curve in chart["curves"]:
            if chart["abscissa"] == "time" and curve["source"]:
                source = curve["source"]
                whole = column(good.data, source)
                if "less" in source:
                    whole = whole - column(good.data, source["less"])
                scale = np.abs(whole).max() * source["factor"]
                assert curve["values"] == pytest.approx(source["factor"] * whole, rel=1e-6, abs=1e-6 * scale)
                compared += 1
    assert compared > 45


def test_units_are_those_of_the_figures(charts: dict[str, dict[str, Any]]) -> None:
    assert charts["tip_deviation"]["unit"] == "mm"
    assert charts["deformation_joint.gear_rad_0"]["unit"] == "mrad"
    assert charts["gear_torque_N m_0"]["unit"] == "N·m"
    for chart in charts.values():
        name = chart["unit"]
        known = name[1:] in {"m", "rad", "N", "N·m", "J", "V", "A"}
        prefix = PREFIX.get(name[0], 1.0) if known else 1
        assert {curve["source"]["factor"] for curve in chart["curves"] if curve["source"]} <= {prefix}


def test_causes_add_up_to_the_error_in_one_unit(good: Result, charts: dict[str, dict[str, Any]]) -> None:
    for which in ("tip_error", "tip_error_nominal"):
        *parts, total = charts[which]["curves"]
        assert (charts[which]["stacked"], charts[which]["unit"], total["label"]) == (True, "mm", "total")
        assert sum(part["values"] for part in parts) == pytest.approx(total["values"], abs=1e-4)
    assert total["values"] == pytest.approx(1e3 * good.data["deviation"].values, abs=1e-3)
    lengths = {"error": {"mm"}, "deformations": {"mrad"}}
    for group, units in lengths.items():
        assert {chart["unit"] for chart in charts.values() if chart["group"] == group} == units


def test_what_stands_side_by_side_has_one_unit(good: Result) -> None:
    small = Result(good.data.assign(deviation=good.data["deviation"] * 1e-4))
    pairs = [{chart["id"]: chart for chart in charts}["tip_deviation"] for charts in charts_of([small, good])]
    assert [chart["unit"] for chart in pairs] == ["mm", "mm"]
    assert pairs[0]["curves"][0]["values"] == pytest.approx(1e-4 * pairs[1]["curves"][0]["values"], rel=1e-5)


def test_deformations_have_their_parts_and_reference(charts: dict[str, dict[str, Any]]) -> None:
    of_link = [f"{plane}{k}" for plane in ("azimuth", "elevation") for k in (1, 2)]
    for chart, name in (("joint.gear", "gear of joint"), *(("link", one) for one in of_link)):
        curves = charts[f"deformation_{chart}_rad_0"]["curves"]
        roles = {curve["role"]: curve["values"] for curve in curves if curve["label"] == name}
        assert list(roles) == ["real", "reference", "stationary", "oscillatory"]
        assert roles["stationary"] + roles["oscillatory"] == pytest.approx(roles["real"], abs=2e-5)


def test_spectra_are_those_of_the_samples_that_they_tell(good: Result, charts: dict[str, dict[str, Any]]) -> None:
    chart = charts["spectrum_deformations"]
    start, end = chart["span"]
    part = good.data.sel(time=slice(start - 1e-9, end + 1e-9))
    for curve in chart["curves"]:
        frequency, amplitude = amplitude_spectrum(column(part, curve["source"]), 1e-3, 4)
        count = len(chart["at"])
        assert chart["at"] == pytest.approx(frequency[:count])
        assert curve["values"] == pytest.approx(curve["source"]["factor"] * amplitude[:count], rel=1e-5, abs=1e-12)
    assert [round(mark["at"], 3) for mark in chart["marks"]] == [4.932, 7.293, 20.162]


def test_long_runs_are_thinned_and_tell_it(good: Result) -> None:
    long = good.data.isel(time=np.tile(np.arange(2001), 5)).assign_coords(time=np.arange(10005) * 1e-3)
    chart = next(chart for chart in charts_of([Result(long)])[0] if chart["id"] == "deformation_joint.gear_rad_0")
    kept = chart["curves"][0]["values"]
    assert chart["samples"] == 10005
    assert len(chart["at"]) < 7000
    assert isinstance(kept, Coarse)
    assert kept.values.max() == pytest.approx(1e3 * float(long["deformation"].sel(deformation_kind="joint.gear").max()))


def test_free_space_has_no_contact_chart(failed: Result) -> None:
    assert {chart.group for chart in page_charts(failed)} == {"error", "tip", "deformations", "motors", "energy"}


def test_facts_have_stable_names_units_and_values(good: Result) -> None:
    facts = {fact.id: fact for fact in facts_of(good)}
    info = good.summary()
    assert facts["deviation.max"].value == info["deviation"]["max_m"]
    assert facts["deviation.max"].unit == "m"
    square = np.trapezoid(good.data["deviation"] ** 2, good.data["time"]) / 2.0
    assert facts["deviation.rms"].value == pytest.approx(np.sqrt(square), rel=1e-9)
    assert facts["settling"].value == info["settling"]["time_s"] == pytest.approx(0.0335, rel=0.02)
    assert facts["vibration.residual"].value == info["vibration"]["actual"]["amplitude_m"] > 0
    assert facts["moment.max"].value == max(link["bending_moment"]["max_Nm"] for link in info["links"].values())


def test_angles_of_gears_are_not_compared_with_lengths() -> None:
    """Of gears that turn and gears that slide, the largest is one of those that turn, and says so."""
    result = arm_result()
    summary = result.summary()
    turning = summary["deformations"]["shoulder.gear"]
    slider = turning | {"unit": "m", "max": 2 * turning["max"]}
    summary["deformations"] |= {"slider.gear": slider}
    found = next(fact for fact in run_facts(result, summary) if fact.id == "gear.max")
    assert (found.value, found.unit) == (turning["max"], "rad")
    assert found.note.startswith("shoulder, at ")
    assert found.note.endswith("(of the gears that turn)")
    del summary["deformations"]["shoulder.gear"]
    alone = next(fact for fact in run_facts(result, summary) if fact.id == "gear.max")
    assert (alone.value, alone.unit) == (slider["max"], "m")


def test_residual_vibration_is_about_the_mean_place(good: Result) -> None:
    """A tip that swings by 1 mm along x after the move, 5 mm off its place: the offset is no vibration."""
    data = good.data.copy()
    time = np.linspace(0.0, 4.0, data.sizes["time"])
    swing = np.zeros((len(time), 3))
    swing[:, 0] = 5e-3 + 1e-3 * np.sin(2 * np.pi * 5 * time)
    data = data.assign(tip=0 * data["tip"] + swing).assign_coords(time=time)
    data.attrs = {key: value for key, value in data.attrs.items() if key != "vibration"}
    found = {fact.id: fact for fact in facts_of(Result(data))}["vibration.residual"]
    assert found.value == pytest.approx(1e-3, rel=1e-2)


def test_the_data_of_a_page_can_be_packed(good: Result, failed: Result) -> None:
    page = page_data([good, failed], ["a", "b"])
    assert [run["name"] for run in page["runs"]] == ["a", "b"]
    assert (page["title"], page["live"]) == ("a, b", None)
    assert page["runs"][1]["status"] == "diverged"
    assert page["runs"][0]["sheet"].startswith("format: 1")
    assert 100_000 < len(pack(page)) < 1_650_000


def compared() -> Iterator[Result]:
    """Runs of random robots; of every published one too, where many are wanted."""
    for k in range(COUNT):
        yield tmodes.run(tmodes.Robot.from_data(random_sheet(k)))
    for name in published() if COUNT > 2 else ():
        try:
            yield tmodes.run(tmodes.load(name))
        except InputError:  # its package is not installed
            continue


def test_figures_and_the_page_draw_the_same_chart(good: Result) -> None:
    """With equal labels, units, values and colours; no code name, no underscore, no letter of the paper in a text."""
    groups, texts = set[str](), set[str]()
    for result in (good, *compared()):
        for chart in in_units([page_charts(result)])[0]:
            data, panel = chart_data(chart), Figure().subplots()
            with house_style():
                draw_chart(panel, chart)
            assert panel.get_ylabel() == data["ordinate"]
            assert data["ordinate"].endswith(f"[{data['unit']}]")
            curves = {str(line.get_label()): line for line in panel.get_lines()}
            colours = {name: str(line.get_color()) for name, line in curves.items()}
            areas = {
                str(area.get_label()): to_hex(tuple(np.asarray(area.get_facecolor())[0])) for area in panel.collections
            }
            for line, curve in zip(chart.lines, data["curves"], strict=True):
                word = plain(word_of(chart, line))
                assert areas.get(word) or colours[word] == colour(curve["colour"])
                assert areas.get(word, colour(curve["colour"])) == colour(curve["colour"])
                if word not in areas and len(line.values) == len(curve["values"]):
                    shown = np.abs(curve["values"]) if chart.log == "first" else curve["values"]
                    drawn = np.nan_to_num(np.asarray(curves[word].get_ydata(), dtype=float))
                    assert drawn == pytest.approx(shown, rel=1e-5, abs=1e-5 * float(np.abs(shown).max()))
                if chart.stacked:
                    assert colour(curve["colour"]) == CAUSES[line.cause][0]
                texts |= {curve["label"], curve["part"], word}
            texts |= {data["title"], data["ordinate"], data["note"]}
            groups.add(chart.group)
    assert groups >= {"error", "tip", "contact", "deformations", "motors", "energy", "spectrum"}
    assert not [text for text in texts if set(text) & set("`_") or "T_" in text]
