"""Copley PVT drives: points on the wire, the drive's buffer and trajectory generator, and the CAN bus to them."""
