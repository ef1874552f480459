"""The falling arm of the stiff benchmark in Exudyn: geometrically exact beams in 3-D, hinges with spring and damper.

Each tube is a row of two-node beams (shear deformable, extensible, on SE(3)) between rigid nodes with Euler parameters;
a generic joint leaves one rotation free, a torsional spring and damper is its gear; the load rides on the last node.
Exudyn's own generalized alpha integrates, as it is the solver that its manual names for such beams; what is stored is
the tip, at the same times as ours.
"""

from __future__ import annotations

import sys
import time
from typing import Any, NamedTuple

import numpy as np
from benchmarks.engines.contender import PeerMissing
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.kinds.links.strain import Beam

sys.exudynFast = True  # type: ignore[attr-defined]  # Exudyn's own switch: the module without range checks
try:
    import exudyn as exu
    import exudyn.itemInterface as items
except ImportError as error:
    raise PeerMissing(f"Exudyn is needed for this peer (pip install exudyn): {error}") from error

__all__ = ["Fall", "fall"]


class Fall(NamedTuple):
    """Processor time of the solver alone [s], and the tip at each sample [m], shape (samples, 3)."""

    seconds: float
    tip: NDArray[np.float64]


def _section(link: Beam) -> Any:
    """Stiffness, mass and Kelvin-Voigt damping per length of the first piece; shear as of a thin tube."""
    piece = link.pieces[0]
    shear = piece.axial[0] * link.shear / link.young / 2
    section = exu.BeamSection()
    stiffness = np.diag([piece.axial[0], shear, shear, piece.torsion[0], piece.bend_y[0], piece.bend_z[0]])
    section.stiffnessMatrix, section.dampingMatrix = stiffness, link.damping_time * stiffness
    section.inertia = np.diag([row[0] for row in piece.inertia])
    section.massPerLength = piece.mass[0]
    return section


def _links(system: Any, chain: Chain, elements: int) -> int:
    """All tubes, hinges and gears; the number of the last node."""
    marker = system.AddMarker(items.MarkerBodyRigid(bodyNumber=system.AddObject(items.ObjectGround())))
    start = 0.0
    node = -1
    for part in chain.nodes:
        link, joint = part.link, part.joint
        assert isinstance(link, Beam)
        nodes = [_node(system, start + link.length * k / elements) for k in range(elements + 1)]
        for k in range(elements):
            beam = items.ObjectBeamGeometricallyExact(
                nodeNumbers=nodes[k : k + 2], length=link.length / elements, sectionData=_section(link)
            )
            _weigh(system, system.AddObject(beam))
        root = system.AddMarker(items.MarkerNodeRigid(nodeNumber=nodes[0]))
        turned = _axis_to_z(np.asarray(joint.axis, dtype=float))
        frames = {"markerNumbers": [marker, root], "rotationMarker0": turned, "rotationMarker1": turned}
        system.AddObject(items.ObjectJointGeneric(constrainedAxes=[1, 1, 1, 1, 1, 0], **frames))
        gear = joint.gear
        assert gear is not None
        spring = {"stiffness": gear.stiffness[0], "damping": gear.damping}
        system.AddObject(items.ObjectConnectorTorsionalSpringDamper(**frames, **spring))
        start, node = start + link.length, nodes[-1]
        marker = system.AddMarker(items.MarkerNodeRigid(nodeNumber=node))
    return node


def _node(system: Any, x: float) -> Any:
    return system.AddNode(items.NodeRigidBodyEP(referenceCoordinates=[x, 0, 0, 1, 0, 0, 0]))


def _weigh(system: Any, body: Any) -> None:
    marker = system.AddMarker(items.MarkerBodyMass(bodyNumber=body))
    system.AddLoad(items.LoadMassProportional(markerNumber=marker, loadVector=[0, 0, -9.81]))


def _axis_to_z(axis: NDArray[np.float64]) -> NDArray[np.float64]:
    """A rotation whose third column is the axis."""
    other = np.eye(3)[int(np.argmin(np.abs(axis)))]
    x = np.cross(other, axis)
    x /= np.linalg.norm(x)
    return np.column_stack([x, np.cross(axis, x), axis])


def fall(
    chain: Chain,
    *,
    elements: int,
    steps: int,
    spectral_radius: float = 0.9,
    modified_newton: bool = True,
    sparse: bool = True,
    newton_tolerance: float = 1e-8,
    duration: float = 1.0,
    samples: int = 101,
    load: tuple[float, float] = (2.0, 4e-3),
) -> Fall:
    """The fall over ``duration`` [s] in so many steps; ``load``: mass [kg] and each moment of inertia [kg*m^2]."""
    system = exu.SystemContainer().AddSystem()
    node = _links(system, chain, elements)
    mass, inertia = load
    _weigh(system, system.AddObject(items.ObjectRigidBody(mass=mass, inertia=[inertia] * 3 + [0] * 3, nodeNumber=node)))
    position = exu.OutputVariableType.Position
    sensor = system.AddSensor(items.SensorNode(nodeNumber=node, storeInternal=True, outputVariableType=position))
    system.Assemble()
    settings = exu.SimulationSettings()
    settings.timeIntegration.endTime, settings.timeIntegration.numberOfSteps = duration, steps
    settings.timeIntegration.verboseMode = 0
    settings.timeIntegration.generalizedAlpha.spectralRadius = spectral_radius
    settings.timeIntegration.newton.useModifiedNewton = modified_newton
    settings.timeIntegration.newton.relativeTolerance = newton_tolerance
    settings.linearSolver.solverType = exu.LinearSolverType.EigenSparse if sparse else exu.LinearSolverType.EXUdense
    settings.solutionSettings.sensorsWritePeriod = duration / (samples - 1)
    settings.solutionSettings.writeSolutionToFile = False
    began = time.process_time()
    done = system.SolveDynamic(settings, solverType=exu.DynamicSolverType.GeneralizedAlpha)
    seconds = time.process_time() - began
    if not done:
        raise ArithmeticError("Exudyn's solver stopped early")
    return Fall(seconds, system.GetSensorStoredData(sensor)[:, 1:4])
