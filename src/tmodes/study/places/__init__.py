"""Where a study runs: one file for each place; importing the package registers them."""

from tmodes.study.places import dask, local
from tmodes.study.places.contract import PLACES, How, Job, Place, Task, place_of

__all__ = ["PLACES", "How", "Job", "Place", "Task", "dask", "local", "place_of"]
