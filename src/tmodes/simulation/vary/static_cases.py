"""Robots of one structure at rest under their weight, all at once: sag of the tip, and natural frequencies there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.describe.links import link_masses
from tmodes.analysis.modes.modes import MotorState, moving_coordinates
from tmodes.analysis.statics.at_rest import first_commands, robot_rest
from tmodes.analysis.statics.equilibrium import Equilibrium, free_coordinates, starting_pose
from tmodes.analysis.statics.path import STRAY
from tmodes.analysis.statics.system import ROUNDING, SETTLED
from tmodes.kinds.noted.functions import array, number
from tmodes.model.model import Model
from tmodes.model.passes import PointMotion, derivatives, evaluate
from tmodes.sheet import Robot
from tmodes.simulation.loop import Blocks
from tmodes.simulation.vary.case_group import Indices
from tmodes.simulation.vary.programs import CaseProgram, case_program
from tmodes.simulation.vary.rests import inverses

__all__ = ["CaseStatics", "StaticCases", "masses_of"]

Array = NDArray[np.float64]

_STEPS = 20
"""Newton's steps."""

_CONTRACTS = 0.1
"""Step over the one before it up to which the slope is taken again."""

_SIDES = "inertia", "elastic"

_LITTLE = 1e-3
"""First step [rad, m] too short to leave a branch."""


class CaseStatics(NamedTuple):
    """Of m cases: ``sag`` (m, 3) [m], world axes, squared circular ``frequencies`` (m, modes), rising, and masses [kg].

    Not-a-number where no rest was found near that of the first case.
    """

    sag: Array
    squares: Array
    masses: Array


def masses_of(robot: Robot) -> dict[str, float]:
    """``mass``: of all that moves [kg]; ``mass.links``: of all beams; and that of each link."""
    each = link_masses(robot, robot.chain())
    found = {"mass": number(sum(mass for mass, _ in each.values()))}
    found["mass.links"] = number(sum(beam for _, beam in each.values()))
    return found | {f"mass.{name}": number(mass) for name, (mass, _) in each.items()}


