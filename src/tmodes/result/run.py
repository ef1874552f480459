"""``tmodes.run``: simulate a robot and give the Result, of which everything else is asked."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from tmodes.chain.chain import Chain
from tmodes.errors import InputError
from tmodes.integrate.settings import refuse_too_large
from tmodes.io.arguments import checked_arguments
from tmodes.result.result import Result, assemble_result
from tmodes.sheet import Robot, RobotPair
from tmodes.sheet.parts import Command
from tmodes.sheet.robot import refuse_other
from tmodes.simulation.parts import Journal, sample_times
from tmodes.simulation.plan import free_drive, refuse_massless
from tmodes.simulation.python_controller import Controller
from tmodes.simulation.sampled_controller import SampledController
from tmodes.simulation.simulate import simulate_motion

__all__ = ["movable_joints", "ready_to_run", "result_bytes", "run", "stands_still"]


@checked_arguments
def run(
    robot: Robot | RobotPair,
    *,
    progress: Callable[[str, float], None] = lambda stage, share: None,
    journals: Callable[[str], Journal | None] = lambda stage: None,
    controller: Controller | SampledController | None = None,
    period: float | None = None,
    stop: str | Sequence[str] = (),
) -> Result:
    """Plan with the robot as known, run the actual one under control, and return the :class:`tmodes.Result`.

    ``robot``: its ``real`` factors make the actual one; or a pair of your own. A robot without drives moves freely from
    its ``initial`` state. ``progress`` receives the stage and its share; ``journals`` gives where the stages
    ``reference`` and ``real`` keep their progress, so that an interrupted run resumes. ``controller``: a Python
    function in place of the sheet's controllers, called once every ``period`` [s] where that is given. ``stop``: one or
    several conditions, next to ``integration.stop``.

    A run that cannot continue keeps what it had: look at ``result.status`` and ``result.message``. Raises
    :class:`tmodes.errors.InputError` for what cannot be run, and :class:`tmodes.errors.SimulationError` where it cannot
    start.
    """
    refuse_other(robot, RobotPair)
    pair = robot if isinstance(robot, RobotPair) else ready_to_run(robot).pair()
    done = simulate_motion(pair, progress=progress, journals=journals, controller=controller, period=period, stop=stop)
    return assemble_result(done, pair.nominal)


_EXAMPLE = "{{joint: {name}, command: {command}, signal: {{type: quintic, start: 0.0, end: 0.5, duration: 1.0}}}}"


def result_bytes(robot: Robot) -> int:
    """Size of a robot's result in memory [bytes]; raises :class:`tmodes.errors.InputError` where it is too large."""
    samples, each = (
        len(sample_times(robot.integration)),
        _bytes_per_sample(robot.chain(), robot.integration.line_points),
    )
    refuse_too_large(robot.integration, samples, each, "a shorter duration, or fewer integration.line_points")
    return samples * each


def _bytes_per_sample(chain: Chain, stations: int) -> int:
    """Eight times the numbers of a sample: two lines of each link, fifteen numbers at each place of one that bends."""
    bending = sum(node.link.bends for node in chain.nodes)
    return 8 * (stations * (6 * len(chain.nodes) + 15 * bending) + 60 * len(chain.nodes) + 21 * len(chain.points) + 60)


def ready_to_run(robot: Robot) -> Robot:
    """The robot, if something moves it; one with an initial state and no drives runs freely, its motors without torque.

    The drives of one with a path in its task follow it.

    Raises :class:`tmodes.errors.InputError` that says what to add where joints could move and nothing moves them, or no
    mass resists a beam's functions.
    """
    refuse_massless(robot)
    robot = robot.commanded()
    if robot.drives:
        return robot
    movable = list(movable_joints(robot.chain()))
    if not movable or robot.base_motion or any(load.signal for load in robot.loads):
        return robot
    if stands_still(robot):
        name, has_motor = movable[0]
        command = Command.TORQUE if has_motor else Command.EFFORT
        shown = _EXAMPLE.format(name=name, command=Command.PRESCRIBED)
        hint = (
            f"add for each joint that moves an item such as {shown}, or command: position with a controller, or "
            f"command: {command}; or add `initial: {{coordinates: {{{name}: 0.3}}}}` to let it run freely"
        )
        raise InputError(
            "drives", f"nothing, so that no joint of {_few(movable)} moves", "a list of what moves the joints", hint
        )
    drives = tuple(free_drive(name, has_motor=has_motor) for name, has_motor in movable)
    return robot.model_copy(update={"drives": drives})


def stands_still(robot: Robot) -> bool:
    """Whether nothing moves a robot whose joints could move: no drive, no base motion, no load, no initial state."""
    moved = robot.drives or robot.base_motion or any(load.signal for load in robot.loads)
    moved = moved or robot.initial.coordinates or robot.initial.rates
    return not moved and any(movable_joints(robot.chain()))


def movable_joints(chain: Chain) -> Iterator[tuple[str, bool]]:
    """Joints that a drive could move, and whether they have a motor."""
    for node in chain.nodes:
        for axis in node.joint.axes:
            if axis.drive.is_driven:
                yield axis.name, node.joint.motor is not None


def _few(movable: list[tuple[str, bool]]) -> str:
    names = ", ".join(name for name, _ in movable[:4])
    return names + ("" if len(movable) <= 4 else f" and {len(movable) - 4} more")
