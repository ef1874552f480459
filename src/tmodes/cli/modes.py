"""``tmodes modes``: frequencies, damping, and the dominant element of each mode of vibration."""

from __future__ import annotations

import math
from typing import Annotated

import typer

from tmodes.cli.options import (
    AsJson,
    FixInertia,
    ReadingOption,
    Roots,
    Settings,
    SheetArgument,
    TrustPaths,
    chosen_sheet,
)
from tmodes.cli.static import PoseOption
from tmodes.cli.terminal import print_result, working

__all__ = ["modes"]


def modes(
    robot: SheetArgument,
    reading: ReadingOption = None,
    settings: Settings = None,
    contact: Annotated[bool, typer.Option("--contact", help="With the tip on the environment.")] = False,
    angle: Annotated[
        float | None, typer.Option(help="Angle of the first drive's motor in rad; else the start of its move.")
    ] = None,
    at: PoseOption = None,
    max_frequency: Annotated[
        float, typer.Option("--max-frequency", help="Highest natural frequency that is shown [Hz].")
    ] = math.inf,
    root: Roots = None,
    trust_paths: TrustPaths = False,
    fix_inertia: FixInertia = False,
    as_json: AsJson = False,
) -> None:
    """Natural frequencies and damping ratios about the static equilibrium, of the actual and the nominal robot.

    Under its loads, its motors at their first command or `--at` a pose. Where drives or the base turn at
    constant speed, about that motion, with its centrifugal and gyroscopic forces. All numbers are of the pole p, an
    eigenvalue of mass, damping, stiffness and controllers: `natural` |p|/2 pi, `damped` Im p/2 pi, damping ratio
    -Re p/|p|. An over-damped mode has two real poles, and a line with its time constant -1/p for each. Modes marked !
    change with more functions.
    """
    from tmodes.interface.modes import modes as found_of

    sheet = chosen_sheet(robot, settings, reading, roots=root, trust_paths=trust_paths, fix_inertia=fix_inertia)
    with working("preparing") as tell:
        found = found_of(sheet, contact=contact, angle=angle, at=at, max_frequency=max_frequency, progress=tell)
    print_result(found, as_json)
