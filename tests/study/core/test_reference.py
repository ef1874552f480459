"""Means, deviations and percentiles of a closed-form arm, against reference values computed with quadrature.

The values were computed independently of this project (tensor Gauss-Legendre quadrature; percentiles checked by 4
million Monte Carlo runs): sag m g (L^2/k + L^3/(3 EI)) and first frequency of an arm of gear, link without mass and
payload, the motor held.
"""

from __future__ import annotations

import numpy as np
import pytest
import scipy.stats

from study.core.studies import FORMULA, LUMPED, study, written
from tmodes.study.statistics import statistics

P01 = {"f1": (2.511774243031631, 0.25562997971996865), "sag": (0.04060479642010701, 0.008114244589711406)}
"""Mean and standard deviation [Hz, m] of p01: k 1600 to 2400, m 1.05 to 1.95, EI 120 to 180, uniform."""

POINTS = {(1600.0, 1.05, 150.0): (2.9108163105535096, 0.029327812500000005),
          (2400.0, 1.95, 120.0): (2.0165321765571904, 0.061108125000000006)}  # fmt: skip
"""First frequency [Hz] and sag [m] at k, m, EI."""

SHARES = np.array([0.01, 0.05, 0.25, 0.5, 0.75, 0.95, 0.99])
PERCENTILES = {
    "normal": [0.03301488417147957, 0.035026327192314625, 0.037992235919167935, 0.040133766983198364,
               0.04234950660750846, 0.04568464962987155, 0.04814482823327615],
    "uniform": [0.0312000561949281, 0.032628816738889885, 0.03613320122717164, 0.04014800136352405,
                0.044162801590530064, 0.04809234052717441, 0.050033787985128364],
}  # fmt: skip
"""Sag [m] of p02 at these shares."""

NORMAL = {"k": (2000.0, 200.0), "EI": (150.0, 7.5), "m": (1.5, 0.1)}
UNIFORM = {"k": (1600.0, 2400.0), "EI": (140.0, 160.0), "m": (1.2, 1.8)}

ARM = """\
format: 1
kind: study
name: p01
robot: arm.yaml
parameters:
  k: {path: joints.joint.gear.stiffness, distribution: {type: uniform, low: 1600, high: 2400}}
  m: {path: links.link.bodies.payload.mass, distribution: {type: uniform, low: 1.05, high: 1.95}}
  EI: {path: links.link.beam.section.bending_stiffness, distribution: {type: uniform, low: 120, high: 180}}
quantities:
  small: {static: sag}
  sag: {expression: 1000*small, unit: m}
  f1: {static: frequency.locked.1}
plan: {type: monte_carlo, runs: 2048, seed: 1}
"""


def test_the_arm_at_points(tmp_path):
    one = written(tmp_path, ARM, arm_yaml=LUMPED)
    rows = one.evaluate(0, np.array([*POINTS]))
    np.testing.assert_allclose(rows.quantities["f1"], [value[0] for value in POINTS.values()], rtol=1e-6)
    np.testing.assert_allclose(rows.quantities["sag"], [value[1] for value in POINTS.values()], rtol=1e-6)
    assert rows.units == {"small": "m", "sag": "m", "f1": "Hz"}


def test_mean_and_deviation_of_the_arm(tmp_path):
    """Within three deviations of the mean and of the deviation of so many random cases."""
    one = written(tmp_path, ARM, arm_yaml=LUMPED)
    rows = one.evaluate(0, one.design().values)
    count = len(rows)
    for name, (mean, deviation) in P01.items():
        found = statistics(rows.quantities[name])
        kurtosis = scipy.stats.kurtosis(rows.quantities[name], fisher=False)
        assert found.mean == pytest.approx(mean, abs=3 * deviation / np.sqrt(count))
        assert found.deviation == pytest.approx(deviation, rel=1.5 * np.sqrt((kurtosis - 1) / count))
        assert found.failed == 0


@pytest.mark.parametrize("kind", ["normal", "uniform"])
@pytest.mark.parametrize("plan", ["monte_carlo", "sobol", "latin_hypercube"])
def test_percentiles(kind, plan):
    """Within the order statistics that surround them in 99.73 % of cases; those of even plans are closer."""
    given, names = (NORMAL, ("mean", "deviation")) if kind == "normal" else (UNIFORM, ("low", "high"))
    parameters = {
        name: {"distribution": {"type": kind, **dict(zip(names, pair, strict=True))}} for name, pair in given.items()
    }
    runs = 2**14
    one = study(parameters, {"sag": {"expression": FORMULA}}, plan={"type": plan, "runs": runs, "seed": 5})
    values = np.sort(one.evaluate(0, one.design().values).quantities["sag"])
    for share, known in zip(SHARES, PERCENTILES[kind], strict=True):
        low, high = scipy.stats.binom.ppf([0.00135, 0.99865], runs, share).astype(int)
        assert values[low - 1] <= known <= values[high]


def test_percentiles_with_correlations():
    """The logarithm of a product of lognormals is normal, with the variance of the correlated sum."""
    sigma = {"a": 0.2, "b": 0.3}
    parameters = {
        name: {"distribution": {"type": "lognormal", "median": 1.0, "sigma_log": one}} for name, one in sigma.items()
    }
    pairs = [{"between": ["a", "b"], "value": -0.6}]
    plan = {"type": "sobol", "runs": 2**14}
    one = study(parameters, {"y": {"expression": "a*b"}}, correlations=pairs, plan=plan)
    values = np.sort(one.evaluate(0, one.design().values).quantities["y"])
    total = np.sqrt(0.2**2 + 0.3**2 - 2 * 0.6 * 0.2 * 0.3)
    for share in SHARES:
        low, high = scipy.stats.binom.ppf([0.00135, 0.99865], len(values), share).astype(int)
        assert values[low - 1] <= np.exp(total * scipy.stats.norm.ppf(share)) <= values[high]
