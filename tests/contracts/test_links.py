"""What every link kind keeps, one of a user's script among them: a link with a tabulated stiffness is defined here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

import numpy as np
import pytest
from pydantic import Field

import tmodes
from lane_runs import simulate_lanes
from simulation.sheets import arm
from tmodes.errors import InputError
from tmodes.gradients.gradient import forward_sensitivities
from tmodes.kinds.kernel.functions import fabs, fmax, if_else
from tmodes.kinds.links.contract import Body, ElasticForces, Link, LinkNumbers, LinkStructure, Row
from tmodes.kinds.links.registry import LINKS
from tmodes.kinds.links.segment import segment_link
from tmodes.kinds.links.sheet import BendingSheet
from tmodes.kinds.schema.quantity import positive
from tmodes.model.model import Model
from tmodes.report import write_report
from tmodes.simulation.initial_state import run_setup, run_trajectory
from tmodes.simulation.simulate import simulate_motion
from wasm.node import page_states


@dataclass(frozen=True)
class TableStructure(LinkStructure):
    """One angle about z; stiffness numbers: the angles of the knots, then by how much the slope rises at each."""

    knots: int
    size: ClassVar[int] = 1  # pyright: ignore[reportIncompatibleMethodOverride]
    table_size: ClassVar[int] = 1  # pyright: ignore[reportIncompatibleMethodOverride]
    damping_size: ClassVar[int] = 1  # pyright: ignore[reportIncompatibleMethodOverride]

    @property
    def key(self) -> str:
        return f"table {self.knots}"

    @property
    def stiffness_size(self) -> int:
        return 2 * self.knots

    def sections(self, tables: Any, rate: Any, q: Any, qd: Any) -> tuple[list[Any], list[list[Any]]]:
        return [0.0], [segment_link(False, True, tables[0], rate, q, qd)]

    def elastic(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> ElasticForces:
        over = [fmax(fabs(q[0]) - stiffness[i], 0.0) for i in range(self.knots)]
        moment, energy = (sum(stiffness[self.knots + i] * x**n / n for i, x in enumerate(over)) for n in (1, 2))
        lost = damping[0] * qd[0]
        return ElasticForces([if_else(q[0] < 0, -moment, moment)], [lost], energy, lost * qd[0])

    def tangents(self, stiffness: Any, damping: Any, q: Any, qd: Any) -> tuple[list[Row], list[Row]]:
        slopes = [if_else(fabs(q[0]) > stiffness[i], stiffness[self.knots + i], 0.0) for i in range(self.knots)]
        return [[(0, sum(slopes))]], [[(0, damping[0])]]


@dataclass(frozen=True, eq=False)
class TableLink(Link):
    kind: ClassVar[str] = "table"
    coordinates: ClassVar[tuple[str, ...]] = ("bend",)  # pyright: ignore[reportIncompatibleMethodOverride]
    length: float
    springs: Any
    damping: float
    bodies: tuple[Body, ...]

    def numbers(self, stations: tuple[float, ...]) -> LinkNumbers:
        damping = np.array([self.damping])
        return LinkNumbers(TableStructure(len(self.springs) // 2), np.array([self.length]), self.springs, damping)


@LINKS.register
class TableSheet(BendingSheet):
    words: ClassVar[tuple[str, ...]] = ("table",)
    coordinate_count: ClassVar[int] = 1  # pyright: ignore[reportIncompatibleMethodOverride]
    model: Literal["table"]
    length: float = positive("m", "L", "length")
    angles: tuple[float, ...] = Field(strict=False)
    moments: tuple[float, ...] = Field(strict=False)
    damping: float = positive("N*m*s/rad", "d", "damping")

    @property
    def line_length(self) -> float:
        return self.length

    def link(self, bodies: tuple[Body, ...]) -> Link:
        slopes = np.diff([0.0, *self.moments]) / np.diff([0.0, *self.angles])
        springs = np.concatenate([[0.0, *self.angles[:-1]], np.diff(slopes, prepend=0.0)])
        return TableLink(self.length, springs, self.damping, bodies)


SECTION = {"bending_stiffness": [9.0, 6.0], "mass_per_length": 0.4, "polar_inertia_per_length": 1e-4}
BEAM = {"length": 0.5, "damping_time": 2e-3, "section": SECTION}
MODE = {"length": 0.3, "bending_stiffness": 6.0, "mass_per_length": 0.5, "damping_time": 2e-3}
BEAMS = {
    "strain": BEAM | {"functions": {"bend_y": 2, "bend_z": 1}},
    "segments": BEAM | {"segments": 2},
    "rigid": BEAM,
    "modes": {"modes": [MODE, MODE | {"length": 0.2, "bending_stiffness": 2.0}, MODE]},
    "table": {"length": 0.4, "angles": [0.01, 0.05], "moments": [0.8, 2.4], "damping": 0.05},
}
"""Numbers of one of each kind; a kind without an entry fails."""

WORDS = sorted(LINKS)
BENDING = [word for word in WORDS if word != "rigid"]
INERTIA = {"xx": 2e-3, "yy": 3e-3, "zz": 2.5e-3, "xy": 1e-4}


def sheet(word: str, **integration: Any) -> Any:
    """Two links on joints about crossed axes, the first of the kind, under a torque."""
    body = {"name": "load", "mass": 0.6, "center": [0.02, 0.01, 0.0], "inertia": INERTIA}
    return arm(
        gravity=9.81,
        joints=[{"name": "first", "type": "revolute", "parent": "base", "child": "link", "axis": [0, 0.6, 0.8]},
                {"name": "second", "type": "revolute", "parent": "link", "child": "hand", "axis": [0, 1, 0]}],
        links=[{"name": "link", "beam": {"model": word, **BEAMS[word]}, "bodies": [body]},
               {"name": "hand", "bodies": [body | {"center": [0.1, 0.0, 0.02]}]}],
        drives=[{"joint": "first", "command": "effort", "signal": {"type": "constant", "value": 2.0}}],
        initial={"state": "zero", "rates": {"first": 1.0}},
        integration={"duration": 0.2, "output_step": 0.005, "relative_tolerance": 1e-9,
                     "absolute_tolerance": 1e-11, **integration},
    )  # fmt: skip


def state(size: int, seed: int) -> list[np.ndarray]:
    rng = np.random.default_rng(seed)
    return [scale * rng.normal(size=size) for scale in (0.03, 1.0, 3.0)]


@pytest.mark.parametrize("word", WORDS)
def test_dynamics_follow_from_the_energies(word: str) -> None:
    """M is symmetric and positive, T = v'Mv/2, and forces take and give the power that the energies say."""
    model = Model(sheet(word).chain())
    q, v, a = state(model.nq, 3)
    mass = model.mass_matrix(q)
    assert np.linalg.eigvalsh(mass)[0] > 0
    assert model.energies(q, v)["kinetic"] == pytest.approx(v @ mass @ v / 2, rel=1e-12)
    step = 1e-6
    total = [sum(model.energies(q + s * v + s * s / 2 * a, v + s * a).values()) for s in (step, -step)]
    power = v @ model.inverse_dynamics(q, v, a) - model.power_lost(q, v)
    assert power == pytest.approx((total[0] - total[1]) / (2 * step), rel=1e-6, abs=1e-6)
    effort = np.array([0.3, -0.2])[: len(model.efforts)]
    found = model.forward_dynamics(q, v, effort)
    assert model.inverse_dynamics(q, v, found)[:2] == pytest.approx(effort, abs=1e-7)


