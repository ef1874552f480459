"""Numbers in which variables are entangled: these are found by probing two at a time, and described by surfaces."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import combinations

import numpy as np
from numpy.polynomial import chebyshev
from numpy.typing import NDArray

from tmodes.model.curves import Curve, Span, places_of
from tmodes.model.forms import Form, Powers, share, variables_of
from tmodes.model.probing import ENTANGLED, Entangled, Fit, mistaken
from tmodes.model.surfaces import Grid, Surface

__all__ = ["disentangled"]

Array = NDArray[np.float64]
Group = tuple[int, ...]
"""Variables that are entangled, by their index, rising."""

_HIGHEST = 32
"""Largest degree along one variable."""

_NEEDED = 2e-13
"""Size of a coefficient, over that of the number, that a variable by itself needs."""

_MORE = 2
"""Degrees more than that; they must be without effect."""

_TAIL = 1e-13
"""Size of the last coefficients over that of the number where it has converged."""

_FITS = 2e-13


def disentangled(fit: Fit, most: int) -> Fit | None:
    """What is known with surfaces of entangled numbers, from at most so many vectors in all; None where none is.

    Raises :class:`tmodes.model.probing.Entangled` where a surface is not smooth, or needs more vectors.
    """
    fit = fit.with_squares([entry for entry, powers in fit.depends.items() if _may_be(powers)])
    pairs = _entangled(fit)
    if not pairs:
        return None
    _take_squares(fit, pairs)
    each = {entry: _joined(own) for entry, own in pairs.items() if entry in fit.depends}
    every = {group for groups in each.values() for group in groups}
    for group in sorted(every):
        if any({*group} < {*other} for other in every):
            continue
        entries = [entry for entry, groups in each.items() if any({*one} <= {*group} for one in groups)]
        _describe(fit, group, entries, most)
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
        far, own = (
            fit.far(frozenset(pair)),
            {e: tuple(one for one in fit.depends[e] if one[0] in pair) for e in entries},
        )
        terms = {entry: fit.terms(entry, powers, far) for entry, powers in own.items()}
        between = {k: fit.ranges[k].between for k in pair}
        true = fit.evaluate(between)
        wrong = mistaken(Form(fit.base, fit.ranges, sums=terms), between, true, fit.noise(true))
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


def _joined(pairs: Iterable[Group]) -> list[Group]:
    """Pairs as groups: those that share a variable are one."""
    groups: list[set[int]] = []
    for pair in pairs:
        met = [group for group in groups if group & {*pair}]
        groups = [*(group for group in groups if group not in met), {*pair}.union(*met)]
    return [tuple(sorted(group)) for group in groups]


def _describe(fit: Fit, group: Group, entries: Sequence[int], most: int) -> None:
    """Surfaces of numbers in place of what the variables of a group do to them by themselves."""
    grid, samples = _sampled(fit, group, entries, most)
    left = np.arange(len(entries))
    base, step = fit.base[entries], (fit.far(frozenset(group)) - fit.base)[entries]
    size = np.abs(samples).reshape(-1, len(entries)).max(axis=0)
    while len(left):
        first = left[np.argmax(np.abs(step[left]) / size[left])]
        if step[first] == 0:
            raise Entangled({group[-1]: ENTANGLED})
        shares = (samples[..., first] - base[first]) / step[first]
        surface = Surface(group, grid.spans, grid.coefficients(shares[..., None])[..., 0])
        errors = np.abs(base[left] + step[left] * shares[..., None] - samples[..., left])
        alike = errors.reshape(-1, len(left)).max(axis=0) <= _FITS * size[left]
        alike |= left == first
        for entry in np.asarray(entries)[left[alike]].tolist():
            others = tuple(one for one in fit.depends[entry] if not variables_of((one,)) & {*group})
            fit.depends[entry] = (*others, (group[0], surface))
        left = left[~alike]


def _sampled(fit: Fit, group: Group, entries: Sequence[int], most: int) -> tuple[Grid, Array]:
    """A grid that is fine enough, and the numbers at its points, (m, n, ..., numbers)."""
    axes = [_axis(fit, k, entries) for k in group]
    degrees = [degree + _MORE for _, degree in axes]
    while max(degrees) <= _HIGHEST:
        grid = Grid(tuple(span for span, _ in axes), tuple(degrees))
        if fit.numbers.count + grid.size > most:
            break
        samples = grid.sampled(lambda point: fit.evaluate(dict(zip(group, point, strict=True)), keep=False)[entries])
        rough = grid.rough(samples, _TAIL)
        if not any(rough):
            return grid, samples
        degrees = [degree + (_MORE + 1) * more for degree, more in zip(degrees, rough, strict=True)]
    raise Entangled({group[-1]: ENTANGLED})


def _axis(fit: Fit, k: int, entries: Sequence[int]) -> tuple[Span, int]:
    """By ratios or by differences: the span by which a variable alone needs the lower degree, and this degree."""
    one, far, found = fit.ranges[k], fit.far(frozenset([k])), list[tuple[Span, int]]()
    for even in (False, True):
        span, need = Span(one.low, one.high, even), 0
        places = places_of(_HIGHEST)
        basis, values = chebyshev.chebvander(places, _HIGHEST), span.value(places)
        functions = {
            p: [entry for entry in entries if (k, p) in fit.depends[entry]] for p in _functions(fit, k, entries)
        }
        for p, own in functions.items():
            step, size = np.abs(far - fit.base)[own], np.maximum(np.abs(far), np.abs(fit.base))[own]
            parts = np.abs(np.linalg.solve(basis, share(one, p, values))) * (step / size).max()
            need = max(need, *np.flatnonzero(parts > _NEEDED).tolist())
        found.append((span, need))
    return min(found, key=lambda each: each[1])


def _functions(fit: Fit, k: int, entries: Sequence[int]) -> set[int | Curve]:
    """What a variable alone does to some numbers."""
    every = (one for entry in entries for one in fit.depends[entry])
    return {p for own, p in every if own == k and not isinstance(p, Surface)}
