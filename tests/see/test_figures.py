"""Every figure draws every result: labelled, with units, in the house style, and without touching the user's."""

from __future__ import annotations

import re
from typing import Any

import matplotlib as mpl
import numpy as np
import pytest
from matplotlib.figure import Figure

from result.synthetic import synthetic_result
from tmodes import plot
from tmodes.errors import InputError
from tmodes.plot.paper.contact import contact_force
from tmodes.plot.paper.energy import energies
from tmodes.plot.paper.load import bending_load, largest_moment
from tmodes.plot.paper.shape import elastic_line, instants, round_factor
from tmodes.plot.save import rendered
from tmodes.result.record import PaperResult

UNIT = re.compile(r"\[(n|µ|m|k)?(m|rad|rad/s²|N|N·m|J|V|A|s|Hz)\]$")


def heights(line: Any) -> np.ndarray:
    """The y values of a curve."""
    return np.asarray(line.get_ydata(), dtype=float)


def drawn(axes: list) -> None:
    """Draw for good: what is wrong with an axis shows only then."""
    rendered(axes[0].figure, "svg")


@pytest.mark.parametrize("name", plot.FIGURES)
def test_every_figure_draws_or_reports_why_not(
    name: str, result: PaperResult, caplog: pytest.LogCaptureFixture
) -> None:
    figures, reasons = plot.all_figures(result), plot.left_out(result)
    assert (name in figures) != (name in reasons)
    if name in reasons:
        assert len(reasons[name]) > 20
        with pytest.raises(InputError, match=re.escape(reasons[name])):
            plot.FIGURES[name].draw(result)
        return
    axes = figures[name]()
    drawn(axes)
    for index, panel in enumerate(axes):
        assert UNIT.search(panel.get_ylabel()), panel.get_ylabel()
        assert panel.get_title(loc="left").startswith(f"{chr(ord('a') + index)}) ")
        assert panel.has_data()
        bottom = panel.get_xlabel() or next(p.get_xlabel() for p in axes[index:] if p.get_xlabel())
        assert UNIT.search(bottom), bottom
    assert caplog.messages == []


def test_what_is_left_out() -> None:
    assert plot.left_out(synthetic_result()) == {}
    assert set(plot.left_out(synthetic_result(contact=False))) == {"contact_force"}
    short = PaperResult(synthetic_result().data.isel(time=slice(0, 3)))
    assert plot.left_out(short) == {
        "spectrum": "a spectrum needs 32 samples between 20 % and 80 % of the move; this run has 0"
    }


@pytest.mark.parametrize("name", plot.FIGURES)
def test_it_draws_on_the_axes_it_is_given(name: str, good: PaperResult) -> None:
    count = len(plot.FIGURES[name].draw(good))
    axes = Figure(figsize=(6, 9)).subplots(count, 1, squeeze=False)
    assert plot.FIGURES[name].draw(good, axes) == list(axes.ravel())
    drawn(list(axes.ravel()))
    with pytest.raises(InputError, match=f"{count + 1} axes"):
        plot.FIGURES[name].draw(good, Figure().subplots(count + 1, 1))


def test_the_users_settings_are_neither_used_nor_changed(good: PaperResult) -> None:
    plain = rendered(plot.drive(good)[0].figure, "svg")
    with mpl.rc_context({"lines.linewidth": 9.0, "font.size": 30.0, "axes.grid": False, "xtick.color": "red"}):
        before = dict(mpl.rcParams)
        assert rendered(plot.drive(good)[0].figure, "svg") == plain
        assert dict(mpl.rcParams) == before


def test_values_are_those_of_the_result_in_the_unit_that_is_written(good: PaperResult) -> None:
    panel = plot.tip_tracking(good)[3]
    assert panel.get_ylabel() == "deviation [mm]"
    np.testing.assert_allclose(heights(panel.lines[0]), good.data["deviation"] * 1e3)
    east = good.data["tip"].sel(axis="x") - good.data["tip_reference"].sel(axis="x")
    np.testing.assert_allclose(heights(panel.lines[1]), east * 1e3)
    gear = plot.deformations(good)[4]
    assert gear.get_ylabel() == r"$\xi$ [mrad]"
    np.testing.assert_allclose(heights(gear.lines[0]), good.data["deformation"][:, 4] * 1e3)


def test_real_and_reference_differ_in_more_than_colour(good: PaperResult) -> None:
    real, reference = plot.deformations(good)[0].lines
    assert real.get_color() != reference.get_color()
    assert real.get_linestyle() != reference.get_linestyle()


def test_a_nearly_constant_force_is_reported_to_be_one(good: PaperResult) -> None:
    axes = contact_force(good)
    drawn(axes)
    whole, close, _ = axes
    assert whole.get_ylim()[0] == 0.0
    force = good.data["contact_force_radial"].values
    assert f"nearly constant, within 0.047 %:\n{force.min():.5f} to {force.max():.5f} N" in whole.texts[0].get_text()
    assert close.get_ylim()[0] > 4.9
    assert close.yaxis.get_offset_text().get_text() == ""
    assert all(float(label.get_text()) > 4.9 for label in close.get_yticklabels())


