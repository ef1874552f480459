"""The map of a live report: from what its sliders say to all numbers of both runs, fitted once and evaluated there.

sliders -> knobs, as known and as they really are -> numbers of each run, by a Form each
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from hashlib import sha256
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.cache import load, save, source_digest
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.registry import outside_digest
from tmodes.live.knobs import Ahead, Knob, knobs_of
from tmodes.live.numbers import follow_of, has_reference, run_numbers, whole_moves
from tmodes.live.sheet_numbers import sheet_numbers
from tmodes.live.sliders import Slider, sliders_of
from tmodes.model.fitting import fitted
from tmodes.model.forms import Form, Range, Unfit
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.loop import Blocks, whole

__all__ = ["LiveMap", "Progress", "live_map"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_SEED = 20100
_LONGEST_MOVE = 2.5
"""How many times as long a move may become, and a little more."""

_NO_EFFECT = "it changes nothing in this run"
_NOT_COMPARED = (
    "an actual robot with factors of its own is compared with the nominal one, and this run has no nominal run to "
    "compare with; set them in the data sheet and simulate it by `tmodes run`"
)


@dataclass(frozen=True, eq=False)
class LiveMap:
    """Sliders, their knobs, and the numbers of each run: ``reference`` and ``real``.

    ``places``: of each run, where each block of its vector is. ``left_out``: paths that have no slider, with reasons.
    """

    sliders: tuple[Slider, ...]
    knobs: tuple[Knob, ...]
    forms: dict[str, Form]
    places: dict[str, dict[str, Any]]
    left_out: dict[str, str]

    def knob_values(self, values: Sequence[float], run: str) -> dict[int, float]:
        """Where the knobs of a run stand for values of the sliders; of an actual robot with its factors."""
        known = {k: knob.start for k, knob in enumerate(self.knobs)}
        factors = {k: knob.factor for k, knob in enumerate(self.knobs)}
        for slider, value in zip(self.sliders, values, strict=True):
            (factors if slider.real else known)[slider.knob] = value
        if run == "reference":
            return known
        return {k: _really(knob, known[k], factors[k]) for k, knob in enumerate(self.knobs)}

    def numbers(self, values: Sequence[float], run: str) -> Blocks:
        """The blocks of a run for values of the sliders."""
        vector = self.forms[run].at(self.knob_values(values, run))
        return {
            name: vector[place["start"] : place["start"] + int(np.prod(place["shape"]))].reshape(place["shape"])
            for name, place in self.places[run].items()
        }

    def changes(self, values: Sequence[float]) -> dict[str, float]:
        """What ``--set`` is to change for these values: of sliders that moved, path and value."""
        found: dict[str, float] = {}
        for slider, value in zip(self.sliders, values, strict=True):
            if value != slider.value:
                found |= slider.changes(self.knobs[slider.knob], value)
        return found

    def info(self) -> dict[str, Any]:
        """As plain data with arrays: what ``web/src/live/map.ts`` reads."""
        return {
            "knobs": [
                {"start": knob.start, "together": knob.together, "factor": knob.factor} for knob in self.knobs
            ],
            "sliders": [{"knob": slider.knob, "real": slider.real} for slider in self.sliders],
            "runs": {name: form.info() | {"places": self.places[name]} for name, form in self.forms.items()},
        }  # fmt: skip


def _really(knob: Knob, known: float, factor: float | None) -> float:
    """Where a knob of the actual robot stands; a proportion is of the actual robot's numbers."""
    if factor is None or knob.factor is None:
        return known
    if not knob.together:
        return known * factor
    return known * (factor / knob.factor) if knob.factor else known


def live_map(
    pair: RobotPair,
    stations: tuple[float, ...] = (),
    ahead: Ahead | None = None,
    progress: Progress = lambda stage, share: None,
) -> LiveMap:
    """The map of a pair: sliders whose effect has a form, and the forms, each verified at random points.

    ``stations``: places along each link of a robot of which its picture is made; ``ahead``: numbers whose sliders come
    first; ``progress``: is given ``report`` and its share. What was found is kept in the folder of compiled code, and
    found again where sheet, kinds, program, sliders and the numbers at the start are the same.
    """
    knobs = knobs_of(pair.nominal, ahead)
    sliders, left_out = _offered(pair, knobs, ahead)
    runs = _Runs(pair, knobs, sliders, range(len(knobs)), stations, _onward(progress))
    found = json.loads(load(runs.key) or b"null")
    if found is None:
        found = _found(runs)
        save(runs.key, json.dumps(found).encode())
    used = found["used"]
    sliders = [slider for slider in sliders if slider.knob in used]
    start, runs = runs.at_start, runs.of(used, sliders)
    forms = {name: Form.of(start[name], runs.ranges(name), parts) for name, parts in found["forms"].items()}
    idle = _idle(sliders, used, forms)
    left_out |= found["left out"] | {slider.path: _NO_EFFECT for slider in sliders if slider in idle}
    kept = [replace(slider, knob=used.index(slider.knob)) for slider in sliders if slider not in idle]
    return LiveMap(tuple(kept), tuple(runs.knobs), forms, runs.places, left_out)


def _onward(progress: Progress) -> Progress:
    """The same, whose share never falls: forms are fitted anew where a number turns out to have none."""
    reached = 0.0

    def forward(stage: str, share: float) -> None:
        nonlocal reached
        reached = max(reached, share)
        progress(stage, reached)

    return forward


