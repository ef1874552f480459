"""What a linear model says of itself in words: stability, poles, zeros, margins."""

from __future__ import annotations

from collections.abc import Iterator
from math import degrees, isfinite, pi
from typing import Any

import numpy as np

from tmodes.io.words import count_of

__all__ = [
    "LOOPS", "POLES", "ZEROS", "heading", "loop_rows", "lost_modes", "pole_rows", "sentence", "stability", "zero_rows",
]  # fmt: skip

POLES = ("real [1/s]", "imaginary [1/s]", "natural [Hz]", "damping ratio", "mostly")
ZEROS = ("from", "to", "zeros [1/s]", "phase")
SAMPLED_ZEROS = ("from", "to", "zeros, z plane", "phase")
LOOPS = ("drive", "gain [dB]", "at [Hz]", "phase [deg]", "at [Hz]", "delay [ms]", "disk", "closed")

_NULL, _ROUNDING = 1e-9, 1e-9
"""Growth that is none; size of a pole, over the largest, that is 0."""

_TWICE = 2e-8
"""Size, over the largest pole, of a pair of poles or of zeros that is a double one at 0: rounding parts it by its root.
"""

_GONE = 1e-6
"""Size of a pole in the z plane whose motion is over at the next sample: poles of delays and of very fast motions."""

_OUTSIDE = 1e-7
"""Distance of a zero from the unit circle that is rounding."""

_RINGS = 0.7
"""Damping above which a mode does not ring: its step response passes its end by less than 5 %."""

_MODES = 3
"""Modes that a sentence names."""


def stability(found: Any) -> str:
    """Whether all motions decay, some grow, or neither."""
    sizes = np.abs(found.poles)
    growing = sizes - 1 if found.period else found.poles.real[sizes > _ROUNDING * sizes.max(initial=0.0)]
    most, free = growing.max(initial=-1.0), not found.period and len(growing) < len(sizes)
    return "unstable" if most > _NULL else "stable" if most < -_NULL and not free else "neither stable nor unstable"


def heading(found: Any) -> str:
    """Its size, its loop, about what it is, whether it is stable."""
    s = found.system
    parts = [count_of(len(names), word) for word, names in (("state", s.states), ("input", s.inputs),
                                                            ("output", s.outputs))]  # fmt: skip
    parts += ["under its controllers" if found.closed else "open loop"]
    parts += [f"sampled every {s.period:g} s"] if s.period else []
    return f"{found.name}: {', '.join([*parts, found.where])}: {stability(found)}"


def _rates(found: Any) -> list[tuple[complex, str]]:
    """Poles as rates [1/s], one of each pair, with the state that takes part most; without those at z = 0 of delays.

    Integrators are at 0.
    """
    with np.errstate(divide="ignore", invalid="ignore"):
        every = [(np.log(one.pole) / found.period if found.period else one.pole, one.state) for one in found.modes]
    rates = [(complex(rate), state) for rate, state in every if np.isfinite(rate)]
    most = max((abs(rate) for rate, _ in rates), default=0.0)
    least = [(_TWICE if rate.imag else _ROUNDING) * most for rate, _ in rates]
    every = [(0j if abs(rate) <= size else rate, state) for (rate, state), size in zip(rates, least, strict=True)]
    return [(rate, state) for rate, state in every if rate.imag >= 0]


def pole_rows(found: Any) -> list[list[str]]:
    """A row for each real pole and each pair, the slowest first."""
    rows = []
    for rate, state in _rates(found):
        size, real = abs(rate), 0.0 if abs(rate.real) <= _NULL * abs(rate) else rate.real
        shown = [f"{one:.5g}" for one in (real, rate.imag, size / (2 * pi))]
        rows.append(
            [*shown, f"{-real / size + 0.0:.4f}" if size else "-", state if size else f"{state}, an integrator"]
        )
    return rows


