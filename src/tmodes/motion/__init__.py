"""An arm in motion: what moves it, its native loops, and the numbers of a run."""
