"""A URDF's links as rigid bodies of the sheet: what each element may say, and what is impossible of it."""

from __future__ import annotations

from typing import Any

import numpy as np

from tmodes.errors import InputError
from tmodes.io.xml_file import Element
from tmodes.kinds.links.body import entries, principal_moments

__all__ = ["ImpossibleBodyError", "body_of", "says_massless"]

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
