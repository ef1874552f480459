"""What acts on a robot at rest: loads on its points, and the surface that its tip touches."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tmodes.equations.loop.contact_kernels import LawAt, contact_law
from tmodes.errors import InputError
from tmodes.io.units import finite_number
from tmodes.io.words import meant, shown
from tmodes.kinds.contacts.registry import Contact, Surface
from tmodes.kinds.noted.functions import number
from tmodes.kinds.schema.axes import cross_matrix
from tmodes.kinds.signals.contract import Signal
from tmodes.model.model import Model
from tmodes.sheet import Robot
from tmodes.sheet.parts import LoadFrame

__all__ = [
    "Act",
    "Load",
    "Pose",
    "acts_of",
    "check_names",
    "coordinate_numbers",
    "first_value",
    "point_index",
    "sheet_loads",
    "surface_act",
]

Array = NDArray[np.float64]

LARGEST = 1e12
"""Largest magnitude of a load's component [N, N*m]."""


@dataclass(frozen=True)
class Load:
    """A force [N] and a moment [N*m] on a named point: three numbers each, also as text with a unit.

    ``follows`` False: both keep their direction in the world (dead load). True: they are given in the axes of the
    point and turn with it (follower load).

    >>> robot.static(load=[tmodes.Load("tip", force=(0, 0, "-10 N"))]).stable
    True
    """

    point: str = "tip"
    force: ArrayLike = (0.0, 0.0, 0.0)
    moment: ArrayLike = (0.0, 0.0, 0.0)
    follows: bool = False

    def wrench(self) -> Array:
        """Force then moment, shape (6,). Raises :class:`InputError` for what are no three finite numbers each.

        >>> tmodes.Load(force=(0, 0, -10)).wrench()
        array([  0.,   0., -10.,   0.,   0.,   0.])
        """
        return np.concatenate([_three(f"load on {self.point}: force", self.force, "N"),
                               _three(f"load on {self.point}: moment", self.moment, "N*m")])  # fmt: skip


@dataclass(frozen=True, eq=False)
class Pose:
    """Where a point is: ``position`` (3,) [m], ``rotation`` (3, 3), ``jacobian`` (6, nq), all in world axes."""

    position: Array
    rotation: Array
    jacobian: Array


@dataclass(frozen=True, eq=False)
class Act(ABC):
    """Something that acts on one point, by the point's index."""

    is_surface: ClassVar[bool] = False
    """Whether it holds its point to a place."""

    point: int

    @abstractmethod
    def wrench(self, pose: Pose) -> Array:
        """Force and moment on the point, world axes, shape (6,)."""

    def stiffness(self, pose: Pose) -> Array | None:
        """What it adds to the stiffness (nq, nq) beyond a wrench that keeps its direction; None: nothing."""
        del pose
        return None

    def carried(self, pose: Pose) -> tuple[Array, Array] | None:
        """What it adds to the masses and to the damping (nq, nq) of the robot; None: nothing."""
        del pose
        return None

    def turns_with(self, axis: Array) -> bool:
        """Whether it stays the same as seen by a robot that turns as a whole about an axis (3,) of the world."""
        del axis
        return False


@dataclass(frozen=True, eq=False)
class _Dead(Act):
    given: Array

    def turns_with(self, axis: Array) -> bool:
        return not np.cross(self.given.reshape(2, 3), axis).any()

    def wrench(self, pose: Pose) -> Array:
        del pose
        return self.given


class _Follower(_Dead):
    def turns_with(self, axis: Array) -> bool:
        del axis
        return True

    def wrench(self, pose: Pose) -> Array:
        return np.concatenate([pose.rotation @ self.given[:3], pose.rotation @ self.given[3:]])

    def stiffness(self, pose: Pose) -> Array:
        """A turn d of the section turns a vector F by d x F, which is a force less -[F]x d."""
        wrench, turn = self.wrench(pose), pose.jacobian[3:]
        force, moment = cross_matrix(wrench[:3]) @ turn, cross_matrix(wrench[3:]) @ turn
        return pose.jacobian[:3].T @ force + turn.T @ moment


def acts_of(model: Model, loads: Sequence[Load]) -> list[Act]:
    """Loads as acts on points by index. Raises :class:`InputError` for an unknown point and numbers not finite."""
    return [(_Follower if load.follows else _Dead)(point_index(model, load.point), load.wrench()) for load in loads]


def sheet_loads(robot: Robot) -> list[Load]:
    """The loads of a data sheet at time 0."""
    loads = []
    for load in robot.loads:
        factor = 1.0 if load.signal is None else first_value(robot, load.signal)
        force, moment = ([factor * x for x in part] for part in (load.force, load.moment))
        loads.append(Load(load.point, force, moment, follows=load.frame is LoadFrame.SECTION))
    return loads


