"""Timings: how fast a robot goes along a path, from what its joints can do."""
