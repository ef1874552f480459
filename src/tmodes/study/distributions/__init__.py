"""How a parameter varies: one file for each distribution; importing the package registers them."""

from tmodes.study.distributions import (
    discrete,
    empirical,
    lognormal,
    loguniform,
    normal,
    triangular,
    truncated,
    uniform,
)
from tmodes.study.distributions.contract import DISTRIBUTIONS, Distribution

__all__ = [
    "DISTRIBUTIONS", "Distribution", "discrete", "empirical", "lognormal", "loguniform", "normal", "triangular",
    "truncated", "uniform",
]  # fmt: skip