@dataclass(frozen=True, eq=False)
class StaticCases:
    """k cases of a sheet: ``values`` (k,) of each path; ``first``: the actual robot of one, whose values are ``case``.

    Those for which the ``program`` does not hold have another structure: they are no cases of these.
    """

    sheet: Robot
    values: Mapping[str, Array]
    case: Mapping[str, float]
    first: Robot

    @cached_property
    def _model(self) -> Model:
        return Model(self.first.chain(), trials=True)

    @cached_property
    def _rest(self) -> Equilibrium:
        return robot_rest(self.first, model=self._model, sheet=False, contact=False)

    @cached_property
    def program(self) -> CaseProgram:
        """The program of their numbers. Raises :class:`tmodes.model.parameters.Structural` where there is none."""
        count = len(next(iter(self.values.values())))
        return case_program(self.sheet, self.case, lambda pair: pair.real, _blocks_of, count)

    def holding(self) -> tuple[StaticCases, Indices]:
        """The cases that the program holds for, and their indices."""
        which = np.flatnonzero(self.program.holds(self.values))
        made = replace(self, values={path: values[which] for path, values in self.values.items()})
        vars(made)["program"] = self.program
        return made, which

    def _numbers(self, which: Indices, *names: str) -> list[Array]:
        """Blocks of numbers of some cases, (m, ...) each."""
        return self.program.blocks(names, {path: values[which] for path, values in self.values.items()})

    @property
    def mass_names(self) -> tuple[str, ...]:
        """Names of the masses."""
        return tuple(masses_of(self.first))

    def found(self, which: Indices, *, rests: bool) -> CaseStatics:
        """The numbers of some cases; ``rests``: not the masses alone."""
        if not rests:
            none = np.full((len(which), 3), np.nan)
            return CaseStatics(none, none[:, :0], *self._numbers(which, "masses"))
        names = "masses", "chain", "weight", "start", "light", "rotors"
        masses, chain, weight, start, light, rotors = self._numbers(which, *names)
        q = self._rests(chain, weight, start)
        sag = self._tips(chain, weight, q) - self._tips(chain, weight, start)
        return CaseStatics(sag, self._squares(chain, weight, q, light, rotors), masses)

    def _tips(self, chain: Array, weight: Array, q: Array) -> Array:
        """The first point (m, 3) [m] in poses (m, nq)."""
        points = evaluate(chain, self._model.passes.schedule("inertia"), self._blocks(q, weight), len(q))["points"]
        return PointMotion.of(points).position[:, 0]

    @cached_property
    def _free(self) -> Indices:
        return free_coordinates(self._model, first_commands(self.first, self._model), ())

    def _rests(self, chain: Array, weight: Array, start: Array) -> Array:
        """Poses (m, nq) at rest, from the first case's on: held coordinates stand where they are held."""
        free, q = self._free, start.copy()
        if not len(free):
            return q
        loose = np.abs(self._rest.unloaded - self._start_of_first)[free].max() > ROUNDING
        if loose or not self._rest.stable or self._rest.lost_stability_at is not None:
            return np.full_like(q, np.nan)
        q[:, free] += (self._rest.q - self._start_of_first)[free]
        going, first, corrected, last = np.arange(len(q)), np.zeros(len(q)), np.zeros(len(q)), np.full(len(q), np.inf)
        inverse = np.zeros((len(q), len(free), len(free)))
        stale = np.ones(len(q), dtype=bool)
        for round_ in range(_STEPS):
            new = going[stale[going]]
            if len(new):
                inverse[new] = inverses(self._slopes(chain[new], weight[new], q[new]))
            step = (inverse[going] @ self._forces(chain[going], weight[going], q[going])[:, :, None])[..., 0]
            q[np.ix_(going, free)] -= step
            size = np.abs(step).max(axis=1)
            if round_:
                corrected[going] += size
            else:
                first[going] = size
            done = (size <= SETTLED * (1 + np.abs(q[going]).max(axis=1))) | ((size <= ROUNDING) & (size >= last[going]))
            stale[going] = size > _CONTRACTS * last[going]
            last[going] = size
            going = going[~done & np.isfinite(size)]
            if not len(going):
                break
        q[going] = np.nan
        q[(first > _LITTLE) & (corrected > STRAY * first)] = np.nan
        return q

    @cached_property
    def _start_of_first(self) -> Array:
        known = {k: v for k, v in self.first.initial.coordinates.items() if k in self._model.coordinates}
        return starting_pose(self._model, first_commands(self.first, self._model), known)

    def _blocks(self, q: Array, base: Array) -> dict[str, Array]:
        still = np.zeros_like(q)
        return {"q": q, "v": still, "a": still, "base": base}

    def _forces(self, chain: Array, weight: Array, q: Array) -> Array:
        """Forces (m, free) on the left side at rest."""
        blocks, passes = self._blocks(q, weight), self._model.passes
        found = [evaluate(chain, passes.schedule(name), blocks, len(q))["forces"] for name in _SIDES]
        return np.asarray(found[0] + found[1])[:, self._free]

    def _slopes(self, chain: Array, weight: Array, q: Array) -> Array:
        """Derivatives (m, free, free) of these by the coordinates."""
        free, count = self._free, len(q)
        many = {name: np.repeat(values, len(free), axis=0) for name, values in self._blocks(q, weight).items()}
        numbers, total = np.repeat(chain, len(free), axis=0), np.zeros((count, len(free), len(free)))
        units = {"q": np.tile(np.eye(q.shape[1])[free], (count, 1))}
        for name in _SIDES:
            schedule = self._model.passes.schedule(name)
            own = {label: many[label] for label in schedule.inputs}
            along = derivatives(numbers, schedule, own, units, len(numbers))["forces"][:, free]
            total += along.reshape(count, len(free), len(free)).swapaxes(1, 2)
        return total

    def _squares(self, chain: Array, weight: Array, q: Array, light: Array, rotors: Array) -> Array:
        """Squared circular frequencies (m, modes) of what moves with locked motors."""
        moving = moving_coordinates(self._rest, MotorState.LOCKED, {})
        if not len(moving):
            return np.zeros((len(q), 0))
        count, n = len(q), q.shape[1]
        many, units = np.repeat(q, len(moving), axis=0), np.tile(np.eye(n)[moving], (count, 1))
        blocks = self._blocks(many, np.repeat(light, len(moving), axis=0)) | {"a": units}
        inertia = self._model.passes.schedule("inertia")
        mass = evaluate(np.repeat(chain, len(moving), axis=0), inertia, blocks, len(many))["forces"]
        mass = mass.reshape(count, len(moving), n)[:, :, moving]
        mass = (mass + mass.swapaxes(1, 2)) / 2 + rotors[:, moving, None] * np.eye(len(moving))
        slopes = self._slopes(chain, weight, q)
        places = np.searchsorted(self._free, moving)
        stiffness = slopes[:, places][:, :, places]
        return _squares(mass, (stiffness + stiffness.swapaxes(1, 2)) / 2)


def _blocks_of(robot: Robot) -> Blocks:
    """The numbers of a robot."""
    model, masses = Model(robot.chain(), trials=True), masses_of(robot)
    known = {name: value for name, value in robot.initial.coordinates.items() if name in model.coordinates}
    return {
        "chain": model.parameters, "weight": model.at_rest(), "light": model.at_rest(gravity=0.0),
        "rotors": model.rotor_inertias, "start": starting_pose(model, first_commands(robot, model), known),
        "masses": array([*masses.values()]),
    }  # fmt: skip


def _squares(mass: Array, stiffness: Array) -> Array:
    """Eigenvalues (m, n) of K x = w^2 M x, rising, from 1/w^2: the low ones keep their digits.

    Not-a-number where K is not positive definite.
    """
    found = np.full(mass.shape[:2], np.nan)
    good = np.isfinite(stiffness).all(axis=(1, 2)) & np.isfinite(mass).all(axis=(1, 2))
    good = np.flatnonzero(good)
    good = good[(np.linalg.eigvalsh(stiffness[good]) > 0).all(axis=1)]
    if len(good):
        root = np.linalg.cholesky(stiffness[good])
        inner = np.linalg.solve(root, np.linalg.solve(root, mass[good]).swapaxes(1, 2))
        found[good] = 1 / np.linalg.eigvalsh((inner + inner.swapaxes(1, 2)) / 2)[:, ::-1]
    return found
