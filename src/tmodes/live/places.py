"""What a page must know to find loads along links, modes and the decomposition of deformations again."""

from __future__ import annotations

from collections.abc import Iterable
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis import vibration
from tmodes.analysis.line.line import line_places
from tmodes.analysis.modes.closed_loop import Servos, is_network, sample_pattern, servos_together
from tmodes.analysis.modes.modes import MotorState, moving_coordinates
from tmodes.analysis.modes.of_sheet import servos_of
from tmodes.analysis.modes.shapes import MOST_WHOLE
from tmodes.analysis.quasistatic import sprung
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.compliance import spring_rows
from tmodes.analysis.statics.equilibrium import Equilibrium
from tmodes.chain.chain import Chain
from tmodes.equations.line.schedule import ROOTS, Lines
from tmodes.equations.loop.plan import LoopPlan
from tmodes.equations.recursion.parts import Parts
from tmodes.errors import SimulationError
from tmodes.integrate.conditions import Band
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.drives.contract import FRICTION
from tmodes.kinds.joints.joint import Limits
from tmodes.kinds.links.line import layout
from tmodes.kinds.noted.functions import array
from tmodes.model.model import Model
from tmodes.result import settling
from tmodes.sheet import Robot
from tmodes.sheet.robot import yield_strength

__all__ = [
    "after_rules", "evenly", "joint_limits", "line_lengths", "line_names", "lines_info", "load_places",
    "vibration_numbers", "vibrations_info", "yield_strengths",
]  # fmt: skip


Array = NDArray[np.float64]

_MOST_PLACES = 101
"""Places along each link at which a page looks for the largest loads; of more a part is taken."""

_ROUNDING = 1e-15


def evenly(count: int, most: int) -> NDArray[np.intp]:
    """At most so many of ``count`` places in a row, the first and the last among them."""
    return np.unique(np.linspace(0, count - 1, min(count, most)).round().astype(np.intp))


def load_places(chain: Chain, line_points: int) -> Array:
    """Places along each link (0 root, 1 tip) at which loads are shown: those of the result, or a part of them."""
    places = line_places(chain, line_points)
    return places[evenly(len(places), _MOST_PLACES)]


def line_names(lines: Lines) -> list[str]:
    """Names of the lines of all links, those of rigid links among them."""
    return [name for name in lines.schedule.outputs if name != ROOTS]


def line_lengths(lines: Lines) -> Array:
    """Lengths [m] of the lines of the links that bend."""
    return array([line.length for link in lines.links for line in link])


def lines_info(lines: Lines, chain: Chain) -> list[dict[str, Any]]:
    """Each line of a link that bends: its name, how many numbers a place has, and where each quantity stands."""
    found = []
    for node, link in zip(chain.nodes, lines.links, strict=True):
        for line in link:
            at = {name: [part.start, part.stop] for name, part in layout(stressed=line.stressed).items()}
            width = max(stop for _, stop in at.values())
            found.append({"name": node.name + line.suffix, "width": width, "at": at})
    return found


def yield_strengths(robot: Robot, lines: Iterable[str]) -> dict[str, float]:
    """Yield strength [Pa] of the lines of bending links, by name, where it is known."""
    found = {name: yield_strength(robot, name) for name in lines}
    return {name: strength for name, strength in found.items() if strength is not None}


def joint_limits(robot: Robot, plan: LoopPlan, parts: Parts) -> list[dict[str, Any]]:
    """Limits of the joints, of which :func:`tmodes.report.facts.run_facts` gives the largest share.

    Where in coordinates and drives (-1: none) each joint is, with its units; what is not limited is None.
    """
    drives = [drive.joint for drive in plan.drives]
    sliding = plan.chain.sliding
    return [
        {
            "joint": name, "coordinate": parts.names.index(name),
            "drive": drives.index(name) if name in drives else -1,
            "unit": "m" if name in sliding else "rad", "effortUnit": "N" if name in sliding else "N m",
            "speed": joint.limits.speed, "effort": joint.limits.effort, "range": _range(joint.limits),
        }
        for joint in robot.joints
        for name in joint.coordinates
        if joint.limits and name in parts.names
    ]  # fmt: skip


