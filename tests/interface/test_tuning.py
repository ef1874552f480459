"""Tuned gains: against SciPy on a closed form, against other searches, with limits, and for laws of other kinds."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Literal

import numpy as np
import pytest
from pydantic import Field
from scipy.optimize import minimize_scalar

import tmodes
from command import tmodes as command
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.controllers.registry import CONTROLLERS, Controller, Measured
from tmodes.study.page.figures import designs_data

KP, KV = "drives.0.controller.position_gain", "drives.0.controller.velocity_gain"
QUICK = {"integration.duration": 1.5, "integration.error_estimate": False, "integration.model_error": False}
SOFT = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.7, "high": 1.1}}


def spong(**changes: Any) -> tmodes.Robot:
    return tmodes.load("spong1987").with_({**QUICK, "gear.damping": 0.5} | changes)


def error_of(robot: tmodes.Robot) -> float:
    return robot.run().reduce("tip_error", "rms")


def test_gains_are_those_of_a_search_of_ones_own() -> None:
    """One gain on the run of the robot, by SciPy's bounded search; before and after are those of single runs.

    Without damping of its own the gear rings behind a stiff motor: the best motor is one that gives way.
    """
    robot = spong(gravity=0, **{"gear.damping": 0.0, "integration.duration": 3.0})
    found = robot.tune([KV], within=20.0)
    assert found.optimum.method == "gradient"
    best: Any = minimize_scalar(lambda kv: error_of(robot.with_({KV: float(kv)})), bounds=(0.6, 240.0))
    assert found.after == pytest.approx([best.fun], rel=1e-4)
    assert found.gains[0].after == pytest.approx(best.x, rel=0.02)  # where it is flat
    assert found.before == pytest.approx([error_of(robot)], rel=1e-6)
    assert error_of(found.robot) == pytest.approx(found.after[0], rel=1e-6)
    assert not found.gains[0].end
    assert not found.warnings
    assert any("gear joint" in one for one in found.limited)


def test_the_worst_case_of_a_family() -> None:
    robot = spong(real={"gear.stiffness": 0.9})
    found = robot.tune({KP: (20.0, 600.0), KV: (2.0, 80.0)}, uncertain={"k": SOFT}, worst_case=8)
    assert found.before.shape == found.after.shape == (8,)
    assert found.after.max() < 0.9 * found.before.max()
    assert found.robot.real == robot.real  # which the sheet says, not the family
    assert found.optimum.gradients > 0
    factors = found.optimum.trials.scenarios[:, 2] if found.optimum.trials else np.empty(0)
    each = [error_of(found.robot.with_({"real": {"gear.stiffness": float(k)}})) for k in factors]
    assert found.after == pytest.approx(each, rel=1e-5)


def test_a_gain_without_effect_is_named() -> None:
    """A limit of the command that is never reached; nothing else is idle, at an end of its range or not."""
    law = {"type": "pid", "position_gain": 60.0, "integral_gain": 30.0, "velocity_gain": 12.0, "limit": 1e4}
    limit = "drives.0.controller.limit"
    found = spong(**{"drives.0.controller": law}).tune({KP: (30.0, 120.0), limit: (5e3, 2e4)}, trials=5)
    effects = {one.path: one.effect for one in found.gains}
    assert effects[limit] == pytest.approx(0.0, abs=1e-6)
    best = found.robot.with_({"real": {}})
    ends = [error_of(best.with_({KP: end})) / error_of(best) - 1.0 for end in (30.0, 120.0)]
    assert effects[KP] == pytest.approx(max(map(abs, ends)), rel=1e-3)
    assert [one.path for one in found.gains if one.idle] == [limit]
    assert found.info()["gains"][1]["effect"] == effects[limit]


@pytest.mark.nightly
def test_the_drives_keep_their_limits() -> None:
    """Along gradients the best gains would need more than the joint allows; then limits are kept without them."""
    free = spong(**{"joints.0.limits": {"effort": 100.0}}).tune(within=4.0)
    needed = 100.0 * free.efforts["joint"]
    allowed = 0.95 * needed
    tight = spong(**{"joints.0.limits": {"effort": allowed}}).tune(within=4.0, trials=60)
    assert (free.optimum.method, tight.optimum.method) == ("gradient", "cobyqa")
    assert tight.efforts["joint"] <= 1.0
    assert tight.before[0] > tight.after[0] > free.after[0]
    peak = tight.robot.with_({"real": {}}).run().reduce("joint.effort", "max_abs")
    assert peak == pytest.approx(allowed * tight.efforts["joint"], rel=1e-6)


@pytest.mark.nightly("law1", "law2", "law3")
@pytest.mark.parametrize("law", [
    {"type": "feedback_linearisation", "pole": 4.0},
    {"type": "computed_torque", "position_gain": 9, "velocity_gain": 5},
    {"type": "lqr", "state_weights": {"joint": 300.0, "joint'": 3.0}},
    {"type": "state_feedback", "position_gains": {"joint": 60.0}, "velocity_gains": {"joint.motor": 12.0}},
])  # fmt: skip
def test_gains_of_any_law(law: dict[str, Any]) -> None:
    """As blocks, all that they name; without slopes where a law is sampled, or designed from the robot."""
    block = {"control": [{"name": "law", "drives": ["joint"], "block": law}], "drives.0.controller": None}
    found = spong(**block, **{"drives.0.signal": {"type": "septic", "start": 0.0, "end": 1.0, "duration": 1.0}}).tune(
        within=2.0, trials=12
    )
    assert {one.path.split(".")[:3] == ["control", "law", "block"] for one in found.gains} == {True}
    assert found.after[0] < found.before[0]


@pytest.mark.nightly
def test_what_has_no_slope_is_tuned_without() -> None:
    """A largest value; a sampled law has slopes along neighbours."""
    assert spong().tune(reduce="max", trials=12).optimum.method == "cobyqa"
    with pytest.raises(InputError, match="max"):
        spong().tune(reduce="max", method="gradient")
    sampled = spong(**{"drives.0.sample_time": 0.01}).tune([KV])
    assert sampled.optimum.method == "gradient"
    assert sampled.after[0] < sampled.before[0]


def test_efforts_of_all_designs(tmp_path: Path) -> None:
    """Gradients do not ask for them, the page shows them; what is not judged by limits is not said to keep any."""
    found = spong(**{"joints.0.limits": {"effort": 500.0}}).tune([KV], within=2.0)
    best, trials = found.optimum.best, found.optimum.trials
    assert best
    assert trials
    assert found.optimum.method == "gradient"
    assert np.isfinite(trials.values["effort_0"]).all()
    peak = found.robot.with_({"real": {}}).run().reduce("joint.effort", "max_abs")
    assert best.quantities["effort_0"][1] == pytest.approx(peak, rel=1e-6)
    assert KV in found.optimum.sentence
    assert {*designs_data(found.optimum, trials.study)[2]["words"]} == {"finished"}
    text = found.page(tmp_path / "tuned.html").read_text(encoding="utf-8")
    shown = re.sub(r"<(script|style).*?</\1>", "", text, flags=re.DOTALL)
    assert not re.search(r"\bnan\b|gain_0|effort_0|within all limits", shown)


def test_its_command(tmp_path: Path) -> None:
    out, figure, soft = tmp_path / "tuned.yaml", tmp_path / "tuned.svg", tmp_path / "soft.yaml"
    soft.write_text(json.dumps({"uncertain": {"k": SOFT}}), encoding="utf-8")
    line = ["tune", "spong1987", "--set", "integration.duration=1.5", "--gain", KV]
    said = command(*line, "--out", str(out), "--figure", str(figure)).stdout
    assert "rms of tip_error" in said
    assert "1 gain, " in said
    assert "along gradients" in said
    assert "designs tried" in figure.read_text(encoding="utf-8")
    info = json.loads(command(*line, "--uncertain", str(soft), "--worst-case", "4", "--json").stdout)
    assert (info["cases"], info["uncertain"]) == (4, ["k"])
    assert info["after"] < info["before"]
    tuned: Any = tmodes.load(out).drives[0].controller
    assert tuned.velocity_gain > 12.0
    assert tuned.position_gain == 80.0


@pytest.mark.parametrize(("given", "words"), [
    ({"gains": ["drives.0.controller.gain"]}, "drives.0.controller"), ({"gains": {KP: (1.0,)}}, r"\(low, high\)"),
    ({"gains": {KP: (3.0, 1.0)}}, "more than low"), ({"gains": ["drives.0.controller.offset"]}, "write a number"),
    ({"within": 1.0}, "a number > 1"), ({"minimize": "tip_eror"}, "tip_error"), ({"reduce": "mode"}, "reduce"),
    ({"uncertain": {"k": 3}}, "uncertain"), ({"method": "grid"}, "grid"),
    ({"against": "tip_error"}, "another output"), ({"against": "joint.efort"}, r"^against: .*joint\.effort"),
    ({"minimize": "tip.zz"}, r"^minimize: .*tip\.z"), ({"reduce": "rmss"}, "^reduce .*`rms`"),
    ({"against": "joint.effort", "against_reduce": "rmss"}, "^against_reduce .*`rms`"),
    ({"against": "joint.effort", "method": "gradient"}, "nsga2"), ({"method": "compromise"}, "two objectives"),
])  # fmt: skip
def test_what_is_wrong_is_said(given: dict[str, Any], words: str) -> None:
    tune: Any = spong().tune
    with pytest.raises((InputError, InputErrors), match=words):
        tune(**given)


def test_a_robot_without_gains() -> None:
    with pytest.raises(InputError, match="no law with gains"):
        spong(**{"drives.0.command": "prescribed", "drives.0.controller": None}).tune()


class Plain(Controller):
    """A law of a user, whose numbers are plain fields."""

    type: Literal["plain"] = Field(description="kind of controller")
    kp: float = Field(gt=0, strict=False, description="gain")
    rates_of: tuple[float, float] = Field(strict=False, description="gains of the rate and of the wanted one")

    def numbers(self) -> tuple[float, ...]:
        return self.kp, *self.rates_of

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        return p[0] * (m.wanted - m.position) + p[2] * m.wanted_rate - p[1] * m.velocity


def test_plain_numbers_of_a_law_of_a_user() -> None:
    CONTROLLERS.register(Plain)
    try:
        robot = spong(**{"drives.0.controller": {"type": "plain", "kp": 80.0, "rates_of": [12.0, 12.0]}})
        with pytest.raises(InputError) as caught:
            robot.tune()
        assert caught.value.which == "gains"
        assert "tuned" in caught.value.hint
        asked = ["drives.0.controller.kp", "drives.0.controller.rates_of.0"]
        found = robot.tune(asked, within=2.0, trials=4)
        own = spong().tune([KP, KV], within=2.0, trials=4)  # the same law
        assert [one.path for one in found.gains] == asked
        assert [one.unit for one in found.gains] == ["-", "-"]
        assert found.before == pytest.approx(own.before, rel=0.2)
        assert error_of(found.robot) == pytest.approx(found.after[0], rel=1e-6)
        assert found.after[0] < found.before[0]
    finally:
        CONTROLLERS.unregister("plain")


@pytest.mark.nightly
def test_an_error_against_an_effort(tmp_path: Path) -> None:
    """No design of a grid of one's own is better in both by more than the curve is coarse; each is that of a run."""
    robot = spong()
    found = robot.tune([KP, KV], against="joint.effort")
    assert found.optimum.method == "compromise"
    assert found.optimum.designs < 150
    curve = np.array([found.curve["error"].values, found.curve["against"].values]).T
    assert (np.diff(curve[:, 0]) > 0).all()
    assert (np.diff(curve[:, 1]) < 0).all()
    numbers = [found.at(3).run().reduce(name, "rms") for name in ("tip_error", "joint.effort")]
    assert numbers == pytest.approx(curve[3], rel=1e-6)
    for kp, kv in ((30.0, 12.0), (80.0, 40.0), (400.0, 100.0)):
        own = robot.with_({KP: kp, KV: kv}).run()
        error, effort = (own.reduce(name, "rms") for name in ("tip_error", "joint.effort"))
        assert (curve <= [1.03 * error, 1.03 * effort]).all(axis=1).any()
    assert found.against
    assert found.against.after[0] <= found.against.before[0]
    assert found.after[0] < 0.9 * found.before[0]
    assert error_of(found.robot) == pytest.approx(found.after[0], rel=1e-6)
    assert any("of which none is better in both" in str(part) for part in found.tables())
    assert found.info()["against"]["curve"] == curve.tolist()
    (axes,) = found.plot()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("rms of joint.effort [N·m]", "rms of tip_error [m]")
    text = found.page(tmp_path / "tuned.html").read_text(encoding="utf-8")
    assert "best compromises of rms of tip_error and rms of joint.effort" in text


def test_one_objective_has_no_curve() -> None:
    found = spong().tune([KV])
    with pytest.raises(InputError, match="against"):
        _ = found.curve
