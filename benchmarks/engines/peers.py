"""Other engines on the same chain: Pinocchio as called from Python, MuJoCo and Exudyn inside their own loops."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from benchmarks.engines.contender import CHECKED, Contender, PeerMissing, needed, now
from benchmarks.engines.rigid import CENTER, GRAVITY, INERTIA, MASS, TURNED, RigidChain
from numpy.typing import NDArray

__all__ = ["ENGINES", "mujoco_model", "pinocchio_model"]

_LIMITS = {
    "pinocchio": (300, "its data grow with the cube of them"),  # 32 GB at a thousand
    "mujoco": (400, "its reader of XML refuses trees so deep"),
    "exudyn": (36, "its time grows with the cube of them"),
}
"""Joints above which an engine is left out, and why."""

_CALLS, _MUJOCO_STEPS, _EXUDYN_STEPS = 300, 100, 40
"""Evaluations, or steps of four evaluations, that are timed at once."""


def _engine(module: str, package: str, robot: RigidChain) -> Any:
    """The module; raises :class:`PeerMissing` where it is absent or the robot too large for it."""
    most, why = _LIMITS[module]
    if robot.joints > most:
        raise PeerMissing(f"above {most} joints: {why}")
    return needed(module, package)


def pinocchio_model(robot: RigidChain) -> tuple[Any, Any]:
    """The module and the model; raises :class:`PeerMissing` where Pinocchio is absent or too large."""
    pin = _engine("pinocchio", "pin", robot)
    made, parent = pin.Model(), 0
    kinds = (pin.JointModelRX, pin.JointModelRY, pin.JointModelRZ)
    for k, (axis, place) in enumerate(zip(robot.axes, robot.places, strict=True)):
        parent = made.addJoint(parent, kinds[axis](), pin.SE3(TURNED, place), f"j{k}")
        made.appendBodyToJoint(parent, pin.Inertia(MASS, CENTER, np.diag(INERTIA)), pin.SE3.Identity())
    return pin, made


def _pinocchio(robot: RigidChain) -> Contender:
    """``aba`` at one state after the other."""
    pin, made = pinocchio_model(robot)
    data, none = made.createData(), np.zeros(robot.joints)
    states = list(zip(*robot.states(_CALLS), strict=True))

    def run() -> float:
        began = now()
        for q, v in states:
            pin.aba(made, data, q, v, none)
        return (now() - began) / _CALLS

    def found() -> Any:
        q, v = robot.states(1024)
        return np.array([pin.aba(made, data, q[k], v[k], none) for k in range(CHECKED)])

    return Contender(f"Pinocchio {pin.__version__} aba, from Python", run, found)


def mujoco_model(robot: RigidChain, step: float = 1e-5) -> tuple[Any, Any]:
    """The module and the model with a time step [s]; :class:`PeerMissing` where it cannot be."""
    mujoco = _engine("mujoco", "mujoco", robot)
    bodies = ""
    for axis, place in zip(robot.axes, robot.places, strict=True):
        bodies += (
            f'<body pos="{_words(place)}" quat="{_words(_quaternion())}"><joint axis="{_words(np.eye(3)[axis])}"/>'
        )
        bodies += f'<inertial pos="{_words(CENTER)}" mass="{MASS}" diaginertia="{_words(INERTIA)}"/>'
    option = f'<option integrator="RK4" timestep="{step!r}"><flag contact="disable" constraint="disable"/></option>'
    info = f"<mujoco>{option}<worldbody>{bodies}{'</body>' * robot.joints}</worldbody></mujoco>"
    return mujoco, mujoco.MjModel.from_xml_string(info)


def _words(values: NDArray[np.float64]) -> str:
    return " ".join(repr(float(value)) for value in values)


def _quaternion() -> NDArray[np.float64]:
    """The turn of the frames as w, x, y, z."""
    w = np.sqrt(1 + np.trace(TURNED)) / 2
    skew = (TURNED[2, 1] - TURNED[1, 2], TURNED[0, 2] - TURNED[2, 0], TURNED[1, 0] - TURNED[0, 1])
    return np.array([w, *(part / (4 * w) for part in skew)])


def _mujoco(robot: RigidChain) -> Contender:
    """Time of a step over its four evaluations."""
    mujoco, made = mujoco_model(robot)
    data = mujoco.MjData(made)
    rollout = needed("mujoco.rollout", "mujoco").rollout
    kind = mujoco.mjtState.mjSTATE_FULLPHYSICS
    start = np.zeros((1, mujoco.mj_stateSize(made, kind)))
    mujoco.mj_getState(made, data, start[0], kind)

    def run() -> float:
        began = now()
        rollout(made, data, start, nstep=_MUJOCO_STEPS)
        return (now() - began) / (4 * _MUJOCO_STEPS)

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


def _exudyn(robot: RigidChain) -> Contender:
    """Time of a step over its four evaluations."""
    sys.exudynFast = True  # type: ignore[attr-defined]  # Exudyn's own switch: the module without range checks
    exudyn = _engine("exudyn", "exudyn", robot)
    q, v = robot.states(1024)

    def run() -> float:
        system, _ = _system(exudyn, robot, np.zeros(robot.joints), np.zeros(robot.joints))
        settings = _settings(exudyn, 1e-5 * _EXUDYN_STEPS, _EXUDYN_STEPS)
        began = now()
        system.SolveDynamic(settings, solverType=exudyn.DynamicSolverType.RK44)
        return (now() - began) / (4 * _EXUDYN_STEPS)

    def found() -> NDArray[np.float64]:
        return np.array([_accelerations(exudyn, robot, q[k], v[k]) for k in range(CHECKED)])

    return Contender(f"Exudyn {exudyn.__version__} kinematic tree, in its RK44", run, found)


def _system(exudyn: Any, robot: RigidChain, q: NDArray[np.float64], v: NDArray[np.float64]) -> tuple[Any, Any]:
    """The chain at a state, and its node."""
    interface = needed("exudyn.itemInterface", "exudyn")
    system, n = exudyn.SystemContainer().AddSystem(), robot.joints
    kinds = (exudyn.JointType.RevoluteX, exudyn.JointType.RevoluteY, exudyn.JointType.RevoluteZ)
    node = system.AddNode(
        interface.NodeGenericODE2(
            numberOfODE2Coordinates=n, referenceCoordinates=[0.0] * n,
            initialCoordinates=list(q), initialCoordinates_t=list(v),
        )
    )  # fmt: skip
    system.AddObject(
        interface.ObjectKinematicTree(
            nodeNumber=node,
            gravity=list(GRAVITY),
            jointTypes=[kinds[axis] for axis in robot.axes],
            linkParents=list(range(-1, n - 1)),
            jointTransformations=exudyn.Matrix3DList([TURNED] * n),
            jointOffsets=exudyn.Vector3DList([list(place) for place in robot.places]),
            linkInertiasCOM=exudyn.Matrix3DList([np.diag(INERTIA)] * n),
            linkCOMs=exudyn.Vector3DList([list(CENTER)] * n),
            linkMasses=[MASS] * n,
        )
    )
    system.Assemble()
    return system, node


def _settings(exudyn: Any, end: float, steps: int) -> Any:
    """Nothing is written, printed or stored: the solver alone, in its fastest way."""
    settings = exudyn.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.active = False
    settings.linearSolver.solverType = exudyn.LinearSolverType.EXUdense
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.endTime = end
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.explicit.computeEndOfStepAccelerations = False
    return settings


def _accelerations(exudyn: Any, robot: RigidChain, q: NDArray[np.float64], v: NDArray[np.float64]) -> Any:
    """Accelerations after one step that is too short to move anything."""
    system, node = _system(exudyn, robot, q, v)
    settings = _settings(exudyn, 1e-14, 1)
    settings.timeIntegration.explicit.computeEndOfStepAccelerations = True
    system.SolveDynamic(settings, solverType=exudyn.DynamicSolverType.ExplicitEuler)
    return system.GetNodeOutput(node, exudyn.OutputVariableType.Coordinates_tt)


ENGINES = {"pinocchio": _pinocchio, "mujoco": _mujoco, "exudyn": _exudyn}
"""The contender of each engine; raises :class:`PeerMissing` where it is absent or the robot too large for it."""
