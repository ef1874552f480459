"""A robot as a WebAssembly module: both runs, its rest, its picture, its energies; and the layout for its engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from tmodes.analysis.modes.closed_loop import servos_together
from tmodes.chain.chain import Chain, Point
from tmodes.compile.loops.time_loop import ARGUMENTS, CELLS, OPTIONS, Status
from tmodes.compile.wasm.wasm import WasmPart, wasm_module
from tmodes.compile.wasm.wasm_parts import each_once, schedule_loop, schedule_samples
from tmodes.equations.line.schedule import Lines
from tmodes.equations.loop.closed_loop import ClosedLoop
from tmodes.equations.mechanics import mechanics
from tmodes.integrate.settings import Integration
from tmodes.kinds.kernel.schedule import Schedule
from tmodes.live.numbers import follow_of, has_reference
from tmodes.live.places import line_names
from tmodes.model.model import Model
from tmodes.model.passes import ChainPasses
from tmodes.sheet import RobotPair
from tmodes.sheet.robot import RECURSION
from tmodes.simulation.loop import Loops
from tmodes.simulation.native_run import BOUND, EVENT_TIME, MOST_EVENTS
from tmodes.simulation.plan import Follow, Planned, planned

__all__ = ["LiveFunctions", "LiveModule", "ModelFunctions", "engine_settings", "live_module", "stationed"]


@dataclass(frozen=True, eq=False)
class ModelFunctions:
    """What a robot's module is made of: the plans of its regimes, and the passes over its chain.

    ``stations``: places along each link, 0 its root and 1 its tip, of which the picture is made. ``places``: where the
    function ``line`` of a page computes the lines of all links, the stations among them; it stands for ``pose`` there.
    """

    pair: RobotPair
    stations: tuple[float, ...]
    places: tuple[float, ...] = ()

    @cached_property
    def plans(self) -> dict[str, Planned]:
        """What happens: ``reference`` where there is one, ``real``, and ``rest``, in which every drive stands."""
        nominal, real = self.pair.nominal, self.pair.real
        reference = follow_of(nominal, "reference") if has_reference(nominal) else None
        follows = {"reference": (nominal, reference), "real": (real, Follow.SHEET), "rest": (real, Follow.HELD)}
        return {name: planned(robot, follow) for name, (robot, follow) in follows.items() if follow}

    @cached_property
    def loops(self) -> dict[str, ClosedLoop]:
        """The closed loops of the plans."""
        return {name: ClosedLoop(plan.plan) for name, plan in self.plans.items()}

    def settles(self, name: str) -> Schedule | None:
        """The rates of a plan at rest, where they are not those of its run and a start is found by them."""
        plan, loop = self.plans[name].plan, self.loops[name]
        controlled = any(drive.servo and drive.servo.is_controlled for drive in plan.drives)
        return ClosedLoop(plan.settles).rate if controlled and (loop.modes or plan.is_sampled) else None

    @cached_property
    def passes(self) -> dict[str, ChainPasses]:
        """The passes over the real ``chain``, and over the one with a point at each station (``pose``).

        Of a robot that is stated by its energies alone, ``pose`` has the points of the statement.
        """
        chain = self.pair.real.model_copy(update={"drives": ()}).chain()
        passes = {"chain": Model(chain).passes}
        if self.places:
            return passes
        if passes["chain"].mechanics.on_links:
            chain = replace(stationed(chain, self.stations), equations=RECURSION)
        return passes | {"pose": ChainPasses(mechanics(chain))}

    @cached_property
    def lines(self) -> Lines | None:
        """The lines of all links, with wrenches on the points where any act."""
        return self.passes["chain"].lines(self.places, loaded=self.loaded) if self.places else None

    @cached_property
    def servos(self) -> dict[str, Schedule]:
        """``servos``, by which a page finds modes under control; nothing where they are springs and dampers."""
        bare = self.pair.real.model_copy(update={"drives": ()})
        found = servos_together(self.pair.real, Model(bare.chain())) if self.places else None
        return {"servos": found.schedule} if found else {}

    @property
    def loaded(self) -> bool:
        """Whether forces act on points."""
        plan = self.plans["real"].plan
        return bool(plan.loads or plan.touch)


def live_module(functions: ModelFunctions, methods: Sequence[str], *, slopes: bool = True) -> LiveModule:
    """All functions of a robot; ``slopes``: ``rest.rate`` gives its derivatives too, half as much code again.

    Loops: ``reference.METHOD`` (where there is a nominal run) and ``real.METHOD``. Samples: ``observe`` and ``rate``
    of both as of :class:`tmodes.simulation.loop.LoopModel`, ``switched`` where something sticks, ``sampled`` where
    outputs are held before the first sample, ``settles`` where the rates at rest
    (:attr:`tmodes.equations.loop.plan.LoopPlan.settles`) are others; ``rest.rate``, whose accelerations vanish at
    rest, where ``held`` coordinates stand by themselves; ``inertia``, ``elastic`` as of
    :class:`tmodes.model.passes.ChainPasses`; for a page, whose ``observe`` gives what it shows alone, ``points`` of
    ``inertia``, and ``tip``: where the first of them is; ``pose``: motion of every station (24 numbers each:
    rotation, position, velocity, rate, accelerations), link by link; ``loaded``: the forces of ``inertia`` with
    wrenches on the
    points, where any act; ``elastic.slopes``: the forces of ``elastic`` with their derivatives; for a page
    ``servos.slopes``: those of :class:`tmodes.analysis.modes.closed_loop.Servos`, where there are any.
    """
    made = LiveFunctions()
    for name, loop in functions.loops.items():
        if name == "rest":
            kind = "derivative" if slopes else "double"
            parts = schedule_samples("rest.rate", loop.rate, kind)
            made.schedule("rest.rate", parts, loop.rate, stride=2 if slopes else 1)
            continue
        sizes = {"size": loop.layout.size, "row": loop.plan.row_size, "parameters": loop.rate.parameters}
        for method in methods:
            made.loop(f"{name}.{method}", _loop(f"{name}.{method}", loop, method), **sizes)
        labels = (*("switched",) * bool(loop.modes), *("sampled",) * (loop.plan.first_samples > 1))
        for label in ("observe", "rate", *labels):
            schedule = getattr(loop, label)
            if label == "observe" and functions.lines:
                more = ("controls",) if name == "real" and loop.plan.is_sampled else ()  # as they are after samples
                schedule = schedule.only(_SHOWN[name] + more)
            made.schedule(f"{name}.{label}", schedule_samples(f"{name}.{label}", schedule), schedule)
        if settles := functions.settles(name):
            made.schedule(f"{name}.settles", schedule_samples(f"{name}.settles", settles), settles)
    passes = _passes(functions)
    for label, schedule in passes.items():
        made.schedule(label, schedule_samples(label, schedule), schedule)
    for label, schedule in (functions.servos | {"elastic": passes["elastic"].only(("forces",))}).items():
        name = f"{label}.slopes"
        made.schedule(name, schedule_samples(name, schedule, "derivative"), schedule, stride=2)
    return made.module("robot", **_layout(functions))


def _passes(functions: ModelFunctions) -> dict[str, Schedule]:
    """The passes over the chain, and what is drawn of it."""
    chain = functions.passes["chain"]
    passes = {"inertia": chain.schedule("inertia"), "elastic": chain.schedule("elastic")}
    if functions.lines:
        passes["line"] = functions.lines.schedule.only(line_names(functions.lines))
        passes |= _motions(passes["inertia"])
    else:
        passes["pose"] = functions.passes["pose"].schedule("inertia").only(("points",))
    if functions.loaded:
        passes["loaded"] = chain.schedule("inertia", loaded=True).only(("forces",))
    return passes


_SHOWN = {"reference": ("q", "v", "gear", "contact"), "real": ("q", "v", "a", "drives", "gear", "contact")}
"""What a page shows of each regime."""


def _motions(inertia: Schedule) -> dict[str, Schedule]:
    """Parts of the forces of inertia that a page asks for at many samples: without the forces, and without rates."""
    pose = inertia.outputs["points"][0]
    return {
        "points": inertia.only(("points",)),
        "tip": replace(inertia, outputs={"tip": [pose.part(9, 3)]}).only(("tip",)),
    }


def _loop(symbol: str, loop: ClosedLoop, method: str) -> Any:
    schedule, guarded, more = Loops(loop).stated(method)
    return schedule_loop(symbol, schedule, guarded, method, **more)


def _layout(functions: ModelFunctions) -> Mapping[str, Any]:
    """What else an engine must know: coordinates, where a state holds what, which coordinates stand at rest."""
    loop, rest = functions.loops["real"], functions.loops["rest"]
    places = {name: [part.start, part.stop] for name, part in loop.layout._asdict().items()}
    held = sorted({driver.coordinate for driver in rest.drivers})
    nodes = loop.plan.chain.nodes
    return {
        "coordinates": [*loop.parts.names], "state": places, "held": held, "stations": [*functions.stations],
        "links": [{"name": node.name, "kind": type(node.link).__name__.lower()} for node in nodes],
        "drives": [driver.plan.joint for driver in loop.drivers],
    }  # fmt: skip


def stationed(chain: Chain, stations: Sequence[float]) -> Chain:
    """The same chain with a named point at each station of each link that bends, and at the root of others.

    A rigid link and the paper's mode have one point; that of a mode is its tip.
    """
    points = []
    for index, node in enumerate(chain.nodes):
        places = stations if node.link.has_stations else (1.0,)
        points += [Point(f"{index}.{s}", index, s) for s in places]
    return replace(chain, points=tuple(points))


def engine_settings(chosen: Integration) -> dict[str, Any]:
    """Settings of a method as the engine reads them."""
    return {
        "duration": chosen.duration, "step": chosen.step, "maxSteps": chosen.max_steps,
        "relativeTolerance": chosen.relative_tolerance, "absoluteTolerance": chosen.absolute_tolerance,
    }  # fmt: skip


FORMAT = 1

"""Number of the way in which a layout is written."""


@dataclass(frozen=True)
class LiveModule:
    """``wasm``: the module, with memory of its own; ``layout``: plain data by which the engine calls it."""

    wasm: bytes
    layout: dict[str, Any]


@dataclass
class LiveFunctions:
    """What goes into a module: code, and by the names that the engine knows, loops and functions over samples."""

    parts: list[WasmPart] = field(default_factory=list)
    loops: dict[str, dict[str, Any]] = field(default_factory=dict)
    samples: dict[str, dict[str, Any]] = field(default_factory=dict)

    def loop(self, name: str, parts: Sequence[WasmPart], *, size: int, row: int, parameters: int) -> None:
        """A time loop, whose function is the first part's: numbers of its state, of a row of signals, of parameters."""
        self.parts += parts
        info = {"export": parts[0].symbols[0], "size": size, "row": row, "parameters": parameters}
        self.loops[name] = info | {"method": name.rpartition(".")[2]}

    def schedule(self, name: str, parts: Sequence[WasmPart], schedule: Any, *, stride: int = 1) -> None:
        """A schedule over samples, whose function is the first part's; ``stride`` 2: with derivatives."""
        self.parts += parts
        inputs = {label: slot.size for label, slot in schedule.inputs.items()}
        outputs = {label: sum(slot.size for slot in slots) for label, slots in schedule.outputs.items()}
        self.samples[name] = {
            "export": parts[0].symbols[0], "kind": "schedule" if stride == 1 else "slopes", "inputs": inputs,
            "outputs": outputs, "parameters": schedule.parameters, "workspace": stride * schedule.workspace,
        }  # fmt: skip

    def module(self, name: str, **info: Any) -> LiveModule:
        """The compiled module; ``info``: what else its layout holds."""
        parts = each_once(self.parts)
        layout = {
            "format": FORMAT, "cells": [*CELLS], "options": [*OPTIONS], "arguments": [*ARGUMENTS],
            "statuses": {status.name.lower(): int(status) for status in Status},
            "limits": {"bound": BOUND, "most_events": MOST_EVENTS, "event_time": EVENT_TIME},
            "simd": any(part.simd for part in parts), "loops": self.loops, "samples": self.samples,
        }  # fmt: skip
        return LiveModule(wasm_module(name, parts), layout | info)
