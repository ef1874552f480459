"""A serial chain of rigid links in Pinocchio and MuJoCo: what a general engine pays for as many coordinates.

54 revolute joints about x, y and z in turn, on frames turned and shifted in general; each link a body with inertia.
"""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np

__all__ = ["mujoco_forward", "pinocchio_aba"]

_CALLS = 300


def _links(joints: int) -> list[tuple[np.ndarray, np.ndarray]]:
    """Axis and place of each joint in the link before."""
    rng = np.random.default_rng(1)
    return [(np.eye(3)[k % 3], rng.uniform(-0.1, 0.1, 3)) for k in range(joints)]


def pinocchio_aba(joints: int) -> Callable[[], float]:
    """Seconds per call of ``aba``, called from Python; raises ImportError where Pinocchio is absent."""
    import pinocchio as pin

    model, parent = pin.Model(), 0
    for k, (axis, place) in enumerate(_links(joints)):
        kind = (pin.JointModelRX(), pin.JointModelRY(), pin.JointModelRZ())[int(np.argmax(axis))]
        turned = pin.SE3(pin.utils.rotate("z", 0.3) @ pin.utils.rotate("x", 0.2), place)
        parent = model.addJoint(parent, kind, turned, f"j{k}")
        body = pin.Inertia(1.0, np.array([0.05, 0.01, 0.02]), np.diag([0.01, 0.02, 0.02]))
        model.appendBodyToJoint(parent, body, pin.SE3.Identity())
    data = model.createData()
    q, v, tau = (np.linspace(-0.3, 0.4, joints) * scale for scale in (1.0, 0.5, 2.0))

    def run() -> float:
        began = time.perf_counter()
        for _ in range(_CALLS):
            pin.aba(model, data, q, v, tau)
        return (time.perf_counter() - began) / _CALLS

    return run


def mujoco_forward(joints: int) -> Callable[[], float]:
    """Seconds per evaluation of the forward dynamics inside MuJoCo's own RK4 loop in C; ImportError where absent."""
    import mujoco
    from mujoco.rollout import rollout

    text = ""
    for axis, place in _links(joints):
        at, about = (" ".join(f"{x:.6f}" for x in values) for values in (place, axis))
        text += f'<body pos="{at}" euler="11 0 17"><joint axis="{about}"/>'
        text += '<inertial pos="0.05 0.01 0.02" mass="1" diaginertia="0.01 0.02 0.02"/>'
    sheet = '<mujoco><option integrator="RK4" timestep="1e-5"><flag contact="disable" constraint="disable"/></option>'
    model = mujoco.MjModel.from_xml_string(f"{sheet}<worldbody>{text}{'</body>' * joints}</worldbody></mujoco>")
    data = mujoco.MjData(model)
    size = mujoco.mj_stateSize(model, mujoco.mjtState.mjSTATE_FULLPHYSICS)
    state = np.zeros((1, size))
    mujoco.mj_getState(model, data, state[0], mujoco.mjtState.mjSTATE_FULLPHYSICS)

    def run() -> float:
        began = time.perf_counter()
        rollout(model, data, state, nstep=_CALLS)
        return (time.perf_counter() - began) / (4 * _CALLS)

    return run
