"""Systems of a user's own: what energies say exactly, and everything that robots have."""

from __future__ import annotations

import re
import runpy
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np
import pytest

import tmodes
from simulation.sheets import arm
from tmodes.analysis.modes.modes import modes_about
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.errors import InputError, InputErrors
from tmodes.simulation.simulate import simulate_motion

ROOT = Path(__file__).parents[2]
EXAMPLE = ROOT / "examples" / "cart_with_flexible_pole.py"


@pytest.fixture(scope="module")
def example() -> dict[str, Any]:
    return runpy.run_path(str(EXAMPLE))


def double_pendulum(name: str = "double_pendulum", **more: Any) -> Any:
    """Two masses on rods with a spring between the rods, which stand at angles from straight down."""

    def places(q: Any, p: Any) -> list[Any]:
        first = ca.vertcat(p.l1 * ca.sin(q.first), 0, -p.l1 * ca.cos(q.first))
        return [first, first + ca.vertcat(p.l2 * ca.sin(q.second), 0, -p.l2 * ca.cos(q.second))]

    def kinetic(q: Any, v: Any, p: Any) -> Any:
        across = p.l1 * p.l2 * ca.cos(q.first - q.second) * v.first * v.second
        squares = (p.l1 * v.first) ** 2, (p.l1 * v.first) ** 2 + (p.l2 * v.second) ** 2 + 2 * across
        return (p.m1 * squares[0] + p.m2 * squares[1]) / 2

    def gravity(q: Any, p: Any) -> Any:
        return p.g * sum(m * place[2] for m, place in zip((p.m1, p.m2), places(q, p), strict=True))

    laws: dict[str, Any] = {
        "kinetic": kinetic,
        "gravity": gravity,
        "elastic": lambda q, p: p.k * (q.second - q.first) ** 2 / 2,
        "points": lambda q, p: dict(zip(("tip", "elbow"), reversed(places(q, p)), strict=True)),
    }
    parameters = {"m1": 1.0, "m2": 0.5, "l1": 1.0, "l2": 0.7, "k": 3.0}
    return tmodes.System(name, {"first": "rad", "second": "rad"}, parameters, **laws | more)


def test_energy_is_kept_in_a_free_motion() -> None:
    start = {"state": "zero", "coordinates": {"first": 2.0}, "rates": {"second": 3.0}}
    settings = {"duration": 3.0, "output_step": 0.01, "relative_tolerance": 1e-11, "absolute_tolerance": 1e-13}
    run = simulate_motion(double_pendulum().robot(initial=start, integration=settings))
    energy = np.sum([*run.energies.values()], axis=0)
    assert np.ptp(energy) < 1e-8 * np.ptp(run.energies["kinetic"])


def test_frequencies_are_the_closed_form() -> None:
    """About rest both angles are small: M q'' + K q = 0 by hand."""
    robot = double_pendulum().robot(gravity=9.81)
    m1, m2, l1, l2, k, g = 1.0, 0.5, 1.0, 0.7, 3.0, 9.81
    mass = np.array([[(m1 + m2) * l1**2, m2 * l1 * l2], [m2 * l1 * l2, m2 * l2**2]])
    stiffness = np.array([[(m1 + m2) * g * l1 + k, -k], [-k, m2 * g * l2 + k]])
    expected = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real)) / (2 * np.pi)
    found = [mode.frequency_Hz for mode in modes_about(robot_rest(robot))]
    assert found == pytest.approx(expected, rel=1e-10)


