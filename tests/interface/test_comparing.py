"""A league of variants: its numbers against runs of one's own, its file, its command, and what is refused."""

from __future__ import annotations

import csv
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from command import tmodes as command
from tmodes.errors import InputError, InputErrors
from tmodes.io.sheet_write import robot_to_yaml

SOFT = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.7, "high": 1.1}}
STIFF = {"drives.0.controller.position_gain": 160.0}
QUICK = {"integration.duration": 1.5, "integration.error_estimate": False, "integration.model_error": False}
LAWS = {"as it is": {}, "stiff": STIFF, "shaped": {"shaper": {"kind": "zv"}}}


def robot() -> tmodes.Robot:
    return tmodes.load("spong1987").with_(QUICK)


def test_its_numbers_are_those_of_single_runs() -> None:
    """Nominal and of each case, of runs of the same robots one by one; the first is the one that fails least."""
    found = robot().compare(LAWS, uncertain={"k": SOFT}, plan={"type": "grid", "levels": 3}, tolerance="90 mm")
    variants = {"as it is": robot(), "stiff": robot().with_(STIFF), "shaped": robot().shaper(kind="zv").robot}
    worst = {}
    for name, one in variants.items():
        row = found.data.sel(variant=name)
        verdict = one.run().summary()["verdict"]
        assert row["nominal_largest_m"] == pytest.approx(verdict["largest_m"], rel=1e-6)
        assert row["nominal_final_m"] == pytest.approx(verdict["final_m"], rel=1e-6, abs=1e-9)
        actual = [one.with_({"real": {"gear.stiffness": k}}).run().reduce("tip_error", "max") for k in (0.7, 0.9, 1.1)]
        assert sorted(row["error"].values) == pytest.approx(sorted(actual), rel=1e-5)
        worst[name] = (np.sum(np.array(actual) > 0.09), max(actual))
    assert [one.name for one in found.ranked] == sorted(worst, key=lambda name: worst[name])
    assert [one.failed(0.09) for one in found.contenders] == [worst[name][0] for name in variants]
    assert "interval" not in found.info()["variants"][0]["cases"]["fails"]  # of a grid, which is no sample


def test_every_variant_has_the_same_cases_and_noise() -> None:
    noise = {"type": "encoder", "name": "teeth", "joint": "joint", "sample_time": 0.01, "noise": 0.01, "seed": 3}
    law = {"type": "pd", "position_gain": 80.0, "velocity_gain": 12.0}
    own = robot().with_({"sensors": [noise]})
    laws = {"one": {}, "two": {}, "block": {"control": [{"name": "law", "drives": ["joint"], "block": law}]}}
    found = own.compare(laws, uncertain={"k": SOFT}, runs=8)
    one, two, block = found.data["error"].values
    assert np.array_equal(one, two)
    assert block == pytest.approx(one, rel=1e-9)  # the same law, as a block that takes the drive over
    assert len({*one.tolist()}) == 8
    assert not found.warnings


def test_shares_have_their_bounds_and_failures_their_reason() -> None:
    """A loop that its delay makes unstable: all of its cases leave the tolerance, 3.7/n at 97.5 % (rule of three)."""
    wild = {"drives.0.delay": 0.2, "drives.0.sample_time": 0.01, "drives.0.controller.position_gain": 3000.0}
    found = robot().compare({"calm": {}, "wild": wild}, uncertain={"k": SOFT}, runs=20, tolerance=1.0)
    calm, late = found.info()["variants"]
    assert (calm["name"], late["name"]) == ("calm", "wild")
    assert (calm["cases"]["fails"]["count"], late["cases"]["fails"]["count"]) == (0, 20)
    assert calm["cases"]["fails"]["interval"] == pytest.approx([0.0, 1 - 0.025 ** (1 / 20)])
    assert late["cases"]["fails"]["interval"] == pytest.approx([0.025 ** (1 / 20), 1.0])


