"""What every figure of a study keeps, one of a user's script among them: words on its axes, files for each quantity."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from tmodes.errors import InputError
from tmodes.plot.studies import STUDY_FIGURES, StudyFigure, save_study_figures
from tmodes.plot.style import house_style, new_figure
from tmodes.study.page.data import ColumnInfo, page_data
from tmodes.study.rows import Rows


@STUDY_FIGURES.register
class Bare(StudyFigure):
    """A figure of a user's own."""

    name = "bare"
    title = "Sorted values"

    def missing(self, data: Any, quantity: Any) -> str:
        """Always there."""
        return ""

    def draw(self, data: Any, quantity: Any) -> Any:
        """Values in order."""
        figure = new_figure(2.0)
        axes = figure.subplots()
        axes.plot(np.sort(quantity["values"]))
        axes.set(xlabel="case", ylabel=quantity["name"])
        return figure


LIMIT = {"text": "peak ≤ 3 mm", "column": "peak", "bound": 3e-3, "sign": 1}
DESIGNS = {"x": "x", "y": "peak", "front": [0, 1], "best": 0, "start": {}, "limits": [LIMIT]}


def made(*, grid: bool = False, drawn: bool = True) -> dict[str, Any]:
    """The data of a study of two parameters and a choice."""
    if grid:
        x, y = (axis.ravel() for axis in np.meshgrid(np.linspace(0, 1, 6), np.linspace(2, 3, 5)))
        parameters = {"x": x, "y": y}
    else:
        draw = np.random.default_rng(0)
        parameters = {"x": draw.uniform(0, 1, 80), "y": draw.normal(2, 0.1, 80), "z": draw.integers(0, 3, 80) * 1.0}
    peak = 1e-3 * (parameters["x"] * parameters["y"] + 0.1 * parameters.get("z", 0.0))
    size = len(peak)
    status = ["finished"] * (size - 1) + ["diverged"]
    peak[-1] = np.nan
    rows = Rows(np.arange(size), parameters, {"peak": peak}, {"peak": "m"}, status, [""] * size, [""] * size,
                np.zeros(size))  # fmt: skip
    info = {"x": ColumnInfo("across", "N*m"), "z": ColumnInfo("size", "-", ("small", "large", "huge"))}
    times = np.linspace(0, 1, 20)
    band = {"title": "Tip x", "label": "Δx of the tip", "unit": "mm",
            "times": times, "shares": [5, 50, 95], "nominal": None, "cases": 80,
            "values": np.array([times - 1, times, times + 1])}  # fmt: skip
    index = {"quantity": "peak", "how": "", "names": ["x", "y"], "first": [[0.5, 0.4, 0.6], [0.4, 0.3, 0.5]],
             "total": [[0.6, 0.5, 0.7], [0.5, 0.4, 0.6]]}  # fmt: skip
    data = page_data("made", rows, info, drawn=drawn, bands=[band] if drawn else [], indices=[index],
                     designs=DESIGNS)  # fmt: skip
    effect = {"quantity": "peak", "unit": "m", "names": ["x", "y"], "size": [[0.5, 0.4, 0.6], [0.1, 0.0, 0.2]],
              "spread": [0.2, 0.1], "trajectories": 8}  # fmt: skip
    return data | {"effects": [effect]}


@pytest.mark.parametrize("name", sorted(STUDY_FIGURES))
def test_figure(name: str) -> None:
    """A title, words and units on the axes, the width of the house; nothing beyond the edges."""
    figure = STUDY_FIGURES[name]
    data = made(grid=name == "surface")
    quantity = data["quantities"][0]
    assert figure.title
    assert name.isidentifier()
    assert figure.missing(data, quantity) == ""
    with house_style():
        drawn = figure.draw(data, quantity)
        drawn.get_layout_engine().execute(drawn)
    assert drawn.get_size_inches()[0] == pytest.approx(6.3)
    words = [text for axes in drawn.axes for text in (axes.get_xlabel(), axes.get_ylabel()) if text]
    assert words or name == "cases"
    renderer = drawn.canvas.get_renderer()
    width, height = drawn.canvas.get_width_height()
    for axes in drawn.axes:
        box = axes.get_tightbbox(renderer)
        assert box.x0 > -3, name
        assert box.x1 < width + 3, name
        assert box.y0 > -3, name
        assert box.y1 < height + 3, name


