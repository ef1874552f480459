"""H-infinity loop shaping: its norms against frequency sweeps and Hankel norms, its run against matrix exponentials."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.linalg import expm, solve_continuous_are, solve_discrete_are, solve_discrete_lyapunov
from scipy.signal import tf2ss

import tmodes
from contracts.test_blocks import LINK, SHAPED, constant, law, matrices, spong
from tmodes.errors import InputError, InputErrors
from tmodes.kinds.controllers.loop_shaping import LoopShaping, robust, tustin, unsampled
from tmodes.simulation.design import linear_plant

System = tuple[Any, Any, Any, Any]


def response(system: System, points: NDArray[np.complex128]) -> NDArray[np.complex128]:
    A, B, C, D = system
    return np.array([C @ np.linalg.solve(point * np.eye(len(A)) - A, B) + D for point in points])


def norm(G: NDArray[np.complex128], K: NDArray[np.complex128]) -> float:
    """Largest singular value of [K; I] (I - G K)^-1 [I, G] over all points."""
    ones = np.eye(G.shape[1])
    sizes = [
        np.linalg.norm(np.vstack([k, ones]) @ np.linalg.solve(ones - g @ k, np.hstack([ones, g])), 2)
        for g, k in zip(G, K, strict=True)
    ]
    return float(max(sizes))


def closed(plant: System, K: System) -> NDArray[np.float64]:
    """State matrix of plant and law under positive feedback."""
    (A, B, C, D), (AK, BK, CK, DK) = plant, K
    inner = np.linalg.inv(np.eye(len(DK)) - DK @ D)
    top = np.hstack([A + B @ inner @ DK @ C, B @ inner @ CK])
    low = np.hstack([BK @ (C + D @ inner @ DK @ C), AK + BK @ D @ inner @ CK])
    return np.vstack([top, low])


def drawn(seed: int, *, sampled: bool) -> System:
    """A plant of two inputs and three outputs; unstable in half of the cases."""
    dice = np.random.default_rng(seed)
    A = dice.standard_normal((5, 5)) * (0.5 if sampled else 1.0)
    D = np.zeros((3, 2)) if sampled else 0.3 * dice.standard_normal((3, 2))
    return A, dice.standard_normal((5, 2)), dice.standard_normal((3, 5)), D


@pytest.mark.parametrize("seed", range(6))
def test_a_law_keeps_the_norm_it_promises(seed: int) -> None:
    """At most gamma at all frequencies, almost the least gamma where that is asked for; the loop is stable."""
    plant = drawn(seed, sampled=False)
    points = 1j * np.append(np.geomspace(1e-3, 1e3, 3000), 0.0)
    for factor, share in ((1.3, 0.75), (1.0001, 0.999)):
        K, least = robust(plant, factor)
        assert np.linalg.eigvals(closed(plant, K)).real.max() < 0
        size = norm(response(plant, points), response(K, points))
        assert share * factor * least < size < factor * least * (1 + 1e-9)
        assert size > least * (1 - 1e-3)  # no law is better


@pytest.mark.parametrize("seed", range(6))
def test_least_norm_of_sampled_plants_is_that_of_their_coprime_factors(seed: int) -> None:
    """gamma = (1 - |[N, M]|_H^2)^-1/2, Hankel norm of the normalised left factors, by Riccati equations in z."""
    A, B, C, _ = plant = drawn(seed, sampled=True)
    Z = solve_discrete_are(A.T, C.T, B @ B.T, np.eye(3))
    scale = np.eye(3) + C @ Z @ C.T
    H = A @ Z @ C.T @ np.linalg.inv(scale)
    observed = solve_discrete_lyapunov((A - H @ C).T, C.T @ np.linalg.solve(scale, C))
    hankel = np.abs(np.linalg.eigvals(Z @ observed)).max()
    K, least = robust(unsampled(plant, 0.01), 1.05)
    assert least == pytest.approx(1 / np.sqrt(1 - hankel), rel=1e-9)
    found = tustin(K, 0.01)
    assert np.abs(np.linalg.eigvals(closed(plant, found))).max() < 1
    points = np.exp(1j * np.linspace(0, np.pi, 3000))
    size = norm(response(plant, points), response(found, points))
    assert least * (1 - 1e-3) < size < 1.05 * least * (1 + 1e-9)


def looped(signal: float, until: float, block: dict[str, Any], delay: float = 0.0, **more: Any) -> tmodes.Robot:
    """The link without weight under the law."""
    return tmodes.Robot.of(
        spong(constant(signal), until, 0.01, LINK | {"g": 0.0}, control=law(block, delay=delay), **more)
    )


def designed(robot: Any, delay: float = 0.0) -> LoopShaping:
    found = robot.control[0].block.designed(partial(linear_plant, robot, delay=delay), ("joint",))
    assert isinstance(found, LoopShaping)
    return found


def test_margin_of_a_textbook_loop_in_closed_form() -> None:
    """G = 1/s: X = Z = 1, gamma = sqrt(2), and the best law is K = -1."""
    plant = np.zeros((1, 1)), np.eye(1), np.eye(1), np.zeros((1, 1))
    K, least = robust(plant, 1.0 + 1e-9)
    assert least == pytest.approx(np.sqrt(2), rel=1e-12)
    assert response(K, np.array([1j]))[0, 0, 0] == pytest.approx(-1, rel=1e-6)


def by_exponentials(n: int, period: float, until: float) -> NDArray[np.float64]:
    """Angles (n + 1, 2) of link and motor; weight, delay of 1.5 periods, design and run without the package."""
    p = LINK | {"g": 0.0}
    (a, b), c, half = matrices(p), np.eye(4)[1:2], period / 2
    step: Any = expm(np.block([[a, b], [np.zeros((1, 5))]]) * half)
    Ah, Bh = step[:4, :4], step[:4, 4:]
    # x, u[k-1], u[k-2]: over the first half of a period acts u[k-2], then u[k-1]
    A = np.block([[Ah @ Ah, Bh, Ah @ Bh], [np.zeros((1, 6))], [np.zeros((1, 4)), np.ones((1, 1)), np.zeros((1, 1))]])
    B, C = np.eye(6)[:, 4:5], np.hstack([c, np.zeros((1, 2))])
    rate, wi, root, wl = 2 / period, 2 * np.pi * 0.3, np.sqrt(5.0), 2 * np.pi * 2.0
    back = np.linalg.inv(np.eye(6) + A)
    Ac, Bc = rate * back @ (A - np.eye(6)), 2 * back @ B / period
    Cc, Dc = 2 * C @ back, -C @ back @ B
    Bc, Cc = Bc * np.sqrt(period), Cc / np.sqrt(period)  # any split of the gain
    # the weight 40 (s + wi)/s 5 (s + wl/root)/(s + wl root), controllable form
    num = 200.0 * np.polymul([1, wi], [1, wl / root])
    den = np.array([1, wl * root, 0.0])
    Aw, Bw = np.array([[-den[1], 0.0], [1.0, 0.0]]), np.array([[1.0], [0.0]])
    Cw, Dw = (num[1:] - num[0] * den[1:])[None], np.array([[num[0]]])
    As = np.block([[Ac, Bc @ Cw], [np.zeros((2, 6)), Aw]])
    Bs, Cs, Ds = np.vstack([Bc @ Dw, Bw]), np.hstack([Cc, Dc @ Cw]), (Dc @ Dw).item()
    s = 1 + Ds**2
    inner = As - Bs @ Cs * Ds / s
    X = solve_continuous_are(inner, Bs, Cs.T @ Cs / s, np.array([[s]]))
    Z = solve_continuous_are(inner.T, Cs.T, Bs @ Bs.T / s, np.array([[s]]))
    gamma2 = 1.1**2 * (1 + np.abs(np.linalg.eigvals(X @ Z)).max())
    F = -(Ds * Cs + Bs.T @ X) / s
    H = gamma2 * np.linalg.inv((1 - gamma2) * np.eye(8) + Z @ X) @ Z @ Cs.T
    K = As + Bs @ F + H @ (Cs + Ds * F), H, Bs.T @ X, np.array([[-Ds]])

    def sampled(system: Any) -> Any:
        """z-transform of Tustin's rule by substitution, states scaled otherwise than those of the package."""
        A, B, C, D = system
        inv = np.linalg.inv(np.eye(len(A)) - A * half)
        return inv @ (np.eye(len(A)) + A * half), inv @ B * period, C @ inv, D + C @ inv @ B * half

    (AK, BK, CK, DK), (AW, BW, CW, DW) = sampled(K), sampled((Aw, Bw, Cw, Dw))
    x, past, xk, xw, found = np.zeros(4), [0.0, 0.0], np.zeros(8), np.zeros(2), [np.zeros(2)]
    for _ in range(n):
        off = x[1:2] - until
        wanted = CK @ xk + DK @ off
        command = (CW @ xw + DW @ wanted).item()
        xk, xw = AK @ xk + BK @ off, AW @ xw + BW @ wanted
        for push in past:
            x = (step @ np.append(x, push))[:4]
        past = [past[1], command]
        found.append(x[:2])
    return np.array(found)


