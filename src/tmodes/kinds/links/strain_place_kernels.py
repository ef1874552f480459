"""Kernels of the line of a strain link: from section to section, what the sections at its points push, and a place."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any

from tmodes.kinds.kernel import vectors as v
from tmodes.kinds.kernel.functions import atan2, cos, sin
from tmodes.kinds.kernel.schedule import Kernel
from tmodes.kinds.kernel.spatial import FORCE, Force
from tmodes.kinds.links.line import PLACE, POSE, STRESS, STRESS_NUMBERS, Shape, Stressed, in_section, packed_place
from tmodes.kinds.links.strain_line import curvature_sums, magnus_turn, shifted, shifted_line
from tmodes.kinds.links.strain_shape import StrainShape

__all__ = ["STATE", "BeamKernels"]

STATE = 15
"""Numbers of a section: rotation (9), rate (3) and angular acceleration (3), in the axes of the link's root."""

Blocks = Mapping[str, Any]


def _kernel(key: str, inputs: Mapping[str, int], output: int, build: Callable[[Blocks], list[Any]]) -> Kernel:
    """A kernel with named inputs, without those that have no numbers."""
    given = {name: size for name, size in inputs.items() if size}
    return Kernel(key, tuple(given.values()), (output,), lambda *packed: [build(dict(zip(given, packed, strict=True)))])


