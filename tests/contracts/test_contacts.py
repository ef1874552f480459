"""What every contact law and surface keeps, those of a user's script among them: a soil is defined here."""

from __future__ import annotations

from typing import Any, Literal

import casadi as ca
import numpy as np
import pytest
from pydantic import Field

from lane_runs import simulate_lanes
from simulation.sheets import ZERO, arm
from tmodes.equations.loop.contact_kernels import Touch, contact_law
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES, Contact, Surface
from tmodes.kinds.kernel import functions as f
from tmodes.kinds.kernel import vectors
from tmodes.kinds.schema.quantity import not_negative, positive
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.simulate import simulate_motion
from wasm.node import page_states


@CONTACTS.register
class Soil(Contact):
    """Pressure and sinkage with the power 3/2 (Hertz; Bekker's n = 1.5), damping in proportion, and friction."""

    law: Literal["soil"] = Field(description="contact law")
    modulus: float = positive("N/m^1.5", "k", "force per sinkage to the power 3/2")
    loss: float = not_negative("s/m", "c", "share of the force per speed of sinking")
    grip: float = not_negative("-", "mu", "friction coefficient")

    @property
    def is_rough(self) -> bool:
        return self.grip > 0

    @property
    def jumps(self) -> bool:
        return False

    def numbers(self) -> tuple[float, ...]:
        return self.modulus, self.loss, self.grip

    def normal_force(self, p: Any, depth: Any, rate: Any) -> Any:
        return p[0] * depth * f.sqrt(depth) * (1 + p[1] * rate)

    def friction_force(self, p: Any, normal: Any, slip: Any, velocity: Any) -> Any:
        return vectors.scale(p[2] * normal / f.sqrt(vectors.dot(slip, slip) + 1e-4), slip)


FLOOR = {"type": "plane", "position": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0]}
SPRING = {"stiffness": 900.0, "damping": 5.0, "preload": 2.0, "friction": 0.3, "friction_velocity": 1e-2}
LAWS = {
    "bilateral": SPRING | {"mass": 0.4},
    "unilateral": SPRING,
    "dynamic_environment": SPRING | {"mass": 0.4, "friction_law": "magnitude"},
    "soil": {"modulus": 2e4, "loss": 0.5, "grip": 0.4},
}
"""Numbers of one of each law; a law without an entry fails."""

SHAPES = {
    "plane": {"position": [0.1, 0.2, -0.1], "normal": [0.3, -0.2, 2.0]},
    "wall": {"distance": 0.7, "heading": 0.4},
    "ball": {"center": [0.2, 0.1, -0.3], "radius": 0.4},
}


def contact(name: str, shape: Any = FLOOR) -> Contact:
    return Contact.of({"law": name, "shape": shape, **LAWS[name]})


def dropped(name: str, **integration: Any) -> Any:
    """A body on two carriages that falls onto the floor while it slides."""
    joints = [{"name": "x", "type": "prismatic", "child": "a", "axis": [1, 0, 0]},
              {"name": "z", "type": "prismatic", "child": "b", "axis": [0, 0, 1]}]  # fmt: skip
    links = [{"name": "a", "bodies": [{"name": "sled", "mass": 0.2}]},
             {"name": "b", "bodies": [{"name": "ram", "mass": 1.5}]}]  # fmt: skip
    height = 0.0 if LAWS[name].get("stiffness") and name != "unilateral" else 0.02
    return arm(
        gravity=9.81, joints=joints, links=links, contact={"law": name, "shape": FLOOR, **LAWS[name]},
        drives=[{"joint": "x", "command": "effort", "signal": {"type": "constant", "value": 1.0}},
                {"joint": "z", "command": "effort", "signal": ZERO}],
        initial={"state": "zero", "coordinates": {"z": height}, "rates": {"x": 0.4}},
        integration={"duration": 0.3, "output_step": 0.005, "relative_tolerance": 1e-9,
                     "absolute_tolerance": 1e-11, **integration},
    )  # fmt: skip


