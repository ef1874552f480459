"""Tracing by operator overloading: numbers that note what is done with them, and straight-line programs.

A function of plain Python and NumPy runs once on numbers that have a value and stand for a node of a tape. Branches are
decided at the value and noted as guards: the program is right for all values for which its guards hold.
"""
