"""What of an MJCF file is read, and what changes no motion of the robot; all else is named (:mod:`.unread`)."""

from __future__ import annotations

from tmodes.io.unread import Format

__all__ = ["MJCF"]

_PLACED = {"pos", "quat", "axisangle", "euler", "xyaxes", "zaxis"}
_ACTUATOR = {
    *("name", "class", "joint", "jointinparent", "gear", "ctrlrange", "ctrllimited", "forcerange", "forcelimited"),
    *("kp", "kv", "dampratio", "gainprm", "biasprm", "gaintype", "biastype", "dyntype", "armature", "damping"),
    *("inheritrange", "group", "user", "tendon", "site", "body", "cranksite", "slidersite", "refsite", "cranklength"),
}
"""Of an actuator; one that is not taken is named by itself."""

_ACTUATORS = (
    *("general", "motor", "position", "velocity", "intvelocity", "damper", "cylinder", "muscle", "adhesion"),
    *("dcmotor", "plugin"),
)
_FLAGS = (
    *("contact", "warmstart", "filterparent", "clampctrl", "refsafe", "sensor", "midphase", "nativeccd", "eulerdamp"),
    *("autoreset", "island", "energy", "fwdinv", "invdiscrete", "multiccd", "sleep", "override"),
)
"""Flags that change how MuJoCo computes, not what."""

_SOFT = "its limits are sharp bounds that a run reports, not springs"
_STICKS = "its dry friction sticks exactly"
_FLUID = "no fluid acts on the robot"

MJCF = Format(
    read={
        "mujoco": {"model"},
        "compiler": {
            *("angle", "autolimits", "coordinate", "eulerseq", "meshdir", "texturedir", "assetdir", "strippath"),
            *("fusestatic", "balanceinertia", "boundmass", "boundinertia", "inertiafromgeom", "inertiagrouprange"),
            *("settotalmass", "alignfree", "fitaabb", "discardvisual", "usethread", "saveinertial", "conflict"),
            *("exactmeshinertia", "convexhull", "local"),
        },
        "compiler/lengthrange": set(),
        "option": {"gravity"},
        "option/flag": {"gravity"},
        "default": {"class"},
        "worldbody": set(),
        "body": {"name", "childclass", "gravcomp", "mocap", *_PLACED},
        "frame": {"name", "childclass", *_PLACED},
        "inertial": {"mass", "diaginertia", "fullinertia", *_PLACED},
        "joint": {
            *("name", "class", "type", "pos", "axis", "range", "limited", "stiffness", "springref", "springdamper"),
            *("damping", "frictionloss", "armature", "ref", "actuatorfrcrange", "actuatorfrclimited"),
        },
        "freejoint": {"name"},
        "include": {"file"},
        "contact": set(),
        "equality": set(),
        "equality/joint": {"name", "class", "active", "joint1", "joint2", "polycoef"},
        "actuator": set(),
        **{f"{parent}/{tag}": _ACTUATOR for tag in _ACTUATORS for parent in ("actuator", "default")},
    },
    idle={
        *("visual", "statistic", "size", "custom", "asset", "sensor", "keyframe", "geom", "site", "camera", "light"),
        *("contact/exclude", "lengthrange", "default/mesh", "default/material", "default/pair", "default/equality"),
        *("default/tendon", "option@timestep", "option@integrator", "option@solver", "option@iterations"),
        *("option@tolerance", "option@ls_iterations", "option@ls_tolerance", "option@noslip_iterations"),
        *("option@noslip_tolerance", "option@ccd_iterations", "option@ccd_tolerance", "option@jacobian"),
        *("option@cone", "option@impratio", "option@sdf_iterations", "option@sdf_initpoints", "option@magnetic"),
        *(
            "option@mpr_iterations",
            "option@mpr_tolerance",
            "option@apirate",
            "option@collision",
            "option@sleep_tolerance",
        ),
        *(f"flag@{name}" for name in _FLAGS),
        *(
            "joint@solref",
            "joint@solimp",
            "joint@group",
            "joint@user",
            "body@user",
            "body@sleep",
            "default/joint@group",
        ),
    },
    owners={"joint", "body", "default", "fixed", "spatial", *_ACTUATORS},
    effects={
        "joint@solreflimit": _SOFT,
        "joint@solimplimit": _SOFT,
        "joint@margin": _SOFT,
        "joint@solreffriction": _STICKS,
        "joint@solimpfriction": _STICKS,
        "joint@actuatorgravcomp": "the compensation of its weight is a load, whatever the joint's actuator could bear",
        "option@density": _FLUID,
        "option@viscosity": _FLUID,
        "option@wind": _FLUID,
        "tendon": "what its tendons pull, and what actuators pull by them, is left out",
        "contact/pair": "nothing touches but what a sheet says under `contact`",
        "flag@actuation": "its actuators are taken",
        "flag@limit": "its limits are taken",
    },
)
"""Geoms are read by MuJoCo for masses and inertias; that they touch nothing is a notice of its own."""
