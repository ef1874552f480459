"""What is not known when a design is chosen."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tmodes.errors import InputError
from tmodes.study.optimize.space import DesignSpace
from tmodes.study.sensitivity.run import with_plan
from tmodes.study.study import Study

__all__ = ["scenarios_of"]


def scenarios_of(study: Study, space: DesignSpace, count: int, seed: int) -> NDArray[np.float64]:
    """Values of all parameters in ``count`` cases of what the design leaves uncertain, the same for all designs.

    Without any case the sheet's own values. Raises :class:`tmodes.errors.InputError` where nothing is uncertain.
    """
    if not count:
        return study.space.nominal[None].copy()
    if len(space.names) == len(study.names):
        hint = "name what is chosen under `optimize.design`; the other parameters are uncertain"
        raise InputError(
            "optimize.worst_case", f"{count} cases of nothing", "left out: all parameters are chosen", hint
        )
    return with_plan(study, {"type": "latin_hypercube", "runs": count, "seed": seed}).design().values