def _range(limits: Limits) -> list[float] | None:
    """Middle and half width of a range; None where there is none."""
    if limits.lower is None or limits.upper is None or limits.upper <= limits.lower + _ROUNDING:
        return None
    return [(limits.upper + limits.lower) / 2, (limits.upper - limits.lower) / 2]


_CASES = (MotorState.CONTROLLED, MotorState.LOCKED, MotorState.FREE)
_DRY = (3, 4, FRICTION + 3, FRICTION + 4)
"""Where a drive's numbers tell dry friction of its motor and of its joint."""


def vibration_numbers(robot: Robot, plan: LoopPlan, model: Model) -> dict[str, Array]:
    """Numbers that hang on a sheet's: ``servos`` (k, 2) stiffness, damping, ``loads`` (n, 6), ``touch`` (4,) or (0,).

    ``model``: the chain without drives. ``touch``: mass, damping, stiffness, preload of the surface. ``loop``: numbers
    of the servos together where they are more than springs and dampers, else none.
    """
    loop = servos_together(robot, model)
    sheet = robot.contact
    stiffness, damping, preload = (sheet and sheet.spring()) or (0.0, 0.0, 0.0)
    touch = [sheet.moving_mass, damping, stiffness, preload] if sheet and sheet.spring() else []
    return {
        "servos": array([*servos_of(robot, model).values()]).reshape(-1, 2),
        "loop": loop.numbers if loop else np.zeros(0),
        "loads": array([load.wrench for load in plan.loads]).reshape(-1, 6),
        "touch": array(touch),
    }


def vibrations_info(robot: Robot, ended: Robot, plan: LoopPlan, model: Model) -> dict[str, Any]:
    """What ``ArmBundle`` of ``web/src/live/bundle.ts`` holds of them; ``model`` as the run has it.

    ``ended``: the robot held where its run ends.
    """
    point = [] if plan.touch is None else [plan.touch.point]
    modes, why = _modes(robot, ended, model)
    return {
        "loads": [{"point": load.point, "follower": load.follower, "signal": load.signal} for load in plan.loads],
        "touch": _surface(robot.contact, *point) if robot.contact and point else None,
        "yields": [*sprung(model), *model.deformations.tolist()],
        "units": [*model.chain.units(model.coordinates).values()],
        "plays": _plays(model),
        "modes": modes,
        "noModes": why,
    }  # fmt: skip


_PLAY = 12
"""Where a drive's numbers have the play of its gear, but for two numbers of each range of its stiffness."""


def _plays(model: Model) -> list[dict[str, int]]:
    """Gears with play: their joint, their place among the deformations, that of the play in the chain's numbers."""
    gears = [axis for axis in model.parts.axes if axis.axis.element]
    return [
        {"coordinate": axis.angle, "gear": k, "place": axis.drive_numbers.start + _PLAY + 2 * axis.drive.ranges}
        for k, axis in enumerate(gears)
        if axis.drive and axis.drive_numbers and axis.axis.joint.gear and axis.axis.joint.gear.backlash
    ]  # fmt: skip


