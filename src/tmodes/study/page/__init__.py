"""The page of a study: one self-contained file, with charts that are brushed and cases that are simulated again."""

from tmodes.study.page.document import write_page
from tmodes.study.page.figures import figure_data

__all__ = ["figure_data", "write_page"]
