"""The map of a live report: one noted program, with guards, from its sliders to all numbers of both runs.

sliders -> numbers of the data sheet -> parameters, signals, rest and lines of the nominal and of the actual robot
"""

from __future__ import annotations

import json
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.compile.cache import load, save, source_digest
from tmodes.io.forms import follows
from tmodes.io.sheet_check import sheet_data
from tmodes.io.sheet_paths import steps_of
from tmodes.kinds.noted.program import Program
from tmodes.kinds.registry import outside_digest
from tmodes.live.knobs import Ahead, knobs_of
from tmodes.live.numbers import follow_of, has_reference, run_numbers, whole_moves
from tmodes.live.sheet_numbers import sample_lists
from tmodes.live.sliders import Slider, sliders_of
from tmodes.model.parameters import Structural
from tmodes.robots import names
from tmodes.sheet import Robot, RobotPair
from tmodes.simulation.loop import Blocks, whole
from tmodes.simulation.vary.programs import CaseProgram, case_program

__all__ = ["LiveMap", "Progress", "live_map", "origin"]

Array = NDArray[np.float64]
Progress = Callable[[str, float], None]

_LONGEST_MOVE = 1e4
"""How many times as long a move may become."""

_NO_EFFECT = "it changes nothing in this run"
_NOT_COMPARED = (
    "an actual robot with factors of its own is compared with the nominal one, and this run has no nominal run to "
    "compare with; set them in the data sheet and simulate it by `tmodes run`"
)
_DRAGS = "of a surface that stands still: a robot that a moving one drags starts otherwise; change it by --set"
_FOLLOWS = "it follows from other numbers, as in the format that the robot is imported from"
_SAMPLES = "samples of a signal; change them in the data sheet"
_DESIGNED = "gains of {} are designed from them before the run, or they are structure: `tmodes run {} --set PATH=VALUE`"
_STRUCTURE = "structure: another value takes other equations; change it by --set"


@dataclass(frozen=True, eq=False)
class LiveMap:
    """Sliders, what each moves, and the program ``noted`` of the numbers of both runs, ``reference`` and ``real``.

    Its blocks are called ``RUN BLOCK``. ``moved``: by the path of a slider, whether it is a proportion, and the numbers
    of the sheet that follow it, as they were; ``sheet``: those of all. ``left_out``: paths without a slider, and why.
    """

    sliders: tuple[Slider, ...]
    moved: Mapping[str, tuple[bool, Mapping[str, float]]]
    noted: CaseProgram
    sheet: Mapping[str, float]
    left_out: dict[str, str]

    @property
    def start(self) -> list[float]:
        """The values of the sliders in the run as it was."""
        return [slider.value for slider in self.sliders]

    @cached_property
    def targets(self) -> dict[str, tuple[float, tuple[int, ...]]]:
        """Paths of the sheet that change: a number times the values of some sliders, by their index."""
        found: dict[str, tuple[float, tuple[int, ...]]] = {}
        for k, slider in enumerate(self.sliders):
            shared, numbers = self.moved[slider.path]
            for path, start in numbers.items():
                base, others = found.get(path, (start, ()))
                found[path] = base if shared else 1.0, (*others, k)
        return found

    @cached_property
    def program(self) -> Program:
        """The program from the values of the sliders."""
        old, count = self.noted.program, len(self.sliders)
        known = [self.targets.get(path, (self.sheet[path], ())) for path in self.noted.paths]
        bases = [base for base, _ in known]
        first = count + len(bases) + len(old.constants)
        operations: list[tuple[Any, ...]] = []
        registers: list[int] = []
        for k, (base, sliders) in enumerate(known):
            factors = [*([] if sliders and base == 1.0 else [count + k]), *sliders]
            registers.append(factors[0])
            for factor in factors[1:]:
                operations.append(("mul", registers[k], factor))
                registers[k] = first + len(operations) - 1
        registers += range(count + len(bases), first)
        registers += range(first + len(operations), first + len(operations) + len(old.operations))
        operations += [(name, *(registers[k] for k in operands)) for name, *operands in old.operations]
        guards = tuple((relation, registers[a], registers[b]) for relation, a, b in old.guards)
        outputs = np.array(registers, dtype=np.intp)[old.outputs]
        return Program(count, np.array([*bases, *old.constants]), tuple(operations), outputs, guards)

    def holds(self, values: Sequence[float]) -> bool:
        """Whether the program holds for values of the sliders; elsewhere the page says so."""
        return bool(self.program(np.array([values], dtype=float))[1][0])

    def numbers(self, values: Sequence[float], run: str) -> Blocks:
        """The blocks of a run for values of the sliders."""
        (vector,) = self.program(np.array([values], dtype=float))[0]
        return {name: vector[_part(place)].reshape(place["shape"]) for name, place in self._places(run).items()}

    def _places(self, run: str) -> dict[str, Any]:
        return {
            name.removeprefix(f"{run} "): place
            for name, place in self.noted.places.items()
            if name.startswith(f"{run} ")
        }

    def entering(self, run: str, *blocks: str) -> set[str]:
        """The paths of sliders that change a block of a run whose name begins with one of ``blocks``."""
        places = [_part(place) for name, place in self._places(run).items() if name.startswith(blocks)]
        return {self.sliders[k].path for place in places for k in self.program.acting(place)}

    def without(self, paths: Mapping[str, str]) -> LiveMap:
        """The same without the sliders of these paths, for the reasons given, at whose values they stay."""
        kept = tuple(slider for slider in self.sliders if slider.path not in paths)
        return replace(self, sliders=kept, left_out=self.left_out | dict(paths))

    def changes(self, values: Sequence[float]) -> dict[str, float]:
        """What ``--set`` is to change for these values: of sliders that moved, path and value."""
        moved = [value != slider.value for slider, value in zip(self.sliders, values, strict=True)]
        return {
            path: float(np.prod([base, *(values[k] for k in sliders)]))
            for path, (base, sliders) in self.targets.items()
            if any(moved[k] for k in sliders)
        }

    def info(self) -> dict[str, Any]:
        """As plain data with arrays: what ``web/src/live/map.ts`` evaluates."""
        program, constants = self.program, len(self.program.constants)
        names = sorted({operation for operation, *_ in program.operations})
        code = [
            (names.index(name), own - operands[0], own - operands[-1])
            for own, (name, *operands) in enumerate(program.operations, program.inputs + constants)
        ]
        changing = np.flatnonzero((program.outputs < program.inputs) | (program.outputs >= program.inputs + constants))
        return {
            "paths": [slider.path for slider in self.sliders], "start": self.start,
            "constants": program.constants, "operations": names, "code": _whole(code, 3),
            "guards": _whole([_relation(*guard) for guard in program.guards], 3).T.copy(),
            "base": program(np.array([self.start]))[0][0],
            "moving": np.diff(_whole(np.stack([changing, program.outputs[changing]], axis=1), 2), prepend=np.int32(0)),
            "runs": {run: self._places(run) for run in ("reference", "real")},
        }  # fmt: skip


