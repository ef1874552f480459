"""What a study asks of each case: one file for each kind of quantity; importing the package registers them."""

from tmodes.study.quantities import expression, function, series, static, summary
from tmodes.study.quantities.contract import QUANTITIES, Asked, Needs, Quantity

__all__ = ["QUANTITIES", "Asked", "Needs", "Quantity", "expression", "function", "series", "static", "summary"]
