"""Accelerators: each gives the same result as the engine without it."""
