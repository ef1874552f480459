"""Amplitude spectra of evenly sampled series."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

__all__ = ["amplitude_spectrum"]

Array = NDArray[Any]


def amplitude_spectrum(values: Array, step: float, padding: int = 8) -> tuple[Array, Array]:
    """Frequencies [Hz] and amplitudes [unit of ``values``] of evenly sampled ``values``, ``step`` [s] apart.

    A least-squares line is subtracted, then a Hann window applied; a sine of amplitude A between two lines of the grid
    shows a peak of A. ``padding`` makes the grid finer (it does not increase the resolution).
    """
    count = len(values)
    line = np.polynomial.Polynomial.fit(np.arange(count), values, 1)(np.arange(count))
    window = np.hanning(count + 1)[:-1]
    amplitude = 2 * np.abs(np.fft.rfft((values - line) * window, padding * count)) / window.sum()
    return np.fft.rfftfreq(padding * count, step), amplitude
