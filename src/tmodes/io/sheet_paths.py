"""Change the plain data of a robot by dotted path: ``joints.shoulder.gear.stiffness``, ``links.0.beam.length``.

Items of a list go by their name (drives by their joint, loads by their point), or by their number where none has that
name. An ending of a path that only one place has is a path too: ``gear.stiffness`` of a robot with one gear.
"""

from __future__ import annotations

import copy
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from difflib import get_close_matches
from typing import Any, NamedTuple, get_args, get_origin

from tmodes.errors import InputError
from tmodes.io.arguments import copied
from tmodes.io.forms import ROBOT, form_of, own_path, robot_path, with_reach
from tmodes.io.sheet_fields import ChainPlace, Step, chosen, inside, keys, named, quantities, root_of
from tmodes.io.sheet_words import at
from tmodes.io.words import nearest, plain, shown
from tmodes.kinds.links.material import LIBRARY

__all__ = ["changed_places", "entered", "expanded", "steps_of"]

LONGEST = 500
MOST_LISTED = 20
"""Keys or names listed in one message: of more the nearest ones."""


def changed_places(data: Mapping[str, Any], changes: Mapping[str, Any]) -> tuple[dict[str, Any], list[str]]:
    """A copy of plain data with changed values by path, and where each change stands, by keys and numbers alone.

    Every key that a data sheet may hold can be set, also one that this one leaves out; the values are checked
    elsewhere. InputError with the nearest name for a path that does not exist. A path is looked up in what the changes
    before it have left: one may give a signal its type, the next a number that only this type has.
    """
    if not isinstance(changes, Mapping):
        got, hint = shown(changes), 'write {"payload.mass": 0.8}'
        raise InputError("changes", got, "a group of paths and their values", hint)
    changed = copy.deepcopy(dict(data))
    places = []
    for path, value in changes.items():
        if path == "contact" and isinstance(value, bool) and form_of(changed) is ROBOT:
            _switch_contact(changed, value)
            continue
        *groups, key = steps = steps_of(path, changed)
        inner = entered(changed, groups, path)
        if not isinstance(inner, (dict, list)):
            raise InputError(path, f"{shown(inner)} around it", "a group", "correct the group first")
        inner[key] = _plain_value(value, path)  # pyright: ignore[reportCallIssue, reportArgumentType]
        places.append(".".join(map(str, steps)))
    return with_reach(data, changed), places


def _plain_value(value: Any, path: str) -> Any:
    """A copy of a value; arrays and numbers of NumPy become lists and numbers."""
    listed = getattr(value, "tolist", None)
    return listed() if listed and not isinstance(value, type) else copied(value, path)


def _switch_contact(data: dict[str, Any], on: bool) -> None:
    """Switch a contact on or off; its numbers stay in the sheet."""
    here, there = ("contact", "contact_off") if on else ("contact_off", "contact")
    if there in data and data.get(here) is None:
        data[here] = data.pop(there)
    if on and data.get("contact") is None:
        hint = "add the group `contact` to the sheet"
        raise InputError("contact", "a switch, of a robot that touches nothing", "left out", hint)


def entered(data: Any, steps: Sequence[Step], path: str) -> Any:
    """What stands at steps of plain data. Groups that are left out are added; a material's name gives its numbers."""
    inner = data
    for step in steps:
        value = expanded(at(inner, step), [step])
        if value is None:
            value = {}
        if not isinstance(inner, (dict, list)):
            raise InputError(path, f"{shown(inner)} around it", "a group", "correct the group first")
        inner[step] = value  # pyright: ignore[reportCallIssue, reportArgumentType]
        inner = value
    return inner


