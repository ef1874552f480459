"""A Python function of the result of each case."""
