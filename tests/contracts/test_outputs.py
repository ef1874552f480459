"""One number, everywhere: each output by its name in stop conditions, studies, gradients, results and figures.

What a run reports by ways of its own (points by inverse dynamics, energies, elastic lines) is what outputs are compared
with; the page's are compared in tests/live.
"""

from __future__ import annotations

import json
import os
from contextlib import nullcontext, suppress
from functools import cache
from typing import Any

import numpy as np
import pytest

import tmodes
from command import called
from random_sheets import random_sheet
from tmodes.analysis.line.line import elastic_line
from tmodes.equations.loop.outputs import DISTANCES, ENERGIES, Output
from tmodes.errors import InputError
from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
from tmodes.gradients.quantities import reduced_output
from tmodes.io.units import udunits
from tmodes.plot.units import pretty, readable
from tmodes.result import Result, assemble_result
from tmodes.result.series import run_wrenches
from tmodes.sheet import Robot
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.outputs import robot_outputs, run_stops
from tmodes.simulation.simulate import simulate_motion
from tmodes.simulation.stops import Instants
from tmodes.simulation.vary.reduce import Reduction, reduced
from tmodes.simulation.vary.single_case import series_of_run, single_case

COUNT = int(os.environ.get("TMODES_OUTPUT_ROBOTS", "1"))
"""How many random robots."""

MANY = pytest.mark.skipif(COUNT < 2, reason="the same of a larger robot: runs with TMODES_OUTPUT_ROBOTS=2")

STATIONS = (0.0, 0.37, 1.0)
QUANTITIES = {
    "moment.y": lambda line: line.moment[..., 1], "torsion": lambda line: line.moment[..., 0],
    "shear.z": lambda line: line.shear[..., 1], "axial": lambda line: line.axial,
    "deflection.y": lambda line: line.shape.deflection[..., 0], "slope.z": lambda line: line.shape.slope[..., 1],
    "curvature.y": lambda line: line.shape.curvature[..., 0], "x": lambda line: line.position[..., 0],
}  # fmt: skip


COMPUTED = ("tip.speed", "energy.total", "tip.angular_velocity.y", "base.force.z", "l0.moment.y@0.37")
"""Those that are not stored."""


def arm(**integration: Any) -> Robot:
    """Coupled gears on a base that moves, a beam that bends and twists, a controller with a state, a wall, a force."""
    beam = {"model": "strain", "functions": {"bend_y": 1, "bend_z": 2, "twist": 1}, "length": 0.5, "damping_time": 1e-3,
            "section": {"bending_stiffness": 40.0, "torsional_stiffness": 30.0, "mass_per_length": 1.5,
                        "polar_inertia_per_length": 2e-3}}  # fmt: skip
    inertia = {"xx": 1e-3, "yy": 1e-3, "zz": 1e-3}
    joints = [
        {"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": axis,
         "gear": {"stiffness": 300.0, "damping": 0.2}, "motor": {"inertia": 0.1, "side": "joint"}}
        for k, axis in enumerate(([0, 0, 1], [0, 1, 0]))
    ]  # fmt: skip
    gains = {"position_gain": 300.0, "velocity_gain": 12.0}
    motion = {"type": "quintic", "start": 0.0, "end": 0.3, "duration": 0.08}
    return Robot.from_data({
        "format": 1, "kind": "arm", "name": "arm", "gravity": 9.81, "joints": joints,
        "links": [{"name": "l0", "beam": beam},
                  {"name": "l1", "bodies": [{"name": "load", "mass": 0.4, "inertia": inertia, "center": [0.3, 0, 0]}]}],
        "couplings": {"j0": {"j0": 1.0, "j1": 0.2}, "j1": {"j0": -0.3, "j1": 1.0}},
        "base_motion": {name: {"type": "sine", "amplitude": 0.05, "frequency": 3.0} for name in ("x", "yaw")},
        "tip": {"link": "l1", "position": [0.3, 0, 0]}, "points": [{"name": "middle", "link": "l0", "at": 0.5}],
        "loads": [{"point": "middle", "frame": "world", "force": [1.0, 2.0, -3.0]}],
        "contact": {"shape": {"type": "wall", "distance": 0.7}, "law": "bilateral", "stiffness": 500.0, "damping": 5.0},
        "drives": [{"joint": "j0", "command": "position", "signal": motion,
                    "controller": {"type": "pid", "integral_gain": 50.0, **gains}},
                   {"joint": "j1", "command": "position", "signal": motion, "controller": {"type": "pd", **gains}}],
        "integration": {"method": "rk4", "step": 1e-4, "duration": 0.1, "output_step": 0.01, "line_points": 3,
                        "error_estimate": False, "model_error": False, **integration},
    })  # fmt: skip