def test_what_is_not_there_is_not_drawn(tmp_path: Path) -> None:
    """Cases that were chosen have no distribution and no bands; a grid has a surface."""
    files = {path.stem for path in save_study_figures(made(grid=True, drawn=False), tmp_path, ["svg"])}
    assert {"surface_peak", "responses_peak", "pareto", "sobol_peak"} <= files
    assert not {"distribution_peak", "bands"} & files
    drawn = {path.name for path in save_study_figures(made(), tmp_path, ["png"], ["distribution", "bands"])}
    assert drawn == {"distribution_peak.png", "bands.png"}


def test_an_unknown_figure_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"figures must be some of .*Did you mean `tornado`"):
        save_study_figures(made(), tmp_path, names=["tornados"])


def test_no_interval_ends_at_the_edge() -> None:
    """Neither of Sobol' indices, of which one may be below zero, nor of elementary effects."""
    data = made()
    data["indices"][0]["first"][1] = [0.0, -0.2, 0.2]
    data["indices"][0]["total"][0] = [0.6, 0.2, 1.1]
    with house_style():
        axes = STUDY_FIGURES["sobol"].draw(data, data["quantities"][0]).axes[0]
        assert axes.get_xlim()[0] < -0.2
        assert axes.get_xlim()[1] > 1.1
        axes = STUDY_FIGURES["morris"].draw(data, data["quantities"][0]).axes[0]
        assert axes.get_xlim()[1] > 0.6
        assert {"across", "y"} <= {text.get_text() for text in axes.texts}


def test_designs_beyond_a_limit_are_marked_as_such() -> None:
    """The last case did not reach its end: it is no design that could be chosen."""
    data = made()
    with house_style():
        axes = STUDY_FIGURES["pareto"].draw(data, data["quantities"][0]).axes[0]
    assert {line.get_label(): len(line.get_xdata()) for line in axes.lines} == {
        "beyond a limit": 1, "designs": 79, "front": 2, "best": 1, "peak ≤ 3 mm": 2,
    }  # fmt: skip


def test_no_line_leads_through_names() -> None:
    """Between entries of a catalogue lies nothing."""
    data = made()
    data["parameters"][0]["labels"] = [f"A{k}" for k in range(100)]
    data["parameters"][0]["values"] = np.arange(len(data["status"])) % 100.0
    with house_style():
        for name in ("pareto", "responses"):
            panel = STUDY_FIGURES[name].draw(data, data["quantities"][0]).axes[0]
            assert {line.get_linestyle() for line in panel.lines if len(line.get_xdata()) > 2} <= {"None", ""}, name


def test_lines_of_all_cases_stay_between_the_axes() -> None:
    """Ends of the axes are those of the cases that are shown, not of those that failed."""
    data = made()
    data["parameters"][0]["values"][-1] = -50.0
    with house_style():
        axes = STUDY_FIGURES["cases"].draw(data, data["quantities"][0]).axes[0]
    heights = np.concatenate([path.vertices[:, 1] for path in axes.collections[0].get_paths()])
    assert heights.min() == pytest.approx(0.0)
    assert heights.max() == pytest.approx(1.0)


def test_an_objective_that_is_a_formula_makes_a_name_of_a_file(tmp_path: Path) -> None:
    data = made()
    data["quantities"][0]["name"] = "peak / (1 + x)"
    files = save_study_figures(data, tmp_path, ["svg"], ["distribution"])
    assert [path.name for path in files] == ["distribution_peak_1_x.svg"]
