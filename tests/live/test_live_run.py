"""An arm's run in the page equals the native one: two flexible links, motors, gears, gravity, a payload, a wall."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from simulation.test_jolts import hinged, ramps
from tmodes import load
from tmodes.io.mesh_file import box
from tmodes.io.urdf_shapes import LinkShape
from tmodes.io.yaml_file import parse_yaml
from tmodes.live.bundle import live_bundle, why_not_live
from tmodes.live.map import LiveMap, live_map
from tmodes.live.numbers import run_numbers, whole_moves
from tmodes.live.sliders import MOST
from tmodes.report.meshes import with_shapes
from tmodes.report.pack import pack
from tmodes.report.scene import scene_of
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.simulation.outputs import robot_outputs
from tmodes.simulation.plan import Follow
from tmodes.simulation.simulate import simulate_motion

from .chain import chain
from .node import drawn, live_in_node, worst_difference

SETTINGS = 10
EQUAL = 1e-9
DRAWN = 1e-7
"""Bound of the picture [m]: the page takes the model's own line, a result one on a finer grid along each link."""

LINES = {"line", "line_rigid", "deflection", "slope", "moment", "elastic_moment", "shear_force", "axial_force",
         "stress", "strain"}  # fmt: skip
"""What the page shows in its scene and its panel alone."""

_WALL = {"shape": {"type": "wall", "distance": 0.87}, "law": "bilateral", "stiffness": 500.0, "damping": 5.0}


def two_links() -> Robot:
    """Soft enough for an explicit method: its own error is then below what is compared."""
    links = [
        {"name": f"l{k}", "beam": {
            "model": "strain", "functions": {"bend_y": 1, "bend_z": 2 - k}, "length": 0.5 - 0.1 * k,
            "section": {"bending_stiffness": 40.0 - 15 * k, "mass_per_length": 1.5},
            "damping_time": 1e-3, "rotary_inertia": "none",
        }}
        for k in range(2)
    ]  # fmt: skip
    links[1]["bodies"] = [{"name": "payload", "mass": 0.4, "inertia": {"xx": 1e-3, "yy": 1e-3, "zz": 1e-3}, "at": 1.0}]
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis,
         "gear": {"stiffness": 300.0, "damping": 0.2}, "motor": {"inertia": 0.1, "side": "joint"}}
        for k, axis in enumerate(([0, 0, 1], [0, 1, 0]))
    ]  # fmt: skip
    drives = [
        {"joint": f"j{k}", "command": "position", "signal": signal,
         "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 12.0}}
        for k, signal in enumerate((
            {"type": "quintic", "start": 0.0, "end": 0.3, "duration": 0.2},
            {"type": "trapezoid", "start": 0.1, "end": 0.3, "duration": 0.15, "ramp_fraction": 0.3, "delay": 0.02},
        ))
    ]  # fmt: skip
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "<two>: links", "gravity": 9.81, "joints": joints, "links": links,
        "drives": drives, "contact": _WALL, "real": {"joints.0.gear.stiffness": 0.8, "joints.j1.gear.stiffness": 0.6},
        "integration": {"method": "dormand_prince", "duration": 0.2, "output_step": 0.005, "line_points": 5,
                        "relative_tolerance": 1e-12, "absolute_tolerance": 1e-14},
    })  # fmt: skip


def result_of(arm: Robot) -> Result:
    return assemble_result(simulate_motion(arm), arm)


def unchanged(live: LiveMap) -> list[float]:
    return [slider.value for slider in live.sliders]


def settings(live: LiveMap) -> list[list[float]]:
    return drawn(live, SETTINGS, seed=7)


@pytest.fixture(scope="module")
def native() -> Result:
    return result_of(two_links())


@pytest.fixture(scope="module")
def live() -> LiveMap:
    return live_map(two_links().pair(), (0.0, 1.0))


@pytest.fixture(scope="module")
def bundle(native: Result) -> dict[str, Any]:
    found = live_bundle(native)
    assert found is not None
    return found


@pytest.fixture(scope="module")
def runs(bundle: dict[str, Any], live: LiveMap, tmp_path_factory: pytest.TempPathFactory) -> list[dict[str, Any]]:
    return live_in_node(bundle, [unchanged(live), *settings(live)], tmp_path_factory.mktemp("live"))


def test_page_has_outputs_by_their_names(native: Result, runs: list[dict[str, Any]]) -> None:
    """What a result stores of an output is in the page's series of the same name, at the same place."""
    data, series, found = native.record, runs[0]["series"], set()
    for name, output in robot_outputs(native.actual).items():
        variable, *labels = output.stored or ("",)
        if variable not in series:
            continue
        dims = data[variable].dims[1:]
        place = tuple(data.places(dim, label) for dim, label in zip(dims, labels, strict=True))
        expected = native.output(name).values
        size = max(float(np.abs(data[variable].values).max()), 1e-9)
        assert series[variable][:, *place] == pytest.approx(expected, rel=0, abs=EQUAL * size), name
        found.add(name.rpartition(".")[2])
    assert {"position", "velocity", "acceleration", "effort", "gear_torque", "gear_twist", "x", "kinetic"} <= found
    assert {"penetration", "force", "motor", "deviation"} <= found