def sheet_of(which: int) -> Robot:
    """The arm, then random robots."""
    return arm() if which == 0 else Robot.from_data(random_sheet(which, which + 7))


@cache
def run_of(which: int) -> RunData:
    return simulate_motion(sheet_of(which))


@cache
def known_of(which: int) -> dict[str, np.ndarray]:
    """What the run reports by its own ways, by the names of outputs."""
    run = run_of(which)
    found: dict[str, Any] = {f"energy.{kind}": run.energies[kind] for kind in ENERGIES}
    found |= {f"work.{kind}": work for kind, work in run.works.items()} | {"energy.total": sum(run.energies.values())}
    for k, name in enumerate(run.coordinates):
        found |= {f"{name}.position": run.q[:, k], f"{name}.velocity": run.v[:, k], f"{name}.acceleration": run.a[:, k]}
    for k, name in enumerate(run.drives):
        kinds = ("effort", "voltage", "current", "gear_torque")
        found |= {f"{name}.{kind}": getattr(run, kind)[:, k] for kind in kinds} | {f"{name}.setpoint": run.wanted[:, k]}
    found |= dict(zip(run.planned.plan.control_names, run.controls.T, strict=True))
    for k, point in enumerate(run.model.parts.points):
        for axis, letter in enumerate("xyz"):
            found[f"{point.name}.{letter}"] = run.points.position[:, k, axis]
            found[f"{point.name}.velocity.{letter}"] = run.points.velocity[:, k, axis]
            found[f"{point.name}.acceleration.{letter}"] = run.points.acceleration[:, k, axis]
            found[f"{point.name}.angular_velocity.{letter}"] = run.points.rate[:, k, axis]
            own, felt = run.points.rotation[:, k, :, axis], run.points.acceleration[:, k] - run.chain.gravity
            found[f"{point.name}.proper_acceleration.{letter}"] = (own * felt).sum(axis=1)
            found[f"{point.name}.body_rate.{letter}"] = (own * run.points.rate[:, k]).sum(axis=1)
        found[f"{point.name}.speed"] = np.linalg.norm(run.points.velocity[:, k], axis=1)
    if run.contact_force is not None:
        found |= {f"contact.force.{letter}": run.contact_force[:, axis] for axis, letter in enumerate("xyz")}
        found |= {"contact.force": run.contact_normal, "contact.penetration": run.penetration}
    line = elastic_line(run.model, run.q, run.v, run.a, stations=STATIONS, wrenches=run_wrenches(run), base=run.base)
    for one in line.bending():
        for name, of in QUANTITIES.items():
            found |= {f"{one.name}.{name}@{s}": of(one)[:, k] for k, s in enumerate(STATIONS)}
    roots = [k for k, node in enumerate(run.chain.nodes) if node.parent < 0]
    force = line.roots[:, roots, :3].sum(axis=1)
    return found | {f"base.force.{letter}": force[:, axis] for axis, letter in enumerate("xyz")}


def seen(which: int, names: list[str]) -> dict[str, np.ndarray]:
    run, outputs = run_of(which), run_of(which).setup.model.outputs
    rows = run.planned.schedule.rows_at(run.times)
    found = run.setup.model.seen([outputs[name] for name in names], run.times, run.states, rows)
    return dict(zip(names, found.T, strict=True))


