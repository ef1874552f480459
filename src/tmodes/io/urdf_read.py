"""What of a URDF is read, and what changes no motion of the robot; all else is named (:mod:`.unread`).

Shapes are drawn and touch nothing (contact is what a sheet says), and who commands the joints is said by drives: what
other programs put there for both (ros2_control, sensors, friction of surfaces) is idle.
"""

from __future__ import annotations

from tmodes.io.unread import Format

__all__ = ["URDF", "plain_tag"]

_SURFACES = "mu mu1 mu2 kp kd fdir1 minDepth maxVel maxContacts selfCollide laserRetro material sensor visual collision"
_SOLVERS = (
    "implicitSpringDamper provideFeedback preserveFixedJoint disableFixedJointLumping stopCfm stopErp cfmDamping "
    "fudgeFactor"
)
_ORIGIN = {"xyz", "rpy"}
_SOFT = "no soft limit acts on the joint"
_BOUND = "it bounds nothing"

URDF = Format(
    read={
        "robot": {"name", "version"},
        "link": {"name", "type"},
        "inertial": set(),
        "inertial/mass": {"value"},
        "inertial/inertia": {"ixx", "iyy", "izz", "ixy", "ixz", "iyz"},
        "origin": _ORIGIN,
        "robot/joint": {"name", "type"},
        "joint/parent": {"link"},
        "joint/child": {"link"},
        "joint/axis": {"xyz"},
        "joint/limit": {"lower", "upper", "effort", "velocity"},
        "joint/dynamics": {
            *("damping", "friction", "armature", "rotor_inertia", "gear_ratio", "stiffness", "spring_stiffness"),
            *("spring_reference",),
        },
        "joint/mimic": {"joint", "multiplier", "offset"},
        "joint/rotor_inertia": {"value"},
        "joint/gear_ratio": {"value"},
        "transmission": {"name", "type"},
        "transmission/type": set(),
        "transmission/joint": {"name"},
        "transmission/actuator": {"name"},
        "transmission/mechanicalReduction": {"value"},
        **{
            f"actuator/{tag}": {"value"}
            for tag in ("mechanicalReduction", "gear_ratio", "rotor_inertia", "drake:gear_ratio", "drake:rotor_inertia")
        },
        "gazebo": {"reference"},
        "gazebo/springStiffness": {"value"},
        "gazebo/springReference": {"value"},
    },
    idle={
        *("visual", "collision", "material", "robot/sensor", "ros2_control", "calibration", "hardwareInterface"),
        *("self_collision_checking", "mujoco", "link@id", "joint@id", "robot@xmlns", "transmission/role"),
        *(f"gazebo/{tag}" for tag in f"{_SURFACES} {_SOLVERS}".split()),
    },
    owners={"link", "joint", "transmission", "gazebo", "plugin"},
    effects={
        "joint/safety_controller": _SOFT,
        "gazebo/stopKp": _SOFT,
        "gazebo/stopKd": _SOFT,
        "limit@acceleration": _BOUND,
        "limit@deceleration": _BOUND,
        "limit@jerk": _BOUND,
        "gazebo/plugin": "what a plugin of Gazebo does to the robot is left out",
        "gazebo/turnGravityOff": "gravity acts on the link",
        "gazebo/gravity": "gravity acts on the link as on all others",
        "gazebo/dampingFactor": "nothing but joints, gears and links damps",
    },
)
"""Namespaces that elements declare are idle by the prefix of the attribute, see :meth:`.unread.Format.left`."""


def plain_tag(tag: str) -> str:
    """A tag without its prefix."""
    return tag.rpartition(":")[2]