def test_dynamics_agree_with_each_other() -> None:
    """Inverse of forward, mass matrix of momenta, jacobian of places, weight of the load factor."""
    model = tmodes.Model(double_pendulum().robot().chain())
    q, v = np.array([0.4, -1.1]), np.array([1.3, 0.7])
    a = model.forward_dynamics(q, v)
    assert np.abs(model.inverse_dynamics(q, v, a)).max() < 1e-12
    assert model.energies(q, v)["kinetic"] == pytest.approx(v @ model.mass_matrix(q) @ v / 2, rel=1e-14)
    step = 1e-6
    moved = (model.pose(q + step * v)[0] - model.pose(q - step * v)[0]) / (2 * step)
    assert np.abs(model.jacobian(q)[:, :3] @ v - moved).max() < 1e-8
    push = np.array([[2.0, 0.0, 1.0, 0.0, 0.0, 0.0], np.zeros(6)])
    along = np.einsum("kij,ki->j", model.jacobian(q), push)
    unloaded, loaded = (model.inverse_dynamics(q, v, a, wrenches=w) for w in (None, push))
    assert np.abs(unloaded - loaded - along).max() < 1e-12


def test_derivatives_are_differences() -> None:
    model = tmodes.Model(double_pendulum().robot().chain())
    q, v, step = np.array([0.4, -1.1]), np.array([1.3, 0.7]), 1e-6
    exact = model.forward_dynamics_derivatives(q, v)
    for k, change in enumerate(np.eye(2) * step):
        slopes = [(model.forward_dynamics(q + change, v) - model.forward_dynamics(q - change, v)) / (2 * step)]
        slopes += [(model.forward_dynamics(q, v + change) - model.forward_dynamics(q, v - change)) / (2 * step)]
        assert np.abs(slopes[0] - exact.q[:, k]).max() < 1e-6
        assert np.abs(slopes[1] - exact.v[:, k]).max() < 1e-6


def test_an_elastic_gear_before_a_coordinate(example: dict[str, Any]) -> None:
    """The motor is a coordinate of its own; without gravity and damping all energy is accounted for."""
    drive = {"joint": "cart", "command": "position", "signal": {"type": "constant", "value": 0.2},
             "controller": {"type": "pd", "position_gain": 300.0, "velocity_gain": 30.0}}  # fmt: skip
    cart = {"motor": {"side": "joint", "inertia": 0.5}, "gear": {"stiffness": 9000.0, "damping": 3.0}}
    robot = example["pole"].robot(
        joints={"cart": cart}, drives=[drive], initial={"state": "zero", "rates": {"pole": 5.0}},
        integration={"duration": 0.5, "output_step": 0.01},
    )  # fmt: skip
    run = simulate_motion(robot)
    assert run.coordinates == ("cart.motor", "cart", "pole")
    assert np.abs(run.energy_balance).max() < 1e-7 * run.energy_moved


def test_the_example_has_what_robots_have(example: dict[str, Any], tmp_path: Path) -> None:
    robot = example["robot"]
    result = tmodes.run(robot)
    assert result.status == "finished"
    assert abs(float(result.data["q"].isel(time=-1).sel(coordinate="cart")) - 0.5) < 0.02
    assert tmodes.Result.load(result.save(tmp_path / "result.nc") or tmp_path / "result.nc").data.equals(result.data)
    held = np.sqrt((20.0 - 0.3 * 9.81 * 0.5) / (0.3 * 0.5**2)) / (2 * np.pi)
    assert [mode.frequency_Hz for mode in modes_about(robot_rest(robot))] == pytest.approx([held], rel=1e-10)
    result.show().save(tmp_path / "page.html")
    assert "cart_with_flexible_pole" in (tmp_path / "page.html").read_text(encoding="utf-8")


def test_the_example_in_batches_and_derivatives(example: dict[str, Any]) -> None:
    robot = example["robot"].with_({"integration.method": "dormand_prince", "integration.duration": 0.5})
    path = "parameters.stiffness"
    slopes = tmodes.forward_sensitivities(robot, [path]).by[path]
    values = np.array([20.0 - 1e-3, 20.0 + 1e-3])
    batch = tmodes.simulate_batch(robot, {path: values})
    difference = (batch.states[1] - batch.states[0]) / 2e-3
    assert np.abs(slopes[:, :4] - difference[:, :4]).max() < 1e-5 * np.abs(slopes[:, :4]).max()


