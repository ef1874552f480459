"""Sensors: what is measured of a robot, with resolution, bias, noise, delay and sample rate."""
