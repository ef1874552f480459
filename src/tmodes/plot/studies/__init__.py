"""Figures of studies, for print; importing the package registers them."""

from tmodes.plot.studies import cases, sensitivity
from tmodes.plot.studies.contract import STUDY_FIGURES, StudyFigure, check_names, save_study_figures

__all__ = ["STUDY_FIGURES", "StudyFigure", "cases", "check_names", "save_study_figures", "sensitivity"]
