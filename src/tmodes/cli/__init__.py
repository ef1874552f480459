"""The command line: one file per command; every message says which, got, expected, mend."""