@dataclass(frozen=True)
class BeamKernels:
    """The kernels of one structure; ``fibre``: empty where stresses are not known, ``ring`` or ``corner``."""

    shape: StrainShape
    fibre: str

    @property
    def key(self) -> str:
        """The structure in words; stations and the form of the stiffness do not matter here."""
        return f"line {replace(self.shape, stations=(), full=False).key}"

    @property
    def interval(self) -> dict[str, int]:
        """Tables of one step along the link."""
        shape = self.shape
        return {"alpha": shape.turning, "beta": shape.turning if shape.planar is None else 0, "rest": 3 * shape.curved}

    @property
    def row(self) -> dict[str, int]:
        """Tables of one place, as in :func:`tmodes.kinds.links.strain_places.place_tables`."""
        shape, g = self.shape, self.shape.points
        return self.interval | {
            "reach": g, "outboard": g, "levers": g * (g + 1) // 2, "turning": shape.rotary * g,
            "functions": shape.size, "stiffness": len(shape.stiffness_sizes),
            "stress": STRESS_NUMBERS if self.fibre else 0,
        }  # fmt: skip

    @property
    def pushes(self) -> dict[str, int]:
        """What the points give to the places.

        ``lines``: derivative of the position by x; ``push``: less the acceleration; ``pairs``: levers times pushes of
        two points, both ways; ``spins``: what a unit of section inertia about each axis asks of the section.
        """
        g = self.shape.points
        return {"lines": 3 * g, "push": 3 * g, "pairs": 3 * g * (g + 1) // 2, "spins": 3 * g * self.shape.rotary}

    def step(self) -> Kernel:
        """(tables of the step, section, coordinates, rates, accelerations) -> the next section."""
        n = self.shape.turning
        inputs = self.interval | {"rotation": 9, "rate": 3, "turning": 3, "q": n, "v": n, "a": n}
        return _kernel(f"{self.key} step", inputs, STATE, self._step)

    def _step(self, given: Blocks) -> list[Any]:
        rotation, rate, turning = v.tri(given["rotation"]), v.vec(given["rate"]), v.vec(given["turning"])
        if not self.shape.turning:
            return v.flat(self._turned(given, rotation), rate, turning)
        (a, b), (ad, bd), (add, bdd) = (self._sums(given, given[name]) for name in "qva")
        if self.shape.planar is not None:
            gained = v.add(v.cross(rate, ad), add)
            return v.flat(self._turned(given, rotation), v.add(rate, ad), v.add(turning, gained))
        a = self._with_rest(given, a)
        speed = v.add(ad, v.cross(ad, b), v.cross(a, bd))
        gain = v.add(add, v.cross(add, b), v.cross(a, bdd), v.scale(2, v.cross(ad, bd)))
        state = magnus_turn(rotation, rate, turning, v.add(a, v.cross(a, b)), speed, gain)
        return v.flat(state.rotation, state.rate, state.bias)

    def _sums(self, given: Blocks, values: Any) -> tuple[v.Vector, v.Vector]:
        alpha = curvature_sums(self.shape, given["alpha"], values)
        return alpha, curvature_sums(self.shape, given["beta"], values) if "beta" in given else v.zero()

    def _with_rest(self, given: Blocks, a: v.Vector) -> v.Vector:
        return v.add(a, v.vec(given["rest"])) if "rest" in given else a

    def _turned(self, given: Blocks, rotation: v.Matrix) -> v.Matrix:
        """Axes after a step."""
        a, b = self._sums(given, given["q"]) if self.shape.turning else (v.zero(), v.zero())
        if self.shape.planar is not None:
            axis = self.shape.planar
            return v.matmul(rotation, v.about(axis, cos(a[axis]), sin(a[axis])))
        a = self._with_rest(given, a)
        return magnus_turn(rotation, v.zero(), v.zero(), v.add(a, v.cross(a, b)), v.zero(), v.zero()).rotation

    def points(self) -> Kernel:
        """(tables, sections at the Gauss points, coordinates, acceleration of the root) -> what they push."""
        g, n = self.shape.points, self.shape.size
        inputs = {"to_points": g * g, "shifts": g * self.shape.shifting} | {f"state{k}": STATE for k in range(g)}
        inputs |= {"q": n, "v": n, "a": n, "acceleration": FORCE}
        return _kernel(f"{self.key} points", inputs, sum(self.pushes.values()), self._points)

    def _points(self, given: Blocks) -> list[Any]:
        g, root = self.shape.points, Force.of(given["acceleration"]).linear
        both = [self._tangent(given, k) for k in range(g)]
        lines, moved = ([pair[k] for pair in both] for k in range(2))
        weights = [[given["to_points"][g * k + j] for j in range(g)] for k in range(g)]
        places = [_weighted(row, lines) for row in weights]
        pushes = [v.scale(-1.0, v.add(root, _weighted(row, moved))) for row in weights]
        pairs = [v.cross(places[j], pushes[k]) if j == k else
                 v.add(v.cross(places[j], pushes[k]), v.cross(places[k], pushes[j]))
                 for j in range(g) for k in range(j, g)]  # fmt: skip
        spins = [self._spin(given[f"state{k}"], axis) for axis in range(self.shape.rotary) for k in range(g)]
        return v.flat(lines, pushes, pairs, spins)

    def _tangent(self, given: Blocks, k: int) -> tuple[v.Vector, v.Vector]:
        """Derivative of the position by x at a point, and its second derivative by time."""
        state, shape = given[f"state{k}"], self.shape
        rotation, rate, turning = v.tri(state), v.vec(state, 9), v.vec(state, 12)
        functions = [given["shifts"][k * shape.shifting + j] for j in range(shape.shifting)]
        line, extra = shifted_line(shape, functions, rotation, given.get("q")), v.zero()
        if shape.shifting:
            speeds, gains = (shifted(shape, functions, rotation, given[name]) for name in "va")
            extra = v.add(*(v.scale(2 * speed, v.cross(rate, axis)) for speed, axis in speeds),
                          *(v.scale(gain, axis) for gain, axis in gains))  # fmt: skip
        return line, v.add(v.cross(turning, line), v.cross(rate, v.cross(rate, line)), extra)

    def _spin(self, state: Any, axis: int) -> v.Vector:
        d, rate = [state[3 * i + axis] for i in range(3)], v.vec(state, 9)
        return v.add(v.scale(v.dot(d, v.vec(state, 12)), d), v.scale(v.dot(d, rate), v.cross(rate, d)))

    def place(self) -> Kernel:
        """(tables, [damping time, curvature at rest], axes before, q, qd, pushes, pose, force outboard) -> a place."""
        inputs = {
            "row": sum(self.row.values()), "own": 4, "rotation": 9, "q": self.shape.size, "v": self.shape.size,
            "pushes": sum(self.pushes.values()), "pose": POSE, "outer": FORCE,
        }  # fmt: skip
        size = sum(PLACE.values()) + bool(self.fibre) * sum(STRESS.values())
        return _kernel(f"{self.key} place {self.fibre}", inputs, size, self._place)

    def _place(self, given: Blocks) -> list[Any]:
        row, pushes = _parts(given["row"], self.row), _parts(given["pushes"], self.pushes)
        rotation = self._turned({**row, "q": given["q"]}, v.tri(given["rotation"]))
        position, outer = _weighted(row["reach"], _vectors(pushes["lines"])), Force.of(given["outer"])
        force = v.sub(_weighted(row["outboard"], _vectors(pushes["push"])), outer.linear)
        levers = [*row["levers"], *(-x for x in row.get("turning", []))]
        moment = _weighted(levers, _vectors([*pushes["pairs"], *pushes.get("spins", [])]))
        moment = v.sub(moment, v.add(outer.angular, v.cross(position, force)))
        shape = self._shape(row, given, rotation)
        stressed = Stressed(row["stress"], self.fibre == "ring") if self.fibre else None
        return packed_place(given["pose"], rotation, position, *in_section(rotation, moment, force), shape, stressed)

    def _shape(self, row: Blocks, given: Blocks, rotation: v.Matrix) -> Shape:
        shape, own, functions = self.shape, given["own"], row["functions"]
        bent, speed = (curvature_sums(shape, functions, given[name]) for name in "qv")
        stretch = range(shape.turning, shape.turning + shape.stretch)
        longer, growing = (v.total([0.0, *(functions[j] * given[name][j] for j in stretch)]) for name in "qv")
        sheared = shape.shear_y or shape.shear_z
        own_shifts = [functions[j] for j in range(shape.turning, shape.size)]
        tangent = shifted_line(shape, own_shifts, rotation, given["q"]) if sheared else [line[0] for line in rotation]
        counts = (shape.twist, shape.bend_y, shape.bend_z, shape.stretch)
        left = iter(row["stiffness"])
        stiffness = [next(left) if count else 0.0 for count in counts]
        answers = [k * (x + own[0] * rate) for k, x, rate in zip(
            stiffness, [*bent, longer], [*speed, growing], strict=True)]  # fmt: skip
        total = v.add(bent, [own[1], own[2], own[3]])
        slope = [atan2(tangent[k], tangent[0]) for k in (1, 2)]
        return Shape(slope, total[1:], total[0], longer, answers[:3], answers[3])


def _parts(packed: Any, sizes: Mapping[str, int]) -> dict[str, list[Any]]:
    """Parts of a block by name, without those that have no numbers."""
    parts, start = {}, 0
    for name, size in sizes.items():
        if size:
            parts[name] = [packed[start + k] for k in range(size)]
        start += size
    return parts


def _vectors(numbers: list[Any]) -> list[v.Vector]:
    return [numbers[k : k + 3] for k in range(0, len(numbers), 3)]


def _weighted(weights: Any, vectors: list[v.Vector]) -> v.Vector:
    return v.add(*(v.scale(weights[k], vector) for k, vector in enumerate(vectors)))
