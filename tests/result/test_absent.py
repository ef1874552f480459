"""A result whose robot names a kind that is not registered here opens; what needs the robot says what is missing."""

from __future__ import annotations

from pathlib import Path
from typing import Any, ClassVar, Literal

import pytest
from pydantic import Field
from typer.testing import CliRunner

import tmodes
from simulation.sheets import arm
from tmodes.cli.main import app
from tmodes.errors import TmodesError
from tmodes.kinds.controllers.registry import CONTROLLERS, Controller, Measured
from tmodes.kinds.registry import UnknownKindError
from tmodes.result.record import absent_kinds


class Proportional(Controller):
    """A spring to the wanted position."""

    sees_all: ClassVar[bool] = False
    type: Literal["proportional"] = Field(description="kind of controller")
    gain: float = 5.0

    def numbers(self) -> tuple[float, ...]:
        return (self.gain,)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        return p[0] * (m.wanted - m.position)


@pytest.fixture(scope="module")
def stored(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run under a controller of a user, whose kind is gone afterwards."""
    CONTROLLERS.register(Proportional)
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 0, 1],
             "motor": {"inertia": 0.5, "side": "joint"}}  # fmt: skip
    signal = {"type": "step", "start": 0.0, "end": 0.2, "time": 0.05}
    drive = {"joint": "j", "command": "position", "signal": signal, "controller": {"type": "proportional"}}
    load = {"name": "l", "bodies": [{"name": "b", "mass": 1.0, "center": [1, 0, 0]}]}
    settings = {"duration": 0.2, "output_step": 0.01}
    sheet = arm(gravity=0.0, joints=[joint], links=[load], drives=[drive], integration=settings)
    path = tmodes.run(sheet).save(tmp_path_factory.mktemp("absent") / "run.nc")
    CONTROLLERS.unregister("proportional")
    return path


def test_it_opens_with_a_notice(stored: Path) -> None:
    result = tmodes.Result.load(stored)
    assert (result.name, result.status) == ("test", "finished")
    (notice,) = (one for one in result.warnings if "proportional" in one)
    assert "--use" in notice
    assert result.data["q"].shape == (21, 1)
    assert result.summary()["energy"]["moved_J"] > 0
    drawn = result.figures()
    assert "joint_efforts" in drawn
    assert len(drawn["joint_efforts"]()) == 1


def test_what_needs_the_robot_names_the_kind(stored: Path) -> None:
    result = tmodes.Result.load(stored)
    for ask in (lambda: result.robot, lambda: result.actual, lambda: tmodes.run(result.robot)):
        with pytest.raises(UnknownKindError, match=r"controller.*`proportional`.*--use"):
            ask()
    CONTROLLERS.register(Proportional)
    try:
        assert tmodes.Result.load(stored).robot.name == "test"
        assert not any("proportional" in one for one in tmodes.Result.load(stored).warnings)
    finally:
        CONTROLLERS.unregister("proportional")


def test_commands_show_it(stored: Path, tmp_path: Path) -> None:
    shown = CliRunner().invoke(app, ["show", str(stored)])
    assert shown.exit_code == 0, shown.output
    assert "proportional" in shown.output
    page = tmp_path / "page.html"
    viewed = CliRunner().invoke(app, ["view", str(stored), "--no-open", "--out", str(page)])
    assert viewed.exit_code == 0, viewed.output
    assert "proportional" in page.read_text(encoding="utf-8")


def test_kinds_are_looked_for_wherever_a_sheet_names_them() -> None:
    sheet = {
        "equations": "my_system", "joints": [{"type": "no_screw", "drive": "no_muscle"}], "contact": {"law": "no_soil"},
        "links": [{"beam": {"model": "no_flexure"}}], "integration": {"method": "no_ralston"},
        "drives": [{"signal": {"type": "sum", "signals": [{"type": "no_chirp"}, {"type": "sine"}]}}],
    }  # fmt: skip
    found = " ".join(str(one) for one in absent_kinds(sheet))
    assert all(
        f"`{name}`" in found
        for name in ("my_system", "no_screw", "no_muscle", "no_soil", "no_flexure", "no_ralston", "no_chirp")
    )
    assert "`sine`" not in found
    assert (
        absent_kinds({"joints": [{"type": "revolute"}], "equations": "recursion", "integration": {"method": "auto"}})
        == []
    )


def test_use_loads_a_file_and_refuses_what_is_none(tmp_path: Path, stored: Path) -> None:
    """From the command line, in a process of its own."""
    kinds = tmp_path / "my_absent_kinds.py"
    own = Path(__file__).read_text(encoding="utf-8")
    source = own[own.index("class Proportional") : own.index("@pytest.fixture")]
    head = "from typing import Any, ClassVar, Literal\nfrom pydantic import Field\n"
    head += "from tmodes.kinds.controllers.registry import CONTROLLERS, Controller, Measured\n\n@CONTROLLERS.register\n"
    kinds.write_text(head + source, encoding="utf-8")
    try:
        shown = CliRunner().invoke(app, ["--use", str(kinds), "show", str(stored)])
        assert shown.exit_code == 0, shown.output
        assert "proportional" not in shown.output
    finally:
        CONTROLLERS.unregister("proportional")
    with pytest.raises(TmodesError, match=r"an entry point of the group tmodes\.kinds.*no_such_kinds"):
        tmodes.use("no_such_kinds")