def test_the_error_by_what_is_uncertain(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """Each parameter alone at its worse end, and the rest of the worst corner, are those of single runs."""
    heavy = {"path": "links.link.bodies.bob.mass", "relative": True,
             "distribution": {"type": "uniform", "low": 0.8, "high": 1.2}}  # fmt: skip
    own = robot().with_({"real": {"gear.stiffness": 0.9}})  # for which the uncertain number stands
    found = own.compare({"own": {}}, uncertain={"k": SOFT, "m": heavy}, plan={"type": "tolerance"})

    def largest(k: float = 1.0, m: float = 1.0) -> float:
        real = {"gear.stiffness": k, "links.link.bodies.bob.mass": m}
        return robot().with_({"real": real}).run().reduce("tip_error", "max")

    known, (one,) = largest(), found.contenders
    soft, other = (max(0.0, *(largest(**{name: end}) - known for end in ends)) for name, ends in
                   {"k": (0.7, 1.1), "m": (0.8, 1.2)}.items())  # fmt: skip
    worst = max(largest(k, m) for k in (0.7, 1.1) for m in (0.8, 1.2))
    assert [*one.attribution.values()] == pytest.approx([soft, other, worst - known - soft - other], abs=1e-7)
    assert known + sum(one.attribution.values()) == pytest.approx(worst, abs=1e-7)
    assert found.info()["variants"][0]["attribution_m"] == one.attribution
    (axes,) = found.plot()
    assert [bar.get_label() for bar in axes.containers] == ["as known", "k", "m", "remainder"]
    widths = [bar[0].get_width() for bar in axes.containers]
    assert widths == pytest.approx([1e3 * known, *(1e3 * part for part in one.attribution.values())])
    assert axes.get_xlabel() == "largest error of the tip [mm], by what is uncertain"
    assert any("worst corner" in part.columns for part in found.tables() if not isinstance(part, str))
    pages: list[Any] = []
    monkeypatch.setattr("tmodes.interface.league.write_plots", lambda page, path: pages.append(page))
    found.page(tmp_path / "league.html")
    added = {curve.name: curve.x for plot in pages[0].plots for curve in plot.curves}
    assert [added[name] for name in one.attribution] == [[1e3 * part] for part in one.attribution.values()]
    assert robot().compare({"own": {}}, uncertain={"k": SOFT}, runs=2).contenders[0].attribution == {}


def test_the_actual_robot_of_a_sheet_is_its_only_case() -> None:
    found = robot().with_({"real": {"gear.stiffness": 0.8}}).compare({"as it is": {}})
    (one,) = found.contenders
    assert one.actual
    assert one.errors == pytest.approx([one.actual.largest_m])
    assert found.cases == 1
    assert "of the actual robot" in str(found)


def test_unfair_comparisons_are_named() -> None:
    found = robot().compare({"own": {}, "light": {"links.0.bodies.0.mass": 0.5}, "near": {"drives.0.signal.end": 0.5}})
    light, near = found.warnings
    assert "`light` and `own` differ in more than their laws and signals: links" in light
    assert "`near` and `own` do not move between the same ends: joint" in near


def test_its_command(tmp_path: Path) -> None:
    laws, figure, out = tmp_path / "laws.yaml", tmp_path / "league.svg", tmp_path / "cases"
    laws.write_text(json.dumps({"variants": LAWS, "uncertain": {"k": SOFT}, "tolerance": "90 mm"}), encoding="utf-8")
    line = [
        "compare",
        "spong1987",
        *(f"--set={path}={value}" for path, value in QUICK.items()),
        "--variants",
        str(laws),
    ]
    said = command(*line, "--runs", "6", "--figure", str(figure), "--out", str(out)).stdout
    assert said.startswith("Best: ")
    assert "3 variants, tolerance 90 mm" in said
    assert "worst of 6" in figure.read_text(encoding="utf-8")
    assert f"Page: {out / 'compare.html'}" in said
    rows = [*csv.DictReader((out / "compare.csv").read_text(encoding="utf-8").splitlines())]
    assert sorted(row["name"] for row in rows) == sorted(LAWS)
    assert [float(row["cases.fails.share"]) for row in rows] == sorted(float(row["cases.fails.share"]) for row in rows)
    assert not [*out.glob("*/report.html")]
    again = json.loads(command(*line, "--runs", "6", "--out", str(out), "--json").stdout)
    own = robot().compare(laws, runs=6).info()
    assert [one["cases"] for one in again["variants"]] == [one["cases"] for one in own["variants"]]


def test_sheets_side_by_side(tmp_path: Path) -> None:
    for name, changes in {"soft": {}, "stiff": STIFF}.items():
        (tmp_path / f"{name}.yaml").write_text(robot_to_yaml(robot().with_(changes)), encoding="utf-8")
    found = json.loads(command("compare", str(tmp_path / "soft.yaml"), str(tmp_path / "stiff.yaml"), "--json").stdout)
    assert [one["name"] for one in found["variants"]] == ["stiff", "soft"]


@pytest.mark.parametrize(("given", "words"), [
    ({"variants": {}}, "1 to 50"), ({"variants": {"a": 3}}, "variants.a"),
    ({"variants": {"a": {"drives.0.controller": {"type": "pdd"}}}}, "variants.a.drives.0.controller.type"),
    ({"variants": {"a": {"shaper": {"kin": "zv"}}}}, "Did you mean `kind`"), ({"tolerance": -1}, "a length > 0"),
    ({"uncertain": {"k": 3}}, "uncertain.k"), ({"uncertain": {"k": {**SOFT, "path": "gear.stif"}}}, "gear.stiffness"),
    ({"uncertain": {"k": {**SOFT, "relative": False}}}, "write `relative: true`"),
    ({"uncertain": {"k": SOFT}, "plan": {"type": "grid", "levels": 2}, "runs": 5}, "grid"),
    ({"figure": "league.txt"}, r"\.svg"),
])  # fmt: skip
def test_what_is_wrong_is_said(given: dict[str, Any], words: str) -> None:
    compare: Any = robot().compare
    with pytest.raises((InputError, InputErrors), match=words):
        compare(**{"variants": {"a": {}}} | given)


def test_errors_of_a_file_have_their_line(tmp_path: Path) -> None:
    laws = tmp_path / "laws.yaml"
    laws.write_text("variants:\n  a: {}\n  b: {drives.0.controller.gain: 3}\n", encoding="utf-8")
    with pytest.raises(InputError, match=r"laws\.yaml:3.*variants\.b\.drives\.0\.controller"):
        robot().compare(laws)
    laws.write_text("variant: {}\n", encoding="utf-8")
    with pytest.raises(InputError, match="Did you mean `variants`"):
        robot().compare(laws)


@pytest.mark.nightly
def test_a_system_stated_by_its_energies_has_a_commanded_path_too() -> None:
    """Its free coordinates are in it as they move in the nominal run: uncertain cases as the runs of their sheets."""
    robot = tmodes.load("moberg2009").with_({"integration.duration": 0.4})
    softer = {"k2": {"path": "parameters.stiffness2", "relative": True,
                     "distribution": {"type": "uniform", "low": 0.5, "high": 0.9}}}  # fmt: skip
    found = robot.compare({"as it is": {}}, uncertain=softer, plan={"type": "grid", "levels": 3})
    assert found.contenders[0].errors.shape == (3,)
    for factor, error in zip((0.5, 0.7, 0.9), found.contenders[0].errors, strict=True):
        alone = robot.with_({"real": {"parameters.stiffness2": factor}}).run(error_estimate=False, model_error=False)
        assert error == pytest.approx(float(abs(alone.output("tip_error")).max()), rel=1e-6)
