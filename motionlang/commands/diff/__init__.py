"""Differences between two runs, or a run and its golden report, by content."""
