"""Numbers in which variables are entangled: these are found by probing two at a time, and described by surfaces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from tmodes.model.accuracy import mistaken
from tmodes.model.curves import Curve, Span, places_of
from tmodes.model.forms import Form, Powers, Range, share, variables_of
from tmodes.model.probing import ENTANGLED, Entangled, Fit
from tmodes.model.surfaces import Grid, SmoothSurface

__all__ = ["disentangled"]

Array = NDArray[np.float64]
Group = tuple[int, ...]
"""Variables that are entangled, by their index, rising."""

_HIGHEST = 32
"""Largest degree along one variable."""

_TO_COEFFICIENTS = np.linalg.inv(chebyshev.chebvander(places_of(_HIGHEST), _HIGHEST))
"""From the values of a function at Chebyshev's points to its coefficients."""

_NEEDED = 2e-13
"""Size of a coefficient, over that of the number, that a variable by itself needs."""

_MORE = 2
"""Degrees more than that; they must be without effect."""

_FINER = 3
"""Degrees more where they have an effect."""

_TAIL = 1e-13
"""Size of the last coefficients over that of the number where it has converged."""

_FITS = 2e-13


def disentangled(fit: Fit, most: int) -> Fit | None:
    """What is known with surfaces of entangled numbers, by at most so many more vectors; None where none is entangled.

    Raises :class:`tmodes.model.probing.Entangled` where a surface is not smooth, or needs more vectors.
    """
    fit = fit.with_squares([entry for entry, powers in fit.depends.items() if _may_be(powers)])
    pairs = _entangled(fit)
    if not pairs:
        return None
    _take_squares(fit, pairs)
    groups = _groups({entry: own for entry, own in pairs.items() if entry in fit.depends})
    grids = {group: _grid(fit, group, entries) for group, entries in groups.items()}
    for group, entries in groups.items():
        others = sum(grid.size for other, grid in grids.items() if other > group)
        most -= _describe(fit, group, entries, grids[group], most - others)
    return fit


def _may_be(powers: Powers) -> bool:
    """Whether variables may be entangled: together with powers of others a power seldom is."""
    return len(powers) > 1 and any(isinstance(p, Curve) for _, p in powers)


def _entangled(fit: Fit) -> dict[int, list[Group]]:
    """The pairs of variables that are entangled in a number: what both do is no product of what each does."""
    candidates: dict[Group, list[int]] = {}
    for entry, powers in fit.depends.items():
        if _may_be(powers):
            for pair in combinations(sorted(k for k, _ in powers), 2):
                candidates.setdefault((min(pair), max(pair)), []).append(entry)
    found: dict[int, list[Group]] = {}
    for pair, entries in candidates.items():
        own = {entry: tuple(one for one in fit.depends[entry] if one[0] in pair) for entry in entries}
        terms = {entry: fit.terms(entry, powers, fit.far(frozenset(pair))) for entry, powers in own.items()}
        between = {k: fit.ranges[k].between for k in pair}
        wrong = mistaken(Form(fit.base, fit.ranges, sums=terms), between, fit.evaluate(between), exact=entries)
        for entry in np.flatnonzero(wrong[entries]).tolist():
            found.setdefault(entries[entry], []).append(pair)
    return found


def _take_squares(fit: Fit, pairs: Mapping[int, list[Group]]) -> None:
    """Describe entangled numbers by their squares where these are simpler, such as the root of an area is."""
    for entry in fit.squared:
        square = fit.square_of(entry)
        simpler = square not in fit.lost and (square not in pairs or _needs(fit, square) < _needs(fit, entry))
        if entry in pairs and square in fit.depends and simpler:
            fit.roots[entry] = square
        fit.depends.pop(entry if entry in fit.roots else square, None)


def _needs(fit: Fit, entry: int) -> int:
    """The degrees that the variables of a number need, in all."""
    return sum(_axis(fit, k, [entry])[1] for k, _ in fit.depends[entry])


def _groups(pairs: Mapping[int, list[Group]]) -> dict[Group, list[int]]:
    """The variables that are entangled with each other, rising, and the numbers in which some of a group are."""
    each = {entry: _joined(own) for entry, own in pairs.items()}
    every = {group for groups in each.values() for group in groups}
    largest = sorted(group for group in every if not any({*group} < {*other} for other in every))
    return {
        group: [entry for entry, groups in each.items() if any({*one} <= {*group} for one in groups)]
        for group in largest
    }


