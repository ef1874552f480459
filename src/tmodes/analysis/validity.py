"""How far links bend, and where a robot leaves what its models or its materials are good for."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.line import LinkLine, LinkLines, elastic_line
from tmodes.equations.recursion.parts import NodePart
from tmodes.kinds.links.contract import Link
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.robot import yield_strength

__all__ = [
    "LinkRange", "link_angles", "link_ranges", "missing_share", "rest_warnings", "run_warnings",
]  # fmt: skip

Array = NDArray[np.float64]

VERDICTS = ("good", "fair", "beyond the model")


@dataclass(frozen=True)
class LinkRange:
    """A flexible link in one pose.

    ``angle_rad``: the one that limits its ``model``; ``slope_rad``: by which its end has turned from the unbent link;
    ``deflection_m``: by which its end has moved, ``deflection_over_length``;
    ``verdict``: good, fair, beyond the model; ``cure``: what would help.
    """

    link: str
    model: str
    angle_rad: float
    slope_rad: float
    deflection_m: float
    deflection_over_length: float
    verdict: str
    cure: str = ""


def link_angles(model: Model, q: ArrayLike) -> dict[str, Array]:
    """For each flexible link the angle [rad] that limits its model, at poses q (n, nq): arrays (n,)."""
    poses = np.atleast_2d(np.asarray(q, dtype=float))
    return {
        one.node.name: one.node.link.limiting_angles(poses[:, one.link.own]) for one in model.parts.nodes if one.link
    }


def link_ranges(model: Model, q: ArrayLike) -> list[LinkRange]:
    """The flexible links in the pose q (nq,)."""
    pose = np.asarray(q, dtype=float)
    angles, unbent = link_angles(model, pose), pose.copy()
    unbent[model.deformations] = 0.0
    lines = elastic_line(model, np.stack([pose, unbent]), stations=[0.0, 1.0])
    return [
        _range(part, [line for line in lines.links.values() if line.node == index], float(angles[part.node.name][0]))
        for index, part in enumerate(model.parts.nodes)
        if part.link
    ]


def _range(part: NodePart, lines: list[LinkLine], angle: float) -> LinkRange:
    """``lines`` of the link from root to tip: bent and unbent, the ends of each."""
    link, first, last = part.node.link, lines[0], lines[-1]
    roots = first.rotation[:, 0].swapaxes(1, 2)
    bent_tip, tip = (roots @ (last.position[:, 1] - first.position[:, 0])[..., None])[..., 0]
    moved = float(np.linalg.norm(bent_tip - tip))
    bent_axes, axes = roots @ last.rotation[:, 1]
    turned = bent_axes @ axes.T
    slope = float(np.arctan2(np.linalg.norm(turned - turned.T) / np.sqrt(8), (np.trace(turned) - 1) / 2))
    limit = link.angle_limit
    verdict = VERDICTS[int(angle > limit.good) + int(angle > limit.fair)]
    share = moved / link.length
    return LinkRange(part.node.name, link.kind, angle, slope, moved, share, verdict, limit.cure)


MISSING_SHARE = 0.01
"""Share of a link's bending energy in shapes that its functions do not have, from which more are advised."""

_NEGLIGIBLE = 1e-4
"""Share of a link's energy below which a direction does not count."""


def run_warnings(robot: Robot, model: Model, times: ArrayLike, q: ArrayLike, lines: LinkLines) -> list[str]:
    """Sentences on the links in a run at n times [s]; each says what, when first, how far, and what to do.

    ``q`` (n, nq); ``lines`` of the same samples, under the same wrenches.
    """
    time, q = (np.asarray(x, dtype=float) for x in (times, q))
    return [*_angles(model, time, q), *_of_lines(robot, model, time, lines)]


def rest_warnings(robot: Robot, model: Model, lines: LinkLines) -> list[str]:
    """Sentences on a robot at rest: functions that are missing, material that yields, links pressed too hard.

    ``lines``: of the one pose, under its loads.
    """
    return [*_of_lines(robot, model, np.zeros(1), lines)]


def _of_lines(robot: Robot, model: Model, time: Array, lines: LinkLines) -> Iterator[str]:
    yield from _functions(model, lines)
    for line in lines.bending():
        yield from _yielding(robot, time, line)
        yield from _buckling(model, time, line)


def _angles(model: Model, time: Array, q: Array) -> Iterator[str]:
    """Angles beyond what the equations of a link are good for."""
    for part in model.parts.nodes:
        if part.link is None:
            continue
        link, stations = part.node.link, tuple(s for s, _ in part.link.stations)
        limit = link.angle_limit
        yield from _beyond(
            time, link.limiting_angles(q[:, part.link.own], stations), limit.warning,
            f"link {part.node.name} {limit.what}", "rad", limit.hint,
        )  # fmt: skip


