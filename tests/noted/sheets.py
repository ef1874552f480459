"""A sheet with each registered kind of link, section, joint, drive, controller, contact, surface and signal."""

from __future__ import annotations

from typing import Any

Sheet = dict[str, Any]

BODY = {"name": "load", "mass": 0.4, "center": [0.02, 0.01, 0.03],
        "inertia": {"xx": 2e-3, "yy": 3e-3, "zz": 2.5e-3, "xy": 1e-4, "xz": -2e-4, "yz": 1e-4}}  # fmt: skip
STEEL = {"young": 2.1e11, "shear": 8.1e10, "density": 7850.0}
GIVEN = {"bending_stiffness": [40.0, 60.0], "torsional_stiffness": 30.0, "axial_stiffness": 1e6,
         "shear_stiffness": [1e5, 2e5], "mass_per_length": 0.5, "polar_inertia_per_length": 5e-4}  # fmt: skip
TUBE = {"shape": "tube", "outer_diameter": 0.03, "thickness": 0.002}
PD = {"type": "pd", "position_gain": 80.0, "velocity_gain": 8.0}
MOVE = {"type": "quintic", "start": 0.1, "end": 0.5, "duration": 0.3, "delay": 0.05}


def strain(section: Sheet, **more: Any) -> Sheet:
    """A strain beam."""
    drawn = {} if "mass_per_length" in section else {"material": STEEL}
    return {"model": "strain", "functions": {"bend_y": 2, "bend_z": 1}, "length": 0.7, "damping_time": 1e-3,
            "section": section} | drawn | more  # fmt: skip


