"""Shapers for a robot's own modes: what they leave of its vibration, and what is said of them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import tmodes
from command import tmodes as command
from tmodes.errors import InputError, ResultFileError
from tmodes.kinds.shapers.registry import residual


def elastic_chain(seed: int, controlled: bool) -> tmodes.Robot:
    """Two random links behind elastic joints, about parallel axes, that move by a thousandth of a radian."""
    g = np.random.default_rng(seed)
    joints, links, drives = [], [], []
    for k in range(2):
        joints.append({
            "name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1],
            "origin": {"position": [0.4 * k, 0, 0]}, "motor": {"inertia": g.uniform(0.5, 2.0), "side": "joint"},
            "gear": {"stiffness": g.uniform(80, 300), "damping": g.uniform(0.05, 0.2)}})  # fmt: skip
        body = {"name": "b", "mass": g.uniform(0.5, 2), "center": [g.uniform(0.1, 0.4), 0.05, 0], "inertia": 0.02}
        links.append({"name": f"l{k}", "bodies": [body]})
        start = g.uniform(-1, 1)
        move = {"type": "s_curve", "start": start, "end": start + 1e-3, "speed": g.uniform(5e-3, 2e-2),
                "acceleration": 0.4, "jerk": 20.0}  # fmt: skip
        drive = {"joint": f"j{k}", "command": "position" if controlled else "prescribed", "signal": move}
        gains = {"type": "pd", "position_gain": g.uniform(200, 400), "velocity_gain": g.uniform(2, 5)}
        drives.append(drive | ({"controller": gains} if controlled else {}))
    integration = {"duration": 6.0, "output_step": 0.005, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-14}
    return tmodes.Robot.from_data({
        "format": 1, "kind": "arm", "name": "chain", "gravity": 0, "joints": joints, "links": links,
        "drives": drives, "integration": integration})  # fmt: skip


def left(robot: tmodes.Robot) -> float:
    """Largest distance of a joint from its end, after the commands are at their ends [rad]."""
    data = robot.run(error_estimate=False, model_error=False).data
    last = max(drive.signal.move_ends() or 0.0 for drive in robot.drives)
    joints = data["q"].sel(coordinate=[name for name in data.coordinate.values if "motor" not in name])
    ends = np.array([float(drive.signal.schedule(9.0).at(9.0)) for drive in robot.drives])
    return float(np.abs(joints.values - ends)[data.time.values >= last].max())


@pytest.mark.parametrize("controlled", [False, True])
@pytest.mark.parametrize("seed", range(3))
def test_a_robot_shaped_for_its_own_modes_stops_dead(seed: int, controlled: bool) -> None:
    """In linear motion less than 1 % of the vibration is left, of moves of different lengths; all modes are shaped."""
    robot = elastic_chain(seed, controlled)
    found = robot.shaper(modes=(1, 2, 3, 4) if controlled else (1, 2))
    assert left(found.robot) < 0.01 * left(robot)


def test_poses_along_the_motion() -> None:
    """The frequency of the bent arm changes with its elbow; along the path it is made for the middle."""
    robot = elastic_chain(0, controlled=False).with_({"drives.1.signal.end": 2.5})
    start, end, path = (robot.shaper(where=where) for where in ("start", "end", "path"))
    ends = [one.shaper.frequencies[0] for one in (start, end)]
    assert abs(ends[0] - ends[1]) > 0.05 * ends[0]
    along = path.along[0].frequency
    assert along[[0, -1]] == pytest.approx(ends, rel=1e-6)
    assert path.shaper.frequencies[0] == pytest.approx((along.min() + along.max()) / 2)
    assert all("…" not in repr(one) for one in (start, path))
    assert all(f"{low:+.1%} to {high:+.1%}" in repr(one) for one in (start, path) for low, high in one.widths)


@pytest.mark.parametrize("kind", ["zv", "zvd", "zvdd", "ei"])
def test_widths_by_their_closed_forms(kind: str) -> None:
    """Without damping cos(pi r/2)^n is left of n + 1 impulses, and of EI (1 - V)/2 + (1 + V)/2 cos(pi r)."""
    power = {"zv": 1, "zvd": 2, "zvdd": 3}.get(kind)
    v = 1.01 * 0.05
    width = 1 - (2 * np.arccos(v ** (1 / power)) if power else np.arccos((v - 0.475) / 0.525)) / np.pi
    found = tmodes.load("spong1987").shaper(kind=kind, frequency=(2.0,))
    ((low, high),) = found.widths
    assert [-low, high] == pytest.approx([width, width], abs=1e-4)
    ends = residual(found.impulses, 2.0 * np.array([1 + low, 1 + high]))
    assert ends == pytest.approx(0.0505, abs=1e-4)


def test_a_shaped_robot_gets_another_shaper_not_two() -> None:
    first = tmodes.load("two_link_arm").shaper(kind="zv")
    second = first.robot.shaper(kind="ei", tolerated=0.1)
    signal = second.robot.drives[0].signal
    assert (signal.shaper.type, signal.shaper.tolerated, signal.signal.type) == ("ei", 0.1, "quintic")
    assert first.shaper.frequencies == pytest.approx(second.shaper.frequencies)


def test_files_of_the_command(tmp_path: Path) -> None:
    sheet, figure = tmp_path / "shaped.yaml", tmp_path / "left.svg"
    said = command("shaper", "two_link_arm", "--kind", "zvd", "--out", str(sheet), "--figure", str(figure)).stdout
    assert "the motion becomes 0.1277 s longer" in said
    signal: Any = tmodes.load(sheet).drives[0].signal
    assert signal.shaper.type == "zvd"
    assert figure.read_bytes().startswith(b"<?xml")
    robot = tmodes.load("two_link_arm")
    with pytest.raises(ResultFileError, match="--overwrite"):
        robot.shaper(out=sheet)
    with pytest.raises(InputError, match=r"\.svg, \.png, \.pdf"):
        robot.shaper(figure=tmp_path / "left.jpg")


@pytest.mark.parametrize(("given", "words"), [
    ({"kind": "zw"}, "`zw`"), ({"modes": (99,)}, "mode 99 of"), ({"modes": (0,)}, "numbers from 1"),
    ({"frequency": (-1.0,)}, "at least 0.001"), ({"frequency": (1.0,), "damping": (0.95,)}, "0.9"),
    ({"frequency": (1.0, 2.0), "damping": (0.1,)}, "2 frequencies and 1 damping"),
    ({"frequency": (1.0,), "damping": (0.9,), "kind": "ei"}, "damping ratio of 0.9"),
    ({"tolerated": 0.1}, "--kind ei"),
])  # fmt: skip
def test_what_is_wrong_is_said(given: dict, words: str) -> None:
    with pytest.raises(InputError) as caught:
        tmodes.load("spong1987").shaper(**given)
    assert words in str(caught.value)
