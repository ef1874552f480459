"""Robot and Result: the two objects that a user holds, with every command as a method; how they are loaded and run."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, cast

from tmodes.errors import InputError
from tmodes.interface import (
    batches,
    checks,
    comparing,
    description,
    following,
    hierarchy,
    inverse,
    learning,
    linear,
    modes,
    motions,
    shaping,
    statics,
    studies,
    tuning,
)
from tmodes.interface.integration import prepared, run_changes
from tmodes.io.arguments import checked_arguments
from tmodes.io.printed import CommandResult, Table, shortened, table_html
from tmodes.result import result as lower
from tmodes.sheet import robot as sheet

if TYPE_CHECKING:
    from tmodes.equations.loop.outputs import Outputs
    from tmodes.report.notebook import Shown
    from tmodes.sheet.robot import RobotPair
    from tmodes.simulation.parts import Journal
    from tmodes.simulation.python_controller import Controller
    from tmodes.simulation.sampled_controller import SampledController

__all__ = ["Result", "Robot", "load", "run"]

Progress = Callable[[str, float], None]
HEIGHT = 760
"""Height of a viewer in a notebook [pixels]."""


def load(
    name_or_path: str | os.PathLike[str],
    changes: Mapping[str, Any] | None = None,
    *,
    roots: Sequence[str | os.PathLike[str]] = (),
    trust_paths: bool = False,
    fix_inertia: bool = False,
) -> Robot:
    """A checked robot from the name of a published one, or from a file (a name wins; write ``./name`` for a file).

    A file is a data sheet, a Denavit-Hartenberg table, URDF, xacro, MJCF, an elasticity file of a URDF, or a sheet of
    the 2010 robot. ``changes`` are values by dotted path; ``roots`` and ``trust_paths`` say where the files that a file
    names may lie; ``fix_inertia``: impossible inertias of a URDF are raised to possible ones. Raises
    :class:`tmodes.errors.InputError` when there is no such robot or it cannot be read, and
    :class:`tmodes.errors.InputErrors` with all wrong values and their lines.

    >>> tmodes.load("spong1987").name
    'spong1987'
    """
    from tmodes.robots.load import load as loaded

    how = {"roots": roots, "trust_paths": trust_paths, "fix_inertia": fix_inertia}
    return Robot.of(loaded(name_or_path, changes, **how))


@checked_arguments
def run(
    robot: sheet.Robot | RobotPair,
    *,
    reading: str | None = None,
    contact: bool | None = None,
    integrator: str | None = None,
    rtol: float | None = None,
    atol: float | None = None,
    check_error: bool = False,
    error_estimate: bool = True,
    model_error: bool = True,
    duration: float | None = None,
    stop: str | Sequence[str] = (),
    stop_at_limits: bool = False,
    settling_band: str | float | None = None,
    controller: Controller | SampledController | None = None,
    period: float | None = None,
    out: str | os.PathLike[str] | None = None,
    overwrite: bool = False,
    report: bool = True,
    figures: bool = False,
    live: bool = True,
    progress: Progress = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
) -> Result:
    """Plan with the robot as known, run the actual one under control, and return the :class:`tmodes.Result`.

    ``robot``: its ``real`` factors make the actual one; or a pair of your own, which takes none of the settings. A
    robot without drives moves freely from its ``initial`` state; one with a path in its ``task`` follows it as
    :func:`tmodes.follow` says. ``reading``: of a sheet of the 2010 robot;
    ``contact``: touch the environment, or not; ``integrator``, ``rtol``, ``atol``, ``check_error``,
    ``error_estimate``, ``model_error``, ``duration`` [s], ``stop_at_limits`` and ``settling_band`` set the keys of
    ``integration`` by these names; ``stop``: one or several conditions, next to ``integration.stop``. ``controller``:
    a Python function in place of the sheet's controllers, called once every ``period`` [s] with a
    :class:`tmodes.simulation.sampled_controller.Measurement`, see docs/controllers.md; without a period with time, q
    and v at every stage of every step. ``out``: a folder for result.nc and, unless ``report`` is False, report.html
    (``live``: that runs again in the page), ``figures`` as files; ``overwrite`` what is there. ``progress`` receives
    the stage and its share; ``journals`` gives where the stages
    ``reference`` and ``real`` keep their progress, so that an interrupted run resumes.

    A run that cannot continue keeps what it had: look at ``result.status`` and ``result.message``. Raises
    :class:`tmodes.errors.InputError` for what cannot be run, :class:`tmodes.errors.SimulationError` where it cannot
    start, and :class:`tmodes.errors.ResultFileError` where the folder cannot be written.

    >>> tmodes.run(tmodes.load("spong1987"), duration=0.1).status
    'finished'
    """
    from tmodes.result.run import run as simulated
    from tmodes.sheet.robot import Robot as Sheet

    changes = run_changes(
        integrator=integrator, rtol=rtol, atol=atol, check_error=check_error, error_estimate=error_estimate,
        model_error=model_error, duration=duration, stop_at_limits=stop_at_limits, settling_band=settling_band,
    )  # fmt: skip
    if isinstance(robot, Sheet):
        robot = prepared(robot, reading, contact, changes, stop_at_limits=stop_at_limits).commanded(progress)
    elif changes or reading is not None or contact is not None or out is not None:
        hint = "set them in both robots of the pair"
        raise InputError("settings of a run", "given for a pair of robots", "left out for a pair", hint)
    how: dict[str, Any] = {"progress": progress, "controller": controller, "period": period, "stop": stop}
    if out is None or not isinstance(robot, Sheet):
        return Result.like(simulated(robot, journals=journals, **how))
    from tmodes.report.folder import RunFolder

    with RunFolder(Path(out), robot, overwrite, live=live, resumes=not (controller or stop)) as folder:
        del how["progress"]
        found = folder.simulate(progress, **how)
        if fault := folder.products(found, progress, report=report, figures=figures):
            raise fault
    return Result.like(found)


class Robot(sheet.Robot):
    """A robot: joints and links in a tree, what drives and loads it, and how it really is; every command is a method.

    A data sheet that is checked and does not change: :meth:`with_` gives a changed one. Units are SI, angles radians.

    >>> robot = tmodes.load("spong1987")
    >>> stiffer = robot.with_({"gear.stiffness": 200.0})
    >>> stiffer.joints[0].gear.stiffness
    (200.0,)
    """

    run = run
    modes = modes.modes
    static = statics.static
    inverse = inverse.inverse
    describe = description.describe
    linearize = linear.linearize
    learn = learning.learn
    follow = following.follow
    shaper = shaping.shaper
    hierarchy = hierarchy.hierarchy
    batch = batches.batch
    compare = comparing.compare
    tune = tuning.tune
    study = studies.study
    sensitivity = studies.sensitivity
    optimize = studies.optimize
    gradient = studies.gradient
    motion = motions.motion
    check = checks.check
    eval = checks.evaluate

    @classmethod
    def of(cls, robot: sheet.Robot) -> Self:
        """The same robot as one with these methods.

        >>> tmodes.Robot.of(tmodes.load("spong1987").pair().real).name
        'spong1987'
        """
        sheet.refuse_other(robot)
        if isinstance(robot, cls):
            return robot
        made = cls.model_construct(robot.model_fields_set, **{name: getattr(robot, name) for name in cls.model_fields})
        vars(made).update({name: value for name, value in vars(robot).items() if name == "_chain"})
        return made

    @property
    def outputs(self) -> Outputs:
        """All numbers of an instant of a run by name, each with ``unit`` and ``meaning``, as ``tmodes outputs``.

        Raises :class:`tmodes.errors.InputError` for a robot that cannot run.

        >>> tmodes.load("spong1987").outputs["joint.gear_twist"].unit
        'rad'
        """
        from tmodes.simulation.outputs import robot_outputs

        return robot_outputs(self)

    @classmethod
    def from_data(cls, data: Mapping[str, Any]) -> Self:
        """A checked robot from plain data (as a YAML file holds it); numbers may be text with a unit.

        Raises :class:`tmodes.errors.InputErrors` with everything that is wrong.

        >>> link = {"name": "rod", "bodies": [{"mass": "1 kg", "center": [0.5, 0, 0], "inertia": 0.1}]}
        >>> joint = {"name": "hinge", "type": "revolute", "child": "rod", "axis": [0, 1, 0]}
        >>> tmodes.Robot.from_data({"format": 1, "kind": "arm", "name": "pendulum", "joints": [joint], "links": [link]})
        pendulum...
        """
        return cls.of(super().from_data(data))

    def with_(self, changes: Mapping[str, Any]) -> Self:
        """A new, checked robot with values changed by path, or by any ending of a path that only one place has.

        Items of lists go by their name or their index; numbers in SI units, or text with a unit. Raises
        :class:`tmodes.errors.InputErrors` that name the path.

        >>> robot = tmodes.load("spong1987")
        >>> robot.with_({"joints.joint.gear.stiffness": 80.0}) == robot.with_({"gear.stiffness": 80.0})
        True
        """
        return self.of(super().with_(changes))

    def show(self, height: int = HEIGHT) -> Shown:
        """The viewer of this robot at rest with its modes, for a notebook; ``height`` in pixels.

        Raises :class:`tmodes.errors.SimulationError` where it has no rest.

        >>> tmodes.load("spong1987").show()
        <tmodes view of ...>
        """
        from tmodes.report.notebook import show

        return show(self, height=height)

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, sheet.Robot):
            return NotImplemented
        return all(getattr(self, name) == getattr(other, name) for name in type(self).model_fields)

    __hash__ = None  # type: ignore[assignment]  # as any data sheet, which holds groups by names

    def _tables(self) -> Iterator[str | Table]:
        yield f"{self.name}: {self.title or 'a robot'}"
        run = self.integration
        contact = "in contact" if self.contact else "contact off" if self.contact_off else "no contact"
        count = len(self.chain().coordinates)
        yield f"{count} coordinates, equations: {self.equations}, {contact}, {run.duration:g} s by {run.method}"
        driven = {drive.joint: f"{drive.command} {drive.signal.name_of_kind()}" for drive in self.drives}
        rows = [
            [joint.name, str(joint.type), ", ".join(f"{k:g}" for k in joint.gear.stiffness) if joint.gear else "-",
             joint.child, driven.get(joint.name, "-")]
            for joint in self.joints
        ]  # fmt: skip
        yield Table("", ["joint", "type", "gear stiffness [SI]", "carries", "drive"], rows)
        if self.task and self.task.paths:
            yield f"task: {', '.join(str(one.type) for one in self.task.paths)}, reference {self.task.reference}"
        beams = {link.name: cast("Any", link.beam) for link in self.links if link.beam and link.beam.coordinate_count}
        if beams:
            yield f"flexible links: {', '.join(f'{name} ({beam.model})' for name, beam in beams.items())}"

    def __repr__(self) -> str:
        return shortened(self._tables(), "the whole sheet: robot.describe()")

    __str__ = __repr__

    def _repr_html_(self) -> str:
        return "".join(map(table_html, self._tables()))


_SHOWN = 30, 80
"""Lines of a result, its verdict, a dozen numbers, its events, and characters of each."""


class Result(lower.Result, CommandResult):  # pyright: ignore[reportIncompatibleVariableOverride]
    """What a run gave: named series with units in ``data``, and what is asked of them.

    >>> result = tmodes.load("spong1987").run(duration=0.1)
    >>> result.status, result.data["tip"].dims
    ('finished', ('time', 'axis'))
    """

    @classmethod
    def like(cls, found: lower.Result) -> Self:
        """The same result as one with these methods.

        >>> tmodes.Result.like(result).status
        'finished'
        """
        made = cls.__new__(cls)
        vars(made).update(vars(found))
        return made

    @property
    def robot(self) -> Robot:  # pyright: ignore[reportIncompatibleVariableOverride]
        """The robot that ran, as it is known.

        Raises :class:`tmodes.kinds.registry.UnknownKindError` where it names a kind that is not registered here.
        """
        return Robot.of(super().robot)

    @property
    def actual(self) -> Robot:  # pyright: ignore[reportIncompatibleVariableOverride]
        """The robot as it really ran, its ``real`` factors taken; raises as :attr:`robot`."""
        return Robot.of(super().actual)

    def info(self) -> dict[str, Any]:
        """Plain data, as ``tmodes run --json`` and ``tmodes show --json`` print it.

        >>> result.info()["status"]
        'finished'
        """
        from tmodes.interface.summary import result_record

        return result_record(self)

    @checked_arguments
    def tables(self, everything: bool = False) -> Iterator[str | Table]:
        """The verdict in words, a dozen numbers, its events; or ``everything``: all numbers, with their errors, steps.

        >>> [part.title for part in result.tables() if not isinstance(part, str)]
        ['spong1987: finished']
        """
        from tmodes.interface.summary import run_tables

        yield from run_tables(self, everything=everything, more="all numbers with their errors: .tables(True)")

    def __repr__(self) -> str:
        return shortened(self.tables(), "print them with .tables()", *_SHOWN)

    @checked_arguments
    def plot(self, ax: Any = None, name: str | None = None) -> list[Any]:
        """Draw one of the figures, by ``name`` (:meth:`figures` has them), the first one if none is named.

        An output by its name, such as ``tip.speed``, is a figure too. Raises :class:`tmodes.errors.InputError` for what
        this result cannot fill.

        >>> tmodes.load("spong1987").run(duration=0.1).plot(name="joint_tracking")
        [<Axes: ...>...]
        """
        from tmodes.plot.figure import FIGURES, output_figure

        if name and "." in name:
            return output_figure(self, name, ax)
        figure = FIGURES[name or next(iter(self.figures()))]
        return figure(self, ax)

    def figures(self) -> dict[str, Callable[..., list[Any]]]:
        """The figures that this result can fill: name -> function that draws it, ``figures()["tip_tracking"]()``.

        >>> "tip_tracking" in result.figures()
        True
        """
        from tmodes.plot import all_figures

        return all_figures(self)

    def show(self, height: int = HEIGHT) -> Shown:
        """The viewer of this run for a notebook: the robot in 3D, linked charts, numbers; ``height`` in pixels.

        >>> result.show()
        <tmodes view of ...>
        """
        from tmodes.report.notebook import show

        return show(self, height=height)

    def _repr_html_(self) -> str:
        return CommandResult._repr_html_(self)
