"""System: equations of motion stated by energies. Whatever has them is a robot, with everything that robots have.

A system names its coordinates and parameters, and gives its energies as functions that receive them as symbols and
return CasADi expressions::

    import casadi as ca, tmodes

    def kinetic(q, v, p):
        return p.M * v.cart**2 / 2 + ...

    pendulum = tmodes.System(name="cart_pole", coordinates={"cart": "m", "pole": "rad"}, parameters={"M": 1.0},
                             kinetic=kinetic, ...)

``q``, ``v`` and ``p`` give their members as attributes or by name (``q["cart"]``); ``p.g`` is the magnitude of the
robot's gravity [m/s^2] where the system has no parameter of that name.
"""

from __future__ import annotations

import hashlib
import keyword
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise
from typing import Any

import casadi as ca
import numpy as np
from numpy.typing import NDArray

from tmodes.chain.chain import Chain
from tmodes.equations.lagrange.as_sheet import system_data
from tmodes.errors import InputError, TmodesError, error_words
from tmodes.io.arguments import refuse_fields
from tmodes.kinds.noted.functions import norm, number
from tmodes.kinds.registry import Registry
from tmodes.sheet.robot import RECURSION, Robot

__all__ = [
    "GRAVITY",
    "ORIGIN",
    "SYSTEMS",
    "EquationTerms",
    "Expressions",
    "Members",
    "System",
    "SystemEnergies",
    "equation_terms",
]


class Members:
    """Symbols by name: ``q.cart``, ``q["cart"]``, or in order."""

    def __init__(self, names: Sequence[str], values: Any, of: str) -> None:
        self._values = {name: values[k] for k, name in enumerate(names)}
        self._of = of

    def __getitem__(self, name: str | int) -> Any:
        if isinstance(name, int):
            return [*self._values.values()][name]
        if name not in self._values:
            raise AttributeError(f"no {self._of} `{name}`; there are {', '.join(self._values)}")
        return self._values[name]

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return self[name]

    def __iter__(self) -> Iterator[Any]:
        return iter(self._values.values())

    def __len__(self) -> int:
        return len(self._values)


@dataclass(frozen=True)
class SystemEnergies:
    """Kinetic and potential energies [J], and Rayleigh's function [W], of a system in its coordinates."""

    kinetic: Any
    gravity: Any
    elastic: Any
    dissipation: Any


@dataclass(frozen=True)
class EquationTerms:
    """Terms of H q'' + h + g + f_elastic + f_damping = Q: H (n, n) and forces (n,), h without gravity.

    ``stiffness`` and ``swing`` (n, n): derivatives of the elastic forces by q, and of the dampers' by q'.
    """

    mass_matrix: Any
    inertial: Any
    gravity: Any
    elastic: Any
    damping: Any
    stiffness: Any
    swing: Any


def equation_terms(energy: SystemEnergies, q: Any, v: Any) -> EquationTerms:
    """d/dt (dT/dq') - dT/dq + dV/dq + dPhi/dq', sorted by what causes it.

    Of the 2010 robot these are its rows but for the gear's torque sigma, which is its drive's:

    Eq. (34) [corrected]: the row of q; the print repeats Hel1,1 for Hel1,2 and Hel1,3. {test_rows_are_lagrange}
    Eq. (35) [derived]: the row of delta. {test_rows_are_lagrange}
    Eq. (36) [derived]: the row of gamma, with + 1/2 eps12 - eps11 + sigma. {test_rows_are_lagrange}
    Eq. (37) [derived]: the row of vt, with eps11 - 1/2 eps12: the -1/2 follows from the energies. {test_half_coupling}
    Eq. (38) [derived]: the row of e. {test_rows_are_lagrange}
    Slip (34): Hel1,1 is repeated where Hel1,2 and Hel1,3 belong {test_slip_34_repeated_entry}
    Slip (18)-(19): with lm, le varying, the energies have geometric terms in rows vt and e that the print
    lacks {test_slip_18_geometric_terms}
    """
    momentum = ca.gradient(energy.kinetic, v)
    stiffness, elastic = ca.hessian(energy.elastic, q)
    swing, damping = ca.hessian(energy.dissipation, v)
    return EquationTerms(
        mass_matrix=ca.jacobian(momentum, v),
        inertial=ca.jtimes(momentum, q, v) - ca.gradient(energy.kinetic, q),
        gravity=ca.gradient(energy.gravity, q),
        elastic=elastic,
        damping=damping,
        stiffness=stiffness,
        swing=swing,
    )