def _found(every: _Runs) -> dict[str, Any]:
    """As plain data: the indices of the knobs whose effect has a form (``used``), why others have none, the forms."""
    left_out: dict[str, str] = {}
    sliders, used = every.sliders, sorted({slider.knob for slider in every.sliders})
    while True:
        runs = every.of(used, sliders)
        try:
            forms = {name: runs.fitted(name).parts() for name in every.at_start}
        except Unfit as error:
            for place, why in error.reasons.items():
                left_out |= {path: why for path, _ in runs.knobs[place].targets}
            used = [k for place, k in enumerate(used) if place not in error.reasons]
            sliders = [slider for slider in sliders if slider.knob in used]
            continue
        return {"used": used, "left out": left_out, "forms": forms}


def _offered(pair: RobotPair, knobs: Sequence[Knob], ahead: Ahead | None) -> tuple[list[Slider], dict[str, str]]:
    """Sliders to begin with, and what has none: with a first factor a run would get a reference that is not here."""
    sliders = sliders_of(pair.nominal, knobs, ahead=ahead)
    if has_reference(pair.nominal) or not any(one.real for one in sliders):
        return sliders, {}
    return sliders_of(pair.nominal, knobs, factors=False), {"real": _NOT_COMPARED}


def _idle(sliders: Sequence[Slider], used: list[int], forms: Mapping[str, Form]) -> list[Slider]:
    """Sliders that change no number of any run."""
    acting = {name: form.acting(0, len(form.base)) for name, form in forms.items()}
    real = set().union(*(own for name, own in acting.items() if name != "reference"))
    every = real | acting.get("reference", set())
    return [slider for slider in sliders if used.index(slider.knob) not in (real if slider.real else every)]


@dataclass(frozen=True, eq=False)
class _Runs:
    """The runs of a pair as functions of knobs; ``used``: which these are among all, by which sliders name them."""

    pair: RobotPair
    knobs: Sequence[Knob]
    sliders: Sequence[Slider]
    used: Sequence[int]
    stations: tuple[float, ...]
    progress: Progress
    places: dict[str, dict[str, Any]] = field(default_factory=dict)

    def of(self, used: Sequence[int], sliders: Sequence[Slider]) -> _Runs:
        """The same runs as functions of some of the knobs, and with the sliders of these."""
        return replace(self, knobs=[self.knobs[k] for k in used], sliders=sliders, used=used)

    @cached_property
    def factors(self) -> dict[int, Slider]:
        """The sliders that are factors of the actual robot, by their knobs."""
        return {self.used.index(slider.knob): slider for slider in self.sliders if slider.real}

    @cached_property
    def at_start(self) -> dict[str, Array]:
        """The vector of each run where no knob has moved."""
        return {name: self._vector(name, {}) for name in ("reference", "real")}

    @cached_property
    def really(self) -> dict[str, float]:
        """The numbers of the actual robot by their paths."""
        return {number.path: number.value for number in sheet_numbers(self.pair.real)}

    @property
    def key(self) -> str:
        """All that a map follows from: program, kinds, both sheets, stations, and the numbers at the start."""
        sheets = [robot.model_dump_json() for robot in (self.pair.nominal, self.pair.real)]
        numbers = [sha256(vector.tobytes()).hexdigest() for vector in self.at_start.values()]
        program = source_digest((".",)), outside_digest(), np.__version__
        spans = [(knob.targets[0][0], knob.low, knob.high) for knob in self.knobs]
        return "\n".join(["map", *program, *sheets, repr(self.stations), repr(spans), *numbers])

    def fitted(self, name: str) -> Form:
        """The form of a run's numbers."""
        return fitted(lambda values: self._vector(name, values), self.ranges(name), np.random.default_rng(_SEED))

    def ranges(self, name: str) -> tuple[Range, ...]:
        """Where the knobs of a run start, and how far they go."""
        return tuple(self._range(k, known=name == "reference") for k in range(len(self.knobs)))

    def _range(self, k: int, *, known: bool) -> Range:
        knob, slider = self.knobs[k], self.factors.get(k)
        if known or knob.factor is None:
            return Range(knob.start, knob.low, knob.high)
        factors = [slider.low, slider.high] if slider else [knob.factor, knob.factor]
        ends = [_really(knob, end, factor) for end in (knob.low, knob.high) for factor in factors]
        return Range(_really(knob, knob.start, knob.factor), min(ends), max(ends))

    def _vector(self, name: str, values: Mapping[int, float]) -> Array:
        self.progress("report", (max(values, default=0) / len(self.knobs) + (name == "real")) / 2)
        sheet: Any = self.pair.nominal if name == "reference" else self.pair.real
        try:
            changes = self._changes(values, known=name == "reference")
            blocks = self._blocks(name, sheet.with_({**changes, "real": {}}) if changes else sheet)
        except (InputError, InputErrors) as error:
            raise Unfit({len(self.knobs) - 1: f"the sheet refuses it: {error}"}) from error
        vector, places = whole(blocks)
        if self.places.setdefault(name, places) != places:
            raise Unfit({len(self.knobs) - 1: "it changes how many pieces a signal has"})
        return vector

    def _changes(self, values: Mapping[int, float], *, known: bool) -> dict[str, float]:
        """Paths and values of the sheet of a run; of a real one the proportion is of its own numbers."""
        found: dict[str, float] = {}
        for k, value in values.items():
            knob = self.knobs[k]
            if known or not knob.together:
                found |= knob.changes(value)
            else:
                found |= {path: self.really[path] * value for path, _ in knob.targets}
        return found

    def _blocks(self, name: str, sheet: Robot) -> Blocks:
        follow, until = follow_of(self.pair.nominal, name), whole_moves(self.pair.nominal, _LONGEST_MOVE)
        return run_numbers(sheet, follow, until, self.stations if name == "real" else ())
