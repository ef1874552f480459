"""A balance of energies that is off by rounding of what is there is not called an error of the integration."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from tmodes.simulation.warnings import run_warnings


@pytest.mark.parametrize(("kinetic", "elastic", "warned"), [(8.0, 0.0, False), (0.0, 8.0, False), (1e-10, 0.0, True)])
def test_the_energy_that_is_there_is_the_scale_of_rounding(kinetic: float, elastic: float, warned: bool) -> None:
    """Of a body that turns freely, and of a spring that holds a load: 8e-12 J of 8 J are no motion."""
    off = np.array([0.0, 4e-12, 8e-12])
    run: Any = SimpleNamespace(
        times=np.arange(3.0), energy_balance=off, energy_moved=1e-11, contact_fold=None,
        energies={"kinetic": kinetic + off, "gravity": 0 * off, "elastic_gear": elastic + 0 * off},
        robot=SimpleNamespace(integration=SimpleNamespace(energy_tolerance=1e-6, stop_at_limits=False), joints=()),
        planned=SimpleNamespace(signals=SimpleNamespace(knots=np.zeros(2), gaps=lambda: (None, np.zeros((1, 0))))),
        setup=SimpleNamespace(model=SimpleNamespace(loop=SimpleNamespace(drivers=()))), chain=SimpleNamespace(nodes=()),
    )  # fmt: skip
    assert bool(run_warnings(run)) == warned