def close(found: Any, known: Any, share: float, name: str) -> None:
    size = max(float(np.abs(known).max()), 1e-6)
    assert found == pytest.approx(known, rel=0, abs=share * size), name


@pytest.mark.parametrize("which", range(COUNT + 1))
def test_outputs_are_what_a_run_reports(which: int) -> None:
    known = known_of(which)
    found = seen(which, list(known))
    for name, values in known.items():
        close(found[name], values, 1e-8 if "@" in name or "base" in name else 1e-9, name)
    left = [name for name in run_of(which).setup.model.outputs if name not in known]
    kinds = {".".join(name.split(".")[-1:]) if not name.startswith(("power", "deformation", "base")) else
             name.partition(".")[0] for name in left}  # fmt: skip
    assert kinds <= {"roll", "pitch", "yaw", "gear_twist", "power", "deformation", "base", "penetration_rate", "fold",
                     "surface", "surface_rate"}  # fmt: skip


def test_attitude_power_and_load_on_the_base() -> None:
    """Angles turn the axes; powers are the slopes of works; at the base hangs all the momentum that changes."""
    run = simulate_motion(arm(output_step=1e-4))
    names = ["tip.roll", "tip.pitch", "tip.yaw", *(f"power.{kind}" for kind in run.works), "j0.gear_twist"]
    outputs, rows = run.setup.model.outputs, run.planned.schedule.rows_at(run.times)
    values = run.setup.model.seen([outputs[name] for name in names], run.times, run.states, rows)
    (cr, cp, cy), (sr, sp, sy) = np.cos(values[:, :3].T), np.sin(values[:, :3].T)
    axis = np.stack([cy * cp, sy * cp, -sp], axis=1), np.stack([cp * sr, cp * cr], axis=1)
    assert run.points.rotation[:, 0, :, 0] == pytest.approx(axis[0], abs=1e-14)
    assert run.points.rotation[:, 0, 2, 1:] == pytest.approx(axis[1], abs=1e-14)
    for k, kind in enumerate(run.works):
        slope = np.gradient(run.works[kind], run.times)[1:-1]
        close(values[1:-1, 3 + k], slope, 1e-3, kind)
    coordinates = list(run.coordinates)
    j0, motors = run.q[:, coordinates.index("j0")], [run.q[:, coordinates.index(f"j{k}.motor")] for k in range(2)]
    twist = j0 - motors[0] - 0.2 * motors[1]
    close(values[:, -1], twist, 1e-12, "j0.gear_twist")


@pytest.mark.parametrize("which", range(COUNT))
def test_stop_conditions_look_at_the_same_numbers(which: int) -> None:
    run, known = run_of(which), known_of(which)
    names = [name for name in known if "@" not in name or "moment.y" in name]
    stops = run_stops(run.setup, tuple(f"{name} > 1e12" for name in names))
    values = stops.values(Instants(run.times, run.states, run.planned.schedule.rows_at(run.times)))
    for k, name in enumerate(names):
        close(values[:, k], known[name], 1e-8, name)
        assert stops.stops[k].output.unit == run.setup.model.outputs[name].unit


@pytest.mark.parametrize("name", ["l0.moment.y@0.37", "j1.acceleration", "energy.total", "base.force.x"])
def test_a_run_stops_where_an_output_passes_a_value(name: str) -> None:
    known, outputs = known_of(0)[name], run_of(0).setup.model.outputs
    limit = float((known[0] + known[1:][np.abs(known[1:] - known[0]).argmax()]) / 2)
    stop = f"{name} {'>' if limit > known[0] else '<'} {limit!r} {outputs[name].unit}"
    run = simulate_motion(arm(), stop=stop)
    assert run.status == "stopped_by_condition"
    close(assemble_result(run).output(name).values[-1], limit, 1e-9, name)


