"""Functions whose Sobol' indices are known, as studies of expressions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from tmodes.study.read import study_from_data
from tmodes.study.study import Study

Pairs = Mapping[tuple[int, int], float]


@dataclass(frozen=True)
class Known:
    """A function by its formula, the distributions of its inputs, and its exact indices."""

    formula: str
    inputs: Mapping[str, Mapping[str, Any]]
    first: tuple[float, ...]
    total: tuple[float, ...]
    second: Pairs = field(default_factory=dict)


def study(formula: str, inputs: Mapping[str, Mapping[str, Any]], **more: Any) -> Study:
    """A study of one expression."""
    data = {
        "format": 1, "kind": "study", "name": "known", "plan": {"type": "monte_carlo", "runs": 10},
        "parameters": {name: {"distribution": dict(one)} for name, one in inputs.items()},
        "quantities": {"y": {"expression": formula}},
    }  # fmt: skip
    return study_from_data(data | more)


def uniform(low: float, high: float) -> dict[str, Any]:
    """Equally likely between two values."""
    return {"type": "uniform", "low": low, "high": high}


def ishigami(a: float, b: float) -> Known:
    """T. Ishigami, T. Homma, An importance quantification technique in uncertainty analysis, ISUMA 1990."""
    one, two = b * np.pi**4 / 5 + b**2 * np.pi**8 / 50 + 0.5, a**2 / 8
    both = 8 * b**2 * np.pi**8 / 225
    alone = (1 + b * np.pi**4 / 5) ** 2 / 2
    variance = one + two + b**2 * np.pi**8 / 18 - b**2 * np.pi**8 / 50
    return Known(
        f"sin(x1) + {a}*sin(x2)**2 + {b}*x3**4*sin(x1)",
        dict.fromkeys(("x1", "x2", "x3"), uniform(-np.pi, np.pi)),
        first=(alone / variance, two / variance, 0.0),
        total=((alone + both) / variance, two / variance, both / variance),
        second={(0, 1): 0.0, (0, 2): both / variance, (1, 2): 0.0},
    )


def g_function(*a: float) -> Known:
    """I. M. Sobol', Global sensitivity indices for nonlinear mathematical models, Math. Comput. Simul. 55 (2001)."""
    own = np.array([1 / (3 * (1 + each) ** 2) for each in a])
    variance = np.prod(1 + own) - 1
    total = own * np.prod(1 + own) / (1 + own) / variance
    formula = "*".join(f"(abs(4*x{k} - 2) + {each})/{1 + each}" for k, each in enumerate(a))
    names = [f"x{k}" for k in range(len(a))]
    return Known(formula, dict.fromkeys(names, uniform(0.0, 1.0)), tuple(own / variance), tuple(total))


def lognormals(*deviations: float) -> Known:
    """A product of lognormal inputs, each exp(s z)."""
    own = np.exp(np.square(deviations)) - 1
    variance = np.prod(1 + own) - 1
    names = [f"x{k}" for k in range(len(deviations))]
    formula = "*".join(f"exp({s}*{name})" for name, s in zip(names, deviations, strict=True))
    inputs = {name: {"type": "normal", "mean": 0.0, "deviation": 1.0} for name in names}
    return Known(formula, inputs, tuple(own / variance), tuple(own * np.prod(1 + own) / (1 + own) / variance))


def elastic_arm(formula: str, first: tuple[float, ...], total: tuple[float, ...], second: Pairs) -> Known:
    """Responses of an elastic arm of 1 m to its gear, payload and bending stiffness; indices by quadrature."""
    compliance = "(1/gear + 1/(3*bending))"
    inputs = {"gear": uniform(1600.0, 2400.0), "payload": uniform(1.05, 1.95), "bending": uniform(120.0, 180.0)}
    return Known(formula.replace("c", compliance), inputs, first, total, second)


FREQUENCY = elastic_arm(
    "1/(2*pi*(payload*c)**0.5)",
    (0.011428373935317223, 0.7695561200446397, 0.21696772372655831),
    (0.011746746909774841, 0.7713784200810305, 0.21892441257975837),
    {(0, 1): 9.109344028457311e-05, (0, 2): 0.00022548225709392855, (1, 2): 0.0017294093190273752},
)
SAG = elastic_arm(
    "9.81*payload*c",
    (0.011637441189978871, 0.7512417925979615, 0.2298753815304469),
    (0.011986564425678248, 0.7584871772795743, 0.23677164297636044),
    {(0, 1): 0.00034912323569924464, (0, 2): 0.0, (1, 2): 0.006896261445913321},
)
CASES = {
    "ishigami": ishigami(7.0, 0.1), "ishigami_other": ishigami(5.0, 0.05), "g": g_function(0.0, 1.0, 4.5, 9.0),
    "lognormals": lognormals(0.5, 0.3, 0.1), "frequency": FREQUENCY, "sag": SAG,
}  # fmt: skip
