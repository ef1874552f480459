"""How fast this engine is on the machine at hand, next to a C compiler and other engines: what ``tmodes bench`` runs.

One file per contender; each runs the same rigid chain and is compared with accelerations in extended precision.
"""