def steps_of(path: str, data: Any) -> list[Step]:
    """The keys and numbers that lead to a path, or to the only place whose path ends so.

    InputError with the nearest name when nothing may stand there, with all paths where several end so.
    """
    if not isinstance(path, str) or not 0 < len(path) <= LONGEST:
        expected, hint = "the path of a value of the data sheet", "write it like payload.mass"
        raise InputError(shown(path), "an unknown path", expected, hint)
    words = robot_path(path, data).split(".")
    here = _Node(data, root_of(data), ())
    last, rest = _led(here, words, data)
    if not rest:
        return list(last.steps)
    nodes = [*_nodes(here, data)]
    ends = [end for node in nodes if (end := _ending(node, words, data))]
    ends = ends or [end for node in nodes if (end := _left_out(node, words, data))]
    if len(ends) == 1:
        return list(ends[0])
    if ends:
        known = [own_path(named(steps, data), data) for steps in ends[:MOST_LISTED]]
        more = f", {len(ends) - len(known)} more" if len(ends) > len(known) else ""
        got = f"the ending of {len(ends)} paths"
        raise InputError(path, got, f"one of {', '.join(known)}{more}", "write more of the path")
    used = _step(last.value, rest, last.place)[1]
    raise _unknown(path, last.steps, (".".join(rest[:used]), *rest[used:]), last.value, last.place, data)


class _Node(NamedTuple):
    """What stands at a place of plain data, and the steps that lead there."""

    value: Any
    place: ChainPlace | None
    steps: tuple[Step, ...]


def _led(node: _Node, words: list[str], data: Any) -> tuple[_Node, list[str]]:
    """How far words lead from a node, and those that lead nowhere from there."""
    while words:
        step, used = _step(node.value, words, node.place)
        group, steps = expanded(node.value, node.steps), (*node.steps, step)
        inner = inside(node.place, step, group, steps, data) if node.place else None
        if inner is None:
            break
        node, words = _Node(at(group, step), inner, steps), words[used:]
    return node, words


def _nodes(node: _Node, data: Any) -> Iterator[_Node]:
    """All groups and lists inside of a node, whatever they are called by."""
    items = node.value.items() if isinstance(node.value, Mapping) else ()
    items = enumerate(node.value) if isinstance(node.value, (list, tuple)) else items
    for step, value in items:
        if isinstance(value, (Mapping, list, tuple)) and node.place and (node.steps or step != "real"):
            steps = (*node.steps, step)
            inner = inside(node.place, step, node.value, steps, data)
            if inner is not None:
                yield (found := _Node(value, inner, steps))
                yield from _nodes(found, data)


def _ending(node: _Node, words: list[str], data: Any) -> tuple[Step, ...]:
    """The steps of what stands, or may stand in a group that is there, where words lead from a node; else empty."""
    value = node.value
    if isinstance(value, Mapping):
        begins = words[0] in value
    else:  # by its number an item could be that of any list
        begins = not words[0].isdecimal() and any(
            words[0] == name.partition(".")[0] for name in filter(None, _names(value))
        )
    if not begins:
        return ()
    found, rest = _led(node, words, data)
    group = at(value, *found.steps[len(node.steps) : -1]) if len(words) > 1 else None
    return found.steps if not rest and (found.value is not None or isinstance(group, Mapping)) else ()


def _left_out(node: _Node, words: list[str], data: Any) -> tuple[Step, ...]:
    """The steps of what may stand in a group that is left out, where words lead from a node; else empty."""
    known = keys(chosen(node.place, node.value)) if node.place and isinstance(node.value, Mapping) else ()
    found, rest = _led(node, words, data) if len(words) > 1 and words[0] in known else (node, words)
    return () if rest else found.steps


def expanded(value: Any, steps: Sequence[Step]) -> Any:
    """The numbers of a material that is given by name."""
    if isinstance(value, str) and steps and steps[-1] == "material" and value in LIBRARY:
        return LIBRARY[value].model_dump(mode="json", exclude_none=True)
    return value


_NAMING = ("name", "joint", "point")
"""Keys by which an item of a list is known: a drive is that of its joint, a load that on its point."""


def _names(items: Sequence[Any]) -> list[Any]:
    """The name of each item of a list; None for one that has none, or one that another has too."""
    names = [
        next((item[key] for key in _NAMING if key in item), None) if isinstance(item, Mapping) else None
        for item in items
    ]
    counts = Counter(name for name in names if isinstance(name, str))
    return [name if isinstance(name, str) and counts[name] == 1 else None for name in names]


