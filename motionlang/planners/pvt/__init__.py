"""Copley's PVT: points of position, velocity and time, and their motion."""
