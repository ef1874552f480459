"""Every contender computes the same robot: accelerations agree with a way of their own in extended precision."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from benchmarks.engines import gcc
from benchmarks.engines.contender import CHECKED, Contender, PeerMissing, Timed, in_turns, needed
from benchmarks.engines.limit import limit
from benchmarks.engines.ours import SAMPLES, Ours
from benchmarks.engines.peers import ENGINES
from benchmarks.engines.rigid import GRAVITY, INERTIA, MASS, TURNED, RigidChain, accelerations, relative_error

from patience import until


def error_of(contender: Contender, robot: RigidChain) -> float:
    q, v = robot.states(SAMPLES)
    return relative_error(contender.found(), accelerations(robot, q[:CHECKED], v[:CHECKED]))


def test_frames_are_turned_by_rotations() -> None:
    assert pytest.approx(np.eye(3), abs=1e-15) == TURNED @ TURNED.T
    assert np.linalg.det(TURNED) == pytest.approx(1.0)


def test_exact_accelerations_of_a_pendulum() -> None:
    """One joint about x: I a = m g (lever across gravity), by hand."""
    angle = 0.7
    (found,) = accelerations(RigidChain(1), [[angle]], [[3.0]])
    turn = TURNED @ np.array([[1, 0, 0], [0, np.cos(angle), -np.sin(angle)], [0, np.sin(angle), np.cos(angle)]])
    center = turn @ [0.05, 0.01, 0.02]
    torque = MASS * np.cross(center, GRAVITY) @ turn[:, 0]
    assert found[0] == pytest.approx(torque / (INERTIA[0] + MASS * (0.01**2 + 0.02**2)), rel=1e-14)


def test_energy_is_kept_by_the_exact_accelerations() -> None:
    """Power of gravity is the rate of the kinetic energy, by central differences along the motion, at five joints."""
    from tmodes.model.model import Model

    robot = RigidChain(5)
    model = Model(robot.chain())
    (q,), (v,) = robot.states(1)
    a = accelerations(robot, [q], [v])[0]
    h = 1e-5
    (before, after) = (
        sum(
            np.sum(model.energies(q + s * h * v + h * h / 2 * a, v + s * h * a)[kind])
            for kind in ("kinetic", "gravity")
        )
        for s in (-1, 1)
    )
    scale = float(model.energies(q, v)["kinetic"])
    assert abs(after - before) / (2 * h) < 1e-6 * scale


@pytest.mark.parametrize("joints", [1, 4, 12])
def test_ours(joints: int) -> None:
    robot = RigidChain(joints)
    found = list(Ours(robot).contenders())
    assert len(found) == 3
    assert max(error_of(one, robot) for one in found) < 1e-13


@pytest.mark.parametrize("way", list(gcc.FLAGS))
@pytest.mark.usefixtures("working_gcc")
def test_gcc(way: str) -> None:
    robot = RigidChain(2)
    contender = gcc.contender(Ours(robot), way)
    assert error_of(contender, robot) < 1e-13
    assert contender.compile_seconds


@pytest.mark.usefixtures("working_gcc")
def test_gcc_that_takes_too_long_is_left_out() -> None:
    with pytest.raises(PeerMissing, match=r"longer than 0\.001 s"):
        gcc.contender(Ours(RigidChain(2)), "gcc -O3", patience=1e-3)


@pytest.mark.skipif(sys.platform != "linux", reason="looks at /proc")
def test_what_a_compiler_started_ends_with_it(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """gcc is a driver: the compiler proper, its child, would go on for minutes next to what is measured next."""
    noted = tmp_path / "pid"
    child = f"import os, signal; open({str(noted)!r}, 'w').write(str(os.getpid())); signal.pause()"
    driver = f"import subprocess, sys; subprocess.run([sys.executable, '-c', {child!r}])"

    class Later(subprocess.Popen[str]):
        """Its time begins when all that it starts has started."""

        def communicate(self, input: Any = None, timeout: float | None = None) -> Any:  # noqa: A002
            until(lambda: noted.exists() and noted.read_text())
            return super().communicate(input, timeout)

    monkeypatch.setattr(gcc.subprocess, "Popen", Later)
    with pytest.raises(PeerMissing, match="given up"):
        gcc.compiled([sys.executable, "-c", driver], 0.01)
    place = Path(f"/proc/{int(noted.read_text())}/cmdline")
    until(lambda: not place.exists() or not place.read_bytes(), "the end of what it started")


@pytest.mark.usefixtures("working_gcc")
def test_text_that_gcc_refuses_is_a_fault() -> None:
    with pytest.raises(RuntimeError, match="refused"):
        gcc.build("this is no C", ("-O0",))


def test_no_compiler_is_no_fault(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", "")
    with pytest.raises(PeerMissing, match="no gcc"):
        gcc.build("", ())


@pytest.mark.peer
@pytest.mark.filterwarnings("ignore::DeprecationWarning")
@pytest.mark.parametrize("peer", ENGINES)
def test_peers(peer: str) -> None:
    robot = RigidChain(7)
    try:
        contender = ENGINES[peer](robot)
    except PeerMissing as missing:
        pytest.skip(str(missing))
    assert error_of(contender, robot) < 1e-11
    assert contender.run() > 0


def test_exudyn_is_left_out_where_it_is_slow() -> None:
    with pytest.raises(PeerMissing, match="above 36 joints"):
        ENGINES["exudyn"](RigidChain(37))


def test_absent_peer_names_its_package() -> None:
    with pytest.raises(PeerMissing, match="pip install some-package"):
        needed("no_such_module_anywhere", "some-package")


@pytest.mark.nightly
def test_limit_counts_the_list_that_runs() -> None:
    """Each joint adds as many operations as another; what follows from parameters is not counted as changing."""
    found = [limit(Ours(RigidChain(n)).schedule) for n in (4, 5, 6)]
    assert found[2].changing - found[1].changing == found[1].changing - found[0].changing > 300
    assert all(0 < one.critical_path < one.throughput and one.changing < one.operations for one in found)


def test_contenders_take_turns_and_the_first_round_does_not_count() -> None:
    order: list[str] = []
    shares: list[float] = []

    def made(name: str, times: list[float]) -> Contender:
        given = iter(times)

        def run() -> float:
            order.append(name)
            return next(given)

        return Contender(name, run, lambda: np.zeros(0))

    times = in_turns([made("a", [9, 1, 2, 3]), made("b", [9, 4, 5, 6])], 3, shares.append)
    assert order == ["a", "b"] * 4
    assert times == {"a": [1, 2, 3], "b": [4, 5, 6]}
    assert shares == [0.25, 0.5, 0.75, 1.0]
    assert Timed.of([3.0, 1.0, 2.0]) == Timed(2.0, 1.5, 2.5)
