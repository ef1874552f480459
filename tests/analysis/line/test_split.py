"""T_st and T_to: sag at rest, small in slow motion, ringing about zero after a release."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from analysis.line.beams import EI, LENGTH, MASS, beam, clamped, piece, turning
from oracle.arms.robots import arms
from patience import bounded
from tmodes.analysis.line.line import elastic_line
from tmodes.analysis.quasistatic import deflections, elastic_names, held_shape, split_motion
from tmodes.chain.chain import Chain, Gear, Joint, Motor, Node
from tmodes.kinds.drives.registry import drive_kind
from tmodes.kinds.joints.registry import joint_kind
from tmodes.model.model import Model


def test_at_rest_the_stationary_part_is_the_sag() -> None:
    """A stiff bar under its own weight: q L^4/(8 EI); nothing oscillates."""
    model = clamped(beam(bend_y=3, bend_z=0, pieces=(piece(bending=3e4),)))
    q, held = held_shape(model, np.zeros(3))
    assert held.all()
    split = split_motion(model, q, np.zeros(3), np.zeros(3))
    assert np.abs(split.oscillatory).max() < 1e-12
    line = elastic_line(model, split.stationary)["rod"]
    assert line.shape is not None
    assert line.shape.deflection[0, -1, 1] == pytest.approx(-9.81 * MASS * LENGTH**4 / (8 * 3e4), rel=1e-6)


def test_held_shape_is_an_equilibrium_of_the_loads_and_the_gross_motion() -> None:
    """Nothing is left along gears and links: of the forces with deflections standing still."""
    rng = np.random.default_rng(1)
    for name in ("twist_and_bend", "branched", "segmented"):
        model = Model(arms()[name])
        q = np.zeros((30, model.nq))
        v, a = rng.normal(size=(2, 30, model.nq))
        q[:, model.motors] = rng.uniform(-1, 1, (30, len(model.motors)))
        wrenches = rng.normal(size=(30, len(model.parts.points), 6))
        found, held = held_shape(model, q, v, a, wrenches=wrenches)
        assert held.all()
        elastic = [part.angle for part in model.parts.nodes if part.node.joint.drive is drive_kind("elastic")]
        sprung = [part.angle for part in model.parts.nodes if part.node.joint.drive is drive_kind("spring")]
        still, gain = v.copy(), a.copy()
        for x in (still, gain):
            x[:, elastic], x[:, sprung], x[:, model.deformations] = x[:, model.motors], 0.0, 0.0
        forces = model.inverse_dynamics(found, still, gain, wrenches=wrenches)
        free = [*elastic, *sprung, *model.deformations]
        assert np.abs(forces[:, free]).max() < 1e-9 * np.abs(forces).max()
        assert np.abs(found[:, model.motors] - q[:, model.motors]).max() == 0.0


def test_gear_deflection_is_output_less_input() -> None:
    """A mass on a horizontal arm behind a gear: xi = -m g l cos(q)/C, the motor's angle apart."""
    from tmodes.frame import Placement
    from tmodes.kinds.links.contract import Body
    from tmodes.kinds.links.rigid import RigidLink

    tilted = Placement(np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]]))
    joint = Joint(
        "hub", joint_kind("revolute"), tilted, drive=drive_kind("elastic"), motor=Motor(0.1), gear=Gear((500.0,))
    )
    node = Node("arm", -1, joint, RigidLink((Body(2.0, np.array([0.5, 0, 0])),)))
    model = Model(Chain("one", (node,), np.array([0.0, 0.0, -9.81])))
    assert elastic_names(model) == ("hub.gear",)
    found, _ = held_shape(model, np.array([0.3, 0.3]))
    xi = deflections(model, found)[0, 0]
    assert xi == pytest.approx(-2.0 * 9.81 * 0.5 * np.cos(0.3 + xi) / 500.0, rel=1e-9)


