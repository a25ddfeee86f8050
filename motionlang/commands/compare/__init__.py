"""Comparison of a real controller's recording with the run.

The recording is read, aligned in time with the run, and compared move by move.
"""
