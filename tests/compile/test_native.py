"""Native code equals CasADi's own evaluation; sin and cos are right to the last place; the cache is not trusted."""

from __future__ import annotations

import casadi as ca
import mpmath
import numpy as np
import pytest

from tmodes.compile import cache
from tmodes.compile.ir import kernels
from tmodes.compile.ir.program import block_program, kernel_function
from tmodes.errors import CompileError, ResultFileError
from tmodes.kinds.kernel import functions
from tmodes.kinds.kernel.schedule import Kernel, Schedule
from tmodes.simulation.initial_state import run_setup

SINE_COSINE = Kernel("sine and cosine", (1,), (2,), lambda x: [[functions.sin(x[0]), functions.cos(x[0])]])


def compiled(kernel: Kernel, name: str = "t"):
    """The native function of one kernel over many samples."""
    schedule = Schedule(0, often=True)  # so that all of its code is in one library
    schedule.output("out", *schedule.call(kernel, schedule.input("in", sum(kernel.inputs))))
    return kernels.schedule_function(name, schedule, "double")["run"], schedule.workspace


def sampled(kernel, values):
    """A kernel of one number, compiled, over samples."""
    run, workspace = compiled(kernel)
    given, out = np.ascontiguousarray(values, dtype=float), np.empty((len(values), *kernel.outputs))
    held, none = np.zeros(workspace), np.zeros(1)
    run(len(out), 0, *(array.ctypes.data for array in (none, held, given, out)))
    return out


def test_sine_and_cosine_to_one_place():
    """Within one unit in the last place of the true value, near and far, at multiples of pi/2, tiny and huge."""
    rng = np.random.default_rng(7)
    turns = np.pi / 2 * rng.integers(-500000, 500000, 300)
    near = np.concatenate([rng.uniform(-7, 7, 2000), rng.uniform(-8e5, 8e5, 1000), turns, np.nextafter(turns, 1e9)])
    edge = np.array([0.0, 5e-324, 1e-300, 1e-8, -1e-8, 2.0**19 * np.pi / 2, 1e7, 1e15, -1e22, 1e300])
    x = np.concatenate([near, edge])
    found = sampled(SINE_COSINE, x)
    mpmath.mp.prec = 1200
    for column, true in enumerate((mpmath.sin, mpmath.cos)):
        exact = [true(mpmath.mpf(value)) for value in x]
        places = [
            abs(float((mpmath.mpf(value) - right) / mpmath.mpf(np.spacing(abs(float(right))))))
            for value, right in zip(found[:, column], exact, strict=True)
        ]
        assert max(places) <= 1.0, (true.__name__, x[int(np.argmax(places))], max(places))


def test_sine_of_nothing_is_nothing():
    """Not-a-number and infinity give not-a-number, as IEEE wants."""
    assert np.isnan(sampled(SINE_COSINE, [np.nan, np.inf, -np.inf])).all()


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
    found, numbers = setup.model.rate(time, state, row), setup.model.numbers
    for k in range(50):
        blocks = {"time": time[k], "state": state[k], "row": row[k], "step": 0.0}
        wanted = interpreted(setup.model.loop.rate, blocks, numbers)
        assert np.abs(found[k] - wanted).max() <= 1e-12 * np.abs(wanted).max()


def test_unknown_operation_is_refused():
    """An operation without a native form is an error of ours, not wrong code."""
    x = ca.SX.sym("x")
    with pytest.raises(CompileError, match="no native form"):
        block_program(ca.Function("f", [x], [ca.erf(x)]))


def test_a_function_outlives_its_library():
    """Who holds a function may call it after the library, and hundreds after it, are gone."""
    held, workspace = compiled(SINE_COSINE, "outlives")
    kernels._loaded.clear()
    for number in range(70):
        compiled(SINE_COSINE, f"later {number}")
        kernels._loaded.clear()
    memory, x, out = np.zeros(workspace), np.array([0.5]), np.empty(2)
    held(1, 0, *(array.ctypes.data for array in (np.zeros(1), memory, x, out)))
    assert out == pytest.approx([np.sin(0.5), np.cos(0.5)], abs=0)


def test_damaged_cache_entry_is_made_again(tmp_path, monkeypatch):
    """A bit flip, a cut, another key's entry: never used, always replaced."""
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))
    kernels._loaded.clear()
    sampled(SINE_COSINE, [0.5])
    (entry,) = (tmp_path / "cache").glob("*.o")
    whole = entry.read_bytes()
    for damage in (whole[:-1], whole[:100] + bytes([whole[100] ^ 1]) + whole[101:], b"", b"0" * len(whole)):
        entry.write_bytes(damage)
        kernels._loaded.clear()
        assert sampled(SINE_COSINE, [0.5])[0, 0] == pytest.approx(np.sin(0.5), abs=0)
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


def test_cache_that_cannot_be_written_costs_time_only(tmp_path, monkeypatch):
    """A full disk below the cache is no error."""
    monkeypatch.setenv("TMODES_CACHE", str(tmp_path / "cache"))

    def full(path, **_):
        raise ResultFileError(f"{path}: the disk is full")

    monkeypatch.setattr(cache, "atomic_write", full)
    kernels._loaded.clear()
    assert sampled(SINE_COSINE, [0.5])[0, 0] == pytest.approx(np.sin(0.5), abs=0)


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
