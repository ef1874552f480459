"""A URDF's link as a rigid body of the sheet: mass, center and inertia, each held against what a real body can have."""

from __future__ import annotations

from typing import Any

from tmodes.errors import InputError
from tmodes.io.urdf_values import check_attributes, check_children, fault, number_at, only, origin_at
from tmodes.io.xml_file import Element
from tmodes.kinds.links.body import principal_moments

__all__ = ["body_of", "says_massless"]

LINK_CHILDREN = {"inertial", "visual", "collision"}
COMPONENTS = ("xx", "yy", "zz", "xy", "xz", "yz")
RULES = {
    "sign": "none is negative",
    "triangle": "the largest is at most the sum of the others (triangle inequality)",
}
"""The rules of :func:`tmodes.kinds.links.body.principal_moments` in words."""

NOTHING = 1e-12
"""Moments below this [kg*m^2] are the dust of a conversion and count as zero: the body is a point mass."""


def body_of(link: Element, name: str) -> dict[str, Any] | None:
    """The body of a link in its own frame; None where it has no mass.

    Mass [kg], center (3,) [m], inertia [kg*m^2] about the center in axes turned by ``rpy``. Raises
    :class:`tmodes.errors.InputError` for what no body can have.
    """
    which = f"link {name}"
    check_attributes(link, {"name", "type"}, which)
    check_children(link, LINK_CHILDREN, which)
    _refuse_stray(link, which)
    inertial = only(link, "inertial", which)
    if inertial is None:
        return None
    check_children(inertial, {"origin", "mass", "inertia"}, f"{which}: inertial", closed=True)
    mass = _mass(inertial, which)
    origin = origin_at(inertial, f"{which}: inertial")
    inertia = _inertia(inertial, mass, which)
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
    return mass if mass is not None and number_at(mass, "value", "mass", 1.0) == 0.0 else None


def _refuse_stray(link: Element, which: str) -> None:
    """A mass next to the inertial would be lost without a word."""
    for tag in ("mass", "inertia"):
        if stray := link.first(tag):
            hint = f"put <{tag}> inside <inertial>"
            raise fault(stray, which, f"<{tag}> outside of <inertial>", "mass and inertia inside <inertial>", hint)


def _mass(inertial: Element, which: str) -> float:
    element = only(inertial, "mass", which)
    if element is None:
        hint = 'add <mass value="..."/> in kg'
        raise fault(inertial, f"{which}: mass", "<inertial> without <mass>", "a mass [kg]", hint)
    check_attributes(element, {"value"}, f"{which}: mass")
    mass = number_at(element, "value", f"{which}: mass")
    if mass < 0.0:
        hint = "correct the sign, or remove <inertial> from a link that is only a frame"
        raise fault(element, f"{which}: mass", f"{mass:g}", "a mass greater than 0 [kg]", hint)
    return mass


def _inertia(inertial: Element, mass: float, which: str) -> dict[str, float]:
    """The six components; empty for a point mass, all of whose moments are nothing."""
    element = only(inertial, "inertia", which)
    if element is None:
        hint = "add the six moments, all zero for a point mass"
        raise fault(inertial, f"{which}: inertia", "<inertial> without <inertia>", "<inertia ixx=... izz=...>", hint)
    check_attributes(element, {f"i{pair}" for pair in COMPONENTS}, f"{which}: inertia")
    values = {pair: number_at(element, f"i{pair}", f"{which}: inertia i{pair}") for pair in COMPONENTS}
    if max(map(abs, values.values())) < NOTHING:
        return {}
    if mass == 0.0:
        hint = "give the mass, or remove <inertial> from a link that is only a frame"
        got, expected = "0 with moments of inertia", "a mass greater than 0 [kg]"
        raise fault(inertial.first("mass") or inertial, f"{which}: mass", got, expected, hint)
    if broken := _broken_rule(values):
        raise _unphysical(element, which, *broken)
    return values


def _broken_rule(values: dict[str, float]) -> tuple[str, str] | None:
    """The rule that principal moments break, and the moments in words; None for those of a real body."""
    xx, yy, zz, xy, xz, yz = (values[pair] for pair in COMPONENTS)
    (low, middle, high), broken = principal_moments([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    words = f"principal moments {low:.6g}, {middle:.6g} and {high:.6g}"
    return (RULES[broken], words) if broken else None


def _unphysical(element: Element, which: str, rule: str, words: str) -> InputError:
    hint = "check the unit, the signs and that it is about the center of mass; a plate's own is Ixx + Iyy = Izz"
    return fault(element, f"{which}: inertia", words, f"moments of a rigid body: {rule}", hint)
