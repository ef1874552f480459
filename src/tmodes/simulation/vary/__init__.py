"""Vary numbers of a data sheet: many robots run at once, each of them checked like a sheet."""
