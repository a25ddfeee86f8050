"""Copley PVT drives: wire format, the drive's buffer and motion, the CAN bus.

The motion is that of the drive's trajectory generator.
"""
