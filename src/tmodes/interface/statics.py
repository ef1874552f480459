"""Rest and stiffness of a robot: what ``tmodes static`` computes and prints."""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.interface.poses import Pose, held_of, load_of, pose_of, pose_words, three_of
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from tmodes.analysis.statics.equilibrium import Equilibrium
    from tmodes.analysis.statics.loads import Load
    from tmodes.sheet import Robot

__all__ = [
    "Linearization",
    "Statics",
    "circumstances",
    "link_table",
    "numbers",
    "static",
    "stiffness_table",
    "which_robot",
]  # fmt: skip

Progress = Callable[[str, float], None]

UNITS = {
    "coordinates": "rad, m along prismatic joints and stretch",
    "moving": "rad/s, m/s: coordinates and `base` that move at constant speed",
    "efforts": "N*m, N: of drives that command no position, on coordinates that are free",
    "residual": "1, of the largest force",
    "lowest_frequency_Hz": "Hz, 0 where not stable",
    "lost_stability_at": "1, factor on weight and loads",
    "shares": "1, of the compliance in that direction",
    "angle_rad": "rad",
    "missing_share": "1, of the energy of bending, in shapes that the link's functions do not have",
}


@checked_arguments
def static(
    robot: Robot,
    *,
    load: Sequence[str | Load | Mapping[str, Any]] = (),
    force: str | Sequence[float | str] | None = None,
    moment: str | Sequence[float | str] | None = None,
    point: str = "tip",
    hold: Pose | Sequence[str] | None = None,
    at: Pose | None = None,
    progress: Progress = lambda stage, share: None,
) -> Statics:
    """Rest under weight and loads: pose, sag, stability, stiffness at a point, and which element gives how much.

    ``load``: further loads, each a :class:`tmodes.analysis.statics.loads.Load`, a group
    ``{"point": "tip", "force": (0, 0, -10)}`` or text; ``force`` (3,) [N] and ``moment`` (3,) [N*m]: dead ones on
    ``point``, whose stiffness is reported. ``at``: joints held there [rad, m], others at their first command; ``hold``:
    motors or joints by their coordinates. Of the nominal robot, in its contact, under the loads of its sheet; of drives
    and a base at constant speed about that motion.

    Raises :class:`tmodes.errors.InputError` for unknown names and wrong numbers, and
    :class:`tmodes.errors.SimulationError` where it finds no rest. Method: load steps that keep to their branch, M. A.
    Crisfield, Non-linear Finite Element Analysis of Solids and Structures 1 (1991), ch. 9.

    >>> rest = tmodes.load("spong1987").static(force=(0, 0, -1))
    >>> rest.stable
    True
    """
    from tmodes.analysis.describe.describe import statics_info
    from tmodes.analysis.statics.at_rest import robot_rest
    from tmodes.analysis.statics.loads import Load, point_index
    from tmodes.model.model import Model

    loads = [load_of(one) for one in load]
    if force is not None or moment is not None:
        pushed = three_of("--force", force or (0.0, 0.0, 0.0), "N")
        loads.append(Load(point, pushed, three_of("--moment", moment or (0.0, 0.0, 0.0), "N*m")))
    model = Model(robot.chain())
    index = point_index(model, point)
    held = pose_of(at, robot) | held_of(hold, robot)
    rest = robot_rest(robot, loads, model=model, held=held, moving=True, efforts=True, progress=progress)
    return Statics(robot, rest, statics_info(robot, rest, index), pose_words(at, hold))


