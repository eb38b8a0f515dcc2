"""The report: what the runs left, on one page that needs nothing else."""

from squat.report.contents import ReportCase
from squat.report.write import write_report

__all__ = ["ReportCase", "write_report"]