@pytest.mark.parametrize("name", ["deviation", "tip_error"])
def test_a_run_stops_where_its_tip_is_off(name: str) -> None:
    """The nominal tip is known at samples, and between them a polynomial."""
    whole = assemble_result(run_of(0)).output(name) if name == "deviation" else None
    limit = 0.036 if whole is None else float(whole.values[[0, -1]].mean())
    run = simulate_motion(arm(), stop=f"{name} > {limit!r} m")
    assert run.status == "stopped_by_condition"
    assert run.reference is not None
    if whole is not None:
        apart = run.points.position[-1, 0] - run.reference.points.position[-1, 0]
        assert np.linalg.norm(apart) == pytest.approx(limit, rel=1e-5)
    else:
        assert series_of_run(run, len(run.times), {name}, None)[name][-1] == pytest.approx(limit, rel=1e-9)


def stored(which: int, tmp_path: Any) -> Result:
    result = assemble_result(run_of(which))
    result.save(tmp_path / "result.nc")
    return Result.load(tmp_path / "result.nc")


@pytest.mark.parametrize("which", range(COUNT))
def test_results_and_files_have_the_same_numbers_and_units(which: int, tmp_path: Any) -> None:
    live, read, known = assemble_result(run_of(which)), stored(which, tmp_path), known_of(which)
    outputs = run_of(which).setup.model.outputs
    for name in (name for name in known if outputs[name].stored or name in COMPUTED):
        found = live.output(name)
        close(found.values, known[name], 1e-8, name)
        assert found["time"].values.tolist() == run_of(which).times.tolist()
        assert found.attrs["units"] == outputs[name].unit
        sticks = bool(run_of(which).setup.model.loop.modes)  # what sticks and what slips is not stored
        with suppress(InputError) if sticks else nullcontext():
            close(read.output(name).values, known[name], 1e-8, name)
        refuse_other_unit(read, outputs[name])
    named = live.output("tip.x")
    assert (named.dims, named.attrs["units"], named.name) == (("time",), "m", "tip.x")
    assert live.reduce("tip.x", "max") == named.values.max()
    with pytest.raises(InputError, match=r"Did you mean `tip\.x`"):
        live.output("tip.xx")


def refuse_other_unit(result: Result, output: Output) -> None:
    """A variable of the file has the unit of the output, where its unit is one."""
    variable = output.stored[0] if output.stored else ""
    if variable in result.record:
        written = result.record[variable].attrs["units"]
        if not any(word in written for word in (",", "by")):
            assert written == udunits(output.unit), output.name
    if variable == "q":
        units = dict(zip(result.record["coordinate"].values, result.record["coordinate_unit"].values, strict=True))
        assert units[output.stored[1]] == udunits(output.unit)


def test_studies_have_the_same_numbers_in_lanes_and_alone() -> None:
    known, outputs = known_of(0), robot_outputs(arm())
    stiff = {"links.l0.beam.section.bending_stiffness": [40.0, 41.0], "joints.j0.gear.damping": [0.2, 0.3]}
    lanes = [Reduction(name, how) for name in known for how in ("end", "max")]
    found = reduced(arm(), stiff, lanes, threads=1)
    assert found.status.tolist() == ["finished", "finished"]
    for case in range(2):
        alone = single_case(arm(), {path: values[case] for path, values in stiff.items()}, lanes, None)
        for one in lanes:
            size = max(float(np.abs(known[one.series]).max()), 1e-6)
            right = alone.values[one][0]
            assert found.values[one][case] == pytest.approx(right, rel=0, abs=1e-9 * size), one
            assert found.units[one] == outputs[one.series].unit
            if case == 0:
                stored = known[one.series][-1] if one.how == "end" else known[one.series].max()
                assert right == pytest.approx(stored, rel=0, abs=1e-8 * size), one


GRADIENTS = {
    "spong1987": (lambda: tmodes.load("spong1987", SHORT), "joints.joint.gear.stiffness", 100.0),
    "arm": (arm, "joints.j0.gear.stiffness", 300.0),
}  # fmt: skip
SHORT = {"integration.duration": 0.1, "integration.output_step": 0.01, "integration.method": "rk4",
         "integration.step": 1e-4}  # fmt: skip


