"""Accelerators: each equals the engine."""
