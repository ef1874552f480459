"""How a live arm ends: the span of its spectra, a run that breaks off, a run whose method changed on the way."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from simulation.sheets import landing
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.report.charts import charts_of
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

from .chain import chain
from .node import live_in_node, worst_difference

pytestmark = pytest.mark.nightly


def result_of(arm: Robot) -> Result:
    return assemble_result(simulate_motion(arm), arm)


def lived(result: Result, arm: Robot, folder: Path, **settings: Any) -> tuple[dict[str, Any], dict[str, Any]]:
    """The bundle of a result, and what the page's run of it gives with some settings of the integration changed."""
    bundle = live_bundle(result)
    assert bundle is not None
    bundle["settings"] |= settings
    (run,) = live_in_node(bundle, [[slider.value for slider in live_map(arm.pair()).sliders]], folder)
    return bundle, run


def spans(result: Result) -> list[tuple[float, float]]:
    """Of the report's own spectra."""
    return [chart["span"] for chart in charts_of([result])[0] if chart["abscissa"] == "frequency"]


@pytest.mark.parametrize(("duration", "first"), [(0.2, 0.0), (0.34, 0.0), (0.5, 0.205)])
def test_spectra_are_of_the_time_after_the_move_where_that_is_long_enough(
    tmp_path: Path, duration: float, first: float
) -> None:
    """A move of 0.2 s, a sample each 5 ms: of 32 samples after it, not of 28, as in the report; else of all."""
    arm = chain(2).with_({"integration.duration": duration})
    result = result_of(arm)
    _, run = lived(result, arm, tmp_path)
    assert run["span"] == pytest.approx([first, duration])
    assert len(spans(result)) > 0
    assert all(run["span"] == pytest.approx(span) for span in spans(result))


def test_the_span_moves_with_the_move(tmp_path: Path) -> None:
    """Moves of twice the duration leave no time after them."""
    arm = chain(2).with_({"integration.duration": 0.5})
    result, sliders = result_of(arm), live_map(arm.pair()).sliders
    bundle = live_bundle(result)
    assert bundle is not None
    values = [2.0 * one.value if "duration" in one.path else one.value for one in sliders]
    assert sum("duration" in one.path for one in sliders) == 2
    (run,) = live_in_node(bundle, [values], tmp_path)
    changed = result_of(arm.with_(live_map(arm.pair()).changes(values)))
    assert run["span"] == pytest.approx([0.0, 0.5])
    assert all(run["span"] == pytest.approx(span) for span in spans(changed))


def test_an_arm_that_breaks_off_shows_what_there_is(tmp_path: Path) -> None:
    """Half of its steps: it says so, is the native run as far as it went, and gives no number that needs the end."""
    arm = chain(2).with_({"integration.duration": 0.4})
    result = result_of(arm)
    steps = int(result.statistics["real"]["steps"]) // 2
    bundle, run = lived(result, arm, tmp_path, maxSteps=steps)
    assert run["status"] not in {"finished", ""}
    assert run["message"].startswith(("actual robot: ", "nominal run: "))
    count = len(run["times"])
    assert 10 < count < len(result.data["time"])
    assert worst_difference(run["series"], result.data.isel(time=slice(0, count)), {"energy_balance": 1.0})[0] < 1e-9
    shown = np.array([frame for frame in bundle["frames"] if frame < count])
    assert run["scene"]["times"][: len(shown)] == pytest.approx(bundle["times"][shown])
    assert run["scene"]["times"][-1] == pytest.approx(run["times"][-1])
    assert len(run["scene"]["line"]) == len(run["scene"]["tip"]) == len(run["scene"]["times"])
    assert run["facts"]["deviation.max"]["value"] is not None
    assert {run["facts"][name]["value"] for name in ("settling", "vibration.residual")} == {None}
    assert run["span"][1] == pytest.approx(run["times"][-1])


def test_a_run_whose_method_changed_says_by_what_the_page_makes_it(tmp_path: Path) -> None:
    """A landing that turns stiff: natively one method after the other, in the page the later one from the beginning."""
    arm = landing(method="auto")
    result = result_of(arm)
    bundle, run = lived(result, arm, tmp_path)
    assert bundle["settings"]["method"] == "extrapolation"
    assert bundle["settings"]["note"] == (
        "the run took dormand_prince, then extrapolation; here all of it is by extrapolation"
    )
    assert run["status"] == "finished"
    assert np.abs(run["series"]["q"] - result.data["q"].values).max() < 1e-6  # of a fall of 50 mm
    steady = landing(method="extrapolation")
    assert (live_bundle(result_of(steady)) or {})["settings"]["note"] == ""
