"""Loads along the links of an arm's run in the page: line panel, colours and headline numbers, as the native run's."""

from __future__ import annotations

from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import pytest

from tmodes import load
from tmodes.live.bundle import live_bundle
from tmodes.live.map import live_map
from tmodes.live.places import evenly, load_places
from tmodes.report.facts import run_facts
from tmodes.report.scene import line_of, scene_of
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

from .node import drawn, live_in_node

pytestmark = pytest.mark.nightly

SETTINGS = 1
EQUAL = 1e-9

FACTS = ("deflection.max", "moment.max", "stress.max", "stress.share", "limits.share")
_TIGHT = {"method": "dormand_prince", "output_step": 0.005, "relative_tolerance": 1e-12, "absolute_tolerance": 1e-14}
_ALONE = {"error_estimate": False, "model_error": False}
"""No further runs, by which errors are estimated: nothing here looks at those."""
_INERTIA = {"xx": 1e-3, "yy": 2e-3, "zz": 3e-3, "xy": 2e-4}


def _turning(k: int, axis: list[int], **more: Any) -> dict[str, Any]:
    gear, motor = {"stiffness": 300.0, "damping": 0.2}, {"inertia": 0.1, "side": "joint"}
    return {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis, "gear": gear, "motor": motor} | more


def _driven(k: int, end: float) -> dict[str, Any]:
    return {"joint": f"j{k}", "command": "position",
            "signal": {"type": "quintic", "start": 0.0, "end": end, "duration": 0.1},
            "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 12.0}}  # fmt: skip


def _beam(length: float, functions: dict[str, int], **more: Any) -> dict[str, Any]:
    return {"model": "strain", "functions": functions, "length": length, "damping_time": 2e-3} | more


def loaded() -> Robot:
    """A sliding cart with two links of a soft plastic: a tube that twists, stretches and is bent at rest; boxes.

    A body amid the one, a payload off the other's tip; a dead load, and one that turns with its section; a wall.
    """
    plastic = {"young": 6e8, "shear": 2e8, "density": 1200.0, "yield_strength": 2e7}
    tube = {"shape": "tube", "outer_diameter": 0.04, "thickness": 0.002}
    boxes = [{"end": 0.2, "section": {"shape": "box", "width": 0.03, "height": 0.02, "thickness": 0.002}},
             {"end": 0.35, "section": {"shape": "box", "width": 0.02, "height": 0.02, "thickness": 0.001}}]  # fmt: skip
    links = [
        {"name": "l0", "bodies": [{"name": "cart", "mass": 3.0, "inertia": _INERTIA, "center": [0.0, 0.1, 0.0]}]},
        {"name": "l1", "beam": _beam(0.45, {"twist": 1, "bend_y": 1, "bend_z": 1, "stretch": 1}, section=tube,
                                     rest_curvature=[0.1, 0.2, -0.3], rotary_inertia="full"),
         "bodies": [{"name": "valve", "mass": 0.3, "inertia": _INERTIA, "at": 0.4, "center": [0.0, 0.03, 0.02]}]},
        {"name": "l2", "beam": _beam(0.35, {"bend_y": 1}, pieces=boxes),
         "bodies": [{"name": "payload", "mass": 0.4, "inertia": _INERTIA, "at": 1.0, "center": [0.05, 0.0, 0.04]}]},
    ]  # fmt: skip
    for link in links[1:]:
        link["beam"]["material"] = plastic
    joints = [
        _turning(0, [1, 0, 0], limits={"effort": 900.0}) | {"type": "prismatic"},
        _turning(1, [0, 0, 1], limits={"lower": -1.0, "upper": 1.5}),
        _turning(2, [0, 1, 0], limits={"speed": 4.0}),
    ]
    loads = [
        {"point": "hook", "force": [0.0, 5.0, 2.0], "moment": [0.3, 0.0, 0.1], "frame": "section",
         "signal": {"type": "sine", "amplitude": 1.0, "frequency": 8.0}},
        {"force": [0.0, 0.0, -3.0], "frame": "world"},
    ]  # fmt: skip
    wall = {"shape": {"type": "plane", "position": [0.84, 0.0, 0.0], "normal": [-1.0, 0.0, 0.0]}, "law": "bilateral",
            "stiffness": 500.0, "damping": 5.0}  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "loaded", "gravity": 9.81, "joints": joints, "links": links,
        "drives": [_driven(0, 0.02), _driven(1, 0.2), _driven(2, -0.3)], "loads": loads, "contact": wall,
        "points": [{"name": "hook", "link": "l2", "at": 0.6, "position": [0.0, 0.02, 0.0]}],
        "real": {"joints.j1.gear.stiffness": 0.7},
        "integration": {**_TIGHT, **_ALONE, "duration": 0.12, "line_points": 30},
    })  # fmt: skip


class Case(NamedTuple):
    """A bundle, and next to each run in the page the native result of the same setting."""

    bundle: dict[str, Any]
    runs: list[dict[str, Any]]
    results: list[Result]


