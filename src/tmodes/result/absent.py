"""Kinds that a stored result names and that are not registered here: it opens all the same, with a notice."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from tmodes.equations.lagrange.registry import SYSTEMS
from tmodes.integrate.registry import AUTO, INTEGRATORS
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES
from tmodes.kinds.controllers.registry import CONTROLLERS
from tmodes.kinds.drives.registry import DRIVES
from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.links.registry import LINKS
from tmodes.kinds.registry import Registry, UnknownKindError
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.sheet.robot import RECURSION

__all__ = ["absent_kinds"]

_HINT = "register it before: tmodes --use FILE ..., or import the script that defines it"

_PLACES: dict[str, Registry[Any]] = {
    "joints.*.type": JOINTS,
    "joints.*.drive": DRIVES,
    "links.*.beam.model": LINKS,
    "drives.*.controller.type": CONTROLLERS,
    "drives.*.signal.type": SIGNALS,
    "drives.*.signal.signals.*.type": SIGNALS,
    "drives.*.noise.type": SIGNALS,
    "loads.*.signal.type": SIGNALS,
    "base_motion.*.type": SIGNALS,
    "contact.law": CONTACTS,
    "contact.shape.type": SURFACES,
    "integration.method": INTEGRATORS,
    "equations": SYSTEMS,
}
"""Where a data sheet names kinds, and of which family; ``*``: any item or name."""

_OURS = {"", AUTO, RECURSION}


def absent_kinds(sheet: Mapping[str, Any]) -> list[UnknownKindError]:
    """The kinds that the plain data of a robot name and that are not registered, as the errors of using them."""
    found: dict[str, UnknownKindError] = {}
    for path, registry in _PLACES.items():
        for name in _values(sheet, path.split(".")):
            if isinstance(name, str) and name not in registry and name not in _OURS:
                which = f"the {registry.noun} kind of this result" if registry is not SYSTEMS else "equations"
                found[f"{path} {name}"] = UnknownKindError(which, f"`{name}`", "one that is registered here", _HINT)
    return [*found.values()]


def _values(data: Any, steps: Sequence[str]) -> Iterator[Any]:
    if not steps:
        yield data
        return
    inner: Any = ()
    if steps[0] == "*":
        inner = data.values() if isinstance(data, Mapping) else data if isinstance(data, list) else ()
    elif isinstance(data, Mapping) and steps[0] in data:
        inner = (data[steps[0]],)
    for one in inner:
        yield from _values(one, steps[1:])
