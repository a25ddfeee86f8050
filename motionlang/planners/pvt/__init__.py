"""Copley's PVT: points with position, velocity and time, and the motion through them."""