@pytest.mark.parametrize("word", WORDS)
def test_the_link_that_it_is_compared_with_shares_its_code(word: str) -> None:
    """Whose difference shows the error of the model: the same structure with other numbers, or none."""
    for node in sheet(word).chain().nodes:
        other = node.link.compared()
        assert (other is node.link) == (not node.link.bends)
        if other is not None and node.link.bends:
            one, two = node.link.numbers(()), other.numbers(())
            assert one.structure == two.structure
            here, there = ([body.center for body in link.all_bodies] for link in (node.link, other))
            assert np.any(one.stiffness != two.stiffness) or not np.array_equal(here, there)


@pytest.mark.parametrize("word", BENDING)
def test_forces_and_tangents_are_derivatives(word: str) -> None:
    """Spring forces of the energy, tangents of the forces; power lost is that of the dampers, never negative."""
    for link in LINKS[word].model_validate({"model": word, **BEAMS[word]}).lowered(()).links:
        numbers = link.numbers(link.stations())
        structure = numbers.structure
        q, qd, _ = state(structure.size, 5)
        constants, step = (numbers.stiffness, numbers.damping), 1e-6
        here = structure.elastic(*constants, q, qd)
        k, d = (rows_of(rows) for rows in structure.tangents(*constants, q, qd))
        for j, shift in enumerate(step * np.eye(structure.size)):
            ends = [structure.elastic(*constants, q + s * shift, qd) for s in (1, -1)]
            assert here.spring[j] == pytest.approx((ends[0].energy - ends[1].energy) / (2 * step), rel=1e-6, abs=1e-8)
            slope = (np.array(ends[0].spring) - ends[1].spring) / (2 * step)
            assert k[:, j] == pytest.approx(slope, rel=1e-6, abs=1e-6 * np.abs(k).max())
            rates = [np.array(structure.elastic(*constants, q, qd + s * shift).damper) for s in (1, -1)]
            assert d[:, j] == pytest.approx((rates[0] - rates[1]) / (2 * step), rel=1e-6, abs=1e-9)
        assert here.loss == pytest.approx(np.dot(here.damper, qd), rel=1e-12)
        assert here.loss >= 0


