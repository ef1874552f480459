"""The equations at given states, and what looks wrong in a sheet: what ``tmodes eval`` and ``check`` compute."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from tmodes.errors import InputError, SimulationError
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table
from tmodes.io.words import count_of

if TYPE_CHECKING:
    from xarray import Dataset

    from tmodes.analysis.margins import Margins
    from tmodes.io.states import ChainStates, States
    from tmodes.model.model import Model
    from tmodes.sheet import Robot

__all__ = ["Check", "Evaluation", "check", "evaluate"]


@checked_arguments
def check(robot: Robot) -> Check:
    """What looks implausible in a checked sheet, a wrong unit say, and why it cannot run as it stands.

    Wrong values were refused when it was loaded, all at once. Raises :class:`tmodes.errors.InputError` for stop
    conditions that name nothing.

    >>> tmodes.load("spong1987").check().warnings
    []
    """
    from tmodes.analysis.consequences import consequences
    from tmodes.io.sheet_plausible import notices_about
    from tmodes.model.model import Model
    from tmodes.simulation.outputs import refuse_wrong_stops

    real = robot.pair().real
    refuse_wrong_stops(real)
    coordinates = Model(real.chain()).coordinates
    starting, loops = _starting(robot)
    return Check(robot, tuple(coordinates), [*notices_about(robot), *consequences(robot), *starting], loops)


def _starting(robot: Robot) -> tuple[list[str], dict[str, Margins]]:
    """Why the robot cannot run as it stands, or that its start is no equilibrium; margins of sampled loops by drive."""
    from tmodes.result.run import ready_to_run
    from tmodes.simulation.initial_state import run_setup
    from tmodes.simulation.warnings import departures

    try:
        setup = run_setup(ready_to_run(_rigidly(robot)).pair().real)
    except (InputError, SimulationError) as error:
        return [f"`tmodes run` needs more: {error}"], {}
    from tmodes.simulation.drive_loops import start_loops

    loops, more = start_loops(setup, margins=True)
    return [*departures(setup, setup.first_row), *more], loops


def _rigidly(robot: Robot) -> Robot:
    """The robot whose reference is that of the rigid one, which is found at once."""
    from tmodes.sheet.task import ReferenceKind

    if not (robot.task and robot.task.paths):
        return robot
    task = robot.task.model_copy(update={"reference": ReferenceKind.RIGID, "least_time": False})
    return robot.model_copy(update={"task": task})


@dataclass(frozen=True, eq=False, repr=False)
class Check(CommandResult):
    """A valid sheet; ``found``: what looks implausible in it; ``loops``: margins of sampled controllers by drive."""

    robot: Robot = field(repr=False)
    coordinates: tuple[str, ...]
    found: Sequence[str] = ()
    loops: Mapping[str, Margins] = field(default_factory=dict)

    @property
    def warnings(self) -> list[str]:
        """What looks implausible in it."""
        return list(self.found)

    @property
    def driven(self) -> list[str]:
        """Joints with a drive."""
        return [drive.joint for drive in self.robot.drives]

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes check --json`` prints it."""
        robot = self.robot
        return {
            "ok": True, "name": robot.name, "kind": robot.kind, "equations": robot.equations,
            "contact": robot.contact is not None, "coordinates": list(self.coordinates), "drives": self.driven,
            "notes": robot.held_notices, "warnings": self.warnings,
            "loops": {name: one._asdict() for name, one in self.loops.items()},
        }  # fmt: skip

    @property
    def data(self) -> Dataset:
        """``initial`` (coordinate): the coordinates at time 0 that the sheet gives [rad, m], 0 where it gives none."""
        from xarray import Dataset

        given = self.robot.initial.coordinates
        initial = [float(given.get(name, 0.0)) for name in self.coordinates]
        return Dataset({"initial": ("coordinate", initial)}, {"coordinate": list(self.coordinates)})

    def plot(self, ax: Any = None) -> list[Any]:
        """The lines of the undeformed links, in the plane in which they extend most."""
        from tmodes.analysis.line.line import elastic_line
        from tmodes.model.model import Model
        from tmodes.plot.commands import shape

        model = Model(self.robot.undriven.chain())
        lines = elastic_line(model, [0.0] * model.nq).links.values()
        return shape({"undeformed": [line.position[0] for line in lines]}, title=self.robot.name, ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """That it is valid, what it has, and what looks implausible."""
        robot = self.robot
        bending = sum(bool(link.beam and link.beam.coordinate_count) for link in robot.links)
        counts = [count_of(len(robot.joints), "joint"), count_of(bending, "flexible link")]
        counts += [count_of(len(self.coordinates), "coordinate"), count_of(len(self.driven), "drive")]
        contact = "contact on" if robot.contact else "contact off" if robot.contact_off else "no contact"
        yield f"{robot.name}: valid ({', '.join([*counts, contact, f'equations: {robot.equations}'])})"
        of = " of the actual robot" if robot.real else ""
        yield from (f"loop of drive {name}{of}: {one.words}" for name, one in self.loops.items())
        yield from (f"note: {note}" for note in robot.held_notices)
        yield from (f"warning: {warning}" for warning in self.warnings)


UNITS = {
    "q": "rad, m along prismatic joints, 1 of stretch",
    "v": "of q, per s",
    "a": "of q, per s^2",
    "effort": "N*m, N along prismatic joints",
    "M": "kg*m^2, kg*m, kg",
    "h": "N*m, N: Coriolis, centrifugal and gravity",
    "g": "N*m, N: gravity alone",
    "f_el": "N*m, N: springs, dampers and friction",
    "position": "m",
    "rotation": "1",
    "velocity": "m/s",
    "J": "m/rad, then rad/rad: velocity of the point, then angular velocity, per rate",
    "energies": "J",
    "losses": "W",
}
"""What each answer is given in; M a + h + f_el = effort of the motors and joints."""

_MOST_NUMBERS = 20_000_000
"""Numbers of all answers together beyond which they are refused."""


@checked_arguments
def evaluate(
    robot: Robot, states: States, *, contact: bool = False, nominal: bool = False, reading: str | None = None
) -> Evaluation:
    """Mass matrix, bias, forces, accelerations, points, Jacobians and energies at given states.

    M a + h + f_el = effort, free of contact and loads, with gravity g; SI units, see :data:`UNITS`. ``states``: records
    with q, v and effort, arrays or numbers by name, or a file of them, JSON or .csv. Of the real robot, or the
    ``nominal`` one; ``reading``: of a sheet of the 2010 robot, whose states may also be phi (6), phid (6) and the
    voltage u: then H phidd + h + f_el + f_di + J^T F = Q, in ``contact`` or free.

    Raises :class:`tmodes.errors.InputError` that names the record and the field of a wrong value, and
    :class:`tmodes.errors.SimulationError` where a term is not finite.

    >>> tmodes.load("spong1987").eval([{"q": [0.1, 0.1]}]).answers[0]["g"]
    [0.0, ...]
    """
    from tmodes.interface.evaluate_phi import evaluate_phi
    from tmodes.io.states import holds_phi, read_phi_states, read_states
    from tmodes.model.model import Model

    sheet = robot if reading is None else robot.with_({"reading": reading})
    phi = bool(sheet.imported) and holds_phi(states)
    if contact and not phi:
        expected, hint = "left out: its terms are those in free space", "evaluate a sheet of the 2010 robot"
        raise InputError("--contact", f"the robot {sheet.name}", expected, f"{hint}, or leave it out")
    pair = (sheet.with_({"contact": contact}) if phi else sheet).pair()
    chosen = pair.nominal if nominal else pair.real
    if phi:
        return Evaluation(chosen.name, (), (), evaluate_phi(chosen, read_phi_states(states)))
    model = Model(chosen.undriven.chain())  # every joint with its motor, none prescribed
    answers = list(_terms_at(model, read_states(states, model.coordinates, model.efforts)))
    return Evaluation(chosen.name, model.coordinates, model.efforts, answers)


@dataclass(frozen=True, eq=False, repr=False)
class Evaluation(CommandResult):
    """All terms of the equations at each state; ``answers``: one group of plain data for each."""

    name: str
    coordinates: tuple[str, ...]
    efforts: tuple[str, ...]
    answers: list[dict[str, Any]] = field(repr=False)

    @property
    def of_paper(self) -> bool:
        """Whether they are in the coordinates of the 2010 robot."""
        return not self.coordinates

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes eval --json`` prints it."""
        names = {"coordinates": list(self.coordinates), "efforts": list(self.efforts)}
        return {"arm": self.name, **names, "units": UNITS, "states": self.answers}

    @property
    def data(self) -> Dataset:
        """Along ``state``: q, v, a, h, g, f_el (coordinate), ``M`` (coordinate, along) and the energies [SI].

        Of the 2010 robot's coordinates phi, phid, phidd, h, f_el, f_di, Q and ``H``.
        """
        from xarray import Dataset

        from tmodes.interface.evaluate_phi import COORDINATES

        vectors, matrix = ("q", "v", "a", "h", "g", "f_el"), "M"
        if self.of_paper:
            vectors, matrix = ("phi", "phid", "phidd", "h", "f_el", "f_di", "Q"), "H"
        series: dict[str, Any] = {name: (("state", "coordinate"), [one[name] for one in self.answers])
                                  for name in vectors}  # fmt: skip
        series[matrix] = (("state", "coordinate", "along"), [one[matrix] for one in self.answers])
        series |= {name: ("state", values, {"units": "J"}) for name, values in self._energies().items()}
        names = list(COORDINATES if self.of_paper else self.coordinates)
        return Dataset(series, {"coordinate": names, "along": names})

    def _energies(self) -> dict[str, list[float]]:
        if self.of_paper:
            return {name: [one[name] for one in self.answers] for name in _PAPER_ENERGIES}
        names = self.answers[0]["energies"] if self.answers else ()
        return {name: [one["energies"][name] for one in self.answers] for name in names}

    def plot(self, ax: Any = None) -> list[Any]:
        """The energies at each state."""
        from tmodes.plot.commands import points

        number = list(range(len(self.answers)))
        shown = {name: (number, values) for name, values in self._energies().items()}
        return points(shown, "state", "energy [J]", title=self.name, ax=ax)

    def tables(self) -> Iterator[str | Table]:
        """Accelerations and energies."""
        from tmodes.interface.evaluate_phi import COORDINATES

        if self.of_paper:
            rows = [[str(k), *(f"{x:.6g}" for x in one["phidd"])] for k, one in enumerate(self.answers)]
            yield Table("Accelerations [rad/s^2]", ["state", *COORDINATES], rows)
            rows = [[str(k), *(f"{one[name]:.6g}" for name in _PAPER_ENERGIES)] for k, one in enumerate(self.answers)]
            yield Table("Energies [J], Rayleigh function [W]", ["state", *_PAPER_ENERGIES], rows)
            yield "All terms (H, h, f_el, f_di, Q, J, tip, forces): add --json"
            return
        few = self.answers[:6]
        rows = [[name, *(f"{one['a'][i]:.6g}" for one in few)] for i, name in enumerate(self.coordinates)]
        yield Table("Accelerations [rad/s^2, m/s^2]", ["coordinate", *(f"state {k}" for k in range(len(few)))], rows)
        names = [*self.answers[0]["energies"], *self.answers[0]["losses"]]
        rows = [[str(k), *(f"{value:.6g}" for value in (*one["energies"].values(), *one["losses"].values()))]
                for k, one in enumerate(self.answers)]  # fmt: skip
        yield Table("Energies [J], losses [W]", ["state", *names], rows)
        yield "All terms (M, h, g, f_el, points, J): add --json"


_PAPER_ENERGIES = ("kinetic", "potential_gravity", "potential_elastic", "rayleigh", "energy")


def _terms_at(model: Model, states: ChainStates) -> Iterator[dict[str, Any]]:
    """The terms at each state, free of contact and loads.

    Raises :class:`tmodes.errors.InputError` for more than memory should hold, and
    :class:`tmodes.errors.SimulationError` naming the state where a term is not finite.
    """
    from tmodes.interface.evaluate_phi import check_finite

    points = [point.name for point in model.parts.points]
    numbers = len(states.q) * model.nq * (model.nq + 6 * len(points) + 8)
    if numbers > _MOST_NUMBERS:
        got = f"{len(states.q)} states of {model.nq} coordinates"
        raise InputError("--states", got, f"at most {_MOST_NUMBERS} numbers in all answers", "split the file")
    q, v = states.q, states.v
    terms = {
        "a": model.forward_dynamics(q, v, states.effort),
        "M": model.mass_matrix(q),
        "h": model.bias(q, v),
        "g": model.gravity(q),
        "f_el": model.elastic_forces(q, v),
    }
    check_finite(terms, "keep q and v within what a robot can do, and give what moves a mass")
    motion, jacobian = model.points(q, v), model.jacobian(q)
    energies, losses = model.energies(q, v), model.losses(q, v)
    for k in range(len(q)):
        yield {
            "q": q[k].tolist(), "v": v[k].tolist(), "effort": states.effort[k].tolist(),
            **{name: values[k].tolist() for name, values in terms.items()},
            "points": {
                name: {"position": motion.position[k, i].tolist(), "rotation": motion.rotation[k, i].tolist(),
                       "velocity": motion.velocity[k, i].tolist(), "J": jacobian[k, i].tolist()}
                for i, name in enumerate(points)
            },
            "energies": {name: float(values[k]) for name, values in energies.items()},
            "losses": {name: float(values[k]) for name, values in losses.items()},
        }  # fmt: skip