Array = NDArray[np.float64]

GRAVITY = "g"
"""Parameter that every system has unless it defines its own: magnitude of the robot's gravity [m/s^2]."""

ORIGIN = "origin"
"""Where the world's axes are, as ``lines`` name it."""

UNITS = ("rad", "m")


@dataclass(frozen=True)
class Expressions:
    """A system at one state: symbols of coordinates, rates and parameters (columns), and what follows from them.

    ``points``: by name (position (3,) [m], rotation (3, 3) from the point's axes to the world's, None where it has
    none). ``map``: what carries a force on the first point to the coordinates, None for the point's own Jacobian.
    """

    q: Any
    v: Any
    p: Any
    energies: SystemEnergies
    terms: EquationTerms
    forces: Any
    points: dict[str, tuple[Any, Any]]
    map: Any


Law = Callable[..., Any]


@dataclass(frozen=True, eq=False)
class System:
    """A mechanical system with coordinates q, parameters p and energies in SI units.

    ``coordinates``: name -> unit (``rad`` or ``m``). ``parameters``: name -> value, which a robot's sheet may change.
    ``kinetic(q, v, p)`` [J], a quadratic form in the rates. ``gravity(q, p)`` and ``elastic(q, p)`` [J]: potential
    energies, apart because statics vary the weight. ``dissipation(q, v, p)`` [W]: Rayleigh's function, half of the
    power lost. ``forces(q, v, p)``: further generalized forces by coordinate name, on the right side. ``points(q, p)``:
    name -> position [m], or (position, rotation matrix); the first is the tip. ``inputs``: coordinates that a drive of
    the robot may act on; None: all of them. ``lines``: polylines to draw, each a sequence of names of points or
    ``origin``; None: one through all points, the tip last, from the origin where there is only one.

    ``numbers(chain)`` gives parameters that follow from a robot's own joints and links instead. ``directions`` (n, n):
    constant map from the robot's coordinates to those of the energies, where these are others, named ``own``.
    ``contact_map(q, p)`` (n, 3): carries a force on the first point to the equations instead of the Jacobian.

    >>> system = tmodes.System("bead", {"x": "m"}, {"m": 2.0}, lambda q, v, p: p.m * v.x**2 / 2)
    >>> tmodes.Model(system.robot()).mass_matrix([0.0])
    array([[2.]])
    """

    name: str
    coordinates: Mapping[str, str]
    parameters: Mapping[str, float]
    kinetic: Law
    gravity: Law | None = None
    elastic: Law | None = None
    dissipation: Law | None = None
    forces: Law | None = None
    points: Law | None = None
    inputs: tuple[str, ...] | None = None
    lines: Sequence[Sequence[str]] | None = None
    title: str = ""
    numbers: Callable[[Chain], Mapping[str, float]] | None = None
    own: tuple[str, ...] = ()
    directions: Array | None = None
    contact_map: Law | None = None
    matches: Callable[[Sequence[str]], Sequence[str]] | None = field(default=None)
    """Names of a robot's coordinates in the order of ``coordinates``, empty where it has none of that one."""

    def __post_init__(self) -> None:
        refuse_fields(self)
        if self.name == RECURSION:
            raise InputError("name", f"`{RECURSION}`", "another name", "choose a name of your own")
        for kind, names in (("coordinates", self.coordinates), ("parameters", self.parameters)):
            for name in names:
                if not name.isidentifier() or keyword.iskeyword(name) or name.startswith("_"):
                    hint = "write letters, digits and underscores"
                    raise InputError(f"{kind}.{name}", f"the name `{name}`", "a plain name", hint)
        for name, unit in self.coordinates.items():
            if unit not in UNITS:
                raise InputError(f"coordinates.{name}", f"the unit `{unit}`", "`rad` or `m`", "write one of these")
        if not self.coordinates:
            raise InputError("coordinates", "none", "at least one", 'write {"angle": "rad"}')

    def robot(self, *, joints: Mapping[str, Mapping[str, Any]] | None = None, **sheet: Any) -> Robot:
        """A robot that moves by these equations; the system is registered under its name for this process.

        Coordinates that ``drives`` (or a motor in ``joints``) name are driven, the others are free. ``sheet``: entries
        of a data sheet: drives, loads, contact, initial, integration, parameters, real, gravity, ... Raises
        :class:`tmodes.errors.InputErrors` for a wrong entry.

        >>> system = tmodes.System("rail", {"x": "m"}, {"m": 2.0}, lambda q, v, p: p.m * v.x**2 / 2)
        >>> system.robot(integration={"duration": 1.0, "output_step": 0.1}).name
        'rail'
        """
        SYSTEMS.register(self)
        own = {"name": self.name, "title": self.title, "equations": self.name}
        sheet["parameters"] = {**self.parameters, **sheet.get("parameters", {})}
        points = self.expressions.points
        return Robot.from_data(system_data(self.coordinates, self.inputs, points, joints or {}, own | sheet))

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.coordinates)

    @cached_property
    def parameter_names(self) -> tuple[str, ...]:
        """Names of the parameters, gravity's among them."""
        return (*self.parameters, *(() if GRAVITY in self.parameters else (GRAVITY,)))

    def values(self, chain: Chain) -> Array:
        """Parameters of a robot: the system's own, changed by the chain's, in the order of ``parameter_names``.

        >>> system = tmodes.System("sled", {"x": "m"}, {"m": 2.0}, lambda q, v, p: p.m * v.x**2 / 2)
        >>> system.values(system.robot().chain())
        array([2.  , 9.81])
        """
        known = {GRAVITY: number(norm(chain.gravity)), **self.parameters}
        known |= dict(self.numbers(chain)) if self.numbers else {}
        for name, value in chain.parameters.items():
            if name not in known:
                expected = f"one of {', '.join(self.parameter_names)}"
                raise InputError(f"parameters.{name}", "an unknown parameter", expected, "correct the name")
            known[name] = value
        return np.array([known[name] for name in self.parameter_names])

    @cached_property
    def expressions(self) -> Expressions:
        """The system's energies and equations as expressions, made once.

        Raises :class:`tmodes.errors.InputError` for a kinetic energy that is no quadratic form in the rates.
        """
        own = self.own or tuple(self.coordinates)
        q, v = (ca.SX.sym(name, self.size) for name in ("q", "v"))
        p = ca.SX.sym("p", len(self.parameter_names))
        at, moving = Members(own, q, "coordinate"), Members(own, v, "coordinate")
        numbers = Members(self.parameter_names, p, "parameter")
        kinetic = self._scalar("kinetic", at, moving, numbers)
        energies = SystemEnergies(
            kinetic=kinetic, gravity=self._scalar("gravity", at, numbers),
            elastic=self._scalar("elastic", at, numbers), dissipation=self._scalar("dissipation", at, moving, numbers),
        )  # fmt: skip
        terms = equation_terms(energies, q, v)
        self._check_kinetic(kinetic, terms, v)
        forces = self.forces(at, moving, numbers) if self.forces else {}
        pushed = ca.vertcat(*(ca.SX(forces.get(name, 0)) for name in own))
        points = {
            name: _point(name, value) for name, value in (self.points(at, numbers) if self.points else {}).items()
        }
        mapped = self.contact_map(at, numbers) if self.contact_map else None
        return Expressions(q, v, p, energies, terms, pushed, points, mapped)

    def _scalar(self, name: str, *given: Members) -> Any:
        """One of the energies; raises :class:`tmodes.errors.InputError` where its function gives no expression."""
        law = getattr(self, name)
        try:
            return ca.SX(law(*given)) if law else ca.SX(0)
        except TmodesError:
            raise
        except Exception as error:
            expected = "a function that gives an expression of its arguments"
            raise InputError(f"{self.name}: {name}", error_words(error), expected, "correct the function") from error

    @cached_property
    def segments(self) -> tuple[tuple[str, str], ...]:
        """Straight lines to draw, by the names of the points at their ends.

        Raises :class:`tmodes.errors.InputError` for a name in ``lines`` that no point has.
        """
        known = [*self.expressions.points]
        whole = [ORIGIN, *known] if len(known) == 1 else known[::-1]
        lines = [whole] if self.lines is None else self.lines
        for name in (name for line in lines for name in line if name not in (ORIGIN, *known)):
            expected = f"one of {', '.join([ORIGIN, *known])}"
            raise InputError(f"{self.name}: lines", f"`{name}`", expected, "name points of the system")
        return tuple(dict.fromkeys(pair for line in lines for pair in pairwise(line)))

    @cached_property
    def key(self) -> str:
        """All of the structure as a digest: two systems of the same key have the same compiled code."""
        e = self.expressions
        shown = [e.energies.kinetic, e.energies.gravity, e.energies.elastic, e.energies.dissipation, e.forces]
        shown += [ca.vec(ca.SX(part)) for point in e.points.values() for part in point if part is not None]
        shown += [] if e.map is None else [ca.vec(e.map)]
        function = ca.Function("system", [e.q, e.v, e.p], [ca.densify(ca.vertcat(*shown))], {"cse": True})
        constant = "" if self.directions is None else np.asarray(self.directions).tobytes().hex()
        digest = hashlib.sha256((str(ca.Function.serialize(function)) + constant).encode())
        return f"{self.name} {digest.hexdigest()[:24]}"

    def basis(self) -> Array:
        """Constant map from the robot's coordinates to those of the energies (n, n).

        >>> tmodes.System("cart", {"x": "m"}, {}, lambda q, v, p: v.x**2 / 2).basis()
        array([[1.]])
        """
        return np.eye(self.size) if self.directions is None else np.asarray(self.directions, dtype=float)

    def _check_kinetic(self, kinetic: Any, terms: EquationTerms, v: Any) -> None:
        if ca.depends_on(terms.mass_matrix, v):
            got, expected = "an energy that is not quadratic in the rates", "a quadratic form in the rates"
            raise InputError(f"{self.name}: kinetic", got, expected, "write sums of products of two rates")
        rest = kinetic - ca.dot(v, terms.mass_matrix @ v) / 2
        symbols = ca.symvar(rest)
        if symbols:
            found = ca.Function("rest", symbols, [rest])
            for values in np.random.default_rng(1).uniform(0.5, 1.5, (3, len(symbols))):
                whole = float(ca.Function("whole", symbols, [kinetic - rest])(*values))
                if abs(float(found(*values))) > 1e-9 * max(abs(whole), 1e-300):
                    got, expected = "terms linear in the rates, or without them", "a quadratic form in the rates"
                    hint = "state what moves by itself as a coordinate with a prescribed drive"
                    raise InputError(f"{self.name}: kinetic", got, expected, hint)


def _point(name: str, value: Any) -> tuple[Any, Any]:
    """Position (3,) and rotation (3, 3) or None, of what a system's ``points`` gave."""
    position, rotation = value if isinstance(value, tuple) and len(value) == 2 else (value, None)
    position = ca.vertcat(*position) if isinstance(position, (list, tuple)) else ca.SX(position)
    if position.shape != (3, 1):
        got = f"a position of shape {position.shape}"
        raise InputError(f"points.{name}", got, "three coordinates [m]", "write [x, y, z]")
    return position, None if rotation is None else ca.SX(rotation)


_HINT = "call `robot()` of the system first, as its script does"
SYSTEMS: Registry[System] = Registry("equations", System, reserved=(RECURSION,), hint=_HINT, replaces=True)
"""Systems that a robot was made of in this process, and the published ones, by name."""