def scales(data: Any) -> dict[str, float]:
    energy = data["energy"].values
    parts = ("deformation_stationary", "deformation_oscillatory")  # what is split sets what rounding leaves of them
    return {
        "energy_balance": max(float(np.abs(energy - energy[0]).max()), float(np.abs(data["work"].values).max())),
        **dict.fromkeys(parts, float(np.abs(data["deformation"].values).max())),
    }


def test_page_equals_native_run_unchanged_and_at_ten_random_settings(
    native: Result, live: LiveMap, runs: list[dict[str, Any]]
) -> None:
    """Every series along time but those of the elastic lines."""
    arms = [two_links().with_(live.changes(values)) for values in settings(live)]
    for run, result in zip(runs, [native, *map(result_of, arms)], strict=True):
        assert run["status"] == result.status == "finished"
        assert set(run["series"]) == {str(name) for name, one in result.data.items() if "time" in one.dims} - LINES
        difference, name = worst_difference(run["series"], result.data, scales(result.data))
        assert difference < EQUAL, name


def test_picture_is_that_of_the_result(native: Result, bundle: dict[str, Any], runs: list[dict[str, Any]]) -> None:
    """The lines of all links at the display frames, bent and without elasticity; the first frame is at rest."""
    at = native.data.isel(time=bundle["frames"])
    for name, variable in (("line", "line"), ("rigid", "line_rigid")):
        true = at[variable].transpose("time", "link", "s", "axis").values
        assert np.abs(runs[0]["scene"][name] - true).max() < DRAWN
    assert np.abs(runs[0]["scene"]["line"] - runs[0]["scene"]["rigid"]).max() > 1e-4
    bent = at["deflection"].transpose("time", "bending_link", "s", "plane").values
    (shown,) = (one["values"] for one in runs[0]["scene"]["colours"] if one["id"] == "deflection")
    true = np.linalg.norm(bent, axis=-1)
    assert np.abs(shown - true).max() < EQUAL * true.max()


def test_the_surface_follows_its_slider(live: LiveMap, runs: list[dict[str, Any]]) -> None:
    """The wall of each run is where the changed sheet has it, and the contact there is the native one's."""
    assert "distance of the wall" in [slider.label for slider in live.sliders]
    for values, run in zip([unchanged(live), *settings(live)], runs, strict=True):
        contact = two_links().with_(live.changes(values)).contact
        assert contact is not None
        shown, true = run["scene"]["contact"]["surface"], contact.shape.drawing()
        assert shown["kind"] == true["kind"] == "plane"
        assert np.allclose(shown["position"], true["position"], rtol=1e-12)
    places = {tuple(run["scene"]["contact"]["surface"]["position"]) for run in runs}
    assert len(places) == SETTINGS + 1


PRESSED = {
    "links.l1.bodies.payload.mass": 0.146, "joints.j0.gear.stiffness.0": 291.5, "joints.j1.gear.stiffness.0": 300.7,
    "real:joints.j0.gear.stiffness.0": 1.415, "real:joints.j1.gear.stiffness.0": 0.802, "contact.stiffness": 1516.0,
    "links.*.beam.section.bending_stiffness.*": 0.264, "real:links.*.beam.section.bending_stiffness.*": 1.677,
    "contact.shape.distance": 0.7965,
}  # fmt: skip
"""Pressed so hard by the wall that the arm could rest bent to the one side or to the other."""


@pytest.mark.nightly
def test_rest_stays_on_its_branch(bundle: dict[str, Any], live: LiveMap, tmp_path: Path) -> None:
    """Newton's method alone would leap to the other side, -0.13 in place of 0.38."""
    values = [PRESSED.get(slider.path, slider.value) for slider in live.sliders]
    (run,) = live_in_node(bundle, [values], tmp_path)
    native = result_of(two_links().with_(live.changes(values))).data["q"].values[0]
    assert native[4] > 0.3
    assert run["series"]["q"][0] == pytest.approx(native, abs=1e-8)


SURFACES = (
    ({"type": "plane", "position": [0.3, 0.0, 0.1], "normal": [0.6, 0.0, 0.8]}, "contact.shape.position.2"),
    ({"type": "ball", "center": [0.0, 0.0, -1.0], "radius": 1.0}, "contact.shape.radius"),
)


