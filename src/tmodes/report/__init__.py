"""One self-contained page about a run: ``tmodes.report.write_report(result, "report.html")``."""

from tmodes.report.page import write_report

__all__ = ["write_report"]
