"""A robot in numbers: what ``tmodes describe`` computes and prints."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.interface.poses import Pose, pose_of, pose_words
from tmodes.interface.statics import circumstances, numbers, stiffness_table, which_robot
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table, known_columns

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.sheet import Robot

__all__ = ["Description", "describe"]

Progress = Callable[[str, float], None]


@checked_arguments
def describe(robot: Robot, *, at: Pose | None = None, progress: Progress = lambda stage, share: None) -> Description:
    """Masses, lengths, stiffnesses, frequencies of each link by itself, sag under weight, stiffness at the tip.

    ``at``: the pose [rad, m], joints that are not named at their first command. Of the nominal robot under its own
    weight, without its loads and, where no joint is free, without its contact. A robot that finds no rest is described
    too, with a warning that says why. Raises :class:`tmodes.errors.InputError` for an unknown joint in ``at``.

    >>> round(tmodes.load("spong1987").describe().found["total_mass_kg"], 3)
    1.0
    """
    from tmodes.analysis.describe.describe import describe as described

    return Description(robot, described(robot, pose_of(at, robot), progress=progress), pose_words(at))


@dataclass(frozen=True, eq=False, repr=False)
class Description(CommandResult):
    """A robot in numbers; ``found``: all of them, as plain data with units in the names."""

    robot: Robot = field(repr=False)
    found: Mapping[str, Any]
    at: str | None = None

    @property
    def warnings(self) -> list[str]:
        """What looks wrong, or holds only with care."""
        return list(self.found["warnings"])

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes describe --json`` prints it."""
        return dict(self.found)

    @property
    def data(self) -> Dataset:
        """``mass`` [kg] and ``length`` [m] (link); ``compliance`` (direction, along) of the tip [SI]."""
        from xarray import Dataset

        links, point = self.found["links"], self.found["stiffness"]
        series: dict[str, Any] = {
            "mass": ("link", [one["mass_kg"] for one in links], {"units": "kg"}),
            "length": ("link", [float("nan") if one["length_m"] is None else one["length_m"] for one in links],
                       {"units": "m"}),
        }  # fmt: skip
        coords: dict[str, Any] = {"link": [one["name"] for one in links]}
        if point:
            ways = [one["direction"] for one in point["directions"]]
            coords |= {"direction": ways, "along": ways}
            series["compliance"] = (("direction", "along"), point["compliance_matrix_SI"])
        return Dataset(series, coords)

    def plot(self, ax: Any = None) -> list[Any]:
        """Share of each element in the compliance of the tip, by direction."""
        from tmodes.plot.commands import bars

        directions = (self.found["stiffness"] or {"directions": []})["directions"]
        elements = dict.fromkeys(name for one in directions for name in one["shares"])
        shares = {name: [one["shares"].get(name, 0.0) for one in directions] for name in elements}
        names = [one["direction"] for one in directions]
        return bars(shares, names, "share of the compliance", title=f"What gives way: {self.robot.name}", ax=ax,
                    stacked=True)  # fmt: skip

    def tables(self) -> Iterator[str | Table]:
        """Joints, links, gears, springs, sag and stiffness."""
        info = self.found
        yield f"{info['name']}: {info['title'] or 'a robot'}"
        count = len(info["coordinates"])
        moves = "coordinate" if count == 1 else "coordinates" if count else "coordinates (nothing in it moves or bends)"
        yield f"{count or 'no'} {moves}, {info['total_mass_kg']:.4g} kg"
        for note in info["notes"]:
            yield f"note: {note}"
        yield from _elements(info)
        if sag := info["sag"]:
            if sag["displacement_m"] is None:
                place = ", ".join(numbers(sag["position_m"], 1.0, 1.0))
                yield f"Sag of the tip under weight: none, a joint is free; it comes to rest at {place} m (x, y, z)"
            else:
                travel = ", ".join(numbers(sag["displacement_m"], 1e3, 1.0))
                yield f"Sag of the tip under weight: {travel} mm (x, y, z), turned by {sag['rotation_rad']:.4g} rad"
            where = circumstances(self.robot, contact=False, loads=False, at=self.at)
            yield f"Sag and stiffness{which_robot(self.robot)}: {where}\n"
        yield from stiffness_table(info["stiffness"])


def _elements(info: Mapping[str, Any]) -> Iterator[str | Table]:
    joints = [[one["name"], one["type"], one["kind"], one["carries"], one["command"] or _undriven(one), _limits(one)]
              for one in info["joints"]]  # fmt: skip
    yield known_columns("Joints (A active, L locked, F free; E elastic, R rigid gear)",
                        ["joint", "type", "kind", "carries", "drive", "limits"], joints)  # fmt: skip
    columns = ["link", "model", "mass [kg]", "length [m]", "EI y, z [N*m^2]", "GJ [N*m^2]", "EA [N]",
               "alone y, z [Hz]"]  # fmt: skip
    yield known_columns("Links", columns, [_link(one) for one in info["links"]])
    for one in info["links"]:
        if "equivalent_mass_kg" in one:
            yield (f"link {one['name']}: {one['equivalent_mass_kg']:.4g} kg in the equations, 33/140 of each mode's "
                   "mass at its tip")  # fmt: skip
    if info["gears"]:
        gears = [[one["joint"], ", ".join(f"{k:.4g}" for k in one["stiffness"]), one["unit"],
                  _number(one["stiffness_over_EI_per_L"])] for one in info["gears"]]  # fmt: skip
        yield known_columns("Gears", ["joint", "stiffness", "unit", "over EI/L of the link"], gears)
    if info["springs"]:
        springs = [[one["joint"], *map(_number, (one["stiffness"], one["rest"], one["damping"])), one["unit"]]
                   for one in info["springs"]]  # fmt: skip
        columns = ["joint", "stiffness", "rest", "damping", "unit of stiffness"]
        yield known_columns("Springs of joints", columns, springs)


def _link(one: dict[str, Any]) -> list[str]:
    bending = [one.get(f"bending_stiffness_{axis}_Nm2") for axis in ("y", "z")]
    bare = [one.get(f"bare_bend_{axis}_Hz") for axis in ("y", "z")]
    others = [_ends(one.get(name)) for name in ("torsional_stiffness_Nm2", "axial_stiffness_N")]
    shown = ", ".join(_ends(pair) for pair in bending) if bending[0] else "-"
    rings = ", ".join(_number(value) for value in bare) if "bare_bend_y_Hz" in one else "-"
    return [one["name"], one["model"], f"{one['mass_kg']:.4g}", _number(one["length_m"]), shown, *others, rings]


def _undriven(one: dict[str, Any]) -> str:
    """What a joint without a drive does."""
    return "free" if one["state"] == "free" else "held"


def _ends(pair: list[float | None] | None) -> str:
    """A number that is the same at both ends, or both; ``rigid`` for none."""
    if pair is None:
        return "-"
    info = ["rigid" if value is None else f"{value:.4g}" for value in pair]
    return info[0] if info[0] == info[1] else f"{info[0]} to {info[1]}"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


def _limits(one: dict[str, Any]) -> str:
    if one["lower"] is None and one["upper"] is None:
        return "-"
    return f"{_number(one['lower'])} to {_number(one['upper'])} {one['unit']}"
