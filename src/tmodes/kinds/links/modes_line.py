"""Kinematics of a ``modes`` link: azimuths and elevations of the modes add up, each seen from the link's root.

Mode k turns its chord by th_k against the tangent where it starts, and its end's tangent by 3/2 th_k, in azimuth (about
z) and in elevation (towards z). A section is Rz(azimuth) Ry(-elevation) of the link's axes.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import cos, sin
from tmodes.kinds.kernel.spatial import Force
from tmodes.kinds.links.terms import Section

__all__ = ["TANGENT", "ModeAngles", "ModesLine"]

TANGENT = 1.5
"""Turn of a mode's end over that of its chord: a cantilever under a tip force."""


@dataclass
class ModeAngles:
    """Bending angles and their rates of each mode, in one plane; 0.0 where a mode is rigid."""

    values: list[Any]
    rates: list[Any]

    def direction(self, mode: int, share: Any) -> tuple[Any, Any]:
        """Angle and rate of a direction: tangents of the modes before, and ``share`` of the mode's own angle."""
        found = []
        for part in (self.values, self.rates):
            before = part[:mode]
            found.append(v.total([*([TANGENT * v.total(before)] if before else []), share * part[mode]]))
        return found[0], found[1]


class _Direction:
    """A direction in space by azimuth and elevation, with its derivatives by both and its bias acceleration."""

    def __init__(self, azimuth: tuple[Any, Any], elevation: tuple[Any, Any]) -> None:
        (ca, sa), (ce, se) = ((cos(x), sin(x)) for x in (azimuth[0], elevation[0]))
        a, e = azimuth[1], elevation[1]
        self.along: v.Vector = [ce * ca, ce * sa, se]
        self.by_azimuth: v.Vector = [-(ce * sa), ce * ca, 0.0]
        self.by_elevation: v.Vector = [-(se * ca), -(se * sa), ce]
        # Second derivative in time at constant rates: -ce a'^2 e_r - 2 se a' e' e_t - e'^2 (the direction itself).
        inward, across = ce * a * a, 2 * se * a * e
        self.rate = v.add(v.scale(a, self.by_azimuth), v.scale(e, self.by_elevation))
        self.bias: v.Vector = [
            -(inward * ca) + across * sa - e * e * self.along[0],
            -(inward * sa) - across * ca - e * e * self.along[1],
            -(e * e * se),
        ]
        self.side: v.Vector = [-sa, ca, 0.0]
        self.ahead: v.Vector = [ca, sa, 0.0]


class ModesLine:
    """All chords of the link in one state; ``spin`` (3,) is the angular velocity of its root in its own axes."""

    def __init__(
        self, lengths: list[Any], azimuth: ModeAngles, elevation: ModeAngles, free: tuple[bool, ...], spin: v.Vector
    ):
        self.lengths, self.azimuth, self.elevation, self.free, self.spin = lengths, azimuth, elevation, free, spin
        self.chords = [self._chord(k, 1.0) for k in range(len(lengths))]

    def _chord(self, mode: int, share: Any) -> _Direction:
        return _Direction(self.azimuth.direction(mode, share), self.elevation.direction(mode, share))

    def section(self, mode: int, place: Any, chord_share: Any, slope_share: Any) -> Section:
        """The section at ``place`` (0..1) of a mode; shares: turn of the chord to it and of its tangent, over th.

        Eq. (3) [derived]: the line is the sum of the modes' deflections y = X(x) T(t), carried by the motion of the
        modes before them: direct kinematics. {test_line_ends_at_tip}
        """
        whole = isinstance(place, float)  # the end of a mode, known beforehand
        last = self.chords[mode] if whole else self._chord(mode, chord_share)
        length = self.lengths[mode] if whole else place * self.lengths[mode]
        arms = [*zip(self.lengths[:mode], self.chords[:mode], strict=True), (length, last)]
        position = v.add(*(v.scale(size, chord.along) for size, chord in arms))
        moved = v.add(*(v.scale(size, chord.rate) for size, chord in arms))
        own = v.add(*(v.scale(size, chord.bias) for size, chord in arms))
        gained = v.add(v.cross(self.spin, v.add(v.cross(self.spin, position), v.scale(2, moved))), own)
        end_azimuth = self.azimuth.direction(mode, slope_share)
        end_elevation = self.elevation.direction(mode, slope_share)
        tangent = _Direction(end_azimuth, end_elevation)
        up = [-x for x in tangent.side]  # elevation turns about minus the side axis
        turning = v.add(v.scale(end_azimuth[1], v.unit(2)), v.scale(end_elevation[1], up))
        turn_bias = v.add(v.cross(self.spin, turning), v.scale(end_azimuth[1] * end_elevation[1], tangent.ahead))
        rotation = v.transpose([tangent.along, tangent.side, tangent.by_elevation])
        columns = [
            self._column(mode, j, arms, (chord_share, slope_share), which, axis)
            for which, axis in (("by_azimuth", v.unit(2)), ("by_elevation", up))
            for j in range(len(self.lengths))
            if self.free[j]
        ]
        return Section(rotation, position, v.add(self.spin, turning), columns, Force(turn_bias, gained))

    def _column(self, mode: int, j: int, arms: list[Any], shares: tuple[Any, Any], which: str, axis: Any) -> Force:
        """Motion of a section of ``mode`` per rate of the angle of mode j in one plane."""
        if j > mode:
            return Force.zero()
        linear = v.zero()
        for k in range(j, mode + 1):
            share = (shares[0] if k == mode else 1.0) if k == j else TANGENT
            linear = v.add(linear, v.scale(share * arms[k][0], getattr(arms[k][1], which)))
        return Force(v.scale(shares[1] if j == mode else TANGENT, axis), linear)
