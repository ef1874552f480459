"""tmodes models, simulates and controls robots that bend: elastic gears, flexible links, a tip that touches the world.

    load -> Robot -> Model -> run -> Result -> figures, report, live page

The names below are loaded when they are first used, so that ``import tmodes`` itself is light.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.equations.lagrange.system import System
    from tmodes.errors import TmodesError
    from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
    from tmodes.gradients.quantities import Functional, tracking_error
    from tmodes.kinds.outside import use
    from tmodes.model.model import Model
    from tmodes.report.notebook import show
    from tmodes.result.result import Result
    from tmodes.result.run import run
    from tmodes.robots.load import load
    from tmodes.sheet.robot import Robot
    from tmodes.simulation.outputs import robot_outputs as outputs
    from tmodes.simulation.vary.simulate import simulate_batch
    from tmodes.study.optimize import optimize
    from tmodes.study.read import read_study
    from tmodes.study.result import load_study
    from tmodes.study.runner import run_study
    from tmodes.study.sensitivity import sensitivity
    from tmodes.study.study import Study

__version__ = "0.1.0"

__all__ = [
    "Functional",
    "Model",
    "Result",
    "Robot",
    "Study",
    "System",
    "TmodesError",
    "adjoint_gradient",
    "forward_sensitivities",
    "load",
    "load_study",
    "optimize",
    "outputs",
    "read_study",
    "run",
    "run_study",
    "sensitivity",
    "show",
    "simulate_batch",
    "tracking_error",
    "use",
]

_HOMES = {
    "Functional": "tmodes.gradients.quantities.Functional",
    "Model": "tmodes.model.model.Model",
    "Result": "tmodes.result.result.Result",
    "Robot": "tmodes.sheet.robot.Robot",
    "Study": "tmodes.study.study.Study",
    "System": "tmodes.equations.lagrange.system.System",
    "TmodesError": "tmodes.errors.TmodesError",
    "adjoint_gradient": "tmodes.gradients.gradient.adjoint_gradient",
    "forward_sensitivities": "tmodes.gradients.gradient.forward_sensitivities",
    "load": "tmodes.robots.load.load",
    "load_study": "tmodes.study.result.load_study",
    "optimize": "tmodes.study.optimize.optimize",
    "outputs": "tmodes.simulation.outputs.robot_outputs",
    "read_study": "tmodes.study.read.read_study",
    "run": "tmodes.result.run.run",
    "run_study": "tmodes.study.runner.run_study",
    "sensitivity": "tmodes.study.sensitivity.sensitivity",
    "show": "tmodes.report.notebook.show",
    "simulate_batch": "tmodes.simulation.vary.simulate.simulate_batch",
    "tracking_error": "tmodes.gradients.quantities.tracking_error",
    "use": "tmodes.kinds.outside.use",
}


_UPWARD = {
    "Model.static": "tmodes.analysis.statics.equilibrium.equilibrium",
    "Result.figures": "tmodes.plot.figure.all_figures",
    "Result.show": "tmodes.report.notebook.show",
    "Robot.chain": "tmodes.chain.lowering.lowered",
    "Robot.chain_issues": "tmodes.chain.checks.chain_issues",
    "Robot.from_data": "tmodes.io.sheet_check.sheet_from_data",
    "Robot.pair": "tmodes.io.sheet_check.real_robot",
    "Robot.show": "tmodes.report.notebook.show",
    "Robot.with_": "tmodes.io.sheet_check.changed_robot",
    "Study.evaluate": "tmodes.study.evaluate.evaluated",
    "Study.from_data": "tmodes.study.read.study_from_data",
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
