"""Copley drives on a CAN bus: their objects, modes and buffer, and a master that streams moves to them."""