def _part(place: Mapping[str, Any]) -> NDArray[np.intp]:
    return np.arange(place["start"], place["start"] + int(np.prod(place["shape"])))


def _whole(rows: Any, width: int) -> NDArray[np.int32]:
    """Rows of whole numbers as columns (width, n), which take less room when packed."""
    return np.ascontiguousarray(np.array(rows, dtype=np.int32).reshape(-1, width).T)


def _relation(relation: str, a: int, b: int) -> tuple[int, int, int]:
    """A guard as the page has it: twice the place of ``<``, ``<=``, ``==`` or ``finite``; negated, one more."""
    isnt, relation = relation.startswith("not "), relation.removeprefix("not ")
    if relation == "!=":
        isnt, relation = not isnt, "=="
    elif relation[0] == ">":
        relation, a, b = relation.replace(">", "<"), b, a
    return 2 * ("<", "<=", "==", "finite").index(relation) + isnt, a, b


def live_map(
    pair: RobotPair,
    stations: tuple[float, ...] = (),
    ahead: Ahead | None = None,
    progress: Progress = lambda stage, share: None,
) -> LiveMap:
    """The map of a pair: a slider of every number of the sheet that is no structure, all by one program.

    ``stations``: places along each link of a robot of which its picture is made; ``ahead``: numbers whose sliders come
    first; ``progress``: is given ``report`` and its share. It is kept in the folder of compiled code, and found again
    where sheet, kinds and program are the same.
    """
    key = _key(pair, stations, ahead)
    progress("report", 0.0)
    if (kept := load(key)) is not None:
        found = _read(json.loads(kept))
    else:
        found = _bounded(_noted(_offered(pair, ahead), pair, stations))
        save(key, json.dumps(_written(found)).encode())
    progress("report", 1.0)
    return found


def origin(name: str) -> str:
    """What commands are given for a robot of this name: a published one, or its file."""
    return name if name in names() else f"{name}.yaml"


def _noted(every: LiveMap, pair: RobotPair, stations: tuple[float, ...]) -> LiveMap:
    """With the program of the numbers of a pair, and the sliders that it follows."""
    nominal, until = pair.nominal, whole_moves(pair.nominal, _LONGEST_MOVE)

    def blocks(both: Any) -> Blocks:
        robots = {"reference": (both.nominal, ())} if has_reference(nominal) else {}
        found: Blocks = {}
        for run, (robot, places) in {**robots, "real": (both.real, stations)}.items():
            numbers = run_numbers(robot, follow_of(nominal, run), until, places)
            found |= {f"{run} {name}": values for name, values in numbers.items()}
        return found

    laws = [f"`{one.name}`" for one in nominal.control if one.block.is_designed]
    structure = _DESIGNED.format(", ".join(laws), origin(nominal.name)) if laws else _STRUCTURE
    try:
        noted = case_program(nominal, every.sheet, lambda both: both, blocks)
    except Structural as error:
        noted, structure = _fixed(blocks(pair)), f"its numbers cannot be followed: {error}"
    why = {
        slider.path: structure for slider in every.sliders if not every.moved[slider.path][1].keys() <= {*noted.paths}
    }
    return replace(every, noted=noted).without(why)


