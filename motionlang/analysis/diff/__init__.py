"""Differences of two runs, or a run and its golden report, aligned by content."""
