"""Figures of a result: ``tmodes.plot.tip_tracking(result)`` returns matplotlib axes, ``save_figures`` writes them all.

Every figure takes ``(result, ax=None)`` and returns its axes. ``FIGURES`` holds them by name, ``all_figures`` gives
those that a result can fill, ``left_out`` the reasons of the others; ``register`` adds a :class:`Figure` of your own.
"""

from tmodes.plot.figure import FIGURES, Figure, all_figures, left_out, register, save_figures
from tmodes.plot.figures.contact_force import ContactForce
from tmodes.plot.figures.controller_states import ControllerStates
from tmodes.plot.figures.decompositions import GearDeflections, LinkCoordinates
from tmodes.plot.figures.deformations import Deformations
from tmodes.plot.figures.elastic_line import ElasticLine
from tmodes.plot.figures.energies import Energies
from tmodes.plot.figures.joint_efforts import JointEfforts
from tmodes.plot.figures.joint_tracking import JointTracking
from tmodes.plot.figures.link_deflection import LinkDeflection
from tmodes.plot.figures.link_loads import LinkLoads
from tmodes.plot.figures.link_tips import LinkTips
from tmodes.plot.figures.spectrum import Spectrum
from tmodes.plot.figures.tip_errors import TipErrors
from tmodes.plot.figures.tip_path import TipPath
from tmodes.plot.figures.tip_tracking import TipTracking
from tmodes.plot.style import house_style

__all__ = [
    "FIGURES", "Figure", "all_figures", "contact_force", "controller_states", "deformations",
    "elastic_line", "energies", "gear_deflections", "house_style", "joint_efforts", "joint_tracking", "left_out",
    "link_coordinates", "link_deflection", "link_loads", "link_tips", "register", "save_figures", "spectrum",
    "tip_errors", "tip_path", "tip_tracking",
]  # fmt: skip

# In the order of the report.
tip_tracking = register(TipTracking())
tip_errors = register(TipErrors())
tip_path = register(TipPath())
elastic_line = register(ElasticLine())
joint_tracking = register(JointTracking())
deformations = register(Deformations())
gear_deflections = register(GearDeflections())
link_coordinates = register(LinkCoordinates())
link_tips = register(LinkTips())
link_deflection = register(LinkDeflection())
spectrum = register(Spectrum())
link_loads = register(LinkLoads())
joint_efforts = register(JointEfforts())
controller_states = register(ControllerStates())
contact_force = register(ContactForce())
energies = register(Energies())
