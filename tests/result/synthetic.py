"""A made-up result of the right shape and plausible size: for tests of files, figures and summaries, not of physics.

The example robot's motion given by sines: 0 to 45 degrees in 2 s, angles of the size that it has, ringing at 4.94 Hz
and 20.2 Hz. What can be exact at no cost is exact: sums, the tip, the moments of a linear mode.
The dimension of the deformations is ``deformation_kind`` (as ``energy_kind``, ``work_kind``): xarray lets no variable
of several dimensions, here ``deformation``, bear the name of one of them.
"""

from __future__ import annotations

import json
from typing import Any

import numpy as np

from tmodes.result.record import PaperResult

COORDINATES = ("q", "delta", "gamma", "vt", "e", "theta")
DEFORMATIONS = ("th11q", "th12d", "th11m", "th12e", "xi")
LENGTHS = (0.6, 0.3)
BENDING = (1082.1294435106379 * 0.99, 13.359622759390597 * 0.99)
GEAR = (0.2 * 4700.0, 0.2 * 2.0)
DAMPING_TIME = 2.0e-4
GRAVITY = 9.81

ROBOT: dict[str, Any] = {
    "format": 1,
    "name": "filipovic2010",
    "title": "One motor, elastic gear, flexible link of two modes, tip in contact with a dynamic environment",
    "citation": "M. Filipovic, A. Djuric, doi:10.2298/TAM1001049F; parameter values assumed.",
    "reading": "consistent",
    "contact": True,
    "gravity": GRAVITY,
    "motor": {
        "resistance": 0.299,
        "back_emf_constant": 3.02,
        "torque_constant": 3.02,
        "inertia": 0.175,
        "friction": 0.5,
    },
    "gear": {"stiffness": 4700.0, "damping": 2.0},
    "link": {
        "modes": [
            {
                "length": LENGTHS[0],
                "bending_stiffness": 1082.1294435106379,
                "mass_per_length": 1.9975816887850697,
                "damping_time": DAMPING_TIME,
            },
            {
                "length": LENGTHS[1],
                "bending_stiffness": 13.359622759390597,
                "mass_per_length": 0.2219535209761189,
                "damping_time": DAMPING_TIME,
            },
        ]
    },
    "payload": {"mass": 0.5, "inertia": 2.5e-4},
    "environment": {
        "mass": 0.1,
        "damping": 20.0,
        "preload": 5.0,
        "stiffness": 1000.0,
        "friction": 0.1,
        "friction_velocity": 1.0e-3,
        "friction_law": "signed",
    },
    "controller": {"position_gain": 2000.0, "velocity_gain": 20.0},
    "reference": {
        "start": 0.0,
        "end": np.pi / 4,
        "duration": 2.0,
        "ramp_fraction": 0.2,
        "noise": {"deviation": 0.0, "frequency": 100.0, "seed": 0},
    },
    "real": {
        "gear.stiffness": 0.2,
        "gear.damping": 0.2,
        "link.modes.0.bending_stiffness": 0.99,
        "link.modes.1.bending_stiffness": 0.99,
    },
    "integration": {
        "method": "dormand_prince",
        "duration": 2.0,
        "output_step": 1.0e-3,
        "relative_tolerance": 1.0e-9,
        "absolute_tolerance": 1.0e-12,
        "check_error": False,
        "step": 2 / 37500,
        "line_points": 21,
        "energy_tolerance": 1.0e-6,
        "stop": [],
        "energy_stop": False,
        "max_steps": 200_000_000,
        "max_wall_time": 3600.0,
    },
}


