"""How a parameter varies: one file for each distribution; importing the package registers them."""

from tmodes.study.distributions import uniform
from tmodes.study.distributions.contract import DISTRIBUTIONS, Distribution

__all__ = ["DISTRIBUTIONS", "Distribution", "uniform"]
