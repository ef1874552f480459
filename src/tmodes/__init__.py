"""tmodes models, simulates and controls robots that bend: elastic gears, flexible links, a tip that touches the world.

    Robot -splits-> Mechanism + Parameters -derive-> equations -compile-> Model -simulate-> Result --> plot, report
    (WHAT)                                 (LAW)                 (RUN)             (SEE)

The names below are loaded when they are first used, so that ``import tmodes`` itself is light.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.arm import Arm
    from tmodes.arm_model import ArmModel
    from tmodes.errors import TmodesError
    from tmodes.mechanism import Drive, Mechanism, Parameters, Reading
    from tmodes.model import Model
    from tmodes.motion.simulate import simulate_arm
    from tmodes.notebook import show
    from tmodes.result import Result
    from tmodes.robot import NominalRealPair, Robot
    from tmodes.robots import load_robot
    from tmodes.robots.load import load_sheet
    from tmodes.sensitivity.functional import Functional, tracking_error
    from tmodes.sensitivity.gradient import adjoint_gradient, forward_sensitivities
    from tmodes.simulate import simulate as run
    from tmodes.vary.simulate import simulate_batch

__version__ = "0.1.0"

__all__ = [
    "Arm",
    "ArmModel",
    "Drive",
    "Functional",
    "Mechanism",
    "Model",
    "NominalRealPair",
    "Parameters",
    "Reading",
    "Result",
    "Robot",
    "TmodesError",
    "adjoint_gradient",
    "forward_sensitivities",
    "load_robot",
    "load_sheet",
    "run",
    "show",
    "simulate_arm",
    "simulate_batch",
    "tracking_error",
]

_HOMES = {
    "Arm": "tmodes.arm.Arm",
    "ArmModel": "tmodes.arm_model.ArmModel",
    "Drive": "tmodes.mechanism.Drive",
    "Functional": "tmodes.sensitivity.functional.Functional",
    "Mechanism": "tmodes.mechanism.Mechanism",
    "Model": "tmodes.model.Model",
    "NominalRealPair": "tmodes.robot.NominalRealPair",
    "Parameters": "tmodes.mechanism.Parameters",
    "Reading": "tmodes.mechanism.Reading",
    "Result": "tmodes.result.Result",
    "Robot": "tmodes.robot.Robot",
    "TmodesError": "tmodes.errors.TmodesError",
    "adjoint_gradient": "tmodes.sensitivity.gradient.adjoint_gradient",
    "forward_sensitivities": "tmodes.sensitivity.gradient.forward_sensitivities",
    "load_robot": "tmodes.robots.load_robot",
    "load_sheet": "tmodes.robots.load.load_sheet",
    "show": "tmodes.notebook.show",
    "simulate_arm": "tmodes.motion.simulate.simulate_arm",
    "simulate_batch": "tmodes.vary.simulate.simulate_batch",
    "tracking_error": "tmodes.sensitivity.functional.tracking_error",
    "run": "tmodes.simulate.simulate",  # tmodes.simulate is the module, so its function has the command line's name
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'tmodes' has no attribute {name!r}")
    module, _, attribute = _HOMES[name].rpartition(".")
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
