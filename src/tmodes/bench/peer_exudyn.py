"""Exudyn's kinematic tree on the same chain, inside its own Runge-Kutta loop in C++."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.bench.contender import CHECKED, Contender, PeerMissing, needed, now
from tmodes.bench.rigid import CENTER, GRAVITY, INERTIA, MASS, TURNED, RigidChain

__all__ = ["LARGEST", "contender"]

LARGEST = 36
"""Joints above which it is left out: its time grows with the cube of them."""

_STEPS = 40


def contender(robot: RigidChain) -> Contender:
    """Time of a step over its four evaluations; raises :class:`PeerMissing` where Exudyn is absent."""
    if robot.joints > LARGEST:
        raise PeerMissing(f"above {LARGEST} joints: its time grows with the cube of them")
    exudyn = _module()
    q, v = robot.states(1024)

    def run() -> float:
        system, _ = _system(exudyn, robot, np.zeros(robot.joints), np.zeros(robot.joints))
        settings = _settings(exudyn, 1e-5 * _STEPS, _STEPS)
        began = now()
        system.SolveDynamic(settings, solverType=exudyn.DynamicSolverType.RK44)
        return (now() - began) / (4 * _STEPS)

    def found() -> NDArray[np.float64]:
        return np.array([_accelerations(exudyn, robot, q[k], v[k]) for k in range(CHECKED)])

    return Contender(f"Exudyn {exudyn.__version__} kinematic tree, in its RK44", run, found)


def _module() -> Any:
    sys.exudynFast = True  # type: ignore[attr-defined]  # Exudyn's own switch: the module without range checks
    return needed("exudyn", "exudyn")


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
