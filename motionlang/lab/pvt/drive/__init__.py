"""Copley PVT drives: wire format, the drive's buffer and motion, the CAN bus.

The motion is the one that the drive's trajectory generator makes.
"""
