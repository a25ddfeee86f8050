"""Drives and servo loops on the bench: the servo laboratory, PVT, Copley's drive, the vendors' notes."""
