"""Moves by position, velocity and time."""
