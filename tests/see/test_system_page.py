"""The page of a system that is stated by its energies: its own lines, also live, and without its script."""

from __future__ import annotations

import html
import runpy
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

import tmodes
from live.node import live_in_node
from tmodes.equations.lagrange.system import SYSTEMS
from tmodes.errors import InputError
from tmodes.live.bundle import live_bundle
from tmodes.report.data import live_page
from tmodes.report.parts import viewer_document
from tmodes.report.scene import scene_of

EXAMPLE = Path(__file__).parents[2] / "examples" / "cart_with_flexible_pole.py"


@pytest.fixture(scope="module")
def cart() -> tmodes.Result:
    robot = runpy.run_path(str(EXAMPLE))["robot"]
    return tmodes.run(robot.with_({"integration.duration": 0.3, "integration.line_points": 3}))


def ends(scene: dict[str, Any]) -> Any:
    """Root and tip of each line at each frame (m, L, 2, 3)."""
    return np.asarray(scene["line"]).reshape(len(scene["times"]), len(scene["links"]), -1, 3)[:, :, [0, -1]]


def test_points_are_joined_with_the_tip_last(cart: tmodes.Result) -> None:
    scene = scene_of(cart)
    assert [link["name"] for link in scene["links"]] == ["cart-tip"]
    there = cart.data["position"].sel(point=["cart", "tip"], time=scene["times"])
    assert ends(scene)[:, 0] == pytest.approx(there.transpose("time", "point", "axis").values, abs=1e-6)
    assert scene["colours"] == []  # nothing is elastic in a way that lines show


def test_lines_of_one_s_own() -> None:
    places = {"tip": (1, 0, 0), "elbow": (0, 0, 1), "knee": (0, 1, 0)}

    def system(lines: Any) -> tmodes.System:
        def still(q: Any, p: Any) -> Any:
            del q, p
            return {name: ca.DM(place) for name, place in places.items()}

        return tmodes.System(
            "lined", {"x": "m"}, {"m": 1.0}, lambda q, v, p: p.m * v.x**2 / 2, points=still, lines=lines
        )

    wanted = (("origin", "elbow"), ("elbow", "tip"), ("origin", "knee"))
    assert system([["origin", "elbow", "tip"], ["origin", "knee"]]).segments == wanted
    assert system([]).segments == ()
    with pytest.raises(InputError, match="toe"):
        _ = system([["tip", "toe"]]).segments


def test_the_live_page_draws_them_too(cart: tmodes.Result, tmp_path: Path) -> None:
    """As the result has them, and where they are after a slider has moved."""
    bundle = live_bundle(cart)
    assert bundle is not None
    values = [slider["value"] for slider in live_page(cart)["live"]["sliders"]]
    longer = [1.5 * values[0], *values[1:]]
    runs = live_in_node(bundle, [values, longer], tmp_path)
    assert np.abs(runs[0]["scene"]["line"] - scene_of(cart, bundle["frames"])["line"]).max() < 1e-6
    for run in runs:
        tips = run["scene"]["line"][:, 0, -1]
        assert np.abs(tips - run["scene"]["tip"]).max() < 1e-12
    assert np.abs(runs[1]["scene"]["line"] - runs[0]["scene"]["line"]).max() > 1e-3


def test_a_result_whose_system_is_absent_opens_with_a_notice(
    cart: tmodes.Result, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    read = tmodes.Result.load(cart.save(tmp_path / "result.nc"))
    whole = scene_of(cart)
    monkeypatch.setattr(SYSTEMS, "_members", {})
    page = live_page(read)
    (run,) = page["runs"]
    assert ends(run["scene"]) == pytest.approx(ends(whole))
    assert page["live"] is None
    assert any("got `cart_with_flexible_pole`" in warning for warning in run["warnings"])
    shown = viewer_document(page).replace("\u00a0", " ")
    assert all(html.escape(warning.replace("`", "")) in shown for warning in run["warnings"])