BEAMS: dict[str, Sheet] = {
    "given": strain(GIVEN, functions={"twist": 1, "bend_y": 2, "bend_z": 2, "stretch": 1, "shear_y": 1, "shear_z": 1}),
    "tube": strain(TUBE, functions={"twist": 1, "bend_y": 2, "bend_z": 1}),
    "round": strain({"shape": "round", "diameter": 0.02}),
    "box": strain({"shape": "box", "width": 0.02, "height": 0.03}),
    "hollow": strain({"shape": "box", "width": 0.02, "height": 0.03, "flange_thickness": 2e-3, "web_thickness": 1e-3}),
    "i_beam": strain({"shape": "i_beam", "width": 0.03, "height": 0.04, "flange_thickness": 3e-3,
                      "web_thickness": 2e-3}),
    "taper": strain(TUBE, taper={"section": TUBE | {"outer_diameter": 0.02, "thickness": 1.5e-3}}),
    "pieces": {"model": "strain", "functions": 2, "length": 0.7, "damping_time": 1e-3, "material": STEEL,
               "pieces": [{"end": 0.3, "section": TUBE}, {"end": 0.7, "section": TUBE | {"outer_diameter": 0.02}}]},
    "curved": strain(GIVEN, rest_curvature=[0.1, 0.3, -0.2], root_mount={"position": [0.0, 0.0, 0.05],
                                                                         "rpy": [0.1, 0.2, 0.3]}),
    "tip_weighted": strain(GIVEN, basis="tip_weighted", rotary_inertia="full", points=5),
    "segments": {"model": "segments", "segments": 2, "length": 0.7, "damping_time": 1e-3, "section": GIVEN},
    "rigid": {"model": "rigid", "length": 0.7, "section": GIVEN, "tip_mount": {"position": [0.1, 0.0, 0.0]}},
    "modes": {"model": "modes", "modes": [
        {"length": 0.3, "bending_stiffness": 40.0, "mass_per_length": 0.5, "damping_time": 1e-3},
        {"length": 0.4, "bending_stiffness": 30.0, "mass_per_length": 0.4, "damping_time": 2e-3}]},
}  # fmt: skip
JOINTS: dict[str, Sheet] = {
    "revolute": {"type": "revolute", "axis": [0.2, 1.0, -0.3], "origin": {"position": [0.1, 0.2, 0.3],
                                                                       "rpy": [0.2, 0.1, -0.4]}},
    "prismatic": {"type": "prismatic", "axis": [0.2, 1.0, -0.3], "friction": {
        "viscous": 0.2, "normal_force": 10.0, "coefficient": 0.1, "static_coefficient": 0.2}},
    "universal": {"type": "universal", "state": "free", "spring": {"stiffness": 20.0, "rest": 0.1, "damping": 0.3}},
    "elastic": {"type": "revolute", "axis": [0, 1, 0], "motor": {
        "inertia": 1e-4, "side": "motor", "ratio": 60.0, "resistance": 1.5, "back_emf_constant": 0.05,
        "torque_constant": 0.06, "inductance": 1e-3,
        "friction": {"viscous": 1e-5, "coulomb": 1e-3, "static_extra": 5e-4, "stribeck_rate": 3.0}},
        "gear": {"stiffness": [300.0, 500.0], "torque_limits": [8.0], "damping": 0.3, "backlash": 1e-3},
        "friction": {"viscous": 0.1, "coulomb": 0.2, "smoothing": 0.01}},
    "locked": {"type": "revolute", "axis": [0, 1, 0], "state": "locked", "locked_at": 0.3},
    "dh": {"type": "revolute", "dh": {"convention": "standard", "a": 0.2, "alpha": 0.3, "d": 0.1, "theta": 0.4}},
    "quaternion": {"type": "revolute", "axis": [0, 0, 1], "origin": {"position": [0.1, 0.2, 0.3],
                                                                     "quaternion": [0.5, 0.5, 0.5, 0.5]}},
}  # fmt: skip
SIGNALS: dict[str, Sheet] = {
    "constant": {"type": "constant", "value": 0.3},
    "step": {"type": "step", "start": 0.0, "end": 0.2, "time": 0.1},
    "trapezoid": {"type": "trapezoid", "start": 0.1, "end": 0.4, "duration": 0.3, "ramp_fraction": 0.2},
    "ramp": {"type": "trapezoid", "start": 0.1, "end": 0.4, "speed": 1.5, "acceleration": 20.0, "delay": 0.02},
    "quintic": MOVE,
    "sine": {"type": "sine", "amplitude": 0.2, "frequency": 3.0, "phase": 0.3, "offset": 0.1},
    "linear": {"type": "table", "times": [0.05, 0.2, 0.4], "values": [0.1, 0.3, 0.2], "interpolation": "linear"},
    "cubic": {"type": "table", "times": [0.05, 0.2, 0.4], "values": [0.1, 0.3, 0.2], "interpolation": "cubic"},
    "noise": {"type": "noise", "deviation": 0.01, "frequency": 30.0, "seed": 3, "mean": 0.1},
    "sum": {"type": "sum", "signals": [MOVE, {"type": "sine", "amplitude": 0.02, "frequency": 3.0}]},
    "ends": MOVE | {"start_rate": 0.3, "end_rate": -0.2, "start_acceleration": 1.0, "end_acceleration": 2.0},
    "septic": MOVE | {"type": "septic", "start_rate": 0.3, "end_rate": -0.2, "start_acceleration": 1.0,
                      "end_acceleration": 2.0, "start_jerk": 3.0, "end_jerk": -5.0},
    "sine_squared": MOVE | {"type": "sine_squared"},
    "brake": {"type": "brake", "torque": 0.2, "engaged_until": 0.1, "engage_at": 0.3, "release_delay": 0.05},
    "polynomial": MOVE | {"type": "polynomial", "smooth": 4},
    "s_curve": {"type": "s_curve", "start": 0.1, "end": 0.4, "speed": 1.5, "acceleration": 20.0, "jerk": 500.0},
    "trajectory": {"type": "trajectory", "times": [0.02, 0.2, 0.4], "positions": [0.1, 0.3, 0.2],
                   "velocities": [0.2, 0.5, 0.4], "accelerations": [0.3, 1.0, -2.0]},
    "short s_curve": {"type": "s_curve", "start": 0.4, "end": 0.1, "speed": 5.0, "acceleration": 60.0, "jerk": 500.0},
    "late sine": {"type": "sine", "amplitude": 0.2, "frequency": 3.0, "delay": 0.13},
    **{f"shaped {name}": {"type": "shaped", "signal": {"type": "trapezoid", "start": 0.1, "end": 0.4, "speed": 3.0,
                                                      "acceleration": 40.0, "delay": 0.03},
                          "shaper": {"type": name, "frequencies": [6.1, 17.3][:count], "damping": [0.03, 0.1][:count]}}
       for name, count in {"zv": 2, "zvd": 1, "zvdd": 1, "ei": 1}.items()},
}  # fmt: skip
CONTROLLERS: dict[str, Sheet] = {
    "pd": PD,
    "pid": {"type": "pid", "position_gain": 80.0, "velocity_gain": 8.0, "integral_gain": 20.0},
    "sampled_pid": {"type": "sampled_pid", "position_gain": 80.0, "velocity_gain": 8.0, "integral_gain": 20.0,
                    "sample_time": 0.01},
    "state_feedback": {"type": "state_feedback", "position_gains": {"first": 80.0, "link.bend_y1": 3.0},
                       "velocity_gains": {"first": 8.0}, "rest": {"link.bend_y1": 0.1}, "feedforward": 0.5},
}  # fmt: skip
BLOCKS: dict[str, Sheet] = {
    "gravity_pd": {"type": "gravity_pd", "position_gain": 80.0, "velocity_gain": 8.0},
    "computed_torque": {"type": "computed_torque", "position_gain": 400.0, "velocity_gain": 40.0},
    "feedback_linearisation": {"type": "feedback_linearisation", "pole": 10.0},
    "passivity_based": {"type": "passivity_based", "damping": 5.0, "position_gain": 100.0, "velocity_gain": 20.0},
    "singular_perturbation": {"type": "singular_perturbation", "position_gain": 100.0, "velocity_gain": 20.0},
    "impedance": {"type": "impedance", "stiffness": [900.0, 800.0, 700.0], "damping": [50.0, 60.0, 70.0]},
    "force": {"type": "force", "stiffness": [900.0, 800.0, 700.0], "damping": [50.0, 60.0, 70.0], "force": 5.0,
              "direction": [0.1, 0.9, -0.4], "integral_gain": 3.0, "input": "tip.x", "sample_time": 0.01},
    "lqr": {"type": "lqr", "state_weights": {"first": 100.0, "second": 100.0}},
    "pole_placement": {"type": "pole_placement", "poles": [[2.0, 0.7], [3.0, 0.7]]},
    "lqg": {"type": "lqg", "sample_time": 0.01, "state_weights": {"first": 100.0, "second": 100.0},
            "measured": ["first.position", "second.position"], "measurement_noise": [1e-6],
            "process_noise": {"first'": 1e-4, "second'": 1e-4}},
    "loop_shaping": {"type": "loop_shaping", "sample_time": 0.01, "gains": {"first": 10.0, "second": 10.0},
                     "measured": ["first.position", "second.position"], "integral_frequency": 0.5},
    "notch": {"type": "notch", "input": "raw", "frequency": 9.0, "damping": 0.3, "depth": 0.1, "sample_time": 0.01},
    "low_pass": {"type": "low_pass", "input": "raw", "frequency": 40.0, "damping": 0.7},
    "disturbance_observer": {"type": "disturbance_observer", "input": "raw", "bandwidth": 9.0, "sample_time": 0.01},
    "lead_lag": {"type": "lead_lag", "input": "raw", "frequency": 9.0, "ratio": 3.0, "sample_time": 0.01},
    "feed_forward": {"type": "feed_forward", "inputs": ["raw", "raw2"], "signals": [MOVE, SIGNALS["septic"]]},
}  # fmt: skip
"""Blocks that stand in the section `control`: of two drives, or (gravity_pd, filters) of one each."""
SAMPLED = {"sample_time": 0.01, "delay": 0.004, "noise": 1e-3, "seed": 3, "bias": 1e-3}
SENSORS: list[Sheet] = [
    {"type": "encoder", "name": "teeth", "joint": "first", "resolution": 1e-3} | SAMPLED,
    {"type": "accelerometer", "name": "felt"} | SAMPLED,
    {"type": "gyro", "name": "turns"},
    {"type": "strain_gauge", "name": "gauge", "link": "link", "at": 0.1, "z": 0.01},
    {"type": "flange", "name": "wrist", "link": "link", "at": 0.5} | SAMPLED,
    {"type": "output", "name": "seen", "output": "tip.x"},
]
PLANE = {"type": "plane", "position": [0.0, 0.0, -0.3], "normal": [0.1, 0.0, 1.0]}
CONTACTS: dict[str, Sheet] = {
    "unilateral": {"law": "unilateral", "shape": PLANE, "stiffness": 3e3, "damping": 20.0, "friction": 0.2,
                   "static_friction": 0.3, "velocity": [0.1, 0.0, 0.0]},
    "bilateral": {"law": "bilateral", "shape": {"type": "wall", "distance": 0.8, "heading": 0.3}, "stiffness": 3e3,
                  "damping": 20.0, "preload": 2.0, "mass": 0.1, "friction": 0.2, "friction_velocity": 0.01},
    "environment": {"law": "dynamic_environment", "shape": {"type": "ball", "center": [0.1, 0.2, 0.3], "radius": 0.9},
                    "mass": 0.1, "damping": 20.0, "preload": 2.0, "stiffness": 3e3, "friction": 0.2,
                    "friction_velocity": 0.01},
}  # fmt: skip


