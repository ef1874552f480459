"""The nearest equivalent of the seed's robot in Exudyn: one KinematicTree of six hinges, without contact.

The same chain as the MuJoCo peer: motor, gear, and for each mode and plane one hinge a third of the way along, turning
by 3/2 of the chord's angle (stiffness 4/9 Cs l^2), which gives a tip-loaded cantilever's tip position and slope to
first order. Springs, dampers and the motor's feedback are the tree's own P and D vectors; the reference enters as a
torque, a symbolic user function that Exudyn evaluates natively at every stage. The motor's inertia is a link's.

What differs from the robot: as in MuJoCo, effects of second order in the bending angles.

``python -m benchmarks.peers.exudyn_chain`` prints the frequencies, the times and the final tip.
"""

from __future__ import annotations

import sys
import time
from dataclasses import dataclass
from typing import Any

import numpy as np
from benchmarks.engines.contender import PeerMissing
from numpy.typing import NDArray

from . import example

sys.exudynFast = True  # type: ignore[attr-defined]  # Exudyn's own switch: the module without range checks
try:
    import exudyn as exu
    from exudyn.advancedUtilities import CreateSymbolicUserFunction
    from exudyn.itemInterface import (
        LoadCoordinate,
        MarkerNodeCoordinate,
        NodeGenericODE2,
        ObjectKinematicTree,
        SensorKinematicTree,
    )
except ImportError as error:
    raise PeerMissing(f"Exudyn is needed for this peer (pip install exudyn): {error}") from error

FloatArray = NDArray[np.float64]
DOF = 6


@dataclass(frozen=True)
class ChainRun:
    """Wall time of the solver alone [s], best of the repeats, and the final tip [m], shape (3,)."""

    seconds: float
    tip: FloatArray


@dataclass(frozen=True)
class Chain:
    """An assembled system; ``keep`` holds what must live as long as the system does."""

    system: Any
    node: Any
    sensor: Any
    keep: tuple[Any, ...]


def _tree(p: dict[str, float], node: Any) -> Any:
    """The tree: theta and gear about z, then for each mode a hinge about z and one about y; tips carry the masses."""
    z, y = exu.JointType.RevoluteZ, exu.JointType.RevoluteY
    second = 2.0 / 3.0 * p["l1"] + p["l2"] / 3.0
    along = [0.0, 0.0, p["l1"] / 3.0, 0.0, second, 0.0]
    masses = [0.0, 0.0, 0.0, p["mel1"], 0.0, p["m"] + p["mel2"]]
    tips = [0.0, 0.0, 0.0, 2.0 / 3.0 * p["l1"], 0.0, 2.0 / 3.0 * p["l2"]]
    turning = [np.diag([0.0, 0.0, p["I"]]), *[j * np.eye(3) for j in (0.0, 0.0, p["Jel1"], 0.0, p["Jzz"] + p["Jel2"])]]
    bend = [4.0 / 9.0 * p[f"l{j}"] ** 2 for j in (1, 1, 2, 2)]
    gain = p["CM"] / p["R"]
    stiff = [b * p[f"Cs{j}"] for b, j in zip(bend, (1, 1, 2, 2), strict=True)]
    damp = [b * p[f"Bs{j}"] for b, j in zip(bend, (1, 1, 2, 2), strict=True)]
    return ObjectKinematicTree(
        nodeNumber=node,
        gravity=[0.0, 0.0, -p["g"]],
        jointTypes=[z, z, z, y, z, y],
        linkParents=[-1, 0, 1, 2, 3, 4],
        jointTransformations=exu.Matrix3DList([np.eye(3)] * DOF),
        jointOffsets=exu.Vector3DList([[x, 0.0, 0.0] for x in along]),
        linkInertiasCOM=exu.Matrix3DList(turning),
        linkCOMs=exu.Vector3DList([[x, 0.0, 0.0] for x in tips]),
        linkMasses=masses,
        jointPositionOffsetVector=[0.0] * DOF,
        jointVelocityOffsetVector=[0.0] * DOF,
        jointPControlVector=[gain * p["Klp"], p["Cxi"], *stiff],
        jointDControlVector=[gain * (p["Klv"] + p["CE"]) + p["Bm"], p["Bxi"], *damp],
    )