def synthetic_result(contact: bool = True, *, duration: float = 2.0, samples: int = 2001) -> PaperResult:
    """A finished run of the example robot, in contact or in free space; ``duration`` [s], the move always takes 2 s."""
    import xarray as xr

    time = np.linspace(0.0, duration, samples)
    wanted, speed, rate = trapezoid(time)
    angle, angle_reference = deformations(time, rate)
    q, q_reference = coordinates(wanted, angle), coordinates(wanted, angle_reference)
    stationary = np.stack([-1.2e-4 * rate, -1.2e-3 * rate, 0 * time - 1.28e-3, 0 * time - 11.3e-3, -1.7e-3 * rate], -1)
    tip, tip_reference = tip_of(q), tip_of(q_reference)
    series: dict[str, tuple[tuple[str, ...], Any, str, str]] = {
        "q": (("time", "coordinate"), q, "rad", "coordinates of the real robot"),
        "v": (("time", "coordinate"), np.gradient(q, time, axis=0), "rad/s", "rates of the coordinates"),
        "q_reference": (("time", "coordinate"), q_reference, "rad", "coordinates of the reference"),
        "v_reference": (
            ("time", "coordinate"),
            np.gradient(q_reference, time, axis=0),
            "rad/s",
            "rates of the coordinates of the reference",
        ),
        "theta_wanted": (("time",), wanted, "rad", "wanted motor angle"),
        "voltage": (("time",), 3.02 * speed + 0.3 * rate + 0.4 * np.sin(ring(time)), "V", "motor voltage"),
        "current": (("time",), 0.9 * rate + 1.2 * np.sin(ring(time)), "A", "motor current"),
        "tip": (("time", "axis"), tip, "m", "tip of the real robot"),
        "tip_reference": (("time", "axis"), tip_reference, "m", "tip of the reference"),
        "deviation": (("time",), np.linalg.norm(tip - tip_reference, axis=1), "m", "distance of the two tips"),
        "deformation": (("time", "deformation_kind"), angle, "rad", "elastic deformation"),
        "deformation_reference": (
            ("time", "deformation_kind"),
            angle_reference,
            "rad",
            "elastic deformation, reference",
        ),
        "deformation_stationary": (("time", "deformation_kind"), stationary, "rad", "stationary part T_st"),
        "deformation_oscillatory": (("time", "deformation_kind"), angle - stationary, "rad", "oscillatory part T_to"),
        "gear_torque": (("time",), gear_torque(time, angle, GEAR), "N m", "gear torque"),
        "gear_torque_reference": (
            ("time",),
            gear_torque(time, angle_reference, (4700.0, 2.0)),
            "N m",
            "gear torque of the reference",
        ),
        **energies(time, speed, angle, contact),
        **elastic_line(time, angle, q),
    }
    if contact:
        series |= contact_forces(time, tip, np.gradient(tip, time, axis=0))
    data = xr.Dataset(
        {
            name: (dims, values, {"units": unit, "long_name": words})
            for name, (dims, values, unit, words) in series.items()
        },
        coords=labels(time),
        attrs=attributes(contact),
    )
    return PaperResult(data)


def trapezoid(time: Any) -> tuple[Any, Any, Any]:
    """Wanted motor angle [rad], its speed and its acceleration: 0 to pi/4 in 2 s, ramps of 0.4 s."""
    top = np.pi / 4 / 1.6
    rate = np.where(time < 0.4, top / 0.4, np.where((time >= 1.6) & (time < 2.0), -top / 0.4, 0.0))
    speed = np.clip(np.minimum(time / 0.4, (2.0 - time) / 0.4), 0.0, 1.0) * top
    step = np.diff(time, prepend=time[0])
    wanted = np.cumsum((speed + np.concatenate([speed[:1], speed[:-1]])) / 2 * step)
    return wanted, speed, rate


def ring(time: Any, frequency: float = 4.94) -> Any:
    """Phase of a vibration [rad]."""
    return 2 * np.pi * frequency * time


def deformations(time: Any, rate: Any) -> tuple[Any, Any]:
    """The five deformations of the real robot and of the reference [rad], shape (time, 5)."""
    fade = np.exp(-0.25 * time) + 0.8 * np.exp(-2.0 * np.clip(time - 1.6, 0, None)) * (time > 1.6)
    slow = fade * np.sin(ring(time))
    fast = np.exp(-0.6 * time) * np.sin(ring(time, 20.2))
    sag = np.exp(-0.5 * time) * np.sin(ring(time, 7.315))
    real = [
        -1.2e-4 * rate + 1.0e-4 * slow + 4e-6 * fast,
        -1.2e-3 * rate + 1.0e-3 * slow + 7e-5 * fast,
        -1.28e-3 + 2.0e-5 * sag,
        -11.3e-3 + 1.7e-4 * sag,
        -1.7e-3 * rate + 1.4e-3 * slow + 3e-5 * fast,
    ]
    stiff = np.exp(-0.3 * time) * np.sin(ring(time, 6.66))
    nominal = [
        -1.2e-4 * rate + 2.2e-4 * stiff,
        -1.2e-3 * rate + 2.2e-3 * stiff,
        -1.27e-3 + 1.5e-5 * sag,
        -11.2e-3 + 1.3e-4 * sag,
        -4.0e-4 * rate + 6.0e-4 * stiff,
    ]
    return np.stack(real, axis=-1), np.stack(nominal, axis=-1)


def coordinates(wanted: Any, angle: Any) -> Any:
    """q, delta, gamma, vt, e, theta [rad] from the motor's angle and the deformations."""
    gamma = wanted + angle[:, 4]
    q = gamma + angle[:, 0]
    delta = angle[:, 0] / 2 + angle[:, 1]
    return np.stack([q, delta, gamma, angle[:, 2], angle[:, 2] / 2 + angle[:, 3], wanted], axis=-1)


def tip_of(q: Any) -> Any:
    """Tip position [m], shape (time, 3), equation (42)."""
    return point_of(q, 1.0, 1.0)


