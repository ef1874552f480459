"""The errors of the link models in the numbers of a run's summary, from what the links' last functions do.

A flexible link has as many functions as its sheet says. The run is done again with the last functions of each direction
softened, and each number is compared: this is what the last functions do. The equations are the same, only numbers
differ, so nothing is compiled. What the missing functions would do is in proportion to what is missing in the balance
of the links' moments.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.errors import SimulationError
from tmodes.kinds.links.facts import DIRECTIONS
from tmodes.result.errors import distances, even_samples, sampled, summary_figures
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.start import RunSetup, run_setup
from tmodes.simulation.stops import STOPPED
from tmodes.simulation.trajectory import integrate

__all__ = ["SAFETY", "compared_chain", "model_errors"]

Array = NDArray[np.float64]

SAFETY = 2.5
"""Factor on the difference: chosen so that bounds hold in 99 % of random runs (docs/errors.md)."""

_WHOLE = 100
"""Parts of the whole run whose ends are compared too."""


def compared_chain(chain: Chain) -> Chain | None:
    """The chain with each flexible link as it is compared; None where none bends, or one is not estimated."""
    links = [node.link.compared() for node in chain.nodes]
    if None in links or not any(node.link.bends for node in chain.nodes):
        return None
    nodes = [replace(node, link=link) for node, link in zip(chain.nodes, links, strict=True) if link is not None]
    return replace(chain, nodes=tuple(nodes))


def model_errors(
    run: RunData, stations: Array, first: Mapping[str, Array], names: Mapping[str, list[str]]
) -> dict[str, Any]:
    """``how`` the errors of the link models are estimated, and ``figures``: that of each number by its path.

    Arguments as of :func:`tmodes.result.errors.summary_errors`. Empty where they are not known.
    """
    runs = [one for one in (run, run.reference) if one is not None]
    if run.status not in {"finished", STOPPED} or not run.robot.integration.model_error:
        return {}
    compared = [_compared(one, float(run.times[-1])) for one in runs]
    others, count = [one for one in compared if one is not None], len(first["tip"])
    if len(others) < len(runs) or any(len(trajectory.times) < count for _, trajectory in others):
        return {}
    own = {f"deformations.{name}.max" for name in run.coordinates}  # of a function by itself: no number of the robot
    figures = [figure for figure in summary_figures(first, names) if figure.name not in own]
    whole = even_samples(count, _WHOLE)  # what is missing may come at another time than what the last functions do
    apart = distances(figures, first, lambda at: [sampled(*one, at) for one in others], stations, whole)
    scale = SAFETY * missing_over_last(run.chain, first, names, stations)
    how = "run with the last functions of each direction of each flexible link softened"
    return {
        "how": how,
        "figures": {one.name: scale * float(max(near.max(), ever.max() / 2)) for one, near, ever in apart},
    }


def missing_over_last(
    chain: Chain, variables: Mapping[str, Array], names: Mapping[str, list[str]], stations: Array
) -> float:
    """Size of what the links' functions miss over that of the last ones, of the worst direction of a link.

    By the energy of their moments in the run: the balance's moment less the material's is what no function has
    (Galerkin); of the latter, the last functions' part is what the others do not have. Directions of no weight do not
    count.
    """
    links, found = {node.name: node.link for node in chain.nodes}, []
    for index, name in enumerate(names["bending_link"]):
        link = links[name]
        for direction in link.projected:
            here = (slice(None), index, slice(None), DIRECTIONS.index(direction))
            root = np.sqrt(_weights(stations) / link.stiffness_at(direction, stations))
            moment, elastic = (variables[series][here] * root for series in ("moment", "elastic_moment"))
            shapes = link.other_moments(direction, stations) * root
            others = np.linalg.lstsq(shapes.T, elastic.T, rcond=None)[0] if len(shapes) else np.zeros((0, len(elastic)))
            parts = (moment - elastic, elastic - others.T @ shapes, moment)
            found.append([float(np.sum(part**2)) for part in parts])
    missing, last, whole = np.array(found).reshape(-1, 3).T
    count = (whole > _NEGLIGIBLE * whole.sum()) & (last > 0)
    return float(np.sqrt(np.max(missing[count] / last[count], initial=0.0)))


_NEGLIGIBLE = 1e-8
"""Share of the energy of all links below which a direction of one does not count."""


def _compared(run: RunData, until: float) -> tuple[RunSetup, Trajectory] | None:
    """The same run with the compared links; None where there is none, or it cannot go as far."""
    setup = run.setup
    chain = None if setup.callback else compared_chain(setup.planned.chain)
    if chain is None:
        return None
    robot = run.robot.model_copy(update={"integration": run.robot.integration.quick()})
    try:
        other = run_setup(robot, setup.follow, chain=chain)
    except SimulationError:
        return None
    settings = robot.integration.model_copy(update={"duration": until})
    motion = (other.model, other.model.numbers, other.planned.schedule, other.start)
    trajectory = integrate(*motion, settings, otherwise=setup.otherwise)
    return (other, trajectory) if trajectory.status == "finished" else None


def _weights(places: Array) -> Array:
    """Weights of the trapezoidal rule at places that rise; one that is given twice counts for both sides."""
    steps = np.diff(places)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
