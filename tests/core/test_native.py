"""Native code equals CasADi's own evaluation; sin and cos are right to the last place; the cache is not trusted."""

from __future__ import annotations

import casadi as ca
import mpmath
import numpy as np
import pytest

from tmodes.compile import cache
from tmodes.compile.ir import kernels
from tmodes.compile.ir.ordering import kernel_function
from tmodes.compile.ir.program import straight_line
from tmodes.errors import CompileError, ResultFileError
from tmodes.simulation.start import run_setup


def sampled(function, *inputs, parameters=(1.0,)):
    """A CasADi function, compiled, over samples."""
    library = kernels.sample_functions("t", str(function), lambda: {"f": function}, {"f": len(inputs)})
    arrays = [np.ascontiguousarray(values, dtype=float) for values in inputs]
    out, p = np.empty((len(arrays[0]), function.nnz_out(0))), np.array(parameters, dtype=float)
    library["f"](len(out), p.ctypes.data, *(array.ctypes.data for array in arrays), out.ctypes.data)
    return out


@pytest.fixture
def sine_cosine():
    x, p = ca.SX.sym("x"), ca.SX.sym("p")
    return ca.Function("sincos", [x, p], [ca.vertcat(ca.sin(x), ca.cos(x))])


def test_sine_and_cosine_to_one_place(sine_cosine):
    """Within one unit in the last place of the true value, near and far, at multiples of pi/2, tiny and huge."""
    rng = np.random.default_rng(7)
    turns = np.pi / 2 * rng.integers(-500000, 500000, 300)
    near = np.concatenate([rng.uniform(-7, 7, 2000), rng.uniform(-8e5, 8e5, 1000), turns, np.nextafter(turns, 1e9)])
    edge = np.array([0.0, 5e-324, 1e-300, 1e-8, -1e-8, 2.0**19 * np.pi / 2, 1e7, 1e15, -1e22, 1e300])
    x = np.concatenate([near, edge])
    found = sampled(sine_cosine, x)
    mpmath.mp.prec = 1200
    for column, true in enumerate((mpmath.sin, mpmath.cos)):
        exact = [true(mpmath.mpf(value)) for value in x]
        places = [
            abs(float((mpmath.mpf(value) - right) / mpmath.mpf(np.spacing(abs(float(right))))))
            for value, right in zip(found[:, column], exact, strict=True)
        ]
        assert max(places) <= 1.0, (true.__name__, x[int(np.argmax(places))], max(places))


def test_sine_of_nothing_is_nothing(sine_cosine):
    """Not-a-number and infinity give not-a-number, as IEEE wants."""
    assert np.isnan(sampled(sine_cosine, [np.nan, np.inf, -np.inf])).all()


def interpreted(schedule, blocks, numbers):
    """The first output of a schedule, each kernel evaluated by CasADi itself."""
    workspace = np.zeros(schedule.workspace)
    workspace[: len(numbers)] = numbers

    def part(slot):
        start = schedule.offset(slot)
        return slice(start, start + slot.size)

    for name, slot in schedule.inputs.items():
        workspace[part(slot)] = blocks[name]
    for kernel, inputs, outputs in schedule.calls:
        results = kernel_function(kernel).call([ca.DM(workspace[part(slot)]) for slot in inputs])
        for slot, result in zip(outputs, results, strict=True):
            workspace[part(slot)] = np.array(result).ravel()
    return np.concatenate([workspace[part(slot)] for slot in next(iter(schedule.outputs.values()))])


def test_native_equals_casadi(robot):
    """The whole closed loop in contact, at random states: native code and CasADi's interpreter agree to rounding."""
    setup, rng = run_setup(robot), np.random.default_rng(3)
    time, row = rng.uniform(0, 2, 50), np.tile([0.4, 0.1, 0.5, -0.2], (50, 1))
    state = 0.1 * rng.standard_normal((50, len(setup.start)))
    found, numbers = setup.model.rate(time, state, row), setup.model.numbers.vector
    for k in range(50):
        blocks = {"time": time[k], "state": state[k], "row": row[k], "step": 0.0}
        wanted = interpreted(setup.model.loop.rate, blocks, numbers)
        assert np.abs(found[k] - wanted).max() <= 1e-12 * np.abs(wanted).max()


