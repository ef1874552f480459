"""tmodes models, simulates and controls robots that bend: elastic gears, flexible links, a tip that touches the world.

    Robot -splits-> Mechanism + Parameters -derive-> equations -compile-> Model -simulate-> Result --> plot, report
    (WHAT)                                 (LAW)                 (RUN)             (SEE)

The names below are loaded when they are first used, so that ``import tmodes`` itself is light.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.equations.lagrange.system import System
    from tmodes.errors import TmodesError
    from tmodes.model.model import Model
    from tmodes.notebook import show
    from tmodes.paper.mechanism import Drive, Mechanism, Parameters, Reading
    from tmodes.paper.model import PaperModel
    from tmodes.paper.sheet import PaperPair, PaperRobot
    from tmodes.result.record import PaperResult
    from tmodes.result.result import Result
    from tmodes.result.run import run
    from tmodes.robots import load_robot
    from tmodes.robots.load import load
    from tmodes.sensitivity.functional import Functional, tracking_error
    from tmodes.sensitivity.gradient import adjoint_gradient, forward_sensitivities
    from tmodes.sheet.robot import Robot
    from tmodes.simulation.simulate import simulate_motion
    from tmodes.simulation.vary.simulate import simulate_batch

__version__ = "0.1.0"

__all__ = [
    "Drive",
    "Functional",
    "Mechanism",
    "Model",
    "PaperModel",
    "PaperPair",
    "PaperResult",
    "PaperRobot",
    "Parameters",
    "Reading",
    "Result",
    "Robot",
    "System",
    "TmodesError",
    "adjoint_gradient",
    "forward_sensitivities",
    "load",
    "load_robot",
    "run",
    "show",
    "simulate_batch",
    "simulate_motion",
    "tracking_error",
]

_HOMES = {
    "Drive": "tmodes.paper.mechanism.Drive",
    "Functional": "tmodes.sensitivity.functional.Functional",
    "Mechanism": "tmodes.paper.mechanism.Mechanism",
    "Model": "tmodes.model.model.Model",
    "PaperModel": "tmodes.paper.model.PaperModel",
    "PaperPair": "tmodes.paper.sheet.PaperPair",
    "PaperResult": "tmodes.result.record.PaperResult",
    "PaperRobot": "tmodes.paper.sheet.PaperRobot",
    "Parameters": "tmodes.paper.mechanism.Parameters",
    "Reading": "tmodes.paper.mechanism.Reading",
    "Result": "tmodes.result.result.Result",
    "Robot": "tmodes.sheet.robot.Robot",
    "System": "tmodes.equations.lagrange.system.System",
    "TmodesError": "tmodes.errors.TmodesError",
    "adjoint_gradient": "tmodes.sensitivity.gradient.adjoint_gradient",
    "forward_sensitivities": "tmodes.sensitivity.gradient.forward_sensitivities",
    "load_robot": "tmodes.robots.load_robot",
    "load": "tmodes.robots.load.load",
    "run": "tmodes.result.run.run",
    "show": "tmodes.notebook.show",
    "simulate_batch": "tmodes.simulation.vary.simulate.simulate_batch",
    "simulate_motion": "tmodes.simulation.simulate.simulate_motion",
    "tracking_error": "tmodes.sensitivity.functional.tracking_error",
}


_UPWARD = {
    "Model.static": "tmodes.analysis.statics.equilibrium.equilibrium",
    "Result.figures": "tmodes.plot.saving.all_figures",
    "Result.show": "tmodes.notebook.show",
    "Robot.chain": "tmodes.chain.lowering.lowered",
    "Robot.from_data": "tmodes.io.sheet_check.sheet_from_data",
    "Robot.mass_issues": "tmodes.chain.mass.massless_issues",
    "Robot.pair": "tmodes.io.sheet_check.real_arm",
    "Robot.show": "tmodes.notebook.show",
    "Robot.with_": "tmodes.io.sheet_check.changed_arm",
}
"""Methods whose work is done by an upper package, and by what: the only imports that run upward (at most 12)."""


def upward(method: str) -> Any:
    """The function of an upper package that does the work of a method."""
    module, _, attribute = _UPWARD[method].rpartition(".")
    return getattr(import_module(module), attribute)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'tmodes' has no attribute {name!r}")
    module, _, attribute = _HOMES[name].rpartition(".")
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
