"""The modes of a result as motions of its lines in space: ``Mode`` of ``web/src/contract.ts``."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tmodes.analysis.modes.modes import Mode
from tmodes.analysis.spectrum import MotorState
from tmodes.errors import SimulationError
from tmodes.report.actual import actual
from tmodes.report.scene import lines_at
from tmodes.result import Result

__all__ = ["modes_of"]

Array = NDArray[np.float64]
Lines = Callable[[Array], Array]
"""Coordinates (n, nq) to the lines of all links (n, L, S, 3) [m]."""

Shaped = tuple[Mode, NDArray[np.complex128]]

_CASES = (MotorState.CONTROLLED, MotorState.LOCKED, MotorState.FREE)

_MOST = 8
"""Modes that are shown of each case, the lowest."""

_STATIONS = 21

_STEP = 1e-5
"""Change of the largest coordinate [rad] by which a line's motion is found: central differences, good to 1e-9."""


def modes_of(result: Result) -> list[dict[str, Any]]:
    """The lowest modes of the real robot about its rest, of each state of its motors; none where there is no rest.

    Frequencies [Hz] and damping are those of ``result.frequencies``; motions without vibration are left out.
    Displacements (L, S, 3) are complex, the largest of size 1.
    """
    if actual(result).missing:
        return []
    try:
        return _modes(result)
    except SimulationError:
        return []


def _modes(result: Result) -> list[dict[str, Any]]:
    from tmodes.analysis.modes.closed_loop import feedback_of
    from tmodes.analysis.modes.modes import modes_about
    from tmodes.analysis.modes.of_sheet import servos_of
    from tmodes.analysis.statics.equilibrium import robot_rest

    known = actual(result)
    arm = known.robot
    rest = robot_rest(arm, model=known.model, contact=arm.contact is not None)
    servos, feedback = servos_of(arm, rest.model), feedback_of(arm, rest)
    stations, found = np.linspace(0, 1, _STATIONS), []
    for state in _CASES[0 if servos else 1 :]:
        modes = [(mode, mode.motion) for mode in modes_about(rest, state, servos, feedback) if mode.motion is not None]
        found += list(_info(str(state), modes, rest.q, lambda q: lines_at(rest.model, known.names, q, stations)[0]))
    return found


def _info(case: str, modes: Iterable[Shaped], rest: Array, lines: Lines) -> Iterator[dict[str, Any]]:
    """The lowest of ``modes`` that vibrate, as the page takes them."""
    vibrating = [(mode, motion) for mode, motion in modes if mode.frequency_Hz > 0]
    for mode, motion in vibrating[:_MOST]:
        moved = _displacement(lines, rest, motion)
        yield {
            "case": case,
            "frequency": mode.frequency_Hz,
            "damping": mode.damping_ratio,
            "element": mode.element,
            "rest": lines(rest[None])[0].astype(np.float32),
            "real": moved.real.astype(np.float32),
            "imaginary": moved.imag.astype(np.float32),
        }


def _displacement(lines: Lines, rest: Array, motion: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Displacement of the lines (L, S, 3) for a unit of the motion (nq,), the largest of size 1 and phase 0."""
    size = np.abs(motion).max()
    parts = np.stack([motion.real, motion.imag]) / size
    ends = lines(np.concatenate([rest + _STEP * parts, rest - _STEP * parts]))
    real, imaginary = (ends[:2] - ends[2:]) / (2 * _STEP)
    moved = real + 1j * imaginary
    lengths = np.linalg.norm(moved, axis=-1)
    largest = np.unravel_index(int(lengths.argmax()), lengths.shape) if lengths.size else ()
    if not lengths.size or lengths[largest] == 0:
        return moved
    lead = moved[largest][np.abs(moved[largest]).argmax()]
    return moved / lengths[largest] * (np.abs(lead) / lead)
