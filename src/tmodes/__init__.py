"""tmodes models, simulates and controls robots that bend: elastic gears, flexible links, a tip that touches the world.

    load -> Robot -> Model -> run -> Result -> figures, report, live page

The names below are loaded when they are first used, so that ``import tmodes`` itself is light.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from tmodes.analysis.statics.loads import Load
    from tmodes.chain.checks import chain_issues
    from tmodes.chain.lowering import lowered as lowered_chain
    from tmodes.equations.lagrange.system import System
    from tmodes.errors import TmodesError
    from tmodes.gradients.gradient import adjoint_gradient, forward_sensitivities
    from tmodes.gradients.quantities import Functional, reduced_output, tracking_error
    from tmodes.interface.batches import batch
    from tmodes.interface.checks import check, evaluate
    from tmodes.interface.comparing import compare
    from tmodes.interface.description import describe
    from tmodes.interface.following import commanded_robot, follow
    from tmodes.interface.hierarchy import hierarchy
    from tmodes.interface.inverse import inverse
    from tmodes.interface.learning import learn
    from tmodes.interface.linear import linearize
    from tmodes.interface.modes import modes
    from tmodes.interface.motions import motion
    from tmodes.interface.objects import Result, Robot, load, run
    from tmodes.interface.shaping import shaper
    from tmodes.interface.show import show
    from tmodes.interface.statics import static
    from tmodes.interface.studies import gradient
    from tmodes.interface.tuning import tune
    from tmodes.io.sheet_check import changed_robot, real_robot, sheet_from_data
    from tmodes.kinds.outside import use
    from tmodes.model.model import Model
    from tmodes.simulation.design import designed_block
    from tmodes.simulation.linear import run_feedback
    from tmodes.simulation.outputs import robot_outputs as outputs
    from tmodes.simulation.sampled_controller import Measurement
    from tmodes.simulation.vary.parameters import parameters_of as parameters
    from tmodes.simulation.vary.simulate import simulate_batch
    from tmodes.study.evaluate import evaluated as evaluated_study
    from tmodes.study.optimize import optimize
    from tmodes.study.read import read_study, study_from_data
    from tmodes.study.result import load_study
    from tmodes.study.runner import run_study
    from tmodes.study.sensitivity import sensitivity
    from tmodes.study.study import Study

__version__ = "0.1.0"

__all__ = [
    "Functional",
    "Load",
    "Measurement",
    "Model",
    "Result",
    "Robot",
    "Study",
    "System",
    "TmodesError",
    "adjoint_gradient",
    "batch",
    "check",
    "compare",
    "describe",
    "evaluate",
    "follow",
    "forward_sensitivities",
    "gradient",
    "hierarchy",
    "inverse",
    "learn",
    "linearize",
    "load",
    "load_study",
    "modes",
    "motion",
    "optimize",
    "outputs",
    "parameters",
    "read_study",
    "reduced_output",
    "run",
    "run_study",
    "sensitivity",
    "shaper",
    "show",
    "simulate_batch",
    "static",
    "tracking_error",
    "tune",
    "use",
]

_HOMES = {
    "Functional": "tmodes.gradients.quantities.Functional",
    "Load": "tmodes.analysis.statics.loads.Load",
    "Measurement": "tmodes.simulation.sampled_controller.Measurement",
    "Model": "tmodes.model.model.Model",
    "Result": "tmodes.interface.objects.Result",
    "Robot": "tmodes.interface.objects.Robot",
    "Study": "tmodes.study.study.Study",
    "System": "tmodes.equations.lagrange.system.System",
    "TmodesError": "tmodes.errors.TmodesError",
    "adjoint_gradient": "tmodes.gradients.gradient.adjoint_gradient",
    "batch": "tmodes.interface.batches.batch",
    "check": "tmodes.interface.checks.check",
    "compare": "tmodes.interface.comparing.compare",
    "describe": "tmodes.interface.description.describe",
    "evaluate": "tmodes.interface.checks.evaluate",
    "follow": "tmodes.interface.following.follow",
    "forward_sensitivities": "tmodes.gradients.gradient.forward_sensitivities",
    "gradient": "tmodes.interface.studies.gradient",
    "hierarchy": "tmodes.interface.hierarchy.hierarchy",
    "learn": "tmodes.interface.learning.learn",
    "linearize": "tmodes.interface.linear.linearize",
    "inverse": "tmodes.interface.inverse.inverse",
    "load": "tmodes.interface.objects.load",
    "load_study": "tmodes.study.result.load_study",
    "modes": "tmodes.interface.modes.modes",
    "motion": "tmodes.interface.motions.motion",
    "optimize": "tmodes.study.optimize.optimize",
    "outputs": "tmodes.simulation.outputs.robot_outputs",
    "parameters": "tmodes.simulation.vary.parameters.parameters_of",
    "read_study": "tmodes.study.read.read_study",
    "run": "tmodes.interface.objects.run",
    "run_study": "tmodes.study.runner.run_study",
    "sensitivity": "tmodes.study.sensitivity.sensitivity",
    "shaper": "tmodes.interface.shaping.shaper",
    "show": "tmodes.interface.show.show",
    "simulate_batch": "tmodes.simulation.vary.simulate.simulate_batch",
    "reduced_output": "tmodes.gradients.quantities.reduced_output",
    "static": "tmodes.interface.statics.static",
    "tracking_error": "tmodes.gradients.quantities.tracking_error",
    "tune": "tmodes.interface.tuning.tune",
    "use": "tmodes.kinds.outside.use",
}

_UPWARD = {
    "chain_issues": "tmodes.chain.checks.chain_issues",
    "changed_robot": "tmodes.io.sheet_check.changed_robot",
    "commanded_robot": "tmodes.interface.following.commanded_robot",
    "evaluated_study": "tmodes.study.evaluate.evaluated",
    "designed_block": "tmodes.simulation.design.designed_block",
    "lowered_chain": "tmodes.chain.lowering.lowered",
    "real_robot": "tmodes.io.sheet_check.real_robot",
    "run_feedback": "tmodes.simulation.linear.run_feedback",
    "sheet_from_data": "tmodes.io.sheet_check.sheet_from_data",
    "study_from_data": "tmodes.study.read.study_from_data",
}
"""What does the work of a method in an upper package: the only imports that run upward (at most 12)."""


def __getattr__(name: str) -> object:
    home = _HOMES.get(name) or _UPWARD.get(name)
    if home is None:
        raise AttributeError(f"module 'tmodes' has no attribute {name!r}")
    module, _, attribute = home.rpartition(".")
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