@dataclass(frozen=True, eq=False, repr=False)
class Statics(CommandResult):
    """A robot at rest under loads; ``rest``: pose and matrices; ``found``: all that is reported, as plain data."""

    robot: Robot = field(repr=False)
    rest: Equilibrium
    found: Mapping[str, Any]
    at: str | None = None

    @property
    def stable(self) -> bool:
        """Whether it stays there."""
        return self.rest.stable

    @property
    def pose(self) -> dict[str, float]:
        """Coordinates by name [rad, m]."""
        return self.rest.named

    @property
    def warnings(self) -> list[str]:
        """What is to be known about these numbers."""
        return list(self.found["warnings"])

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes static --json`` prints it."""
        return {
            "robot": self.robot.name, "of": "nominal robot" if self.robot.real else "robot", "units": UNITS,
            **self.found,
        }  # fmt: skip

    @property
    def data(self) -> Dataset:
        """``q`` (coordinate), ``position`` and ``displacement`` (point, axis) [m], matrices about the pose [SI].

        ``mass``, ``damping``, ``stiffness`` (coordinate, along); ``compliance`` (direction, along_direction) of the
        point.
        """
        from xarray import Dataset

        info, names = self.found, list(self.rest.model.coordinates)
        points, point = info["points"], info["stiffness"]
        series: dict[str, Any] = {"q": ("coordinate", self.rest.q, {"units": "rad, m"})}
        for name in ("position", "displacement"):
            values = [one[f"{name}_m"] for one in points]
            series[name] = (("point", "axis"), values, {"units": "m"})
        for name, matrix in zip(("mass", "damping", "stiffness"), self.rest.matrices, strict=True):
            series[name] = (("coordinate", "along"), matrix)
        coords: dict[str, Any] = {"coordinate": names, "along": names, "axis": list("xyz")}
        coords |= {"point": [one["point"] for one in points]}
        if point:
            ways = [one["direction"] for one in point["directions"]]
            coords |= {"direction": ways, "along_direction": ways}
            series["compliance"] = (("direction", "along_direction"), point["compliance_matrix_SI"])
        return Dataset(series, coords)

    def plot(self, ax: Any = None) -> list[Any]:
        """The lines of the links at rest, and unloaded, in the plane in which they extend most."""
        from tmodes.plot.commands import shape

        lines = {label: _drawn(self.rest, q) for label, q in (("unloaded", self.rest.unloaded), ("at rest", None))}
        return shape(lines, title=f"{self.robot.name} at rest", ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """Rest, points, links, reactions and stiffness."""
        robot, info = self.robot, self.found
        yield _state(robot, info)
        yield circumstances(robot, contact=True, at=self.at, efforts=info["efforts"])
        if not info["coordinates"]:
            yield "It has no coordinates: nothing in it moves or bends."
        units = robot.chain().units(info["coordinates"])
        coordinates = [[name, *numbers([value], 1.0, 1.0), units[name]]
                       for name, value in info["coordinates"].items()]  # fmt: skip
        if coordinates:
            yield Table("Pose", ["coordinate", "value", "unit"], coordinates)
        yield from _places(info)


def _drawn(rest: Equilibrium, q: NDArray[np.float64] | None) -> list[NDArray[np.float64]]:
    """The lines (S, 3) [m] of all links in the world, at rest or in another pose."""
    from tmodes.analysis.line.line import elastic_line

    lines = elastic_line(rest.model, rest.q if q is None else q)
    return [line.position[0] for line in lines.links.values()]


def _state(robot: Robot, info: Mapping[str, Any]) -> str:
    lowest = info["lowest_frequency_Hz"]
    stable = "stable" if info["stable"] else "NOT STABLE"
    stable = f"neutral, nothing holds {' and '.join(info['neutral'])}" if info["neutral"] else stable
    rates = ", ".join(f"{name} {rate:.4g}" for name, rate in info["moving"].items())
    how = f"in motion at constant speed ({rates} rad/s, m/s)" if rates else "at rest"
    ringing = f", lowest undamped frequency {lowest:.4g} Hz" if lowest else ""
    return f"{robot.name}{which_robot(robot)} {how}: {stable}{ringing}"


def _places(info: Mapping[str, Any]) -> Iterator[Table]:
    size = _largest(info["points"], "position_m")
    sags = [[one["point"], *numbers(one["position_m"], 1.0, size), *numbers(one["displacement_m"], 1e3, size),
             *numbers([one["rotation_rad"]], 1.0, 1.0)] for one in info["points"]]  # fmt: skip
    columns = ["point", *(f"{axis} [m]" for axis in "xyz"), *(f"d{axis} [mm]" for axis in "xyz"), "rotation [rad]"]
    yield Table("Points at rest, and how far they are displaced and rotated", columns, sags)
    yield from link_table(info["links"])
    if info["reactions"]:
        force, moment = (_largest(info["reactions"], name) for name in ("force_N", "moment_Nm"))
        rows = [[one["at"], *numbers(one["force_N"], 1.0, force), *numbers(one["moment_Nm"], 1.0, moment)]
                for one in info["reactions"]]  # fmt: skip
        columns = ["at", *(f"F{axis} [N]" for axis in "xyz"), *(f"M{axis} [N*m]" for axis in "xyz")]
        yield Table("Reactions of the base and of each joint on what it carries, world axes", columns, rows)
    yield from stiffness_table(info["stiffness"])


def link_table(links: Sequence[Mapping[str, Any]]) -> Iterator[Table]:
    """How far the flexible links bend, and whether the model of each holds."""
    if links:
        rows = [[link["link"], link["model"], f"{link['deflection_over_length']:.3%}", f"{link['slope_rad']:.4g}",
                 _share(link["missing_share"]), link["verdict"]] for link in links]  # fmt: skip
        columns = ["link", "model", "deflection / length", "slope [rad]", "missing shapes", "model holds"]
        yield Table("Flexible links", columns, rows)


def which_robot(sheet: Robot) -> str:
    """What stands behind the name of a robot whose sheet has an actual one, too."""
    return ", nominal robot" if sheet.real else ""


def circumstances(
    sheet: Robot, *, contact: bool, loads: bool = True, at: str | None = None, efforts: Container[str] = ()
) -> str:
    """What a table about a rest is of: free space or contact, weight, loads, pose.

    ``at``: the pose as it was given; ``efforts``: coordinates that are free under a drive's effort; others are held.
    """
    gravity = math.hypot(*sheet.chain().gravity)
    closed = sheet.contact is not None and not sheet.contact.unilateral
    left_out = "its bilateral contact left out (loop open)" if closed else "free space"
    drives = ["drives at their first command"] if any(drive.command.is_motion for drive in sheet.drives) else []
    pushed = [drive.joint for drive in sheet.drives if not drive.command.is_motion]
    free = [name for name in pushed if name in efforts or f"{name}.motor" in efforts]
    held = [name for name in pushed if name not in free]
    return ", ".join([
        "in contact" if contact and sheet.contact else left_out,
        f"gravity {gravity:.4g} m/s^2" if gravity else "no gravity",
        *(["under its loads" if loads else "without its loads"] if sheet.loads else ()),
        *([f"at {at}"] if at else drives),
        *([f"{' and '.join(free)} free under the first effort of the drive"] if free else ()),
        *([f"{' and '.join(held)} held without the effort of the drive"] if held else ()),
    ])  # fmt: skip


def _share(share: float | None) -> str:
    return "-" if share is None else f"{share:.1%}"


ROUNDING = 1e-12
"""A value below this share of the largest is zero but for rounding, and printed as 0."""


def numbers(values: list[float], factor: float, largest: float) -> list[str]:
    """SI values times a factor; 0 for what is rounding next to the largest SI value."""
    return [f"{factor * value + 0.0:.6g}" if abs(value) > ROUNDING * largest else "0" for value in values]


def _largest(rows: list[dict[str, Any]], name: str) -> float:
    return max((abs(value) for one in rows for value in one[name]), default=0.0)


def stiffness_table(info: Mapping[str, Any] | None) -> Iterator[Table]:
    """Stiffness by direction and the elements that give most."""
    if info is None:
        return
    rows = []
    for one in info["directions"]:
        stiffness = "-" if one["why"] else "rigid" if one["stiffness"] is None else f"{one['stiffness']:.5g}"
        largest = sorted(one["shares"].items(), key=lambda item: -abs(item[1]))[:4]
        shares = ", ".join(f"{name} {share:.1%}" for name, share in largest if abs(share) >= 5e-4)
        rows.append([one["direction"], stiffness, one["unit"], one["why"] or shares])
    yield Table(f"Stiffness at {info['point']}", ["direction", "stiffness", "unit", "share of the compliance"], rows)


@dataclass(frozen=True, eq=False, repr=False)
class Linearization(CommandResult):
    """``mass``, ``damping``, ``stiffness`` (nq, nq) [SI] about the pose ``q`` (nq,), by ``coordinates``."""

    name: str
    where: str
    coordinates: tuple[str, ...]
    q: NDArray[np.float64]
    mass: NDArray[np.float64]
    damping: NDArray[np.float64]
    stiffness: NDArray[np.float64]

    @property
    def matrices(self) -> dict[str, NDArray[np.float64]]:
        """The three by their names."""
        return {"mass": self.mass, "damping": self.damping, "stiffness": self.stiffness}

    @property
    def state_matrix(self) -> NDArray[np.float64]:
        """A (2 nq, 2 nq) of x' = A x + B f with x the changes of coordinates and rates."""
        import numpy as np

        n, pull = len(self.q), np.linalg.solve(self.mass, np.hstack([self.stiffness, self.damping]))
        return np.vstack([np.eye(n, 2 * n, n), -pull]).astype(float)

    @property
    def poles(self) -> NDArray[np.complex128]:
        """Eigenvalues (2 nq,) of the free robot [1/s], the slowest first."""
        import numpy as np

        found = np.linalg.eigvals(self.state_matrix).astype(complex)
        return found[np.argsort(np.abs(found), kind="stable")]

    def info(self) -> dict[str, Any]:
        """Plain data."""
        matrices = {name: matrix.tolist() for name, matrix in self.matrices.items()}
        return {"robot": self.name, "coordinates": list(self.coordinates), "q": self.q.tolist(), **matrices}

    @property
    def data(self) -> Dataset:
        """``q`` (coordinate), ``mass``, ``damping`` and ``stiffness`` (coordinate, along) [SI]."""
        from xarray import Dataset

        names = list(self.coordinates)
        series = {name: (("coordinate", "along"), matrix) for name, matrix in self.matrices.items()}
        return Dataset({"q": ("coordinate", self.q), **series}, {"coordinate": names, "along": names})

    def plot(self, ax: Any = None) -> list[Any]:
        """The poles in the complex plane."""
        from tmodes.plot.commands import points

        shown = {"": (self.poles.real, self.poles.imag)}
        return points(shown, "real part [1/s]", "imaginary part [1/s]", title=f"Poles of {self.name}", ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """The three matrices."""
        yield f"{self.name}: M a + D v + K q = f about its rest, {self.where}"
        for name, matrix in self.matrices.items():
            rows = [
                [own, *(f"{value:.5g}" for value in row)] for own, row in zip(self.coordinates, matrix, strict=True)
            ]
            yield Table(f"{name} [SI]", ["", *self.coordinates], rows)