def _step(value: Any, words: list[str], place: ChainPlace | None) -> tuple[Step, int]:
    """The next step, and how many words it takes: a name may hold dots itself."""
    if isinstance(value, (list, tuple)):
        plain = bool(value) and isinstance(value[0], (int, float))  # as the samples of a signal, which may be many
        names = [] if plain else _names(value)
        for count in range(len(words), 0, -1):
            if (name := ".".join(words[:count])) in names:
                return names.index(name), count
        if words[0].isdecimal() and len(words[0]) < 6 and int(words[0]) < len(value):
            return int(words[0]), 1
        return words[0], 1
    kinds = get_args(chosen(place, value)) if place is not None and place.unit is not None else ()
    if kinds and get_origin(kinds[-1]) is not dict:
        return ".".join(words), len(words)  # an entry of `real`, or of the initial state
    there = value if isinstance(value, Mapping) else {}  # such as the references of `shoulder.motor`
    count = next((count for count in range(len(words), 1, -1) if ".".join(words[:count]) in there), 1)
    return ".".join(words[:count]), count


def _unknown(
    path: str, before: Sequence[Step], words: Sequence[str], value: Any, place: ChainPlace | None, data: Any
) -> InputError:
    """The error for a step that leads nowhere, the first of ``words``; ``before`` are those that led to ``value``."""
    where, *beyond = words
    if isinstance(value, (list, tuple)):
        known = [str(name or k) for k, name in enumerate(_names(value))]
        look = "give the name of an item, or its number from 0"
    else:
        known = keys(chosen(place, value)) if place else []
        look = "choose one of these keys" if known else "leave out what follows it"
    start = own_path(named(before, data), data)
    meant = nearest(where, known)
    found = ".".join(filter(None, (start, meant, *beyond))) if meant else ""
    if found and beyond and not _leads(found, data):
        found = ""
    if not before:  # a path may differ in capital letters and hyphens alone
        found = _first(data, lambda steps: plain(own_path(named(steps, data), data)) == plain(path)) or found
    if not (isinstance(value, (list, tuple)) and where.isdecimal()):  # the names that there are say more
        found = found or _alike(path, data) or (_ending_meant(path, data) if known and not before else "")
    some = known if len(known) <= MOST_LISTED else get_close_matches(where, known, MOST_LISTED, 0.0)
    rest = f", {len(known) - len(some)} more: see `tmodes schema --arm`" if some is not known else ""
    expected = f"one of {', '.join(some)}{rest}" if known else f"no key inside `{start}`"
    return InputError(path, "an unknown key", expected, f"did you mean `{found}`?" if found else look)


def _leads(path: str, data: Any) -> bool:
    """Whether something may stand at a path."""
    try:
        steps_of(path, data)
    except InputError:
        return False
    return True


def _ending_meant(path: str, data: Any) -> str:
    """The ending of a number's path, of as many words, that was probably meant; the path where several end so."""
    count, known = path.count(".") + 1, dict[str, list[str]]()
    for _, _, place, _ in quantities(data):
        steps = place[: max(k for k, step in enumerate(place, 1) if isinstance(step, str))]
        own = own_path(named(steps, data), data)
        words = own.split(".")[-count:]
        ways = [] if words[0].isdecimal() else known.setdefault(".".join(words), [])
        ways += [] if own in ways else [own]
    meant = nearest(path, known)
    return "" if meant is None else meant if len(known[meant]) == 1 else known[meant][0]


def _alike(path: str, data: Any) -> str:
    """The path of a number with the same last word, and most of the other words; of the last link where all equal."""
    words = [plain(word) for word in path.split(".")]
    best, most = "", -1
    for _, _, place, _ in quantities(data):
        steps = place[: max(k for k, step in enumerate(place, 1) if isinstance(step, str))]
        own = named(steps, data)
        if steps[-1] == path.rpartition(".")[2]:
            shared = len({*words} & {plain(word) for word in own.split(".")})
            if shared > most or (shared == most and words[0] in _CARRIED):
                best, most = own_path(own, data), shared
    return best


_CARRIED = ("payload", "tool", "load", "gripper", "end_effector")
"""What a robot carries at its end."""


def _first(data: Any, fits: Callable[[tuple[Step, ...]], bool]) -> str:
    """The path of the first number of the sheet whose steps fit; empty where there is none."""
    return next((own_path(named(steps, data), data) for _, _, steps, _ in quantities(data) if fits(steps)), "")
