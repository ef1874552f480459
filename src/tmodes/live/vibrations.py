"""What a page needs to find modes and the decomposition of deformations again: places, and numbers that change."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.modes import MotorState, moving_coordinates
from tmodes.analysis.modes.of_sheet import local_servos
from tmodes.analysis.modes.shapes import MOST_WHOLE
from tmodes.analysis.quasistatic import gross_motion, sprung
from tmodes.analysis.statics.compliance import spring_rows
from tmodes.analysis.statics.equilibrium import Equilibrium, robot_rest
from tmodes.equations.loop.plan import LoopPlan
from tmodes.errors import SimulationError
from tmodes.kinds.contacts.registry import Contact
from tmodes.kinds.drives.contract import FRICTION
from tmodes.model.model import Model
from tmodes.sheet import Robot

__all__ = ["vibration_numbers", "vibrations_info"]

Array = NDArray[np.float64]

_CASES = (MotorState.CONTROLLED, MotorState.LOCKED, MotorState.FREE)
_DRY = (3, 4, FRICTION + 3, FRICTION + 4)
"""Where a drive's numbers tell dry friction of its motor and of its joint."""


def vibration_numbers(arm: Robot, plan: LoopPlan, model: Model) -> dict[str, Array]:
    """Numbers that hang on a sheet's: ``servos`` (k, 2) stiffness, damping, ``loads`` (n, 6), ``touch`` (4,) or (0,).

    ``model``: the chain without drives. ``touch``: mass, damping, stiffness, preload of the surface.
    """
    sheet = arm.contact
    stiffness, damping, preload = (sheet and sheet.spring()) or (0.0, 0.0, 0.0)
    touch = [sheet.moving_mass, damping, stiffness, preload] if sheet and sheet.spring() else []
    return {
        "servos": np.array([*local_servos(arm, model).values()], dtype=float).reshape(-1, 2),
        "loads": np.array([load.wrench for load in plan.loads], dtype=float).reshape(-1, 6),
        "touch": np.array(touch, dtype=float),
    }


def vibrations_info(arm: Robot, plan: LoopPlan, model: Model) -> dict[str, Any]:
    """What ``ArmBundle`` of ``web/src/live/bundle.ts`` holds of them; ``model`` as the run has it."""
    point = [] if plan.touch is None else [plan.touch.point]
    modes, why = _modes(arm, model)
    return {
        "loads": [{"point": load.point, "follower": load.follower, "signal": load.signal} for load in plan.loads],
        "touch": _surface(arm.contact, *point) if arm.contact and point else None,
        "split": {
            "free": [*sprung(model), *model.deformations.tolist()],
            "gross": np.ascontiguousarray(gross_motion(model, np.eye(model.nq)).T), "weight": model.at_rest(),
        },
        "modes": modes,
        "noModes": why,
    }  # fmt: skip


def _modes(arm: Robot, model: Model) -> tuple[dict[str, Any] | None, str]:
    """``ArmModes``, or why there are none."""
    if arm.contact and arm.contact.spring() is None:
        return None, f"of the contact law `{arm.contact.name_of_kind()}`, which is no spring, modes are found natively"
    if model.nq > MOST_WHOLE:
        return None, f"of {model.nq} coordinates modes are found natively alone"
    try:
        rest = robot_rest(arm, contact=arm.contact is not None)
    except SimulationError as error:
        return None, str(error)
    if rest.model.coordinates != model.coordinates:
        return None, "its modes have other coordinates than its run"
    servos = local_servos(arm, rest.model)
    names = list(model.coordinates)
    gears, links = spring_rows(rest.model)
    springs = [{"element": name, "rows": [angle], "gear": True} for name, angle in gears.items()]
    springs += [{"element": name, "rows": rows, "gear": False} for name, rows in links.items()]
    return {
        "rest": rest.q,
        "free": rest.free.tolist(),
        "weight": rest.model.at_rest(),
        "cases": _cases(rest, servos),
        "servos": [
            {"coordinate": names.index(name), "element": f"{name.removesuffix('.motor')}.controller"} for name in servos
        ],
        "springs": springs,
        "dry": _dry(Model(arm.model_copy(update={"drives": ()}).chain())),
    }, ""  # fmt: skip


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