@pytest.mark.parametrize(("shape", "path"), SURFACES, ids=["plane", "ball"])
def test_every_kind_of_surface_has_a_slider(shape: dict[str, Any], path: str) -> None:
    """Both ways by three hundredths of the arm's length; numbers and picture are those of the changed sheet."""
    arm = two_links().with_({"contact.shape": shape})
    live = live_map(arm.pair(), (0.0, 1.0))
    (slider,) = (one for one in live.sliders[:MOST] if one.path.startswith("contact.shape"))
    assert slider.path == path
    assert (slider.low, slider.high) == pytest.approx((slider.value - 0.027, slider.value + 0.027))
    values = [one.high if one is slider else one.value for one in live.sliders]
    moved = arm.with_({path: slider.high})
    assert live.changes(values) == {path: slider.high}
    assert moved.contact is not None
    numbers = live.numbers(values, "real")
    assert numbers["surface"] == pytest.approx(moved.contact.shape.moving_numbers(), rel=1e-12)
    true = run_numbers(moved.pair().real, Follow.SHEET, whole_moves(arm, 1e4), (0.0, 1.0))
    assert numbers["parameters"] == pytest.approx(true["parameters"], rel=1e-12)


def test_headline_numbers_are_those_of_the_summary(native: Result, runs: list[dict[str, Any]]) -> None:
    summary, facts = native.summary(), runs[0]["facts"]
    gears = [one["max"] for name, one in summary["deformations"].items() if name.endswith(".gear")]
    expected = {
        "deviation.max": summary["deviation"]["max_m"],
        "contact.mean": summary["contact_force"]["mean_N"],
        "gear.max": max(gears),
    }  # fmt: skip
    assert {name: facts[name]["value"] for name in expected} == pytest.approx(expected, rel=EQUAL)
    bent = max(link["deflection"]["max_m"] for link in summary["links"].values())
    assert facts["deflection.max"]["value"] == pytest.approx(bent, rel=EQUAL)


def test_saved_sheet_is_that_of_the_settings(live: LiveMap, runs: list[dict[str, Any]]) -> None:
    for values, run in zip([unchanged(live), *settings(live)], runs, strict=True):
        data, _ = parse_yaml(run["sheet"], "page")
        assert Robot.from_data(data) == two_links().with_(live.changes(values))


@pytest.mark.nightly
def test_an_arm_without_a_reference_run(tmp_path: Path) -> None:
    """A step that no motor can follow: nothing is compared, and nothing is missing."""
    arm = load("quanser_2dsfl", {"integration.duration": 0.3, "integration.method": "dop853"})
    assert isinstance(arm, Robot)
    result = result_of(arm)
    bundle = live_bundle(result)
    assert bundle is not None
    (run,) = live_in_node(bundle, [unchanged(live_map(arm.pair()))], tmp_path)
    assert "deviation" not in run["series"]
    assert run["scene"]["reference"] is None
    assert worst_difference(run["series"], result.data, scales(result.data))[0] < 1e-8


def test_bundle_of_a_saved_result_is_the_same(native: Result, bundle: dict[str, Any], tmp_path: Path) -> None:
    """A report that is made later, from the file."""
    again = live_bundle(Result.load(native.save(tmp_path / "result.nc")))
    assert again is not None
    assert pack(again) == pack(bundle)


def test_an_arm_that_no_page_can_run_says_why() -> None:
    arm = two_links().with_({"base_motion": {"x": {"type": "sine", "amplitude": 0.001, "frequency": 2.0}}})
    assert "base" in why_not_live(result_of(arm))


@pytest.mark.nightly
def test_scene_has_all_that_the_page_s_own_has(tmp_path: Path) -> None:
    """Links that only carry a surface, the plan without elasticity, and quaternions without jumps of sign."""
    arm, block = chain(3, 1.5), box((0.1, 0.1, 0.1))
    result = with_shapes(result_of(arm), [LinkShape(name, "#102030", block) for name in ("l2", "l0")])
    bundle = live_bundle(result)
    assert bundle is not None
    (run,) = live_in_node(bundle, [unchanged(live_map(arm.pair()))], tmp_path)
    scene = scene_of(result, bundle["frames"])
    assert [link["name"] for link in bundle["links"]] == [link["name"] for link in scene["links"]] == ["l0", "l1", "l2"]
    for name in ("line", "rigid", "reference", "referenceRigid", "roots"):
        assert np.abs(run["scene"][name] - scene[name]).max() < 1e-6, name


