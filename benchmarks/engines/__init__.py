"""How fast this engine is on the machine at hand, next to others: ``python -m benchmarks.engines``.

One file per contender; each runs the same rigid chain and is compared with accelerations in extended precision.
"""
