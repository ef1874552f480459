"""How a parameter varies; importing the package registers all distributions."""

from tmodes.study.distributions import continuous, discrete
from tmodes.study.distributions.contract import DISTRIBUTIONS, Distribution

__all__ = ["DISTRIBUTIONS", "Distribution", "continuous", "discrete"]
