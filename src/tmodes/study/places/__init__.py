"""Where a study runs: one file for each place; importing the package registers them."""

from tmodes.study.places import dask, local
from tmodes.study.places.contract import PLACES, How, Place, PlaceJob, Task, place_of

__all__ = ["PLACES", "How", "Place", "PlaceJob", "Task", "dask", "local", "place_of"]
