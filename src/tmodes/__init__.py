"""tmodes models, simulates and controls robots that bend: elastic gears, flexible links, a tip that touches the world.

    Robot -splits-> Mechanism + Parameters -derive-> equations -compile-> Model -simulate-> Result --> plot, report
    (WHAT)                                 (LAW)                 (RUN)             (SEE)

The names below are loaded when they are first used, so that ``import tmodes`` itself is light.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from tmodes.errors import TmodesError
    from tmodes.model.model import ArmModel
    from tmodes.notebook import show
    from tmodes.paper.mechanism import Drive, Mechanism, Parameters, Reading
    from tmodes.paper.model import Model
    from tmodes.paper.sheet import NominalRealPair, Robot
    from tmodes.paper.simulate import simulate as run
    from tmodes.result.record import Result
    from tmodes.robots import load_robot
    from tmodes.robots.load import load_sheet
    from tmodes.sensitivity.functional import Functional, tracking_error
    from tmodes.sensitivity.gradient import adjoint_gradient, forward_sensitivities
    from tmodes.sheet import Arm
    from tmodes.simulation.simulate import simulate_arm
    from tmodes.simulation.vary.simulate import simulate_batch

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
    "Arm": "tmodes.sheet.Arm",
    "ArmModel": "tmodes.model.model.ArmModel",
    "Drive": "tmodes.paper.mechanism.Drive",
    "Functional": "tmodes.sensitivity.functional.Functional",
    "Mechanism": "tmodes.paper.mechanism.Mechanism",
    "Model": "tmodes.paper.model.Model",
    "NominalRealPair": "tmodes.paper.sheet.NominalRealPair",
    "Parameters": "tmodes.paper.mechanism.Parameters",
    "Reading": "tmodes.paper.mechanism.Reading",
    "Result": "tmodes.result.record.Result",
    "Robot": "tmodes.paper.sheet.Robot",
    "TmodesError": "tmodes.errors.TmodesError",
    "adjoint_gradient": "tmodes.sensitivity.gradient.adjoint_gradient",
    "forward_sensitivities": "tmodes.sensitivity.gradient.forward_sensitivities",
    "load_robot": "tmodes.robots.load_robot",
    "load_sheet": "tmodes.robots.load.load_sheet",
    "show": "tmodes.notebook.show",
    "simulate_arm": "tmodes.simulation.simulate.simulate_arm",
    "simulate_batch": "tmodes.simulation.vary.simulate.simulate_batch",
    "tracking_error": "tmodes.sensitivity.functional.tracking_error",
    "run": "tmodes.paper.simulate.simulate",
}


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module 'tmodes' has no attribute {name!r}")
    module, _, attribute = _HOMES[name].rpartition(".")
    return getattr(import_module(module), attribute)


def __dir__() -> list[str]:
    return sorted([*globals(), *__all__])