def first_value(robot: Robot, signal: Signal) -> float:
    """The value of a signal at time 0; beyond the robot's run it may have none."""
    return number(signal.schedule(min(1.0, robot.integration.duration)).coefficients[0, 0])


def point_index(model: Model, name: str) -> int:
    """Index of a named point. Raises :class:`InputError` where there is none."""
    names = [point.name for point in model.parts.points]
    if name not in names:
        raise InputError("point", f"`{name}`", f"one of {', '.join(names)}", "name a point of the arm, or add it there")
    return names.index(name)


def _three(which: str, values: Any, unit: str) -> Array:
    """Three numbers in a unit, each perhaps as text with its own."""
    given = values.tolist() if isinstance(values, np.ndarray) else values
    if not isinstance(given, (list, tuple)) or len(given) != 3:
        raise InputError(which, shown(given), f"three numbers in {unit}", "give x, y and z")
    return np.array([finite_number(which, value, unit, "three finite numbers", most=LARGEST) for value in given])


class SurfaceDistance(NamedTuple):
    """Distance of a point from a surface [m], positive in the free; the normal towards the free; its curvature [1/m].

    ``curvature`` is the derivative of the normal by the position, shape (3, 3).
    """

    gap: float
    normal: Array
    curvature: Array


def touch(shape: Surface, position: Array) -> SurfaceDistance:
    """Where a position (3,) [m] is with regard to a surface."""
    numbers, place = shape.numbers(), [float(x) for x in position]
    still = shape.meet(numbers, place, [0.0, 0.0, 0.0])
    # The second derivative of the penetration along a velocity is a quadratic form of it: the surface's curvature.
    along = [[float(shape.meet(numbers, place, list(a + b)).curving) for b in np.eye(3)] for a in np.eye(3)]
    own = [along[i][i] / 4 for i in range(3)]
    bent = np.array([[(along[i][j] - own[i] - own[j]) / 2 for j in range(3)] for i in range(3)])
    return SurfaceDistance(-float(still.depth), -np.array(still.direction, dtype=float), -bent)


@dataclass(frozen=True, eq=False)
class _RestingSurface(Act):
    """Normal force of the law at rest; friction holds nothing there.

    Where it acts, the surface moves with the point along the normal: its mass and its damper are then the robot's too.
    """

    is_surface: ClassVar[bool] = True
    sheet: Contact

    @cached_property
    def _law(self) -> Callable[[float, float], LawAt]:
        return contact_law(self.sheet)

    def _at(self, pose: Pose) -> tuple[SurfaceDistance, LawAt]:
        found = touch(self.sheet.shape, pose.position)
        return found, self._law(-found.gap, 0.0)

    def wrench(self, pose: Pose) -> Array:
        found, law = self._at(pose)
        return np.concatenate([law.force * found.normal, np.zeros(3)])

    def stiffness(self, pose: Pose) -> Array:
        found, law = self._at(pose)
        block = law.stiffness * np.outer(found.normal, found.normal) - law.force * found.curvature
        return pose.jacobian[:3].T @ block @ pose.jacobian[:3]

    def carried(self, pose: Pose) -> tuple[Array, Array] | None:
        found, law = self._at(pose)
        if self.sheet.unilateral and not law.force:
            return None
        along = found.normal @ pose.jacobian[:3]
        moved = np.outer(along, along)
        return self.sheet.moving_mass * moved, law.damping * moved


def surface_act(model: Model, sheet: Contact) -> Act:
    """The surface as an act on its point. Raises :class:`tmodes.errors.InputError` for an unknown point."""
    return _RestingSurface(point_index(model, sheet.point), sheet)


LARGEST_GIVEN = 1e6
"""Largest value of a coordinate or a rate that is given [rad, m, rad/s, m/s]."""


def coordinate_numbers(
    model: Model, values: Mapping[str, Any] | None, *, rate: bool = False, effort: bool = False
) -> dict[str, float]:
    """Values by coordinate [rad, m; ``rate``: rad/s, m/s; ``effort``: N*m, N], each a number or text with a unit.

    Raises :class:`tmodes.errors.InputError` for an unknown name, and for what is no finite number of that unit.
    """
    given = values or {}
    check_names(model, given)
    units = model.chain.units(given)
    if rate:
        units = {name: "1/s" if unit == "-" else f"{unit}/s" for name, unit in units.items()}
    if effort:
        units = {name: "N" if unit == "m" else "N*m" for name, unit in units.items()}
    most = LARGEST if effort else LARGEST_GIVEN
    return {name: finite_number(name, value, units[name], most=most) for name, value in given.items()}


def check_names(model: Model, names: Iterable[str]) -> None:
    """Refuse names that are no coordinates of the model: :class:`tmodes.errors.InputError` with the nearest one."""
    for name in names:
        if name not in model.coordinates:
            hint = meant(str(name), model.coordinates, "check the spelling")
            raise InputError("coordinate", f"`{name}`", f"one of {', '.join(model.coordinates)}", hint)
