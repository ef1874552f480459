"""Which stored blocks give which cases of a study, and what is missing."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass

from tmodes.study.blocks import Label

__all__ = ["Cover", "Gap", "Part", "covered"]


@dataclass(frozen=True)
class Part:
    """Cases ``first`` to ``end``, whose quantities are in the blocks ``labels``; ``missing``: those in none."""

    first: int
    end: int
    labels: tuple[Label, ...]
    missing: tuple[str, ...]


@dataclass(frozen=True)
class Gap:
    """Cases ``first`` to ``end`` of which nothing is stored."""

    first: int
    end: int


@dataclass(frozen=True)
class Cover:
    """All cases in order: ``parts`` that are stored, ``gaps`` that are not; ``older``: cases of another engine only."""

    parts: tuple[Part, ...]
    gaps: tuple[Gap, ...]
    older: int

    @property
    def complete(self) -> bool:
        """Whether every quantity of every case is stored."""
        return not self.gaps and not any(part.missing for part in self.parts)

    @property
    def done(self) -> int:
        """Cases of which all is stored."""
        return sum(part.end - part.first for part in self.parts if not part.missing)


def covered(
    labels: Iterable[Label], total: int, engine: str, keys: Mapping[str, str], address: Callable[[int, int], str]
) -> Cover:
    """Cover ``total`` cases, whose ``address`` (first, end) is asked for, by blocks of this ``engine``.

    Blocks count by their content: a study with more cases, or another order of blocks, finds those that are there.
    """
    groups: dict[int, dict[int, list[Label]]] = defaultdict(lambda: defaultdict(list))
    for label in labels:
        if label.end <= total and _useful(label, keys):
            groups[label.first][label.end].append(label)
    parts: list[Part] = []
    gaps: list[Gap] = []
    case = older = 0
    starts = sorted(groups)
    while case < total:
        ends = {end: same for end, of in groups.get(case, {}).items() if (same := _same(of, address(case, end)))}
        here = {end: new for end, same in ends.items() if (new := [one for one in same if one.engine == engine])}
        if here:
            parts.append(_part(case, max(here), here[max(here)], keys))
            case = max(here)
            continue
        older += max(ends, default=case) - case
        following = next((start for start in starts if start > case), total)
        gaps.append(Gap(case, following))
        case = following
    return Cover(tuple(parts), _united(gaps), older)


def _same(labels: Sequence[Label], address: str) -> list[Label]:
    return [label for label in labels if label.address == address]


def _useful(label: Label, keys: Mapping[str, str]) -> bool:
    """Whether a block has a quantity that is asked for, and none that is not and may have made a case fail."""
    asked = [name for name, key in label.keys.items() if keys.get(name) == key]
    return bool(asked) and (len(asked) == len(label.keys) or not label.failed)


def _part(first: int, end: int, labels: Sequence[Label], keys: Mapping[str, str]) -> Part:
    """The fewest blocks that give most quantities: those with many first; the order is always the same."""
    left, used = dict(keys), []
    for label in sorted(labels, key=lambda label: (-len(label.keys), label.name)):
        gives = [name for name, key in label.keys.items() if left.get(name) == key]
        if gives:
            used.append(label)
            left = {name: key for name, key in left.items() if name not in gives}
    return Part(first, end, tuple(used), tuple(left))


def _united(gaps: Sequence[Gap]) -> tuple[Gap, ...]:
    """Gaps that touch as one."""
    found: list[Gap] = []
    for gap in gaps:
        if found and found[-1].end == gap.first:
            found[-1] = Gap(found[-1].first, gap.end)
        else:
            found.append(gap)
    return tuple(found)