def test_a_sampled_loop_with_delay_is_that_of_matrix_exponentials() -> None:
    """To rounding of the design at each sample of a step: 1.5 periods late, with integral and lead."""
    period, n = 0.01, 200
    exact = {"relative_tolerance": 1e-11, "absolute_tolerance": 1e-12}
    robot = looped(0.4, period * n, SHAPED | {"sample_time": period}, 1.5 * period, integration=exact)
    found = np.asarray(robot.run().data["q"].sel(coordinate=["joint", "joint.motor"]))
    truth = by_exponentials(n, period, 0.4)
    assert np.abs(found - truth).max() < 1e-9
    assert truth[-1] == pytest.approx([0.4, 0.4], abs=0.03)
    assert robot.linearize(closed=True).is_stable


def test_a_lead_among_the_filters_of_the_weight_is_the_lead_of_the_law() -> None:
    """Against the same matrix exponentials, by another order of the states."""
    period, n = 0.01, 100
    exact = {"relative_tolerance": 1e-11, "absolute_tolerance": 1e-12}
    block = {name: value for name, value in SHAPED.items() if not name.startswith("lead")} | {"sample_time": period}
    lead = {"type": "lead_lag", "frequency": 2.0, "ratio": 5.0}
    robot = looped(0.4, period * n, block | {"weight": [lead]}, 1.5 * period, integration=exact)
    found = np.asarray(robot.run().data["q"].sel(coordinate=["joint", "joint.motor"]))
    assert np.abs(found - by_exponentials(n, period, 0.4)).max() < 1e-9