def _modes(robot: Robot, ended: Robot, model: Model) -> tuple[dict[str, Any] | None, str]:
    """``ArmModes``, or why there are none."""
    if robot.contact and robot.contact.spring() is None:
        law = robot.contact.name_of_kind()
        return None, f"of the contact law `{law}`, which is no spring, modes are found natively"
    if is_network(robot):
        return None, "under blocks of `control`, and drives that sample or are late, modes are found natively alone"
    if model.nq > MOST_WHOLE:
        return None, f"of {model.nq} coordinates modes are found natively alone"
    try:
        rest = robot_rest(robot, contact=robot.contact is not None)
        servos, loop = servos_of(robot, rest.model), _loop(servos_together(robot, rest.model))
    except SimulationError as error:
        return None, str(error)
    if rest.model.coordinates != model.coordinates:
        return None, "its modes have other coordinates than its run"
    names = list(model.coordinates)
    gears, links, parallel = spring_rows(rest.model)
    aligned = dict(parallel.values())
    springs = [
        {"element": name, "rows": [k], "gear": True, "parallel": aligned.get(k, -1)} for name, k in gears.items()
    ]
    springs += [{"element": name, "rows": rows, "gear": False, "parallel": -1} for name, rows in links.items()]
    springs += [{"element": name, "rows": [k], "gear": False, "parallel": n} for name, (k, n) in parallel.items()]
    return {
        "rest": rest.q,
        "end": _end(ended),
        "free": rest.free.tolist(),
        "cases": _cases(rest, servos),
        "servos": [
            {"coordinate": names.index(name), "element": f"{name.removesuffix('.motor')}.controller"} for name in servos
        ],
        "loop": loop,
        "springs": springs,
        "dry": _dry(Model(robot.model_copy(update={"drives": ()}).chain())),
    }, ""  # fmt: skip


def _loop(servos: Servos | None) -> dict[str, Any] | None:
    """``LoopInfo`` of servos. Raises :class:`SimulationError` for sample times without a common period."""
    if servos is None:
        return None
    period, steps = sample_pattern(servos.periods) if servos.periods else (0.0, [])
    return {
        "own": servos.own, "currents": servos.currents, "start": servos.start, "rated": servos.rated,
        "sampled": [row for rows in servos.sampled for row in rows], "period": period,
        "steps": [{"length": length, "due": [row for k in due for row in servos.sampled[k]]} for length, due in steps],
    }  # fmt: skip


def _end(ended: Robot) -> Array | None:
    """Where it rests in the end; None where it does not."""
    try:
        return robot_rest(ended).q
    except SimulationError:
        return None


def _cases(rest: Equilibrium, servos: dict[str, Any]) -> list[dict[str, Any]]:
    """The coordinates that move, by what the motors do; under control only where there is a controller."""
    own = {state: servos if state is MotorState.CONTROLLED else {} for state in _CASES[0 if servos else 1 :]}
    return [
        {"name": str(state), "moving": moving_coordinates(rest, state, kept).tolist()} for state, kept in own.items()
    ]


def _dry(model: Model) -> list[int]:
    slots = [axis.drive_numbers for axis in model.parts.axes if axis.drive_numbers]
    return [slot.start + k for slot in slots for k in _DRY]


def _surface(sheet: Contact, point: int) -> dict[str, Any] | None:
    """``Surface`` of the page: a plane by its normal towards the free, or a ball by its center."""
    if sheet.spring() is None:
        return None
    drawn = sheet.shape.drawing()
    info = {"point": point, "radius": 0.0, "inside": False, "bilateral": not sheet.unilateral}
    if "radius" in drawn:
        return info | {"axis": drawn["center"], "distance": 0.0, "radius": drawn["radius"], "inside": drawn["inside"]}
    normal = np.array(drawn["normal"]) / np.linalg.norm(drawn["normal"])
    return info | {"axis": normal.tolist(), "distance": -float(normal @ np.array(drawn["position"]))}


def after_rules(robot: Robot, method: str) -> dict[str, Any]:
    """By which constants a page finds settling and vibration of a run, continued beyond its end."""
    band, own = Band.parsed(robot.integration.settling_band), _constants(settling)
    return {
        "vibration": _constants(vibration), "settling": own | band._asdict() | {"within": band.words},
        "method": settling.continuing(method), "outputStep": robot.integration.output_step,
    }  # fmt: skip


def _constants(module: ModuleType) -> dict[str, Any]:
    """Numbers and words that a module is governed by, by name."""
    names = {name.strip("_"): value for name, value in vars(module).items() if name.strip("_").isupper()}
    return {name: value for name, value in names.items() if isinstance(value, int | float | str | tuple)}