def test_a_force_that_varies_is_not(good: PaperResult) -> None:
    varied = good.data["contact_force_radial"] * np.linspace(-1, 1, len(good.data["time"]))
    whole = contact_force(PaperResult(good.data.assign(contact_force_radial=varied)))[0]
    assert whole.texts[0].get_text() == ""
    assert whole.get_ylim()[0] < -4.9 < 4.9 < whole.get_ylim()[1]


def test_the_exaggeration_is_what_the_title_reports(good: PaperResult) -> None:
    def tip_of_first(axes: list) -> tuple[float, float]:
        return tuple(part[-1] for part in axes[0].lines[1].get_data())

    x, y, _ = good.data["line"].isel(time=0, mode=1, s=-1).values
    scaled, natural = elastic_line(good), elastic_line(good, exaggerate=1)
    factor = int(scaled[0].get_title(loc="left").removeprefix("a) From above, deviation × "))
    assert factor in {10, 20, 50}
    assert natural[0].get_title(loc="left") == "a) From above, to scale"
    np.testing.assert_allclose(tip_of_first(natural), (x, y))
    theta, reach = float(good.data["q"].sel(coordinate="theta")[0]), 0.9
    rigid = reach * np.array([np.cos(theta), np.sin(theta)])
    np.testing.assert_allclose(tip_of_first(scaled), rigid + factor * (np.array([x, y]) - rigid))


@pytest.mark.parametrize(("wanted", "got"), [(0.3, 1), (1, 1), (1.99, 1), (4.9, 2), (5, 5), (19, 10), (7e5, 5e5)])
def test_round_factors(wanted: float, got: float) -> None:
    assert round_factor(wanted) == got


@pytest.mark.parametrize("count", [1, 2, 3, 5, 6, 2001])
def test_instants_hold_the_first_and_the_last(count: int, good: PaperResult) -> None:
    chosen = instants(good.data.isel(time=slice(0, count)))
    assert chosen[0] == 0
    assert chosen[-1] == count - 1
    assert len(chosen) == min(count, 5)


def test_instants_of_a_long_run_are_those_of_the_move() -> None:
    long = synthetic_result(duration=8.0, samples=801).data
    np.testing.assert_allclose(long["time"][instants(long)], [0, 0.5, 1, 1.5, 2])


def test_the_load_holds_its_worst_instant(good: PaperResult) -> None:
    moment, sample, place = largest_moment(good.data)
    info = good.summary()["largest_bending_moment"]
    assert (moment, float(good.data["time"][sample])) == (info["value_Nm"], info["time_s"])
    assert place == 0.0
    for panel in bending_load(good):
        low, high = panel.dataLim.intervaly
        worst = heights(panel.lines[0])
        assert low - 1e-9 <= worst.min() <= worst.max() <= high + 1e-9
        assert panel.get_xlim() == (0.0, pytest.approx(0.9))


def test_the_largest_moment_may_be_in_the_second_mode(good: PaperResult) -> None:
    moment = good.data["bending_moment"].copy()
    moment.loc[{"mode": "mode2", "plane": "horizontal", "s": moment["s"][10], "time": moment["time"][7]}] = -1e3
    assert largest_moment(good.data.assign(bending_moment=moment)) == (-1e3, 7, pytest.approx(0.75))


def test_rounding_is_not_made_to_look_like_motion(good: PaperResult) -> None:
    noise = np.random.default_rng(1).normal(size=(len(good.data["time"]), 5)) * 1e-18
    angles = 0 * good.data["deformation"] + good.data["deformation"].values[0] + noise
    parts = {"deformation_stationary": angles, "deformation_oscillatory": 0 * angles + noise}
    small = good.data.assign(deformation=angles, **parts)
    for panel in plot.stationary_oscillatory(PaperResult(small)):
        low, high = panel.get_ylim()
        curve = heights(panel.lines[0])
        assert high - low > 1e6 * np.ptp(curve)
        assert low < curve.min() <= curve.max() < high


def test_a_small_motion_fills_its_panel(good: PaperResult) -> None:
    part = 1e-9 * np.sin(good.data["time"].values)[:, None] * np.ones(5)
    small = good.data.assign(deformation_oscillatory=0 * good.data["deformation_oscillatory"] + part)
    panel = plot.stationary_oscillatory(PaperResult(small))[1]
    assert panel.get_ylabel().endswith("[nrad]")
    assert np.ptp(heights(panel.lines[0])) > 0.8 * np.ptp(panel.get_ylim())


def test_a_balance_without_residual_is_reported(good: PaperResult) -> None:
    axes = energies(PaperResult(good.data.assign(energy_balance=good.data["energy_balance"] * 0)))
    drawn(axes)
    assert axes[2].texts[0].get_text() == "exactly zero throughout"
    assert energies(good)[2].get_yscale() == "log"
