"""Large motion of flexible links against Exudyn's beams (absolute nodal coordinates), over two seconds."""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np
import pytest

from tmodes.sheet import Robot
from tmodes.simulation.simulate import simulate_motion

exudyn: Any = pytest.importorskip("exudyn", reason="needs `pip install exudyn`")

pytestmark = [pytest.mark.peer, pytest.mark.slow, pytest.mark.filterwarnings("ignore::DeprecationWarning")]

DURATION, SAMPLES = 2.0, 41
LINKS = ({"L": 0.6, "rhoA": 0.5, "EI": 8.0, "EA": 4e5}, {"L": 0.5, "rhoA": 0.3, "EI": 3.0, "EA": 2e5})


def cables(count: int, elements: int = 12, steps: int = 4000) -> np.ndarray:
    """Tips of links that hang from a pin and from each other and fall from the horizontal, shape (SAMPLES, 2)."""
    made: Any = import_module("exudyn.utilities")
    beams: Any = import_module("exudyn.beams")
    system = exudyn.SystemContainer()
    bodies = system.AddSystem()
    ground = bodies.AddObject(made.ObjectGround())
    before, start = bodies.AddMarker(made.MarkerBodyPosition(bodyNumber=ground)), 0.0
    nodes: list[int] = []
    for link in LINKS[:count]:
        template = made.ObjectANCFCable2D(
            physicsMassPerLength=link["rhoA"], physicsBendingStiffness=link["EI"], physicsAxialStiffness=link["EA"]
        )
        nodes = beams.GenerateBeamElementsAlongLine(
            bodies, [start, 0, 0], [start + link["L"], 0, 0], elements, beamTemplate=template, gravity=[0, -9.81, 0]
        )["nodes"]
        root = bodies.AddMarker(made.MarkerNodePosition(nodeNumber=nodes[0]))
        bodies.AddObject(made.ObjectJointRevolute2D(markerNumbers=[before, root]))
        before = bodies.AddMarker(made.MarkerNodePosition(nodeNumber=nodes[-1]))
        start += link["L"]
    sensor = bodies.AddSensor(
        made.SensorNode(nodeNumber=nodes[-1], storeInternal=True, outputVariableType=exudyn.OutputVariableType.Position)
    )
    bodies.Assemble()
    settings = exudyn.SimulationSettings()
    settings.timeIntegration.endTime = DURATION
    settings.timeIntegration.numberOfSteps = steps
    settings.timeIntegration.generalizedAlpha.spectralRadius = 0.9
    settings.timeIntegration.verboseMode = 0
    settings.solutionSettings.sensorsWritePeriod = DURATION / (SAMPLES - 1)
    settings.solutionSettings.writeSolutionToFile = False
    bodies.SolveDynamic(settings)
    return bodies.GetSensorStoredData(sensor)[:, 1:3]


def links(count: int) -> np.ndarray:
    """The same as an arm of true beams."""
    sheet = {
        "format": 1, "kind": "arm", "name": "falling", "gravity": [0.0, -9.81, 0.0],
        "joints": [{"name": f"j{k}", "type": "revolute", "child": f"l{k}", "axis": [0, 0, 1]} for k in range(count)],
        "links": [
            {"name": f"l{k}", "beam": {
                "model": "strain", "functions": {"bend_z": 5}, "length": link["L"], "damping_time": 0.0,
                "rotary_inertia": "none",
                "section": {"bending_stiffness": link["EI"], "mass_per_length": link["rhoA"]}}}
            for k, link in enumerate(LINKS[:count])
        ],
        "drives": [
            {"joint": f"j{k}", "command": "effort", "signal": {"type": "constant", "value": 0.0}} for k in range(count)
        ],
        "initial": {"state": "zero"},
        "integration": {"duration": DURATION, "output_step": DURATION / (SAMPLES - 1), "relative_tolerance": 1e-8,
                        "absolute_tolerance": 1e-10},
    }  # fmt: skip
    return simulate_motion(Robot.from_data(sheet)).points.position[:, 0, :2]


@pytest.mark.parametrize("count", [1, 2])
def test_falling_links_move_as_exudyns(count: int) -> None:
    length = sum(link["L"] for link in LINKS[:count])
    theirs, ours = cables(count), links(count)
    assert theirs.shape == ours.shape
    assert np.abs(np.diff(ours, axis=0)).max() > 0.1 * length  # they do move
    assert np.abs(theirs - ours).max() < 0.002 * length
