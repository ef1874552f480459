"""The flexible link of the 2010 robot: two modes."""

from __future__ import annotations

from pydantic import Field

from tmodes.kinds.links.modes_sheet import Mode as FlexibleMode
from tmodes.kinds.links.modes_sheet import shape_angle, shape_deflection, shape_slope
from tmodes.kinds.schema.quantity import DataSheet

__all__ = ["FlexibleLink", "FlexibleMode", "shape_angle", "shape_deflection", "shape_slope"]


class FlexibleLink(DataSheet):
    """The flexible link: its modes from root to tip. The equations of this paper hold for two."""

    modes: tuple[FlexibleMode, FlexibleMode] = Field(strict=False, description="the modes from root to tip")
