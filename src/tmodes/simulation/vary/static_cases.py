"""Robots of one structure at rest under their weight, all at once: sag of the tip, and natural frequencies there."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, NamedTuple

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
from tmodes.model.passes import PointMotion, derivatives, evaluate, second_derivatives
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

_BLOCKS = "masses", "chain", "weight", "start", "light", "rotors"

_TIP = slice(9, 12)
"""The position of the first point among the points' numbers."""

_SAME = 1e-8
"""Share by which squared frequencies differ that coincide."""

_LITTLE = 1e-3
"""First step [rad, m] too short to leave a branch."""


class CaseStatics(NamedTuple):
    """Of m cases: ``sag`` (m, 4) [m], how far and along world axes, ``frequencies`` (m, modes) [Hz], ``masses`` [kg].

    Not-a-number where no rest was found near that of the first case. Of derivatives the last axis says by what.
    """

    sag: Array
    frequencies: Array
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

    def holding(self, values: Mapping[str, Array]) -> tuple[StaticCases, Indices]:
        """The cases of some ``values`` (k,) that the program holds for, and their indices."""
        which = np.flatnonzero(self.program.holds(values))
        made = replace(self, values={path: own[which] for path, own in values.items()})
        vars(made).update({name: one for name, one in vars(self).items() if name not in vars(made)})
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
            none = np.full((len(which), 4), np.nan)
            return CaseStatics(none, none[:, :0], *self._numbers(which, "masses"))
        return self._at_rest(which)[0]

    def _at_rest(self, which: Indices) -> tuple[CaseStatics, dict[str, Array], Array, Array, Array]:
        """The numbers of some cases; their blocks, poses (m, nq) at rest, squared frequencies and shapes there."""
        of: dict[str, Array] = dict(zip(_BLOCKS, self._numbers(which, *_BLOCKS), strict=True))
        chain, weight, start = of["chain"], of["weight"], of["start"]
        q = self._rests(chain, weight, start)
        sag = self._tips(chain, weight, q) - self._tips(chain, weight, start)
        squares, shapes = self._modes(chain, weight, q, of["light"], of["rotors"])
        sags, frequencies = np.column_stack([np.linalg.norm(sag, axis=1), sag]), np.sqrt(squares) / (2 * np.pi)
        return CaseStatics(sags, frequencies, of["masses"]), of, q, squares, shapes

    def slopes(self, along: Mapping[str, Array], modes: int) -> tuple[CaseStatics, CaseStatics] | None:
        """The numbers of the only case, and their exact derivatives along k directions; None: it has none.

        ``along`` (k,): how the value of each path moves. The rest moves by K q' = -f', and the lowest ``modes`` by
        (w^2)' = x^T (K' - w^2 M') x with their shapes x, where K' has the motion of the rest (R. L. Fox, M. P. Kapoor,
        AIAA Journal 6, 1968, 2426). Squares that coincide move by the eigenvalues of the small problem of their shapes;
        as rising values they may have a kink there, and the mean of the derivatives on both sides is given.
        """
        values, of, q, squares, shapes = self._at_rest(np.zeros(1, np.intp))
        ways = np.stack([along[k] for k in self.program.paths])
        rates = self.program.slopes(_BLOCKS, self.values)
        by = {name: (one @ ways).T[:, None] for name, one in zip(_BLOCKS, rates, strict=True)}
        modes = min(modes, squares.shape[1])
        while 0 < modes < squares.shape[1] and _coincide(squares[0])[modes - 1]:
            modes += 1
        squares, shapes = squares[0, :modes], shapes[0, :, :modes]
        if not (np.isfinite(values.sag).all() and np.isfinite(squares).all()):
            return None
        nothing = np.zeros((1, q.shape[1]))

        def second(
            name: str, base: str, pose: Array, moved: Array, turn: Array = nothing, push: Array = nothing
        ) -> Any:
            """Outputs (k, modes, 4, size) of a pass along directions of its coordinates, and as its numbers move."""
            blocks = {"parameters": (of["chain"], 0.0, by["chain"]), "base": (of[base], 0.0, by[base]),
                      "q": (pose, turn, moved), "a": (0.0, push, 0.0)}  # fmt: skip
            shape = len(by["chain"]), max(len(turn), len(push))
            return second_derivatives(self._model.passes.schedule(name), shape, blocks)

        start, moved, free = by["start"], by["start"].copy(), self._free
        forces = np.sum([second(name, "weight", q, start)["forces"][:, 0, 2, free] for name in _SIDES], axis=0)
        moved[:, 0, free] -= np.linalg.solve(self._slopes(of["chain"], of["weight"], q)[0], forces.T).T
        tip, unloaded = (second("inertia", "weight", *pose)["points"][:, 0, 2, _TIP].T
                         for pose in ((q, moved), (of["start"], start)))  # fmt: skip
        length, sag = values.sag[0, 0], tip - unloaded
        whole = values.sag[0, 1:] @ sag / length if length else np.zeros(len(start))
        x = np.zeros((max(modes, 1), q.shape[1]))
        x[:modes, self._moving] = shapes.T
        turned = np.sum([second(name, "weight", q, moved, x)["forces"][:, :, 3] for name in _SIDES], axis=0)
        pushed = second("inertia", "light", q, moved, nothing, x)["forces"][:, :, 3] + by["rotors"] * x
        found = _moved_squares(squares, (turned - squares[:, None] * pushed) @ x.T)
        frequencies = found / (4 * np.pi * np.sqrt(squares))[:, None]
        return values, CaseStatics(np.vstack([whole, sag])[None], frequencies[None], np.moveaxis(by["masses"], 0, 2))

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

    @cached_property
    def _moving(self) -> Indices:
        """What moves with locked motors."""
        return moving_coordinates(self._rest, MotorState.LOCKED, {})

    def _modes(self, chain: Array, weight: Array, q: Array, light: Array, rotors: Array) -> tuple[Array, Array]:
        """Squared circular frequencies (m, modes) of what moves with locked motors, and shapes (m, moving, modes)."""
        moving, count, n = self._moving, len(q), q.shape[1]
        if not len(moving):
            return np.zeros((count, 0)), np.zeros((count, 0, 0))
        many, units = np.repeat(q, len(moving), axis=0), np.tile(np.eye(n)[moving], (count, 1))
        blocks = self._blocks(many, np.repeat(light, len(moving), axis=0)) | {"a": units}
        inertia = self._model.passes.schedule("inertia")
        mass = evaluate(np.repeat(chain, len(moving), axis=0), inertia, blocks, len(many))["forces"]
        mass = mass.reshape(count, len(moving), n)[:, :, moving]
        mass = (mass + mass.swapaxes(1, 2)) / 2 + rotors[:, moving, None] * np.eye(len(moving))
        slopes = self._slopes(chain, weight, q)
        places = np.searchsorted(self._free, moving)
        stiffness = slopes[:, places][:, :, places]
        return _modes(mass, (stiffness + stiffness.swapaxes(1, 2)) / 2)


