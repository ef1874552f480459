"""Controllers and sensors of a user whose methods raise, or give what is none: errors with their name, no traceback."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, ClassVar, Literal

import pytest
from pydantic import Field

import tmodes
from contracts.test_blocks import Sheet, spong
from tmodes.errors import InputError
from tmodes.kinds.controllers.registry import CONTROLLERS, Controller, Measured
from tmodes.kinds.sensors.registry import SENSORS, Port, Sensor
from tmodes.simulation.plan import planned
from tmodes.simulation.simulate import simulate_motion

HELD = {"type": "constant", "value": 0.1}


class Faulty(Controller):
    """What it gives is replaced by each case."""

    type: Literal["faulty"]
    gain: float = Field(40.0, strict=False)
    sees_all: ClassVar[bool] = False

    def numbers(self) -> tuple[float, ...]:
        return (self.gain, 4.0)

    def initial(self) -> tuple[float, ...]:
        return (0.0,)

    def command(self, p: Any, m: Measured, x: list[Any]) -> Any:
        return p[0] * (m.wanted - m.position) - p[1] * m.velocity + x[0]

    def rates(self, p: Any, m: Measured, x: list[Any]) -> list[Any]:
        del p, x
        return [m.wanted - m.position]


class FaultySensor(Sensor):
    ports: ClassVar[tuple[Port, ...]] = (Port("", "rad/s"),)
    type: Literal["faulty"]

    @property
    def sources(self) -> tuple[str, ...]:
        return ("joint.velocity",)

    def value(self, seen: Any) -> list[Any]:
        return [seen["joint.velocity"]]


@pytest.fixture(autouse=True, scope="module")
def registered() -> Iterator[None]:
    CONTROLLERS.register(Faulty)
    SENSORS.register(FaultySensor)
    yield
    CONTROLLERS.unregister("faulty")
    SENSORS.unregister("faulty")


def fails() -> Any:
    message = "a fault of its own"
    raise RuntimeError(message)


CASES: dict[str, tuple[str, Any]] = {
    "raises": ("command", lambda _s, _p, _m, _x: fails()),
    "nothing": ("command", lambda _s, _p, _m, _x: None),
    "two commands of one drive": ("command", lambda _s, p, _m, _x: [p[0], p[1]]),
    "a branch": ("command", lambda _s, _p, m, _x: 1.0 if m.position > 0 else 2.0),
    "a float of a symbol": ("command", lambda _s, p, m, _x: p[0] * math.sin(m.position)),
    "a number that is none": ("command", lambda _s, _p, _m, _x: math.nan),
    "too few rates": ("rates", lambda _s, _p, _m, _x: []),
    "a start that is no number": ("initial", lambda _s: (math.nan,)),
    "numbers that are none": ("numbers", lambda _s: (math.inf, 1.0)),
    "words for numbers": ("numbers", lambda _s: ("a", "b")),
    "no period": ("period", property(lambda _s: 0.0)),
    "too few updates": ("updates", lambda _s, _p, _m, _x: []),
}


@pytest.mark.parametrize("block", [False, True])
@pytest.mark.parametrize("name", CASES)
def test_a_controller_is_refused_by_its_name(name: str, block: bool, monkeypatch: pytest.MonkeyPatch) -> None:
    method, gives = CASES[name]
    monkeypatch.setattr(Faulty, method, gives)
    if method == "updates":
        monkeypatch.setattr(Faulty, "period", property(lambda _s: 0.01))
    controller: Sheet = {"type": "faulty"}
    sheet: dict[str, Any] = {"control": [{"name": "law", "drives": ["joint"], "block": controller}]} if block else {
        "drive": {"controller": controller}}  # fmt: skip
    with pytest.raises(InputError) as wrong:
        simulate_motion(spong(HELD, 0.02, 0.01, **sheet))
    assert wrong.value.which == f"Faulty.{method}"


@pytest.mark.parametrize("gives", [
    lambda _s, _seen: fails(), lambda _s, _seen: None, lambda _s, seen: [seen["other"]],
    lambda _s, seen: [seen["joint.velocity"]] * 2, lambda _s, _seen: ["a"],
])  # fmt: skip
def test_a_sensor_is_refused_by_its_name(gives: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(FaultySensor, "value", gives)
    with pytest.raises(InputError) as wrong:
        simulate_motion(spong(HELD, 0.02, 0.01, drive={"controller": {"type": "faulty"}},
                              sensors=[{"name": "a", "type": "faulty", "sample_time": 0.01}]))  # fmt: skip
    assert wrong.value.which == "FaultySensor.command"


def test_without_a_fault_both_run() -> None:
    sensors = [{"name": "a", "type": "faulty", "sample_time": 0.01}]
    assert planned(spong(HELD, 0.02, 0.01, drive={"controller": {"type": "faulty"}}, sensors=sensors)).plan.blocks


def test_numbers_of_a_faultless_one_are_followed() -> None:
    """By derivatives, in which they are no plain numbers."""
    aim, path, change = tmodes.tracking_error("tip", [0.1, 0.0, -0.4]), "drives.0.controller.gain", 1e-2

    def found(gain: float) -> Any:
        robot = spong(HELD, 0.2, 0.01, drive={"controller": {"type": "faulty", "gain": gain}})
        return tmodes.adjoint_gradient(robot, aim, [path])

    less, here, more = (found(40.0 + step) for step in (-change, 0.0, change))
    assert here.by[path] == pytest.approx((more.value - less.value) / (2 * change), rel=1e-4)
