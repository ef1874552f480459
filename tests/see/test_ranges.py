"""Figures for print: one unit in a row, no empty panel, stated offsets, ranges in which there is something to see."""

from __future__ import annotations

import re
from functools import cache
from itertools import groupby
from typing import Any

import numpy as np
import pytest
from matplotlib.legend import Legend

import tmodes
from see.runs import QUINTIC, result_of, sheet, tube
from tmodes import plot
from tmodes.plot import ranges
from tmodes.result import Result

pytestmark = pytest.mark.nightly

UNIT = re.compile(r"\[(?P<prefix>n|µ|m|k|M)?(?P<base>m|rad|N·m|N|J|V|A|–|Pa)\]$")


@cache
def flat() -> Result:
    """An arm that moves and bends in the plane x y: nothing happens along z."""
    joint = {"name": "hub", "type": "revolute", "parent": "base", "child": "rod", "axis": [0, 0, 1],
             "motor": {"inertia": 0.2, "side": "joint"}}  # fmt: skip
    control = {"type": "pd", "position_gain": 100.0, "velocity_gain": 10.0}
    drive = {"joint": "hub", "command": "position", "signal": QUINTIC, "controller": control}
    arm = sheet(joints=[joint], links=[{"name": "rod", "beam": tube()}], drives=[drive])
    return tmodes.run(tmodes.Robot.from_data(arm))


@pytest.fixture(scope="module", params=["2010", "swinging", "flat"])
def shown(request: pytest.FixtureRequest, good: Result) -> dict[str, list[Any]]:
    """Every figure of three runs."""
    result = {"2010": lambda: good, "swinging": lambda: result_of("swinging"), "flat": flat}[request.param]()
    return {name: draw() for name, draw in plot.all_figures(result).items()}


def curve_values(panel: Any) -> list[Any]:
    """Of each curve of the panel; lines at zero have two points."""
    values = [np.asarray(line.get_ydata(), dtype=float) for line in panel.get_lines()]
    return [one for one in values if len(one) > 2]


def test_what_stands_in_a_row_has_one_unit_for_one_quantity(shown: dict[str, list[Any]]) -> None:
    compared = 0
    for name, axes in shown.items():
        for _, row in groupby(axes, key=lambda panel: panel.get_subplotspec().rowspan.start):
            units: dict[str, str] = {}
            for panel in row:
                found = UNIT.search(panel.get_ylabel())
                if found and name != "tip_path":  # that has axes to scale
                    quantity = panel.get_ylabel().split(" [")[0].split(" −")[0].split(" +")[0] + found["base"]
                    compared += quantity in units
                    assert units.setdefault(quantity, found[0]) == found[0], (name, panel.get_ylabel())
    assert compared > 2


def test_no_panel_is_empty(shown: dict[str, list[Any]]) -> None:
    """Each has a curve that is not zero throughout, or an area."""
    for name, axes in shown.items():
        for panel in axes:
            least = 0.0 if panel.get_yscale() == "log" else 1e-12
            drawn = any(np.nanmax(np.abs(values)) > least for values in curve_values(panel))
            assert drawn or panel.collections, (name, panel.get_title(loc="left"))


def test_directions_in_which_nothing_happens_are_left_out() -> None:
    figures = plot.all_figures(flat())
    assert [panel.get_title(loc="left") for panel in figures["tip_tracking"]()] == [
        "a) Tip x", "b) Tip y", "c) Error from nominal path",
    ]  # fmt: skip
    assert [panel.get_title(loc="left") for panel in figures["link_deflection"]()] == ["a) rod, along y"]
    assert [line.get_label() for line in figures["link_tips"]()[0].get_lines()][:1] == ["along y"]
    assert "gears" not in figures["tip_errors"]()[0].get_legend_handles_labels()[1]


def test_a_motor_without_voltage_has_no_panel_for_it() -> None:
    axes = plot.all_figures(result_of("swinging"))["joint_efforts"]()
    assert [panel.get_ylabel().split(" [")[0] for panel in axes] == ["torque", "voltage", "current", "torque"]


def test_elastic_energies_have_their_own_axis(good: Result) -> None:
    """They are a seventh of the kinetic energy: on its axis they could not be read."""
    axes = plot.all_figures(good)["energies"]()
    labels = [[str(line.get_label()) for line in panel.get_lines()] for panel in axes]
    labels = [[label for label in own if not label.startswith("_")] for own in labels]
    assert labels[:2] == [["kinetic", "gravity", "elastic gear", "elastic link"], ["elastic gear", "elastic link"]]
    assert [panel.get_ylabel() for panel in axes] == ["energy [mJ]", "elastic energy [mJ]", "work [J]", "residual [J]"]
    small = good.data["energy"].sel(energy_kind="elastic_link").values
    assert np.asarray(axes[1].get_lines()[1].get_ydata()) == pytest.approx(1e3 * small)


