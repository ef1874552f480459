"""Joint and motor angles that hold a point where it is wanted, the robot bent as it is: what ``tmodes pose`` prints."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError
from tmodes.interface.poses import Pose, held_of, load_of
from tmodes.interface.statics import numbers, which_robot
from tmodes.io.arguments import checked_arguments, whole_number
from tmodes.io.printed import CommandResult, Table
from tmodes.io.units import finite_number
from tmodes.io.words import shown

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.analysis.statics.inverse import Branch, Branches, Target
    from tmodes.analysis.statics.loads import Load
    from tmodes.sheet import Robot

__all__ = ["Inverse", "inverse"]

UNITS = {
    "coordinates": "rad, m along prismatic joints and stretch", "motors": "rad, m", "twists": "rad, m",
    "torques": "N*m, N, that the motors hold, after the reducer", "lowest_frequency_Hz": "Hz, 0 where not stable",
    "velocity_map": "m/s and rad/s of the point per rate of each motor",
}  # fmt: skip

_MOST_STARTS = 100_000


@checked_arguments
def inverse(
    robot: Robot,
    *,
    tip: str | Sequence[float | str],
    load: Sequence[str | Load | Mapping[str, Any]] = (),
    point: str = "tip",
    near: Pose | Sequence[str] | None = None,
    starts: int = 64,
    progress: Callable[[str, float], None] = lambda stage, share: None,
) -> Inverse:
    """Joint and motor angles with which the robot, bent by weight and loads, holds a point where it is wanted.

    ``tip``: x, y, z [m] in the world and perhaps roll, pitch and yaw [rad] of the point's axes about axes that stay, as
    in URDF; ``free`` for any of them that does not matter. Of the nominal robot, under the loads of its sheet at time 0
    and further ones (``load``, as of :meth:`Robot.static`), in its contact. All branches that ``starts`` starts find:
    those within the limits first, then stable ones, then by their distance from the pose ``near`` (joints or motors
    [rad, m]; others at their first command). Where joints can move and leave the point, as of a robot with more than it
    needs or with the point on the axis of the first, those of least motion from it, and how they go on
    (``branch.ways``).

    Where the point can not be, ``found.branches`` is empty and ``found.nearest`` is the pose that brings it nearest: by
    least squares of distances over the size of the robot and of angles.
    Raises :class:`tmodes.errors.InputError` for unknown names, wrong numbers, and a robot that no motor holds. Method:
    K. Levenberg, Quart. Appl. Math. 2 (1944) 164, with the exact Jacobian of the point and stiffness of the robot.

    >>> found = tmodes.load("two_link_arm").inverse(tip=(0.7, 0, 0.3))
    >>> [branch.stable for branch in found.branches]
    [True, True]
    """
    from tmodes.analysis.statics.inverse import held_poses, tip_problem
    from tmodes.analysis.statics.loads import point_index
    from tmodes.model.model import Model

    model = Model(robot.chain())
    index, target = point_index(model, point), _target(tip)
    whole_number("starts", starts, 1, _MOST_STARTS)
    problem, pose = tip_problem(robot, index, [load_of(one) for one in load], model=model, near=held_of(near, robot))
    progress("starts", 0.0)
    return Inverse(robot, point, target, held_poses(robot, problem, pose, target, int(starts)))


def _target(given: str | Sequence[float | str]) -> Target:
    """Three or six numbers, or text with commas between them; `free` for any of them."""
    import numpy as np

    from tmodes.analysis.statics.inverse import Target

    listed: Any = given.tolist() if isinstance(given, np.ndarray) else given
    words: Any = given.split(",") if isinstance(given, str) else listed
    if not isinstance(words, (list, tuple)) or len(words) not in (3, 6):
        expected, hint = "x, y, z [m], or these and roll, pitch, yaw [rad]", "write it like 0.7,0,0.3"
        raise InputError("--tip", shown(given), expected, hint)
    numbers = [_wanted(word, "m" if k < 3 else "rad") for k, word in enumerate(words)]
    if all(math.isnan(one) for one in numbers):
        raise InputError("--tip", shown(given), "at least one number", "write the wanted ones, like free,free,0.3")
    return Target(np.array(numbers[:3]), np.array(numbers[3:]) if len(numbers) == 6 else None)


def _wanted(word: Any, unit: str) -> float:
    free = isinstance(word, str) and word.strip() == "free"
    return math.nan if free else finite_number("--tip", word, unit, "finite numbers, or `free`", most=1e6)


@dataclass(frozen=True, eq=False, repr=False)
class Inverse(CommandResult):
    """The ``branches`` with which a robot holds a point, best first, and how they were sought."""

    robot: Robot = field(repr=False)
    point: str
    target: Target
    found: Branches

    @property
    def branches(self) -> tuple[Branch, ...]:
        """All ways that were found; none: the point can not be there, or it was not found."""
        return self.found.branches

    @property
    def nearest(self) -> Branch | None:
        """Where the point can not be: the pose that brings it nearest, ``nearest.off`` how near [m, rad]."""
        return self.found.nearest

    @property
    def reachable(self) -> bool:
        """Whether the point can be there at all, be it in a pose that is unstable or beyond a limit."""
        return bool(self.branches)

    @property
    def held(self) -> bool:
        """Whether a branch within the limits holds the point and stays there."""
        return any(one.stable and not one.outside for one in self.branches)

    @property
    def warnings(self) -> list[str]:
        """Branches that can not be used as they are, and how far the search can be relied on."""
        good = [one for one in self.branches if one.stable]
        target, said = self.target, []
        wanted = sum(math.isfinite(x) for part in (target.position, target.rpy) if part is not None for x in part)
        if not self.branches and self.found.held < wanted:
            said.append(f"the joints hold at most {self.found.held} of the {wanted} wanted numbers: free others")
        if self.found.placed:
            said.append("the place alone can be held: leave out roll, pitch and yaw, or write `free` for them")
        if self.branches and not good:
            said.append("reachable only as an unstable equilibrium: the robot does not stay there with its motors held")
        if self.branches and not [one for one in good if not one.outside]:
            said.append("no stable branch is within the limits of the joints")
        if any(one.starts == 1 for one in self.branches) and not self.found.redundant:
            said.append("a branch was met from one start alone, so that there may be others: take more --starts")
        return said

    @property
    def _wanted(self) -> str:
        axes = zip("xyz", self.target.position, strict=True)
        words = ", ".join(f"{axis} {value:.6g}" for axis, value in axes if math.isfinite(value))
        named = () if self.target.rpy is None else zip(("roll", "pitch", "yaw"), self.target.rpy, strict=True)
        turned = ", ".join(f"{name} {value:.6g}" for name, value in named if math.isfinite(value))
        parts = [f"at {words} m" if words else "", f"turned to {turned} rad" if turned else ""]
        return f"{self.point} {', '.join(part for part in parts if part)}"

    @property
    def sought(self) -> str:
        """How the branches were sought, and what is known of their number."""
        found, count = self.found, len(self.branches)
        if not self.branches:
            return f"{found.starts} starts found none"
        words = f"{count} branch{'es' if count > 1 else ''} from {found.starts} starts"
        if found.redundant:
            free = f"joint motions that leave the point in place: {found.redundant}"
            return f"{words}; {free}; poses of locally least motion from the start"
        rarest = min(one.starts for one in self.branches)
        return f"{words}, the rarest met {rarest} time{'s' if rarest > 1 else ''}; that these are all is not proven"

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes pose --json`` prints it."""
        finite, turned = (
            [float(x) if math.isfinite(x) else None for x in (() if part is None else part)]
            for part in (self.target.position, self.target.rpy)
        )
        return {
            "robot": self.robot.name, "point": self.point, "position_m": finite,
            "rpy_rad": turned or None, "reachable": self.reachable,
            "branches": [_branch_info(one) for one in self.branches],
            "nearest": None if self.nearest is None else _branch_info(self.nearest),
            "starts": self.found.starts, "redundant": self.found.redundant, "sought": self.sought, "units": UNITS,
            "warnings": self.warnings,
        }  # fmt: skip

    @property
    def data(self) -> Dataset:
        """``q`` (branch, coordinate), ``torque`` and ``rate_map`` (branch, ..., motor), ``deflection`` (branch, axis).

        ``rate_map`` (branch, component, motor): velocity of the point per rate of each motor at rest [SI]. Where the
        point can not be, the one branch is the nearest pose.
        """
        import numpy as np
        from xarray import Dataset

        shown_ones = self.branches or ((self.nearest,) if self.nearest else ())
        if not shown_ones:
            return Dataset({"q": ("branch", np.zeros(0))})
        first, rows = shown_ones[0], range(len(shown_ones))
        series: dict[str, Any] = {
            "q": (("branch", "coordinate"), [one.q for one in shown_ones], {"units": "rad, m"}),
            "torque": (("branch", "motor"), [[*one.torque.values()] for one in shown_ones], {"units": "N*m, N"}),
            "deflection": (("branch", "axis"), [one.deflection for one in shown_ones], {"units": "m"}),
            "rate_map": (("branch", "component", "motor"), [one.velocity_map for one in shown_ones]),
            "stable": ("branch", [one.stable for one in shown_ones]),
        }
        coords = {
            "branch": list(rows), "coordinate": list(first.model.coordinates), "motor": list(first.torque),
            "axis": list("xyz"), "component": ["vx", "vy", "vz", "wx", "wy", "wz"],
        }  # fmt: skip
        return Dataset(series, coords)

    def plot(self, ax: Any = None) -> list[Any]:
        """The lines of the links in the first branches, in the plane in which they extend most."""
        from tmodes.analysis.line.line import elastic_line
        from tmodes.plot.commands import shape

        poses = {f"branch {k + 1}": one for k, one in enumerate(self.branches[:_DRAWN])}
        poses = poses or ({"nearest": self.nearest} if self.nearest else {})
        lines = {
            label: [line.position[0] for line in elastic_line(one.model, one.q).links.values()]
            for label, one in poses.items()
        }
        return shape(lines, title=f"{self.robot.name}: {self._wanted}", ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """What was wanted, how it was sought, and each branch."""
        head = f"{self.robot.name}{which_robot(self.robot)}, {self._wanted}"
        if self.branches:
            yield f"{head}: {self.sought}"
        elif self.nearest is None:
            yield f"{head}: {self.sought}, nor the nearest pose"
        else:
            off, turned = self.nearest.off
            angle = f" and {turned:.4g} rad" if self.target.turns else ""
            yield f"{head}: NOT REACHABLE from {self.found.starts} starts; the nearest pose is {off:.6g} m{angle} off"
        shown_ones = {str(k + 1): one for k, one in enumerate(self.branches)}
        shown_ones |= {} if self.nearest is None else {"nearest": self.nearest}
        if not shown_ones:
            return
        yield Table("Branches", ["branch", "sag [mm]", "rest"], [_row(*item) for item in shown_ones.items()])
        for title, values in _GROUPS.items():
            named = {label: values(one) for label, one in shown_ones.items()}
            columns = [*next(iter(named.values()))]
            rows = [[label, *numbers([*one.values()], 1.0, 1.0)] for label, one in named.items()]
            if columns:
                yield Table(title, ["branch", *columns], rows)


_GROUPS: dict[str, Callable[[Branch], Mapping[str, float]]] = {
    "Joints [rad, m]": lambda one: {one.model.coordinates[k]: float(one.q[k]) for k in one.model.joints},
    "Motors [rad, m]": lambda one: one.motors,
    "Held by the motors [N*m, N]": lambda one: one.torque,
    "Twist of the gears [rad, m]": lambda one: one.twists,
}

_DRAWN = 4
"""Branches that are drawn: more lie over each other."""


def _row(label: str, branch: Branch) -> list[str]:
    sag = math.hypot(*branch.deflection)
    state = "stable" if branch.stable else "NOT STABLE"
    state += ", singular" if branch.singular and label != "nearest" else ""
    for way in branch.ways:
        moved = ", ".join(f"{name} {value:.3g}" for name, value in way.items() if value)
        state += f", one of a family along {moved}"
    return [label, *numbers([sag], 1e3, 1.0), "; ".join([state, *branch.outside])]


def _branch_info(branch: Branch) -> dict[str, Any]:
    frequency = branch.lowest_frequency_Hz
    return {
        "coordinates": branch.named, "motors": branch.motors, "twists": branch.twists, "torques": dict(branch.torque),
        "off_m": branch.off[0], "off_rad": branch.off[1], "deflection_m": branch.deflection.tolist(),
        "stable": bool(branch.stable), "lowest_frequency_Hz": frequency if math.isfinite(frequency) else None,
        "outside": list(branch.outside), "singular": bool(branch.singular), "starts": branch.starts,
        "velocity_map": branch.velocity_map.tolist(), "ways": [dict(one) for one in branch.ways],
    }  # fmt: skip