@pytest.mark.parametrize("name", sorted(CONTACTS))
def test_law(name):
    """No force where apart, slopes as differences have them, mass and losses not negative; numbers make no code."""
    law = contact(name)
    at = contact_law(law)
    if law.unilateral:
        assert at(-1e-3, 0.0) == (0.0, 0.0, 0.0)
    here, step = at(2e-3, 0.01), 1e-7
    assert here.force > 0
    assert here.stiffness == pytest.approx(
        (at(2e-3 + step, 0.01).force - at(2e-3 - step, 0.01).force) / (2 * step), rel=1e-6
    )
    assert here.damping == pytest.approx(
        (at(2e-3, 0.01 + step).force - at(2e-3, 0.01 - step).force) / (2 * step), rel=1e-6
    )
    assert here.damping >= 0
    assert law.moving_mass >= 0
    for slip in ([0.3, -0.1, 0.0], [0.0, 0.0, 0.0]):
        force = [float(x) for x in law.friction_force(law.numbers(), 5.0, slip, slip)]
        assert vectors.dot(force, slip) >= 0
    other = Contact.of(law.model_dump() | {key: 1.3 * x for key, x in law.model_dump().items() if isinstance(x, float)})
    assert other.structure == law.structure
    symbols = [ca.SX.sym(key, size) for key, size in (("p", len(law.numbers())), ("x", 2))]
    made = [str(one.normal_force(symbols[0], symbols[1][0], symbols[1][1])) for one in (law, other)]
    assert made[0] == made[1]


@pytest.mark.parametrize("name", sorted(SURFACES))
def test_surface(name):
    """Direction, rate and curvature are the derivatives of the penetration; drawn where it is."""
    shape = Surface.of({"type": name, **SHAPES[name]})
    place, velocity, p, step = np.array([0.3, 0.2, 0.4]), np.array([0.5, -0.2, 0.3]), shape.numbers(), 1e-4

    def depth(time: float) -> float:
        return float(shape.meet(p, list(place + time * velocity), [0.0] * 3).depth)

    met = shape.meet(p, list(place), list(velocity))
    assert np.linalg.norm(met.direction) == pytest.approx(1.0, rel=1e-12)
    assert met.rate == pytest.approx((depth(step) - depth(-step)) / (2 * step), rel=1e-6)
    assert met.curving == pytest.approx((depth(step) - 2 * depth(0) + depth(-step)) / step**2, rel=1e-4, abs=1e-6)
    assert shape.drawing()["kind"] in {"plane", "ball"}
    assert len(shape.moving_numbers()) == 7


@pytest.mark.parametrize("name", sorted(CONTACTS))
def test_run(name, tmp_path):
    """Natively, by an implicit method, in a batch and in WebAssembly alike; energy balances."""
    sheet = dropped(name)
    run = simulate_motion(sheet)
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    assert run.contact_normal is not None
    assert np.abs(run.contact_normal).max() > 10.0
    other = simulate_motion(sheet.with_({"integration.method": "extrapolation"}))
    assert np.abs(other.q - run.q).max() < 1e-6
    setup = run_setup(sheet.with_({"integration.method": "dormand_prince"}))
    model, settings = setup.model, setup.robot.integration.model_copy(update={"method": "dormand_prince"})
    native = run_trajectory(setup)
    batch = simulate_lanes(model, np.array([model.numbers] * 3), setup.planned.schedule, setup.start, settings)
    assert np.abs(batch.states[1] - native.states).max() < 1e-9
    assert np.abs(page_states(setup, tmp_path) - native.states).max() < 1e-8


@pytest.mark.parametrize(
    ("name", "friction"), [("bilateral", "friction"), ("unilateral", "friction"), ("soil", "grip")]
)
def test_what_moves_along_the_normal_alone_is_not_rubbed(name, friction):
    """Friction is of the part of the velocity along the surface: straight down, a rough floor is as a smooth one."""
    down = dropped(name).with_({"initial.rates": {"x": 0.0}, "drives.0.signal.value": 0.0})
    rough, smooth = (simulate_motion(down.with_({f"contact.{friction}": value})) for value in (0.9, 0.0))
    assert np.abs(rough.q[:, 1]).max() > 1e-3
    assert np.abs(rough.q - smooth.q).max() < 1e-9


def test_derivatives_through_a_soil():
    """By the modulus of the soil: against differences of runs."""
    sheet, path = dropped("soil", duration=0.15, method="dop853"), "contact.modulus"
    slope = forward_sensitivities(sheet, [path]).by[path][-1]
    ends = [simulate_motion(sheet.with_({path: 2e4 + step})).q[-1] for step in (1.0, -1.0)]
    assert slope[:2] == pytest.approx((ends[0] - ends[1]) / 2.0, rel=1e-4)
    assert abs(slope[1]) > 1e-10


def test_a_law_of_the_same_name_is_refused():
    with pytest.raises(Exception, match="soil"):

        @CONTACTS.register
        class Other(Contact):
            law: Literal["soil"] = Field(description="contact law")


def test_a_sheet_names_registered_laws_only():
    with pytest.raises(Exception, match=r"contact\.law.*mud"):
        dropped("soil").with_({"contact.law": "mud"})


def test_code_is_shared_by_structure_and_distinguished_by_source():
    assert Touch(contact("soil")).key == Touch(contact("soil")).key
    assert Soil.fingerprint() != contact("bilateral").fingerprint()
    assert len(Soil.fingerprint().split()[-1]) == 16
