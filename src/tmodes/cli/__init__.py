"""The command line: one file per command; every message says which value, what was expected, how to fix it."""