@pytest.fixture(scope="module")
def case(tmp_path_factory: pytest.TempPathFactory) -> Case:
    arm = loaded()
    live = live_map(arm.pair(), (0.0, 1.0))
    jobs = [  # a line has a place at each body, and those of a page stay where they were
        [own.value if own.path.endswith(".at") else value for own, value in zip(live.sliders, job, strict=True)]
        for job in drawn(live, SETTINGS, seed=11)
    ]
    arms = [arm, *(arm.with_(live.changes(values)) for values in jobs)]
    results = [assemble_result(simulate_motion(one), one) for one in arms]
    bundle = live_bundle(results[0])
    assert bundle is not None
    jobs = [[slider.value for slider in live.sliders], *jobs]
    return Case(bundle, live_in_node(bundle, jobs, tmp_path_factory.mktemp("live")), results)


def frames_of(case: Case) -> Any:
    return np.asarray(case.bundle["frames"], dtype=np.intp)


def shown(case: Case, result: Result, name: str) -> Any:
    """A series along the links at the frames and at the stations that are shown."""
    stations = np.searchsorted(result.data["s"].values, case.bundle["stations"] - 1e-9)
    return result.data[name].isel(time=frames_of(case), s=stations).values


def same(values: Any, true: Any, name: str) -> None:
    assert np.abs(values.reshape(true.shape) - true).max() <= EQUAL * np.abs(true).max(), name


def test_line_panel_is_that_of_the_native_run(case: Case) -> None:
    for run, result in zip(case.runs, case.results, strict=True):
        panel, page = run["line"], line_of(result, frames_of(case))
        assert page is not None
        assert panel["links"] == page["links"]
        assert [one["id"] for one in panel["quantities"]] == [one["id"] for one in page["quantities"]]
        for own, there in zip(panel["quantities"], page["quantities"], strict=True):
            assert {**own, "values": 0} == {**there, "values": 0}
            same(own["values"], shown(case, result, own["id"]), own["id"])


def test_links_are_coloured_by_the_loads_of_the_new_run(case: Case) -> None:
    """By all that colours the page's own scene, displacement apart: the page takes the model's own line for it."""
    links = case.results[0].data["bending_link"].values
    kinds = [colour["id"] for colour in scene_of(case.results[0], frames_of(case))["colours"]]
    drawn = [link["name"] for link in case.bundle["links"]]
    for run, result in zip(case.runs, case.results, strict=True):
        colours = {one["id"]: one["values"] for one in run["scene"]["colours"]}
        assert list(colours) == kinds
        true = {"bending_moment": np.linalg.norm(shown(case, result, "moment")[..., 1:], axis=-1),
                "torsion": np.abs(shown(case, result, "moment")[..., 0]),
                "deflection": np.linalg.norm(shown(case, result, "deflection"), axis=-1)}  # fmt: skip
        true |= {name: shown(case, result, name) for name in ("stress", "strain")}
        assert [*true, "displacement"] == kinds
        bends = [name in links for name in drawn]
        for name, values in true.items():
            whole = colours[name].reshape(len(values), len(drawn), -1)
            same(whole[:, bends], values, name)
            assert not whole[:, np.logical_not(bends)].any()


def test_headline_numbers_are_of_the_new_run(case: Case) -> None:
    """The largest loads at all samples, and shares of strengths and limits: value, and when and where."""
    for run, result in zip(case.runs, case.results, strict=True):
        info = {fact.id: fact for fact in run_facts(result, result.summary())}
        for name in FACTS:
            assert run["facts"][name]["value"] == pytest.approx(info[name].value, rel=EQUAL), name
            assert run["facts"][name]["note"].replace("\xa0", " ") == info[name].note.replace("\xa0", " "), name


def test_of_very_many_samples_some_are_looked_at(case: Case, tmp_path: Path) -> None:
    """The note says so; what is shown at the frames is as before."""
    dense = 334
    times = np.linspace(0.0, case.bundle["times"][-1], dense * (len(case.bundle["times"]) - 1) + 1)
    more = {"times": times, "frames": (dense * frames_of(case)).astype(np.int32)}
    sliders = [slider["value"] for slider in case.bundle["sliders"]]
    (run,) = live_in_node(case.bundle | more, [sliders], tmp_path)
    info = {fact.id: fact for fact in run_facts(case.results[0], case.results[0].summary())}
    assert run["facts"]["moment.max"]["note"].endswith("(looked at: one sample in 2)")
    assert run["facts"]["moment.max"]["value"] == pytest.approx(info["moment.max"].value, rel=1e-2)
    for quantity in run["line"]["quantities"]:
        same(quantity["values"], shown(case, case.results[0], quantity["id"]), quantity["id"])


def test_places_of_a_finely_kept_line_are_some_of_its_own() -> None:
    """Ends among them, and no more than a page can look at."""
    chain = load("spong1987").chain()
    fine, places = np.linspace(0.0, 1.0, 1001), load_places(chain, 1001)
    assert {*places} < {*fine}
    assert (places[0], places[-1], len(places)) == (0.0, 1.0, 101)
    assert np.array_equal(load_places(chain, 30), np.linspace(0.0, 1.0, 30))
    assert evenly(30, 21).tolist() == sorted({*evenly(30, 21).tolist()})
    assert (evenly(30, 21)[0], evenly(30, 21)[-1]) == (0, 29)
