# SPDX-License-Identifier: MIT
"""The report: one HTML page that stands on its own."""

from exactkf.report.page import render, write_report

__all__ = ["render", "write_report"]