def point_of(q: Any, along_first: float, along_second: float) -> Any:
    """A point on the chords of the two modes [m], shape (time, 3)."""
    first, second = LENGTHS[0] * along_first, LENGTHS[1] * along_second
    yaw, pitch = q[:, 0] + q[:, 1], q[:, 3] + q[:, 4]
    flat, flat2 = first * np.cos(q[:, 3]), second * np.cos(pitch)
    return np.stack(
        [
            flat * np.cos(q[:, 0]) + flat2 * np.cos(yaw),
            flat * np.sin(q[:, 0]) + flat2 * np.sin(yaw),
            first * np.sin(q[:, 3]) + second * np.sin(pitch),
        ],
        axis=-1,
    )


def gear_torque(time: Any, angle: Any, gear: tuple[float, float]) -> Any:
    """Cxi xi + Bxi xi' [N m]."""
    return gear[0] * angle[:, 4] + gear[1] * np.gradient(angle[:, 4], time)


def contact_forces(time: Any, tip: Any, velocity: Any) -> dict[str, tuple[tuple[str, ...], Any, str, str]]:
    """Radial force of about 4.98 N and friction of a tenth of it across."""
    radial = 4.9825 + 1.2e-3 * np.sin(ring(time)) * np.exp(-0.3 * time)
    outwards = tip / np.linalg.norm(tip, axis=1, keepdims=True)
    rubbing = velocity / np.sqrt((velocity**2).sum(axis=1, keepdims=True) + 1e-6)
    force = radial[:, None] * (outwards + 0.1 * rubbing)
    return {
        "contact_force": (("time", "axis"), force, "N", "force by the tip on the environment"),
        "contact_force_radial": (("time",), radial, "N", "radial contact force"),
        "contact_force_radial_reference": (
            ("time",),
            4.9830 + 1.0e-3 * np.sin(ring(time, 6.66)),
            "N",
            "radial contact force of the reference",
        ),
    }


def energies(time: Any, speed: Any, angle: Any, contact: bool) -> dict[str, tuple[tuple[str, ...], Any, str, str]]:
    """Energies and works whose balance leaves a residual of rounding's size [J]."""
    from scipy.integrate import cumulative_trapezoid

    def total(power: Any) -> Any:
        return cumulative_trapezoid(power, time, initial=0.0)

    kinetic = 0.43 * speed**2
    elastic = 0.5 * sum(
        3 * stiffness / length * angle[:, column] ** 2
        for stiffness, length, pair in zip(BENDING, LENGTHS, ((0, 2), (1, 3)), strict=True)
        for column in pair
    )
    gear = 0.5 * GEAR[0] * angle[:, 4] ** 2
    gravity = GRAVITY * 0.5 * (LENGTHS[0] * angle[:, 2] + LENGTHS[1] * (1.5 * angle[:, 2] + angle[:, 3]))
    energy = np.stack([kinetic, gravity, gear, elastic], axis=-1)
    rates = np.gradient(angle, time, axis=0)
    bending = sum(
        DAMPING_TIME * 3 * stiffness / length * rates[:, column] ** 2
        for stiffness, length, pair in zip(BENDING, LENGTHS, ((0, 2), (1, 3)), strict=True)
        for column in pair
    )
    losses = np.stack(
        [
            total(0.5 * speed**2),
            total(GEAR[1] * rates[:, 4] ** 2),
            total(bending),
            total(0.45 * speed) if contact else np.zeros_like(time),
        ],
        axis=-1,
    )
    residual = 1e-11 * np.sin(ring(time, 3.0))
    brought_in = energy.sum(axis=1) - energy[0].sum() + losses.sum(axis=1) + residual
    return {
        "energy": (("time", "energy_kind"), energy, "J", "energy"),
        "work": (("time", "work_kind"), np.column_stack([brought_in, losses]), "J", "work since the start"),
        "energy_balance": (("time",), residual, "J", "residual of the energy balance"),
    }


def elastic_line(time: Any, angle: Any, q: Any) -> dict[str, tuple[tuple[str, ...], Any, str, str]]:
    """Deflection, slope, moments and shear of each mode's static shape; the line in space along the chords."""
    s = np.linspace(0.0, 1.0, 21)
    th = np.stack([angle[:, [0, 2]], angle[:, [1, 3]]], axis=1)[..., None]
    length = np.array(LENGTHS)[:, None, None]
    bending = np.array(BENDING)[:, None, None]
    rate = np.gradient(th, time, axis=0)
    flexibility = 3 * bending / length * (th + DAMPING_TIME * rate) * (1 - s)
    first = np.stack([point_of(q, x, 0.0) for x in s], axis=1)
    second = np.stack([point_of(q, 1.0, x) for x in s], axis=1)
    dims = ("time", "mode", "plane", "s")
    return {
        "deflection": (dims, length * th * s**2 * (3 - s) / 2, "m", "deflection from the root's tangent"),
        "slope": (dims, th * 1.5 * s * (2 - s), "rad", "slope against the root's tangent"),
        "bending_moment": (dims, -flexibility, "N m", "bending moment from the dynamics"),
        "flexibility_moment": (dims, flexibility, "N m", "moment of the bent line"),
        "shear_force": (dims, flexibility[..., :1] / length * np.ones_like(s), "N", "shear force"),
        "line": (("time", "mode", "s", "axis"), np.stack([first, second], axis=1), "m", "elastic line in space"),
    }


