"""Where a run leaves what its model or its material are good for: reported in the result."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.line.line import LinkLine, LinkLines
from tmodes.kinds.links.contract import Link
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["missing_share", "rest_warnings", "run_warnings", "yield_strength"]


Array = NDArray[np.float64]

MISSING_SHARE = 0.01

"""Share of a link's bending energy in shapes that its functions do not have, from which more are advised."""

_NEGLIGIBLE = 1e-4

"""Share of a link's energy below which a direction does not count."""


def run_warnings(robot: Robot, model: Model, times: ArrayLike, q: ArrayLike, lines: LinkLines) -> list[str]:
    """Sentences on the links in a run at n times [s]; each says what, when first, how far, and what to do.

    ``q`` (n, nq); ``lines`` of the same samples, under the same wrenches.
    """
    time, q = (np.asarray(x, dtype=float) for x in (times, q))
    return [*_range(model, time, q), *_of_lines(robot, model, time, lines)]


def rest_warnings(robot: Robot, model: Model, lines: LinkLines) -> list[str]:
    """Sentences on an arm at rest: functions that are missing, material that yields, links pressed too hard.

    ``lines``: of the one pose, under its loads.
    """
    return [*_of_lines(robot, model, np.zeros(1), lines)]


def _of_lines(robot: Robot, model: Model, time: Array, lines: LinkLines) -> Iterator[str]:
    yield from _functions(model, lines)
    for line in lines.bending():
        yield from _yielding(robot, time, line)
        yield from _buckling(model, time, line)


def _range(model: Model, time: Array, q: Array) -> Iterator[str]:
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


def yield_strength(robot: Robot, name: str) -> float | None:
    """Least yield strength [Pa] of a link's materials, None where unknown. Segments bear their link's name."""
    names = {link.name for link in robot.links}
    beam = robot.link(name if name in names else name.rpartition(".")[0]).beam if robot.links else None
    if beam is None:
        return None
    return min(beam.yield_strengths, default=None)


def _buckling(model: Model, time: Array, line: LinkLine) -> Iterator[str]:
    """Axial compression against pi^2 EI/(4 L^2), a link clamped at its root and free at its tip."""
    link = model.chain.nodes[line.node].link
    free = [name for name in ("bend_y", "bend_z") if link.functions[name]]
    stiffness = [float(link.stiffness_at(name, line.s).min()) for name in free]
    if not stiffness:
        return
    critical = float(np.pi**2 * min(stiffness) / (4 * line.length**2))
    yield from _beyond(
        time, -line.axial.min(axis=1), critical,
        f"link {line.name} is pressed beyond its buckling load pi^2 EI/(4 L^2) = {critical:.4g} N", "N",
        "it may buckle: shorten it, stiffen it, or press less",
    )  # fmt: skip


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
