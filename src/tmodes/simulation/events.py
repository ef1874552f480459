"""What happened in a run at instants: teeth and surfaces that meet and part, what sticks and slips, limits, its end.

Where forces start, end or switch, the integrator has located the instant; joint limits are found between samples.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from numpy.typing import NDArray

from tmodes.equations.loop.contact_kernels import SLIP
from tmodes.equations.recursion.drive_kernels import TEETH
from tmodes.simulation.event import Event
from tmodes.simulation.motion_run import RunData
from tmodes.simulation.parts import MOST_CHANGES

__all__ = ["cut_short", "events_of"]

Array = NDArray[np.float64]

_SLOW = 1e-9
"""A speed [m/s] of approach below which a touch after a touch is none."""

_SAME = 1e-12
"""A rate [m/s] of a surface that changes by less at a switch has met no body."""


def events_of(run: RunData) -> tuple[Event, ...]:
    """The events of a run in the order of time; of changes the first :data:`tmodes.simulation.parts.MOST_CHANGES`."""
    end = [Event(float(run.times[-1]), "stop", run.ended_by)] if run.ended_by else []
    found = sorted([*_changes(run), *_limits(run)], key=lambda event: event.time)
    return (*found, *end)


def cut_short(run: RunData) -> str:
    """A sentence where a run has more changes than are kept; else empty."""
    if len(run.changes) < MOST_CHANGES:
        return ""
    return (
        f"the list of events ends at t = {run.changes[-1].time:.6g} s, after {MOST_CHANGES:,} changes of contacts, "
        "friction and teeth; what happened later is in the series alone"
    )


def _changes(run: RunData) -> Iterator[Event]:
    if not run.changes:
        return
    model, rows = run.setup.model, run.planned.schedule
    times = np.array([change.time for change in run.changes])
    before, after = (np.array([getattr(change, name) for change in run.changes]) for name in ("before", "after"))
    times, after = np.insert(times, 0, 0.0), np.concatenate([run.states[:1], after])
    before = np.concatenate([run.states[:1], before])
    seen = [model.event_data(times, states, rows.rows_at(times)) for states in (before, after)]
    reader = _Reader(run, before, after, *seen)
    touching = False
    for k in range(1, len(times)):
        for kind, place, speed, unit, direction in reader.at(k):
            if kind == "touch" and touching and abs(speed) <= _SLOW:
                continue  # it touched all along: friction switched
            touching = kind == "touch" if place == "contact" and kind in {"touch", "release"} else touching
            yield Event(float(times[k]), kind, place, abs(float(speed)), unit, int(direction))


_Found = Iterator[tuple[str, str, float, str, float]]


class _Reader:
    """Reads events off the states before and after each change, and the event data there."""

    def __init__(
        self, run: RunData, before: Array, after: Array, was: Mapping[str, Array], found: Mapping[str, Array]
    ) -> None:
        loop, layout = run.setup.model.loop, run.setup.model.layout
        self.before, self.after, self.was, self.found = before, after, was, found
        self.layout, self.slipping = layout, tuple(loop.slipping)
        self.names = run.coordinates
        self.units = [run.setup.model.outputs[f"{name}.velocity"].unit for name in self.names]
        self.touch = loop.plan.touch.touch if loop.plan.touch else None
        self.touching = len(self.slipping) + (SLIP if self.touch and self.touch.sheet.sticks else 0)
        self.gears = [axis.angle for axis in loop.parts.axes if axis.drive and axis.drive.dead_zone]
        self.modes = [states[:, layout.modes] for states in (before, after)]
        gates = found["gate"]
        self.open: NDArray[np.bool_] = gates.reshape(len(gates), -1, 2).min(axis=2) > 0

    def at(self, k: int) -> _Found:
        """Kind, place, speed, its unit, and direction of what happens at a change."""
        was, now = self.modes[0][k], self.modes[1][k]
        yield from self._friction(k, was, now)
        if self.touch:
            yield from self._landing(k, was, now) if self.touch.lands else self._gate(k)
            if self.touch.sheet.sticks:
                first = len(self.slipping)
                yield from self._slip(k, was[first : first + SLIP], now[first : first + SLIP])
        yield from self._teeth(k)

    def _friction(self, k: int, was: Array, now: Array) -> _Found:
        """Coordinates that stick, or slip in a new direction."""
        for mode, place in enumerate(self.slipping):
            if was[mode] != now[mode]:
                kind, states = ("slip", self.after) if now[mode] else ("stick", self.before)
                yield kind, self.names[place], states[k, self.layout.v.start + place], self.units[place], now[mode]

    def _landing(self, k: int, was: Array, now: Array) -> _Found:
        """A surface with mass, also one from which the point bounces."""
        rate = self.layout.surface.start + 1
        hit = abs(self.after[k, rate] - self.before[k, rate]) > _SAME
        place = self.touching
        if was[place] and not now[place]:
            yield "release", "contact", self.after[k, rate], "m/s", 0
        elif now[place] > was[place] or (hit and not was[place]):
            yield "touch", "contact", self.was["contact"][k, 5], "m/s", 0

    def _gate(self, k: int) -> _Found:
        """A surface without mass that only pushes."""
        if self.touch and self.touch.sheet.unilateral and self.open[k, 0] != self.open[k - 1, 0]:
            yield "touch" if self.open[k, 0] else "release", "contact", self.found["contact"][k, 5], "m/s", 0

    def _slip(self, k: int, was: Array, now: Array) -> _Found:
        """A point that sticks, or slips: where it slipped before, in another direction by more than a right angle."""
        if not self.found["contact"][k, 3]:
            return
        slipped, slips = was.any(), now.any()
        if slipped and not slips:
            yield "stick", "contact", self.was["sliding"][k, 0], "m/s", 0
        elif slips and (not slipped or was @ now < 0):
            yield "slip", "contact", self.found["sliding"][k, 0], "m/s", 0

    def _teeth(self, k: int) -> _Found:
        """Gears with play; of each side the first of two gates is that of the force."""
        own = TEETH // 2
        first = self.open.shape[1] - own * len(self.gears)
        for gear, place in enumerate(self.gears):
            for gate, side in ((first + own * gear, 1), (first + own * gear + 2, -1)):
                if self.open[k, gate] != self.open[k - 1, gate]:
                    kind, rate = "engage" if self.open[k, gate] else "disengage", self.found["gear_rates"][k, gear]
                    yield kind, f"{self.names[place]}.gear", rate, self.units[place], side


def _limits(run: RunData) -> Iterator[Event]:
    """Where joints pass their limits of position, between samples by the cubic of both ends and rates."""
    settings = run.robot.integration
    for joint, name in ((each, name) for each in run.robot.joints for name in each.coordinates):
        if joint.limits is None or name not in run.coordinates:
            continue
        place = run.coordinates.index(name)
        for limit, side in ((joint.limits.lower, -1.0), (joint.limits.upper, 1.0)):
            if limit is None:
                continue
            margin = settings.absolute_tolerance + settings.relative_tolerance * max(1.0, abs(limit))
            beyond = side * (run.q[:, place] - limit) - margin
            for k in np.flatnonzero((beyond[:-1] <= 0) & (beyond[1:] > 0)).tolist():
                time, rate = _crossing(run.times[k : k + 2], beyond[k : k + 2], side * run.v[k : k + 2, place])
                yield Event(time, "limit", name, abs(rate), f"{joint.unit}/s", int(side))


def _crossing(times: Array, values: Array, rates: Array) -> tuple[float, float]:
    """Time and rate of the first upward zero between two samples."""
    from scipy.interpolate import CubicHermiteSpline

    course = CubicHermiteSpline(times, values, rates)
    roots = [float(root) for root in course.roots(extrapolate=False) if course(root, 1) > 0]
    time = min(roots, default=float(times[1]))
    return time, float(course(time, 1))
