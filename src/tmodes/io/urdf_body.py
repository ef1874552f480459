"""A URDF's links as rigid bodies of the sheet, and impossible inertias made possible."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.io.xml_file import Element
from tmodes.kinds.links.body import entries, principal_moments, raised_inertia
from tmodes.kinds.schema.axes import cross_matrix, rotation_about, rpy_matrix

__all__ = ["ImpossibleBodyError", "Mover", "body_of", "inertia_of", "says_massless"]

Array = NDArray[np.float64]

POSES = 20
MOST_JOINTS = 60
"""Moving joints beyond which the change of frequencies is not computed."""

FADES = 1e-3
"""Weight of the axis of a joint over that of the next one towards the link."""


def inertia_of(body: Mapping[str, Any]) -> Array:
    """The inertia (3, 3) of a body of the sheet about its center, in its link's axes."""
    pairs = body.get("inertia") or dict.fromkeys(("xx", "yy", "zz", "xy", "xz", "yz"), 0.0)
    xx, yy, zz, xy, xz, yz = (pairs[pair] for pair in ("xx", "yy", "zz", "xy", "xz", "yz"))
    turn = rpy_matrix(*body.get("rpy", (0.0, 0.0, 0.0)))
    return turn @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ turn.T


@dataclass(frozen=True, eq=False)
class Mover:
    """The rigid tree of a URDF: its ``joints`` as of the sheet, parents first."""

    joints: Sequence[Mapping[str, Any]]

    def repaired(self, link: str, body: Mapping[str, Any]) -> dict[str, Any]:
        """A body with the inertia of a real one, in its link's axes."""
        return {**body, "rpy": [0.0, 0.0, 0.0], "inertia": entries(raised_inertia(inertia_of(body), self._uses(link)))}

    def _uses(self, link: str) -> Array:
        """Axes (k, 3) of the joints that turn a link in its own axes at the zero pose, the nearer the longer."""
        carriers = {joint["child"]: joint for joint in self.joints}
        uses, turn, weight = [], np.eye(3), 1.0
        while link in carriers:
            joint = carriers[link]
            if joint["type"] == "revolute":
                uses.append(weight * turn.T @ _unit(joint["axis"]))
                weight *= FADES
            turn, link = rpy_matrix(*joint["origin"]["rpy"]) @ turn, joint["parent"]
        return np.array(uses).reshape(-1, 3)

    def largest_fall(self, bodies: Mapping[str, Mapping[str, Any]], link: str, added: Array) -> float | None:
        """The share by which an ``added`` inertia (3, 3) of a link lowers a natural frequency at most; None: unknown.

        ``bodies``: of all links, that one's repaired.
        """
        count = sum(joint["type"] != "fixed" for joint in self.joints)
        if not 0 < count <= MOST_JOINTS:
            return None
        rng, largest = np.random.default_rng(0), 0.0
        for _ in range(POSES):
            mass, turning = np.zeros((count, count)), np.zeros((3, count))
            for name, (turn, angular, linear) in self._moved(rng.uniform(-1, 1, count), count).items():
                body = bodies.get(name)
                if body is None:
                    continue
                own = turn.T @ angular
                center = linear - cross_matrix(turn @ np.array(body["center"])) @ angular
                mass += body["mass"] * center.T @ center + own.T @ inertia_of(body) @ own
                turning = own if name == link else turning
            try:
                from scipy.linalg import eigh

                share = eigh(turning.T @ added @ turning, mass, eigvals_only=True)[-1]
            except np.linalg.LinAlgError:
                return None
            largest = max(largest, float(share))
        return 1.0 - float(np.sqrt(max(0.0, 1.0 - largest)))

    def _moved(self, position: Array, count: int) -> dict[str, tuple[Array, Array, Array]]:
        """Of each link its rotation, and the jacobians (3, count) of its turn and of its origin."""
        still = np.eye(3), np.zeros((3, count)), np.zeros((3, count))
        found: dict[str, tuple[Array, Array, Array]] = {}
        k = 0
        for joint in self.joints:
            turn, angular, linear = found.get(joint["parent"], still)
            arm = turn @ np.array(joint["origin"]["position"])
            linear = linear - cross_matrix(arm) @ angular
            turn, angular = turn @ rpy_matrix(*joint["origin"]["rpy"]), angular.copy()
            if joint["type"] != "fixed":
                axis = turn @ _unit(joint["axis"])
                if joint["type"] == "revolute":
                    angular[:, k] = axis
                    turn = turn @ rotation_about(_unit(joint["axis"]), np.pi * position[k])
                else:
                    linear = linear - cross_matrix(axis * position[k]) @ angular
                    linear[:, k] = axis
                k += 1
            found[joint["child"]] = turn, angular, linear
        return found


def _unit(axis: Sequence[float]) -> Array:
    return np.array(axis) / np.linalg.norm(axis)


