"""What every registry of kinds keeps; and kinds of installed packages, which are loaded when a person asks for them."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import pytest

import tmodes
import tmodes.plot
from command import tmodes as command
from tmodes.errors import InputError, TmodesError
from tmodes.integrate.registry import INTEGRATORS
from tmodes.kinds.contacts.registry import CONTACTS, SURFACES
from tmodes.kinds.controllers.registry import CONTROLLERS
from tmodes.kinds.drives.registry import DRIVES
from tmodes.kinds.joints.registry import JOINTS
from tmodes.kinds.links.registry import LINKS
from tmodes.kinds.outside import ENTRY_POINTS, USED
from tmodes.kinds.paths.registry import PATHS
from tmodes.kinds.registry import REGISTRIES, Registry, UnknownKindError
from tmodes.kinds.shapers.registry import SHAPERS
from tmodes.kinds.signals.registry import SIGNALS
from tmodes.robots import text as text_of_robot

FAMILIES = (
    CONTACTS,
    CONTROLLERS,
    DRIVES,
    tmodes.plot.FIGURES,
    INTEGRATORS,
    JOINTS,
    LINKS,
    PATHS,
    SHAPERS,
    SIGNALS,
    SURFACES,
)

MODULE = '''
from typing import Literal
from tmodes.kinds.signals.registry import SIGNALS, Signal
from tmodes.kinds.signals.schedule import SignalPieces
import numpy as np

@SIGNALS.register
class Ramp(Signal):
    """Rises by 1/s."""
    type: Literal["offered_ramp"]
    def pieces(self, until):
        return SignalPieces(np.array([0.0, until]), np.array([[0.0, 1.0]]))
'''


@pytest.mark.parametrize("registry", FAMILIES, ids=lambda one: one.noun)
def test_every_family_is_registered_alike(registry: Registry[object]) -> None:
    assert REGISTRIES[registry.noun] is registry
    assert len(registry) == len(registry.names) >= 2
    first, member = next(iter(registry.items()))
    assert registry[first] is member
    with pytest.raises(InputError, match=registry.contract.__name__):
        registry.register(int)
    with pytest.raises(UnknownKindError, match=f"Did you mean `{first}`"):
        _ = registry[f"{first}x"]
    assert f"{first}x" not in registry
    before = registry.names
    given = member if not isinstance(member, type) and registry not in (JOINTS, DRIVES) else None
    registry.register(given or (member if isinstance(member, type) else type(member)))  # the same again
    assert registry.names == before


@pytest.fixture
def offered(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """An installed package that offers a signal as an entry point."""
    (tmp_path / "offered_kinds.py").write_text(MODULE, encoding="utf-8")
    info = tmp_path / "offered_kinds-1.0.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: offered-kinds\nVersion: 1.0\n", encoding="utf-8")
    (info / "entry_points.txt").write_text(f"[{ENTRY_POINTS}]\nramps = offered_kinds\n", encoding="utf-8")
    monkeypatch.syspath_prepend(str(tmp_path))
    return "ramps"


def test_an_entry_point_is_loaded_when_it_is_asked_for(offered: str) -> None:
    """A sheet that names its kind, or its module, loads nothing."""
    move = {"joint": "joint", "command": "torque", "signal": {"type": "offered_ramp"}}
    with pytest.raises(TmodesError, match=r"signal"):
        tmodes.load("spong1987").with_({"drives": [move]})
    with pytest.raises(TmodesError, match=r"joints\.0\.drive|joints\.joint\.drive"):
        tmodes.load("spong1987").with_({"joints.joint.drive": "offered_kinds"})
    assert "offered_kinds" not in sys.modules
    assert "offered_ramp" not in SIGNALS
    try:
        assert offered in tmodes.use()
        robot = tmodes.load("spong1987").with_({"drives": [move]})
        assert robot.drives[0].signal.schedule(2.0).at(1.5) == pytest.approx(1.5)
    finally:
        SIGNALS.unregister("offered_ramp")
        sys.modules.pop("offered_kinds", None)


BROKEN = {
    "SyntaxError: '(' was never closed": "x = 1\ny = (",
    "ValueError: two lines": "import json\n\ndef late():\n    raise ValueError('two\\nlines')\n\nlate()",
    "JSONDecodeError: Expecting value": "import json\n\njson.loads('')",
    "ModuleNotFoundError: No module named 'no_such_library'": "import no_such_library",
    "SystemExit: 3": "import sys\n\nsys.exit(3)",
    "GeneratorExit": "raise GeneratorExit",
    "Own: mine": "class Own(BaseException): ...\n\nraise Own('mine')",
    "TypeError": "from tmodes.kinds.signals.registry import SIGNALS\nSIGNALS.register(int, 1)",
}
LINES = dict(zip(BROKEN, (2, 4, 3, 1, 3, 1, 3, 2), strict=True))


@pytest.mark.parametrize("words", BROKEN)
def test_code_that_cannot_be_loaded_is_reported_at_its_line(words: str, tmp_path: Path) -> None:
    """It is the user's file that is wrong; nothing is kept of it."""
    file = tmp_path / f"broken_kinds_{LINES[words]}.py"
    file.write_text(BROKEN[words], encoding="utf-8")
    with pytest.raises(InputError) as wrong:
        tmodes.use(str(file))
    assert wrong.value.where == f"{file.name}:{LINES[words]}"
    assert wrong.value.got.startswith(words)
    assert str(file) in wrong.value.expected
    assert str(file.resolve()) not in USED
    done = command("--use", file, "check", "spong1987", code=2)
    assert f"{file.name}:{LINES[words]}: " in done.stderr


