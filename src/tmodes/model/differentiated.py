"""Derivatives of a robot's dynamics: along directions, in reverse, and all at once by those of the inverse dynamics.

The accelerations a(q, v, effort) solve ID(q, v, a) = forces, hence da/dq = -M^-1 dID/dq, da/dv = -M^-1 dID/dv and
da/deffort = M^-1 S: J. Carpentier, N. Mansard, Analytical Derivatives of Rigid Body Dynamics Algorithms, RSS (2018).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.mechanics import mechanics
from tmodes.errors import InputError, SimulationError
from tmodes.model.passes import Blocks, ChainPasses, derivatives
from tmodes.model.rows import StateRows, in_a_row, one_row

if TYPE_CHECKING:
    from tmodes.model.acceleration_table import AccelerationDerivatives, AccelerationTable
    from tmodes.model.derivatives import Columns, Differentiated

__all__ = ["DifferentiatedModel", "InverseDerivatives"]

Array = NDArray[np.float64]

_STILL = np.zeros(1)
_ALL = ("a", "q", "v")
_MANY = 300
"""States from which on tables of all columns are worth the seconds that it takes to make them."""

_INPUTS = ("q", "v", "effort", "given", "wrenches", "base", "parameters")


class InverseDerivatives(NamedTuple):
    """Derivatives (n, nq, nq) or (nq, nq) of the forces by accelerations, coordinates and rates [SI]."""

    a: Array
    q: Array
    v: Array


@dataclass(frozen=True, eq=False)
class DifferentiatedModel:
    """A robot's schedules with their derivatives. Arrays as :class:`tmodes.model.model.Model` has them."""

    chain: Chain
    trials: bool = field(default=False, kw_only=True, repr=False)
    """Whether its states are those that a computation tries: then what is not finite gives what is not finite."""

    _made: dict[Any, Any] = field(default_factory=dict, init=False, repr=False)

    def _rows(self, q: ArrayLike, v: ArrayLike) -> StateRows:
        return StateRows(q, v, self.passes.parts.size, finite=not self.trials)

    @cached_property
    def passes(self) -> ChainPasses:
        """The schedules of the chain's equations, with its numbers."""
        return ChainPasses(mechanics(self.chain))

    def forward_dynamics_jvp(
        self,
        q: ArrayLike,
        v: ArrayLike,
        effort: ArrayLike = 0.0,
        *,
        directions: Mapping[str, ArrayLike],
        given: ArrayLike = 0.0,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> Array:
        """Derivative of the accelerations along one direction for each state, shape of q.

        ``directions``: changes by the names of inputs ``q``, ``v``, ``effort``, ``given``, ``wrenches``, ``base``, each
        in the shape of that input; ``parameters`` (numbers,) changes those of the chain, in all states.

        >>> model.forward_dynamics_jvp([0, 0], [0, 0], directions={"effort": [1.0]}).round(4)
        array([3.3333, 0.    ])
        """
        rows, loaded = self._rows(q, v), wrenches is not None
        known = self._known(directions, loaded=loaded)
        blocks = self.passes.dynamic(rows, effort, given, base, wrenches)
        change = directions.get("parameters")
        named = known - {"parameters"}
        along = {name: rows.of(directions[name], blocks[name].shape[1], name) for name in named}
        change = None if change is None else one_row("parameters", change, len(self.passes.parameters))
        return rows.shaped(
            self._forward(loaded=loaded).along(self.passes.parameters, blocks, along, change=change)["a"]
        )

    def forward_dynamics_vjp(
        self,
        q: ArrayLike,
        v: ArrayLike,
        effort: ArrayLike = 0.0,
        *,
        weights: ArrayLike,
        by: Sequence[str] = ("q", "v", "effort", "parameters"),
        given: ArrayLike = 0.0,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> dict[str, Array]:
        """Derivatives of sum(weights * accelerations) by the inputs named in ``by``, each in the shape of its rows.

        ``weights``: shape of q. The inputs are those of :meth:`forward_dynamics_jvp`; ``parameters`` (numbers,) sums
        over all states. One sweep in reverse gives them all.

        >>> model.forward_dynamics_vjp([0, 0], [0, 0], weights=[1, 0], by=["effort"])["effort"].round(4)
        array([3.3333])
        """
        rows, loaded = self._rows(q, v), wrenches is not None
        names = self._known(by, loaded=loaded)
        blocks = self.passes.dynamic(rows, effort, given, base, wrenches)
        seeds = {"a": rows.of(weights, self.passes.parts.size, "weights")}
        found = self._forward(loaded=loaded).back(self.passes.parameters, blocks, seeds, sorted(names))
        return {name: value if name == "parameters" else rows.shaped(value) for name, value in found.items()}

    def forward_dynamics_derivatives(
        self,
        q: ArrayLike,
        v: ArrayLike,
        effort: ArrayLike = 0.0,
        *,
        given: ArrayLike = 0.0,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> AccelerationDerivatives:
        """Derivatives of the accelerations at one state q, v (nq,), exact; rows of prescribed joints are zero.

        Raises :class:`tmodes.errors.SimulationError` where the mass matrix is not positive definite.

        >>> model.forward_dynamics_derivatives([0, 0], [0, 0]).effort.shape
        (2, 1)
        """
        passes, parts, loaded = self.passes, self.passes.parts, wrenches is not None
        state = self._state(q, v, base, wrenches)
        drives = {
            "effort": one_row("effort", effort, len(parts.efforts)),
            "given": one_row("given", given, len(parts.given)),
            "step": _STILL,
        }
        inputs = in_a_row(state | drives, passes.schedule("forward", loaded=loaded).inputs)
        forward, columns = self._columns("forward", (), loaded=loaded), self._columns("inertia", _ALL, loaded=loaded)
        if parts.held:
            a = forward.values(passes.parameters, inputs)
            return self._solved(state | {"a": a}, loaded=loaded)
        table = self._kept(("table", loaded), lambda: self._table(forward, columns))
        right, failed = table.solved(inputs)
        return self._info(right, failed, columns)

    def _table(self, forward: Columns, inertia: Columns) -> AccelerationTable:
        from tmodes.model.acceleration_table import AccelerationTable

        passes, elastic = self.passes, self._columns("elastic", ("q", "v"))
        return AccelerationTable(
            passes.parameters, forward, inertia, elastic, passes.rotor_inertias, passes.parts.driven
        )

    def _state(self, q: ArrayLike, v: ArrayLike, base: ArrayLike | None, wrenches: ArrayLike | None) -> Blocks:
        """One state by the names of the inputs."""
        size = self.passes.parts.size
        state = {"q": one_row("q", q, size, scalar=False), "v": one_row("v", v, size)}
        state["base"] = self._still if base is None else one_row("base", base, len(self._still), scalar=False)
        if wrenches is not None:
            state["wrenches"] = one_row("wrenches", wrenches, 6 * len(self.passes.parts.points), scalar=False)
        return state

    @cached_property
    def _still(self) -> Array:
        return self.passes.at_rest()

    def _known(self, names: Any, *, loaded: bool) -> set[str]:
        known = [name for name in _INPUTS if loaded or name != "wrenches"]
        for name in names:
            if name not in known:
                hint = "give `wrenches` as well, be they zero" if name == "wrenches" else "correct the name"
                raise InputError("directions", f"`{name}`", f"names among {', '.join(known)}", hint)
        return set(names)

    def _forward(self, *, loaded: bool) -> Differentiated:
        return self._kept(("forward", loaded), lambda: self._differentiated("forward", loaded=loaded))

    def _differentiated(
        self, name: str, outputs: Sequence[str] | None = None, *, loaded: bool = False
    ) -> Differentiated:
        from tmodes.model.derivatives import differentiated

        return differentiated(self.passes.schedule(name, loaded=loaded), outputs)

    def _kept(self, key: Any, make: Callable[[], Any]) -> Any:
        if key not in self._made:
            self._made[key] = make()
        return self._made[key]

    def _columns(self, name: str, by: tuple[str, ...], *, loaded: bool = False) -> Columns:
        """Derivatives of the forces, or of the accelerations, by inputs of all coordinates."""

        def make() -> Columns:
            of = self._differentiated(name, ["a" if name == "forward" else "forces"], loaded=loaded)
            bodies = self.passes.parts.bodies()
            # The columns of the mass matrix stand in their own order: it is solved with as it comes.
            return of.columns([(label, sorted(bodies) if label == "a" else bodies) for label in by])

        return self._kept((name, loaded, by), make)

    def inverse_dynamics_derivatives(
        self,
        q: ArrayLike,
        v: ArrayLike,
        a: ArrayLike,
        *,
        wrenches: ArrayLike | None = None,
        base: ArrayLike | None = None,
    ) -> InverseDerivatives:
        """Exact derivatives of the forces of :meth:`tmodes.Model.inverse_dynamics` by ``a``, ``q`` and ``v`` [SI].

        States (n, nq) or (nq,), ``wrenches`` (n, points, 6) do not change with them.

        >>> model.inverse_dynamics_derivatives([0, 0], [0, 0], [0, 0]).q.round(9)
        array([[ 100. , -100. ],
               [-100. ,  109.8]])
        """
        rows, size = self._rows(q, v), self.passes.parts.size
        still = np.broadcast_to(self._still, (rows.count, len(self._still)))
        states = {"q": rows.q, "v": rows.v, "a": rows.of(a, size, "a")}
        states["base"] = still if base is None else rows.of(base, still.shape[1], "base")
        if wrenches is not None:
            states["wrenches"] = rows.of(wrenches, 6 * len(self.passes.parts.points), "wrenches")
        parts = (self._tabled if rows.count >= _MANY else self._inverses)(states, _ALL, loaded=wrenches is not None)
        return InverseDerivatives(*(part[0] for part in parts) if rows.single else parts)

    def _inverse(self, state: Blocks, by: tuple[str, ...], *, loaded: bool) -> list[Array]:
        """Derivatives of all forces on the left side by the inputs named, each (nq, nq), along one coordinate a row."""
        return [one[0] for one in self._inverses({name: row[None] for name, row in state.items()}, by, loaded=loaded)]

    def _inverses(self, states: Blocks, by: tuple[str, ...], *, loaded: bool) -> list[Array]:
        """The same of many states, each (states, nq, nq)."""
        passes, n, states_ = self.passes, self.passes.parts.size, len(states["q"])
        found = np.zeros((len(by), states_, n, n))
        for name in ("inertia", "elastic"):
            schedule = passes.schedule(name, loaded=loaded and name == "inertia")
            wanted = [label for label in by if label != "a" or name == "inertia"]
            each = n * len(wanted)
            blocks = {label: np.repeat(states[label], each, axis=0) for label in schedule.inputs}
            units = {label: np.zeros((states_, each, n)) for label in wanted}
            for k, label in enumerate(wanted):
                units[label][:, n * k : n * (k + 1)] = np.eye(n)
            flat = {label: unit.reshape(states_ * each, n) for label, unit in units.items()}
            forces = derivatives(passes.parameters, schedule, blocks, flat, states_ * each)["forces"]
            forces = forces.reshape(states_, each, n)
            for k, label in enumerate(wanted):
                found[by.index(label)] += forces[:, n * k : n * (k + 1)].transpose(0, 2, 1)
        if "a" in by:
            found[by.index("a")] += np.diag(passes.rotor_inertias)
        return [*found]

    def _tabled(self, states: Blocks, by: tuple[str, ...], *, loaded: bool) -> list[Array]:
        """The same, eight directions at once, by tables that are worth making for many states."""
        from tmodes.compile.ir.linear_solve import aligned, padded

        columns, count, n = self._columns("inertia", _ALL, loaded=loaded), len(states["q"]), self.passes.parts.size
        found, rows = np.empty((len(by), count, n, n)), aligned(n, len(_ALL) * padded(n))
        for k in range(count):
            self._fill(rows, {name: own[k] for name, own in states.items()}, loaded=loaded)
            for label, part in zip(by, found, strict=True):
                part[k] = rows[:, columns.place[label]]
        return [*found]

    def _fill(self, found: Array, state: Blocks, *, loaded: bool) -> None:
        """The same by all, into an array, with columns of zeros between those of one input and the next."""
        from tmodes.compile.ir.linear_solve import padded

        passes = self.passes
        inputs = in_a_row(state, passes.schedule("inertia", loaded=loaded).inputs)
        self._columns("inertia", _ALL, loaded=loaded).at(passes.parameters, inputs, found)
        elastic = self._columns("elastic", ("q", "v"))
        if elastic.calls:
            there = np.empty((len(found), elastic.width))
            elastic.at(passes.parameters, in_a_row(state, passes.schedule("elastic").inputs), there)
            found[:, padded(len(found)) :] += there
        rows = np.arange(len(found))
        found[rows, rows] += passes.rotor_inertias

    def _solved(self, state: Blocks, *, loaded: bool) -> AccelerationDerivatives:
        """M^-1 times the derivatives of the forces, of a robot with prescribed joints, which stay as they are."""
        from tmodes.compile.ir.linear_solve import aligned, eliminate, padded

        parts = self.passes.parts
        size, driven, width = len(state["q"]), len(parts.driven), 3 * padded(len(state["q"]))
        rows = aligned(size, width + padded(driven))
        self._fill(rows[:, :width], state, loaded=loaded)
        rows[parts.driven, range(width, width + driven)] = -1.0
        rows[parts.held], rows[:, parts.held] = 0.0, 0.0
        rows[parts.held, parts.held] = 1.0
        failed = eliminate(rows)
        return self._info(np.negative(rows[:, padded(size) :]), failed, self._columns("inertia", _ALL, loaded=loaded))

    def _info(self, right: Array, failed: int, columns: Columns) -> AccelerationDerivatives:
        """Solutions by name; ``failed``: the number, from 1, of the coordinate in which there is none."""
        from tmodes.compile.ir.linear_solve import padded
        from tmodes.model.acceleration_table import AccelerationDerivatives

        parts, first = self.passes.parts, padded(len(right))
        if failed:
            raise SimulationError(
                f"the mass matrix is not positive definite in coordinate {parts.names[failed - 1]}; give what it "
                "moves a mass and an inertia"
            )
        places = (columns.place[name] for name in ("q", "v"))
        q, v = (slice(at.start - first, at.stop - first) if isinstance(at, slice) else at - first for at in places)
        return AccelerationDerivatives(right[:, q], right[:, v], right[:, 2 * first : 2 * first + len(parts.driven)])