def test_the_page_shows_the_example_as_it_is() -> None:
    page = (ROOT / "docs" / "systems.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python\n(.*?)```", page, flags=re.DOTALL)
    assert blocks[0] == EXAMPLE.read_text(encoding="utf-8")


def refused(changes: dict[str, Any], **sheet: Any) -> str:
    with pytest.raises((InputError, InputErrors)) as caught:
        _ = tmodes.Model(double_pendulum("refused", **changes).robot(**sheet).chain()).coordinates
    return str(caught.value)


def test_what_is_wrong_is_said() -> None:
    assert "quadratic" in refused({"kinetic": lambda q, v, p: v.first**4})
    assert "linear in the rates" in refused({"kinetic": lambda q, v, p: v.first**2 + v.second**2 + v.first})
    assert "unknown parameter" in refused({}, parameters={"k3": 1.0})
    assert "`second`" in refused({"inputs": ("first",)}, drives=[{
        "joint": "second", "command": "effort", "signal": {"type": "constant", "value": 0.0}}])  # fmt: skip
    still = {"type": "constant", "value": 0.0}
    robot = double_pendulum("moved").robot(base_motion={"x": still}, initial={"state": "zero"})
    with pytest.raises(InputError, match="stands still"):
        tmodes.run(robot)
    with pytest.raises(InputError, match="known"):
        _ = tmodes.Model(robot.with_({"equations": "unknown_system"}).chain()).coordinates


def test_a_system_without_its_reaction_says_so() -> None:
    model = tmodes.Model(double_pendulum().robot().chain())
    with pytest.raises(InputError, match="momentum"):
        model.momentum(np.zeros(2), np.ones(2))


def test_a_tip_sticks_and_slips_as_that_of_links() -> None:
    """A rod on a cart whose tip lands on a rough floor, and is pushed to and fro."""
    system = tmodes.System(
        "rod_on_cart", {"x": "m", "th": "rad"}, {"m": 2.0, "I": 0.3, "l": 0.5},
        kinetic=lambda q, v, p: (p.m * v.x**2 + (p.I + p.m * p.l**2) * v.th**2) / 2
        - p.m * p.l * ca.sin(q.th) * v.x * v.th,
        gravity=lambda q, p: p.g * p.m * p.l * ca.sin(q.th),
        points=lambda q, p: {"tip": ca.vertcat(q.x + p.l * ca.cos(q.th), 0, p.l * ca.sin(q.th))},
    )  # fmt: skip
    push = {"joint": "x", "command": "effort", "signal": {"type": "sine", "amplitude": 8.0, "frequency": 0.8}}
    free = {"joint": "th", "command": "effort", "signal": {"type": "constant", "value": 0.0}}
    common: dict[str, Any] = {
        "gravity": 9.81, "integration": {"duration": 1.5, "output_step": 0.05, "method": "dop853"},
        "initial": {"state": "zero", "coordinates": {"th": 0.02}, "rates": {"x": 0.5}},
        "contact": {"law": "unilateral", "shape": {"type": "plane", "position": [0, 0, 0], "normal": [0, 0, 1]},
                    "stiffness": 5e3, "damping": 50.0, "friction": 0.3, "static_friction": 0.5},
    }  # fmt: skip
    body = {"name": "m", "mass": 2.0, "center": [0.5, 0, 0], "inertia": dict.fromkeys(("xx", "yy", "zz"), 0.3)}
    links = arm(
        joints=[{"name": "x", "type": "prismatic", "child": "c", "axis": [1, 0, 0]},
                {"name": "th", "type": "revolute", "child": "l", "axis": [0, -1, 0]}],
        links=[{"name": "c", "bodies": []}, {"name": "l", "bodies": [body]}],
        tip={"link": "l", "position": [0.5, 0, 0]}, drives=[push, free], **common,
    )  # fmt: skip
    one, other = simulate_motion(system.robot(drives=[push], **common)), simulate_motion(links)
    assert one.statistics["switches"] == other.statistics["switches"] > 1
    np.testing.assert_allclose(one.q, other.q, rtol=0, atol=1e-9)
