"""MuJoCo's forward dynamics on the same chain, inside its own Runge-Kutta loop in C: its fastest way."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.bench.contender import CHECKED, Contender, PeerMissing, needed, now
from tmodes.bench.rigid import CENTER, INERTIA, MASS, TURNED, RigidChain

__all__ = ["LARGEST", "contender", "model"]

LARGEST = 400
"""Joints above which it is left out: its reader of XML refuses deeper trees."""

_STEPS = 100


def model(robot: RigidChain, step: float = 1e-5) -> tuple[Any, Any]:
    """The module and the model with a time step [s]; :class:`PeerMissing` where it cannot be."""
    if robot.joints > LARGEST:
        raise PeerMissing(f"above {LARGEST} joints: its reader of XML refuses trees so deep")
    mujoco = needed("mujoco", "mujoco")
    bodies = ""
    for axis, place in zip(robot.axes, robot.places, strict=True):
        bodies += f'<body pos="{_info(place)}" quat="{_info(_quaternion())}"><joint axis="{_info(np.eye(3)[axis])}"/>'
        bodies += f'<inertial pos="{_info(CENTER)}" mass="{MASS}" diaginertia="{_info(INERTIA)}"/>'
    option = f'<option integrator="RK4" timestep="{step!r}"><flag contact="disable" constraint="disable"/></option>'
    info = f"<mujoco>{option}<worldbody>{bodies}{'</body>' * robot.joints}</worldbody></mujoco>"
    return mujoco, mujoco.MjModel.from_xml_string(info)


def _info(values: NDArray[np.float64]) -> str:
    return " ".join(repr(float(value)) for value in values)


def _quaternion() -> NDArray[np.float64]:
    """The turn of the frames as w, x, y, z."""
    w = np.sqrt(1 + np.trace(TURNED)) / 2
    skew = (TURNED[2, 1] - TURNED[1, 2], TURNED[0, 2] - TURNED[2, 0], TURNED[1, 0] - TURNED[0, 1])
    return np.array([w, *(part / (4 * w) for part in skew)])


def contender(robot: RigidChain) -> Contender:
    """Time of a step over its four evaluations."""
    mujoco, made = model(robot)
    data = mujoco.MjData(made)
    rollout = needed("mujoco.rollout", "mujoco").rollout
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    start = np.zeros((1, mujoco.mj_stateSize(made, kind)))
    mujoco.mj_getState(made, data, start[0], kind)

    def run() -> float:
        began = now()
        rollout(made, data, start, nstep=_STEPS)
        return (now() - began) / (4 * _STEPS)

    def found() -> Any:
        q, v = robot.states(1024)
        answers = []
        for k in range(CHECKED):
            mujoco.mj_resetData(made, data)
            data.qpos[:], data.qvel[:] = q[k], v[k]
            mujoco.mj_forward(made, data)
            answers.append(data.qacc.copy())
        return np.array(answers)

    return Contender(f"MuJoCo {mujoco.__version__} forward, in its RK4", run, found)