def sheet(
    *, joint: Sheet = JOINTS["revolute"], beam: Sheet | None = None, signal: Sheet = MOVE, controller: Sheet = PD,
    contact: Sheet | None = None, **more: Any,
) -> Sheet:  # fmt: skip
    """Two joints: the first of a kind, with a link that carries bodies; the second with a rigid link."""
    bodies = [BODY | ({"at": 1.0} if beam else {})]
    drives = [
        {"joint": "second", "command": "effort", "signal": {"type": "step", "start": 0.0, "end": 1.0, "time": 0.1}}
    ]
    if joint.get("state", "active") == "active":
        drives.append({"joint": "first", "command": "position", "signal": signal, "controller": controller})
    return {
        "format": 1, "kind": "arm", "name": "kinds", "gravity": [0.3, -0.2, -9.8],
        "base": {"position": [0.1, 0.2, 0.3], "rpy": [0.1, -0.2, 0.3]},
        "joints": [{"name": "first", "parent": "base", "child": "link"} | joint,
                   {"name": "second", "type": "revolute", "child": "end", "axis": [0, 0, 1],
                    "friction": {"viscous": 0.1}}],
        "links": [{"name": "link", "bodies": bodies} | ({"beam": beam} if beam else {}),
                  {"name": "end", "bodies": [BODY]}],
        "tip": {"link": "end", "position": [0.2, 0.1, 0.05]}, "drives": drives,
        "loads": [{"point": "tip", "frame": "section", "force": [1.0, 2.0, 3.0], "moment": [0.1, 0.2, 0.3]}],
        "initial": {"state": "zero", "coordinates": {"second": 0.2}, "rates": {"second": 0.3}},
        "integration": {"duration": 0.5, "output_step": 0.05},
        **({"contact": contact} if contact else {}), **more,
    }  # fmt: skip


