"""The nearest equivalent of the seed's robot in MuJoCo: a chain of six hinges, without contact.

What is the same: motor (armature, back-EMF, PD gains), gear spring and damper, point masses and rotary inertias at the
tips of the modes, stiffness and damping of the modes, gravity; the same six degrees of freedom and frequencies.
The modes' rule ``tip slope = 3/2 deflection/length`` needs no coupled joint: one hinge a third of the way along a mode,
turning by 3/2 of the chord's angle, gives the same tip position and slope to first order; its stiffness is 4/9 Cs l^2.

What differs: each tip moves on an arc about that hinge, the tips' inertia is the same about all three axes, and
elevations follow the bent chain instead of the fixed vertical: effects of second order in the bending angles. The
reference is held over a step (at its midpoint), since an actuator's control is constant in a step.

``python -m benchmarks.peers.mujoco_chain`` prints the frequencies, the times and the final tip.
"""

from __future__ import annotations

import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from benchmarks.engines.contender import PeerMissing
from numpy.typing import NDArray

from . import example

try:
    import mujoco
    from mujoco.rollout import rollout
except ImportError as error:
    raise PeerMissing(f"MuJoCo is needed for this peer (pip install mujoco): {error}") from error

FloatArray = NDArray[np.float64]
DOF = 6


@dataclass(frozen=True)
class ChainRun:
    """Wall time of the steps alone [s], best of the repeats, and the final tip [m], shape (3,)."""

    seconds: float
    tip: FloatArray


def _mode(number: int, p: dict[str, float], before: str, mass: float, inertia: float, inside: str) -> str:
    """One mode as a body of MJCF: joints in ``before``, then a hinge in each plane a third of the way along."""
    length, stiffness = p[f"l{number}"], 4.0 / 9.0 * p[f"Cs{number}"] * p[f"l{number}"] ** 2
    spring = f'stiffness="{stiffness!r}" damping="{stiffness * p[f"Bs{number}"] / p[f"Cs{number}"]!r}"'
    place = f'pos="{length / 3.0!r} 0 0" {spring}'
    start = p["l1"] if number == 2 else 0.0
    return f"""<body name="mode{number}" pos="{start!r} 0 0">{before}
        <joint name="h{number}" axis="0 0 1" {place}/><joint name="v{number}" axis="0 -1 0" {place}/>
        <inertial pos="{length!r} 0 0" mass="{mass!r}" diaginertia="{inertia!r} {inertia!r} {inertia!r}"/>
        {inside}</body>"""


def description(p: dict[str, float]) -> str:
    """The chain as MJCF."""
    drive = f"""<joint name="theta" axis="0 0 1" armature="{p["I"]!r}"/>
        <joint name="xi" axis="0 0 1" stiffness="{p["Cxi"]!r}" damping="{p["Bxi"]!r}"/>"""
    end = f'<site name="tip" pos="{p["l2"]!r} 0 0"/>'
    second = _mode(2, p, "", p["m"] + p["mel2"], p["Jzz"] + p["Jel2"], end)
    gain = p["CM"] / p["R"]
    feedback = f"0 {-gain * p['Klp']!r} {-gain * (p['Klv'] + p['CE']) - p['Bm']!r}"
    return f"""<mujoco model="chain"><compiler angle="radian"/>
      <option integrator="RK4" timestep="{example.STEP!r}" gravity="0 0 {-p["g"]!r}">
        <flag contact="disable" constraint="disable" warmstart="disable"/></option>
      <worldbody>{_mode(1, p, drive, p["mel1"], p["Jel1"], second)}</worldbody>
      <actuator><general joint="theta" biastype="affine" gainprm="{gain!r}" biasprm="{feedback}"/></actuator>
      </mujoco>"""


