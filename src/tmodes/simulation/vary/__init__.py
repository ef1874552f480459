"""Vary numbers of a data sheet: many robots or arms run at once, each of them checked like a sheet."""