def test_what_lands_sticks_and_slips_does_so_in_the_page(tmp_path: Path) -> None:
    """On a rough surface with mass, met in the first run; in the second one, of a heavier arm, the run begins on it."""
    surface = {"type": "plane", "position": [0, 0, -0.02], "normal": [0, 0, 1]}
    arm = Robot.from_data({
        "format": 1, "kind": "arm", "name": "lands", "gravity": 9.81, "tip": {"link": "l", "position": [0.5, 0, 0]},
        "joints": [{"name": "j", "type": "revolute", "child": "l", "axis": [0, -1, 0],
                    "gear": {"stiffness": 200.0, "damping": 0.5}, "motor": {"inertia": 0.1, "side": "joint"}}],
        "links": [{"name": "l", "bodies": [{"name": "m", "mass": 1.0, "center": [0.4, 0, 0]}]}],
        "drives": [{"joint": "j", "command": "prescribed", "signal": {
            "type": "table", "times": [0, 0.1, 0.3], "values": [0.0, 0.0, -0.15], "interpolation": "linear"}}],
        "contact": {"law": "unilateral", "shape": surface, "stiffness": 2e3, "damping": 20.0, "mass": 0.2,
                    "restitution": 0.3, "friction": 0.3, "static_friction": 0.5},
        "integration": {"method": "dormand_prince", "duration": 0.3, "output_step": 0.02,
                        "relative_tolerance": 1e-10, "absolute_tolerance": 1e-12},
    })  # fmt: skip
    heavy = {"links.l.bodies.m.mass": 2.0, "joints.j.gear.stiffness.0": 120.0}
    first, live = result_of(arm), live_map(arm.pair(), (0.0, 1.0))
    values = [unchanged(live), [heavy.get(slider.path, slider.value) for slider in live.sliders]]
    bundle = live_bundle(first)
    assert bundle is not None
    touched = []
    results = [first, result_of(arm.with_(heavy))]
    for run, result in zip(live_in_node(bundle, values, tmp_path), results, strict=True):
        assert run["status"] == result.status == "finished"
        assert worst_difference(run["series"], result.data, scales(result.data))[0] < 1e-8
        touched.append(result.data["contact_force_normal"].values > 0)
    assert not touched[0][0]
    assert touched[0].any()
    assert touched[1][0]


def test_jumps_of_a_given_motion_give_the_same_impulse_in_the_page(tmp_path: Path) -> None:
    """At the start and underway, the first one also as a slider changes what it moves."""
    joints = [
        {"name": "h", "type": "revolute", "child": "hub", "axis": [0, 0, 1]},
        {"name": "p", "type": "revolute", "child": "l", "axis": [0, 0, 1], "origin": {"position": [0.4, 0, 0]},
         "motor": {"inertia": 0.1, "side": "joint"}, "gear": {"stiffness": 80.0, "damping": 0.1}},
    ]  # fmt: skip
    signals = {"h": ramps(0.0, 0.5, 0.5, 0.1), "p": ramps(0.0, 0.0, 0.2, 0.2)}
    arm = hinged(
        signals["h"], joints=joints, integration={
            "method": "dormand_prince", "duration": 0.5, "output_step": 0.02, "relative_tolerance": 1e-10,
            "absolute_tolerance": 1e-12,
        }, drives=[{"joint": name, "command": "prescribed", "signal": one} for name, one in signals.items()],
    )  # fmt: skip
    lighter = {"links.l.bodies.b.mass": 0.7}
    first, live = result_of(arm), live_map(arm.pair(), (0.0, 1.0))
    bundle = live_bundle(first)
    assert bundle is not None
    values = [unchanged(live), [lighter.get(slider.path, slider.value) for slider in live.sliders]]
    results = [first, result_of(arm.with_(lighter))]
    for run, result in zip(live_in_node(bundle, values, tmp_path), results, strict=True):
        assert worst_difference(run["series"], result.data, scales(result.data))[0] < 1e-8
        assert np.abs(np.diff(result.data["v"].sel(coordinate="p").values)).max() > 1.0


@pytest.mark.nightly
def test_a_brake_stops_a_motor_and_lets_it_go_in_the_page(tmp_path: Path) -> None:
    """Behind a gear, released and engaged again while the motor moves; of another arm, too."""
    brake = {"type": "brake", "torque": 30.0, "engaged_until": 0.05, "engage_at": 0.15, "release_delay": 0.01}
    arm = two_links().with_({"contact": None, "drives.0.brake": brake})
    first, live = result_of(arm), live_map(arm.pair(), (0.0, 1.0))
    bundle = live_bundle(first)
    assert bundle is not None
    slider = live.sliders[0]
    weaker = {slider.path: slider.value * 0.9}
    values = [unchanged(live), [weaker.get(slider.path, slider.value) for slider in live.sliders]]
    results = [first, result_of(arm.with_(weaker))]
    for run, result in zip(live_in_node(bundle, values, tmp_path), results, strict=True):
        assert worst_difference(run["series"], result.data, scales(result.data))[0] < 1e-8
        still = result.data["v"].sel(coordinate="j0.motor").values == 0.0
        assert still.any()
        assert not still.all()
