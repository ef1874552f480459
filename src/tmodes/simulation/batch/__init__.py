"""Thousands of runs at once: lanes side by side, groups of them over threads, results in memory or on disk."""