def controlled(block: Sheet) -> Sheet:
    """Both joints under the block; behind elastic gears where it needs them."""
    gear = {"motor": {"inertia": 0.05, "side": "joint"}, "gear": {"stiffness": 300.0, "damping": 0.3}}
    winds = block["type"] in {"feedback_linearisation", "passivity_based"}
    made = sheet(joint=JOINTS["revolute"] | (gear if winds else {}))
    made["joints"][1] |= gear if winds else {}
    both = [{"joint": one, "command": "position", "signal": MOVE} for one in ("first", "second")]
    groups = [["first"], ["second"]] if block["type"] == "gravity_pd" or "input" in block else [["first", "second"]]
    control = [{"name": f"law{k}", "drives": group, "block": block} for k, group in enumerate(groups)]
    control += [{"name": "raw", "of": "first", "block": PD}] if {"input", "inputs"} & {*block} else []
    control += [{"name": "raw2", "of": "second", "block": PD}] if "inputs" in block else []
    return made | {"drives": both, "control": control}


KINDS: dict[str, Sheet] = {
    **{f"beam {name}": sheet(beam=beam) for name, beam in BEAMS.items()},
    **{f"joint {name}": sheet(joint=joint) for name, joint in JOINTS.items()},
    **{f"signal {name}": sheet(signal=signal) for name, signal in SIGNALS.items()},
    **{f"controller {name}": sheet(controller=one, beam=BEAMS["given"]) for name, one in CONTROLLERS.items()},
    **{f"controller {name}": controlled(one) for name, one in BLOCKS.items()},
    **{f"contact {name}": sheet(contact=contact) for name, contact in CONTACTS.items()},
    "sensors": sheet(beam=BEAMS["given"], sensors=SENSORS),
    "body inside": sheet(beam=strain(TUBE)) | {"links": [
        {"name": "link", "beam": strain(TUBE), "bodies": [BODY | {"at": 0.4}, BODY | {"name": "end", "at": 1.0}]},
        {"name": "end", "bodies": [BODY]}]},
    "base motion": sheet(base_motion={"x": SIGNALS["sine"], "yaw": MOVE}),
    "couplings": sheet(joint=JOINTS["elastic"]) | {"couplings": {"first": {"first": 0.9}}},
}  # fmt: skip
