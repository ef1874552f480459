"""What every figure is: a name, words for its caption, the series that it needs, and how it is drawn."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from tmodes.errors import InputError
from tmodes.plot.style import house_style

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from tmodes.plot.panels import AxesLike
    from tmodes.result.result import Result

from tmodes.kinds.registry import Registry

__all__ = ["FIGURES", "Figure", "register"]


class Figure(ABC):
    """One figure of a result. Subclasses set the class variables and write :meth:`draw`.

    An instance is called as ``figure(result, ax=None)`` and returns its axes, lettered a), b), ...
    """

    name: ClassVar[str] = ""
    """Name of the figure and of its files, an identifier."""

    title: ClassVar[str] = ""
    """Title in a few words."""

    caption: ClassVar[str] = ""
    """What to look at, in one or two sentences."""

    needs: ClassVar[Mapping[str, str]] = {}
    """Series or dimensions of the result that must exist, each with the reason when it does not."""

    @abstractmethod
    def draw(self, result: Any, ax: AxesLike = None) -> list[Axes]:
        """Draw into ``ax`` (one axes for each panel), or into a new figure; called inside the house style."""

    def missing(self, data: Any) -> str:
        """Why a result with this dataset cannot fill the figure; empty where it can."""
        reasons = (reason for name, reason in self.needs.items() if name not in data and name not in data.dims)
        return next(reasons, "")

    def __call__(self, result: Result, ax: AxesLike = None, **options: Any) -> list[Axes]:
        """The axes of the figure; ``options`` are those of its :meth:`draw`.

        Raises :class:`tmodes.errors.InputError` where :meth:`missing` gives a reason.
        """
        if reason := self.missing(result.data):
            raise InputError(self.name, reason, "a result that has what it shows", "leave this figure out")
        with house_style():
            return self.draw(result, ax, **options)


def _has_words(figure: Figure) -> None:
    if not figure.name.isidentifier():
        raise InputError("figure name", repr(figure.name), "an identifier such as 'joint_power'", "set another `name`")
    if not (figure.title and figure.caption):
        hint = "set the class's `title` and `caption`"
        raise InputError(f"figure {figure.name}", "a class without title or caption", "a class with both", hint)


FIGURES: Registry[Figure] = Registry("figure", Figure, check=_has_words)
"""Every figure, in the order of the report."""

register = FIGURES.register
