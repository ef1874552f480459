"""Numbers of many cases of one sheet that need no simulation: sag, natural frequencies, masses."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.analysis.modes.of_sheet import sheet_frequencies
from tmodes.analysis.statics.at_rest import robot_rest
from tmodes.analysis.statics.equilibrium import base_spin, steady_rates
from tmodes.errors import InputError, SimulationError
from tmodes.io.arguments import checked_arguments
from tmodes.io.words import nearest, several
from tmodes.model.model import Model
from tmodes.model.parameters import Structural
from tmodes.sheet import Robot
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.batch.executor import thread_count
from tmodes.simulation.case_results import CaseResults
from tmodes.simulation.vary.programs import refused_cases
from tmodes.simulation.vary.simulate import changes_of, checked
from tmodes.simulation.vary.static_cases import CaseStatics, StaticCases, masses_of
from tmodes.simulation.vary.values import changed_sheet

__all__ = ["StaticSlopes", "refuse_unknown_numbers", "static_numbers", "static_unit"]

Array = NDArray[np.float64]

_SAG = ("sag", "sag.x", "sag.y", "sag.z")
_FREQUENCY = re.compile(r"frequency\.locked\.([1-9][0-9]?)")
_BLOCK = 512
_FEW = 24
"""Cases up to which each is a sheet of its own."""

_MOST = 16
"""Programs of all cases."""


@checked_arguments
def static_numbers(
    sheet: Robot,
    vary: Mapping[str, ArrayLike],
    names: str | Sequence[str],
    *,
    threads: int | None = None,
    progress: Callable[[str, float], None] = lambda stage, share: None,
    wrong: str = "error",
) -> CaseResults:
    """Numbers of the actual robots of k cases; ``vary`` and ``wrong`` as of ``tmodes.simulation.vary.reduce.reduced``.

    The result has ``values`` (k,) by name, not-a-number where a case has none: it has no rest (``failed``), or the
    sheet takes no such number (``refused``).

    ``sag``: how far the weight moves the tip, motors held at their first command, and along the world's axes ``sag.x``,
    ``sag.y``, ``sag.z`` [m]; ``frequency.locked.1`` and on: natural frequencies about the rest, motors locked, of mass
    and stiffness alone, rising, damped or not [Hz]; ``mass``: of all that moves, ``mass.links``: of the beams, and
    ``mass.NAME`` of a link [kg]. Frequencies are those with the loads and the contact of the sheet.

    All cases of a structure at once by a program of their numbers, and, for frequencies, without loads,
    contact or steady motion; else sheet by sheet, which is slow.

    Raises :class:`tmodes.errors.InputError` or :class:`tmodes.errors.InputErrors` for wrong numbers and unknown names.
    """
    refuse_other(sheet)
    if wrong not in ("error", "row"):
        raise InputError("wrong", repr(wrong), "`error` or `row`", "leave it out")
    values = checked(vary)
    refused = refused_cases(sheet, values)
    if refused and wrong == "error":
        first = next(iter(refused))
        changed_sheet(sheet, changes_of(values, first), first)
    rows = _Rows(sheet, values, tuple(dict.fromkeys(several("names", names))), refused, thread_count(threads))
    rows.run(lambda share: progress("statics", share))
    rows.results.units |= {name: static_unit(name) for name in rows.names}
    return rows.results


def static_unit(name: str) -> str:
    """Unit of a number by its name."""
    return "m" if name in _SAG else "Hz" if _FREQUENCY.fullmatch(name) else "kg"


class StaticSlopes:
    """Exact derivatives of static numbers; what was noted for a case serves for others of its structure."""

    def __init__(self, names: Sequence[str]) -> None:
        self.modes = max((int(of[1]) for name in names if (of := _FREQUENCY.fullmatch(name))), default=0)
        self._known = list[StaticCases]()

    def at(self, sheet: Robot, case: Mapping[str, float], along: Mapping[str, Array]) -> dict[str, tuple[float, Array]]:
        """By name the value of a case and its slopes (k,), the paths moving ``along`` (k,).

        Empty where there are none: what moves is structure, no rest was found, or loads, contact or steady motion act
        on a robot whose frequencies are asked for.
        """
        for base in self._bases(sheet, case):
            try:
                one, which = base.holding(_single(case))
                fixed = any(along[path].any() for path in one.program.fixed)
                found = one.slopes(along, self.modes) if len(which) and not fixed else None
            except (Structural, SimulationError):
                break
            if found:
                self._known = [*dict.fromkeys([base, *self._known])]
                values, slopes = (_columns(one, each) for each in found)
                return {name: (float(values[name][0]), slope[0]) for name, slope in slopes.items()}
        return {}

    def _bases(self, sheet: Robot, case: Mapping[str, float]) -> Iterator[StaticCases]:
        """Those that may hold for a case, at last its own."""
        yield from (one for one in self._known if one.sheet is sheet)
        robot = sheet.with_(case).pair().real
        if case and not (self.modes and _is_moved(robot)):
            yield StaticCases(sheet, _single(case), case, robot)


def _single(case: Mapping[str, float]) -> dict[str, Array]:
    return {path: np.array([value]) for path, value in case.items()}


def _columns(cases: StaticCases, found: CaseStatics) -> dict[str, Array]:
    """All numbers by name, (m,), or their slopes, (m, k)."""
    modes = [f"frequency.locked.{k + 1}" for k in range(found.frequencies.shape[1])]
    return dict(zip([*_SAG, *modes, *cases.mass_names], np.moveaxis(np.concatenate(found, axis=1), 1, 0), strict=True))


class _Rows:
    """The rows of all cases, filled as they come."""

    def __init__(
        self,
        sheet: Robot,
        given: Mapping[str, Array],
        names: tuple[str, ...],
        refused: Mapping[int, str],
        threads: int,
    ) -> None:
        self.sheet, self.given, self.names, self.threads = sheet, given, names, threads
        size = len(next(iter(given.values())))
        self.results = CaseResults.of_all(size, "finished")
        self.results.values = {name: np.full(size, np.nan) for name in names}
        self.results.put(refused, "refused")
        self.done = np.zeros(0, dtype=np.int64)
        self.going = np.array([k for k in range(size) if k not in refused], dtype=np.int64)

    def _robot(self, index: int) -> Robot:
        return self.sheet.with_(changes_of(self.given, index)).pair().real

    def run(self, progress: Callable[[float], None]) -> None:
        """Fill all rows that are not refused."""
        if not len(self.going):
            return
        first = self._robot(int(self.going[0]))
        refuse_unknown_numbers(self.names, masses_of(first))
        whole = np.array([*self.given.values()])[:, self.going]
        left = self.going[np.isfinite(whole).all(axis=0)]
        for _ in range(_MOST):
            if len(left) <= _FEW:
                break
            done, held = self._at_once(left, progress)
            self.done = np.append(self.done, done)
            left = np.setdiff1d(left, held)
            if not len(held):
                break
        for count, index in enumerate(np.setdiff1d(self.going, self.done).tolist(), 1):
            self._one(index)
            progress((len(self.done) + count) / len(self.going))

    def _at_once(
        self, left: NDArray[np.int64], progress: Callable[[float], None]
    ) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
        """Fill rows by a program that is noted at the first; which have numbers, and which the program holds for."""
        none, first = np.zeros(0, dtype=np.int64), self._robot(int(left[0]))
        if any(_FREQUENCY.fullmatch(name) for name in self.names) and _is_moved(first):
            return none, none
        values, case = {path: own[left] for path, own in self.given.items()}, changes_of(self.given, int(left[0]))
        try:
            cases, which = StaticCases(self.sheet, values, case, first).holding(values)
        except Structural:
            return none, none
        held = left[which]
        rests = any(name in _SAG or _FREQUENCY.fullmatch(name) for name in self.names)
        blocks = [np.arange(k, min(k + _BLOCK, len(held))) for k in range(0, len(held), _BLOCK)]
        try:
            done = [self._fill(cases, blocks[0], held, rests=rests)]  # by which all code is made
            with ThreadPoolExecutor(self.threads, "tmodes-statics") as pool:
                for places in pool.map(lambda which: self._fill(cases, which, held, rests=rests), blocks[1:]):
                    done.append(places)
                    progress((len(self.done) + sum(map(len, done))) / len(self.going))
        except SimulationError:
            return none, none
        return np.concatenate(done), held

    def _fill(
        self, cases: StaticCases, which: NDArray[np.int64], usual: NDArray[np.int64], *, rests: bool
    ) -> NDArray[np.int64]:
        """Fill the rows of some cases; those that have numbers."""
        found = cases.found(which, rests=rests)
        columns = _columns(cases, found)
        good = np.ones(len(which), dtype=bool) if not rests else np.isfinite(found.sag).all(axis=1)
        if any(_FREQUENCY.fullmatch(name) for name in self.names):
            good &= np.isfinite(found.frequencies).all(axis=1)
        places = usual[which[good]]
        for name in self.names:
            self.results.values[name][places] = columns[name][good] if name in columns else np.nan
        return places

    def _one(self, index: int) -> None:
        """Fill the row of one case by its sheet."""
        robot = self._robot(index)
        found = masses_of(robot)
        try:
            if any(name in _SAG for name in self.names):
                travel = robot_rest(robot, sheet=False, contact=False).displacement()[0]
                found |= dict(zip(_SAG, (float(np.linalg.norm(travel)), *travel.tolist()), strict=True))
            if any(_FREQUENCY.fullmatch(name) for name in self.names):
                modes = sheet_frequencies(robot)["locked"]
                undamped = sorted(float(one) for mode in modes if (one := mode["undamped_frequency_Hz"]) is not None)
                found |= {f"frequency.locked.{k + 1}": frequency for k, frequency in enumerate(undamped)}
        except SimulationError as error:
            self.results.put({index: str(error)}, "failed")
        for name in self.names:
            self.results.values[name][index] = found.get(name, np.nan)


def _is_moved(robot: Robot) -> bool:
    """Whether more than weight acts on a robot about whose rest frequencies are."""
    moves = steady_rates(robot, Model(robot.chain())) or base_spin(robot) is not None
    return bool(robot.loads or robot.contact or moves)


def refuse_unknown_numbers(names: Sequence[str], masses: Mapping[str, float]) -> None:
    """Raise :class:`tmodes.errors.InputError` for a name that is none; ``masses`` of the robot by their names."""
    if not names:
        raise InputError("names", "none", "at least one", "write `sag`")
    known = [*_SAG, "frequency.locked.1", *masses]
    for name in names:
        if name not in known and not _FREQUENCY.fullmatch(name):
            close = nearest(name, known)
            hint = f"did you mean `{close}`?" if close else "write one of these names"
            raise InputError("names", f"the unknown number {name!r}", f"one of {', '.join(known)}", hint)
