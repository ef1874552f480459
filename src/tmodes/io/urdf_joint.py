"""A URDF's joint as a joint of the sheet: placement, axis, limits and friction."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.errors import InputError
from tmodes.io.scalars import finite_float
from tmodes.io.urdf_tree import UrdfJoint
from tmodes.io.urdf_values import (
    check_attributes,
    check_children,
    fault,
    number_at,
    only,
    origin_at,
    text_at,
    triple_at,
)
from tmodes.io.words import meant, shown
from tmodes.io.xml_file import Element

__all__ = ["MOVING", "Follows", "follows", "joint_ends", "joint_of"]

KINDS = {"revolute": "revolute", "continuous": "revolute", "prismatic": "prismatic", "fixed": "fixed"}
"""What each type of a URDF's joint is in the sheet."""

MOVING = frozenset(KINDS) - {"fixed"}
CHILDREN = {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic", "calibration", "safety_controller"}
BOUNDLESS = 1e9
"""A limit beyond this [rad or m] says that there is none."""


@dataclass(frozen=True)
class Follows:
    """What ``<mimic>`` says: position = ``factor`` * position of ``leader`` + ``offset``."""

    leader: str
    factor: float
    offset: float


def joint_ends(element: Element) -> UrdfJoint:
    """A joint's name, kind and links; raises :class:`tmodes.errors.InputError` for a kind that is not modelled."""
    name = text_at(element, "name", "a joint's name")
    which = f"joint {name}"
    check_attributes(element, {"name", "type"}, which)
    check_children(element, CHILDREN, which)
    kind = text_at(element, "type", f"{which}: type")
    if kind not in KINDS:
        raise _other_kind(element, which, kind)
    return UrdfJoint(name, kind, _end(element, "parent", which), _end(element, "child", which), element)


def joint_of(joint: UrdfJoint) -> dict[str, Any]:
    """The joint of the sheet; its origin is in the parent link's frame, as a URDF means it."""
    which = f"joint {joint.name}"
    data: dict[str, Any] = {"name": joint.name, "type": KINDS[joint.type], "parent": joint.parent, "child": joint.child}
    data |= {"origin": origin_at(joint.element, which), "from": "frame"}
    if joint.type == "fixed":
        return data
    data["axis"] = _axis(joint.element, which)
    if limits := _limits(joint, which):
        data["limits"] = limits
    if friction := _friction(joint.element, which):
        data["friction"] = friction
    return data


def follows(joint: UrdfJoint) -> Follows | None:
    """The joint that this one mimics, None where it moves by itself."""
    which = f"joint {joint.name}: mimic"
    element = only(joint.element, "mimic", which)
    if element is None or joint.type == "fixed":
        return None
    check_attributes(element, {"joint", "multiplier", "offset"}, which)
    factor = number_at(element, "multiplier", f"{which} multiplier", 1.0)
    return Follows(text_at(element, "joint", which), factor, number_at(element, "offset", f"{which} offset", 0.0))


def _other_kind(element: Element, which: str, kind: str) -> InputError:
    known = ", ".join(KINDS)
    if kind == "floating":
        hint = "fix the base to the world: make the joint fixed, or remove it with its parent"
        return fault(element, f"{which}: type", "a floating joint (a free-flying base)", f"one of {known}", hint)
    if kind == "planar":
        hint = "write it as two prismatic joints and a revolute one"
        return fault(element, f"{which}: type", "a planar joint", f"one of {known}", hint)
    hint = meant(kind, KINDS, "choose one of them")
    return fault(element, f"{which}: type", shown(kind), f"one of {known}", hint)


def _end(element: Element, tag: str, which: str) -> str:
    end = only(element, tag, which)
    if end is None:
        raise fault(element, which, f"no <{tag}>", "a joint with a parent and a child link", f'add <{tag} link="..."/>')
    return text_at(end, "link", f"{which}: {tag}")


def _axis(element: Element, which: str) -> list[float]:
    """The axis as written; along x where the file says nothing, which is the format's own rule."""
    axis = only(element, "axis", which)
    if axis is None:
        return [1.0, 0.0, 0.0]
    check_attributes(axis, {"xyz"}, f"{which}: axis")
    text_at(axis, "xyz", f"{which}: axis")
    numbers = triple_at(axis, "xyz", f"{which}: axis")
    if max(map(abs, numbers)) < 1e-9:
        raise fault(axis, f"{which}: axis", "a zero axis", "a direction", 'write its direction, such as "0 0 1"')
    return numbers


def _limits(joint: UrdfJoint, which: str) -> dict[str, float]:
    """Those limits that the file states; zero speed or effort is how many files say "not known"."""
    element = only(joint.element, "limit", which)
    if element is None:
        return {}
    check_attributes(element, {"lower", "upper", "effort", "velocity"}, f"{which}: limit")
    limits: dict[str, float] = {} if joint.type == "continuous" else _range(element, which)
    for key, name in (("speed", "velocity"), ("effort", "effort")):
        value = _limit(element, name, which)
        if value < 0.0:
            raise fault(element, f"{which}: {name}", f"{value:g}", "a limit not less than 0", "correct the sign")
        if 0.0 < value <= BOUNDLESS:
            limits[key] = value
    return limits


def _range(element: Element, which: str) -> dict[str, float]:
    """Lower and upper limit; one that is missing next to the other is zero, which is the format's own rule."""
    if not element.attributes.keys() & {"lower", "upper"}:
        return {}
    lower, upper = (_limit(element, name, which) for name in ("lower", "upper"))
    if lower > upper:
        got, hint = f"lower {lower:g} above upper {upper:g}", "exchange them, or correct a sign"
        raise fault(element, f"{which}: limit", got, "a range from lower to upper", hint)
    return {name: value for name, value in (("lower", lower), ("upper", upper)) if abs(value) <= BOUNDLESS}


def _limit(element: Element, name: str, which: str) -> float:
    """A limit's number. Infinite and huge ones are written in many ways, and all mean that there is none."""
    text = element.attributes.get(name, "0").strip()
    value = finite_float(text)
    if value is None and text.lower().lstrip("+-") in {"inf", "infinity"}:
        value = float(text)
    return number_at(element, name, f"{which}: {name}") if value is None else value


def _friction(element: Element, which: str) -> dict[str, float]:
    dynamics = only(element, "dynamics", which)
    if dynamics is None:
        return {}
    check_attributes(dynamics, {"damping", "friction"}, f"{which}: dynamics")
    friction = {"viscous": "damping", "coulomb": "friction"}
    values = {key: number_at(dynamics, name, f"{which}: {name}", 0.0) for key, name in friction.items()}
    if values["coulomb"] < 0.0:
        hint = "correct the sign: a negative one would drive the joint"
        raise fault(dynamics, f"{which}: friction", f"{values['coulomb']:g}", "a number not less than 0", hint)
    return values if any(values.values()) else {}