LINK_CHILDREN = {"inertial", "visual", "collision"}
COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")


class ImpossibleBodyError(InputError):
    """A mass or an inertia that no body has; the body as it ``stands``, None where its mass is the fault."""

    stands: dict[str, Any] | None = None

    @classmethod
    def of(cls, error: InputError, stands: dict[str, Any] | None) -> ImpossibleBodyError:
        """The error with what stands in the file."""
        made = cls(error.which, error.got, error.expected, error.hint, error.where)
        made.stands = stands
        return made


RULES = {"sign": "none is negative", "triangle": "the largest is at most the sum of the others (triangle inequality)"}
"""The rules of :func:`tmodes.kinds.links.body.principal_moments` in words."""

NOTHING = 1e-12
"""Moments below this [kg*m^2] are the dust of a conversion and count as zero: the body is a point mass."""


def body_of(link: Element, name: str) -> dict[str, Any] | None:
    """The body of a link in its own frame; None where it has no mass.

    Mass [kg], center (3,) [m], inertia [kg*m^2] about the center in axes turned by ``rpy``. Raises
    :class:`tmodes.errors.InputError` for what no body can have.
    """
    which = f"link {name}"
    link.check_attributes({"name", "type"}, which)
    link.check_children(LINK_CHILDREN, which)
    for stray in (one for one in link.children if one.tag in {"mass", "inertia"}):  # it would be lost without a word
        got, hint = f"<{stray.tag}> outside of <inertial>", f"put <{stray.tag}> inside <inertial>"
        raise stray.fault(which, got, "mass and inertia inside <inertial>", hint)
    inertial = link.only("inertial", which)
    if inertial is None:
        return None
    inertial.check_children({"origin", "mass", "inertia"}, f"{which}: inertial", closed=True)
    mass = _mass(inertial, which)
    origin = inertial.origin(f"{which}: inertial")
    try:
        return _body(name, mass, origin, _inertia(inertial, mass, which))
    except ImpossibleBodyError as error:
        error.stands = _body(name, mass, origin, error.stands or {})
        raise


def _body(name: str, mass: float, origin: dict[str, Any], inertia: dict[str, float]) -> dict[str, Any] | None:
    if mass == 0.0:
        return None
    body: dict[str, Any] = {"name": name, "mass": mass, "center": origin["position"]}
    if inertia:
        body["inertia"] = inertia
    if inertia and any(origin["rpy"]):
        body["rpy"] = origin["rpy"]
    return body


def says_massless(link: Element) -> Element | None:
    """The ``<mass value="0">`` that a link states; None where it states another, or none at all."""
    inertial = link.first("inertial")
    mass = inertial.first("mass") if inertial else None
    return mass if mass is not None and mass.number("value", "mass", 1.0) == 0.0 else None


def _mass(inertial: Element, which: str) -> float:
    element = inertial.only("mass", which, {"value"})
    if element is None:
        hint = 'add <mass value="..."/> in kg'
        raise inertial.fault(f"{which}: mass", "<inertial> without <mass>", "a mass [kg]", hint)
    mass = element.number("value", f"{which}: mass")
    if mass < 0.0:
        hint = "correct the sign, or remove <inertial> from a link that is only a frame"
        raise ImpossibleBodyError.of(
            element.fault(f"{which}: mass", f"{mass:g}", "a mass greater than 0 [kg]", hint), None
        )
    return mass


def _inertia(inertial: Element, mass: float, which: str) -> dict[str, float]:
    """The six components; empty for a point mass, all of whose moments are nothing."""
    element = inertial.only("inertia", which, {f"i{pair}" for pair in COMPONENTS})
    if element is None:
        hint = "add the six moments, all zero for a point mass"
        raise inertial.fault(f"{which}: inertia", "<inertial> without <inertia>", "<inertia ixx=... izz=...>", hint)
    values = {pair: element.number(f"i{pair}", f"{which}: inertia i{pair}") for pair in COMPONENTS}
    if max(map(abs, values.values())) < NOTHING:
        return {}
    if mass == 0.0:
        hint = "give the mass, or remove <inertial> from a link that is only a frame"
        stated = inertial.first("mass") or inertial
        fault = stated.fault(f"{which}: mass", "0 with moments of inertia", "a mass greater than 0 [kg]", hint)
        raise ImpossibleBodyError.of(fault, None)
    xx, yy, zz, xy, xz, yz = values.values()
    matrix = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    (low, middle, high), broken = principal_moments(matrix)
    if broken:
        got = f"principal moments {low:.6g}, {middle:.6g} and {high:.6g}"
        hint = "check the unit, the signs and that it is about the center of mass; a plate's own is Ixx + Iyy = Izz"
        fault = element.fault(f"{which}: inertia", got, f"moments of a rigid body: {RULES[broken]}", hint)
        raise ImpossibleBodyError.of(fault, entries(matrix))
    return values
