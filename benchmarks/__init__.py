"""Measured programs, and their limits: `python -m benchmarks [NAME …]`."""