def _fixed(blocks: Blocks) -> CaseProgram:
    """The program of numbers that nothing changes."""
    vector, places = whole({"real none": np.zeros(0), **blocks})
    return CaseProgram((), {}, Program(0, vector, (), np.arange(len(vector)), ()), places)


_HALVINGS = 8


def _bounded(every: LiveMap) -> LiveMap:
    """With sliders that go, each by itself, as far as the checks of the sheet and the structure of the program hold."""
    guards = every.program.part(np.zeros(0, dtype=np.intp), guarded=True)
    start, ends = np.array(every.start), np.array([(one.low, one.high) for one in every.sliders]).reshape(-1, 2)
    holds, fails = np.zeros(ends.shape), np.ones(ends.shape)
    share = fails
    for _ in range(1 + _HALVINGS):
        here = np.where(share == 1.0, ends, start[:, None] + share * (ends - start[:, None]))
        cases = np.repeat(start[None], ends.size, axis=0)
        cases[np.arange(ends.size), np.arange(ends.size) // 2] = here.ravel()
        right = guards(cases)[1].reshape(ends.shape)
        holds, fails = np.where(right, share, holds), np.where(right, fails, share)
        share = (holds + fails) / 2
        if right.all():
            break
    bounds = np.where(holds == 1.0, ends, start[:, None] + holds * (ends - start[:, None])).tolist()
    sliders = tuple(replace(one, low=low, high=high) for one, (low, high) in zip(every.sliders, bounds, strict=True))
    acting = every.program.acting(np.arange(len(every.program.outputs)))
    why = {one.path: _NO_EFFECT for k, one in enumerate(sliders) if k not in acting}
    why |= {one.path: _STRUCTURE for one in sliders if one.low == one.high}
    return replace(every, sliders=sliders).without(why)


def _written(found: LiveMap) -> dict[str, Any]:
    """What was found, as JSON holds it."""
    noted, program = found.noted, found.noted.program
    lists = program.constants.tolist(), program.operations, program.outputs.tolist(), program.guards
    return {
        "sliders": [asdict(slider) for slider in found.sliders], "moved": found.moved, "sheet": found.sheet,
        "left_out": found.left_out, "noted": [noted.paths, noted.fixed, noted.places],
        "program": [program.inputs, *lists],
    }  # fmt: skip


def _read(kept: dict[str, Any]) -> LiveMap:
    """The same as it was written."""
    inputs, constants, operations, outputs, guards = kept["program"]
    paths, fixed, places = kept["noted"]
    tuples = [tuple(map(tuple, rows)) for rows in (operations, guards)]
    program = Program(inputs, np.array(constants), tuples[0], np.array(outputs, dtype=np.intp), tuples[1])
    sliders = tuple(Slider(**one) for one in kept["sliders"])
    noted = CaseProgram(tuple(paths), fixed, program, places)
    return LiveMap(sliders, kept["moved"], noted, kept["sheet"], kept["left_out"])


def _key(pair: RobotPair, stations: tuple[float, ...], ahead: Ahead | None) -> str:
    """All that a map follows from: program, kinds, both sheets, stations and what comes first."""
    sheets = [robot.model_dump_json() for robot in (pair.nominal, pair.real)]
    program = source_digest((".",)), outside_digest(), np.__version__
    return "\n".join(["map", *program, *sheets, repr(stations), repr(ahead)])


def _offered(pair: RobotPair, ahead: Ahead | None) -> LiveMap:
    """Sliders to begin with, of no program; with a first factor a run would get a reference that is not here."""
    knobs = knobs_of(pair.nominal, ahead, others=True)
    sliders, left_out = sliders_of(pair.nominal, knobs, 2 * len(knobs), ahead=ahead), dict[str, str]()
    if not has_reference(pair.nominal) and any(one.real for one in sliders):
        sliders, left_out = [one for one in sliders if not one.real], {"real": _NOT_COMPARED}
    moved = {
        one.path: (knobs[one.knob].together and not one.real, one.changes(knobs[one.knob], one.value))
        for one in sliders
    }
    left_out |= dict.fromkeys(sample_lists(pair.nominal), _SAMPLES)
    every = LiveMap(tuple(sliders), moved, _fixed({}), {}, left_out)
    if pair.nominal.contact and not any(pair.nominal.contact.velocity):
        every = every.without({path: _DRAGS for path in moved if path.startswith("contact.velocity.")})
    every = every.without(
        dict.fromkeys(_following(pair.nominal, [path for _, own in moved.values() for path in own]), _FOLLOWS)
    )
    sheet = {path: base * math.prod(every.sliders[k].value for k in own) for path, (base, own) in every.targets.items()}
    return replace(every, sheet=sheet)


def _following(robot: Robot, paths: Sequence[str]) -> list[str]:
    """Those of some paths whose numbers follow from those of the others."""
    data = sheet_data(robot)
    steps = {tuple(steps_of(path, data)): path for path in paths}
    return [path for own, path in steps.items() if own in follows(robot, dict.fromkeys(steps.keys() - {own}, 1.0))]