def controls(p: dict[str, float], steps: int = example.STEPS) -> FloatArray:
    """Klp theta_o + Klv theta_o' [V] at each step's midpoint, shape (steps,)."""
    middle = (np.arange(steps) + 0.5) * example.STEP
    knots, rows = example.reference()
    row = np.array(rows)[np.searchsorted(knots, middle, side="right") - 1].T
    tau = middle - row[0]
    wanted, speed = row[1] + row[2] * tau + row[3] * tau**2, row[2] + 2.0 * row[3] * tau
    return p["Klp"] * wanted + p["Klv"] * speed


def _accelerations(model: Any, data: Any, state: FloatArray) -> FloatArray:
    data.qpos[:], data.qvel[:], data.ctrl[:] = state[:DOF], state[DOF:], 0.0
    mujoco.mj_forward(model, data)
    return data.qacc.copy()


def _slope(model: Any, data: Any, state: FloatArray) -> FloatArray:
    """Derivative of the accelerations by position and rate, shape (6, 12), by central differences."""
    nudges = 1e-6 * np.eye(2 * DOF)
    changes = [_accelerations(model, data, state + d) - _accelerations(model, data, state - d) for d in nudges]
    return np.transpose(changes) / 2e-6


def equilibrium(model: Any, data: Any) -> FloatArray:
    """State of rest under gravity with theta = 0, shape (12,), by Newton's method."""
    state = np.zeros(2 * DOF)
    for _ in range(20):
        state[:DOF] -= np.linalg.solve(_slope(model, data, state)[:, :DOF], _accelerations(model, data, state))
    return state


def frequencies(model: Any, data: Any, state: FloatArray) -> FloatArray:
    """Frequencies [Hz] with the motor locked, about ``state``, rising: moduli of the damped eigenvalues."""
    armature = model.dof_armature[0]
    model.dof_armature[0] = 1e12  # a motor so heavy that it stands still
    slope = _slope(model, data, state)[1:]
    model.dof_armature[0] = armature
    held = np.vstack([np.eye(DOF - 1, 2 * (DOF - 1), DOF - 1), np.delete(slope, (0, DOF), axis=1)])
    roots = np.linalg.eigvals(held)
    return np.sort(np.abs(roots[roots.imag > 0.0])) / (2.0 * np.pi)


def make() -> tuple[Any, Any, FloatArray]:
    """Model, data and the state of rest."""
    model = mujoco.MjModel.from_xml_string(description(example.parameters()))
    data = mujoco.MjData(model)
    return model, data, equilibrium(model, data)


def _final_tip(model: Any, data: Any, state: FloatArray) -> FloatArray:
    _accelerations(model, data, state)
    return data.site("tip").xpos.copy()


def run_native(repeats: int = 3) -> ChainRun:
    """The whole run in ``mujoco.rollout``, one native call: MuJoCo's fastest way. RK4, 37,500 steps."""
    model, data, rest = make()
    signal = controls(example.parameters())[None, :, None]
    start = np.concatenate([[0.0], rest])[None]
    best, state = np.inf, rest
    for _ in range(repeats):
        began = time.perf_counter()
        states, _ = rollout(model, data, start, signal)
        best, state = min(best, time.perf_counter() - began), np.asarray(states)[0, -1, 1 : 1 + 2 * DOF]
    return ChainRun(best, _final_tip(model, data, state))


def run_python() -> ChainRun:
    """The same with ``mj_step`` in a Python loop."""
    model, data, rest = make()
    signal = controls(example.parameters())
    mujoco.mj_resetData(model, data)
    data.qpos[:], data.qvel[:] = rest[:DOF], rest[DOF:]
    control = data.ctrl
    began = time.perf_counter()
    for value in signal:
        control[0] = value
        mujoco.mj_step(model, data)
    seconds = time.perf_counter() - began
    return ChainRun(seconds, _final_tip(model, data, np.concatenate([data.qpos, data.qvel])))


if __name__ == "__main__":
    print("frequencies [Hz]", np.round(frequencies(*make()), 4), "wanted", example.FREQUENCIES)
    for name, run in (("rollout", run_native()), ("Python loop", run_python())):
        print(f"{name}: {run.seconds:.3f} s, final tip {run.tip} m")
