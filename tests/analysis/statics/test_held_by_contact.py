"""Robots whose free joints are held by a contact alone: a rocker as a ball of its length, a lever on a floor."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.linalg import eigh
from scipy.optimize import minimize, root

from simulation.sheets import arm
from tmodes.analysis.describe.describe import describe
from tmodes.analysis.statics.at_rest import robot_rest

GRAVITY, STIFFNESS = 9.81, 1e5


class FourBar:
    """Crank and coupler in the plane x, z, turning about y; the rocker is a spring between the coupler's end and C."""

    def __init__(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        self.crank, self.coupler = rng.uniform((0.15, 0.4), (0.25, 0.5))
        self.rocker = self.crank * rng.uniform(0.8, 1.2)
        self.center = np.array([self.coupler + rng.uniform(-0.05, 0.05), rng.uniform(-0.03, 0.03)])
        self.masses, self.moments = rng.uniform(0.5, 1.5, 2), rng.uniform(0.002, 0.01, 2)

    def sheet(self, **more: Any) -> Any:
        joints = [{"name": "crank", "type": "revolute", "child": "crank", "axis": [0, 1, 0], "state": "free"},
                  {"name": "pin", "type": "revolute", "child": "coupler", "axis": [0, 1, 0], "state": "free",
                   "from": "frame", "origin": {"position": [0, 0, -self.crank]}}]  # fmt: skip
        middles = [[0, 0, -self.crank / 2], [self.coupler / 2, 0, 0]]
        links = [
            {"name": name, "bodies": [{"mass": mass, "center": middle, "inertia": moment}]}
            for name, mass, middle, moment in zip(("crank", "coupler"), self.masses, middles, self.moments, strict=True)
        ]
        contact = {"law": "bilateral", "shape": {"type": "ball", "center": [self.center[0], 0, self.center[1]],
                   "radius": self.rocker}, "stiffness": STIFFNESS, "damping": 1.0}  # fmt: skip
        tip = {"link": "coupler", "position": [self.coupler, 0, 0]}
        return arm(gravity=GRAVITY, joints=joints, links=links, tip=tip, contact=contact,
                    integration={"duration": 1.0, "output_step": 0.1}, **more)  # fmt: skip

    def places(self, q: Any) -> list[np.ndarray]:
        """Centers of both bodies, and the coupler's end."""
        (c, d) = q[0], q[0] + q[1]
        pin = -self.crank * np.array([np.sin(c), np.cos(c)])
        along = np.array([np.cos(d), -np.sin(d)])
        return [pin / 2, pin + self.coupler / 2 * along, pin + self.coupler * along]

    def potential(self, q: Any) -> float:
        one, two, end = self.places(q)
        stretch = np.linalg.norm(end - self.center) - self.rocker
        return GRAVITY * (self.masses @ [one[1], two[1]]) + STIFFNESS * stretch**2 / 2

    def mass(self, q: Any) -> np.ndarray:
        step = 1e-6
        slopes = [np.array([(np.array(self.places(q + step * e)) - self.places(q - step * e))[k] / (2 * step)
                            for e in np.eye(2)]) for k in range(2)]  # fmt: skip
        turns = [np.array([1.0, 0.0]), np.array([1.0, 1.0])]
        parts = zip(self.masses, slopes, self.moments, turns, strict=True)
        return np.sum([m * s @ s.T + j * np.outer(t, t) for m, s, j, t in parts], axis=0)

    def slope(self, q: Any) -> np.ndarray:
        return np.array([self.potential(q + 1e-5 * e) - self.potential(q - 1e-5 * e) for e in np.eye(2)]) / 2e-5

    def rest(self) -> tuple[np.ndarray, np.ndarray]:
        """The pose of least energy, and its frequencies [Hz], by SciPy."""
        q = root(self.slope, minimize(self.potential, np.zeros(2)).x, tol=1e-12).x
        stiffness = np.array([self.slope(q + 1e-5 * e) - self.slope(q - 1e-5 * e) for e in np.eye(2)]) / 2e-5
        return q, np.sqrt(eigh(stiffness, self.mass(q), eigvals_only=True)) / (2 * np.pi)


@pytest.mark.parametrize("seed", range(6))
def test_a_four_bar_rests_and_vibrates_as_its_energies_say(seed: int) -> None:
    bar = FourBar(seed)
    pose, frequencies = bar.rest()
    rest = robot_rest(bar.sheet())
    assert rest.stable
    assert rest.q == pytest.approx(pose, abs=1e-6)
    mass, _, stiffness = rest.matrices
    assert np.sqrt(eigh(stiffness, mass, eigvals_only=True)) / (2 * np.pi) == pytest.approx(frequencies, rel=1e-5)
    assert rest.lowest_frequency_Hz == pytest.approx(frequencies[0], rel=1e-5)


def test_a_free_lever_comes_to_rest_on_a_floor_that_only_pushes() -> None:
    """Its end sinks until the floor carries half of its weight: m g / 2 = k depth."""
    joint = {"name": "j", "type": "revolute", "child": "l", "axis": [0, 1, 0], "state": "free"}
    link = {"name": "l", "bodies": [{"mass": 2.0, "center": [0.25, 0, 0], "inertia": 0.01}]}
    floor = {"law": "unilateral", "shape": {"type": "plane", "normal": [0, 0, 1], "position": [0, 0, -0.1]},
             "stiffness": STIFFNESS, "damping": 1.0}  # fmt: skip
    sheet = arm(joints=[joint], links=[link], tip={"link": "l", "position": [0.5, 0, 0]}, contact=floor)
    rest = robot_rest(sheet)
    assert rest.stable
    depth = 0.5 * np.sin(rest.q[0]) - 0.1
    assert depth == pytest.approx(2.0 * 9.81 / 2 / STIFFNESS, rel=1e-6)


def test_the_description_of_such_a_robot_is_in_contact() -> None:
    bar = FourBar(0)
    pose, _ = bar.rest()
    found = describe(bar.sheet())
    end = bar.places(pose)[2]
    assert found["sag"]["position_m"] == pytest.approx([end[0], 0.0, end[1]], abs=1e-6)
    assert any("in contact" in note for note in found["notes"])