@pytest.mark.parametrize("robot", ["spong1987", pytest.param("arm", marks=MANY)])
def test_gradients_of_all_outputs_are_those_of_differences(robot: str) -> None:
    make, path, at = GRADIENTS[robot]
    sheet = make()
    names = list(robot_outputs(sheet))
    names = [name for name in names if name.partition(".")[0] not in DISTANCES and name != "contact.fold"]
    sides = [forward_sensitivities(sheet.with_({path: at * (1 + k / 100)}), quantities=names) for k in (-2, -1, 1, 2)]
    found = forward_sensitivities(sheet, [path], quantities=names)
    run = simulate_motion(sheet)
    known = run.setup.model.seen(
        [run.setup.model.outputs[name] for name in names], run.times, run.states,
        run.planned.schedule.rows_at(run.times),
    )  # fmt: skip
    for k, name in enumerate(names):
        low, left, right, high = (side.info[name] for side in sides)
        slope = (low - 8 * left + 8 * right - high) / (12 * at / 100)
        close(found.info[name][:, 0], known[:, k], 1e-9, name)
        size = max(float(np.abs(slope).max()), 1e-7 * float(np.abs(found.info[name]).max()))
        assert found.of[name][path] == pytest.approx(slope, rel=0, abs=2e-6 * size), name


def test_gradient_of_a_reduced_output_is_that_of_differences() -> None:
    sheet, path = tmodes.load("spong1987", SHORT), "joints.joint.gear.stiffness"
    sides = [tmodes.run(sheet.with_({path: at})).reduce("energy.total", "rms") for at in (99.0, 101.0)]
    found = adjoint_gradient(sheet, reduced_output("energy.total", "rms"), [path])
    assert found.by[path] == pytest.approx((sides[1] - sides[0]) / 2, rel=1e-3)
    with pytest.raises(InputError, match="one of mean, rms, end"):
        reduced_output("energy.total", "max")


def test_figures_show_the_same_numbers() -> None:
    result, outputs = tmodes.Result.like(assemble_result(run_of(0))), run_of(0).setup.model.outputs
    panels = result.figures()["joint_tracking"]()
    output, values = outputs["j0.position"], result.output("j0.position").values
    lines = {line.get_label(): line.get_ydata() for line in panels[0].get_lines()}
    unit = next(
        unit for unit in (readable(output.unit, value) for value in (1.0, 1e-3)) if unit.name in panels[0].get_ylabel()
    )
    close(lines["actual"], unit.of(values), 1e-9, "joint")
    drawn = result.plot(name="l0.moment.y@0.37")[0]
    moment, unit = known_of(0)["l0.moment.y@0.37"], readable("N*m", known_of(0)["l0.moment.y@0.37"])
    assert unit.name in drawn.get_ylabel()
    close(drawn.get_lines()[0].get_ydata(), unit.of(moment), 1e-8, "moment")
    forces = result.figures()["contact_force"]()
    output, values = outputs["contact.force"], result.output("contact.force").values
    assert pretty(output.unit)[-1] in forces[0].get_ylabel()
    shown = [np.asarray(line.get_ydata()) for panel in forces for line in panel.get_lines()]
    unit = readable(output.unit, values)
    assert any(len(one) == len(values) and np.allclose(one, unit.of(values), rtol=1e-9) for one in shown)


@pytest.mark.parametrize("station", ["1.5", "x", "S"])
def test_a_station_beyond_its_link_is_named(station: str) -> None:
    with pytest.raises(InputError) as wrong:
        tmodes.load("filipovic2010").outputs.group(f"link.1.moment.z@{station}", "series")
    assert wrong.value.got.startswith(f"`{station}`")


def test_the_command_lists_all_names() -> None:
    rows = json.loads(called("outputs", "spong1987", "--json").stdout)
    outputs = tmodes.outputs(tmodes.load("spong1987"))
    assert {row["name"]: row["unit"] for row in rows} == {name: unit for name, unit, _ in outputs.rows}
    assert all(row["meaning"] for row in rows)
    assert (outputs["joint.setpoint"].unit, outputs["joint.effort"].unit) == ("rad", "N*m")
    assert len(repr(outputs).splitlines()) <= 10
