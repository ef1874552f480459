"""The errors of the link models in the numbers of a run's summary, by a second run with other numbers of the links.

The equations are the same, so nothing is compiled. Of a link with functions the last ones of each direction are
softened; how far what is missing does more or less than these follows from the balance of the link's moments. A lumped
link gets masses and springs nearer to those of a beam of its section.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.errors import SimulationError
from tmodes.kinds.links.facts import DIRECTIONS
from tmodes.result.errors import distances, even_samples, sampled, summary_figures
from tmodes.sheet.robot import RECURSION
from tmodes.simulation.initial_state import RunSetup, run_setup
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.parts import Trajectory
from tmodes.simulation.solve import solve
from tmodes.simulation.stops import STOPPED

__all__ = ["SAFETY", "compared_chain", "model_errors"]

Array = NDArray[np.float64]

SAFETY = 2.0
"""Factor on the difference: chosen so that bounds hold in 99 % of random runs (docs/errors.md)."""

_WHOLE = 100
"""Parts of the whole run whose ends are compared too."""


_NEGLIGIBLE = 1e-8
"""Share of the energy of all links below which a direction of one does not count."""


def compared_chain(chain: Chain) -> Chain | str:
    """The chain with each flexible link as it is compared; else why there is none, empty where nothing bends."""
    if not any(node.link.bends for node in chain.nodes):
        return ""
    if chain.equations != RECURSION:
        return f"the equations `{chain.equations}` are stated for these links alone"
    links = {node.name: node.link.compared() for node in chain.nodes}
    nodes = [replace(node, link=link) for node in chain.nodes if (link := links[node.name]) is not None]
    if len(nodes) < len(chain.nodes):
        left = next(node for node in chain.nodes if links[node.name] is None)
        return f"the link {left.name} (`{left.link.kind}`) has no other numbers to be compared with"
    return replace(chain, nodes=tuple(nodes))


def model_errors(
    run: RunData, stations: Array, first: Mapping[str, Array], names: Mapping[str, list[str]],
    progress: Callable[[float], None] = lambda share: None,
) -> dict[str, Any]:  # fmt: skip
    """``how`` the errors of the link models are estimated, and ``figures``: that of each number by its path.

    Arguments as of :func:`tmodes.result.errors.summary_errors`. ``why``: why there are none; empty where nothing bends
    or they are not asked for. Raises KeyboardInterrupt where it is interrupted.
    """
    runs = [one for one in (run, run.reference) if one is not None]
    chains = [compared_chain(one.chain) for one in runs]
    if not run.robot.integration.model_error or "" in chains:
        return {}
    why = next((chain for chain in chains if not isinstance(chain, Chain)), "")
    if run.status not in {"finished", STOPPED} or run.setup.callback:
        why = "a Python function controls the robot" if run.setup.callback else "the run did not reach its end"
    pairs = [(one, chain) for one, chain in zip(runs, chains, strict=True) if isinstance(chain, Chain) and not why]
    compared = [_compared(*pair, float(run.times[-1]), progress) for pair in pairs]
    others, count = [one for one in compared if one is not None], len(first["tip"])
    if len(others) < len(runs) or any(len(trajectory.times) < count for _, trajectory in others):
        return {"how": "", "figures": {}, "why": why or "the robot with its links changed does not come as far"}
    own = {f"deformations.{name}.max" for name in run.coordinates}  # of a function by itself: no number of the robot
    figures = [figure for figure in summary_figures(first, names) if figure.name not in own]
    whole = even_samples(count, _WHOLE)  # what is missing may come at another time than what the last functions do
    apart = distances(figures, first, lambda at: [sampled(*one, at) for one in others], stations, whole)
    scale = SAFETY * uncertainty(run.chain, first, names, stations)
    how = " and ".join(dict.fromkeys(node.link.comparison for node in run.chain.nodes if node.link.bends))
    return {
        "how": f"run with {how}",
        "figures": {one.name: scale * float(max(near.max(), ever.max())) for one, near, ever in apart},
    }


def uncertainty(chain: Chain, variables: Mapping[str, Array], names: Mapping[str, list[str]], stations: Array) -> float:
    """How far the true errors may be over the difference of the runs, by the worst direction of a link.

    Of functions by the energy of their moments in the run: the balance's moment less the material's is what no function
    has (Galerkin); of the latter, the last functions' part is what the others do not have. Directions of no weight do
    not count.
    """
    links, found = {node.name: node.link for node in chain.nodes if node.link.bends}, []
    for name, link in links.items():
        for direction in link.projected:
            here = (slice(None), names["bending_link"].index(name), slice(None), DIRECTIONS.index(direction))
            root = np.sqrt(_weights(stations) / link.stiffness_at(direction, stations))
            moment, elastic = (variables[series][here] * root for series in ("moment", "elastic_moment"))
            shapes = link.other_moments(direction, stations) * root
            others = np.linalg.lstsq(shapes.T, elastic.T, rcond=None)[0] if len(shapes) else np.zeros((0, len(elastic)))
            parts = (moment - elastic, elastic - others.T @ shapes, moment)
            angle = float(np.linalg.norm(variables["slope"][:, names["bending_link"].index(name)], axis=-1).max())
            found.append((link, direction, angle, *(float(np.sum(part**2)) for part in parts)))
    least = _NEGLIGIBLE * sum(whole for *_, whole in found)
    shares = [
        link.uncertainty(way, missing / last, angle)
        for link, way, angle, missing, last, whole in found
        if whole > least and last
    ]
    return max(
        [*shares, *(link.uncertainty("", 0.0, 0.0) for link in links.values() if not link.projected)], default=0.0
    )


def _compared(
    run: RunData, chain: Chain, until: float, progress: Callable[[float], None]
) -> tuple[RunSetup, Trajectory] | None:
    """The same run with a compared chain; None where it cannot go as far."""
    setup = run.setup
    robot = run.robot.model_copy(update={"integration": run.robot.integration.quick()})
    try:
        other = run_setup(robot, setup.follow, chain=chain)
    except SimulationError:
        return None
    settings = robot.integration.model_copy(update={"duration": until})
    trajectory = solve(replace(other, otherwise=setup.otherwise).problem(settings), progress=progress)
    if trajectory.status == "interrupted":
        raise KeyboardInterrupt
    return (other, trajectory) if trajectory.status == "finished" else None


def _weights(places: Array) -> Array:
    """Weights of the trapezoidal rule at places that rise; one that is given twice counts for both sides."""
    steps = np.diff(places)
    return (np.append(steps, 0.0) + np.append(0.0, steps)) / 2