def labels(time: Any) -> dict[str, Any]:
    """The labelled dimensions of a result."""
    return {
        "time": ("time", time, {"units": "s", "long_name": "time"}),
        "coordinate": ("coordinate", list(COORDINATES), {"long_name": "coordinate"}),
        "axis": ("axis", ["x", "y", "z"], {"long_name": "axis in space"}),
        "deformation_kind": ("deformation_kind", list(DEFORMATIONS), {"long_name": "elastic deformation"}),
        "mode": ("mode", ["mode1", "mode2"], {"long_name": "mode of the link"}),
        "plane": ("plane", ["horizontal", "vertical"], {"long_name": "plane of bending"}),
        "s": ("s", np.linspace(0.0, 1.0, 21), {"units": "1", "long_name": "place along a mode over its length"}),
        "energy_kind": (
            "energy_kind",
            ["kinetic", "gravity", "elastic_gear", "elastic_link"],
            {"long_name": "kind of energy"},
        ),
        "work_kind": (
            "work_kind",
            ["motor", "motor_friction", "gear_damping", "link_damping", "contact"],
            {"long_name": "kind of work"},
        ),
    }


def real_robot() -> dict[str, Any]:
    """The data sheet with the factors of the real robot multiplied in."""
    sheet: dict[str, Any] = json.loads(json.dumps(ROBOT))
    for path, factor in sheet.pop("real").items():
        *way, last = path.split(".")
        place: Any = sheet
        for key in way:
            place = place[int(key)] if isinstance(place, list) else place[key]
        place[last] *= factor
    return sheet


def attributes(contact: bool) -> dict[str, Any]:
    """The attributes of a finished run."""
    parameters = {
        "gravity": GRAVITY,
        "gear.stiffness": GEAR[0],
        "gear.damping": GEAR[1],
        "link.modes.0.length": LENGTHS[0],
        "link.modes.0.bending_stiffness": BENDING[0],
        "link.modes.1.length": LENGTHS[1],
        "link.modes.1.bending_stiffness": BENDING[1],
        "payload.mass": 0.5,
    }
    nominal = parameters | {
        "gear.stiffness": 4700.0,
        "gear.damping": 2.0,
        "link.modes.0.bending_stiffness": 1082.1294435106379,
        "link.modes.1.bending_stiffness": 13.359622759390597,
    }

    def lines(pairs: list[tuple[float, float, str]]) -> list[dict[str, Any]]:
        return [{"frequency_Hz": f, "damped_frequency_Hz": f, "damping_ratio": d, "element": e} for f, d, e in pairs]

    elements = ("gear", "mode2 vertical", "mode2 horizontal", "mode1 vertical", "mode1 horizontal")
    dampings = (0.0031, 0.0046, 0.0127, 0.0205, 0.113)
    frequencies = {
        "locked": lines(list(zip((4.9957, 7.3152, 20.259, 32.6164, 179.863), dampings, elements, strict=True))),
        "free": lines(list(zip((7.315, 9.81, 26.4, 32.61, 180.2), dampings, elements, strict=True))),
        "controlled": lines(list(zip((4.938, 7.315, 20.212, 32.61, 178.2), dampings, elements, strict=True))),
    }
    return {
        "tmodes_format": 1,
        "robot": json.dumps(ROBOT | {"contact": contact}),
        "robot_real": json.dumps(real_robot() | {"contact": contact}),
        "mechanism": f"consistent contact={'signed' if contact else 'none'} drive=controlled rigid=none degree=2",
        "reading": "consistent",
        "parameters": json.dumps(parameters),
        "parameters_nominal": json.dumps(nominal),
        "versions": json.dumps({"tmodes": "0.1.0", "python": "3.11.7", "numpy": "2.4.6", "casadi": "3.8.2"}),
        "status": "finished",
        "message": "The run reached its end.",
        "frequencies": json.dumps(frequencies),
        "statistics": json.dumps({"steps": 4321, "rejected": 12, "evaluations": 26000, "dt_omega": 0.52}),
        "warnings": json.dumps([]),
    }
