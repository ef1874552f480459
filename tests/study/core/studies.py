"""Studies that are tested here, as plain data and as files."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tmodes.study.read import read_study, study_from_data
from tmodes.study.study import Study

UNIFORM = {"type": "uniform", "low": 0.0, "high": 1.0}

LUMPED = """\
format: 1
kind: arm
name: lumped
gravity: 0.00981   # so little that the arm stays straight but for a part in 1e9
joints:
  - name: joint
    type: revolute
    child: link
    axis: [0, 1, 0]
    motor: {inertia: 1.0, side: joint}
    gear: {stiffness: 2000.0, damping: 0.0}
links:
  - name: link
    bodies: [{name: payload, mass: 1.5, at: 1.0}]
    beam:
      model: strain
      functions: {bend_y: 2}
      length: 1.0
      damping_time: 0.0
      rotary_inertia: none
      section: {bending_stiffness: 150.0, mass_per_length: 1.0e-6}
"""
"""The arm of the reference values p01 and p02: gear, link without mass, payload; the motor is held."""

FORMULA = "m*9.81*(1/k + 1/(3*EI))"
"""Its sag [m]: gear and beam one after the other, length 1 m."""


def study(parameters: dict[str, Any] | None = None, quantities: dict[str, Any] | None = None, **more: Any) -> Study:
    """A study of expressions, of one parameter unless others are given."""
    functions = more.pop("functions", None)
    plan = more.pop("plan", {"type": "monte_carlo", "runs": 8})
    return study_from_data({
        "format": 1, "kind": "study", "name": "test",
        "parameters": parameters or {"x": {"distribution": UNIFORM}},
        "quantities": quantities or {"y": {"expression": next(iter(parameters or {"x": 0}))}},
        **({"plan": plan} if plan else {}), **more,
    }, functions=functions)  # fmt: skip


def short(quantities: dict[str, Any], parameters: dict[str, Any] | None = None, **more: Any) -> Study:
    """A study of a tenth of a second of the 2010 robot, with its gear varied."""
    gear = {"path": "gear.stiffness", "relative": True, "distribution": {"type": "uniform", "low": 0.8, "high": 1.2}}
    settings = {"integration.duration": 0.1, "integration.output_step": 0.01}
    return study(parameters or {"gear": gear}, quantities, **{"robot": "filipovic2010", "set": settings, **more})


def written(folder: Path, text: str, **files: str) -> Study:
    """The study of a text, read from a file of a folder with other ``files``, named with _ for the dot."""
    for name, content in files.items():
        (folder / name.replace("_", ".")).write_text(content, encoding="utf-8")
    (folder / "study.yaml").write_text(text, encoding="utf-8")
    return read_study(folder / "study.yaml")