def test_filters_of_the_weight_are_in_the_loop() -> None:
    """Poles of a continuous loop with notch, low-pass and integral: of state matrices by SciPy's transfer functions."""
    w = 2 * np.pi * np.array([8.0, 30.0, 0.3])
    top = np.polymul([1, 2 * 0.3 * 0.2 * w[0], w[0] ** 2], [40.0, 40.0 * w[2]])
    below = np.polymul(np.polymul([1, 2 * 0.3 * w[0], w[0] ** 2], [1 / w[1], 1.0]), [1.0, 0.0])
    AW, BW, CW, DW = tf2ss(top, below)
    (a, b), c = matrices(LINK | {"g": 0.0}), np.eye(4)[1:2]
    n, m = len(AW), 4
    A, B = np.block([[a, b @ CW], [np.zeros((n, m)), AW]]), np.vstack([b @ DW, BW])
    C = np.hstack([c, np.zeros((1, n))])
    X, Z = solve_continuous_are(A, B, C.T @ C, np.eye(1)), solve_continuous_are(A.T, C.T, B @ B.T, np.eye(1))
    gamma2 = 1.1**2 * (1 + np.abs(np.linalg.eigvals(X @ Z)).max())
    H = gamma2 * np.linalg.inv((1 - gamma2) * np.eye(n + m) + Z @ X) @ Z @ C.T
    K = A - B @ B.T @ X + H @ C, H, B.T @ X, np.zeros((1, 1))
    wanted = np.linalg.eigvals(closed((A, B, C, np.zeros((1, 1))), K))
    weight = [
        {"type": "low_pass", "frequency": 30.0},
        {"type": "notch", "frequency": 8.0, "damping": 0.3, "depth": 0.2},
    ]
    block = {name: value for name, value in SHAPED.items() if not name.startswith("lead")} | {"weight": weight}
    found = np.linalg.eigvals(looped(0.0, 0.1, block).linearize(closed=True).A)
    apart = np.abs(found[:, None] - wanted[None])
    assert len(found) == len(wanted)
    assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < 1e-6 * np.abs(wanted).max()