def _moved(duration: float) -> float:
    """Largest T_to while a hub turns 1 rad under gravity, smoothly (four derivatives) from rest to rest."""
    model = turning(beam(bend_y=0, bend_z=1, pieces=(piece(bending=50.0),)), gravity=np.array([0.0, -9.81, 0.0]))
    start, _ = held_shape(model, np.zeros(2))
    move = np.polynomial.Polynomial([0, 0, 0, 0, 0, 126, -420, 540, -315, 70])

    def given(t: float) -> list[float]:
        return [float(move.deriv(k)(t / duration)) / duration**k if k else float(move(t / duration)) for k in range(3)]

    def rate(t: float, y: np.ndarray) -> list[float]:
        angle, speed, gain = given(t)
        return [y[1], model.forward_dynamics(np.array([angle, y[0]]), np.array([speed, y[1]]), given=[gain])[1]]

    times = np.linspace(0, duration, 200)
    run = solve_ivp(rate, (0, duration), [start[0, 1], 0.0], t_eval=times, rtol=1e-9, atol=1e-13, method="DOP853")
    base = np.array([given(t) for t in times])
    q, v = np.column_stack([base[:, 0], run.y[0]]), np.column_stack([base[:, 1], run.y[1]])
    split = split_motion(model, q, v, model.forward_dynamics(q, v, given=base[:, 2:]))
    assert split.held.all()
    return float(np.abs(split.oscillatory).max())


@pytest.mark.nightly
def test_oscillatory_part_of_a_slow_move_goes_with_the_square_of_its_speed() -> None:
    """It is what the acceleration of the changing sag leaves; half the speed, a quarter of it."""
    fast, slow = _moved(6.0), _moved(12.0)
    assert slow < 1e-4
    assert 3.5 < fast / slow < 5.5


def test_release_rings_about_zero_at_the_natural_frequency() -> None:
    model = clamped(beam(bend_y=0, bend_z=2), gravity=np.zeros(3))
    mass, _, stiffness = model.linearize(np.zeros(2))
    wave = np.sqrt(np.sort(np.linalg.eigvals(np.linalg.solve(mass, stiffness)).real))
    push = np.array([0.0, 0.02, 0.0, 0.0, 0.0, 0.0])[None, None]
    start, _ = held_shape(model, np.zeros(2), wrenches=push)
    times = np.linspace(0, 10 * 2 * np.pi / wave[0], 1001)[:-1]
    run = solve_ivp(
        lambda _, y: np.concatenate([y[2:], model.forward_dynamics(y[:2], y[2:])]),
        (0, times[-1]), [*start[0], 0, 0], t_eval=times, rtol=1e-7, atol=1e-11, method="DOP853",
    )  # fmt: skip
    q, v = run.y[:2].T, run.y[2:].T
    split = split_motion(model, q, v, model.forward_dynamics(q, v))
    assert np.abs(split.stationary).max() < 1e-12
    ringing = split.oscillatory[:, 0]
    assert abs(ringing.mean()) < 1e-3 * np.abs(ringing).max()
    spectrum = np.abs(np.fft.rfft(ringing * np.hanning(len(ringing))))
    assert int(spectrum.argmax()) == 10


def test_loads_beyond_buckling_are_reported() -> None:
    """A light rod pressed far beyond pi^2 EI/(4 L^2), from straight: exactly singular or not, it never lies."""
    model = clamped(beam(bend_y=0, bend_z=2), gravity=np.zeros(3))
    critical = np.pi**2 * EI / (4 * LENGTH**2)
    push = np.array([-1.001 * critical, 1e-3, 0.0, 0.0, 0.0, 0.0])[None, None]
    shape, held = held_shape(model, np.zeros(2), wrenches=push)
    if held[0]:
        assert np.abs(model.inverse_dynamics(shape, 0 * shape, 0 * shape, wrenches=push)).max() < 1e-8


def test_cheap_enough_for_a_run() -> None:
    """2,000 samples of an arm of 17 coordinates within seconds."""
    model = Model(arms()["twist_and_bend"])
    rng = np.random.default_rng(2)
    q = np.zeros((2000, model.nq))
    q[:, model.motors] = np.cumsum(rng.normal(size=(2000, 2)) * 1e-3, axis=0)
    q[:, 2:4] = q[:, model.motors]
    v = 0.1 * rng.normal(size=q.shape)
    with bounded(10.0):
        split = split_motion(model, q, v, 0 * v)
    assert split.held.all()
