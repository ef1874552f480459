"""What every figure must keep, also one from outside tmodes: drawn, labelled, with units, nothing overlapping."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from typing import Any, ClassVar

import numpy as np
import pytest
from matplotlib import figure as mpl_figure

import tmodes
from see.runs import QUINTIC, SHEETS, result_of, sheet
from tmodes import plot
from tmodes.errors import InputError
from tmodes.plot.figure import rendered
from tmodes.plot.panels import letter, panels, readable, time_axis
from tmodes.result import Result

UNIT = re.compile(r"\[(n|µ|m|k|M)?(m|rad|rad/s|m/s|rad·s|N|N·m|J|V|A|s|Hz|W|Pa|–)\]$")


class JointPower(plot.Figure):
    """Power of each motor [W], a figure that a user writes in a script."""

    name = "joint_power"
    title = "Motor power"
    caption = "Power that each motor supplies."
    needs: ClassVar = {"drive": "no joint of this robot can be driven"}

    def draw(self, result: Any, ax: Any = None) -> list[Any]:
        """One panel with a curve for each drive."""
        data, axes = result.data, panels(ax, [["power"]], 2.3)
        drives = [str(name) for name in data["drive"].values]
        power = data["effort"].sel(drive=drives).values * data["v"].sel(coordinate=drives).values
        unit = readable("W", power)
        axes[0].plot(data["time"].values, unit.of(power))
        axes[0].set_ylabel(f"power [{unit.name}]")
        time_axis(axes[0], data["time"].values)
        letter(axes, ["Motor power"])
        return axes


NAMES = [*plot.FIGURES, "joint_power"]


@pytest.fixture(autouse=True, scope="module")
def outside() -> Iterator[None]:
    """A figure from outside the package, for the tests of this module."""
    plot.register(JointPower())
    yield
    plot.FIGURES.unregister("joint_power")


@pytest.fixture(scope="module", params=SHEETS)
def result(request: pytest.FixtureRequest) -> Result:
    return result_of(request.param)


@pytest.mark.parametrize("name", NAMES)
def test_it_draws_or_reports_why_not(name: str, result: Result, caplog: pytest.LogCaptureFixture) -> None:
    """Either it is drawn whole, or it gives a reason, never both."""
    figures, reasons = plot.all_figures(result), plot.left_out(result)
    assert (name in figures) != (name in reasons)
    if name in reasons:
        with pytest.raises(InputError, match=re.escape(reasons[name])):
            plot.FIGURES[name](result)
        return
    axes = figures[name]()
    assert_nothing_overlaps(axes)
    for index, panel in enumerate(axes):
        assert UNIT.search(panel.get_ylabel()), panel.get_ylabel()
        assert panel.get_title(loc="left").startswith(f"{chr(ord('a') + index)}) ")
        assert panel.has_data()
        bottom = panel.get_xlabel() or next(p.get_xlabel() for p in axes[index:] if p.get_xlabel())
        assert UNIT.search(bottom), bottom
    assert caplog.messages == []


@cache
def filling(name: str) -> Result:
    """A result that can fill a figure: a swinging robot's, but for what its controllers do not have."""
    if name != "controller_states":
        return result_of("swinging")
    gains = {"position_gain": 20.0, "integral_gain": 10.0, "velocity_gain": 4.0}
    laws = [{"type": "pid", **gains}, {"type": "sampled_pid", **gains, "sample_time": 0.02}]
    joints = [{"name": f"joint{k}", "type": "revolute", "child": f"link{k}", "axis": [0, 0, 1],
               "motor": {"inertia": 0.2, "side": "joint"}} for k in range(2)]  # fmt: skip
    drives = [{"joint": f"joint{k}", "command": "position", "signal": QUINTIC, "controller": laws[k]} for k in range(2)]
    links = [{"name": f"link{k}", "bodies": [{"name": "body", "mass": 1.0, "center": [0.2, 0, 0]}]} for k in range(2)]
    return tmodes.run(tmodes.Robot.from_data(sheet(joints=joints, links=links, drives=drives)))


def assert_nothing_overlaps(axes: list[Any]) -> None:
    """Titles, labels and legends of all panels keep apart."""
    whole = axes[0].figure
    whole.canvas.draw()
    drawer = whole.canvas.get_renderer()  # pyright: ignore[reportAttributeAccessIssue]
    titles: list[Any] = [vars(panel)[f"_{place}_title"] for panel in axes for place in ("left", "right")]
    words = [*titles, *(text for panel in axes for text in (panel.xaxis.label, panel.yaxis.label))]
    boxes = [text.get_window_extent(drawer) for text in words if text.get_text()]
    boxes += [legend.get_window_extent(drawer) for legend in whole.legends]
    for k, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[:k])
        assert box.x0 >= 0
        assert box.x1 <= whole.bbox.x1 + 1


def test_nothing_overlaps_in_the_states_of_controllers() -> None:
    """The others are looked at where they are drawn."""
    assert_nothing_overlaps(plot.FIGURES["controller_states"](filling("controller_states")))


@pytest.mark.parametrize("name", NAMES)
def test_it_draws_on_the_axes_it_is_given(name: str) -> None:
    result = filling(name)
    count = len(plot.FIGURES[name](result))
    axes = mpl_figure.Figure(figsize=(6, 9)).subplots(count, 1, squeeze=False)
    assert plot.FIGURES[name](result, axes) == list(axes.ravel())
    with pytest.raises(InputError, match=f"{count + 1} axes"):
        plot.FIGURES[name](result, mpl_figure.Figure().subplots(count + 1, 1))


@pytest.mark.parametrize("name", NAMES)
def test_a_single_sample_is_enough(name: str) -> None:
    """Or the figure reports why it is not."""
    short = Result(result_of("swinging").data.isel(time=slice(0, 1)))
    if name in (figures := plot.all_figures(short)):
        rendered(figures[name]()[0].figure, "svg")


@pytest.mark.parametrize("name", NAMES)
def test_words(name: str) -> None:
    figure = plot.FIGURES[name]
    assert figure.name == name
    assert figure.title[0].isupper()
    assert figure.caption.endswith(".")
    assert all(len(reason) > 10 for reason in figure.needs.values())


def test_the_figure_from_outside_shows_its_numbers() -> None:
    data = result_of("swinging").data
    (panel,) = plot.all_figures(result_of("swinging"))["joint_power"]()
    shown = np.asarray(panel.get_lines()[0].get_ydata())
    power = data["effort"].values[:, 0] * data["v"].sel(coordinate="shoulder").values
    assert shown / np.abs(shown).max() == pytest.approx(power / np.abs(power).max())


@pytest.mark.parametrize(("wrong", "words"), [
    ({"name": "tip_path"}, "a name that no figure has"),
    ({"name": "two words"}, "an identifier"),
    ({"name": "unknown", "caption": ""}, "without title or caption"),
])  # fmt: skip
def test_a_wrong_figure_is_refused(wrong: dict[str, str], words: str) -> None:
    before = list(plot.FIGURES)
    with pytest.raises(InputError, match=words):
        plot.register(type("Wrong", (JointPower,), wrong)())
    assert list(plot.FIGURES) == before