def _blocks_of(robot: Robot) -> Blocks:
    """The numbers of a robot."""
    model, masses = Model(robot.chain(), trials=True), masses_of(robot)
    known = {name: value for name, value in robot.initial.coordinates.items() if name in model.coordinates}
    return {
        "chain": model.parameters, "weight": model.at_rest(), "light": model.at_rest(gravity=0.0),
        "rotors": model.rotor_inertias, "start": starting_pose(model, first_commands(robot, model), known),
        "masses": array([*masses.values()]),
    }  # fmt: skip


def _modes(mass: Array, stiffness: Array) -> tuple[Array, Array]:
    """Eigenvalues (m, n) of K x = w^2 M x, rising, from 1/w^2: the low ones keep their digits; and x, x^T M x = 1.

    Not-a-number where K is not positive definite.
    """
    found, shapes = np.full(mass.shape[:2], np.nan), np.full(mass.shape, np.nan)
    good = np.isfinite(stiffness).all(axis=(1, 2)) & np.isfinite(mass).all(axis=(1, 2))
    good = np.flatnonzero(good)
    good = good[(np.linalg.eigvalsh(stiffness[good]) > 0).all(axis=1)]
    if len(good):
        root = np.linalg.cholesky(stiffness[good])
        inner = np.linalg.solve(root, np.linalg.solve(root, mass[good]).swapaxes(1, 2))
        inverse, ways = np.linalg.eigh((inner + inner.swapaxes(1, 2)) / 2)
        found[good] = 1 / np.where(inverse > 0, inverse, np.nan)[:, ::-1]
        shapes[good] = np.linalg.solve(root.swapaxes(1, 2), ways[:, :, ::-1]) * np.sqrt(found[good])[:, None]
    return found, shapes


def _coincide(squares: Array) -> Any:
    """Which squares (modes,) coincide with the next one."""
    return np.diff(squares) <= _SAME * squares[1:]


def _moved_squares(squares: Array, small: Array) -> Array:
    """Derivatives (modes, k) of squares from X^T (K' - w^2 M') X of their shapes X, (k, modes, modes)."""
    found = np.diagonal(small, axis1=1, axis2=2).T.copy()
    for group in np.split(np.arange(len(squares)), np.flatnonzero(~_coincide(squares)) + 1):
        own = small[:, group][:, :, group]
        sides = np.linalg.eigvalsh((own + own.swapaxes(1, 2)) / 2).T
        found[group] = (sides + sides[::-1]) / 2
    return found
