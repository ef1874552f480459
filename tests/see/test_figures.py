"""Figures and report of arms: every one draws, shows the numbers of the result, and survives nasty names."""

from __future__ import annotations

import re

import numpy as np
import pytest

from see.runs import NASTY, result_of
from tmodes.plot import all_figures, elastic_line, spectrum, tip_path
from tmodes.plot.figures.tip import views
from tmodes.report.page import write_report
from tmodes.result import Result


def test_curves_are_the_result():
    data = result_of("swinging").data
    axes = tip_path(result_of("swinging"))
    line = axes[0].get_lines()[0]
    assert np.asarray(line.get_xdata()) == pytest.approx(data["tip"].sel(axis="x").values)
    gear = all_figures(result_of("swinging"))["gear_deflections"]()[0].get_lines()[0]
    values = data["deformation"].sel(deformation_kind="shoulder.gear").values
    shown = np.asarray(gear.get_ydata())
    assert shown / np.abs(shown).max() == pytest.approx(values / np.abs(values).max())


def test_the_enlargement_is_reported_and_true():
    result = result_of("cantilever")
    axes = elastic_line(result, exaggerate=10.0)
    assert [panel.get_title(loc="left") for panel in axes] == [
        "a) From the side, to scale",
        "b) From the side, deflection × 10",
    ]
    bent = float(result.data["deflection"].sel(plane="z").isel(s=-1, time=0, bending_link=0))
    ends = [np.nanmax(np.concatenate([line.get_ydata() for line in panel.get_lines()])) for panel in axes]
    assert ends[0] == pytest.approx(bent, rel=1e-6)
    assert ends[1] == pytest.approx(10 * bent, rel=1e-6)


def test_sides_from_which_an_arm_is_seen():
    flat = np.zeros((5, 3))
    flat[:, 0], flat[:, 2] = np.arange(5), np.arange(5) ** 2
    assert views(flat) == [("x", "z")]
    assert len(views(np.random.default_rng(1).normal(size=(9, 3)))) == 2


def test_the_spectrum_peaks_where_the_arm_rings():
    """A pendulum of 1 m: 0.498 Hz at small angles, 1 % less at 0.4 rad."""
    panel = spectrum(result_of("pendulum"))[0]
    line = panel.get_lines()[0]
    peak = np.asarray(line.get_xdata())[np.argmax(line.get_ydata())]
    assert peak == pytest.approx(0.493, abs=0.02)


def test_report(tmp_path):
    result = result_of("swinging")
    data = result.data.copy()
    data.attrs = data.attrs | {"status": "diverged", "message": f"lost {NASTY}", "warnings": f'["{NASTY}"]'}
    page = write_report(Result(data), tmp_path / "r.html").read_text(encoding="utf-8")
    assert NASTY not in page
    assert page.count("&lt;b&gt;") >= 3
    assert "This run did not finish: diverged." in page
    worst = result.summary()["deviation"]["max_m"] * 1e3
    assert f"{worst:.4g}\u00a0mm" in page
    assert not re.search(r"(src|href)=\"(http|//)", page)
    good = write_report(result, tmp_path / "g.html").read_text(encoding="utf-8")
    assert "2 driven joints, 1 elastic link" in good
    assert "joints.shoulder.gear.stiffness" in good