def test_an_axis_of_one_per_cent_says_what_is_subtracted(good: Result) -> None:
    """The sag varies by 1 %: tick labels are differences from the number in the label, in the same unit."""
    panel = plot.all_figures(good)["deformations"]()[3]
    label = re.fullmatch(r"angle \+ ([\d.]+) mrad\n\[mrad\]", panel.get_ylabel())
    assert label is not None
    offset = float(label[1])
    panel.figure.canvas.draw()
    pairs = [
        (tick.get_text().replace("−", "-"), y)
        for tick, y in zip(panel.get_yticklabels(), panel.get_yticks(), strict=True)
    ]
    assert len(pairs) > 2
    assert all(float(text) == pytest.approx(y + offset, abs=1e-4) for text, y in pairs)


def test_equal_curves_are_one_and_the_figure_says_so(good: Result) -> None:
    """The vertical shape hardly changes; the horizontal one does."""
    across, up, *_ = plot.all_figures(good)["link_deflection"]()
    assert [len(curve_values(panel)) for panel in (across, up)] == [5, 1]
    assert [note.get_title().get_text() for note in up.findobj(Legend)] == ["mean of 5 times,\nequal within 0.1 %"]


def test_an_oscillation_too_small_for_a_panel_is_stated(good: Result) -> None:
    titles = [panel.get_title(loc="left") for panel in plot.all_figures(good)["link_coordinates"]()]
    assert titles[:2] == ["a) Deformation of link, azimuth1", "b) dynamic part"]
    assert titles[4] == "e) Deformation of link, elevation1 (dynamic part at most 0.007 %)"


def test_a_force_from_zero_and_in_close_up_only_where_they_differ(good: Result) -> None:
    """Nearly constant in 2010; bounces on the plane otherwise, where both would be the same picture."""
    axes = [plot.all_figures(result)["contact_force"]() for result in (good, result_of("swinging"))]
    assert [len(one) for one in axes] == [4, 3]
    assert all(one[0].get_ylim()[0] == 0 for one in axes)


def test_forces_and_stresses_along_links_start_at_zero(good: Result) -> None:
    assert [panel.get_ylim()[0] for panel in plot.all_figures(good)["link_loads"]()[1::2]] == [0, 0]


def test_a_peak_of_few_samples_does_not_set_the_range(good: Result) -> None:
    data = good.data.copy(deep=True)
    series = data["deformation_oscillatory"]
    series[{"time": 3}] = 50 * np.abs(series).max()
    panel = plot.all_figures(Result(data))["gear_deflections"]()[1]
    largest, rest = (np.sort(np.abs(curve_values(panel)[0]))[k] for k in (-1, -2))
    assert largest > 40 * rest
    assert panel.get_ylim()[1] < 5 * rest
    assert f"{largest:.3g}" in panel.texts[0].get_text()


def test_the_instant_of_the_largest_deflection_is_shown() -> None:
    data = result_of("swinging").data
    bend = np.linalg.norm(data["line"] - data["line_rigid"], axis=data["line"].dims.index("axis"))
    times = [str(line.get_label()) for line in plot.elastic_line(result_of("swinging"))[0].get_lines()]
    sample = int(bend.reshape(len(bend), -1).max(axis=1).argmax())
    assert f"{float(data['time'][sample]):.3g} s" in times


def test_spectra_that_are_compared_have_one_scale(good: Result) -> None:
    actual, nominal, _ = plot.spectrum(good)
    assert (actual.get_xlim(), actual.get_ylim()) == (nominal.get_xlim(), nominal.get_ylim())


def test_legends_stay_off_the_curves(shown: dict[str, list[Any]]) -> None:
    for name, axes in shown.items():
        axes[0].figure.canvas.draw()
        for panel in axes:
            if legend := panel.get_legend():
                assert legend.get_window_extent().x0 > panel.get_window_extent().x1, name


def test_one_unit_for_panels_to_compare() -> None:
    common = ranges.common_unit
    assert common("rad", [0.2], [0.02]).name == "rad"
    assert common("rad", [0.8], [0.003]).name == "mrad"
    assert common("m", [2.0], [0.0], [0.5]).name == "m"
    assert common("rad", [2.0], [1e-9]).name == "mrad"  # thousands read well, millions do not
    assert common("N m", [0.0]).name == "N·m"
