"""Accelerators: each gives what the engine gives."""
