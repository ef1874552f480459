"""An arm's run and its folder; and what an arm needs before it can run."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tmodes.chain.chain import Chain, Drive, JointKind, RigidLink
from tmodes.errors import InputError
from tmodes.integrate.settings import refuse_too_large
from tmodes.report.folder import RunFolder
from tmodes.result import Result, assemble_result
from tmodes.sheet import Robot
from tmodes.sheet.parts import Command
from tmodes.simulation.trajectory import sample_times

if TYPE_CHECKING:
    from tmodes.io.urdf_shapes import LinkShape
    from tmodes.plot.save import Drawing

__all__ = ["MotionFolder", "movable_joints", "ready_to_run", "result_bytes"]

Progress = Callable[[str, float], None]

_EXAMPLE = "{{joint: {name}, command: {command}, signal: {{type: quintic, start: 0.0, end: 0.5, duration: 1.0}}}}"


class MotionFolder(RunFolder):
    """The folder of an arm's run: ``result.nc``, ``report.html``, ``figures/``; ``shapes`` are how its links look.

    Raises :class:`tmodes.errors.InputError` for an arm that nothing moves, or a result too large for memory, before
    anything is made; and on entry as :class:`tmodes.report.folder.RunFolder`.
    """

    def __init__(
        self, path: Path, arm: Robot, overwrite: bool = False, shapes: Sequence[LinkShape] = (), *, live: bool = True
    ) -> None:
        super().__init__(path, ready_to_run(arm), overwrite, live=live)
        self._size, self._shapes = result_bytes(self.robot), shapes

    def _sheet(self) -> str:
        from tmodes.io.sheet_check import sheet_data

        return json.dumps(sheet_data(self.robot))

    def _bytes(self) -> int:
        return self._size

    def _load(self) -> Result:
        return Result.load(self.result_file)

    def _computed(self, progress: Progress) -> Result:
        from tmodes.report.meshes import with_shapes
        from tmodes.simulation.simulate import simulate_motion

        run = simulate_motion(self.robot, progress=progress, journals=self._journal)
        return with_shapes(assemble_result(run, self.robot, progress=progress), self._shapes)

    def _drawn(self, result: Any) -> dict[str, Drawing]:
        from tmodes.plot import drawings

        return drawings(result)

    def _write_report(self, result: Any, pictures: dict[str, Drawing]) -> None:
        from tmodes.report.write_motion import write_arm_report

        write_arm_report(result, self.report_file, pictures, live=self.live)


def result_bytes(arm: Robot) -> int:
    """Size of an arm's result in memory [bytes]; raises :class:`tmodes.errors.InputError` where it is too large."""
    samples, each = len(sample_times(arm.integration)), _bytes_per_sample(arm.chain(), arm.integration.line_points)
    refuse_too_large(arm.integration, samples, each, "a shorter duration, or fewer integration.line_points")
    return samples * each


def _bytes_per_sample(chain: Chain, stations: int) -> int:
    """Eight times the numbers of a sample: two lines of each link, fifteen numbers at each place of one that bends."""
    bending = sum(not isinstance(node.link, RigidLink) for node in chain.nodes)
    return 8 * (stations * (6 * len(chain.nodes) + 15 * bending) + 60 * len(chain.nodes) + 21 * len(chain.points) + 60)


def ready_to_run(arm: Robot) -> Robot:
    """The arm, if something moves it; one with an initial state and no drives runs freely, its motors without torque.

    Raises :class:`tmodes.errors.InputError` that tells what to add where joints could move and nothing moves them.
    """
    if arm.drives:
        return arm
    movable = list(movable_joints(arm.chain()))
    if not movable or arm.base_motion or any(load.signal for load in arm.loads):
        return arm
    if not (arm.initial.coordinates or arm.initial.rates):
        name, has_motor = movable[0]
        command = Command.TORQUE if has_motor else Command.EFFORT
        shown = _EXAMPLE.format(name=name, command=Command.PRESCRIBED)
        hint = (
            f"add for each joint that moves an item such as {shown}, or command: position with a controller, or "
            f"command: {command}; or add `initial: {{coordinates: {{{name}: 0.3}}}}` to let it run freely"
        )
        raise InputError("drives", f"nothing, so that no joint of {_few(movable)} moves", "what moves the joints", hint)
    return arm.with_({"drives": [_free(name, has_motor) for name, has_motor in movable]})


def movable_joints(chain: Chain) -> Iterator[tuple[str, bool]]:
    """Joints that a drive could move, and whether they have a motor."""
    for node in chain.nodes:
        joint = node.joint
        if joint.kind is not JointKind.FIXED and joint.drive is not Drive.SPRING:
            yield joint.name, joint.motor is not None


def _free(name: str, has_motor: bool) -> dict[str, Any]:
    command = Command.TORQUE if has_motor else Command.EFFORT
    return {"joint": name, "command": str(command), "signal": {"type": "constant", "value": 0.0}}


def _few(movable: list[tuple[str, bool]]) -> str:
    names = ", ".join(name for name, _ in movable[:4])
    return names + ("" if len(movable) <= 4 else f" and {len(movable) - 4} more")