def _torque(p: dict[str, float], symbolic: Any) -> Any:
    """Torque of the reference, CM/R (Klp theta_o + Klv theta_o') [N m], as a function Exudyn can record."""
    knots, rows = example.reference()
    gain = p["CM"] / p["R"]

    def piece(t: Any, row: list[float]) -> Any:
        tau = t - row[0]
        wanted, speed = row[1] + row[2] * tau + row[3] * tau * tau, row[2] + 2.0 * row[3] * tau
        return gain * (p["Klp"] * wanted + p["Klv"] * speed)

    def torque(_mbs: Any, t: Any, _load: Any) -> Any:
        later = symbolic.IfThenElse(t < knots[2], piece(t, rows[1]), piece(t, rows[2]))
        return symbolic.IfThenElse(t < knots[1], piece(t, rows[0]), later)

    return torque


def make(start: FloatArray, driven: bool = True) -> Chain:
    """The chain at ``start`` [rad], shape (6,), at rest; not ``driven``: the motor's reference stays at zero."""
    p, system = example.parameters(), exu.SystemContainer().AddSystem()
    node = system.AddNode(
        NodeGenericODE2(
            numberOfODE2Coordinates=DOF,
            referenceCoordinates=[0.0] * DOF,
            initialCoordinates=list(start),
            initialCoordinates_t=[0.0] * DOF,
        )
    )
    tree, keep = system.AddObject(_tree(p, node)), ()
    if driven:
        marker = system.AddMarker(MarkerNodeCoordinate(nodeNumber=node, coordinate=0))
        load = system.AddLoad(LoadCoordinate(markerNumber=marker, load=0.0))
        function = CreateSymbolicUserFunction(system, _torque(p, exu.symbolic), "loadUserFunction", load)
        system.SetLoadParameter(load, "loadUserFunction", function)
        keep = (function,)
    end = SensorKinematicTree(
        objectNumber=tree,
        linkNumber=DOF - 1,
        localPosition=[2.0 / 3.0 * p["l2"], 0.0, 0.0],
        writeToFile=False,
        outputVariableType=exu.OutputVariableType.Position,
    )
    sensor = system.AddSensor(end)
    system.Assemble()
    return Chain(system, node, sensor, keep)


def _settings() -> Any:
    """Nothing is written, printed or stored: the solver alone."""
    settings = exu.SimulationSettings()
    settings.solution.file.write = False
    settings.solution.sensors.active = False
    settings.linearSolver.solverType = exu.LinearSolverType.EXUdense
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.endTime = example.DURATION
    settings.staticSolver.verboseMode = 0
    settings.staticSolver.newton.relativeTolerance = 1e-12
    settings.staticSolver.newton.absoluteTolerance = 1e-12
    return settings


def equilibrium() -> FloatArray:
    """Coordinates of rest under gravity [rad], shape (6,), by Exudyn's static solver."""
    chain = make(np.zeros(DOF), driven=False)
    chain.system.SolveStatic(_settings())
    return np.array(chain.system.GetNodeOutput(chain.node, exu.OutputVariableType.Coordinates))


def frequencies() -> FloatArray:
    """Undamped frequencies [Hz] with the motor locked, about the sagged rest, rising."""
    chain = make(equilibrium(), driven=False)
    found = chain.system.ComputeODE2Eigenvalues(constrainedCoordinates=[0], convert2Frequencies=True)
    return np.sort(np.asarray(found[0], dtype=float))


def _run(settings: Any, solver: Any, repeats: int) -> ChainRun:
    rest, best, tip = equilibrium(), np.inf, np.zeros(3)
    for _ in range(repeats):
        chain = make(rest)
        began = time.perf_counter()
        done = chain.system.SolveDynamic(settings, solverType=solver)
        best = min(best, time.perf_counter() - began)
        if not done:
            raise ArithmeticError("Exudyn's solver stopped early")
        tip = np.array(chain.system.GetSensorValues(chain.sensor))
    return ChainRun(best, tip)


def run_explicit(repeats: int = 3) -> ChainRun:
    """RK44 of fixed step, 37,500 steps, without the accelerations at the end of each step (its fastest way)."""
    settings = _settings()
    settings.timeIntegration.numberOfSteps = example.STEPS
    settings.timeIntegration.explicit.computeEndOfStepAccelerations = False
    return _run(settings, exu.DynamicSolverType.RK44, repeats)


def run_implicit(steps: int = 2_000, repeats: int = 1) -> ChainRun:
    """Exudyn's default, implicit generalized alpha with modified Newton, for information: another accuracy."""
    settings = _settings()
    settings.timeIntegration.numberOfSteps = steps
    return _run(settings, exu.DynamicSolverType.GeneralizedAlpha, repeats)


if __name__ == "__main__":
    print("frequencies [Hz]", np.round(frequencies(), 4), "wanted", example.FREQUENCIES)
    for name, run in (("RK44", run_explicit()), ("generalized alpha, 2000 steps", run_implicit())):
        print(f"{name}: {run.seconds:.3f} s, final tip {run.tip} m")