def missing_share(line: LinkLine, link: Link) -> dict[str, float]:
    """For each direction that has functions: the share of its bending energy in shapes that they do not have.

    The material's moment is the projection of the balance's moment M on the functions (Galerkin), so what is missing is
    int (M - EI kappa)^2/EI over int M^2/EI, all samples together: twist, bend_y, bend_z. By it a static deflection is
    too small.
    """
    if line.shape is None or len(line.s) < 2:
        return {}
    shares, totals = {}, {}
    for k, name in enumerate(("twist", "bend_y", "bend_z")):
        if name in link.projected:
            weight = 1 / link.stiffness_at(name, line.s)
            gap = line.moment[..., k] - line.shape.elastic_moment[..., k]
            totals[name] = float(np.trapezoid(line.moment[..., k] ** 2 * weight, line.s, axis=1).sum())
            shares[name] = float(np.trapezoid(gap**2 * weight, line.s, axis=1).sum())
    whole = sum(totals.values())
    return {name: shares[name] / total for name, total in totals.items() if total > _NEGLIGIBLE * whole}


def _functions(model: Model, lines: LinkLines) -> Iterator[str]:
    """Links whose load bends them in ways that their functions do not have."""
    for line in lines.bending():
        link = model.chain.nodes[line.node].link
        for name, share in missing_share(line, link).items():
            if share > MISSING_SHARE:
                yield (
                    f"link {line.name}: {share:.1%} of its energy of {name} would be in shapes that its "
                    f"{link.functions[name]} function(s) do not have (limit {MISSING_SHARE:.0%}): take more "
                    f"functions.{name}"
                )


def _yielding(robot: Robot, time: Array, line: LinkLine) -> Iterator[str]:
    strength = yield_strength(robot, line.name)
    if line.stress is None or strength is None:
        return
    worst = line.largest("mises_stress")
    place = "" if worst is None else f", most at s = {worst.s:.2g}"
    yield from _beyond(
        time, line.stress.mises_stress.max(axis=1) / 1e6, strength / 1e6,
        f"link {line.name} is stressed beyond the yield strength of its material ({strength / 1e6:.4g} MPa{place})",
        "MPa", "the elastic model ends there; take a stronger section, or a slower move",
    )  # fmt: skip


def _buckling(model: Model, time: Array, line: LinkLine) -> Iterator[str]:
    """Axial compression against pi^2 EI/(4 L^2), a link clamped at its root and free at its tip.

    Only of such links while they are nearly straight: one whose root nothing holds, or that carries further joints, has
    another load, and one that is bent is computed as it is bent.
    """
    node, link = model.chain.nodes[line.node], model.chain.nodes[line.node].link
    free = [name for name in ("bend_y", "bend_z") if link.functions[name]]
    stiffness = [float(link.stiffness_at(name, line.s).min()) for name in free]
    if not stiffness or not _is_cantilever(model, line.node):
        return
    critical = float(np.pi**2 * min(stiffness) / (4 * line.length**2))
    straight = np.ones(len(time), bool) if line.shape is None else np.abs(line.shape.slope).max(axis=(1, 2)) < _STRAIGHT
    yield from _beyond(
        time, np.where(straight, -line.axial.min(axis=1), 0.0), critical,
        f"link {node.name} is pressed beyond its buckling load as a cantilever, pi^2 EI/(4 L^2) = {critical:.4g} N",
        "N", "the straight link is not stable there: raise EI, or press less",
    )  # fmt: skip


def _is_cantilever(model: Model, index: int) -> bool:
    """Whether a link's tip carries no joint that moves, and nothing between its root and the base is free."""
    nodes = model.chain.nodes
    if any(node.parent == index and node.joint.moves for node in nodes):
        return False
    while index >= 0:
        drives = [axis.drive for axis in nodes[index].joint.axes]
        if any(not (drive.is_driven or drive.has_gear) for drive in drives):
            return False
        index = nodes[index].parent
    return True


_STRAIGHT = 0.2
"""Largest slope of a link that counts as straight [rad]."""


def _beyond(time: Array, value: Array, bound: float, what: str, unit: str, hint: str) -> Iterator[str]:
    """A sentence where a value passes its bound."""
    past = np.flatnonzero(value > bound)
    if len(past):
        worst = int(past[np.argmax(value[past])])
        if len(time) == 1:
            yield f"{what}: {value[worst]:.4g} {unit}; {hint}"
            return
        reached = f"reaches {value[worst]:.4g} {unit} at t = {time[worst]:.4g} s"
        yield f"{what} first at t = {time[past[0]]:.4g} s and {reached}: {hint}"
