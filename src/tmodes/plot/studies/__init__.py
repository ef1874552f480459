"""Figures of studies, for print: one file for each; importing the package registers them."""

from tmodes.plot.studies import (
    bands,
    cases,
    distribution,
    effects,
    indices,
    pareto,
    responses,
    surface,
    swings,
)
from tmodes.plot.studies.contract import STUDY_FIGURES, StudyFigure, check_names, save_study_figures

__all__ = [
    "STUDY_FIGURES", "StudyFigure", "bands", "cases", "check_names", "distribution", "effects", "indices", "pareto",
    "responses", "save_study_figures", "surface", "swings",
]  # fmt: skip