def _joined(pairs: Iterable[Group]) -> list[Group]:
    """Pairs as groups: those that share a variable are one."""
    groups: list[set[int]] = []
    for pair in pairs:
        met = [group for group in groups if group & {*pair}]
        groups = [*(group for group in groups if group not in met), {*pair}.union(*met)]
    return [tuple(sorted(group)) for group in groups]


def _describe(fit: Fit, group: Group, entries: Sequence[int], grid: Grid, most: int) -> int:
    """Surfaces of numbers in place of what the variables of a group do by themselves; how many vectors they took."""
    before = fit.numbers.count
    grid, samples = _sampled(fit, group, entries, grid, most)
    left = np.arange(len(entries))
    base, step = fit.base[entries], (fit.far(frozenset(group)) - fit.base)[entries]
    size = np.abs(samples).reshape(-1, len(entries)).max(axis=0)
    while len(left):
        first = left[np.argmax(np.abs(step[left]) / size[left])]
        if step[first] == 0:
            raise Entangled({group[-1]: ENTANGLED})
        shares = (samples[..., first] - base[first]) / step[first]
        surface = SmoothSurface(group, grid.spans, grid.coefficients(shares[..., None])[..., 0])
        errors = np.abs(base[left] + step[left] * shares[..., None] - samples[..., left])
        alike = errors.reshape(-1, len(left)).max(axis=0) <= _FITS * size[left]
        alike |= left == first
        for entry in np.asarray(entries)[left[alike]].tolist():
            others = tuple(one for one in fit.depends[entry] if not variables_of((one,)) & {*group})
            fit.depends[entry] = (*others, (group[0], surface))
        left = left[~alike]
    return fit.numbers.count - before


def _sampled(fit: Fit, group: Group, entries: Sequence[int], grid: Grid, most: int) -> tuple[Grid, Array]:
    """The grid, or one that is fine enough, and the numbers at its points, (m, n, ..., numbers)."""
    while grid.size <= most and max(grid.degrees) <= _HIGHEST:
        samples = grid.sampled(lambda point: fit.evaluate(dict(zip(group, point, strict=True)), keep=False)[entries])
        rough = grid.rough(samples, _TAIL)
        if not any(rough):
            return grid, samples
        most -= grid.size
        finer = (degree + _FINER * more for degree, more in zip(grid.degrees, rough, strict=True))
        grid = Grid(grid.spans, tuple(finer))
    raise Entangled({group[-1]: ENTANGLED})


def _grid(fit: Fit, group: Group, entries: Sequence[int]) -> Grid:
    """By what the variables need by themselves, and a little more."""
    axes = [_axis(fit, k, entries) for k in group]
    return Grid(tuple(span for span, _ in axes), tuple(degree + _MORE for _, degree in axes))


def _axis(fit: Fit, k: int, entries: Sequence[int]) -> tuple[Span, int]:
    """By ratios or by differences: the span by which a variable alone needs the lower degree, and this degree."""
    one, far = fit.ranges[k], fit.far(frozenset([k]))
    changes = np.abs(far - fit.base) / np.maximum(np.maximum(np.abs(far), np.abs(fit.base)), np.finfo(float).tiny)
    functions: dict[int | Curve, float] = {}
    for entry in entries:
        for own, p in fit.depends[entry]:
            if own == k and not isinstance(p, SmoothSurface):
                functions[p] = max(functions.get(p, 0.0), float(changes[entry]))
    spans = [Span(one.low, one.high, even) for even in (False, True)]
    each = [(span, max(_degree(one, p, span, _NEEDED / change) for p, change in functions.items())) for span in spans]
    return min(each, key=lambda found: found[1])


def _degree(one: Range, p: int | Curve, span: Span, least: float) -> int:
    """The highest degree whose coefficient in a share is at least so large."""
    found = _TO_COEFFICIENTS @ share(one, p, span.value(places_of(_HIGHEST)))
    return max(np.flatnonzero(np.abs(found) > least).tolist(), default=0)
