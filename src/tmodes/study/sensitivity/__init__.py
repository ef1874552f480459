"""Which parameters make a quantity vary: Sobol' indices with confidence intervals, elementary effects."""

from tmodes.study.sensitivity.result import Sensitivity
from tmodes.study.sensitivity.run import sensitivity

__all__ = ["Sensitivity", "sensitivity"]