def test_what_does_not_change_is_computed_once():
    """Operations on parameters alone are out of the loop."""
    x, p = ca.SX.sym("x"), ca.SX.sym("p")
    program = straight_line(ca.Function("f", [x, p], [x * (ca.sin(p) + ca.cos(p)) - x]), invariant=1)
    assert len(program.held) == 1
    pairs = zip(program.fixed, program.values, strict=True)
    assert sum(not fixed and value.opcode != "input" for fixed, value in pairs) == 2


def test_unknown_operation_is_refused():
    """An operation without a native form is an error of ours, not wrong code."""
    x, p = ca.SX.sym("x"), ca.SX.sym("p")
    with pytest.raises(CompileError, match="no native form"):
        straight_line(ca.Function("f", [x, p], [ca.erf(x)]), invariant=1)


def test_a_function_outlives_its_library(sine_cosine):
    """Who holds a function may call it after the library, and hundreds after it, are gone."""
    make = {"f": sine_cosine}
    held = kernels.sample_functions("t", "outlives", lambda: make, {"f": 1})["f"]
    kernels._loaded.clear()
    for number in range(70):
        kernels.sample_functions("t", f"later {number}", lambda: make, {"f": 1})
        kernels._loaded.clear()
    x, p, out = np.array([0.5]), np.zeros(1), np.empty(2)
    held(1, *(array.ctypes.data for array in (p, x, out)))
    assert out == pytest.approx([np.sin(0.5), np.cos(0.5)], abs=0)


def test_damaged_cache_entry_is_made_again(sine_cosine, tmp_path, monkeypatch):
    """A bit flip, a cut, another key's entry: never used, always replaced."""
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
    kernels._loaded.clear()
    sampled(sine_cosine, [0.5])
    (entry,) = (tmp_path / "cache").glob("*.o")
    whole = entry.read_bytes()
    for damage in (whole[:-1], whole[:100] + bytes([whole[100] ^ 1]) + whole[101:], b"", b"0" * len(whole)):
        entry.write_bytes(damage)
        kernels._loaded.clear()
        assert sampled(sine_cosine, [0.5])[0, 0] == pytest.approx(np.sin(0.5), abs=0)
        assert entry.read_bytes() == whole


def test_cache_of_another_user_or_open_to_others_is_not_used(tmp_path, monkeypatch):
    """A folder that others can write is no cache."""
    place = tmp_path / "open"
    place.mkdir(mode=0o777)
    place.chmod(0o777)
    monkeypatch.setenv("TMODES_CACHE", str(place))
    assert cache.folder() is None
    cache.save("key", b"binary")
    assert not list(place.iterdir())
    monkeypatch.setenv("TMODES_CACHE", "")
    assert cache.folder() is None


def test_cache_that_cannot_be_written_costs_time_only(sine_cosine, tmp_path, monkeypatch):
    """A full disk below the cache is no error."""
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))

    def full(path, **_):
        raise ResultFileError(f"{path}: the disk is full")

    monkeypatch.setattr(cache, "atomic_write", full)
    kernels._loaded.clear()
    assert sampled(sine_cosine, [0.5])[0, 0] == pytest.approx(np.sin(0.5), abs=0)


def test_cache_is_bounded(tmp_path, monkeypatch):
    """The entries not used for the longest time go."""
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(cache, "MAX_BYTES", 5000)
    for index in range(12):
        cache.save(f"key{index}", bytes(1000))
    left = [index for index in range(12) if cache.load(f"key{index}") is not None]
    assert left
    assert len(left) <= 5
    assert 11 in left