def rows_of(rows: list[Row]) -> np.ndarray:
    matrix = np.zeros((len(rows), len(rows)))
    for i, row in enumerate(rows):
        for j, value in row:
            matrix[i, j] = value
    return matrix


@pytest.mark.parametrize("word", BENDING)
def test_run(word: str) -> None:
    """Natively, by an implicit method and in a batch alike; energy balances."""
    run = simulate_motion(sheet(word))
    assert np.abs(run.energy_balance).max() < 1e-6 * run.energy_moved
    other = simulate_motion(sheet(word, method="extrapolation"))
    assert np.abs(other.q - run.q).max() < 1e-6
    setup = run_setup(sheet(word, method="dormand_prince"))
    native = run_trajectory(setup)
    settings = setup.robot.integration
    rows = np.array([setup.model.numbers] * 2)
    batch = simulate_lanes(setup.model, rows, setup.planned.schedule, setup.start, settings)
    assert np.abs(batch.states[1] - native.states).max() < 1e-9


def test_page(tmp_path: Any) -> None:
    """The same run in WebAssembly."""
    setup = run_setup(sheet("modes", method="dormand_prince"))
    assert np.abs(page_states(setup, tmp_path) - run_trajectory(setup).states).max() < 1e-8


def test_derivatives() -> None:
    """Of the end of a run by a number of the link: against differences of runs."""
    path, value = "links.link.beam.modes.1.bending_stiffness", 2.0
    given = sheet("modes", duration=0.1, method="dop853")
    slope = forward_sensitivities(given, [path]).by[path][-1]
    ends = [simulate_motion(given.with_({path: value * (1 + s)})).q[-1] for s in (1e-4, -1e-4)]
    assert slope[: len(ends[0])] == pytest.approx((ends[0] - ends[1]) / (2e-4 * value), rel=1e-3, abs=1e-9)


def test_report(tmp_path: Any) -> None:
    """The report of a run has the link's coordinates."""
    given = sheet("modes", duration=0.05)
    path = write_report(tmodes.run(given), tmp_path / "report.html")
    assert f"link.{given.chain().nodes[0].link.coordinates[0]}" in path.read_text(encoding="utf-8")


def test_kinds_are_refused_and_distinguished() -> None:
    with pytest.raises(Exception, match=r"links\.link\.beam\.model.*tabel"):
        sheet("table").with_({"links.link.beam.model": "tabel"})
    with pytest.raises(InputError, match="table"):

        @LINKS.register
        class Other(BendingSheet):
            words: ClassVar[tuple[str, ...]] = ("table",)

    assert TableStructure(2).fingerprint != TableStructure(2).key
    assert len(TableStructure(2).fingerprint.split()[-1]) == 16
