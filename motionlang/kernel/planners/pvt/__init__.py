"""Copley's PVT: points of position, velocity and time, and motion through them."""