@pytest.mark.parametrize("name", ["numpy.py", "json.py", "scipy.py", "my.kinds.py"])
def test_a_file_under_the_name_of_another_module(name: str, tmp_path: Path) -> None:
    """It gets a name of its own, takes the place of none, and finds the installed ones and what lies beside it."""
    file = tmp_path / name
    file.write_text("import numpy, beside\nassert numpy.pi > beside.THREE\n" + MODULE, encoding="utf-8")
    (tmp_path / "beside.py").write_text("THREE = 3", encoding="utf-8")
    (tmp_path / "yaml.py").write_text("raise ValueError", encoding="utf-8")
    before = sys.modules.copy()
    try:
        tmodes.use(str(file))
        assert "offered_ramp" in SIGNALS
        assert {key: sys.modules[key] for key in before} == before
        tmodes.use(str(file))  # once
    finally:
        SIGNALS.unregister("offered_ramp")
        for key in sys.modules.keys() - before.keys():
            del sys.modules[key]


def test_sys_exit_of_a_kind_is_no_success(tmp_path: Path) -> None:
    """It leaves after the sheet was read; the message names the line."""
    file = tmp_path / "leaving_kinds.py"
    text = MODULE.replace("return ", "raise SystemExit(0)\n        return ")
    file.write_text(text, encoding="utf-8")
    (sheet := tmp_path / "own.yaml").write_text(
        re.sub(r"signal: \{.*\}", "signal: {type: offered_ramp}", text_of_robot("spong1987")), encoding="utf-8"
    )
    try:
        done = command("--use", file, "run", sheet, "--out", tmp_path / "run", code=2)
    finally:
        SIGNALS.unregister("offered_ramp")
        sys.modules.pop("leaving_kinds", None)
    assert "leaving_kinds.py:" in done.stderr


@pytest.mark.parametrize("registry", FAMILIES, ids=lambda one: one.noun)
def test_kinds_of_tmodes_are_brought_by_the_names_that_they_have(registry: Registry[object]) -> None:
    names = registry.names
    assert all(registry[name] in registry.members for name in names)
    assert registry.names == names
    assert not [member for member in registry.outside if type(member).__module__.startswith("tmodes.plot")]
