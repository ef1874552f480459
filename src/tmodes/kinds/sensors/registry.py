"""The sensors that tmodes brings; ``@SENSORS.register`` adds more."""

from __future__ import annotations

from tmodes.kinds.sensors.contract import NOISE, SENSORS, Port, Sensor

__all__ = ["NOISE", "SENSORS", "Port", "Sensor"]

SENSORS.bring(
    "tmodes.kinds.sensors",
    {
        "encoder": "encoder", "accelerometer": "inertial", "gyro": "inertial", "strain_gauge": "strain_gauge",
        "flange": "flange", "output": "output",
    },
)  # fmt: skip