def test_a_limit_holds_the_integral() -> None:
    """A step that asks for more than the drive gives: it overshoots no more than without limit."""
    high = {}
    for name, drive in (("free", {}), ("cut", {"saturation": {"torque": 5.0}})):
        block = SHAPED | {"sample_time": 0.01, "gains": {"joint": 200.0}, "integral_frequency": 1.0}
        run = looped(0.4, 4.0, block, drive=drive).run()
        high[name] = float(run.output("joint.position").max())
        assert float(run.output("joint.position")[-1]) == pytest.approx(0.4, abs=0.02), name
        assert name == "free" or float(np.abs(run.output("joint.effort")).max()) <= 5.0 + 1e-9
    assert high["cut"] < high["free"] + 0.05


def test_what_is_measured_by_acceleration_is_seen_with_the_commands_before() -> None:
    """Motor angle and acceleration: the loop that is designed is the one that runs, and is stable."""
    sheet = SHAPED | {"measured": ["joint.motor.position", "joint.motor.acceleration"], "sample_time": 0.01,
                   "output_weights": {"joint.motor.acceleration": 0.01}}  # fmt: skip
    robot = looped(0.0, 0.1, sheet)
    assert designed(robot).design.plant.D.any()
    loop = robot.linearize(closed=True)
    assert loop.is_stable


def test_a_loop_that_asks_for_too_much_says_so() -> None:
    found = designed(looped(0.0, 0.1, SHAPED | {"sample_time": 0.1, "gains": {"joint": 3e4}}), 0.2)
    assert found.robustness < 0.25
    assert any("bears little" in one for one in found.remarks())
    calm = designed(looped(0.0, 0.1, SHAPED))
    assert calm.robustness == pytest.approx(1 / calm.design.gamma)
    assert not calm.remarks()


@pytest.mark.parametrize(
    ("more", "place"),
    [
        ({"gains": {"elbow": 3.0}}, "control.law.block.gains"),
        ({"lead_ratio": 1.0}, "control.law.block.lead_frequency"),
        ({"output_weights": {"a": 1.0}}, "control.law.block.output_weights"),
        ({"factor": 1.0}, "control.law.block.factor"),
        ({"weight": [{"type": "pd", "position_gain": 1.0}]}, "control.law.block.weight"),
        ({"weight": [{"type": "low_pass", "frequency": 5.0, "sample_time": 0.01}]}, "control.law.block.weight"),
        ({"measured": ["nothing"]}, "control.law.block.measured"),
    ],
)
def test_what_does_not_fit_is_refused(more: dict[str, Any], place: str) -> None:
    with pytest.raises((InputError, InputErrors)) as caught:
        looped(0.0, 0.1, SHAPED | more).run()
    assert place in str(caught.value)


def test_what_the_weighted_loop_bears_is_shown_next_to_its_margins() -> None:
    robot = looped(0.0, 0.1, SHAPED)
    linear = robot.linearize(closed=True)
    assert linear.info()["e_max"] == {"law": pytest.approx(designed(robot).robustness)}
    assert any(isinstance(one, str) and "e_max" in one for one in linear.tables())
    assert robot.linearize().info()["e_max"] == {}