def loop_rows(found: Any) -> list[list[str]]:
    """Margins of each loop of a closed one: what its gain, phase and delay may change by; the disk margin."""
    rows = []
    for name, loop in found.loops.items():
        own = loop.margins()
        shown = [f"{one:.4g}" if isfinite(one) else "-" for one in (
            20 * np.log10(own.gain), own.gain_frequency, degrees(own.phase), own.phase_frequency, 1e3 * own.delay
        )]  # fmt: skip
        rows.append([name, *shown, f"{own.disk:.3g}", "stable" if own.stable else "unstable"])
    return rows


def lost_modes(found: Any) -> Iterator[str]:
    """Modes that no input reaches or no output shows, but for those of a sampled model that are gone at a sample."""
    lost = {
        "No input reaches": found.uncontrollable if found.inputs else (),  # else it is so of all modes
        "No output shows": found.unobservable if found.outputs else (),
    }
    for what, modes in lost.items():
        kept = [str(_rate(one, found.period)) for one in modes if not found.period or abs(one.pole) > _GONE]
        if kept:
            yield f"{what} the mode {', '.join(kept)}."


def _rate(mode: Any, period: float | None) -> Any:
    """A mode of a sampled model with its pole as a rate [1/s]."""
    return mode._replace(pole=complex(np.log(mode.pole)) / period) if period else mode


def zero_rows(found: Any) -> Iterator[list[str]]:
    """A row for each input and output: its zeros, and whether some are to the right (outside of the unit circle)."""
    least = _TWICE * np.abs(found.poles).max(initial=0.0)
    for source in found.inputs:
        for output in found.outputs:
            if not found.acts(output, source):
                yield [source, output, "none", "no effect"]
                continue
            zeros = found.zeros(output, source)
            right = (zeros.real > _NULL * np.abs(zeros)) & (np.abs(zeros) > least)
            outside = np.abs(zeros) > 1 + _OUTSIDE if found.period else right
            plain = zeros if found.period else np.where(np.abs(zeros) > least, zeros, 0.0)
            shown = ", ".join(f"{one.real:.4g}{one.imag:+.4g}i" for one in plain if one.imag >= 0)
            yield [source, output, shown or "none", "non-minimum" if outside.any() else "minimum"]


def sentence(found: Any) -> str:
    """Whether it is stable, its slowest modes; of one input and output in open loop the margins; non-minimum phase."""
    kind = "Under its controllers" if found.closed else "In open loop"
    rates = _rates(found)
    grows = [(rate, state) for rate, state in rates if rate.real > _NULL * abs(rate)]
    said = [f"{kind} {stability(found)}{_growing(*max(grows, key=lambda one: one[0].real)) if grows else ''}"]
    rings = [one for one in rates if one[0].imag > 0 and -_RINGS <= one[0].real / abs(one[0]) <= _NULL]
    if rings:
        more = f" and {len(rings) - _MODES} more" if len(rings) > _MODES else ""
        said.append(f"it rings at {', '.join(_ringing(*one) for one in rings[:_MODES])}{more}")
    else:
        said.append("nothing rings")
    if len(found.inputs) == len(found.outputs) == 1 and not found.closed:
        said.append(_margins(found))
    wrong = [f"{source} to {output}" for source, output, _, phase in zero_rows(found) if phase == "non-minimum"]
    if wrong:
        more = f" and {len(wrong) - _MODES} more" if len(wrong) > _MODES else ""
        said.append(f"non-minimum phase: {', '.join(wrong[:_MODES])}{more}")
    return f"{'; '.join(said)}."


def _growing(rate: complex, state: str) -> str:
    return f", it grows at {rate.real:.3g} 1/s, mostly {state}"


def _ringing(rate: complex, state: str) -> str:
    share = -100 * rate.real / abs(rate)
    damping = f"damping {share:.2g} %" if share > 100 * _NULL else "undamped"
    return f"{abs(rate) / (2 * pi):.3g} Hz ({damping}, mostly {state})"


def _margins(found: Any) -> str:
    """Of the loop that negative feedback from the output to the input closes."""
    known = found.margins()
    return (
        f"margins under unit negative feedback: {known.words}"
        if known.stable
        else "under unit negative feedback unstable"
    )
