"""Comparison of a real controller's recording with the run.

It is read, aligned in time, and compared move by move.
"""
