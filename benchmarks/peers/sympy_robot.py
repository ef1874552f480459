"""The seed's robot derived with SymPy from its energies: what a careful user of SymPy would write.

State y = [phi, phi'], phi = [q, delta, gamma, vt, e, theta] [rad]. The motor is under the local PD law (41) and the
reference is a polynomial row ``[t_start, c0, c1, c2]``. Equation numbers are those of Filipovic & Djuric (2010).
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import sympy as sp

Reading = Literal["printed", "consistent"]
Rhs = Callable[[float, Sequence[float], Sequence[float]], list[float]]

PHI = sp.symbols("q delta gamma vt e theta", real=True)
RATES = sp.symbols("qt deltat gammat vtt et thetat", real=True)
T, VOLTAGE = sp.symbols("t u", real=True)
ROW = sp.symbols("t_start c0 c1 c2", real=True)
_LETTERS = "l1 l2 m Jzz g mel1 mel2 Jel1 Jel2 Cs1 Bs1 Cs2 Bs2 Cxi Bxi R CE CM I Bm Klp Klv me be Fc0 ka1 mu veps"
P: dict[str, sp.Symbol] = {symbol.name: symbol for symbol in sp.symbols(_LETTERS, positive=True)}
NAMES = tuple(P)


def _along(expression: Any, held: tuple[sp.Symbol, ...] = ()) -> sp.Expr:
    """Time derivative along the rates, the coordinates in ``held`` held fixed."""
    return sp.Add(*[sp.diff(expression, x) * v for x, v in zip(PHI, RATES, strict=True) if x not in held])


def _points() -> tuple[sp.Matrix, sp.Matrix]:
    """Tips of mode 1 and mode 2 [m], Eq. (42)."""
    q, delta, _, vt, e, _ = PHI
    lm, le = P["l1"] * sp.cos(vt), P["l2"] * sp.cos(vt + e)
    first = sp.Matrix([lm * sp.cos(q), lm * sp.sin(q), P["l1"] * sp.sin(vt)])
    arm = sp.Matrix([le * sp.cos(q + delta), le * sp.sin(q + delta), P["l2"] * sp.sin(vt + e)])
    return first, first + arm


def _radius_in_plane() -> tuple[sp.Expr, sp.Expr]:
    """Horizontal radii of both points in the vertical plane of the printed reading [m]."""
    _, _, _, vt, e, _ = PHI
    return P["l1"] * sp.cos(vt), P["l1"] * sp.cos(vt) + P["l2"] * sp.cos(vt + e)


def _speed_squared(point: sp.Matrix, radius: sp.Expr, reading: Reading) -> sp.Expr:
    """Squared speed of a point mass; the printed reading adds a horizontal and a vertical plane motion."""
    if reading == "consistent":
        return sp.Add(*[_along(c) ** 2 for c in point])
    horizontal = sp.Add(*[_along(c, held=(PHI[3], PHI[4])) ** 2 for c in point[:2]])
    return horizontal + _along(radius) ** 2 + _along(point[2]) ** 2


def kinetic(reading: Reading) -> sp.Expr:
    """Kinetic energy [J], Eq. (14)."""
    qt, dt, gt, vtt, et, tht = RATES
    squares = [_speed_squared(p, r, reading) for p, r in zip(_points(), _radius_in_plane(), strict=True)]
    rotary1 = (sp.Rational(3, 2) * qt - gt / 2) ** 2 + (sp.Rational(3, 2) * vtt) ** 2
    azimuth = sp.Rational(3, 4) * qt + sp.Rational(3, 2) * dt + gt / 4
    rotary2 = azimuth**2 + (sp.Rational(3, 4) * vtt + sp.Rational(3, 2) * et) ** 2
    masses = P["mel1"] * squares[0] + (P["m"] + P["mel2"]) * squares[1]
    return (masses + P["Jel1"] * rotary1 + (P["Jzz"] + P["Jel2"]) * rotary2 + P["I"] * tht**2) / 2


def gravity() -> sp.Expr:
    """Potential energy of gravity [J], Eq. (15)."""
    first, second = _points()
    return P["g"] * (P["mel1"] * first[2] + (P["m"] + P["mel2"]) * second[2])


def spring_form(angles: Sequence[sp.Symbol], letter: str, reading: Reading) -> sp.Expr:
    """Elastic energy [J] of the coordinates (letter C) or Rayleigh function [W] of the rates (B), Eqs. (16)-(25)."""
    q, delta, gamma, vt, e, theta = angles
    l1, l2 = P["l1"], P["l2"]
    full = reading == "consistent"
    lm, le = (l1 * sp.cos(PHI[3]), l2 * sp.cos(PHI[3] + PHI[4])) if full else (l1, l2)
    bend1 = l1**2 * vt**2 + lm**2 * (q - gamma) ** 2
    bend2 = l2**2 * (e - vt / 2) ** 2 + le**2 * (delta - (q - gamma) / 2) ** 2
    return (P[letter + "s1"] * bend1 + P[letter + "s2"] * bend2 + P[letter + "xi"] * (gamma - theta) ** 2) / 2


def _by(expression: Any, variables: Sequence[sp.Symbol]) -> sp.Matrix:
    return sp.Matrix([sp.diff(expression, x) for x in variables])


@dataclass(frozen=True)
class Contact:
    """Tip force on the environment F = (mass . phi'' + rest) direction [N] and its generalised force A F."""

    mass: sp.Matrix
    rest: sp.Expr
    direction: sp.Matrix
    map: sp.Matrix


def _contact(reading: Reading) -> Contact:
    """Radial force of the environment, friction with its sign, and the contact map of the reading."""
    point, jacobian = _points()[1], _points()[1].jacobian(PHI)
    kappa = sp.sqrt(point.dot(point))
    normal, velocity = point / kappa, jacobian * sp.Matrix(RATES)
    rate = normal.dot(velocity)
    drift = normal.dot(sp.Matrix([_along(c) for c in velocity])) + (velocity.dot(velocity) - rate**2) / kappa
    rest = P["me"] * drift + P["be"] * rate + P["Fc0"] + P["ka1"] * (kappa - P["l1"] - P["l2"])
    direction = normal + P["mu"] * velocity / sp.sqrt(velocity.dot(velocity) + P["veps"] ** 2)
    generalised = jacobian.T if reading == "consistent" else _printed_map(point, jacobian)
    return Contact(P["me"] * (jacobian.T * normal), rest, direction, generalised)


def _printed_map(point: sp.Matrix, jacobian: sp.Matrix) -> sp.Matrix:
    """Planar Jacobian blocks, shape (6, 3): F_x enters both planes, as in the paper."""
    x, y, _ = point
    plane = sp.Matrix([_radius_in_plane()[1], point[2]]).jacobian(PHI[3:5])
    radial = sp.Matrix([[x, y, 0], [0, 0, sp.sqrt(x**2 + y**2)]]) / sp.sqrt(x**2 + y**2)
    matrix = sp.zeros(6, 3)
    matrix[:2, :2] = jacobian[:2, :2].T
    matrix[3:5, :] = plane.T * radial
    return matrix


@dataclass(frozen=True)
class Derived:
    """The equations as SymPy expressions; calling it with numbers gives a fast right-hand side.

    ``seconds``: wall time of the derivation [s]. The terms obey H phi'' + h + f_el + f_di + A F = Q(u).
    """

    H: sp.Matrix
    h: sp.Matrix
    f_el: sp.Matrix
    f_di: sp.Matrix
    Q: sp.Matrix
    energies: Mapping[str, sp.Expr]
    contact: Contact | None
    seconds: float

    def system(self) -> tuple[sp.Matrix, sp.Matrix]:
        """Matrix and right-hand side of the linear system for phi''."""
        left, right = self.H, self.Q - self.h - self.f_el - self.f_di
        if self.contact is None:
            return left, right
        push = self.contact.map * self.contact.direction
        return left + push * self.contact.mass.T, right - push * self.contact.rest

    def program(self, parameters: Mapping[str, float]) -> tuple[list[tuple[sp.Symbol, Any]], list[Any]]:
        """Assignments in order and the 12 rates: the numbers and the PD law put in, phi'' solved for."""
        tau = T - ROW[0]
        wanted, speed = ROW[1] + ROW[2] * tau + ROW[3] * tau**2, ROW[2] + 2 * ROW[3] * tau
        law = P["Klp"] * (wanted - PHI[5]) + P["Klv"] * (speed - RATES[5])
        numbers = {P[name]: sp.Float(parameters[name], 17) for name in NAMES}
        left, right = (matrix.subs(VOLTAGE, law).subs(numbers) for matrix in self.system())
        steps, (left, right) = sp.cse([left, right], symbols=sp.numbered_symbols("k"))
        return steps, [*RATES, *_eliminate(left, right, steps)]

    def __call__(self, parameters: Mapping[str, float], modules: str = "math") -> Rhs:
        """``rhs(t, y, row) -> [y']`` in Python; ``math`` is three times faster than ``numpy`` for one state."""
        steps, rates = self.program(parameters)
        return sp.lambdify([T, [*PHI, *RATES], ROW], rates, modules, cse=lambda expressions: (steps, expressions))

    def c_source(self, parameters: Mapping[str, float], function: str = "rates") -> str:
        """The same program as C, for ``c_loop.build``; the numbers are in it, its fourth argument is not used."""
        steps, rates = self.program(parameters)
        names = [f"const double {T} = arg[0][0];"]
        names += [f"const double {x} = arg[1][{i}];" for i, x in enumerate([*PHI, *RATES])]
        names += [f"const double {x} = arg[2][{i}];" for i, x in enumerate(ROW)]
        names += [f"const double {name} = {sp.ccode(value)};" for name, value in steps]
        names += [f"res[0][{i}] = {sp.ccode(value)};" for i, value in enumerate(rates)]
        head = f"int {function}(const double** arg, double** res, long long* iw, double* w, int mem)"
        return "\n".join(["#include <math.h>", head, "{", *names, "return 0;", "}"])


def _eliminate(left: sp.Matrix, right: sp.Matrix, steps: list[tuple[sp.Symbol, Any]]) -> list[sp.Expr]:
    """Gauss elimination as straight-line code appended to ``steps``; entries that are zero cost nothing.

    H is positive definite and the contact's term is small compared with it, so no pivoting is needed.
    """
    fresh = sp.numbered_symbols("s")

    def name(value: Any) -> Any:
        if value.is_Number or value.is_Symbol:
            return value
        symbol = next(fresh)
        steps.append((symbol, value))
        return symbol

    n = left.rows
    a = [[name(left[i, j]) for j in range(n)] + [name(right[i])] for i in range(n)]
    inverses: list[Any] = []
    for k in range(n):
        inverses.append(name(1 / a[k][k]))
        for i in range(k + 1, n):
            if a[i][k] == 0:
                continue
            factor = name(a[i][k] * inverses[k])
            a[i][k + 1 :] = [name(x - factor * y) for x, y in zip(a[i][k + 1 :], a[k][k + 1 :], strict=True)]
    x: list[Any] = [0] * n
    for k in reversed(range(n)):
        x[k] = name((a[k][n] - sp.Add(*[a[k][j] * x[j] for j in range(k + 1, n)])) * inverses[k])
    return x


def derive(reading: Reading, contact: bool) -> Derived:
    """Derive the equations of one reading, in free space or in contact, from the energies."""
    began = time.perf_counter()
    moving, weight = kinetic(reading), gravity()
    stored, lost = spring_form(PHI, "C", reading), spring_form(RATES, "B", reading)
    momentum = _by(moving, RATES)
    h = momentum.applyfunc(_along) - _by(moving, PHI) + _by(weight, PHI)
    torque = P["CM"] * (VOLTAGE - P["CE"] * RATES[5]) / P["R"] - P["Bm"] * RATES[5]
    energies = {"kinetic": moving, "potential_gravity": weight, "potential_elastic": stored, "rayleigh": lost}
    touch = _contact(reading) if contact else None
    terms = momentum.jacobian(RATES), h, _by(stored, PHI), _by(lost, RATES), sp.Matrix([0, 0, 0, 0, 0, torque])
    return Derived(*terms, energies, touch, time.perf_counter() - began)
